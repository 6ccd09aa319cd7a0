// The page: what the reader has chosen, and what follows from it.

const ANY = { key: "any", label: "all cycles", keep: () => true };
const CHOICES = [
  ANY,
  { key: "stable", label: "stable cycles", keep: (row) => stableColumn[row] === 1 },
  { key: "contact", label: "stable, foot always pressed down", keep: (row) => stableColumn[row] === 1 && orbits.numbers("min_vertical_force")[row] > 0 },
  { key: "unstable", label: "unstable cycles", keep: (row) => stableColumn[row] === 0 },
].filter(({ key }) => key !== "contact" || orbits.has("min_vertical_force"));

const STABILITY = "stability";
const COUNT = "count";

// Measures with values on a scale; those that say how good the computation was are not for the map.
const colours = report.measures.filter(({ name }) => orbits.words(name) === null && !["stable", "residual", "integration_error", "state_error", "multiplier_error"].includes(name));

const state = { across: 0, up: null, indices: [], colour: STABILITY, choice: "any", group: "", of: "radius", cell: 0, row: null };

// What happens near 1 decides; how far beyond a multiplier lies matters little.
const MOST = { spectral_radius: 2 };

// Scales span the whole sweep, so that colours stay when a slider moves: that of the slice all cycles of the
// choice, that of the map those which stand for their cells.
const scales = new Map();

function scaleOf(name, chart) {
  const key = [chart, name, state.choice, state.group, state.of].join();
  if (!scales.has(key)) scales.set(key, new ValueScale(valuesOf(name, chart), MOST[name]));
  return scales.get(key);
}

function valuesOf(name, chart) {
  const chosen = Array.from({ length: cells.length }, (_, cell) => wanted(cell));
  if (name === COUNT) return chosen.map((rows) => rows.length);
  const rows = chart === "map" ? chosen.map(representative).filter((row) => row !== null) : chosen.flat();
  return rows.map((row) => orbits.numbers(name)[row]);
}

// The cycles of a cell that the reader wants to see.
function wanted(cell) {
  const { keep } = CHOICES.find(({ key }) => key === state.choice);
  return rowsOf(cell).filter((row) => keep(row) && (!state.group || orbits.entry("group", row) === state.group));
}

// Of several cycles, the one that stands for the cell.
function representative(rows) {
  const measured = state.of !== "radius" && orbits.has(state.colour);
  const values = measured ? orbits.numbers(state.colour) : radiusColumn;
  const sign = measured && state.of === "high" ? -1 : 1;
  const finite = rows.filter((row) => !Number.isNaN(values[row]));
  return finite.reduce((best, row) => (best === null || sign * values[row] < sign * values[best] ? row : best), null);
}

function look(cell) {
  if (cells.entry("status", cell) === "failed") return { cross: true };
  const rows = wanted(cell);
  const row = representative(rows);
  if (row === null) return {};
  const stable = stableColumn[row] === 1;
  const letter = orbits.has("group") ? orbits.entry("group", row) : null;
  if (state.colour === STABILITY) return { fill: styled(stable ? "map-stable" : "map-unstable"), hatch: !stable, letter };
  const value = state.colour === COUNT ? rows.length : orbits.numbers(state.colour)[row];
  return { fill: Number.isNaN(value) ? null : colourAt(scaleOf(state.colour, "map").unit(value)), hatch: !stable && state.colour !== COUNT, cross: Number.isNaN(value) };
}

// ---- what follows from a choice ----

const stage = new Stage(byId("stage"), (time, seen) => {
  byId("time").value = String(Math.round((1000 * time) / stage.path.period));
  byId("time").setAttribute("aria-valuetext", `${brief(time, 3)} of ${brief(stage.path.period, 3)}`);
  byId("now").textContent = [
    `t = ${time.toFixed(3)}`, seen.d === null ? "" : `d = ${signed(seen.d.toFixed(3))}`,
    seen.force === null ? "" : `Fy = ${signed(seen.force[1].toFixed(3))}`,
  ].filter(Boolean).join("   ");
  view.mark(time);
});
const view = new CycleView(stage, (row) => choose(state.cell, row));
const curves = new CurveLayer(byId("curves"));
const map = new GridMap(byId("map"), curves, (cell) => cell !== null && choose(cell), (cell, spoken) => readOut(cell ?? state.cell, spoken));

