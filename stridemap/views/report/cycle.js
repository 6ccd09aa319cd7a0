// One cell's limit cycles: the list to choose from, and everything about the one that is chosen, beside a pinned one.

const byId = (id) => document.getElementById(id);

// A term whose meaning opens beneath it, by mouse, finger and keyboard.
function defined(term, meaning) {
  if (!meaning) return html("span", {}, term);
  return html("details", { class: "definition" }, html("summary", {}, term), html("p", {}, meaning));
}

class CycleView {
  // `onCycle(row)` is called when the reader chooses another cycle of the cell.
  constructor(stage, onCycle) {
    this.stage = stage;
    this.onCycle = onCycle;
    this.pinned = null;
    this.strip = new Strip(byId("strip"), (time) => this.stage.seek(time));
    byId("profiles").addEventListener("pointerdown", (event) => this.scrub(event));
    byId("profiles").addEventListener("pointermove", (event) => event.buttons && this.scrub(event));
    byId("profiles").addEventListener("keydown", (event) => this.key(event));
  }

  // Show a cell and one of its cycles, or none, beside a pinned one, or none.
  show(cell, row, pinned) {
    byId("cell-name").textContent = placeText(cell);
    this.list(cell, row);
    const found = row !== null;
    byId("cycle").hidden = byId("numbers").hidden = byId("profiles-card").hidden = !found;
    byId("empty").hidden = found;
    if (!found) {
      const status = cells.entry("status", cell);
      const reason = cells.entry("reason", cell) ?? "no cycle passes the choice above";
      byId("empty").textContent = `${status === "failed" ? "This cell failed" : "No limit cycle here"}: ${reason}.`;
      this.stage.play(false);
      this.row = null;
      return;
    }
    const another = this.row !== row;
    if (another) this.path = Path.ofRow(row);
    this.row = row;
    if (this.pinned !== pinned) this.pinnedPath = pinned === null ? null : Path.ofRow(pinned);
    this.pinned = pinned;
    this.profiles();
    this.tables(row);
    if (another) this.strip.load(this.path);
    if (another) this.stage.load(this.path);
    else this.mark(this.stage.time);
  }

  list(cell, chosen) {
    const rows = rowsOf(cell);
    const box = byId("cycles");
    const words = (row) => [
      orbits.has("group") && orbits.entry("group", row) !== null ? `group ${orbits.entry("group", row)}` : null,
      stabilityOf(row),
      `T = ${brief(orbits.numbers("period")[row] * kindFactor("time"), 6)}`,
      `|μ| = ${brief(radiusColumn[row])}`,
    ].filter(Boolean).join(", ");
    const options = rows.map((row, i) => html(
      "label", { class: stableColumn[row] === 1 ? "stable" : "unstable" },
      html("input", { type: "radio", name: "cycle", value: String(row), checked: row === chosen, onchange: () => this.onCycle(row) }),
      html("span", {}, `${i + 1}: ${words(row)}`),
    ));
    const legend = rows.length === 1 ? "one limit cycle" : `${rows.length} limit cycles`;
    box.hidden = !rows.length;
    box.replaceChildren(html("legend", {}, legend), ...options);
  }

  profiles() {
    const of = state.profiles === "phase" ? portraitsOf : chartsOf;
    const charts = of(this.path.samples(SAMPLES));
    const beside = this.pinnedPath ? of(this.pinnedPath.samples(SAMPLES)) : [];
    const before = this.charts ?? [];
    const kept = before.length === charts.length && charts.every((chart, i) => before[i].named === withUnit(chart.title, chart.unit));
    this.charts = charts.map((chart, i) => {
      const row = chart.measure && orbits.has(chart.measure) ? orbits.entry(chart.measure, this.row) : null;
      const bound = row === null ? null : row * kindFactor("length");
      return lineChart({ ...chart, bound, series: [...chart.series, ...(beside[i]?.series ?? [])] }, chart.series.length, kept ? before[i] : undefined);
    });
    if (!kept) byId("profiles").replaceChildren(...this.charts);
  }

  // Pressing on a profile goes to that time.
  scrub(event) {
    const chart = this.charts?.find((figure) => figure.contains(event.target));
    if (!chart || event.target.closest("button")) return;
    this.stage.play(false);
    this.stage.seek(chart.time(event) / kindFactor("time"));
  }

  // Arrow keys go through the step, in hundredths of it; with Shift in tenths.
  key(event) {
    if (!this.path || event.target.closest("button")) return;
    const { period } = this.path;
    const stride = (event.shiftKey ? 0.1 : 0.01) * period;
    const times = { ArrowLeft: this.stage.time - stride, ArrowRight: this.stage.time + stride, Home: 0, End: period };
    if (!(event.key in times)) return;
    event.preventDefault();
    this.stage.play(false);
    this.stage.seek(times[event.key]);
  }

