// Drawings in SVG: profiles over a step, and the multipliers in the unit circle.

function svg(tag, attributes = {}, ...children) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

function html(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name in node && typeof value !== "string") node[name] = value;
    else node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

const SAMPLES = 241;
const CHART = { width: 340, height: 184, left: 52, right: 46, top: 10, bottom: 40 };

// The charts of a path: coordinates and rates by their units, then what acts at the foot and the hip.
function chartsOf(samples) {
  const named = (label, value, cls) => ({ label, values: samples.map(value), cls });
  const charts = [];
  for (const [kind, of, symbol, unitOf] of [["", "q", "symbol", "unit"], ["rate of ", "v", "rate_symbol", "rate_unit"]]) {
    for (const [unit, members] of grouped(model.coordinates, (c) => c[unitOf])) {
      const series = members.map((c, i) => named(c[symbol], (s) => s[of][model.coordinates.indexOf(c)], `series-${i}`));
      const title = kind + members.map((c) => c.symbol).join(", ");
      charts.push({ title, unit, series });
    }
  }
  const has = (name) => samples[0][name] !== null;
  if (has("d")) charts.push({ title: "d: stance foot minus the paper's zero moment point", unit: model.units.length, series: [named("d", (s) => s.d, "zmp")], measure: "d_max" });
  if (has("offset")) charts.push({ title: "centre of pressure ahead of the contact", unit: model.units.length, series: [named("offset", (s) => s.offset, "force")], measure: "cop_max" });
  if (has("force")) {
    charts.push({
      title: "ground force on the stance foot", unit: model.units.force, zero: true,
      series: [named("Fy", (s) => s.force[1], "force"), named("Fx", (s) => s.force[0], "force aside")],
    });
  }
  if (has("torque")) {
    for (const [unit, members] of grouped(model.motors, (motor) => motor.unit)) {
      const series = members.map((m, i) => named(m.symbol, (s) => s.torque[model.motors.indexOf(m)], `series-${i}`));
      charts.push({ title: series.length > 1 ? "torques of the motors" : "torque of the motor", unit, series });
    }
  }
  return charts;
}

function grouped(items, key) {
  const groups = new Map();
  for (const item of items) groups.set(key(item), [...(groups.get(key(item)) ?? []), item]);
  return groups;
}

// One chart; its element has `mark(t)`, which moves the line of the time shown.
function lineChart({ title, unit, series, measure, zero }, times, row) {
  const { width, height, left, right, top, bottom } = CHART;
  const period = times.at(-1);
  const bound = measure && orbits.has(measure) ? orbits.entry(measure, row) : null;
  const values = series.flatMap((s) => s.values).concat(zero ? [0] : [], bound === null ? [] : [0]).filter(Number.isFinite);
  let [low, high] = values.length ? [Math.min(...values), Math.max(...values)] : [0, 0];
  const rounding = 1e-12 * Math.max(1, Math.abs(low), Math.abs(high));
  const pad = high - low > rounding ? 0.06 * (high - low) : Math.max(0.5, 1e6 * rounding); // what is zero but for rounding is a flat line
  [low, high] = [Math.max(low - pad, -Number.MAX_VALUE), Math.min(high + pad, Number.MAX_VALUE)];
  const x = (t) => left + (t / period) * (width - left - right);
  const y = (v) => height - bottom - between(Number.isFinite(v) ? v : low, low, high) * (height - top - bottom);
  const root = svg("svg", { viewBox: `0 0 ${width} ${height}`, class: "chart", role: "img", "aria-label": describe(title, unit, series) });
  for (const value of ticks(low, high, 4)) {
    root.append(svg("line", { x1: left, x2: width - right, y1: y(value), y2: y(value), class: value === 0 ? "axis" : "grid" }));
    root.append(svg("text", { x: left - 6, y: y(value), class: "tick end" }, brief(value)));
  }
  for (const value of ticks(0, period, 4)) {
    root.append(svg("text", { x: x(value), y: height - bottom + 15, class: "tick middle" }, brief(value)));
  }
  root.append(svg("text", { x: width - right, y: height - 9, class: "tick end" }, withUnit("t", model.units.time)));
  for (const side of bound === null ? [] : [-bound, bound].filter((v) => v > low && v < high)) {
    root.append(svg("line", { x1: left, x2: width - right, y1: y(side), y2: y(side), class: "bound" }));
    root.append(svg("text", { x: width - right + 4, y: y(side), class: "tick" }, side < 0 ? `${MINUS}max` : measure));
  }
  root.append(...lines(series, times, x, y));
  const mark = svg("line", { y1: top, y2: height - bottom, class: "now" });
  root.append(mark);
  const figure = html("figure", { class: "profile" }, html("figcaption", {}, withUnit(title, unit)), root);
  figure.mark = (t) => ["x1", "x2"].forEach((end) => mark.setAttribute(end, x(t)));
  figure.time = (event) => {
    const box = root.getBoundingClientRect();
    return Math.max(0, Math.min(1, ((event.clientX - box.left) / box.width * width - left) / (width - left - right))) * period;
  };
  return figure;
}