const slice = new Slice(byId("slice"), (row) => choose(orbits.numbers("cell")[row], row));

function choose(cell, row) {
  const before = state.row;
  state.cell = cell;
  state.indices = grid.indices(cell);
  const rows = wanted(cell).length ? wanted(cell) : rowsOf(cell);
  const same = before === null ? [] : rows.filter((r) => stableColumn[r] === stableColumn[before] && (!orbits.has("group") || orbits.entry("group", r) === orbits.entry("group", before)));
  state.row = row ?? representative(same) ?? representative(rows) ?? rows[0] ?? null;
  view.show(cell, state.row);
  readOut(cell, true);
  redraw();
  remember();
}

function redraw() {
  byId("map").classList.toggle("strip", state.up === null);
  map.show({ across: state.across, up: state.up, indices: state.indices, look, chosen: state.cell });
  legend();
  curveLegend();
  showSlice();
  for (const [i, output] of sliders) output(state.indices[i]);
}

// The measure that colours the map, or the largest multiplier, along the horizontal axis.
function showSlice() {
  const named = (name) => report.measures.find((m) => m.name === name);
  const measure = named(state.colour) ?? named("spectral_radius");
  const at = grid.axes.flatMap((axis, i) => (i === state.across ? [] : [`${axis.symbol} = ${brief(axis.values[state.indices[i]], 6)}`]));
  byId("slice-name").textContent = `${withUnit(measure.label, measure.unit)} along ${grid.axes[state.across].symbol}${at.length ? ` at ${at.join(", ")}` : ""}`;
  slice.show({
    across: state.across, indices: state.indices, keep: wanted, measure, scale: scaleOf(measure.name, "slice"),
    level: measure.name === "spectral_radius" ? 1 : null, chosen: state.row,
    crossings: state.up === null ? [] : curves.crossings(grid.axes[state.up].values[state.indices[state.up]]),
  });
}

function readOut(cell, spoken) {
  const position = [state.across, state.up].filter((i) => i !== null).map((i) => `${grid.axes[i].symbol} = ${brief(grid.axes[i].values[grid.indices(cell)[i]], 6)}`);
  const rows = wanted(cell);
  const row = representative(rows);
  const measure = colours.find(({ name }) => name === state.colour);
  const kind = row === null ? "" : `${orbits.has("group") && orbits.entry("group", row) !== null ? `group ${orbits.entry("group", row)}, ` : ""}${stabilityOf(row)}`;
  const value = row === null || !measure ? "" : `, ${measure.label} ${brief(orbits.numbers(state.colour)[row], 6)} ${measure.unit}`;
  const words = rows.length ? `${rows.length} ${rows.length === 1 ? "cycle" : "cycles"}; ${kind}${value}` : "no cycle";
  byId("readout").textContent = `${position.join(", ")}: ${words}`;
  if (spoken) byId("spoken").textContent = byId("readout").textContent;
}

// The switch for boundaries, where there are any, and what each line is; or at which values there are some.
function curveLegend() {
  byId("curves-toggle").hidden = boundaries.length === 0;
  const box = byId("curves-legend");
  box.hidden = boundaries.length === 0 || !curves.on;
  if (box.hidden) return;
  if (curves.shown.length) {
    box.replaceChildren(html("span", { class: "key" }, "boundaries, thick where stable gaits end:"), ...curves.legend());
    return;
  }
  const { names, at } = boundaries[0];
  const values = Object.entries(at).map(([name, value]) => `${grid.axes.find((axis) => axis.name === name).symbol} = ${brief(value, 6)}`);
  const where = values.length ? ` at ${values.join(", ")}` : "";
  const symbols = names.map((name) => grid.axes.find((axis) => axis.name === name).symbol);
  box.replaceChildren(html("span", { class: "key" }, `boundaries are shown over ${symbols.join(" and ")}${where}`));
}

