// What the reader has chosen to see: which cycles, which of several stands for a cell, and scales for what is shown.

const CHOICES = [
  { key: "any", label: "all cycles", keep: () => true },
  { key: "stable", label: "stable cycles", keep: (row) => stableColumn[row] === 1 },
  { key: "contact", label: "stable, foot always pressed down", keep: (row) => stableColumn[row] === 1 && orbits.numbers("min_vertical_force")[row] > 0 },
  { key: "unstable", label: "unstable cycles", keep: (row) => stableColumn[row] === 0 },
].filter(({ key }) => key !== "contact" || orbits.has("min_vertical_force"));

const STABILITY = "stability";
const COUNT = "count";

// Numbers of cycles per cell, as if they were measured.
const countQuantity = Object.assign(new Quantity({ name: COUNT, label: "number of cycles", unit: "", meaning: "Limit cycles of the cell that the choices keep." }, []), { whole: true });

const DEFAULTS = {
  colour: STABILITY, choice: "any", group: "", of: "radius", filter: "", about: "", range: null, view: null, brush: null,
  x: quantities.has("d_max") ? "d_max" : "spectral_radius", y: quantities.has("cot") ? "cot" : "period", z: "spectral_radius", profiles: "time", pin: null,
};

const state = { across: 0, up: null, indices: [], cell: 0, row: null, ...DEFAULTS };

// What happens near 1 decides; how far beyond a multiplier lies matters little.
const MOST = { spectral_radius: 2 };
// Values from which scales diverge by themselves.
const CENTRES = { spectral_radius: 1 };

// Results that hold as long as what they depend on stays the same.
class Kept {
  constructor() {
    this.found = new Map();
  }

  get(name, key, make) {
    const before = this.found.get(name);
    if (before?.key === key) return before.value;
    const value = make();
    this.found.set(name, { key, value });
    return value;
  }
}

const kept = new Kept();
const choiceKey = () => [state.choice, state.group, state.filter].join("\u0000");

// Whether each row passes the choices; and the rows that lie within the brush of the scatter.
function passing() {
  return kept.get("passing", choiceKey(), () => {
    const { keep } = CHOICES.find(({ key }) => key === state.choice);
    const filter = compileFilter(state.filter);
    const group = state.group && orbits.has("group") ? orbits.words("group").indexOf(state.group) : null;
    const groups = group === null ? null : orbits.numbers("group");
    const mask = new Uint8Array(orbits.length);
    for (let row = 0; row < mask.length; row++) mask[row] = keep(row) && (group === null || groups[row] === group) && (!filter || filter(row)) ? 1 : 0;
    return mask;
  });
}

function brushed() {
  if (!state.brush) return null;
  return kept.get("brushed", [choiceKey(), state.x, state.y, state.brush].join("\u0000"), () => {
    const [x0, x1, y0, y1] = state.brush;
    const [xs, ys] = [quantities.get(state.x).numbers(), quantities.get(state.y).numbers()];
    return Uint8Array.from(passing(), (pass, row) => (pass && xs[row] >= x0 && xs[row] <= x1 && ys[row] >= y0 && ys[row] <= y1 ? 1 : 0));
  });
}

// The cycles of a cell that the reader wants to see.
function wanted(cell) {
  const mask = passing();
  const rows = [];
  for (let row = first[cell]; row < first[cell + 1]; row++) if (mask[row]) rows.push(row);
  return rows;
}

// By which values one of several cycles stands for its cell: the least or, with a sign of -1, the largest.
function ranking() {
  const measured = state.of !== "radius" && quantities.has(state.colour);
  return [measured ? quantities.get(state.colour).numbers() : radiusColumn, measured && state.of === "high" ? -1 : 1];
}

// Of several cycles, the one that stands for the cell.
function representative(rows) {
  const [values, sign] = ranking();
  let best = null;
  for (const row of rows) if (!Number.isNaN(values[row]) && (best === null || sign * values[row] < sign * values[best])) best = row;
  return best;
}

