// The start, from the address or from the paper's own point, and each time that the address changes.

function start() {
  const missing = notOnGrid(location.hash);
  const [cell, row] = takeAddress(location.hash);
  state.indices = grid.indices(cell);
  const filter = state.filter;
  state.filter = "";
  const understood = setFilter(filter);
  buildControls();
  if (!understood) byId("filter").value = filter;
  buildAxes();
  buildSliders();
  showUnits();
  choose(cell, row, "replace");
  return missing;
}

// Say which values the address asks for in vain.
function sayMissing(missing) {
  if (missing.length) byId("readout").textContent = `The grid has no ${missing.join(" and no ")}; its nearest cell is shown. ${readText(state.cell)}`;
}

buildUnits();
showSpeeds();
buildFilter();
buildPin();
buildBrush();
buildButtons();
const missing = start();
buildPlayer();
buildCurves();
sayMissing(missing);

// Links within the page have addresses too, which say nothing of the choice.
addEventListener("popstate", () => {
  if (!location.hash || location.hash.includes("=")) {
    const unknown = start();
    refresh();
    sayMissing(unknown);
  }
});

// The scatter is drawn while it is in sight.
if (typeof IntersectionObserver !== "undefined") {
  new IntersectionObserver(([entry]) => {
    scatter.inSight = entry.isIntersecting;
    if (scatter.inSight) showScatter();
  }, { rootMargin: "100px" }).observe(byId("scatter-card"));
}

// Canvases are drawn anew when their size or the colours change.
for (const [id, drawn] of [["map", map], ["slice", slice], ["scatter", scatter], ["stage", stage], ["stage-pinned", pinnedStage]]) {
  new ResizeObserver(() => {
    sizes.delete(byId(id));
    drawn.draw();
  }).observe(byId(id));
}
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  looks = null;
  map.drawnKey = scatter.drawnKey = null;
  redraw();
  stage.draw();
});

// For scripts and for tests: the tables, the equations, and the page itself.
window.stridemap = {
  report, orbits, cells, grid, equations, evaluate, Path, map, slice, scatter, curves, joinedBy, stage, pinnedStage, state, choose, quantities,
  compileFilter, bar, redrawn, scaleOf: (values, choice) => new ValueScale(values, choice), patches: { patchesOf, depthsOf, deepest, bordersOf },
};
document.documentElement.dataset.ready = "yes";
