// The page: what follows from what the reader has chosen.

function look(cell) {
  if (cells.entry("status", cell) === "failed") return { cross: true };
  const { standing, counts } = representatives();
  const row = standing[cell];
  if (row < 0) return {};
  const stable = stableColumn[row] === 1;
  const brush = brushed();
  let dim = false;
  if (brush) {
    dim = true;
    for (let one = first[cell]; one < first[cell + 1] && dim; one++) dim = !brush[one];
  }
  const letter = orbits.has("group") ? orbits.entry("group", row) : null;
  if (state.colour === STABILITY) return { fill: looks.plain[stable ? "stable" : "unstable"], hatch: !stable, letter, dim };
  const value = state.colour === COUNT ? counts[cell] : looks.values[row];
  return { fill: Number.isNaN(value) ? null : looks.scale.colour(value), hatch: !stable && state.colour !== COUNT, cross: Number.isNaN(value), letter, dim };
}

// What the looks of all cells share, gathered before the map is drawn.
let looks = null;

// ---- what is shown ----

const stage = new Stage(byId("stage"), (time, seen) => {
  byId("time").value = String(Math.round((1000 * time) / stage.path.period));
  byId("time").setAttribute("aria-valuetext", `${brief(time * kindFactor("time"), 3)} of ${brief(stage.path.period * kindFactor("time"), 3)}`);
  const digits = (value, kind) => (kindFactor(kind) === 1 ? signed(value.toFixed(3)) : brief(value * kindFactor(kind), 4));
  byId("now").textContent = [
    `t = ${digits(time, "time")}`, seen.d === null ? "" : `d = ${digits(seen.d, "length")}`,
    seen.force === null ? "" : `Fy = ${digits(seen.force[1], "force")}`,
  ].filter(Boolean).join("   ");
  view.mark(time);
  if (state.pin !== null && pinnedStage.path) {
    pinnedStage.step = stage.step;
    pinnedStage.seek((time / stage.path.period) * pinnedStage.path.period);
  }
});
const pinnedStage = new Stage(byId("stage-pinned"), () => {});
const view = new CycleView(stage, (row) => choose(state.cell, row));
const curves = new CurveLayer(byId("curves"));
const tip = byId("tip");

const map = new GridMap(byId("map"), curves, {
  onChoose: (cell) => cell !== null && choose(cell),
  onPoint: (cell, spoken, event) => {
    readOut(cell ?? state.cell, spoken);
    hover(event && cell !== null ? readText(cell) : "", event);
  },
  onView: (to) => {
    state.view = to;
    redraw();
    remember("replace");
  },
});

const slice = new Slice(byId("slice"), (row) => choose(cellColumn[row], row), (row, special, event) => {
  const text = special ? specialText(special, axisQuantities[slice.across]) : row === null ? "" : rowText(row, [slice.quantity]);
  hover(text, event);
});

const scatter = new Scatter(byId("scatter"), {
  onChoose: (row) => choose(cellColumn[row], row),
  onBrush: (box) => {
    state.brush = box;
    redraw();
    remember("push");
  },
  onPoint: (row, event) => hover(row === null ? "" : rowText(row, [scatter.x, scatter.y, scatter.z]), event),
});

const bar = new ColourBar(byId("scale"), (range, done) => {
  state.range = range;
  redraw();
  remember(done ? "push" : "");
});

// A text beside the pointer.
function hover(text, event) {
  tip.hidden = !text || !event || event.pointerType === "touch";
  if (tip.hidden) return;
  tip.textContent = text;
  const { width, height } = tip.getBoundingClientRect();
  tip.style.left = `${Math.max(4, Math.min(event.clientX + 14, innerWidth - width - 8))}px`;
  tip.style.top = `${event.clientY + 18 + height > innerHeight ? event.clientY - height - 10 : event.clientY + 18}px`;
}

// Go to a cell and one of its cycles; without one it is that which is most like the cycle before.
function choose(cell, row, how = "push") {
  const before = state.row;
  state.cell = cell;
  state.indices = grid.indices(cell);
  const rows = wanted(cell).length ? wanted(cell) : rowsOf(cell);
  const group = orbits.has("group") ? orbits.numbers("group") : null;
  const alike = before === null ? [] : rows.filter((r) => stableColumn[r] === stableColumn[before] && (!group || group[r] === group[before]));
  state.row = row ?? representative(alike) ?? representative(rows) ?? rows[0] ?? null;
  showCycle();
  readOut(cell, true);
  redraw();
  remember(how);
}

