// What is drawn of a cycle in SVG: its profiles over a step, its phase portraits, and its multipliers.

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

const SAMPLES = 121;

// A series of a chart: how it is called, and its values at the times of the samples, in the units that are shown.
const seriesOf = (label, samples, value, factor, cls) => ({ label, times: samples.map(({ t }) => t * kindFactor("time")), values: samples.map((s) => value(s) * factor), cls });

// The charts of a path over time: coordinates and rates by their units, then what acts at the foot and the hip.
function chartsOf(samples) {
  const charts = [];
  for (const [kind, of, symbol, unitOf, siOf] of [["", "q", "symbol", "unit", "si"], ["rate of ", "v", "rate_symbol", "rate_unit", "rate_si"]]) {
    for (const [unit, members] of grouped(model.coordinates, (c) => c[unitOf])) {
      const series = members.map((c, i) => seriesOf(c[symbol], samples, (s) => s[of][model.coordinates.indexOf(c)], factorOf(unit), `series-${i}`));
      charts.push({ title: kind + members.map((c) => c.symbol).join(", "), unit: unitText(unit, members[0][siOf]), series });
    }
  }
  const has = (name) => samples[0][name] !== null;
  const length = kindFactor("length");
  if (has("d")) charts.push({ title: "d: stance foot minus the paper's zero moment point", unit: kindUnit("length"), series: [seriesOf("d", samples, (s) => s.d, length, "zmp")], measure: "d_max" });
  if (has("offset")) charts.push({ title: "centre of pressure ahead of the contact", unit: kindUnit("length"), series: [seriesOf("offset", samples, (s) => s.offset, length, "force")], measure: "cop_max" });
  if (has("force")) {
    charts.push({
      title: "ground force on the stance foot", unit: kindUnit("force"), zero: true,
      series: [["Fy", 1], ["Fx", 0]].map(([label, part], i) => seriesOf(label, samples, (s) => s.force[part], kindFactor("force"), i ? "force aside" : "force")),
    });
  }
  if (has("torque")) {
    for (const [unit, members] of grouped(model.motors, (motor) => motor.unit)) {
      const series = members.map((m, i) => seriesOf(m.symbol, samples, (s) => s.torque[model.motors.indexOf(m)], factorOf(unit), `series-${i}`));
      charts.push({ title: series.length > 1 ? "torques of the motors" : "torque of the motor", unit: unitText(unit, members[0].si), series });
    }
  }
  return charts;
}

// The phase portraits of a path: the rate of each coordinate over it.
function portraitsOf(samples) {
  return model.coordinates.map((c, i) => {
    const rates = seriesOf(c.rate_symbol, samples, (s) => s.v[i], factorOf(c.rate_unit), "series-0");
    return {
      title: `${c.rate_symbol} over ${c.symbol}`, unit: unitText(c.rate_unit, c.rate_si), across: withUnit(c.symbol, unitText(c.unit, c.si)),
      series: [{ ...rates, places: samples.map((s) => s.q[i] * factorOf(c.unit)) }],
    };
  });
}

function grouped(items, key) {
  const groups = new Map();
  for (const item of items) groups.set(key(item), [...(groups.get(key(item)) ?? []), item]);
  return groups;
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
