// What the reader takes along: tables as CSV and JSON, charts as SVG and PNG, and lines of text through the clipboard.

function download(name, content, type) {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  const link = html("a", { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

// A name of a file from what it shows.
const fileName = (title) => `${model.name}-${title}`.replace(/[^A-Za-z0-9]+/g, "-").replace(/^-|-$/g, "").slice(0, 80).toLowerCase();

const LOOKS = ["fill", "stroke", "stroke-width", "stroke-dasharray", "stroke-linejoin", "font", "text-anchor", "dominant-baseline", "opacity", "paint-order"];

// A drawing of the page as a file of its own, with the looks that the style sheet gives it.
function standalone(root) {
  const copy = root.cloneNode(true);
  const [originals, copies] = [root, copy].map((node) => [node, ...node.querySelectorAll("*")]);
  originals.forEach((node, i) => {
    const style = getComputedStyle(node);
    copies[i].setAttribute("style", LOOKS.map((look) => `${look}:${style.getPropertyValue(look)}`).join(";"));
    copies[i].removeAttribute("class");
  });
  const [, , width, height] = root.getAttribute("viewBox").split(" ").map(Number);
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", width);
  copy.setAttribute("height", height);
  copy.prepend(svg("rect", { width: "100%", height: "100%", fill: styled("card") }));
  return { text: new XMLSerializer().serializeToString(copy), width, height };
}

// A chart on a canvas drawn once more, as SVG; `over` is SVG that lies over it.
function redrawn(chart, over = null) {
  const { width, height } = chart.canvas.getBoundingClientRect();
  const pen = new SvgPen(width, height);
  chart.render(pen, width, height);
  if (over?.childElementCount) {
    const { text } = standalone(over);
    const frame = chart.frameOf({ width, height });
    pen.parts.push(text.replace("<svg", `<svg x="${frame.x}" y="${frame.y}"`).replace(/<rect[^>]*width="100%"[^>]*\/>/, ""));
  }
  return { text: pen.text(styled("card")), width, height };
}

// SVG as pixels, three for each of its own.
async function pixelsOf({ text, width, height }) {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  await image.decode();
  const canvas = html("canvas");
  [canvas.width, canvas.height] = [3 * width, 3 * height];
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((done) => canvas.toBlob(done, "image/png"));
}

const pictureOf = (source) => (source instanceof Element ? standalone(source) : source);

// Buttons that save a chart: `source()` gives the drawing, as an element or {text, width, height}.
function saveButtons(source, title) {
  const button = (kind, act) => html("button", { type: "button", class: "small", "data-save": kind, title: `save this chart as ${kind}`, "aria-label": `save the chart “${title}” as ${kind}`, onclick: act }, kind);
  return html(
    "span", { class: "save" },
    button("SVG", () => download(`${fileName(title)}.svg`, pictureOf(source()).text, "image/svg+xml")),
    button("PNG", async () => download(`${fileName(title)}.png`, await pixelsOf(pictureOf(source())))),
  );
}

async function copyText(text, button) {
  let copied = true;
  try {
    await navigator.clipboard.writeText(text);
  } catch { // without the permission, or in an older browser
    const area = html("textarea", { class: "unseen" }, text);
    document.body.append(area);
    area.select();
    copied = document.execCommand("copy");
    area.remove();
  }
  const before = button.dataset.text ?? (button.dataset.text = button.textContent);
  button.textContent = copied ? "copied" : "not allowed here";
  setTimeout(() => { button.textContent = before; }, 1500);
}

// The parameters of the grid, the number of the cycle in its cell, and all columns.
function selectionColumns() {
  return [...grid.axes.map(({ name }) => name), "cycle", ...Object.keys(orbits.source).filter((name) => name !== "cell")];
}

// Rows as lists of plain values, in the model's units.
function selectionRows(rows) {
  const columns = Object.keys(orbits.source).filter((name) => name !== "cell");
  return rows.map((row) => {
    const cell = cellColumn[row];
    const point = grid.indices(cell).map((at, i) => Number(plain(grid.axes[i].values[at])));
    return [...point, row - first[cell] + 1, ...columns.map((name) => orbits.entry(name, row))];
  });
}

function selectionCsv(rows) {
  const field = (value) => (value === null ? "" : typeof value === "string" && /[",\n\r]/.test(value) ? `"${value.replaceAll('"', '""')}"` : String(value));
  return `${[selectionColumns(), ...selectionRows(rows)].map((line) => line.map(field).join(",")).join("\n")}\n`;
}

function selectionJson(rows) {
  const names = selectionColumns();
  const finite = (value) => (typeof value === "number" && !Number.isFinite(value) ? String(value) : value);
  const cycles = selectionRows(rows).map((line) => Object.fromEntries(line.map((value, i) => [names[i], finite(value)])));
  const chosen = { cycles: state.choice, group: state.group || null, filter: state.filter || null };
  return JSON.stringify({ model: model.name, fixed: report.fixed, units: model.units, chosen, cycles }, null, 1);
}
