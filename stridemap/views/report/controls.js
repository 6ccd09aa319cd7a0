// The controls, and what they change.

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
    // While a slider moves there is one step to go back from, and not one for each value.
    let how = "push";
    input.addEventListener("input", () => {
      choose(grid.cell(state.indices.map((at, j) => (j === i ? Number(input.value) : at))), undefined, how);
      how = "replace";
    });
    input.addEventListener("change", () => { how = "push"; });
    const show = (index) => {
      input.value = String(index);
      output.textContent = `${axisQuantities[i].text(axis.values[index])} ${axisQuantities[i].unit}`.trim();
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
    state.view = null;
    if (referenceLabels.includes(state.about)) state.range = null; // it may have been one of differences
    buildAxes();
    buildSliders();
    buildAbout();
    redraw();
    readOut(state.cell);
    remember("push");
  };
  options(byId("across"), names, state.across, set("across", "up"));
  options(byId("up"), names, state.up, set("up", "across"));
}

// What a change of a choice brings: all that is drawn, and the address.
function changed() {
  buildAbout();
  byId("of").closest("label").hidden = !quantities.has(state.colour);
  redraw();
  readOut(state.cell);
  remember("push");
}

function buildControls() {
  const change = (key) => (value) => {
    state[key] = value;
    if (key === "colour") Object.assign(state, { range: null, about: "" });
    changed();
  };
  const entries = [[STABILITY, "stable or unstable"], ...measures.map((m) => [m.name, m.label]), [COUNT, countQuantity.label]];
  options(byId("colour"), entries, state.colour, change("colour"));
  options(byId("choice"), CHOICES.map(({ key, label }) => [key, label]), state.choice, change("choice"));
  options(byId("of"), [["radius", "most stable"], ["low", "lowest"], ["high", "highest"]], state.of, change("of"));
  byId("of").closest("label").hidden = !quantities.has(state.colour);
  const letters = (orbits.has("group") && orbits.words("group")) || [];
  byId("group").closest("label").hidden = letters.length < 2;
  options(byId("group"), [["", "all"], ...letters.map((l) => [l, l])], state.group, change("group"));
  const plotted = [...quantities.values()].map(({ name, label, symbol }) => [name, symbol && symbol !== label ? `${symbol} (${label})` : label]);
  for (const name of ["x", "y", "z"]) {
    options(byId(`scatter-${name}`), plotted, state[name], (value) => {
      state[name] = value;
      if (name !== "z") state.brush = null;
      changed();
    });
  }
  options(byId("profile-kind"), [["time", "over one step"], ["phase", "phase portraits"]], state.profiles, (value) => {
    state.profiles = value;
    if (state.row !== null) view.profiles();
    view.mark(stage.time);
    remember("push");
  });
  buildAbout();
  byId("filter").value = state.filter;
}

// From which value the colours diverge, where there is a choice.
function buildAbout() {
  const select = byId("about");
  const name = state.colour;
  const labels = referenceLabels.filter((label) => hasReference(name, label));
  const found = [
    ...(name in CENTRES ? [["", `about ${CENTRES[name]}`], ["plain", "from low to high"]] : [["", "from low to high"]]),
    ...labels.map((label) => [label, `about the ${label}'s value`]),
  ];
  if (!found.some(([value]) => value === state.about)) state.about = "";
  select.closest("label").hidden = found.length < 2;
  options(select, found, state.about, (value) => {
    state.about = value;
    redraw();
    remember("push");
  });
}

// Take over a filter if it can be understood; if not, say why, and leave the one before.
function setFilter(text) {
  const box = byId("filter-error");
  try {
    compileFilter(text);
  } catch (error) {
    if (!(error instanceof FilterError)) throw error;
    box.textContent = error.message;
    byId("filter").setAttribute("aria-invalid", "true");
    return false;
  }
  box.textContent = "";
  byId("filter").removeAttribute("aria-invalid");
  state.filter = text.trim();
  return true;
}

function buildFilter() {
  byId("filter").onchange = () => setFilter(byId("filter").value) && changed();
  byId("filter").oninput = () => { if (!byId("filter").value.trim() && setFilter("")) changed(); };
  const names = [...quantities.values()].map(({ name, label, symbol, ownUnit }) => html("span", {}, html("code", {}, name), ` ${symbol ?? label}${ownUnit ? `, in ${ownUnit}` : ""}`));
  const words = Object.entries(orbits.source).filter(([, { type }]) => type !== "number").map(([name, { words: found }]) => html("span", {}, html("code", {}, name), found ? ` one of ${found.slice(0, 12).join(", ")}` : " true or false"));
  const compared = referenceLabels.map((label) => html("span", {}, html("code", {}, label), ` the ${label}'s value of the quantity that is compared`));
  byId("filter-names").replaceChildren(...compared, ...words, ...names);
}

