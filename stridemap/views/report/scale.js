// Scales from values to pixels, with their ticks.

// Round tick values inside a range, at most about `count`; of whole numbers only whole ones.
function ticks(low, high, count = 6, whole = false) {
  const raw = whole ? Math.max(1, (high - low) / count) : (high - low) / count;
  if (!(raw > 0)) return [low];
  const unit = 10 ** Math.floor(Math.log10(raw));
  const step = (whole ? [1, 2, 5, 10] : [1, 2, 2.5, 5, 10]).map((m) => m * unit).find((s) => s >= raw * (1 - 1e-9));
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
    this.view = [0, 1];
    const n = this.values.length;
    const isLog = n > 2 && this.values[0] > 0 && !even(this.values) && even(this.values.map(Math.log));
    this.kind = n > 1 && even(this.values) ? "linear" : isLog ? "log" : "list";
    this.positions = { linear: this.values, log: this.values.map(Math.log), list: this.values.map((_, i) => i) }[this.kind];
    const inner = this.positions.slice(1).map((position, i) => (position + this.positions[i]) / 2);
    const half = n > 1 ? [inner[0] - this.positions[0], this.positions[n - 1] - inner[n - 2]] : [0.5, 0.5];
    this.edges = [this.positions[0] - half[0], ...inner, this.positions[n - 1] + half[1]];
  }

  // Only the part of the axis between two places from 0 to 1 is shown.
  zoom(from, to) {
    this.view = [from, to];
    return this;
  }

  toUnit(position) {
    const unit = (position - this.edges[0]) / (this.edges.at(-1) - this.edges[0]);
    return (unit - this.view[0]) / (this.view[1] - this.view[0]);
  }

  // The position at a place from 0 to 1 of what is shown.
  toPosition(unit) {
    return this.edges[0] + (this.view[0] + unit * (this.view[1] - this.view[0])) * (this.edges.at(-1) - this.edges[0]);
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

  // The value of the parameter at a place from 0 to 1 of the whole axis, and the place of a value.
  valueOfPlace(place) {
    const position = this.edges[0] + place * (this.edges.at(-1) - this.edges[0]);
    if (this.kind === "linear") return position;
    if (this.kind === "log") return Math.exp(position);
    const { values } = this;
    if (values.length < 2) return values[0] + place - 0.5;
    const i = Math.max(0, Math.min(Math.floor(position), values.length - 2));
    return values[i] + (position - i) * (values[i + 1] - values[i]);
  }

  placeOfValue(value) {
    if (this.values.length < 2) return value - this.values[0] + 0.5;
    return this.view[0] + this.unitOf(value) * (this.view[1] - this.view[0]);
  }

  // The ends of a value's cell, and the position of the value.
  span(index) {
    return [this.toUnit(this.edges[index]), this.toUnit(this.edges[index + 1])];
  }

  position(index) {
    return this.toUnit(this.positions[index]);
  }

  index(unit) {
    const position = this.toPosition(unit);
    const at = this.edges.findIndex((edge) => edge > position);
    return Math.max(0, Math.min((at < 0 ? this.edges.length : at) - 1, this.values.length - 1));
  }

  // Pairs of position and text, of values in other units by a factor.
  ticks(count, factor = 1) {
    const [from, to] = [this.index(0), this.index(1)];
    const inside = ([unit]) => unit >= -1e-9 && unit <= 1 + 1e-9;
    if (this.kind === "list" || to - from < count) {
      const every = Math.ceil((to - from + 1) / count);
      const places = Array.from({ length: to - from + 1 }, (_, i) => from + i).filter((_, i) => i % every === 0);
      return places.map((i) => [this.position(i), brief(this.values[i] * factor)]).filter(inside);
    }
    const linear = this.kind === "linear";
    const [low, high] = [0, 1].map((unit) => (linear ? this.toPosition(unit) : Math.exp(this.toPosition(unit))) * factor);
    const chosen = linear ? ticks(low, high, count) : logTicks(low, high);
    return chosen.map((value) => [this.toUnit(linear ? value / factor : Math.log(value / factor)), brief(value)]).filter(inside);
  }
}

// The size of a canvas in CSS pixels. It is kept, because asking for it lays the page out; an observer forgets it.
const sizes = new Map();

function sizeOf(canvas) {
  if (!sizes.has(canvas)) {
    const { width, height } = canvas.getBoundingClientRect();
    if (!(width > 0 && height > 0)) return { width, height };
    sizes.set(canvas, { width, height });
  }
  return sizes.get(canvas);
}

// A canvas for sharp lines: drawn in CSS pixels, with as many real ones as the screen has.
function prepared(canvas) {
  const { width, height } = sizeOf(canvas);
  const ratio = window.devicePixelRatio || 1;
  const [w, h] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
  if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  return { pen, width, height };
}

// A colour or font of the style sheet, so that canvases follow light and dark. It is kept until one of these changes,
// because asking for it computes the styles of the page.
const styles = new Map();
for (const media of ["(prefers-color-scheme: dark)", "print"]) matchMedia(media).addEventListener("change", () => styles.clear());
for (const event of ["beforeprint", "afterprint"]) addEventListener(event, () => styles.clear());

function styled(name) {
  if (!styles.has(name)) styles.set(name, getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim());
  return styles.get(name);
}
