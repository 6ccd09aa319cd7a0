// The stage: the walker on its ground, with zero moment point and ground force, moving or at a chosen time.

const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1];
const MASS_COLOURS = { swing_foot: "swing", wobbling: "spring" };
const springLines = model.lines.filter(({ role }) => role === "spring");

class Stage {
  // `onTime(t)` is called when the time within the step changes.
  constructor(canvas, onTime) {
    this.canvas = canvas;
    this.onTime = onTime;
    this.time = 0;
    this.step = 0;
    this.speed = 0.25;
    this.playing = false;
  }

  load(path) {
    this.path = path;
    this.stride = path.seen(path.period).foot;
    const samples = path.samples(49);
    const heights = samples.flatMap(({ positions, lines }) => [positions, ...Object.values(lines)].flat().map(([, y]) => y));
    const extents = samples.flatMap(({ lines }) => springLines.map(({ name }) => [name, lines[name].at(-1).map((v, i) => v - lines[name][0][i])]));
    // The direction of a spring is that in which it is longest: its length may pass through zero.
    this.springs = new Map();
    for (const [name, extent] of extents) if (Math.hypot(...extent) > Math.hypot(...(this.springs.get(name) ?? [0, 0]))) this.springs.set(name, extent);
    const forces = samples.map(({ force }) => (force === null ? 0 : Math.hypot(...force))).sort((a, b) => a - b);
    this.size = Math.max(...heights);
    this.extent = Math.max(0, ...[...this.springs.values()].map((extent) => Math.hypot(...extent)));
    this.usualForce = forces[24] || 1;
    [this.time, this.step] = [0, 0];
    this.show();
  }

  // Go to a time within the step shown.
  seek(time) {
    this.time = Math.max(0, Math.min(time, this.path.period));
    this.show();
  }

  play(on) {
    this.playing = on && Boolean(this.path);
    this.last = null;
    if (this.playing) requestAnimationFrame((now) => this.tick(now));
  }

  tick(now) {
    if (!this.playing) return;
    const passed = this.last === null ? 0 : Math.min((now - this.last) / 1000, 0.1);
    this.last = now;
    this.time += passed * this.speed;
    while (this.time >= this.path.period) {
      this.time -= this.path.period;
      this.step += 1;
    }
    this.show();
    requestAnimationFrame((next) => this.tick(next));
  }

  show() {
    if (!this.path) return;
    this.seen = this.path.seen(this.time);
    this.draw();
    this.onTime(this.time, this.seen);
  }

  draw() {
    if (!this.path) return;
    const { pen, width, height } = prepared(this.canvas);
    const scale = Math.min(width / 1.5, height / 1.4) / this.size;
    // The camera follows at the mean speed; the origin of the world is the present stance foot.
    const share = this.time / this.path.period - 0.5;
    const centre = [share * this.stride[0], share * this.stride[1]];
    const toPixels = ([x, y]) => [width / 2 + (x - centre[0]) * scale, height - 0.2 * this.size * scale - (y - centre[1]) * scale];
    this.toPixels = toPixels;
    this.ground(pen, toPixels, width, scale);
    this.measures(pen, toPixels, scale);
    this.walker(pen, toPixels, scale);
    this.lenses(pen, width, height, scale);
  }

  // The ground with strokes that stand still in the world, so that walking shows, and the footprints.
  ground(pen, toPixels, width, scale) {
    const [sx, sy] = this.stride;
    const length = Math.hypot(sx, sy) || 1;
    const along = sx > 0 ? [sx / length, sy / length] : [1, 0];
    const at = (s, below = 0) => toPixels([s * along[0] + below * along[1], s * along[1] - below * along[0]]);
    const reach = width / scale;
    pen.strokeStyle = styled("ink-soft");
    pen.lineWidth = 1.5;
    segment(pen, ...at(-reach), ...at(reach));
    pen.strokeStyle = styled("line");
    pen.lineWidth = 1;
    const gap = 0.05 * this.size;
    const walked = this.step * length;
    for (let i = Math.floor((walked - reach) / gap); i * gap < walked + reach; i++) {
      segment(pen, ...at(i * gap - walked), ...at(i * gap - walked - 0.6 * gap, 0.7 * gap));
    }
    pen.fillStyle = styled("ink-soft");
    for (let i = -Math.ceil(reach / length); i <= 0; i++) disc(pen, at(i * length), 2.5);
  }

  walker(pen, toPixels, scale) {
    const { lines, positions, masses } = this.seen;
    pen.lineCap = "round";
    pen.lineJoin = "round";
    for (const { name, role } of model.lines) {
      const points = lines[name];
      const hip = Math.floor(points.length / 2); // of legs: the stance leg ends here and the swing leg begins
      for (let i = 1; i < points.length; i++) {
        const [colour, width] = role === "spring" ? ["spring", 2] : role === "legs" && i > hip ? ["swing", 4] : ["ink", 5];
        pen.strokeStyle = styled(colour);
        pen.lineWidth = width;
        if (role === "spring") coil(pen, toPixels(points[i - 1]), toPixels(points[i]));
        else segment(pen, ...toPixels(points[i - 1]), ...toPixels(points[i]));
      }
    }
    const heaviest = Math.max(...masses.map(Math.abs));
    positions.forEach((position, i) => {
      const radius = Math.max(3, 0.045 * this.size * scale * Math.sqrt(Math.abs(masses[i] / heaviest)));
      pen.fillStyle = styled(MASS_COLOURS[model.masses[i].role] ?? "ink");
      disc(pen, toPixels(position), radius);
      pen.strokeStyle = styled("card");
      pen.lineWidth = 1.5;
      pen.stroke();
    });
  }

