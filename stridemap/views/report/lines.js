// Line charts in SVG: over time, or of one thing over another. A pinned cycle is drawn beside, thin and dotted.

const CHART = { width: 340, height: 184, left: 52, right: 58, top: 10, bottom: 40 };

// The range of some values with room around it. What is zero but for rounding is a flat line.
function padded(values) {
  const finite = values.filter(Number.isFinite);
  const [low, high] = finite.length ? [Math.min(...finite), Math.max(...finite)] : [0, 0];
  const rounding = 1e-12 * Math.max(1, Math.abs(low), Math.abs(high));
  const pad = high - low > rounding ? 0.06 * (high - low) : Math.max(0.5, 1e6 * rounding);
  return [Math.max(low - pad, -Number.MAX_VALUE), Math.min(high + pad, Number.MAX_VALUE)];
}

// One chart; its element has `mark(t)`, which moves the mark of the time shown, and `time(event)`, the time that is
// pressed. `bound` is a value that the series stay within on either side, called `measure`.
// Where there is a `figure` of the same title, it gets another drawing.
function lineChart({ title, unit, series, across, zero, measure, bound = null }, own, figure) {
  const { width, height, left, right, top, bottom } = CHART;
  const placesOf = (s) => s.places ?? s.times;
  const extra = (zero || bound !== null ? [0] : []);
  const [low, high] = padded(series.flatMap((s) => s.values).concat(extra));
  const [from, to] = across ? padded(series.flatMap(placesOf)) : [0, Math.max(...series.map((s) => s.times.at(-1)))];
  const x = (value) => left + between(Number.isFinite(value) ? value : from, from, to) * (width - left - right);
  const y = (value) => height - bottom - between(Number.isFinite(value) ? value : low, low, high) * (height - top - bottom);
  const root = svg("svg", { viewBox: `0 0 ${width} ${height}`, class: "chart", role: "img", "aria-label": described(title, unit, series.slice(0, own), across) });
  for (const value of ticks(low, high, 4)) {
    root.append(svg("line", { x1: left, x2: width - right, y1: y(value), y2: y(value), class: value === 0 ? "axis" : "grid" }));
    root.append(svg("text", { x: left - 6, y: y(value), class: "tick end" }, brief(value)));
  }
  for (const value of ticks(from, to, 4)) {
    if (across) root.append(svg("line", { x1: x(value), x2: x(value), y1: top, y2: height - bottom, class: value === 0 ? "axis" : "grid" }));
    root.append(svg("text", { x: x(value), y: height - bottom + 15, class: "tick middle" }, brief(value)));
  }
  root.append(svg("text", { x: width - right, y: height - 9, class: "tick end" }, across ?? withUnit("t", kindUnit("time"))));
  for (const side of bound === null ? [] : [-bound, bound].filter((value) => value > low && value < high)) {
    root.append(svg("line", { x1: left, x2: width - right, y1: y(side), y2: y(side), class: "bound" }));
    root.append(svg("text", { x: width - right + 4, y: y(side), class: "tick" }, side < 0 ? MINUS + measure : measure));
  }
  root.append(...drawnSeries(series, own, placesOf, x, y, across));
  const { times } = series[0];
  const mark = across ? svg("circle", { r: 4, class: "now-dot" }) : svg("line", { y1: top, y2: height - bottom, class: "now" });
  root.append(mark);
  if (figure) figure.lastChild.replaceWith(root);
  else {
    figure = html("figure", { class: "profile" });
    figure.append(html("figcaption", {}, html("span", {}, withUnit(title, unit)), saveButtons(() => figure.lastChild, title)), root);
    figure.named = withUnit(title, unit);
  }
  const sampleAt = (t) => Math.max(0, Math.min(times.length - 1, Math.round((t / times.at(-1)) * (times.length - 1))));
  figure.mark = (t) => {
    if (!across) return ["x1", "x2"].forEach((end) => mark.setAttribute(end, x(t)));
    const i = sampleAt(t);
    const place = [x(series[0].places[i]), y(series[0].values[i])];
    mark.toggleAttribute("hidden", !place.every(Number.isFinite));
    if (place.every(Number.isFinite)) ["cx", "cy"].forEach((name, k) => mark.setAttribute(name, place[k]));
  };
  figure.time = (event) => pressedTime(event, root, { series: series[0], across, x, y, from, to });
  return figure;
}

// The time of the place that is pressed: along the axis, or of the nearest point of a portrait.
function pressedTime(event, root, { series, across, x, y, from, to }) {
  const box = root.getBoundingClientRect();
  const [px, py] = [((event.clientX - box.left) / box.width) * CHART.width, ((event.clientY - box.top) / box.height) * CHART.height];
  if (!across) return Math.min(series.times.at(-1), from + Math.max(0, Math.min(1, (px - CHART.left) / (CHART.width - CHART.left - CHART.right))) * (to - from));
  const away = (i) => Math.hypot(x(series.places[i]) - px, y(series.values[i]) - py);
  return series.times[series.times.reduce((best, _, i) => (away(i) < away(best) ? i : best), 0)];
}

// The curves, each with its label at its end; labels are kept apart. Those after the first `own` are of the pinned cycle.
function drawnSeries(series, own, placesOf, x, y, across) {
  const ends = series.slice(0, own).map((s, i) => ({ i, y: y(s.values.at(-1)) })).sort((a, b) => a.y - b.y);
  ends.forEach((end, j) => { if (j) end.y = Math.max(end.y, ends[j - 1].y + 13); });
  return series.flatMap((s, i) => {
    const places = s.values.map((value, j) => [x(placesOf(s)[j]), y(value)]).filter((place) => place.every(Number.isFinite));
    const points = places.map(([along, up]) => `${along.toFixed(2)},${up.toFixed(2)}`).join(" ");
    const line = svg("polyline", { points, class: i < own ? s.cls : `${s.cls} pinned` });
    if (i >= own || own < 2 || across) return [line];
    return [line, svg("text", { x: CHART.width - CHART.right + 4, y: ends.find((end) => end.i === i).y, class: `label ${s.cls}` }, s.label)];
  });
}

function described(title, unit, series, across) {
  const ranges = series.map(({ label, values }) => `${label} from ${brief(Math.min(...values))} to ${brief(Math.max(...values))}`);
  return `${withUnit(title, unit)}${across ? "" : " over one step"}: ${ranges.join("; ")}`;
}
