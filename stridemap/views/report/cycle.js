// One cell's limit cycles: the list to choose from, and everything about the one that is chosen.

const byId = (id) => document.getElementById(id);

class CycleView {
  // `onCycle(row)` is called when the reader chooses another cycle of the cell.
  constructor(stage, onCycle) {
    this.stage = stage;
    this.onCycle = onCycle;
    byId("profiles").addEventListener("pointerdown", (event) => this.scrub(event));
    byId("profiles").addEventListener("pointermove", (event) => event.buttons && this.scrub(event));
  }

  show(cell, row) {
    byId("cell-name").textContent = grid.axes.map((axis, i) => `${axis.symbol} = ${brief(axis.values[grid.indices(cell)[i]], 6)}`).join(", ");
    this.list(cell, row);
    const found = row !== null;
    byId("cycle").hidden = byId("numbers").hidden = byId("profiles-card").hidden = !found;
    byId("empty").hidden = found;
    if (!found) {
      const status = cells.entry("status", cell);
      const reason = cells.entry("reason", cell) ?? "no cycle passes the choice above";
      byId("empty").textContent = `${status === "failed" ? "This cell failed" : "No limit cycle here"}: ${reason}.`;
      this.stage.play(false);
      return;
    }
    this.row = row;
    this.path = Path.ofRow(row);
    this.profiles(row);
    this.tables(row);
    this.stage.load(this.path);
  }

  list(cell, chosen) {
    const rows = rowsOf(cell);
    const box = byId("cycles");
    const words = (row) => [
      orbits.has("group") && orbits.entry("group", row) !== null ? `group ${orbits.entry("group", row)}` : null,
      stabilityOf(row),
      `T = ${brief(orbits.numbers("period")[row], 6)}`,
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

  profiles(row) {
    const samples = this.path.samples(SAMPLES);
    const times = samples.map((s) => s.t);
    this.charts = chartsOf(samples).map((chart) => lineChart(chart, times, row));
    byId("profiles").replaceChildren(...this.charts);
  }

  // Pressing on a profile goes to that time.
  scrub(event) {
    const chart = this.charts?.find((figure) => figure.contains(event.target));
    if (!chart) return;
    this.stage.play(false);
    this.stage.seek(chart.time(event));
  }

  mark(t) {
    this.charts?.forEach((chart) => chart.mark(t));
  }

  tables(row) {
    const line = (label, value, { unit = "", title = "", name = "" }) => html(
      "tr", { title, "data-name": name },
      html("th", { scope: "row" }, label), html("td", { class: "number" }, value), html("td", { class: "unit" }, unit),
    );
    byId("measures").replaceChildren(
      ...report.measures.map((m) => line(m.label, entryText(m.name, row), { unit: m.unit, title: m.meaning, name: m.name })),
    );
    byId("measures").querySelector('[data-name="period"] .number').textContent = exact(orbits.numbers("period")[row], 12);
    byId("state").replaceChildren(
      ...model.section.map((s) => line(s.symbol, signed(orbits.numbers(s.name)[row].toFixed(12)), { title: s.name, name: s.name })),
    );
    const pairs = multipliers(row);
    byId("circle").replaceChildren(unitCircle(pairs));
    byId("multipliers").replaceChildren(...pairs.map((pair, i) => html(
      "tr", { "data-name": `multiplier_${i}` },
      html("td", { class: "number" }, complexText(pair)), html("td", { class: "number" }, exact(Math.hypot(...pair))),
    )));
    byId("check").textContent =
      `Integrated in this page in ${this.path.steps} Runge-Kutta steps: the step closes to ${brief(this.path.closing, 2)}; ` +
      `half as many steps change its end by ${brief(this.path.change, 2)}.`;
    const settings = grid.point(orbits.numbers("cell")[row]).map((value, i) => `--set ${model.parameters[i].name}=${value}`);
    byId("command").textContent = `stridemap orbit --model ${model.name} ${settings.join(" ")}`;
  }
}
