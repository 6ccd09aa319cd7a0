// A pen like that of a canvas, which writes SVG: so that one program draws a chart on the screen and as vectors.

const textOf = (value) => String(value).replace(/[&<>"]/g, (sign) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[sign]);
const local = (id) => `url${"("}#${id})`; // the name of something in the same drawing; the page itself names no address
const round2 = (value) => String(Math.round(value * 100) / 100);

class SvgPen {
  constructor(width, height) {
    Object.assign(this, {
      width, height, parts: [], path: [], stack: [], transform: "", dashes: [], clips: 0,
      fillStyle: "#000", strokeStyle: "#000", lineWidth: 1, font: "12px sans-serif", textAlign: "start", textBaseline: "alphabetic",
      lineJoin: "miter", lineCap: "butt", globalAlpha: 1,
    });
  }

  static STATE = ["fillStyle", "strokeStyle", "lineWidth", "font", "textAlign", "textBaseline", "lineJoin", "lineCap", "globalAlpha", "transform", "dashes"];

  save() { this.stack.push(Object.fromEntries(SvgPen.STATE.map((name) => [name, this[name]]))); }
  restore() { Object.assign(this, this.stack.pop() ?? {}); }
  translate(x, y) { this.transform += `translate(${round2(x)} ${round2(y)})`; }
  rotate(angle) { this.transform += `rotate(${round2((angle * 180) / Math.PI)})`; }
  setLineDash(dashes) { this.dashes = [...dashes]; }
  beginPath() { this.path = []; }
  moveTo(x, y) { this.path.push(`M${round2(x)} ${round2(y)}`); }
  lineTo(x, y) { this.path.push(`${this.path.length ? "L" : "M"}${round2(x)} ${round2(y)}`); }
  closePath() { this.path.push("Z"); }
  rect(x, y, width, height) { this.path.push(`M${round2(x)} ${round2(y)}h${round2(width)}v${round2(height)}h${round2(-width)}Z`); }

  arc(x, y, radius, from, to) {
    const point = (angle) => `${round2(x + radius * Math.cos(angle))} ${round2(y + radius * Math.sin(angle))}`;
    const middle = (from + to) / 2;
    const large = Math.abs(to - from) / 2 > Math.PI ? 1 : 0;
    this.path.push(`${this.path.length ? "L" : "M"}${point(from)}`, ...[middle, to].map((end) => `A${round2(radius)} ${round2(radius)} 0 ${large} ${to > from ? 1 : 0} ${point(end)}`));
  }

  common() {
    return `${this.transform ? ` transform="${this.transform}"` : ""}${this.globalAlpha < 1 ? ` opacity="${this.globalAlpha}"` : ""}`;
  }

  stroked() {
    const dash = this.dashes.length ? ` stroke-dasharray="${this.dashes.join(" ")}"` : "";
    return `fill="none" stroke="${textOf(this.strokeStyle)}" stroke-width="${this.lineWidth}" stroke-linejoin="${this.lineJoin}" stroke-linecap="${this.lineCap}"${dash}`;
  }

  fill() { this.parts.push(`<path d="${this.path.join("")}" fill="${textOf(this.fillStyle)}"${this.common()}/>`); }
  stroke() { this.parts.push(`<path d="${this.path.join("")}" ${this.stroked()}${this.common()}/>`); }
  box(x, y, width, height) { return `x="${round2(x)}" y="${round2(y)}" width="${round2(width)}" height="${round2(height)}"`; }
  fillRect(...box) { this.parts.push(`<rect ${this.box(...box)} fill="${textOf(this.fillStyle)}"${this.common()}/>`); }
  strokeRect(...box) { this.parts.push(`<rect ${this.box(...box)} ${this.stroked()}${this.common()}/>`); }

  written(text, x, y, look) {
    const anchor = { center: "middle", right: "end", end: "end" }[this.textAlign] ?? "start";
    const base = { middle: "central", top: "hanging" }[this.textBaseline] ?? "auto";
    this.parts.push(`<text x="${round2(x)}" y="${round2(y)}" text-anchor="${anchor}" dominant-baseline="${base}" style="font:${textOf(this.font)}" ${look}${this.common()}>${textOf(text)}</text>`);
  }

  fillText(text, x, y) { this.written(text, x, y, `fill="${textOf(this.fillStyle)}"`); }
  strokeText(text, x, y) { this.written(text, x, y, this.stroked()); }

  // What `draw` draws, only within boxes {x, y, width, height}.
  within(boxes, draw) {
    const id = `clip${this.clips++}`;
    this.parts.push(`<clipPath id="${id}"><path d="${boxes.map(({ x, y, width, height }) => `M${round2(x)} ${round2(y)}h${round2(width)}v${round2(height)}h${round2(-width)}Z`).join("")}"/></clipPath><g clip-path="${local(id)}">`);
    draw();
    this.parts.push("</g>");
  }

  text(ground) {
    return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${this.width} ${this.height}" width="${this.width}" height="${this.height}"><rect width="100%" height="100%" fill="${textOf(ground)}"/>${this.parts.join("")}</svg>`;
  }
}

// What `draw` draws, only within boxes, on a canvas or in SVG.
function within(pen, boxes, draw) {
  if (pen instanceof SvgPen) return pen.within(boxes, draw);
  const region = new Path2D();
  for (const { x, y, width, height } of boxes) region.rect(x, y, width, height);
  pen.save();
  pen.clip(region);
  draw();
  pen.restore();
}
