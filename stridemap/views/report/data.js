// The sweep's tables as arrays of numbers, the grid they lie on, and how numbers are written.

const report = JSON.parse(document.getElementById("data").textContent);
const model = report.model;

function decode(text, Numbers) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return new Numbers(bytes.buffer);
}

// A table of columns, each decoded when it is first asked for.
class Table {
  constructor(source) {
    this.length = source.rows;
    this.source = source.columns;
    this.decoded = new Map();
  }

  has(name) {
    return name in this.source;
  }

  // The column as numbers: words as indices into words(name), truth as 0 and 1, or 2 where
  // it is not known.
  numbers(name) {
    if (!this.decoded.has(name)) {
      const { type, data } = this.source[name];
      this.decoded.set(name, decode(data, { f8: Float64Array, bool: Uint8Array }[type] ?? Int32Array));
    }
    return this.decoded.get(name);
  }

  words(name) {
    return this.source[name].words ?? null;
  }

  // One entry as a number, a word, true, false, or null for none.
  entry(name, row) {
    const value = this.numbers(name)[row];
    const { type, words } = this.source[name];
    if (type === "word") return value < 0 ? null : words[value];
    if (type === "bool") return value > 1 ? null : value === 1;
    return Number.isNaN(value) ? null : value;
  }
}

const orbits = new Table(report.orbits);
const cells = new Table(report.cells);

// The grid: cells are numbered with the last axis running fastest.
const grid = {
  axes: report.axes,

  cell(indices) {
    return this.axes.reduce((cell, axis, i) => cell * axis.values.length + indices[i], 0);
  },

  indices(cell) {
    const indices = new Array(this.axes.length);
    for (let i = this.axes.length - 1; i >= 0; i--) {
      const n = this.axes[i].values.length;
      indices[i] = cell % n;
      cell = Math.floor(cell / n);
    }
    return indices;
  },

  // The parameter vector of a cell, in the model's order.
  point(cell) {
    const named = { ...report.fixed };
    this.indices(cell).forEach((index, i) => { named[this.axes[i].name] = this.axes[i].values[index]; });
    return model.parameters.map((parameter) => named[parameter.name]);
  },
};

// Rows of orbits lie in the order of their cells: those of cell c are first[c] to first[c + 1] - 1.
const first = new Int32Array(cells.length + 1);
for (const cell of orbits.numbers("cell")) first[cell + 1]++;
for (let cell = 0; cell < cells.length; cell++) first[cell + 1] += first[cell];

function rowsOf(cell) {
  return Array.from({ length: first[cell + 1] - first[cell] }, (_, i) => first[cell] + i);
}

const stableColumn = orbits.numbers("stable");
const stabilityOf = (row) => ["unstable", "stable", "stable or not: not known"][stableColumn[row]];
const radiusColumn = orbits.numbers("spectral_radius");

// The Floquet multipliers of a row as pairs of real and imaginary part.
function multipliers(row) {
  return model.section.map((_, i) => ["re", "im"].map((part) => orbits.numbers(`multiplier_${i}_${part}`)[row]));
}

const MINUS = "\u2212";
const signed = (text) => text.replaceAll("-", MINUS);

// A number with so many decimals that columns stand under each other, as the command line prints it.
function exact(value, decimals = 10) {
  if (Math.abs(value) >= 1e-3 || value === 0) return signed(value.toFixed(decimals));
  return signed(value.toExponential(3));
}

// A number in a few digits, for axes and short texts.
function brief(value, digits = 4) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) return signed(value.toExponential(Math.max(0, digits - 3)));
  return signed(String(Number(value.toPrecision(digits))));
}

function entryText(name, row) {
  const value = orbits.entry(name, row);
  if (value === null) return "none";
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (typeof value === "string") return value;
  return orbits.source[name].whole ? String(value) : exact(value);
}

const withUnit = (label, unit) => (unit ? `${label} [${unit}]` : label);
