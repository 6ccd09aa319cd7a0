// The bar of a colour scale, with a handle at each of its ends: by mouse, finger, and keyboard.

class ColourBar {
  // `onRange([low, high], done)` is called while an end moves, and when it is let go.
  constructor(box, onRange) {
    this.onRange = onRange;
    this.bar = html("div", { class: "bar" });
    this.ticks = html("div", { class: "ticks" });
    this.handles = ["lower", "upper"].map((side, i) => {
      const handle = html("button", { type: "button", class: "handle", role: "slider", "aria-label": `${side} end of the colours`, "data-end": side });
      handle.addEventListener("pointerdown", (event) => this.press(event, i));
      handle.addEventListener("pointermove", (event) => this.held === i && this.drag(event, i));
      for (const end of ["pointerup", "pointercancel"]) handle.addEventListener(end, () => this.lift(i));
      handle.addEventListener("keydown", (event) => this.key(event, i));
      return handle;
    });
    this.bar.append(...this.handles);
    this.name = html("span", { class: "name" });
    box.replaceChildren(this.name, this.bar, this.ticks);
  }

  // The bar reaches beyond the colours as far as the values that are shown do, but not by more than its own length.
  show(scale, quantity) {
    this.scale = scale;
    this.quantity = quantity;
    this.name.textContent = quantity.title;
    if (this.held === undefined) this.span(scale);
    const stops = Array.from({ length: 49 }, (_, i) => scale.colour(this.valueAt(i / 48))).join(", ");
    this.bar.style.background = `linear-gradient(to right, ${stops})`;
    [scale.low, scale.high].forEach((value, i) => {
      const handle = this.handles[i];
      handle.style.left = `${100 * this.unit(value)}%`;
      handle.setAttribute("aria-valuemin", String(this.low));
      handle.setAttribute("aria-valuemax", String(this.high));
      handle.setAttribute("aria-valuenow", String(value));
      handle.setAttribute("aria-valuetext", `${brief(value * quantity.factor)} ${quantity.unit}`.trim());
    });
    const values = this.log ? logTicks(this.low * quantity.factor, this.high * quantity.factor) : ticks(this.low * quantity.factor, this.high * quantity.factor, 6, scale.whole);
    const marked = values.map((value) => [value / quantity.factor, brief(value)]);
    this.ticks.replaceChildren(...marked.map(([value, text]) => html("span", { style: `left: ${100 * this.unit(value)}%` }, text)));
  }

  span(scale) {
    this.log = scale.log;
    const [low, high] = [scale.low, scale.high];
    const reach = this.log ? high / low : high - low;
    const [below, above] = this.log ? [low / Math.sqrt(reach), high * Math.sqrt(reach)] : [low - reach / 2, high + reach / 2];
    this.low = Math.min(low, Math.max(scale.whole ? scale.least - 0.5 : scale.least, below));
    this.high = Math.max(high, Math.min(scale.whole ? scale.largest + 0.5 : scale.largest, above));
    if (this.log && !(this.low > 0)) this.low = low;
  }

  unit(value) {
    const unit = this.log ? Math.log(value / this.low) / Math.log(this.high / this.low) : between(value, this.low, this.high);
    return Math.max(0, Math.min(1, unit));
  }

  valueAt(unit) {
    return this.log ? this.low * (this.high / this.low) ** unit : this.low * (1 - unit) + this.high * unit;
  }

  press(event, i) {
    this.held = i;
    this.handles[i].setPointerCapture?.(event.pointerId);
    event.preventDefault();
    this.handles[i].focus();
  }

  drag(event, i) {
    const { left, width } = this.bar.getBoundingClientRect();
    this.move(i, this.valueAt(Math.max(0, Math.min(1, (event.clientX - left) / width))), false);
  }

  lift(i) {
    if (this.held !== i) return;
    this.held = undefined;
    this.onRange([this.scale.low, this.scale.high], true);
  }

  key(event, i) {
    const strides = { ArrowLeft: -0.01, ArrowDown: -0.01, ArrowRight: 0.01, ArrowUp: 0.01, PageDown: -0.1, PageUp: 0.1 };
    const here = this.unit([this.scale.low, this.scale.high][i]);
    const to = event.key === "Home" ? 0 : event.key === "End" ? 1 : event.key in strides ? here + strides[event.key] : null;
    if (to === null) return;
    event.preventDefault();
    this.move(i, this.valueAt(Math.max(0, Math.min(1, to))), true);
  }

  // The ends keep their order, and a little apart.
  move(i, value, done) {
    const range = [this.scale.low, this.scale.high];
    const least = 0.005;
    const limit = this.valueAt(Math.max(0, Math.min(1, this.unit(range[1 - i]) + (i ? least : -least))));
    range[i] = i ? Math.max(value, limit) : Math.min(value, limit);
    if (range[0] < range[1]) this.onRange(range, done);
  }
}
