// The sweep's tables as arrays of numbers, and the grid they lie on.

const report = JSON.parse(document.getElementById("data").textContent);
const model = report.model;

function decode(text, Numbers) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return new Numbers(bytes.buffer);
}

// Bytes from the characters of base 85, four from each five; up to three zeros follow the last.
function fromBase85(text) {
  const digit = new Uint8Array(128);
  let next = 0;
  for (let code = 33; code < 127; code++) if (!"\"\\<&'{(@/".includes(String.fromCharCode(code))) digit[code] = next++;
  const bytes = new Uint8Array((text.length / 5) * 4);
  const view = new DataView(bytes.buffer);
  for (let i = 0, at = 0; i < text.length; i += 5, at += 4) {
    let word = 0;
    for (let j = 0; j < 5; j++) word = word * 85 + digit[text.charCodeAt(i + j)];
    view.setUint32(at, word);
  }
  return bytes;
}

// The bytes of all columns.
async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

if (typeof DecompressionStream === "undefined") {
  document.getElementById("old-browser").hidden = false;
  return;
}
const planes = await inflated(fromBase85(report.bytes.text).subarray(0, report.bytes.packed));
delete report.bytes;

// Whole numbers whose bytes lie apart by their place; where they were counted from one below the least, a 0 is a gap.
function wholeNumbers({ least, planes: count, at, steps }, rows) {
  const values = new Float64Array(rows);
  for (let place = count - 1; place >= 0; place--) {
    const start = at + place * rows;
    for (let row = 0; row < rows; row++) values[row] = values[row] * 256 + planes[start + row];
  }
  if (steps) for (let row = 1; row < rows; row++) values[row] += values[row - 1];
  for (let row = 0; row < rows; row++) values[row] = values[row] === 0 ? NaN : values[row] + (least - 1);
  return values;
}

function doubles(at, rows) {
  const bytes = new Uint8Array(8 * rows);
  for (let place = 0; place < 8; place++) for (let row = 0; row < rows; row++) bytes[8 * row + place] = planes[at + place * rows + row];
  return new Float64Array(bytes.buffer);
}

// A column as numbers. Each is the number nearest to its decimal digits, as if they were read.
function columnOf(source, rows) {
  if (source.double !== undefined) return doubles(source.double, rows);
  const values = wholeNumbers(source, rows);
  if (source.powers) {
    const powers = wholeNumbers(source.powers, rows);
    for (let row = 0; row < rows; row++) values[row] = Number(`${values[row]}e${powers[row]}`);
  } else if (source.decimals) {
    const scale = 10 ** source.decimals; // exact, as the whole number is: the quotient is rounded once
    for (let row = 0; row < rows; row++) values[row] /= scale;
  }
  for (const [row, text] of source.odd ?? []) values[row] = Number(text);
  return values;
}

// A table of columns, each decoded when it is first asked for.
class Table {
  constructor(source) {
    this.length = source.rows;
    this.source = source.columns;
    this.decoded = new Map();
  }

  has(name) {
    return Object.hasOwn(this.source, name);
  }

  // The column as numbers: words as indices into words(name), truth as 0 and 1, or 2 where
  // it is not known.
  numbers(name) {
    let found = this.decoded.get(name);
    if (!found) this.decoded.set(name, (found = columnOf(this.source[name], this.length)));
    return found;
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

  // Half a unit of the last decimal that was kept of a number.
  error(name, row) {
    const { double, decimals, whole } = this.source[name];
    if (double !== undefined || whole) return 0;
    const value = Math.abs(this.numbers(name)[row]);
    const relative = value < 1e-3 && decimals !== 15 ? 10 ** (Math.floor(Math.log10(value)) - 3) : 0; // small measures have four digits
    return 0.5 * Math.max(relative || 0, decimals ? 10 ** -decimals : 0);
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

  // The place of a value of a parameter on its axis, or of the nearest one.
  nearest(axis, value) {
    const { values } = this.axes[axis];
    return values.reduce((best, v, i) => (Math.abs(v - value) < Math.abs(values[best] - value) ? i : best), 0);
  },

  // The parameter vector of a cell, in the model's order.
  point(cell) {
    const named = { ...report.fixed };
    this.indices(cell).forEach((index, i) => { named[this.axes[i].name] = this.axes[i].values[index]; });
    return model.parameters.map((parameter) => named[parameter.name]);
  },
};

// Rows of orbits lie in the order of their cells: those of cell c are first[c] to first[c + 1] - 1.
const cellColumn = orbits.numbers("cell");
const first = new Int32Array(cells.length + 1);
for (const cell of cellColumn) first[cell + 1]++;
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

function entryText(name, row) {
  const value = orbits.entry(name, row);
  if (value === null) return "none";
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (typeof value === "string") return value;
  return orbits.source[name].whole ? String(value) : exact(value);
}
