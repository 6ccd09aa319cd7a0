// The slice: a measure of all cycles along the map's horizontal axis, through the chosen cell. Filled marks are
// stable cycles, open ones unstable; lines join the cycles of one branch, and are dashed where they are unstable.

const SLICE = { top: 12, bottom: 30 };

class Slice {
  // `onChoose(row)` is called when the reader presses near a cycle.
  constructor(canvas, onChoose) {
    this.canvas = canvas;
    canvas.addEventListener("click", (event) => {
      const row = this.near(event);
      if (row !== null) onChoose(row);
    });
  }

  // Draw `measure` of the cycles that `keep(cell)` gives; `level` is a value to mark with a line, or null;
  // `crossings` are values of the axis at which boundaries are crossed, with their types.
  show({ across, indices, keep, measure, scale, level, chosen, crossings }) {
    Object.assign(this, { across, measure, scale, level, chosen, crossings });
    this.columns = new CellScale(grid.axes[across]);
    this.rows = grid.axes[across].values.flatMap((_, column) => {
      const at = [...indices];
      at[across] = column;
      return keep(grid.cell(at)).map((row) => [column, row]);
    });
    this.joined = joined(this.rows);
    this.draw();
  }

  locate(column, row, width, height) {
    const value = orbits.numbers(this.measure.name)[row];
    const unit = this.scale.unit(value);
    const x = INSET.left + this.columns.position(column) * (width - INSET.left - INSET.right);
    const y = height - SLICE.bottom - Math.max(0, Math.min(1, unit)) * (height - SLICE.top - SLICE.bottom);
    return { x, y, beyond: unit > 1 ? 1 : unit < 0 ? -1 : 0, missing: Number.isNaN(value) };
  }

  near(event) {
    const { width, height, left, top } = this.canvas.getBoundingClientRect();
    const away = ([column, row]) => {
      const { x, y, missing } = this.locate(column, row, width, height);
      return missing ? Infinity : Math.hypot(event.clientX - left - x, event.clientY - top - y);
    };
    const best = this.rows.reduce((found, pair) => (found === null || away(pair) < away(found) ? pair : found), null);
    return best !== null && away(best) < 30 ? best[1] : null;
  }

  draw() {
    if (!this.rows) return;
    const { pen, width, height } = prepared(this.canvas);
    const [right, bottom] = [width - INSET.right, height - SLICE.bottom];
    const y = (value) => bottom - this.scale.unit(value) * (bottom - SLICE.top);
    pen.font = `12px ${styled("font")}`;
    pen.textAlign = "right";
    pen.textBaseline = "middle";
    for (const value of this.scale.ticks(5)) {
      pen.strokeStyle = styled("line");
      pen.lineWidth = 1;
      segment(pen, INSET.left, y(value), right, y(value));
      pen.fillStyle = styled("ink-soft");
      pen.fillText(brief(value), INSET.left - 8, y(value));
    }
    if (this.level !== null && this.scale.unit(this.level) >= 0 && this.scale.unit(this.level) <= 1) {
      pen.strokeStyle = styled("ink");
      segment(pen, INSET.left, y(this.level), right, y(this.level));
    }
    this.axis(pen, right, bottom);
    // Many cells leave little room: marks are smaller, so that the lines between them can be seen.
    this.size = (right - INSET.left) / this.columns.values.length < 6 ? 1.6 : 3;
    this.boundaries(pen, right, bottom);
    this.lines(pen, width, height);
    for (const [column, row] of this.rows) this.dot(pen, this.locate(column, row, width, height), row);
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

  // Branches: half of each line between two cycles looks as the cycle that it begins at.
  lines(pen, width, height) {
    const columns = new Map(this.rows.map(([column, row]) => [row, column]));
    pen.lineWidth = 1.4;
    for (const [one, other] of this.joined) {
      const [a, b] = [one, other].map((row) => this.locate(columns.get(row), row, width, height));
      if (a.missing || b.missing || (a.beyond && a.beyond === b.beyond)) continue;
      const [x, y] = [(a.x + b.x) / 2, (a.y + b.y) / 2];
      for (const [end, row] of [[a, one], [b, other]]) {
        const stable = stableColumn[row] === 1;
        pen.strokeStyle = styled(stable ? "map-stable" : "open");
        pen.setLineDash(stable ? [] : [4, 3]);
        segment(pen, end.x, end.y, x, y);
      }
    }
    pen.setLineDash([]);
  }

  axis(pen, right, bottom) {
    pen.strokeStyle = styled("line");
    pen.strokeRect(INSET.left - 0.5, SLICE.top - 0.5, right - INSET.left + 1, bottom - SLICE.top + 1);
    pen.textAlign = "center";
    pen.textBaseline = "top";
    for (const [unit, text] of this.columns.ticks(right < 500 ? 5 : 8)) {
      const x = INSET.left + unit * (right - INSET.left);
      segment(pen, x, bottom, x, bottom + 5);
      pen.fillText(text, x, bottom + 8);
    }
  }

  // Beyond the scale a mark becomes a triangle at its edge.
  dot(pen, { x, y, beyond, missing }, row) {
    if (missing) return;
    const [stable, chosen] = [stableColumn[row] === 1, row === this.chosen];
    const size = chosen ? 6 : this.size;
    pen.beginPath();
    if (beyond) {
      pen.moveTo(x, y - beyond * (size + 2));
      pen.lineTo(x + size, y + beyond * 2);
      pen.lineTo(x - size, y + beyond * 2);
      pen.closePath();
    } else pen.arc(x, y, size, 0, 2 * Math.PI);
    pen.fillStyle = styled(stable ? "map-stable" : "card");
    pen.strokeStyle = styled(chosen ? "ink" : stable ? "map-stable" : "open");
    pen.lineWidth = chosen ? 2.5 : 1.3;
    pen.fill();
    pen.stroke();
  }
}
