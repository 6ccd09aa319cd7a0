// On paper: charts as vectors in place of pixels, in the colours of a light page, and what was chosen as a sentence.

const PRINTED = [["map", () => map, () => byId("curves")], ["slice", () => slice], ["scatter", () => scatter], ["stage", () => stage], ["stage-pinned", () => pinnedStage]];

// What the controls say, which are not printed.
function chosenWords() {
  const said = [...document.querySelectorAll("#map-card .controls select")].flatMap((select) => {
    const label = select.closest("label");
    return label.hidden || label.closest("[hidden]") ? [] : [`${label.firstChild.textContent.trim()} ${select.selectedOptions[0]?.textContent ?? ""}`];
  });
  const filter = byId("filter").value.trim();
  return [...said, ...(filter ? [`filter ${filter}`] : [])].join("; ");
}

function beforePrint() {
  document.documentElement.dataset.print = "yes"; // the style sheet's light colours, before anything is drawn
  afterPrint.undo?.();
  const { inSight } = scatter; // out of sight it may not have been drawn yet
  scatter.inSight = true;
  refresh();
  scatter.inSight = inSight;
  const added = PRINTED.flatMap(([id, chart, over]) => {
    const canvas = byId(id);
    if (canvas.getBoundingClientRect().width === 0 || (id === "stage-pinned" && state.pin === null)) return [];
    const figure = html("div", { class: "printed", "data-of": id });
    figure.innerHTML = redrawn(chart(), over?.()).text;
    canvas.after(figure);
    return [figure];
  });
  const chosen = html("p", { class: "printed note" }, chosenWords());
  byId("map-card").querySelector("h2").after(chosen);
  afterPrint.undo = () => [...added, chosen].forEach((node) => node.remove());
}

function afterPrint() {
  delete document.documentElement.dataset.print;
  afterPrint.undo?.();
  afterPrint.undo = null;
  refresh();
}

addEventListener("beforeprint", beforePrint);
addEventListener("afterprint", afterPrint);

// A mark of a statement leads to the map, which may be out of sight.
byId("claims")?.addEventListener("click", (event) => {
  const link = event.target.closest("a[href*='=']");
  if (link) byId("explore").scrollIntoView();
});