function showCycle() {
  view.show(state.cell, state.row, state.pin);
  const beside = state.pin !== null && state.row !== null;
  byId("pinned").hidden = !beside;
  byId("pin").textContent = state.pin !== null && state.pin === state.row ? "Unpin" : "Pin for comparison";
  byId("unpin").hidden = state.pin === null || state.pin === state.row;
  if (beside) {
    byId("pinned-name").textContent = `pinned: ${placeText(cellColumn[state.pin])}, cycle ${numberOf(state.pin)}`;
    if (pinnedStage.row !== state.pin) pinnedStage.load(view.pinnedPath);
    else pinnedStage.draw();
    pinnedStage.row = state.pin;
  }
}

const drawnKey = () => JSON.stringify([
  state.across, state.up, state.indices.map((at, i) => (i === state.across || i === state.up ? null : at)), state.choice, state.group, state.filter,
  state.colour, state.of, state.about, state.range, state.view, state.brush?.map(String), state.brush && [state.x, state.y], curves.on, si.on && [si.length, si.mass, si.gravity],
]);

function redraw() {
  byId("map").classList.toggle("strip", state.up === null);
  const key = drawnKey();
  if (looks?.key !== key) {
    const measured = state.colour !== STABILITY;
    looks = { key, plain: { stable: styled("map-stable"), unstable: styled("map-unstable") }, scale: measured ? mapScale() : null, values: measured ? mapQuantity().numbers() : null };
  }
  map.show({
    across: state.across, up: state.up, indices: state.indices, look, caption: caption(), chosen: state.cell,
    pinned: state.pin === null ? null : cellColumn[state.pin], view: state.view, key,
  });
  byId("whole").hidden = state.view === null;
  legend();
  curveLegend();
  showSlice();
  showScatter();
  selection();
  for (const [i, output] of sliders) output(state.indices[i]);
}

// What the colours of the map mean, in a line that saved pictures bear as well.
function caption() {
  const at = grid.axes.flatMap((axis, i) => (i === state.across || i === state.up ? [] : [`${axis.symbol} = ${axisQuantities[i].text(axis.values[state.indices[i]])}`]));
  const quantity = mapQuantity();
  const { scale } = looks;
  const colour = state.colour === STABILITY ? "blue: stable, hatched: unstable" : `${quantity.title}: dark to bright from ${quantity.text(scale.low, 4)} to ${quantity.text(scale.high, 4)}`;
  const diverging = scale && scale.centre !== null ? `${quantity.title}: blue below ${quantity.text(scale.centre, 4)}, brown above, from ${quantity.text(scale.low, 4)} to ${quantity.text(scale.high, 4)}` : colour;
  return [...at, diverging].join("; ");
}

// Drawn anew in full, as when the units or the colours of the page change.
function refresh() {
  looks = null;
  map.drawnKey = scatter.drawnKey = null;
  buildSliders();
  showSpeeds();
  if (state.row !== null) {
    view.row = null;
    const { time, step, playing } = stage;
    showCycle();
    stage.step = step;
    stage.seek(time);
    if (playing) stage.play(true);
  } else byId("cell-name").textContent = placeText(state.cell);
  redraw();
  readOut(state.cell);
}

// The quantity that colours the map, or the largest multiplier, along the horizontal axis.
function showSlice() {
  const quantity = quantities.get(state.colour) ?? quantities.get("spectral_radius");
  const at = grid.axes.flatMap((axis, i) => (i === state.across ? [] : [`${axis.symbol} = ${axisQuantities[i].text(axis.values[state.indices[i]])}`]));
  byId("slice-name").textContent = `${quantity.title} along ${grid.axes[state.across].symbol}${at.length ? ` at ${at.join(", ")}` : ""}`;
  const label = referenceLabels[0] ?? null;
  slice.show({
    across: state.across, indices: state.indices, keep: wanted, quantity, chosen: state.row, label,
    level: CENTRES[quantity.name] ?? null,
    reference: (indices) => {
      const value = label === null ? NaN : referenceAt(quantity.name, label, indices);
      return Number.isNaN(value) ? null : value;
    },
    scaleOf: (values, compared) => new ValueScale(values, {
      axis: !quantity.whole, most: MOST[quantity.name], whole: quantity.whole, factor: quantity.factor, include: quantity.name in CENTRES ? [] : compared.slice(0, 1),
      range: state.range && quantity.name === state.colour ? state.range : null,
    }),
    crossings: state.up === null ? [] : curves.crossings(grid.axes[state.up].values[state.indices[state.up]]),
    view: state.view ? state.view.slice(0, 2) : [0, 1],
  });
  const legend = branchLegend(slice.branches, axisQuantities[state.across]);
  byId("branch-legend").hidden = legend.length === 0;
  byId("branch-legend").replaceChildren(...legend);
}

