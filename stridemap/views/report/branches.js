// Branches over one parameter, as lines of a slice, with their special points.

const branchTables = report.branches.map(({ varies, at, lines }) => ({ varies, at, table: new Table(lines) }));

// The branches along an axis, at the values that the other axes have.
function branchesAlong(across, indices) {
  return branchTables.filter(({ varies, at }) => varies === grid.axes[across].name && grid.axes.every((axis, i) => i === across || same(axis.values[indices[i]], at[axis.name])));
}

// Values of a quantity on gaits of branches, or none where it is not known of them.
function branchValues(found, name) {
  return found.flatMap(({ table }) => (table.has(name) ? [...table.numbers(name)].filter(Number.isFinite) : []));
}

// Each special point as { table, row, type, words, value, steps }.
function specialPoints(found) {
  return found.flatMap(({ table, varies }) => {
    const types = table.numbers("type");
    const [value, steps] = [varies, "period_n"].map((name) => table.numbers(name));
    const rows = [...types.keys()].filter((row) => types[row] >= 0);
    return rows.map((row) => ({ table, row, type: table.entry("type", row), words: table.entry("words", row), value: value[row], steps: steps[row] }));
  });
}

const stepsText = (n) => (n === 1 ? "cycles of one step" : `cycles of ${n} steps`);

// What a special point is, in words.
function specialText({ type, words, value, steps }, axis) {
  const { name, letters } = report.special[type];
  const called = letters.toLowerCase() === name ? name : `${name} (${letters})`;
  return `${called}${words ? `, ${words}` : ""} at ${axis.symbol} = ${axis.text(value, 9)}, ${stepsText(steps)}`;
}

const branchColours = (steps) => (steps > 1 ? [styled("several-steps"), styled("several-steps")] : [styled("map-stable"), styled("open")]);

// Draw branches into a box; `place(value, y)` gives the place of a value of the parameter and one of the quantity.
function drawBranches(pen, found, name, place, box) {
  within(pen, [box], () => {
    for (const { table, varies } of found.filter((one) => one.table.has(name))) {
      const [x, y, look, steps] = [varies, name, "look", "period_n"].map((column) => table.numbers(column));
      for (let row = 0; row < table.length;) {
        let last = row;
        while (last < table.length - 1 && look[last] === look[row] && look[row] > 0) last++;
        if (look[row] > 0) {
          const points = Array.from({ length: last - row + 1 }, (_, i) => place(x[row + i], y[row + i]));
          drawPiece(pen, look[row] === 2, steps[row], trimmed(points, box));
        }
        row = Math.max(last, row + 1);
      }
    }
  });
  pen.setLineDash([]);
}

// A line without what lies above or below a box. A browser draws no dashes along a line of enormous length.
function trimmed(points, { y, height }) {
  const edge = ([x0, y0], [x1, y1]) => [y, y + height].filter((at) => (y0 - at) * (y1 - at) < 0).map((at) => [x0 + ((x1 - x0) * (at - y0)) / (y1 - y0), at]).sort((a, b) => (a[1] - b[1]) * (y1 - y0));
  const kept = points.flatMap((point, i) => [...(i ? edge(points[i - 1], point) : []), point]);
  return kept.map((point) => (point[1] >= y && point[1] <= y + height ? point : [point[0], NaN]));
}

function drawPiece(pen, stable, steps, points) {
  const [solid, dashed] = branchColours(steps);
  pen.strokeStyle = stable ? solid : dashed;
  pen.lineWidth = stable ? 2 : 1.3;
  pen.setLineDash(stable ? [] : [5, 3]);
  pen.beginPath();
  let down = false;
  for (const [px, py] of points) {
    if (!Number.isFinite(py)) down = false;
    else if (down) pen.lineTo(px, py);
    else {
      pen.moveTo(px, py);
      down = true;
    }
  }
  pen.stroke();
}