function buildCurves() {
  byId("curves-shown").onchange = (event) => {
    curves.on = event.target.checked;
    redraw();
    remember("push");
  };
  if (orbits.has("branch")) byId("slice-lines").textContent = " Lines join the cycles of one branch, dashed where they are unstable.";
  if (branchTables.length) byId("slice-lines").textContent += " Where branches were followed, they are drawn instead, with their special points.";
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
  byId("strip").addEventListener("click", () => play(false));
  byId("strip").addEventListener("keydown", (event) => event.key !== "Tab" && play(false));
  byId("profiles").addEventListener("keydown", (event) => event.key.startsWith("Arrow") && play(false));
  showSpeeds();
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  still.addEventListener("change", () => still.matches && play(false));
  play(!still.matches);
}

// How fast the walker moves, in its own time, per second of the reader's.
function showSpeeds() {
  options(byId("speed"), SPEEDS.map((s) => [s, `${brief(s * kindFactor("time"), 3)} ${kindUnit("time")} per second`]), stage.speed, (value) => { stage.speed = Number(value); });
}

function buildPin() {
  const pin = (row) => {
    state.pin = row;
    showCycle();
    redraw();
    remember("push");
  };
  byId("pin").onclick = () => pin(state.pin === state.row ? null : state.row);
  byId("unpin").onclick = () => pin(null);
  byId("pinned-go").onclick = () => choose(cellColumn[state.pin], state.pin);
}

function buildBrush() {
  const set = (change) => () => {
    change();
    state.brush = null;
    byId("filter").value = state.filter;
    changed();
  };
  byId("brush-clear").onclick = set(() => {});
  byId("brush-filter").onclick = set(() => {
    const [x0, x1, y0, y1] = state.brush;
    const digits = (value) => String(Number(value.toPrecision(6)));
    const part = (name, low, high) => [Number.isFinite(low) ? `${digits(low)} <= ` : "", name, Number.isFinite(high) ? ` <= ${digits(high)}` : ""].join("");
    const parts = [part(state.x, x0, x1), part(state.y, y0, y1)].filter((text) => text.includes("<="));
    setFilter([...(state.filter ? [`(${state.filter})`] : []), ...parts].join(" and "));
  });
}

// Buttons that copy, save, zoom and reset.
function buildButtons() {
  byId("copy-link").onclick = (event) => copyText(location.href.split("#")[0] + addressOf(), event.currentTarget);
  byId("copy-command").onclick = (event) => copyText(byId("command").textContent, event.currentTarget);
  byId("save-csv").onclick = () => download(`${fileName("cycles")}.csv`, selectionCsv(selection()), "text/csv");
  byId("save-json").onclick = () => download(`${fileName("cycles")}.json`, selectionJson(selection()), "application/json");
  byId("range-reset").onclick = () => {
    state.range = null;
    redraw();
    remember("push");
  };
  for (const [id, factor] of [["zoom-in", 1.6], ["zoom-out", 1 / 1.6], ["whole", 1e-9]]) {
    byId(id).onclick = () => {
      state.view = zoomed(state.view, map.cursorPlace(), factor);
      redraw();
      remember("push");
    };
  }
  byId("map-save").replaceChildren(saveButtons(() => redrawn(map, byId("curves")), "map"));
  byId("slice-save").replaceChildren(saveButtons(() => redrawn(slice), "slice"));
  byId("scatter-save").replaceChildren(saveButtons(() => redrawn(scatter), "scatter"));
  byId("circle-save").replaceChildren(saveButtons(() => byId("circle").querySelector("svg"), "multipliers"));
}

// Metres, kilograms and seconds for the whole page.
function buildUnits() {
  byId("units").hidden = !hasSi;
  const inputs = Object.entries(SIZES).map(([key, [label, unit]]) => {
    const input = html("input", { type: "number", min: "0", step: "any", value: String(si[key]), "data-size": key });
    input.onchange = () => {
      const value = Number(input.value);
      if (!(value > 0 && Number.isFinite(value))) {
        input.value = String(si[key]);
        return;
      }
      si[key] = value;
      if (si.on) {
        refresh();
        remember("push");
      }
    };
    return html("label", {}, label, input, unit);
  });
  byId("sizes").replaceChildren(...inputs);
  byId("si").onchange = (event) => {
    si.on = event.target.checked;
    refresh();
    remember("push");
  };
}

// Controls as the state has them, after the address has changed.
function showUnits() {
  byId("si").checked = si.on;
  byId("sizes").querySelectorAll?.("input").forEach((input) => { input.value = String(si[input.dataset.size]); });
}
