// The map: a cell of the grid is a rectangle; a click, or the arrow keys and Enter, choose one. Boundaries lie over it.

const INSET = { left: 58, right: 14, top: 26, bottom: 46 };

class GridMap {
  // `onChoose(cell)` is called when the reader chooses a cell, `onPoint(cell, spoken, event)` when one is pointed at,
  // and `onView(view)` when another part of the map is to be shown.
  constructor(canvas, curves, { onChoose, onPoint, onView }) {
    Object.assign(this, { canvas, curves, onPoint, onView, view: null });
    this.zoom = new ZoomPointer(canvas, (event) => this.place(event), () => this.view, onView);
    canvas.addEventListener("click", (event) => !this.zoom.dragged && onChoose(this.under(event)));
    canvas.addEventListener("pointermove", (event) => onPoint(this.under(event), false, event));
    canvas.addEventListener("pointerleave", () => onPoint(null));
    canvas.addEventListener("keydown", (event) => this.key(event, onChoose));
    canvas.addEventListener("focus", () => this.draw());
    canvas.addEventListener("blur", () => this.draw());
  }

  // What to show: `look(cell)` gives {fill, hatch, letter, cross, dim} of a cell; what was drawn is drawn again
  // only when `key` is another.
  show({ across, up, indices, look, caption, chosen, pinned, view, key }) {
    const cursor = this.cursor;
    Object.assign(this, { across, up, indices: [...indices], look, caption, chosen, pinned, view, shown: key });
    const [left, right, bottom, top] = view ?? WHOLE;
    this.scales = [across, up].map((i, k) => (i === null ? null : new CellScale(grid.axes[i]).zoom(...(k ? [bottom, top] : [left, right]))));
    this.curves.show(across, up, this.indices);
    const here = grid.indices(chosen);
    this.cursor = cursor && chosen === this.before ? cursor : [here[across], up === null ? 0 : here[up]];
    this.before = chosen;
    this.draw();
  }

  get rows() {
    return this.up === null ? 1 : grid.axes[this.up].values.length;
  }

  get columns() {
    return grid.axes[this.across].values.length;
  }

  cellAt(column, row) {
    const indices = [...this.indices];
    indices[this.across] = column;
    if (this.up !== null) indices[this.up] = row;
    return grid.cell(indices);
  }

  get size() {
    return sizeOf(this.canvas);
  }

  // The frame within the axes, in CSS pixels.
  frameOf({ width, height }) {
    const { left, right, top, bottom } = INSET;
    return { x: left, y: top, width: width - left - right, height: height - top - bottom };
  }

  // The rectangle of a cell in CSS pixels.
  box(column, row, frame = this.frameOf(this.size)) {
    const [x0, x1] = this.scales[0].span(column).map((u) => frame.x + u * frame.width);
    const [y0, y1] = (this.scales[1]?.span(row) ?? [0, 1]).map((u) => frame.y + (1 - u) * frame.height);
    return { x: x0, y: y1, width: x1 - x0, height: y0 - y1 };
  }

  // Where the pointer is, in parts of what is shown.
  place(event) {
    const { width, height, left, top } = this.canvas.getBoundingClientRect();
    const frame = this.frameOf({ width, height });
    return [(event.clientX - left - frame.x) / frame.width, 1 - (event.clientY - top - frame.y) / frame.height];
  }

  under(event) {
    const [x, y] = this.place(event);
    if (x < 0 || x > 1 || y < 0 || y > 1) return null;
    return this.cellAt(this.scales[0].index(x), this.scales[1]?.index(y) ?? 0);
  }