function legend() {
  const box = byId("legend");
  const swatch = (cls, text) => html("span", { class: "key" }, html("span", { class: `swatch ${cls}` }), text);
  if (state.colour === STABILITY) {
    const counts = { stable: 0, unstable: 0, none: 0, failed: 0 };
    for (const line of map.looks) {
      for (const { fill, hatch, cross } of line) counts[cross ? "failed" : !fill ? "none" : hatch ? "unstable" : "stable"]++;
    }
    const labels = { stable: "stable", unstable: "unstable only", none: "no cycle found", failed: "failed" };
    const shown = Object.keys(labels).filter((key) => counts[key] || key !== "failed");
    box.replaceChildren(...shown.map((key) => swatch(key, `${labels[key]}: ${counts[key]} cells`)));
    if (orbits.has("group") && !orbits.numbers("group").every((code) => code < 0)) box.append(html("span", { class: "key" }, "letters: group of the cycle shown"));
    return;
  }
  const measure = colours.find(({ name }) => name === state.colour) ?? { label: "number of cycles", unit: "" };
  const scale = scaleOf(state.colour, "map");
  const stops = Array.from({ length: 17 }, (_, i) => colourAt(i / 16)).join(", ");
  const bar = html("div", { class: "bar", style: `background: linear-gradient(to right, ${stops})` });
  const inside = scale.ticks(5).map((value) => html("span", { style: `left: ${100 * scale.unit(value)}%` }, brief(value)));
  const beyond = [scale.below ? "below" : "", scale.above ? "above" : ""].filter(Boolean).join(" and ");
  box.replaceChildren(
    html("div", { class: "scale" }, html("span", { class: "name" }, withUnit(measure.label, measure.unit)), bar, html("div", { class: "ticks" }, ...inside)),
    ...(state.colour === COUNT ? [] : [swatch("unstable-only", "hatched: unstable")]),
    ...(beyond ? [html("span", { class: "key" }, `values ${beyond} have the colour of the end`)] : []),
  );
}

// The address keeps the choice, so that it can be marked and sent with the file.
function remember() {
  const kept = new URLSearchParams({ cell: state.cell, cycle: rowsOf(state.cell).indexOf(state.row) + 1, colour: state.colour });
  try {
    history.replaceState(null, "", `#${kept}`);
  } catch { /* some viewers do not let a file change its address */ }
}

// ---- controls ----

let sliders = [];

function options(select, entries, chosen, onChange) {
  select.replaceChildren(...entries.map(([value, text]) => html("option", { value: String(value), selected: value === chosen }, text)));
  select.onchange = () => onChange(select.value);
}

function buildSliders() {
  const others = grid.axes.map((_, i) => i).filter((i) => i !== state.across && i !== state.up);
  const parts = others.map((i) => {
    const axis = grid.axes[i];
    const output = html("output", { for: `slider-${i}` });
    const input = html("input", { type: "range", id: `slider-${i}`, min: "0", max: String(axis.values.length - 1), step: "1", value: String(state.indices[i]), "data-axis": axis.name });
    input.addEventListener("input", () => choose(grid.cell(state.indices.map((at, j) => (j === i ? Number(input.value) : at)))));
    const show = (index) => {
      input.value = String(index);
      output.textContent = `${brief(axis.values[index], 6)} ${axis.unit}`.trim();
      input.setAttribute("aria-valuetext", output.textContent);
    };
    const label = html("label", { class: "slider", title: axis.meaning }, html("span", {}, axis.symbol), input, output);
    return { i, show, label };
  });
  sliders = parts.map(({ i, show }) => [i, show]);
  byId("sliders").replaceChildren(...parts.map(({ label }) => label));
}

function buildAxes() {
  const names = grid.axes.map((axis, i) => [i, `${axis.symbol} (${axis.name})`]);
  byId("axes").hidden = grid.axes.length < 3;
  const set = (one, other) => (value) => {
    const before = state[one];
    state[one] = Number(value);
    if (state[other] === state[one]) state[other] = before;
    buildAxes();
    buildSliders();
    redraw();
    readOut(state.cell);
  };
  options(byId("across"), names, state.across, set("across", "up"));
  options(byId("up"), names, state.up, set("up", "across"));
}

