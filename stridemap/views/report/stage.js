// The stage: the walker on its ground, with zero moment point and ground force, moving or at a chosen time.

const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1];
const MASS_COLOURS = { stance_foot: "stance", swing_foot: "swing", wobbling: "mass" };
const TRACE = 97; // samples of a step for traces
const springLines = model.lines.filter(({ role }) => role === "spring");

// The name of a body's colour. A body where the legs meet is drawn as they are; any other has a colour of its own.
function bodyColour({ lines, positions }, i) {
  const { role } = model.masses[i];
  if (role !== "body") return MASS_COLOURS[role];
  const hips = model.lines.filter((line) => line.role === "legs").map(({ name }) => lines[name][Math.floor(lines[name].length / 2)]);
  return hips.some((hip) => distance(hip, positions[i]) < 1e-9) ? "stance" : "body";
}

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
    this.traces = this.tracesOf(path.samples(TRACE));
    this.loops = new Map(springLines.map(({ name }) => [name, this.loopsOf(name, path.samples(TRACE))]));
    const forces = samples.map(({ force }) => (force === null ? 0 : Math.hypot(...force))).sort((a, b) => a - b);
    this.size = Math.max(...heights);
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

  // Where wobbling masses are over a step, in the world.
  tracesOf(samples) {
    const wobbling = model.masses.flatMap(({ role }, i) => (role === "wobbling" ? [i] : []));
    return wobbling.map((i) => samples.map(({ positions }) => positions[i]));
  }

  // The two ends of a spring over a step, as seen by who walks along at the mean speed: loops about the mean of the
  // first one. Their reach is how far they go from there.
  loopsOf(name, samples) {
    const along = (sample, i) => this.stride.map((v) => (v * i) / (samples.length - 1));
    const ends = [0, -1].map((end) => samples.map((sample, i) => sample.lines[name].at(end).map((v, axis) => v - along(sample, i)[axis])));
    const middle = [0, 1].map((axis) => ends[0].reduce((sum, point) => sum + point[axis], 0) / samples.length);
    const loops = ends.map((end) => end.map((point) => point.map((v, axis) => v - middle[axis])));
    return { middle, loops, reach: Math.max(...loops.flat().map((point) => Math.hypot(...point))) };
  }

  draw() {
    if (!this.path) return;
    const { pen, width, height } = prepared(this.canvas);
    this.render(pen, width, height);
  }

  render(pen, width, height) {
    const scale = Math.min(width / 0.9, height / 1.24) / this.size;
    // The camera follows at the mean speed; the origin of the world is the present stance foot.
    const share = this.time / this.path.period - 0.5;
    const centre = [share * this.stride[0], share * this.stride[1]];
    const toPixels = ([x, y]) => [width / 2 + (x - centre[0]) * scale, height - 0.13 * this.size * scale - (y - centre[1]) * scale];
    this.toPixels = toPixels;
    this.ground(pen, toPixels, width, scale);
    this.trace(pen, toPixels, width, scale);
    this.measures(pen, toPixels, scale);
    this.walker(pen, toPixels, scale);
    this.centreOfMass(pen, toPixels);
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

  // Where each wobbling mass was and will be, a dot for equal times: where they lie close it is slow.
  trace(pen, toPixels, width, scale) {
    const steps = Math.ceil(width / scale / (Math.abs(this.stride[0]) || 1)) + 1;
    pen.fillStyle = styled("mass");
    for (const trace of this.traces) {
      for (let step = -steps; step <= steps; step++) {
        for (let i = 0; i < trace.length - 1; i += 8) {
          const past = step + i / (trace.length - 1) <= this.time / this.path.period;
          disc(pen, toPixels(trace[i].map((v, axis) => v + step * this.stride[axis])), past ? 2 : 1);
        }
      }
    }
  }

  walker(pen, toPixels, scale) {
    const { lines, positions, masses } = this.seen;
    pen.lineCap = "round";
    pen.lineJoin = "round";
    for (const { name, role } of model.lines) {
      const points = lines[name];
      const hip = Math.floor(points.length / 2); // of legs: the stance leg ends here and the swing leg begins
      for (let i = 1; i < points.length; i++) {
        const [colour, width] = role === "spring" ? ["spring", 2] : role === "legs" && i > hip ? ["swing", 5] : ["stance", 6];
        pen.strokeStyle = styled(colour);
        pen.lineWidth = width;
        if (role === "spring") coil(pen, toPixels(points[i - 1]), toPixels(points[i]));
        else segment(pen, ...toPixels(points[i - 1]), ...toPixels(points[i]));
      }
    }
    const heaviest = Math.max(...masses.map(Math.abs));
    // The lighter ones in front, or a heavy one would hide them.
    const order = positions.map((_, i) => i).sort((a, b) => Math.abs(masses[b]) - Math.abs(masses[a]));
    order.forEach((i) => {
      const position = positions[i];
      const radius = Math.max(3, 0.045 * this.size * scale * Math.sqrt(Math.abs(masses[i] / heaviest)));
      pen.fillStyle = styled(bodyColour(this.seen, i));
      disc(pen, toPixels(position), radius);
      pen.strokeStyle = styled("card");
      pen.lineWidth = 1.5;
      pen.stroke();
    });
  }

  // Springs move little: each is drawn once more under a magnifying glass, in the upper corner, with the loops that
  // its ends go through as seen by who walks along at the mean speed.
  lenses(pen, width, height, scale) {
    const radius = Math.min(0.2 * height, 0.18 * width, 95);
    const reach = Math.max(0, ...[...this.loops.values()].map((of) => of.reach));
    const larger = lensPower((0.86 * radius) / (scale * reach));
    if (!(larger > 1)) return;
    const share = this.time / this.path.period;
    [...this.loops].forEach(([name, { middle, loops }], n) => {
      const centre = [width - radius - 6 - n * (2 * radius + 12), radius + 6];
      const at = ([x, y]) => [centre[0] + larger * scale * x, centre[1] - larger * scale * y];
      pen.fillStyle = styled("card");
      pen.strokeStyle = styled("line");
      pen.lineWidth = 1.5;
      disc(pen, centre, radius);
      pen.stroke();
      const now = [0, -1].map((end) => at(this.seen.lines[name].at(end).map((v, axis) => v - share * this.stride[axis] - middle[axis])));
      loops.forEach((loop, end) => {
        pen.strokeStyle = styled(end ? "spring" : "ink-soft");
        pen.lineWidth = end ? 2 : 1.5;
        polyline(pen, loop.map(at));
      });
      pen.strokeStyle = styled("spring");
      pen.lineWidth = 1.2;
      coil(pen, ...now, 6, 5);
      pen.fillStyle = styled("ink");
      disc(pen, now[0], 5);
      pen.fillStyle = styled("mass");
      disc(pen, now[1], 7);
      pen.fillStyle = styled("ink-soft");
      pen.font = `12px ${styled("font")}`;
      pen.textAlign = "center";
      pen.textBaseline = "top";
      const title = `${name} \u00d7${larger}, walking along`;
      const half = 3.2 * title.length; // about: on a narrow page it is wider than the circle
      pen.fillText(title, Math.min(centre[0], width - half), centre[1] + radius + 4);
    });
  }

  // The paper's zero moment point with its distance from the foot, and ground force.
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
  }

  centreOfMass(pen, toPixels) {
    const { com } = this.seen;
    if (com !== null) {
      pen.fillStyle = styled("card");
      disc(pen, toPixels(com), 5.5);
      pen.strokeStyle = styled("ink");
      pen.lineWidth = 2;
      pen.stroke();
    }
  }
}

// The largest round number that is not above what fits.
function lensPower(fits) {
  if (!Number.isFinite(fits)) return 0;
  const unit = 10 ** Math.floor(Math.log10(fits));
  return Math.max(...[1, 2, 3, 4, 5, 6, 8].map((m) => m * unit).filter((m) => m <= fits));
}

function disc(pen, [x, y], radius) {
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fill();
}

function polyline(pen, points) {
  pen.beginPath();
  points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
  pen.stroke();
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
