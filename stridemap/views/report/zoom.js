// Zoom and pan: which part of the map is shown, as [left, right, bottom, top] in parts of the whole, or null for all.

const WHOLE = [0, 1, 0, 1];
const DEEPEST = 1 / 64;

// A part of the map about a point that stays where it is, larger by a factor.
function zoomed(view, [x, y], factor) {
  const side = (from, to, at) => {
    const size = Math.min(1, Math.max(DEEPEST, (to - from) / factor));
    const middle = from + at * (to - from);
    const start = Math.max(0, Math.min(1 - size, middle - at * size));
    return [start, start + size];
  };
  const [a, b, c, d] = view ?? WHOLE;
  const found = [...side(a, b, x), ...side(c, d, y)];
  return found.every((value, i) => Math.abs(value - WHOLE[i]) < 1e-9) ? null : found;
}

// A part of the map moved by parts of what is shown.
function moved(view, right, up) {
  if (!view) return null;
  const side = (from, to, by) => {
    const start = Math.max(0, Math.min(1 - (to - from), from + by * (to - from)));
    return [start, start + to - from];
  };
  return [...side(view[0], view[1], right), ...side(view[2], view[3], up)];
}

class ZoomPointer {
  // `place(event)` gives a point in parts of what is shown, `view()` and `onView(view)` read and change it.
  constructor(canvas, place, view, onView) {
    Object.assign(this, { canvas, place, view, onView, down: new Map(), dragged: false });
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => this.down.delete(event.pointerId));
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
  }

  press(event) {
    if (!this.down.size) this.dragged = false;
    this.down.set(event.pointerId, this.place(event));
    this.start = [event.clientX, event.clientY];
  }

  move(event) {
    const before = this.down.get(event.pointerId);
    if (!before) return;
    const now = this.place(event);
    if (Math.hypot(event.clientX - this.start[0], event.clientY - this.start[1]) > 5) this.dragged = true;
    if (!this.dragged) return;
    const others = [...this.down].filter(([id]) => id !== event.pointerId).map(([, point]) => point);
    this.down.set(event.pointerId, now);
    if (others.length) {
      const away = (point) => Math.hypot(point[0] - others[0][0], point[1] - others[0][1]);
      if (away(before) > 1e-3) this.onView(zoomed(this.view(), others[0], away(now) / away(before)));
    } else if (this.view()) this.onView(moved(this.view(), before[0] - now[0], before[1] - now[1]));
  }

  // The wheel scrolls the page, unless the map has the focus or Ctrl is held, as when two fingers pinch on a pad.
  wheel(event) {
    if (!event.ctrlKey && !event.metaKey && document.activeElement !== this.canvas) return;
    event.preventDefault();
    this.onView(zoomed(this.view(), this.place(event), Math.exp(-event.deltaY / 300)));
  }
}