// The curves, each with its label at its end; labels are kept apart.
function lines(series, times, x, y) {
  const ends = series.map((s, i) => ({ i, y: y(s.values.at(-1)) })).sort((a, b) => a.y - b.y);
  ends.forEach((end, j) => { if (j) end.y = Math.max(end.y, ends[j - 1].y + 13); });
  return series.flatMap(({ label, values, cls }, i) => {
    const places = values.map((v, j) => [x(times[j]), y(v)]).filter((place) => place.every(Number.isFinite));
    const points = places.map(([along, up]) => `${along.toFixed(2)},${up.toFixed(2)}`).join(" ");
    const at = ends.find((end) => end.i === i).y;
    const text = svg("text", { x: CHART.width - CHART.right + 4, y: at, class: `label ${cls}` }, label);
    return [svg("polyline", { points, class: cls }), ...(series.length > 1 ? [text] : [])];
  });
}

function describe(title, unit, series) {
  const ranges = series.map(({ label, values }) => `${label} from ${brief(Math.min(...values))} to ${brief(Math.max(...values))}`);
  return `${withUnit(title, unit)} over one step: ${ranges.join("; ")}`;
}

// The multipliers in the complex plane. What lies beyond the drawing stands at its edge as a triangle.
function unitCircle(pairs) {
  const size = 240;
  const largest = Math.max(1, ...pairs.map(([re, im]) => Math.hypot(re, im)));
  const reach = Math.min(Math.max(1.3, 1.15 * largest), 3);
  const at = (v) => size / 2 + (v / reach) * (size / 2 - 12);
  const label = `Floquet multipliers: ${pairs.map(complexText).join("; ")}`;
  const root = svg("svg", { viewBox: `0 0 ${size} ${size}`, class: "circle", role: "img", "aria-label": label });
  root.append(svg("line", { x1: 4, x2: size - 4, y1: at(0), y2: at(0), class: "grid" }));
  root.append(svg("line", { y1: 4, y2: size - 4, x1: at(0), x2: at(0), class: "grid" }));
  root.append(svg("circle", { cx: at(0), cy: at(0), r: at(1) - at(0), class: "unit" }));
  root.append(svg("text", { x: at(1) + 4, y: at(0) + 14, class: "tick" }, "1"));
  root.append(svg("text", { x: size - 6, y: at(0) - 6, class: "tick end" }, "Re"));
  root.append(svg("text", { x: at(0) + 6, y: 12, class: "tick" }, "Im"));
  const drawable = (v) => Math.max(-1e150, Math.min(1e150, v));
  for (const [re, im] of pairs.map((pair) => pair.map(drawable))) {
    const modulus = Math.hypot(re, im);
    const shrink = modulus > reach ? reach / modulus : 1;
    const [px, py] = [at(re * shrink), at(-im * shrink)];
    const cls = modulus < 1 ? "inside" : "outside";
    if (shrink === 1) {
      root.append(modulus < 1 ? svg("circle", { cx: px, cy: py, r: 4.5, class: cls }) : diamond(px, py, cls));
    } else {
      const turn = (Math.atan2(-im, re) * 180) / Math.PI;
      root.append(svg("path", { d: "M8 0L-4 6L-4 -6Z", class: cls, transform: `translate(${px} ${py}) rotate(${turn})` }));
    }
  }
  return root;
}

const diamond = (x, y, cls) => svg("path", { d: `M${x} ${y - 6.5}L${x + 6.5} ${y}L${x} ${y + 6.5}L${x - 6.5} ${y}Z`, class: cls });

function complexText([re, im]) {
  if (im === 0) return exact(re);
  return `${exact(re)} ${im < 0 ? MINUS : "+"} ${exact(Math.abs(im))} i`;
}