  // Springs move little: each is drawn once more under a magnifying glass, in the upper corner. The mark in
  // the middle is where it is fixed; a spring on either side of the mass stands for the one that has no length.
  lenses(pen, width, height, scale) {
    const radius = Math.min(0.16 * height, 0.16 * width, 60);
    const larger = lensPower((0.6 * radius) / (scale * this.extent));
    if (!(larger > 1)) return;
    [...this.springs].forEach(([name, extent], i) => {
      const points = this.seen.lines[name];
      const middle = [width - radius - 6 - i * (2 * radius + 12), radius + 6];
      const along = [extent[0] / Math.hypot(...extent), extent[1] / Math.hypot(...extent)];
      const length = points.at(-1).reduce((sum, v, j) => sum + (v - points[0][j]) * along[j], 0);
      const at = (s, aside = 0) => [middle[0] + s * along[0] + aside * along[1], middle[1] - s * along[1] + aside * along[0]];
      const tip = at(larger * scale * length);
      pen.fillStyle = styled("card");
      pen.strokeStyle = styled("line");
      pen.lineWidth = 1.5;
      disc(pen, middle, radius);
      pen.stroke();
      pen.strokeStyle = styled("ink");
      segment(pen, ...at(0, -0.35 * radius), ...at(0, 0.35 * radius));
      pen.strokeStyle = styled("spring");
      pen.lineWidth = 1.5;
      coil(pen, at(-radius), tip, 5, 4);
      coil(pen, tip, at(radius), 5, 4);
      pen.fillStyle = styled("spring");
      disc(pen, tip, 7);
      pen.fillStyle = styled("ink-soft");
      pen.font = `12px ${styled("font")}`;
      pen.textAlign = "center";
      pen.textBaseline = "top";
      pen.fillText(`${name} \u00d7${larger}`, middle[0], middle[1] + radius + 4);
    });
  }

  // Centre of mass, the paper's zero moment point with its distance from the foot, and ground force.
  measures(pen, toPixels, scale) {
    const { com, zmp, force, contact, cop } = this.seen;
    const footAt = toPixels([contact, 0]);
    if (zmp !== null) {
      const point = toPixels([contact + zmp, 0]);
      pen.strokeStyle = pen.fillStyle = styled("zmp");
      pen.lineWidth = 2;
      segment(pen, footAt[0], footAt[1] + 16, point[0], footAt[1] + 16);
      segment(pen, footAt[0], footAt[1] + 11, footAt[0], footAt[1] + 21);
      pen.lineWidth = 1;
      if (com !== null) {
        pen.setLineDash([2, 4]);
        segment(pen, ...point, ...toPixels(com));
        pen.setLineDash([]);
      }
      triangle(pen, [point[0], point[1] + 4], 8);
    }
    if (force !== null) {
      const at = cop ?? contact;
      const [along, up] = force.map((f) => (0.5 * this.size * f) / this.usualForce);
      pen.strokeStyle = pen.fillStyle = styled("force");
      pen.lineWidth = 3;
      arrow(pen, toPixels([at, 0]), toPixels([at + along, up]), 9);
    }
    if (com !== null) {
      pen.fillStyle = styled("card");
      disc(pen, toPixels(com), 5.5);
      pen.strokeStyle = styled("zmp");
      pen.lineWidth = 2;
      pen.stroke();
    }
  }
}

// The largest round number that is not above what fits.
function lensPower(fits) {
  if (!Number.isFinite(fits)) return 0;
  const unit = 10 ** Math.floor(Math.log10(fits));
  return Math.max(...[1, 2, 5].map((m) => m * unit).filter((m) => m <= fits));
}

function disc(pen, [x, y], radius) {
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fill();
}

function triangle(pen, [x, y], size) {
  pen.beginPath();
  pen.moveTo(x, y);
  pen.lineTo(x - size * 0.75, y + size * 1.3);
  pen.lineTo(x + size * 0.75, y + size * 1.3);
  pen.fill();
}

function arrow(pen, from, to, head) {
  const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  if (length < 1) return;
  const back = Math.max(0, 1 - head / length);
  segment(pen, ...from, from[0] + back * (to[0] - from[0]), from[1] + back * (to[1] - from[1]));
  pen.beginPath();
  pen.moveTo(...to);
  for (const side of [-1, 1]) {
    pen.lineTo(to[0] - head * Math.cos(angle + side * 0.45), to[1] - head * Math.sin(angle + side * 0.45));
  }
  pen.fill();
}

// A spring between two points: a zigzag whose teeth keep their height.
function coil(pen, from, to, teeth = 8, height = 6) {
  const along = [(to[0] - from[0]), (to[1] - from[1])];
  const length = Math.hypot(...along) || 1;
  const across = [(-along[1] / length) * height, (along[0] / length) * height];
  pen.beginPath();
  pen.moveTo(...from);
  for (let i = 1; i < 2 * teeth; i++) {
    const share = 0.1 + (0.8 * (i - 0.5)) / (2 * teeth - 1);
    const side = i % 2 ? 1 : -1;
    pen.lineTo(from[0] + share * along[0] + side * across[0], from[1] + share * along[1] + side * across[1]);
  }
  pen.lineTo(...to);
  pen.stroke();
}
