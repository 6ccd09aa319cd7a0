// Boundaries over the map, as vectors: those that lie in the plane that is shown, at the values that are chosen.

const boundaries = report.curves.map((curve) => ({ ...curve, points: decode(curve.points, Float64Array) }));

// Whether a boundary lies in the plane of two axes, at the values that the others have.
function liesIn(curve, across, up, indices) {
  if (up === null || ![across, up].every((i) => curve.names.includes(grid.axes[i].name))) return false;
  return grid.axes.every((axis, i) => {
    if (i === across || i === up) return true;
    const [here, there] = [axis.values[indices[i]], curve.at[axis.name]];
    return Math.abs(here - there) <= 1e-9 * Math.abs(here);
  });
}

// Dashes are in line widths, as in all pictures; thin lines get those of a line of width 1.2.
const dashesOf = (type, width) => report.looks[type].dashes.map((d) => (d * Math.max(width, 1.2)).toFixed(1)).join(" ");

class CurveLayer {
  constructor(element) {
    this.svg = element;
    this.on = true;
  }

  // The boundaries that are shown now.
  show(across, up, indices) {
    this.axes = [across, up];
    this.shown = boundaries.filter((curve) => liesIn(curve, across, up, indices));
  }

  // Draw them into a frame of the map, with its two scales; letters [text, x, y] stand above them.
  draw(scales, { left, top, width, height }, letters) {
    if (!this.shown) return;
    this.svg.replaceChildren();
    if (!this.on || !this.shown.length) return;
    // The picture is as large as the frame, and so cuts off what leaves it.
    Object.assign(this.svg.style, { left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px` });
    this.svg.setAttribute("viewBox", `${left} ${top} ${width} ${height}`);
    const group = svg("g");
    const order = [...this.shown].sort((a, b) => a.stable - b.stable);
    for (const halo of [true, false]) {
      for (const curve of order) {
        const thick = curve.stable ? 2 : 1.1;
        const look = report.looks[curve.type];
        group.append(svg("path", {
          d: this.path(curve, scales, { left, top, width, height }),
          "data-type": curve.type,
          ...(halo ? { class: "halo", "stroke-width": thick + 1.2 } : { stroke: look.colour, "stroke-width": thick, "stroke-dasharray": dashesOf(curve.type, thick) }),
        }));
      }
    }
    this.svg.append(group, ...letters.map(([text, x, y]) => svg("text", { x, y, class: "letter" }, text)));
  }

  path(curve, scales, { left, top, width, height }) {
    const place = this.axes.map((i) => curve.names.indexOf(grid.axes[i].name));
    const parts = [];
    for (let i = 0; i < curve.points.length; i += 2) {
      const [u, v] = scales.map((scale, k) => scale.unitOf(curve.points[i + place[k]]));
      parts.push(`${i ? "L" : "M"}${(left + u * width).toFixed(2)} ${(top + (1 - v) * height).toFixed(2)}`);
    }
    return parts.join("");
  }

  // Where the boundaries cross a line of the map, at a value of its vertical axis: [value across, type].
  crossings(value) {
    if (!this.on || !this.shown) return [];
    const [x, y] = this.axes.map((i) => grid.axes[i]?.name);
    return this.shown.flatMap((curve) => {
      const [a, b] = [curve.names.indexOf(x), curve.names.indexOf(y)];
      const found = [];
      for (let i = 0; i + 3 < curve.points.length; i += 2) {
        const [low, high] = [curve.points[i + b] - value, curve.points[i + 2 + b] - value];
        if (low > 0 === high > 0) continue;
        found.push([curve.points[i + a] + (low / (low - high)) * (curve.points[i + 2 + a] - curve.points[i + a]), curve.type]);
      }
      return found;
    });
  }

  // A sample of each line that is shown, with what it is.
  legend() {
    const types = Object.keys(report.looks).filter((type) => this.shown.some((curve) => curve.type === type));
    return types.map((type) => {
      const sample = svg("svg", { viewBox: "0 0 34 12", "aria-hidden": "true" });
      sample.append(svg("path", { d: "M2 6H32", stroke: report.looks[type].colour, "stroke-width": 2.2, "stroke-dasharray": dashesOf(type, 2.2) }));
      return html("span", { class: "key", "data-type": type }, sample, report.looks[type].name);
    });
  }
}