  mark(t) {
    this.charts?.forEach((chart) => chart.mark(t * kindFactor("time")));
    if (!this.path) return;
    this.strip.mark(t);
    byId("profiles").setAttribute("aria-valuenow", String(Math.round((100 * t) / this.path.period)));
    byId("profiles").setAttribute("aria-valuetext", `t = ${brief(t * kindFactor("time"), 3)} of ${brief(this.path.period * kindFactor("time"), 3)}`);
  }

  // A measured value as it is shown: with all its decimals in the model's units, and with those that are certain in others.
  value({ name, unit }, row, decimals = 10) {
    const factor = factorOf(unit);
    const value = orbits.entry(name, row);
    if (typeof value !== "number" || orbits.source[name].whole) return entryText(name, row);
    return factor === 1 ? exact(value, decimals) : settled(value * factor, orbits.error(name, row) * factor, decimals);
  }

  // An entry of the section point, always with its decimals: small ones are zeros but for rounding.
  entry({ name, unit }, row) {
    const [value, factor] = [orbits.numbers(name)[row], factorOf(unit)];
    return factor === 1 ? signed(value.toFixed(12)) : settled(value * factor, orbits.error(name, row) * factor, 12);
  }

  // Rows of a table: the chosen cycle's value, the pinned one's where there is one, and the unit. Only the values are
  // written anew for another cycle.
  fill(box, lines, ...before) {
    const rows = this.pinned === null ? [this.row] : [this.row, this.pinned];
    const layout = [rows.length, ...lines.map(({ unit }) => unit)].join();
    if (box.layout !== layout) {
      box.layout = layout;
      box.lines = lines.map(({ label, meaning, name, unit }) => {
        const numbers = rows.map(() => html("td", { class: "number" }));
        return { numbers, line: html("tr", { title: meaning, "data-name": name }, html("th", { scope: "row" }, defined(label, meaning)), ...numbers, html("td", { class: "unit" }, unit)) };
      });
      box.replaceChildren(...before, ...box.lines.map(({ line }) => line));
    }
    lines.forEach(({ valueOf }, i) => rows.forEach((row, j) => { box.lines[i].numbers[j].textContent = valueOf(row); }));
  }

  tables(row) {
    const decimalsOf = ({ name }) => (name === "period" ? 12 : 10);
    this.fill(
      byId("measures"), report.measures.map((m) => ({ ...m, unit: unitText(m.unit, m.si), valueOf: (r) => this.value(m, r, decimalsOf(m)) })),
      ...(this.pinned === null ? [] : [this.heading()]),
    );
    this.fill(byId("state"), model.section.map((s) => ({ label: s.symbol, meaning: "", name: s.name, unit: unitText(s.unit, s.si), valueOf: (r) => this.entry(s, r) })));
    const pairs = multipliers(row);
    byId("circle").replaceChildren(unitCircle(pairs));
    const modulus = (r, i) => {
      const [re, im] = ["re", "im"].map((part) => `multiplier_${i}_${part}`);
      const value = Math.hypot(orbits.numbers(re)[r], orbits.numbers(im)[r]);
      return orbits.numbers(im)[r] === 0 ? exact(value) : settled(value, orbits.error(re, r) + orbits.error(im, r));
    };
    byId("multipliers").replaceChildren(...pairs.map((pair, i) => html(
      "tr", { "data-name": `multiplier_${i}` },
      html("td", { class: "number" }, complexText(pair)), html("td", { class: "number" }, modulus(row, i)),
    )));
    byId("check").textContent =
      `Integrated in this page in ${this.path.steps} Runge-Kutta steps: the step closes to ${brief(this.path.closing, 2)}; ` +
      `half as many steps change its end by ${brief(this.path.change, 2)}.`;
    byId("command").textContent = commandOf(row);
  }

  heading() {
    return html("tr", { class: "heading" }, html("th", { scope: "col" }, ""), html("th", { scope: "col", class: "number" }, "this cycle"), html("th", { scope: "col", class: "number" }, "pinned"), html("th", { scope: "col" }, ""));
  }
}

// Where a cell is, as the reader has the units.
const placeText = (cell) => grid.indices(cell).map((at, i) => `${axisQuantities[i].symbol} = ${axisQuantities[i].text(grid.axes[i].values[at])}`).join(", ");

// What finds the cycles of a row's cell on the command line; values are in the model's units, as one would type them.
function commandOf(row) {
  const settings = grid.point(cellColumn[row]).map((value, i) => `--set ${model.parameters[i].name}=${plain(value)}`);
  return `stridemap orbit --model ${model.name} ${settings.join(" ")}`;
}
