// The scatter: two quantities of the cycles that are shown, coloured by a third. A rectangle drawn over it picks out
// the cycles within, on the map too.

const SCATTER = { left: 62, right: 14, top: 12, bottom: 46 };

class Scatter {
  // `onChoose(row)` is called when the reader presses a point, `onBrush(box)` when a rectangle [x0, x1, y0, y1] is
  // drawn over it, or null when it is taken away, and `onPoint(row, event)` when a point is pointed at.
  constructor(canvas, { onChoose, onBrush, onPoint }) {
    Object.assign(this, { canvas, onChoose, onBrush, inSight: typeof IntersectionObserver === "undefined" });
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => {
      if (this.from) this.drag(event);
      else onPoint(this.near(event), event);
    });
    canvas.addEventListener("pointerup", (event) => this.lift(event));
    canvas.addEventListener("pointercancel", () => { this.from = this.to = null; });
    canvas.addEventListener("pointerleave", () => onPoint(null));
  }

  show({ x, y, z, rows, colour, chosen, pinned, brush, within: inside, key }) {
    Object.assign(this, { x, y, z, rows, colour, chosen, pinned, brush, inside, shown: key });
    const scale = (quantity) => {
      const values = quantity.numbers();
      return new ValueScale(rows.map((row) => values[row]), { axis: !quantity.whole, whole: quantity.whole, factor: quantity.factor, most: MOST[quantity.name] });
    };
    this.scales = kept.get("scatter", key, () => [scale(x), scale(y)]);
    this.draw();
  }

  frame({ width, height } = sizeOf(this.canvas)) {
    return { x: SCATTER.left, y: SCATTER.top, width: width - SCATTER.left - SCATTER.right, height: height - SCATTER.top - SCATTER.bottom };
  }

  // Pixels of a row; beyond the scales it lies at their edge.
  locate(row, frame) {
    const clip = (unit) => Math.max(-0.012, Math.min(1.012, unit));
    const [u, v] = [this.scales[0].unit(this.x.numbers()[row]), this.scales[1].unit(this.y.numbers()[row])];
    return [frame.x + clip(u) * frame.width, frame.y + (1 - clip(v)) * frame.height];
  }

  near(event) {
    if (!this.rows) return null;
    const box = this.canvas.getBoundingClientRect();
    const frame = this.frame(box);
    let [best, least] = [null, 12];
    for (const row of this.rows) {
      const [x, y] = this.locate(row, frame);
      const away = Math.hypot(event.clientX - box.left - x, event.clientY - box.top - y);
      if (away < least) [best, least] = [row, away];
    }
    return best;
  }

  point(event) {
    const { left, top } = this.canvas.getBoundingClientRect();
    const { x, y, width, height } = this.frame();
    return [Math.max(x, Math.min(x + width, event.clientX - left)), Math.max(y, Math.min(y + height, event.clientY - top))];
  }

  press(event) {
    if (!this.rows || event.button) return;
    this.from = this.to = this.point(event);
    this.canvas.setPointerCapture?.(event.pointerId);
  }

  drag(event) {
    this.to = this.point(event);
    this.draw();
  }

  lift(event) {
    if (!this.from) return;
    const [from, to] = [this.from, this.point(event)];
    this.from = this.to = null;
    if (Math.hypot(from[0] - to[0], from[1] - to[1]) < 5) {
      const row = this.near(event);
      if (row !== null) this.onChoose(row);
      else this.onBrush(null);
      return;
    }
    const frame = this.frame();
    const [left, right] = [from[0], to[0]].sort((a, b) => a - b).map((x) => (x - frame.x) / frame.width);
    const [low, high] = [from[1], to[1]].sort((a, b) => b - a).map((y) => 1 - (y - frame.y) / frame.height);
    // A rectangle that reaches an edge holds what lies beyond it as well.
    const end = (scale, unit, edge) => (Math.abs(unit - (edge > 0 ? 1 : 0)) < 1e-3 ? edge * Infinity : scale.valueAt(unit));
    this.onBrush([end(this.scales[0], left, -1), end(this.scales[0], right, 1), end(this.scales[1], low, -1), end(this.scales[1], high, 1)]);
  }

  draw() {
    if (!this.rows) return;
    const { pen, width, height } = prepared(this.canvas);
    const ratio = window.devicePixelRatio || 1;
    const key = [this.shown, width, height, ratio, styled("paper")].join("\u0000");
    if (this.drawnKey !== key) {
      this.drawnKey = key;
      this.drawn ??= document.createElement("canvas");
      [this.drawn.width, this.drawn.height] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
      const ground = this.drawn.getContext("2d");
      ground.setTransform(ratio, 0, 0, ratio, 0, 0);
      this.ground(ground, width, height);
    }
    pen.drawImage(this.drawn, 0, 0, width, height);
    this.marks(pen, this.frame({ width, height }));
  }

  render(pen, width, height) {
    this.ground(pen, width, height);
    this.marks(pen, this.frame({ width, height }));
  }

  ground(pen, width, height) {
    const { x, y, width: w, height: h } = this.frame({ width, height });
    pen.font = `12px ${styled("font")}`;
    pen.strokeStyle = styled("line");
    pen.lineWidth = 1;
    pen.strokeRect(x - 0.5, y - 0.5, w + 1, h + 1);
    pen.fillStyle = styled("ink-soft");
    const places = (scale, count) => scale.ticks(count).map(([value, text]) => [scale.unit(value), text]);
    ticksBelow(pen, places(this.scales[0], w < 450 ? 4 : 7), x, x + w, y + h);
    ticksBeside(pen, places(this.scales[1], 6), x, y, y + h);
    nameBelow(pen, this.x.title, x, x + w, y + h);
    nameBeside(pen, this.y.title, y, y + h);
    const size = this.rows.length > 5000 ? 2 : this.rows.length > 500 ? 3 : 5;
    const frame = { x, y, width: w, height: h };
    const [xs, ys] = [this.x.numbers(), this.y.numbers()];
    for (const inside of this.inside ? [false, true] : [true]) {
      pen.globalAlpha = inside ? 1 : 0.12;
      for (const row of this.rows) {
        if (Number.isNaN(xs[row]) || Number.isNaN(ys[row]) || (this.inside && Boolean(this.inside[row]) !== inside)) continue;
        const [px, py] = this.locate(row, frame);
        pen.fillStyle = this.colour(row);
        pen.fillRect(px - size / 2, py - size / 2, size, size);
      }
    }
    pen.globalAlpha = 1;
  }

  marks(pen, frame) {
    for (const [row, dash] of [[this.pinned, [2, 2]], [this.chosen, []]]) {
      if (row === null || Number.isNaN(this.x.numbers()[row]) || Number.isNaN(this.y.numbers()[row])) continue;
      const [x, y] = this.locate(row, frame);
      for (const [colour, thick] of [[styled("paper"), 4], [styled("ink"), 2]]) {
        pen.strokeStyle = colour;
        pen.lineWidth = thick;
        pen.setLineDash(thick === 2 ? dash : []);
        pen.beginPath();
        pen.arc(x, y, 7, 0, 2 * Math.PI);
        pen.stroke();
      }
      pen.setLineDash([]);
    }
    const box = this.from ? [this.from, this.to] : this.brush ? this.brushBox(frame) : null;
    if (!box) return;
    const [[x0, y0], [x1, y1]] = box;
    pen.strokeStyle = styled("accent");
    pen.lineWidth = 1.5;
    pen.strokeRect(Math.min(x0, x1), Math.min(y0, y1), Math.abs(x1 - x0), Math.abs(y1 - y0));
  }

  brushBox(frame) {
    const place = (scale, value, low) => (Number.isFinite(value) ? Math.max(0, Math.min(1, scale.unit(value))) : low ? 0 : 1);
    const [x0, x1, y0, y1] = this.brush;
    return [
      [frame.x + place(this.scales[0], x0, true) * frame.width, frame.y + (1 - place(this.scales[1], y0, true)) * frame.height],
      [frame.x + place(this.scales[0], x1, false) * frame.width, frame.y + (1 - place(this.scales[1], y1, false)) * frame.height],
    ];
  }
}