function buildControls() {
  const change = (key) => (value) => {
    state[key] = value;
    byId("of").closest("label").hidden = !orbits.has(state.colour);
    redraw();
    readOut(state.cell);
    remember();
  };
  const entries = [[STABILITY, "stable or unstable"], ...colours.map((m) => [m.name, m.label]), [COUNT, "number of cycles"]];
  options(byId("colour"), entries, state.colour, change("colour"));
  options(byId("choice"), CHOICES.map(({ key, label }) => [key, label]), state.choice, change("choice"));
  options(byId("of"), [["radius", "most stable"], ["low", "lowest"], ["high", "highest"]], state.of, change("of"));
  byId("of").closest("label").hidden = !orbits.has(state.colour);
  const letters = (orbits.has("group") && orbits.words("group")) || [];
  byId("group").closest("label").hidden = letters.length < 2;
  options(byId("group"), [["", "all"], ...letters.map((l) => [l, l])], "", change("group"));
}

function buildCurves() {
  byId("curves-shown").onchange = (event) => {
    curves.on = event.target.checked;
    redraw();
  };
  if (orbits.has("branch")) byId("slice-lines").textContent = " Lines join the cycles of one branch, dashed where they are unstable.";
  if (boundaries.length) byId("slice-lines").textContent += " Upright lines are where boundaries are crossed.";
}

function buildPlayer() {
  const button = byId("play");
  const play = (on) => {
    stage.play(on);
    button.textContent = stage.playing ? "Pause" : "Play";
    button.setAttribute("aria-pressed", String(stage.playing));
  };
  button.onclick = () => play(!stage.playing);
  byId("time").addEventListener("input", () => {
    play(false);
    stage.seek((Number(byId("time").value) / 1000) * stage.path.period);
  });
  byId("profiles").addEventListener("pointerdown", () => play(false));
  options(byId("speed"), SPEEDS.map((s) => [s, `${s} ${model.units.time} per second`]), stage.speed, (value) => { stage.speed = Number(value); });
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  still.addEventListener("change", () => still.matches && play(false));
  play(!still.matches);
}

// ---- start ----

// The map spans the two axes with the most values; ties keep the order of the grid.
function startAxes() {
  const order = grid.axes.map((_, i) => i).sort((a, b) => grid.axes[b].values.length - grid.axes[a].values.length || a - b);
  const [across, up] = order.slice(0, 2).sort((a, b) => a - b);
  Object.assign(state, { across, up: up ?? null });
}

// The cell of the address, or the one nearest to the preset, or else the first that has a cycle.
function startCell() {
  const kept = new URLSearchParams(location.hash.slice(1));
  if (kept.get("colour") === COUNT || colours.some(({ name }) => name === kept.get("colour"))) state.colour = kept.get("colour");
  const cell = Number(kept.get("cell") ?? NaN);
  if (Number.isInteger(cell) && cell >= 0 && cell < cells.length) return [cell, rowsOf(cell)[Number(kept.get("cycle")) - 1]];
  const nearest = grid.axes.map(({ values, preset }) => values.reduce((best, v, i) => (Math.abs(v - preset) < Math.abs(values[best] - preset) ? i : best), 0));
  const at = grid.cell(nearest);
  return [rowsOf(at).length ? at : orbits.numbers("cell")[0], undefined];
}

startAxes();
const [startingCell, startingRow] = startCell();
state.indices = grid.indices(startingCell);
buildControls();
buildAxes();
buildSliders();
choose(startingCell, startingRow);
buildPlayer();
buildCurves();

// Canvases are drawn anew when their size or the colours change.
for (const [id, drawn] of [["map", map], ["slice", slice], ["stage", stage]]) new ResizeObserver(() => drawn.draw()).observe(byId(id));
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  redraw();
  stage.draw();
});

// For scripts and for tests: the tables, the equations, and the page itself.
window.stridemap = { report, orbits, cells, grid, equations, evaluate, Path, map, slice, curves, joinedBy, stage, state, choose };
document.documentElement.dataset.ready = "yes";