  key(event, onChoose) {
    const stride = event.shiftKey ? 10 : 1;
    const moves = { ArrowLeft: [-stride, 0], ArrowRight: [stride, 0], ArrowUp: [0, stride], ArrowDown: [0, -stride] };
    const jumps = { Home: [0, this.cursor[1]], End: [this.columns - 1, this.cursor[1]] };
    const zooms = { "+": 1.5, "=": 1.5, "-": 1 / 1.5, 0: 1e-9 };
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key in zooms) {
      event.preventDefault();
      this.onView(zoomed(this.view, this.cursorPlace(), zooms[event.key]));
      return;
    }
    if (event.key in moves) {
      const inside = (value, size) => Math.max(0, Math.min(value, size - 1));
      const [dx, dy] = moves[event.key];
      this.cursor = [inside(this.cursor[0] + dx, this.columns), inside(this.cursor[1] + dy, this.rows)];
    } else if (event.key in jumps) {
      this.cursor = jumps[event.key];
    } else if (event.key === "Enter" || event.key === " ") {
      onChoose(this.cellAt(...this.cursor));
    } else return;
    event.preventDefault();
    this.follow();
    this.draw();
    this.onPoint(this.cellAt(...this.cursor), true);
  }

  // The cell that the keys are at, in parts of what is shown.
  cursorPlace() {
    return [0, 1].map((k) => Math.max(0, Math.min(1, this.scales[k]?.position(this.cursor[k]) ?? 0.5)));
  }

  // Keep the cell that the keys are at in sight.
  follow() {
    if (!this.view) return;
    const [right, up] = [0, 1].map((k) => {
      const at = this.scales[k]?.position(this.cursor[k]) ?? 0.5;
      return at < 0 || at > 1 ? at - 0.5 : 0;
    });
    if (right || up) this.onView(moved(this.view, right, up));
  }

  draw() {
    if (!this.scales) return;
    const { pen, width, height } = prepared(this.canvas);
    this.ground(width, height);
    pen.drawImage(this.drawn, 0, 0, width, height);
    this.marks(pen, this.frameOf({ width, height }));
  }

  // The picture without its marks, drawn anew when what is shown, its size or its colours have changed.
  ground(width, height) {
    const ratio = window.devicePixelRatio || 1;
    const key = [this.shown, width, height, ratio, styled("paper")].join("\u0000");
    if (this.drawnKey === key) return;
    this.drawnKey = key;
    this.drawn ??= document.createElement("canvas");
    [this.drawn.width, this.drawn.height] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
    const pen = this.drawn.getContext("2d");
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.render(pen, width, height);
    const { x, y, width: w, height: h } = this.frameOf({ width, height });
    if (w > 0 && h > 0) this.curves.draw(this.scales, { left: x, top: y, width: w, height: h }, this.lettered);
  }

  render(pen, width, height) {
    const frame = this.frameOf({ width, height });
    this.looks = Array.from({ length: this.rows }, (_, r) => Array.from({ length: this.columns }, (_, c) => this.look(this.cellAt(c, r))));
    pen.fillStyle = styled("map-none");
    pen.fillRect(frame.x, frame.y, frame.width, frame.height);
    within(pen, [frame], () => this.cells(pen, frame));
    this.letters(pen, frame);
    this.frame(pen, width, height);
  }

  // Neighbours in a row that look alike are one rectangle.
  cells(pen, frame) {
    const [columns, rows] = this.scales.map((scale) => (scale ? [scale.index(0), scale.index(1)] : [0, 0]));
    const hatched = [];
    for (let r = rows[0]; r <= rows[1]; r++) {
      const line = this.looks[r];
      const alike = (one, other) => one.fill === other.fill && Boolean(one.hatch) === Boolean(other.hatch) && Boolean(one.dim) === Boolean(other.dim) && !one.cross && !other.cross;
      for (let c = columns[0]; c <= columns[1]; c++) {
        const { fill, hatch, cross, dim } = line[c];
        const box = this.box(c, r, frame);
        while (c < columns[1] && alike(line[c], line[c + 1])) c++;
        const end = this.box(c, r, frame);
        box.width = end.x + end.width - box.x;
        pen.globalAlpha = dim ? 0.18 : 1;
        // Neighbours overlap by a hair, or their edges would show as a grid of thin lines.
        if (fill) fillBox(pen, box, fill, dim ? 0 : 0.4);
        if (hatch && !dim) hatched.push(box);
        if (cross) strokeCross(pen, box);
      }
    }
    pen.globalAlpha = 1;
    if (hatched.length) hatchOver(pen, hatched, frame);
  }

  // One letter for each connected patch of cells of a group that is large enough to hold it, and borders between groups.
  letters(pen, frame) {
    const letters = this.looks.map((row) => row.map(({ letter }) => letter ?? null));
    this.lettered = [];
    if (!letters.some((row) => row.some(Boolean))) return;
    within(pen, [frame], () => this.borders(pen, frame, bordersOf(letters)));
    pen.font = `600 13px ${styled("font")}`;
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.lineWidth = 3.5;
    pen.lineJoin = "round";
    pen.strokeStyle = styled("map-halo");
    pen.fillStyle = styled("map-letter");
    const inFrame = ({ x, y, width, height }) => x + width > frame.x && x < frame.x + frame.width && y + height > frame.y && y < frame.y + frame.height;
    const depths = depthsOf(letters);
    for (const [letter, whole] of patchesOf(letters)) {
      const patch = whole.filter(([c, r]) => inFrame(this.box(c, r, frame)));
      const area = patch.reduce((sum, [c, r]) => { const { width, height } = this.box(c, r, frame); return sum + width * height; }, 0);
      if (area < 450) continue;
      const box = this.box(...deepest(patch, depths), frame);
      const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      if (x < frame.x + 6 || x > frame.x + frame.width - 6 || y < frame.y + 6 || y > frame.y + frame.height - 6) continue;
      pen.strokeText(letter, x, y);
      pen.fillText(letter, x, y);
      this.lettered.push([letter, x, y]);
    }
  }

  borders(pen, frame, edges) {
    const [right, top] = [edges.filter(([, , side]) => side === "right"), edges.filter(([, , side]) => side === "top")];
    for (const [colour, thick] of [[styled("map-halo"), 2.6], [styled("map-letter"), 1.1]]) {
      pen.fillStyle = colour;
      for (const [c, r] of right) {
        const { x, y, width, height } = this.box(c, r, frame);
        pen.fillRect(x + width - thick / 2, y - thick / 2, thick, height + thick);
      }
      for (const [c, r] of top) {
        const { x, y, width } = this.box(c, r, frame);
        pen.fillRect(x - thick / 2, y - thick / 2, width + thick, thick);
      }
    }
  }

  frame(pen, width, height) {
    const [right, bottom] = [width - INSET.right, height - INSET.bottom];
    const factor = (i) => axisQuantities[i].factor;
    pen.strokeStyle = styled("line");
    pen.fillStyle = styled("ink-soft");
    pen.lineWidth = 1;
    pen.strokeRect(INSET.left - 0.5, INSET.top - 0.5, right - INSET.left + 1, bottom - INSET.top + 1);
    pen.font = `12px ${styled("font")}`;
    ticksBelow(pen, this.scales[0].ticks(width < 500 ? 5 : 8, factor(this.across)), INSET.left, right, bottom);
    if (this.up !== null) ticksBeside(pen, this.scales[1].ticks(8, factor(this.up)), INSET.left, INSET.top, bottom);
    pen.textAlign = "right";
    pen.textBaseline = "alphabetic";
    pen.fillText(this.caption, right, INSET.top - 8);
    nameBelow(pen, axisQuantities[this.across].title, INSET.left, right, bottom);
    if (this.up !== null) nameBeside(pen, axisQuantities[this.up].title, INSET.top, bottom);
  }

  // A ring around the chosen cell, and a dashed one around the cell that the keys are at.
  marks(pen, frame) {
    const ring = ({ x, y, width, height }, gap, dash) => {
      for (const [colour, thick] of [[styled("paper"), 4], [styled("ink"), 2]]) {
        pen.strokeStyle = colour;
        pen.lineWidth = thick;
        pen.setLineDash(colour === styled("ink") ? dash : []);
        pen.strokeRect(x - gap, y - gap, width + 2 * gap, height + 2 * gap);
      }
      pen.setLineDash([]);
    };
    const boxOf = (cell) => {
      const at = grid.indices(cell);
      return this.box(at[this.across], this.up === null ? 0 : at[this.up], frame);
    };
    const inPlane = (cell) => grid.indices(cell).every((at, i) => i === this.across || i === this.up || at === this.indices[i]);
    within(pen, [{ x: frame.x - 8, y: frame.y - 8, width: frame.width + 16, height: frame.height + 16 }], () => {
      if (this.pinned !== null && inPlane(this.pinned)) ring(boxOf(this.pinned), 2, [2, 2]);
      ring(boxOf(this.chosen), 2, []);
      if (document.activeElement === this.canvas) ring(this.box(...this.cursor, frame), 5, [3, 3]);
    });
  }
}