// While it is out of sight the scatter is drawn when nothing else happens, so that nothing waits for it.
let idle = null;

function showScatter(late = false) {
  byId("brush-clear").hidden = byId("brush-filter").hidden = state.brush === null;
  clearTimeout(idle);
  if (!scatter.inSight && !late) {
    idle = setTimeout(showScatter, 400, true);
    return;
  }
  const [x, y, z] = [state.x, state.y, state.z].map((name) => quantities.get(name));
  const key = JSON.stringify([drawnKey(), state.x, state.y, state.z]);
  const rows = kept.get("plane rows", JSON.stringify([planeCells().length, planeCells()[0], planeCells().at(-1), state.across, state.up, choiceKey()]), () => planeCells().flatMap(wanted));
  const scale = kept.get("scatter colours", key, () => new ValueScale(rows.map((row) => z.numbers()[row]), { centre: CENTRES[z.name] ?? null, most: MOST[z.name], whole: z.whole, factor: z.factor }));
  const values = z.numbers();
  scatter.show({ x, y, z, rows, colour: (row) => (Number.isNaN(values[row]) ? styled("swing") : scale.colour(values[row])), chosen: state.row, pinned: state.pin, brush: state.brush, within: brushed(), key });
  const ends = [scale.low, (scale.low + scale.high) / 2, scale.high].map((value) => html("span", { class: "key" }, html("span", { class: "swatch", style: `background: ${scale.colour(value)}` }), z.text(value, 3)));
  const cut = scatter.scales.some(({ below, above }) => below || above) ? [html("span", { class: "key" }, "marks on the frame lie beyond it")] : [];
  byId("scatter-legend").replaceChildren(html("span", { class: "key" }, `colour: ${z.title}`), ...ends, ...cut);
}

// How many cycles are shown, of all; they can be saved.
function selection() {
  const { rows, many } = kept.get("selection", JSON.stringify([drawnKey(), state.x, state.y]), () => {
    const shown = shownRows();
    return { rows: shown, many: new Set(shown.map((row) => cellColumn[row])).size };
  });
  byId("selection").textContent = `${rows.length.toLocaleString("en")} ${rows.length === 1 ? "cycle" : "cycles"} in ${many.toLocaleString("en")} ${many === 1 ? "cell" : "cells"} shown`;
  byId("save-csv").disabled = byId("save-json").disabled = rows.length === 0;
  return rows;
}

// A cell, and what was found in it.
function readText(cell) {
  const position = [state.across, state.up].filter((i) => i !== null).map((i) => `${grid.axes[i].symbol} = ${axisQuantities[i].text(grid.axes[i].values[grid.indices(cell)[i]])}`);
  const rows = wanted(cell);
  const row = representative(rows);
  const quantity = quantities.get(state.colour);
  const kind = row === null ? "" : `${orbits.has("group") && orbits.entry("group", row) !== null ? `group ${orbits.entry("group", row)}, ` : ""}${stabilityOf(row)}`;
  const value = row === null || !quantity ? "" : `, ${quantity.label} ${quantity.text(quantity.numbers()[row])} ${quantity.unit}`.trimEnd();
  const none = rowsOf(cell).length ? "no cycle passes the choices" : "no cycle";
  const words = rows.length ? `${rows.length} ${rows.length === 1 ? "cycle" : "cycles"}; ${kind}${value}` : none;
  return `${position.join(", ")}: ${words}`;
}