// The cycle that stands for each cell, or -1, of those that pass; and how many pass.
function representatives() {
  return kept.get("representatives", [choiceKey(), state.of, state.of === "radius" ? "" : state.colour].join("\u0000"), () => {
    const mask = passing();
    const [values, sign] = ranking();
    const [standing, counts] = [new Int32Array(cells.length).fill(-1), new Int32Array(cells.length)];
    for (let row = 0; row < mask.length; row++) {
      if (!mask[row]) continue;
      const cell = cellColumn[row];
      counts[cell]++;
      const best = standing[cell];
      if (!Number.isNaN(values[row]) && (best < 0 || sign * values[row] < sign * values[best])) standing[cell] = row;
    }
    return { standing, counts };
  });
}

// The cells of the plane that the map shows.
function planeCells() {
  return kept.get("plane", [state.across, state.up, ...state.indices.map((at, i) => (i === state.across || i === state.up ? "" : at))].join(), () => {
    const indices = [...state.indices];
    const found = [];
    for (let up = 0; up < (state.up === null ? 1 : grid.axes[state.up].values.length); up++) {
      for (let across = 0; across < grid.axes[state.across].values.length; across++) {
        indices[state.across] = across;
        if (state.up !== null) indices[state.up] = up;
        found.push(grid.cell(indices));
      }
    }
    return found;
  });
}

// The cycles that are shown: those of the map's plane that pass the choices, and the brush where there is one.
function shownRows() {
  const brush = brushed();
  return planeCells().flatMap(wanted).filter((row) => !brush || brush[row]);
}

const quantityOf = (name) => (name === COUNT ? countQuantity : quantities.get(name));

// The label of the reference about which the colours diverge, or which slices show, if the coloured quantity has it here.
function referenceHere(name, label = referenceLabels[0]) {
  if (!label) return null;
  const value = referenceAt(name, label, state.indices);
  return Number.isNaN(value) ? null : value;
}

// Whether a reference differs from cell to cell of the map: it depends on one of the map's axes.
const differs = (name, label) => references.some((one) => one.quantity === name && one.label === label && one.at.some(([axis]) => axis === state.across || axis === state.up));

// What the colours of the map show: a quantity; or where they diverge about a reference that differs from cell to
// cell, by how much it differs from that of its cell.
function mapQuantity() {
  const quantity = quantityOf(state.colour);
  if (!differs(state.colour, state.about)) return quantity;
  return kept.get("difference", [state.colour, state.about].join("\u0000"), () => {
    const there = referenceColumn(quantity.name, state.about);
    const { name, label, ownUnit: unit, named: si, meaning } = quantity;
    return new Quantity({ name, label: `${label}, less the ${state.about}'s`, unit, si, meaning }, Float64Array.from(quantity.numbers(), (value, row) => value - there[row]));
  });
}

// From which value the scale of a quantity diverges, as the reader has it.
function centreOf(name) {
  if (state.about === "plain") return null;
  if (differs(name, state.about)) return 0;
  if (referenceLabels.includes(state.about)) return referenceHere(name, state.about) ?? CENTRES[name] ?? null;
  return CENTRES[name] ?? null;
}

// From so many stable cycles on the colours of the map are theirs. How far unstable ones go matters little.
const STABLE_ONES = 50;

// The scale of the map's colours: it spans the cells that are shown, those with stable cycles if these are many.
function mapScale() {
  const { standing, counts } = representatives();
  const quantity = mapQuantity();
  const [all, stable] = [[], []];
  for (const cell of planeCells()) {
    const row = standing[cell];
    if (state.colour === COUNT) all.push(counts[cell]);
    else if (row >= 0) (stableColumn[row] === 1 ? stable : all).push(quantity.numbers()[row]);
  }
  const ownCentre = state.colour in CENTRES;
  const values = stable.length >= STABLE_ONES && !ownCentre ? stable : [...all, ...stable];
  return new ValueScale(values, { range: state.range, centre: centreOf(state.colour), most: differs(state.colour, state.about) ? undefined : MOST[state.colour], whole: quantity.whole, factor: quantity.factor });
}
