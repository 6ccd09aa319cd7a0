// The strip: the walker at even times of one step side by side, as vectors. Pressing on one goes to its time.

const FIGURES = 9;
const STRIP = { width: 560, height: 172, top: 12, bottom: 30 };

class Strip {
  // `onTime(t)` is called when the reader presses on a figure.
  constructor(element, onTime) {
    this.element = element;
    this.onTime = onTime;
  }

  load(path) {
    this.path = path;
    this.figures = [];
    const samples = path.samples(FIGURES);
    this.element.replaceChildren();
    if (!samples.every((seen) => this.places(seen).flat().every((v) => Math.abs(v) < 1e100))) return; // it cannot be integrated
    const heights = samples.flatMap((seen) => this.places(seen).map(([, y]) => y));
    const inside = STRIP.height - STRIP.top - STRIP.bottom;
    const [low, high] = [Math.min(0, ...heights), Math.max(...heights)];
    const widest = Math.max(...samples.map((seen) => this.reach(seen)));
    const scale = Math.min(inside / (high - low || 1), (0.92 * STRIP.width) / FIGURES / widest);
    const ground = STRIP.height - STRIP.bottom + low * scale;
    const root = svg("svg", { viewBox: `0 0 ${STRIP.width} ${STRIP.height}`, role: "group", "aria-label": `The walker at ${FIGURES} even times of one step` });
    root.append(svg("line", { x1: 0, x2: STRIP.width, y1: ground, y2: ground, class: "axis" }));
    this.figures = samples.map((seen, i) => this.figure(seen, i, scale, ground));
    root.append(...this.figures);
    this.element.replaceChildren(root);
    this.mark(0);
  }

  // All points of a figure.
  places({ positions, lines }) {
    return [positions, ...Object.values(lines)].flat();
  }

  // How wide a figure is.
  reach(seen) {
    const across = this.places(seen).map(([x]) => x);
    return Math.max(...across) - Math.min(...across) || 1;
  }

  figure(seen, i, scale, ground) {
    const middle = ((i + 0.5) * STRIP.width) / FIGURES;
    const across = this.places(seen).map(([x]) => x);
    const centre = (Math.max(...across) + Math.min(...across)) / 2;
    const at = ([x, y]) => [middle + (x - centre) * scale, ground - y * scale];
    const line = (points, cls) => svg("polyline", { points: points.map((point) => at(point).map((v) => v.toFixed(2)).join()).join(" "), class: cls });
    const share = i / (FIGURES - 1);
    const shown = brief(share * this.path.period * kindFactor("time"), 3);
    const time = i ? shown : `t = ${shown}`;
    const group = svg("g", { class: "stick", role: "button", tabindex: 0, "aria-label": `t = ${shown} ${kindUnit("time")}`, "data-time": share * this.path.period });
    group.append(svg("rect", { x: middle - STRIP.width / FIGURES / 2, y: 0, width: STRIP.width / FIGURES, height: STRIP.height, class: "reach" }));
    for (const { name, role } of model.lines) {
      const points = seen.lines[name];
      const hip = Math.floor(points.length / 2);
      if (role === "legs") group.append(line(points.slice(hip), "swing"), line(points.slice(0, hip + 1), "stance"));
      else group.append(line(points, role === "spring" ? "spring" : "stance"));
    }
    const heaviest = Math.max(...seen.masses.map(Math.abs));
    const order = seen.positions.map((_, n) => n).sort((a, b) => Math.abs(seen.masses[b]) - Math.abs(seen.masses[a]));
    for (const n of order) {
      const [x, y] = at(seen.positions[n]);
      const r = Math.max(2, 0.055 * scale * Math.sqrt(Math.abs(seen.masses[n] / heaviest)));
      group.append(svg("circle", { cx: x, cy: y, r, class: bodyColour(seen, n) }));
    }
    group.append(svg("text", { x: middle, y: STRIP.height - 9, class: "middle" }, time));
    const go = () => this.onTime(share * this.path.period);
    group.addEventListener("click", go);
    group.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      go();
    });
    return group;
  }

  // The figure nearest to the time shown.
  mark(t) {
    const nearest = Math.round((t / this.path.period) * (FIGURES - 1));
    this.figures.forEach((figure, i) => figure.classList.toggle("shown", i === nearest));
  }
}
