// The address keeps all that the reader has chosen, in values and not in numbers of cells, so that it can be marked,
// sent with the file, and gone back to.

const RESERVED = ["cycle", "colour", "cycles", "group", "of", "filter", "about", "range", "view", "brush", "x", "y", "z", "across", "up", "profiles", "pin", "si", "boundaries", "cell"];
const axisKey = (name) => (RESERVED.includes(name) ? `${name}.value` : name);

// Words of the address by what they keep; those that are as at the start are left out.
const KEYS = { cycles: "choice", group: "group", of: "of", filter: "filter", about: "about", x: "x", y: "y", z: "z", profiles: "profiles" };

const numberOf = (row) => row - first[cellColumn[row]] + 1;

function addressOf() {
  const words = new URLSearchParams();
  grid.axes.forEach((axis, i) => words.set(axisKey(axis.name), plain(axis.values[state.indices[i]])));
  if (state.row !== null) words.set("cycle", String(numberOf(state.row)));
  words.set("colour", state.colour);
  for (const [key, name] of Object.entries(KEYS)) if (state[name] !== DEFAULTS[name]) words.set(key, state[name]);
  if (state.range) words.set("range", state.range.map((value) => String(Number(value.toPrecision(6)))).join());
  if (state.brush) words.set("brush", state.brush.map((value) => String(Number.isFinite(value) ? Number(value.toPrecision(8)) : value)).join());
  if (state.view) words.set("view", viewValues(state.view).map((value) => String(Number(value.toPrecision(6)))).join());
  const [across, up] = startAxes();
  if (state.across !== across || state.up !== up) {
    words.set("across", grid.axes[state.across].name);
    if (state.up !== null) words.set("up", grid.axes[state.up].name);
  }
  if (state.pin !== null) words.set("pin", [...grid.indices(cellColumn[state.pin]).map((at, i) => plain(grid.axes[i].values[at])), numberOf(state.pin)].join());
  if (si.on) words.set("si", [si.length, si.mass, si.gravity].join());
  if (!curves.on) words.set("boundaries", "no");
  return `#${words}`;
}

// The map spans the two axes with the most values; ties keep the order of the grid.
function startAxes() {
  const order = grid.axes.map((_, i) => i).sort((a, b) => grid.axes[b].values.length - grid.axes[a].values.length || a - b);
  const [across, up] = order.slice(0, 2).sort((a, b) => a - b);
  return [across, up ?? null];
}

const viewScales = () => [state.across, state.up].map((i) => (i === null ? null : new CellScale(grid.axes[i])));

// The part of the map that is shown as values of its axes, and back.
function viewValues(view) {
  const [across, up] = viewScales();
  return [view[0], view[1]].map((place) => across.valueOfPlace(place)).concat([view[2], view[3]].map((place) => (up ? up.valueOfPlace(place) : place)));
}

function viewOfValues([left, right, bottom, top]) {
  const [across, up] = viewScales();
  const inside = (place) => Math.max(0, Math.min(1, place));
  const view = [...[left, right].map((value) => inside(across.placeOfValue(value))), ...(up ? [bottom, top].map((value) => inside(up.placeOfValue(value))) : [0, 1])];
  return view[1] - view[0] >= DEEPEST / 2 && view[3] - view[2] >= DEEPEST / 2 ? view : null;
}

// The paper's own point where nothing is said of it: the nearest values of the grid, or else the first cell with a cycle.
function presetCell() {
  const at = grid.cell(grid.axes.map(({ preset }, i) => grid.nearest(i, preset)));
  return first[at + 1] > first[at] ? at : cellColumn[0];
}

// The cell at some values of the axes; those that are left out are as at the start.
function cellAtValues(values) {
  const at = grid.indices(presetCell());
  return grid.cell(at.map((place, i) => (Number.isFinite(values[i]) ? grid.nearest(i, values[i]) : place)));
}

// Values that an address asks for and the grid does not have, in words.
function notOnGrid(hash) {
  const words = new URLSearchParams(hash.slice(1));
  return grid.axes.flatMap((axis, i) => {
    const value = words.has(axisKey(axis.name)) ? Number(words.get(axisKey(axis.name))) : NaN;
    const there = axis.values[grid.nearest(i, value)];
    return Math.abs(value - there) > 1e-6 * Math.abs(value) ? [`${axis.symbol} = ${axisQuantities[i].text(value)}`] : [];
  });
}

// Take over what an address says; what it does not say, or says wrongly, is as at the start. Gives the cell and the row.
function takeAddress(hash) {
  const words = new URLSearchParams(hash.slice(1));
  const numbers = (key, count) => {
    const found = (words.get(key) ?? "").split(",").map((text) => (text.trim() === "" ? NaN : Number(text)));
    return found.length === count && !found.some(Number.isNaN) ? found : null;
  };
  Object.assign(state, DEFAULTS);
  const coloured = words.get("colour");
  if (coloured === COUNT || measures.some(({ name }) => name === coloured)) state.colour = coloured;
  for (const [key, name] of Object.entries(KEYS)) if (words.has(key)) state[name] = words.get(key);
  if (!CHOICES.some(({ key }) => key === state.choice)) state.choice = DEFAULTS.choice;
  if (!["radius", "low", "high"].includes(state.of)) state.of = DEFAULTS.of;
  for (const name of ["x", "y", "z"]) if (!quantities.has(state[name])) state[name] = DEFAULTS[name];
  if (state.group && !(orbits.has("group") && orbits.words("group").includes(state.group))) state.group = "";
  if (!["", "plain", ...referenceLabels].includes(state.about)) state.about = "";
  if (state.profiles !== "phase") state.profiles = "time";
  [state.across, state.up] = startAxes();
  const named = (name) => grid.axes.findIndex((axis) => axis.name === name);
  const [across, up] = [named(words.get("across")), named(words.get("up"))];
  if (across >= 0 && up >= 0 && across !== up) [state.across, state.up] = [across, up];
  const range = numbers("range", 2);
  if (range && range[0] < range[1]) state.range = range;
  const brush = numbers("brush", 4);
  if (brush && brush[0] <= brush[1] && brush[2] <= brush[3]) state.brush = brush;
  const view = numbers("view", 4);
  if (view) state.view = viewOfValues(view);
  const sizes = numbers("si", 3);
  si.on = hasSi && sizes !== null && sizes.every((value) => value > 0 && Number.isFinite(value));
  if (si.on) [si.length, si.mass, si.gravity] = sizes;
  curves.on = words.get("boundaries") !== "no";
  const pin = numbers("pin", grid.axes.length + 1);
  if (pin) state.pin = rowsOf(cellAtValues(pin.slice(0, -1)))[pin.at(-1) - 1] ?? null;
  const cell = cellAtValues(grid.axes.map(({ name }) => (words.has(axisKey(name)) ? Number(words.get(axisKey(name))) : NaN)));
  return [cell, rowsOf(cell)[Number(words.get("cycle")) - 1]];
}
