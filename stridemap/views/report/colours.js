// From the values of a quantity to colours and heights.

// Nine colours of cividis (Nuñez, Anderton and Renslow 2018): lightness rises evenly, and blue against yellow
// is told apart with every common kind of colour vision.
const STOPS = [
  [0, 34, 78], [26, 56, 111], [67, 78, 108], [97, 101, 111], [125, 124, 120], [155, 148, 118], [188, 174, 108],
  [222, 201, 88], [254, 232, 56],
];

// From blue through a pale middle to brown: on either side of a value the lightness falls evenly, and blue against
// brown is told apart with every common kind of colour vision.
const DIVERGING = [
  [5, 48, 97], [33, 102, 172], [67, 147, 195], [146, 197, 222], [241, 240, 234], [244, 196, 130], [217, 132, 50],
  [166, 84, 15], [95, 45, 5],
];

// Where a value lies between two others, from 0 to 1; their difference may be beyond the largest number.
const between = (value, low, high) => (value / 2 - low / 2) / (high / 2 - low / 2);

// Each scale of colours in 512 steps, made once.
const STEPS = 511;
const mixed = new Map([STOPS, DIVERGING].map((stops) => [stops, Array.from({ length: STEPS + 1 }, (_, step) => {
  const position = (step / STEPS) * (stops.length - 1);
  const i = Math.min(Math.floor(position), stops.length - 2);
  const channels = stops[i].map((channel, c) => Math.round(channel + (position - i) * (stops[i + 1][c] - channel)));
  return `rgb(${channels.join(" ")})`;
})]));

const colourAt = (unit, stops = STOPS) => mixed.get(stops)[Math.round(Math.max(0, Math.min(1, unit || 0)) * STEPS)];

// Shares of the values that lie below the ends of a scale.
const ENDS = [0.02, 0.98];

// The scale of what is shown: it spans most of the values, and the few beyond count as its ends.
class ValueScale {
  // `range` is the reader's own, `centre` the value from which a scale diverges, `most` where its own range ends
  // at the latest, `include` what lies on it unless it is far off; `whole` numbers have whole ticks, and `factor` converts units. An
  // axis, other than colours, reaches to all values that do not lie far off, so that none of its marks is cut off.
  constructor(values, { range = null, centre = null, most = Infinity, whole = false, factor = 1, include = [], axis = false } = {}) {
    Object.assign(this, { whole, factor });
    const finite = Float64Array.from(values).filter(Number.isFinite).sort();
    const sorted = finite.length ? finite : [0];
    const at = (share) => sorted[Math.round(share * (sorted.length - 1))];
    const few = sorted.length < 50;
    [this.least, this.largest] = [sorted[0], sorted.at(-1)];
    let [low, high] = few ? [at(0), at(1)] : ENDS.map(at);
    if (axis) {
      const reach = high - low;
      const pad = 0.04 * reach;
      if (low - this.least <= reach) low = Math.min(low, low > 0 && this.least > 0 ? Math.max(this.least - pad, this.least / 1.1) : this.least - pad);
      if (this.largest - high <= reach) high = Math.max(high, this.largest + pad);
    }
    if (low < most) high = Math.min(high, most);
    const [from, to, span] = [low, high, high - low];
    for (const value of include) if (value >= from - span && value <= to + span) [low, high] = [Math.min(low, value - 0.04 * span), Math.max(high, value + 0.04 * span)];
    [low, high] = this.apart(low, high);
    this.own = [low, high];
    [this.low, this.high] = range ?? this.own;
    if (whole && range === null) [this.low, this.high] = [low - 0.5, high + 0.5];
    [this.below, this.above] = [this.least < this.low, this.largest > this.high];
    this.centre = centre !== null && Number.isFinite(centre) ? centre : null;
    this.log = !whole && this.centre === null && this.low > 0 && this.high / this.low > 30;
  }

  // Values that differ by rounding alone are one value.
  apart(low, high) {
    const rounding = Math.max(1e-14, 1e-9 * Math.max(Math.abs(low), Math.abs(high)));
    return high - low > rounding || this.whole ? [low, high] : [low - 0.5, low + 0.5];
  }

  // From 0 at the lower end of the scale to 1 at its upper one.
  unit(value) {
    return this.log ? Math.log(Math.max(value, 0) / this.low) / Math.log(this.high / this.low) : between(value, this.low, this.high);
  }

  valueAt(unit) {
    return this.log ? this.low * (this.high / this.low) ** unit : this.low * (1 - unit) + this.high * unit;
  }

  // Of a diverging scale both sides have all their colours, and the middle one is that of its centre; a side on which
  // nothing is shown is as long as the other.
  colour(value) {
    if (this.centre === null) return colourAt(this.unit(value));
    const [below, above] = [this.centre - this.low, this.high - this.centre];
    const side = value < this.centre ? (below > 0 ? below : above) : above > 0 ? above : below;
    const away = (value - this.centre) / side;
    return colourAt(Number.isNaN(away) ? 0.5 : 0.5 + Math.max(-1, Math.min(1, away)) / 2, DIVERGING);
  }

  ticks(count) {
    const [low, high] = [this.low * this.factor, this.high * this.factor];
    const found = this.log ? logTicks(low, high) : ticks(low, high, count, this.whole);
    return found.map((value) => [value / this.factor, brief(value)]);
  }
}