// A cycle, with some of its quantities.
function rowText(row, shown) {
  const group = orbits.has("group") ? orbits.entry("group", row) : null;
  const values = shown.map((quantity) => `${quantity.label} ${quantity.text(quantity.numbers()[row])} ${quantity.unit}`.trimEnd());
  return [placeText(cellColumn[row]), `${group === null ? "" : `group ${group}, `}${stabilityOf(row)}`, ...values].join("\n");
}

function readOut(cell, spoken) {
  byId("readout").textContent = readText(cell);
  if (spoken) byId("spoken").textContent = byId("readout").textContent;
}

// The switch for boundaries, where there are any, and what each line is; or at which values there are some.
function curveLegend() {
  byId("curves-toggle").hidden = boundaries.length === 0;
  byId("curves-shown").checked = curves.on;
  const box = byId("curves-legend");
  box.hidden = boundaries.length === 0 || !curves.on;
  if (box.hidden) return;
  if (curves.shown.length) {
    box.replaceChildren(html("span", { class: "key" }, "boundaries, thick where stable gaits end:"), ...curves.legend());
    return;
  }
  const { names, at } = boundaries[0];
  const axisOf = (name) => axisQuantities[grid.axes.findIndex((axis) => axis.name === name)];
  const values = Object.entries(at).map(([name, value]) => `${axisOf(name).symbol} = ${axisOf(name).text(value)}`);
  const where = values.length ? ` at ${values.join(", ")}` : "";
  box.replaceChildren(html("span", { class: "key" }, `boundaries are shown over ${names.map((name) => axisOf(name).symbol).join(" and ")}${where}`));
}

function legend() {
  const box = byId("legend");
  const swatch = (cls, text) => html("span", { class: "key" }, html("span", { class: `swatch ${cls}` }), text);
  const letters = orbits.has("group") && !orbits.numbers("group").every((code) => code < 0);
  const lettered = letters ? [html("span", { class: "key" }, "letters: group of the cycle shown, with lines between groups")] : [];
  byId("scale").hidden = state.colour === STABILITY;
  byId("range-reset").hidden = state.colour === STABILITY || state.range === null;
  if (state.colour === STABILITY) {
    const counts = { stable: 0, unstable: 0, none: 0, failed: 0 };
    for (const line of map.looks) {
      for (const { fill, hatch, cross } of line) counts[cross ? "failed" : !fill ? "none" : hatch ? "unstable" : "stable"]++;
    }
    const choosing = state.choice !== "any" || state.group || state.filter;
    const labels = { stable: "stable", unstable: "unstable only", none: choosing ? "no cycle that passes the choices" : "no cycle found", failed: "failed" };
    const shown = Object.keys(labels).filter((key) => counts[key] || key !== "failed");
    box.replaceChildren(...shown.map((key) => swatch(key, `${labels[key]}: ${counts[key].toLocaleString("en")} ${counts[key] === 1 ? "cell" : "cells"}`)), ...lettered);
    return;
  }
  const quantity = mapQuantity();
  const { scale } = looks;
  bar.show(scale, quantity);
  const beyond = [scale.below ? "below" : "", scale.above ? "above" : ""].filter(Boolean).join(" and ");
  const label = referenceLabels.includes(state.about) ? `${state.about}'s value` : "stability's limit";
  const centre = differs(state.colour, state.about) ? `${label} in each cell` : `${label}: ${quantity.text(scale.centre ?? NaN, 4)}`;
  box.replaceChildren(
    ...(quantity.meaning ? [defined(`what is ${quantity.label}?`, quantity.meaning)] : []),
    ...(scale.centre === null ? [] : [html("span", { class: "key" }, html("span", { class: "swatch", style: `background: ${colourAt(0.5, DIVERGING)}` }), centre)]),
    ...(state.colour === COUNT ? [] : [swatch("unstable-only", "hatched: unstable")]),
    ...(beyond ? [html("span", { class: "key" }, `values ${beyond} have the colour of the end`)] : []),
    ...lettered,
  );
}

// Write the choice into the address: as a new step to go back from, or in place of the last one.
function remember(how) {
  const address = addressOf();
  if (!how || address === location.hash) return;
  try {
    history[how === "push" ? "pushState" : "replaceState"](null, "", address);
  } catch { /* some viewers do not let a file change its address */ }
}
