// Units: those of the model, or metres, kilograms and seconds for a walker of a given size, on the whole page.

// Leg length in m, mass of the upper body in kg, gravity in m/s^2, and whether they are used.
const si = { on: false, length: 1, mass: 50, gravity: 9.80665 };
const SIZES = { length: [`leg length ${model.units.length}`, "m"], mass: [`mass ${model.units.mass}`, "kg"], gravity: ["gravity g", "m/s²"] };
const hasSi = Object.keys(report.si).length > 0;

// What one of a unit is in the units that are shown.
function factorOf(unit) {
  const powers = si.on && Object.hasOwn(report.si, unit) ? report.si[unit] : null;
  return powers === null ? 1 : si.mass ** (powers[0] / 2) * si.length ** (powers[1] / 2) * si.gravity ** (powers[2] / 2);
}

const superscripts = (unit) => unit.replaceAll("^2", "²");
const unitText = (unit, name) => (si.on && Object.hasOwn(report.si, unit) ? superscripts(name) : unit);

// Of a kind of quantity: its unit as it is shown, and what one of the model's is in it.
const kindUnit = (kind) => unitText(model.units[kind], model.si_units[kind]);
const kindFactor = (kind) => factorOf(model.units[kind]);

// Everything that can be plotted, named in a filter or compared: the measures with values on a scale, and parameters.
class Quantity {
  constructor({ name, label, symbol, unit, si: named, meaning }, values) {
    Object.assign(this, { name, symbol, ownUnit: unit, named, meaning, values });
    this.label = label ?? symbol;
    this.whole = values === null && Boolean(orbits.source[name]?.whole);
  }

  get unit() {
    return unitText(this.ownUnit, this.named);
  }

  get factor() {
    return factorOf(this.ownUnit);
  }

  get title() {
    return withUnit(this.label, this.unit);
  }

  // The values of all rows, in the model's own units.
  numbers() {
    this.values ??= orbits.numbers(this.name);
    return this.values;
  }

  text(value, digits = 6) {
    return this.whole ? String(value) : brief(value * this.factor, digits);
  }
}

// Measures that say how good the computation was are for the tables only.
const ERRORS = ["residual", "integration_error", "state_error", "multiplier_error"];
const measures = report.measures
  .filter(({ name }) => orbits.source[name].type === "number" && !ERRORS.includes(name))
  .map((measure) => new Quantity(measure, null));

// Parameters of the grid, by row.
const axisQuantities = grid.axes.map((axis, i) => {
  const after = grid.axes.slice(i + 1).reduce((product, { values }) => product * values.length, 1);
  const values = Float64Array.from(cellColumn, (cell) => axis.values[Math.floor(cell / after) % axis.values.length]);
  return new Quantity({ ...axis, label: axis.symbol }, values);
});

const quantities = new Map([...measures, ...axisQuantities].map((quantity) => [quantity.name, quantity]));
