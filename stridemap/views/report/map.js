// The map: a cell of the grid is a rectangle; a click, or the arrow keys and Enter, choose one. Boundaries lie over it.

const INSET = { left: 58, right: 14, top: 12, bottom: 46 };

class GridMap {
  // `onChoose(cell)` is called when the reader chooses a cell, `onPoint(cell)` when one is pointed at.
  constructor(canvas, curves, onChoose, onPoint) {
    this.canvas = canvas;
    this.curves = curves;
    this.onPoint = onPoint;
    canvas.addEventListener("click", (event) => onChoose(this.under(event)));
    canvas.addEventListener("pointermove", (event) => onPoint(this.under(event)));
    canvas.addEventListener("pointerleave", () => onPoint(null));
    canvas.addEventListener("keydown", (event) => this.key(event, onChoose));
    canvas.addEventListener("focus", () => this.draw());
    canvas.addEventListener("blur", () => this.draw());
  }

  // What to show: `look(cell)` gives {fill, hatch, letter, cross} of a cell.
  show({ across, up, indices, look, chosen }) {
    const cursor = this.cursor;
    Object.assign(this, { across, up, indices: [...indices], look, chosen });
    this.scales = [across, up].map((i) => (i === null ? null : new CellScale(grid.axes[i])));
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

  // The rectangle of a cell in CSS pixels.
  box(column, row) {
    const { width, height } = this.canvas.getBoundingClientRect();
    const [w, h] = [width - INSET.left - INSET.right, height - INSET.top - INSET.bottom];
    const [x0, x1] = this.scales[0].span(column).map((u) => INSET.left + u * w);
    const [y0, y1] = (this.scales[1]?.span(row) ?? [0, 1]).map((u) => INSET.top + (1 - u) * h);
    return { x: x0, y: y1, width: x1 - x0, height: y0 - y1 };
  }

  under(event) {
    const { width, height, left, top } = this.canvas.getBoundingClientRect();
    const x = (event.clientX - left - INSET.left) / (width - INSET.left - INSET.right);
    const y = 1 - (event.clientY - top - INSET.top) / (height - INSET.top - INSET.bottom);
    if (x < 0 || x > 1 || y < 0 || y > 1) return null;
    return this.cellAt(this.scales[0].index(x), this.scales[1]?.index(y) ?? 0);
  }

  key(event, onChoose) {
    const stride = event.shiftKey ? 10 : 1;
    const moves = { ArrowLeft: [-stride, 0], ArrowRight: [stride, 0], ArrowUp: [0, stride], ArrowDown: [0, -stride] };
    const jumps = { Home: [0, this.cursor[1]], End: [this.columns - 1, this.cursor[1]] };
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
    this.draw();
    this.onPoint(this.cellAt(...this.cursor), true);
  }

  draw() {
    const { pen, width, height } = prepared(this.canvas);
    const [columns, rows] = [this.columns, this.rows];
    this.looks = Array.from({ length: rows }, (_, r) => Array.from({ length: columns }, (_, c) => this.look(this.cellAt(c, r))));
    pen.fillStyle = styled("map-none");
    pen.fillRect(INSET.left, INSET.top, width - INSET.left - INSET.right, height - INSET.top - INSET.bottom);
    const hatched = new Path2D();
    for (let r = 0; r < rows; r++) {
      for (let c = 0; c < columns; c++) {
        const { fill, hatch, cross } = this.looks[r][c];
        const box = this.box(c, r);
        // Neighbours overlap by a hair, or their edges would show as a grid of thin lines.
        if (fill) fillBox(pen, box, fill, 0.4);
        if (hatch) hatched.rect(box.x, box.y, box.width, box.height);
        if (cross) strokeCross(pen, box);
      }
    }
    hatchOver(pen, hatched, width, height);
    this.letters(pen);
    this.frame(pen, width, height);
    this.marks(pen);
    const { left, right, top, bottom } = INSET;
    this.curves.draw(this.scales, { left, top, width: width - left - right, height: height - top - bottom }, this.lettered);
  }

  // One letter for each connected patch of cells of a group that is large enough to hold it.
  letters(pen) {
    this.lettered = [];
    const seen = this.looks.map((row) => row.map(() => false));
    pen.font = `600 13px ${styled("font")}`;
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    for (let r = 0; r < this.rows; r++) {
      for (let c = 0; c < this.columns; c++) {
        const { letter } = this.looks[r][c];
        if (!letter || seen[r][c]) continue;
        const boxes = this.patch(c, r, letter, seen).map(([x, y]) => this.box(x, y));
        const area = boxes.reduce((sum, box) => sum + box.width * box.height, 0);
        if (area < 450) continue;
        const mean = (f) => boxes.reduce((sum, box) => sum + f(box), 0) / boxes.length;
        const centre = (box) => [box.x + box.width / 2, box.y + box.height / 2];
        const middle = [mean((b) => centre(b)[0]), mean((b) => centre(b)[1])];
        const away = (box) => Math.hypot(centre(box)[0] - middle[0], centre(box)[1] - middle[1]);
        const [x, y] = centre(boxes.reduce((best, box) => (away(box) < away(best) ? box : best)));
        pen.lineWidth = 3.5;
        pen.lineJoin = "round";
        pen.strokeStyle = styled("map-halo");
        pen.fillStyle = styled("map-letter");
        pen.strokeText(letter, x, y);
        pen.fillText(letter, x, y);
        this.lettered.push([letter, x, y]);
      }
    }
  }

  // The cells around one that bear its letter.
  patch(column, row, letter, seen) {
    const found = [];
    const open = [[column, row]];
    while (open.length) {
      const [c, r] = open.pop();
      if (this.looks[r]?.[c]?.letter !== letter || seen[r][c]) continue;
      seen[r][c] = true;
      found.push([c, r]);
      open.push([c + 1, r], [c - 1, r], [c, r + 1], [c, r - 1]);
    }
    return found;
  }

  frame(pen, width, height) {
    const [right, bottom] = [width - INSET.right, height - INSET.bottom];
    pen.strokeStyle = styled("line");
    pen.fillStyle = styled("ink-soft");
    pen.lineWidth = 1;
    pen.strokeRect(INSET.left - 0.5, INSET.top - 0.5, right - INSET.left + 1, bottom - INSET.top + 1);
    pen.font = `12px ${styled("font")}`;
    pen.textAlign = "center";
    pen.textBaseline = "top";
    for (const [unit, text] of this.scales[0].ticks(width < 500 ? 5 : 8)) {
      const x = INSET.left + unit * (right - INSET.left);
      segment(pen, x, bottom, x, bottom + 5);
      pen.fillText(text, x, bottom + 8);
    }
    pen.textAlign = "right";
    pen.textBaseline = "middle";
    for (const [unit, text] of this.scales[1]?.ticks(8) ?? []) {
      const y = bottom - unit * (bottom - INSET.top);
      segment(pen, INSET.left - 5, y, INSET.left, y);
      pen.fillText(text, INSET.left - 8, y);
    }
    this.names(pen, right, bottom);
  }

  names(pen, right, bottom) {
    const name = (i) => withUnit(grid.axes[i].symbol, grid.axes[i].unit);
    pen.fillStyle = styled("ink");
    pen.font = `13px ${styled("font")}`;
    pen.textAlign = "center";
    pen.textBaseline = "alphabetic";
    pen.fillText(name(this.across), (INSET.left + right) / 2, bottom + 38);
    if (this.up === null) return;
    pen.save();
    pen.translate(15, (INSET.top + bottom) / 2);
    pen.rotate(-Math.PI / 2);
    pen.fillText(name(this.up), 0, 0);
    pen.restore();
  }

  // A ring around the chosen cell, and a dashed one around the cell that the keys are at.
  marks(pen) {
    const ring = ({ x, y, width, height }, gap, dash) => {
      for (const [colour, thick] of [[styled("paper"), 4], [styled("ink"), 2]]) {
        pen.strokeStyle = colour;
        pen.lineWidth = thick;
        pen.setLineDash(colour === styled("ink") ? dash : []);
        pen.strokeRect(x - gap, y - gap, width + 2 * gap, height + 2 * gap);
      }
      pen.setLineDash([]);
    };
    const here = grid.indices(this.chosen);
    ring(this.box(here[this.across], this.up === null ? 0 : here[this.up]), 2, []);
    if (document.activeElement === this.canvas) ring(this.box(...this.cursor), 5, [3, 3]);
  }
}

function segment(pen, x0, y0, x1, y1) {
  pen.beginPath();
  pen.moveTo(x0, y0);
  pen.lineTo(x1, y1);
  pen.stroke();
}

function fillBox(pen, { x, y, width, height }, colour, more) {
  pen.fillStyle = colour;
  pen.fillRect(x - more, y - more, width + 2 * more, height + 2 * more);
}

function strokeCross(pen, { x, y, width, height }) {
  pen.strokeStyle = styled("ink-soft");
  pen.lineWidth = 1;
  segment(pen, x, y, x + width, y + height);
  segment(pen, x, y + height, x + width, y);
}

// Diagonal lines over a region: what is unstable can be seen without colour.
function hatchOver(pen, region, width, height) {
  pen.save();
  pen.clip(region);
  pen.strokeStyle = styled("map-hatch");
  pen.lineWidth = 1;
  for (let x = -height; x < width; x += 6) segment(pen, x, height, x + height, 0);
  pen.restore();
}