// The outline of each marker, in parts of its size; those without area are open.
const OUTLINES = {
  D: [[0, -1.2], [1.2, 0], [0, 1.2], [-1.2, 0]],
  s: [[-1, -1], [1, -1], [1, 1], [-1, 1]],
  "*": Array.from({ length: 10 }, (_, i) => [(i % 2 ? 0.55 : 1.4) * Math.sin((i * Math.PI) / 5), -(i % 2 ? 0.55 : 1.4) * Math.cos((i * Math.PI) / 5)]),
  v: [[-1.1, -0.9], [1.1, -0.9], [0, 1.1]],
  "^": [[-1.1, 0.9], [1.1, 0.9], [0, -1.1]],
  "<": [[0.9, -1.1], [0.9, 1.1], [-1.1, 0]],
  P: [[-0.4, -1.2], [0.4, -1.2], [0.4, -0.4], [1.2, -0.4], [1.2, 0.4], [0.4, 0.4], [0.4, 1.2], [-0.4, 1.2], [-0.4, 0.4], [-1.2, 0.4], [-1.2, -0.4], [-0.4, -0.4]],
};
const STROKES = { "|": [[[0, -1.6], [0, 1.6]]], x: [[[-1, -1], [1, 1]], [[-1, 1], [1, -1]]] };

// A marker of a special point; that of a subcritical doubling is hollow.
function drawMarker(pen, type, hollow, x, y, size) {
  const { marker, colour } = report.special[type];
  pen.strokeStyle = colour;
  pen.fillStyle = hollow ? styled("card") : colour;
  pen.lineWidth = marker in STROKES ? 2 : 1.4;
  if (marker in STROKES) {
    for (const [a, b] of STROKES[marker]) segment(pen, x + size * a[0], y + size * a[1], x + size * b[0], y + size * b[1]);
    return;
  }
  pen.beginPath();
  if (marker in OUTLINES) {
    OUTLINES[marker].forEach(([a, b], i) => (i ? pen.lineTo(x + size * a, y + size * b) : pen.moveTo(x + size * a, y + size * b)));
    pen.closePath();
  } else pen.arc(x, y, size, 0, 2 * Math.PI);
  pen.fill();
  pen.stroke();
}

// What lines and markers mean, and the special points as a list; or where branches are drawn.
function branchLegend(found, axis) {
  const key = (draw, text) => {
    const pen = new SvgPen(26, 14);
    draw(pen);
    const sample = html("span", { class: "sample" });
    sample.innerHTML = pen.text("none");
    return html("span", { class: "key" }, sample, text);
  };
  const line = (stable, steps, text) => key((pen) => drawPiece(pen, stable, steps, [[1, 7], [25, 7]]), text);
  if (!found.length) {
    const places = branchTables.map(({ varies, at }) => [`along ${axisNamed(varies).symbol}`, ...Object.entries(at).map(([name, value]) => `${axisNamed(name).symbol} = ${axisNamed(name).text(value)}`)].join(", "));
    return places.length ? [html("span", { class: "key" }, `branches are drawn ${[...new Set(places)].join("; ")}`)] : [];
  }
  const points = specialPoints(found);
  const several = found.some(({ table }) => table.numbers("period_n").some((n) => n > 1));
  const types = Object.keys(report.special).filter((type) => points.some((one) => one.type === type));
  const subcritical = points.some(({ words }) => words === "subcritical");
  return [
    line(true, 1, "branch of stable cycles"), line(false, 1, "unstable"),
    ...(several ? [line(true, 2, "cycles of several steps")] : []),
    ...types.map((type) => key((pen) => drawMarker(pen, type, false, 13, 7, 4), report.special[type].name)),
    ...(subcritical ? [key((pen) => drawMarker(pen, "pd", true, 13, 7, 4), "subcritical")] : []),
    html("details", { class: "definition" }, html("summary", {}, `${points.length} special ${points.length === 1 ? "point" : "points"}`), html("ul", {}, ...points.map((one) => html("li", {}, specialText(one, axis))))),
  ];
}

const axisNamed = (name) => axisQuantities[grid.axes.findIndex((axis) => axis.name === name)];
