// Scales from values to pixels and colours, with their ticks.

// Round tick values inside a range, at most about `count`.
function ticks(low, high, count = 6) {
  const raw = (high - low) / count;
  if (!(raw > 0)) return [low];
  const unit = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((m) => m * unit).find((s) => s >= raw * (1 - 1e-9));
  const first = Math.ceil(low / step - 1e-9);
  // Counted from the first, because adding 1 to a huge number may leave it as it is.
  const values = Array.from({ length: 2 * count + 2 }, (_, i) => (first + i) * step).filter((v) => v <= high + 1e-9 * step);
  return [...new Set(values.map((v) => Number(v.toPrecision(12))))].filter(Number.isFinite);
}

// Ticks of a logarithmic scale: powers of ten, with 2 and 5 between where there is room.
function logTicks(low, high) {
  const [from, to] = [Math.floor(Math.log10(low)), Math.ceil(Math.log10(high))];
  const steps = to - from > 4 ? [1] : to - from > 2 ? [1, 3] : [1, 2, 5];
  const values = [];
  for (let e = from; e <= to; e++) for (const m of steps) values.push(Number(`${m}e${e}`));
  const inside = values.filter((v) => v >= low * (1 - 1e-9) && v <= high * (1 + 1e-9));
  return inside.length > 1 ? inside : ticks(low, high, 4).filter((v) => v > 0);
}

function even(values) {
  const gaps = values.slice(1).map((v, i) => v - values[i]);
  return Math.max(...gaps) <= 1.5 * Math.min(...gaps);
}

// An axis of the grid from 0 to 1: each value owns a cell that ends half-way to its neighbours. Values that
// are spaced neither evenly nor by even ratios get cells of one size.
class CellScale {
  constructor(axis) {
    this.values = axis.values;
    const n = this.values.length;
    const isLog = n > 2 && this.values[0] > 0 && !even(this.values) && even(this.values.map(Math.log));
    this.kind = n > 1 && even(this.values) ? "linear" : isLog ? "log" : "list";
    this.positions = { linear: this.values, log: this.values.map(Math.log), list: this.values.map((_, i) => i) }[this.kind];
    const inner = this.positions.slice(1).map((position, i) => (position + this.positions[i]) / 2);
    const half = n > 1 ? [inner[0] - this.positions[0], this.positions[n - 1] - inner[n - 2]] : [0.5, 0.5];
    this.edges = [this.positions[0] - half[0], ...inner, this.positions[n - 1] + half[1]];
  }

  toUnit(position) {
    return (position - this.edges[0]) / (this.edges.at(-1) - this.edges[0]);
  }

  // Any value of the parameter from 0 to 1; between the values of a list it is interpolated.
  unitOf(value) {
    if (this.kind === "linear") return this.toUnit(value);
    if (this.kind === "log") return this.toUnit(Math.log(value));
    const { values } = this;
    if (values.length < 2) return value === values[0] ? 0.5 : NaN;
    const after = values.findIndex((v) => v > value);
    const i = Math.max(0, Math.min((after < 0 ? values.length : after) - 1, values.length - 2));
    return this.toUnit(i + (value - values[i]) / (values[i + 1] - values[i]));
  }

  // The ends of a value's cell, and the position of the value.
  span(index) {
    return [this.toUnit(this.edges[index]), this.toUnit(this.edges[index + 1])];
  }

  position(index) {
    return this.toUnit(this.positions[index]);
  }

  index(unit) {
    const position = this.edges[0] + unit * (this.edges.at(-1) - this.edges[0]);
    const at = this.edges.findIndex((edge) => edge > position);
    return Math.max(0, Math.min((at < 0 ? this.edges.length : at) - 1, this.values.length - 1));
  }

  // Pairs of position and text.
  ticks(count) {
    const [low, high] = [this.values[0], this.values.at(-1)];
    if (this.kind === "list" || this.values.length <= count) {
      const every = Math.ceil(this.values.length / count);
      return this.values.flatMap((value, i) => (i % every ? [] : [[this.position(i), brief(value)]]));
    }
    const chosen = this.kind === "linear" ? ticks(low, high, count) : logTicks(low, high);
    const position = this.kind === "linear" ? (v) => v : Math.log;
    return chosen.map((value) => [this.toUnit(position(value)), brief(value)]);
  }
}

// Nine colours of cividis (Nuñez, Anderton and Renslow 2018): lightness rises evenly, and blue against yellow
// is told apart with every common kind of colour vision.
const STOPS = [
  [0, 34, 78], [26, 56, 111], [67, 78, 108], [97, 101, 111], [125, 124, 120], [155, 148, 118], [188, 174, 108],
  [222, 201, 88], [254, 232, 56],
];

// Where a value lies between two others, from 0 to 1; their difference may be beyond the largest number.
const between = (value, low, high) => (value / 2 - low / 2) / (high / 2 - low / 2);

function colourAt(unit) {
  const position = Math.max(0, Math.min(1, unit || 0)) * (STOPS.length - 1);
  const i = Math.min(Math.floor(position), STOPS.length - 2);
  const mixed = STOPS[i].map((channel, c) => Math.round(channel + (position - i) * (STOPS[i + 1][c] - channel)));
  return `rgb(${mixed.join(" ")})`;
}

// From the values of a measure to colour or height. It spans most of them; the few beyond count as its ends.
class ValueScale {
  // `most` is where it ends at the latest.
  constructor(values, most = Infinity) {
    const finite = Float64Array.from(values.filter(Number.isFinite)).sort();
    const sorted = finite.length ? finite : [0];
    const at = (share) => sorted[Math.round(share * (sorted.length - 1))];
    const whole = sorted.length < 50;
    [this.low, this.high] = whole ? [at(0), at(1)] : [at(0.01), at(0.97)];
    if (this.low < most) this.high = Math.min(this.high, most);
    [this.below, this.above] = [sorted[0] < this.low, sorted.at(-1) > this.high];
    this.log = this.low > 0 && this.high / this.low > 30;
    // Values that differ by rounding alone are one value.
    const rounding = Math.max(1e-14, 1e-9 * Math.max(Math.abs(this.low), Math.abs(this.high)));
    if (!(this.high - this.low > rounding)) [this.low, this.high, this.log] = [this.low - 0.5, this.low + 0.5, false];
  }

  unit(value) {
    return this.log
      ? Math.log(Math.max(value, 0) / this.low) / Math.log(this.high / this.low)
      : between(value, this.low, this.high);
  }

  ticks(count) {
    return this.log ? logTicks(this.low, this.high) : ticks(this.low, this.high, count);
  }
}

// A canvas for sharp lines: drawn in CSS pixels, with as many real ones as the screen has.
function prepared(canvas) {
  const { width, height } = canvas.getBoundingClientRect();
  const ratio = window.devicePixelRatio || 1;
  const [w, h] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
  if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  return { pen, width, height };
}

// A colour or font of the style sheet, so that canvases follow light and dark.
const styled = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
