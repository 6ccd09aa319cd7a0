// The slice: a quantity of all cycles along the map's horizontal axis, through the chosen cell. Filled marks are
// stable cycles, open ones unstable; lines join the cycles of one branch, and are dashed where they are unstable. Where
// branches were followed along the slice, the lines are these, with their special points.

const SLICE = { top: 12, bottom: 46 };

// From so many stable cycles on the scale is theirs, with as much room beside it as they take.
const STABLE_MARKS = 10;

function aboutStable(shown, rows, quantity) {
  const stable = rows.filter((row) => stableColumn[row] === 1).map((row) => quantity.numbers()[row]).filter(Number.isFinite);
  if (stable.length < STABLE_MARKS || quantity.name in CENTRES) return shown;
  const [low, high] = [Math.min(...stable), Math.max(...stable)];
  return shown.filter((value) => value >= 2 * low - high && value <= 2 * high - low);
}

class Slice {
  // `onChoose(row)` is called when the reader presses near a cycle, or goes to it by keyboard; `onPoint(row, special,
  // event)` when a cycle or a special point is pointed at.
  constructor(canvas, onChoose, onPoint) {
    this.canvas = canvas;
    this.onChoose = onChoose;
    canvas.addEventListener("click", (event) => {
      const row = this.near(event);
      if (row !== null) onChoose(row);
    });
    canvas.addEventListener("pointermove", (event) => onPoint(this.near(event), this.nearSpecial(event), event));
    canvas.addEventListener("pointerleave", () => onPoint(null, null));
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  // Draw `quantity` of the cycles that `keep(cell)` gives, over the scale that `scaleOf(values)` makes; `level` is a
  // value to mark with a line, or null; `reference(indices)` a value to compare with, or null, called `label`;
  // `crossings` are values of the axis at which boundaries are crossed, with their types; `view` is the part shown.
  show({ across, indices, keep, quantity, scaleOf, level, reference, label, chosen, crossings, view }) {
    Object.assign(this, { across, quantity, level, label, chosen, crossings });
    this.columns = new CellScale(grid.axes[across]).zoom(...view);
    const at = [...indices];
    this.rows = [];
    this.compared = [];
    for (let column = this.columns.index(0); column <= this.columns.index(1); column++) {
      at[across] = column;
      for (const row of keep(grid.cell(at))) this.rows.push([column, row]);
      const value = reference(at);
      if (value !== null) this.compared.push([column, value]);
    }
    const values = quantity.numbers();
    this.branches = branchesAlong(across, indices);
    this.special = specialPoints(this.branches).filter(({ table }) => table.has(quantity.name));
    const shown = aboutStable([...this.rows.map(([, row]) => values[row]), ...branchValues(this.branches, quantity.name)], this.rows.map(([, row]) => row), quantity);
    this.scale = scaleOf(shown, this.compared.map(([, value]) => value));
    this.joined = joined(this.rows);
    this.draw();
  }

  locate(column, row, width, height) {
    const value = this.quantity.numbers()[row];
    const unit = this.scale.unit(value);
    const x = INSET.left + this.columns.position(column) * (width - INSET.left - INSET.right);
    const y = height - SLICE.bottom - Math.max(0, Math.min(1, unit)) * (height - SLICE.top - SLICE.bottom);
    return { x, y, beyond: unit > 1 ? 1 : unit < 0 ? -1 : 0, missing: Number.isNaN(value) };
  }

  // Where a value of the parameter and one of the quantity are.
  placeOf(value, y, width, height) {
    return [
      INSET.left + this.columns.unitOf(value) * (width - INSET.left - INSET.right),
      height - SLICE.bottom - this.scale.unit(y) * (height - SLICE.top - SLICE.bottom),
    ];
  }

  // The special point that is pointed at, or null.
  nearSpecial(event) {
    if (!this.rows || !this.special.length) return null;
    const { width, height, left, top } = this.canvas.getBoundingClientRect();
    let [best, least] = [null, 9];
    for (const one of this.special) {
      const [x, y] = this.placeOf(one.value, one.table.numbers(this.quantity.name)[one.row], width, height);
      const distance = Math.hypot(event.clientX - left - x, event.clientY - top - y);
      if (distance < least) [best, least] = [one, distance];
    }
    return best;
  }

  near(event) {
    if (!this.rows) return null;
    const { width, height, left, top } = this.canvas.getBoundingClientRect();
    const away = ([column, row]) => {
      const { x, y, missing } = this.locate(column, row, width, height);
      return missing ? Infinity : Math.hypot(event.clientX - left - x, event.clientY - top - y);
    };
    let [best, least] = [null, 30];
    for (const pair of this.rows) {
      const distance = away(pair);
      if (distance < least) [best, least] = [pair[1], distance];
    }
    return best;
  }

  // Left and right go to the neighbouring column, along the branch where it goes on; up and down to the next value.
  key(event) {
    const row = this.next(event.key);
    if (row === undefined) return;
    event.preventDefault();
    if (row !== null) this.onChoose(row);
  }

  next(key) {
    const values = this.quantity.numbers();
    const here = this.rows.find(([, row]) => row === this.chosen) ?? this.rows[0];
    if (!here) return undefined;
    const value = values[here[1]];
    const nearest = (rows) => rows.reduce((best, pair) => (best === null || Math.abs(values[pair[1]] - value) < Math.abs(values[best[1]] - value) ? pair : best), null);
    if (key === "ArrowLeft" || key === "ArrowRight") {
      const pair = this.joined.find(([one, other]) => (key === "ArrowRight" ? one : other) === here[1]);
      if (pair) return pair[key === "ArrowRight" ? 1 : 0];
      const beyond = this.rows.filter(([column]) => (key === "ArrowRight" ? column > here[0] : column < here[0])).map(([column]) => column);
      if (!beyond.length) return null;
      const column = key === "ArrowRight" ? Math.min(...beyond) : Math.max(...beyond);
      return nearest(this.rows.filter((pair2) => pair2[0] === column))[1];
    }
    if (key === "ArrowUp" || key === "ArrowDown") {
      const sign = key === "ArrowUp" ? 1 : -1;
      const others = this.rows.filter(([column, row]) => column === here[0] && row !== here[1] && sign * (values[row] - value) > 0);
      return nearest(others)?.[1] ?? null;
    }
    if (key === "Home" || key === "End") return this.rows.at(key === "Home" ? 0 : -1)[1];
    return undefined;
  }

  draw() {
    if (!this.rows) return;
    const { pen, width, height } = prepared(this.canvas);
    this.render(pen, width, height);
  }

  render(pen, width, height) {
    const [right, bottom] = [width - INSET.right, height - SLICE.bottom];
    const y = (value) => bottom - this.scale.unit(value) * (bottom - SLICE.top);
    pen.font = `12px ${styled("font")}`;
    for (const [value] of this.scale.ticks(5)) {
      pen.strokeStyle = styled("line");
      pen.lineWidth = 1;
      segment(pen, INSET.left, y(value), right, y(value));
    }
    pen.fillStyle = styled("ink-soft");
    ticksBeside(pen, this.scale.ticks(5).map(([value, text]) => [this.scale.unit(value), text]), INSET.left, SLICE.top, bottom);
    if (this.level !== null && this.scale.unit(this.level) >= 0 && this.scale.unit(this.level) <= 1) {
      pen.strokeStyle = styled("ink");
      segment(pen, INSET.left, y(this.level), right, y(this.level));
    }
    this.axis(pen, right, bottom);
    // Many cells leave little room: marks are smaller, so that the lines between them can be seen.
    this.size = (right - INSET.left) / this.columns.values.length < 6 ? 1.6 : 3;
    this.boundaries(pen, right, bottom);
    this.compare(pen, right, bottom);
    const followed = this.branches.some(({ table }) => table.has(this.quantity.name));
    if (!followed) this.lines(pen, width, height);
    this.dots(pen, width, height);
    if (followed) this.followed(pen, width, height, { x: INSET.left, y: SLICE.top, width: right - INSET.left, height: bottom - SLICE.top });
    nameBelow(pen, axisQuantities[this.across].title, INSET.left, right, bottom);
    nameBeside(pen, this.quantity.unit ? `[${this.quantity.unit}]` : "", SLICE.top, bottom);
  }

  // The value to compare with, over the columns for which it holds; where it is beyond the scale its label says so.
  compare(pen, right, bottom) {
    const width = right - INSET.left;
    pen.lineWidth = 1.8;
    pen.strokeStyle = styled("zmp");
    for (const [column, value] of this.compared) {
      const unit = this.scale.unit(value);
      if (!(unit >= 0 && unit <= 1)) continue;
      const [x0, x1] = this.columns.span(column).map((u) => INSET.left + Math.max(0, Math.min(1, u)) * width);
      const y = bottom - unit * (bottom - SLICE.top);
      segment(pen, x0, y, x1, y);
    }
    if (!this.compared.length) return;
    const value = this.compared.at(-1)[1];
    const unit = this.scale.unit(value);
    const beyond = unit > 1 ? " (above)" : unit < 0 ? " (below)" : "";
    const high = unit > 0.85;
    const y = bottom - Math.max(0, Math.min(1, unit)) * (bottom - SLICE.top) + (high ? 3 : -3);
    pen.font = `600 12px ${styled("font")}`;
    pen.textAlign = "right";
    pen.textBaseline = high ? "top" : "bottom";
    pen.fillStyle = styled("zmp");
    pen.lineWidth = 3;
    pen.strokeStyle = styled("card");
    const text = `${this.label} ${this.quantity.text(value, 4)}${beyond}`;
    pen.strokeText(text, right - 6, y);
    pen.fillText(text, right - 6, y);
  }

  // Where boundaries cross the slice.
  boundaries(pen, right, bottom) {
    for (const [value, type] of this.crossings) {
      const unit = this.columns.unitOf(value);
      if (!(unit >= 0 && unit <= 1)) continue;
      const x = INSET.left + unit * (right - INSET.left);
      pen.strokeStyle = type === "fold" ? styled("ink-soft") : report.looks[type].colour;
      pen.lineWidth = 1;
      pen.setLineDash(report.looks[type].dashes.map((d) => 1.5 * d));
      segment(pen, x, SLICE.top, x, bottom);
    }
    pen.setLineDash([]);
  }

  // Branches that were followed, and their special points within the box.
  followed(pen, width, height, box) {
    drawBranches(pen, this.branches, this.quantity.name, (value, y) => this.placeOf(value, y, width, height), box);
    for (const { table, row, type, words, value } of this.special) {
      const [x, y] = this.placeOf(value, table.numbers(this.quantity.name)[row], width, height);
      const inside = x >= box.x && x <= box.x + box.width && y >= box.y - 1 && y <= box.y + box.height + 1;
      if (inside) drawMarker(pen, type, words === "subcritical", x, y, 4);
    }
  }

  // Branches: half of each line between two cycles looks as the cycle that it begins at.
  lines(pen, width, height) {
    const columns = new Map(this.rows.map(([column, row]) => [row, column]));
    const [stableColour, openColour] = [styled("map-stable"), styled("open")];
    pen.lineWidth = 1.4;
    for (const [one, other] of this.joined) {
      const [a, b] = [one, other].map((row) => this.locate(columns.get(row), row, width, height));
      if (a.missing || b.missing || (a.beyond && a.beyond === b.beyond)) continue;
      const [x, y] = [(a.x + b.x) / 2, (a.y + b.y) / 2];
      for (const [end, row] of [[a, one], [b, other]]) {
        const stable = stableColumn[row] === 1;
        pen.strokeStyle = stable ? stableColour : openColour;
        pen.setLineDash(stable ? [] : [4, 3]);
        segment(pen, end.x, end.y, x, y);
      }
    }
    pen.setLineDash([]);
  }

  axis(pen, right, bottom) {
    pen.strokeStyle = styled("line");
    pen.lineWidth = 1;
    pen.strokeRect(INSET.left - 0.5, SLICE.top - 0.5, right - INSET.left + 1, bottom - SLICE.top + 1);
    pen.fillStyle = styled("ink-soft");
    ticksBelow(pen, this.columns.ticks(right < 500 ? 5 : 8, axisQuantities[this.across].factor), INSET.left, right, bottom);
  }

  // Beyond the scale a mark becomes a triangle at its edge.
  dots(pen, width, height) {
    const colours = Object.fromEntries(["map-stable", "card", "open", "ink"].map((name) => [name, styled(name)]));
    const last = this.rows.filter(([, row]) => row === this.chosen); // the chosen one is drawn over the others
    for (const [column, row] of [...this.rows.filter(([, row2]) => row2 !== this.chosen), ...last]) {
      const { x, y, beyond, missing } = this.locate(column, row, width, height);
      if (missing) continue;
      const [stable, chosen] = [stableColumn[row] === 1, row === this.chosen];
      const size = chosen ? 6 : this.size;
      pen.beginPath();
      if (beyond) {
        pen.moveTo(x, y - beyond * (size + 2));
        pen.lineTo(x + size, y + beyond * 2);
        pen.lineTo(x - size, y + beyond * 2);
        pen.closePath();
      } else pen.arc(x, y, size, 0, 2 * Math.PI);
      pen.fillStyle = colours[stable ? "map-stable" : "card"];
      pen.strokeStyle = colours[chosen ? "ink" : stable ? "map-stable" : "open"];
      pen.lineWidth = chosen ? 2.5 : 1.3;
      pen.fill();
      pen.stroke();
    }
  }
}
