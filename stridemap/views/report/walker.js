// A step of the walker, integrated here from a section point, with the model's equations.

// The generated function `name` at `values`, an object with t, q, v, p, z as far as it takes them.
function evaluate(name, values) {
  return equations[name](Math, ...model.inputs[name].map((input) => values[input]));
}

const knows = (name) => name in model.inputs;
const nCoordinates = model.coordinates.length;

function stateOf(t, y, p) {
  return { t, q: y.slice(0, nCoordinates), v: y.slice(nCoordinates), p };
}

function rate(t, y, p) {
  const { dq, dv } = evaluate("state_derivative", stateOf(t, y, p));
  return [...dq, ...dv];
}

// One step of the explicit Runge-Kutta method of order 8 of Dormand and Prince.
function advance(t, y, h, p) {
  const { a, b, c } = report.tableau;
  const slopes = [];
  const moved = (weights) => {
    const sum = y.slice();
    for (let j = 0; j < weights.length; j++) {
      if (!weights[j]) continue;
      const [weight, slope] = [h * weights[j], slopes[j]];
      for (let i = 0; i < sum.length; i++) sum[i] += weight * slope[i];
    }
    return sum;
  };
  for (let stage = 0; stage < b.length; stage++) slopes.push(rate(t + c[stage] * h, moved(a[stage]), p));
  return moved(b);
}

const distance = (a, b) => Math.max(...a.map((value, i) => Math.abs(value - b[i])));

// The path from one touchdown to the next.
class Path {
  static COARSEST = 48;
  static FINEST = 3072;
  static TARGET = 1e-11;

  constructor(z, period, p) {
    this.period = period;
    this.p = p;
    const start = evaluate("section_state", { z, p });
    this.start = [...start.q, ...start.v];
    let nodes = this.nodes(Path.COARSEST);
    do {
      this.states = nodes;
      nodes = this.nodes(2 * (this.states.length - 1));
      this.change = distance(nodes.at(-1), this.states.at(-1));
    } while (!(this.change < Path.TARGET) && nodes.length - 1 < Path.FINEST);
    this.states = nodes;
    this.steps = nodes.length - 1;
  }

  static ofRow(row) {
    const z = model.section.map(({ name }) => orbits.numbers(name)[row]);
    return new Path(z, orbits.numbers("period")[row], grid.point(orbits.numbers("cell")[row]));
  }

  nodes(steps) {
    const h = this.period / steps;
    const states = [this.start];
    for (let i = 0; i < steps; i++) states.push(advance(i * h, states[i], h, this.p));
    return states;
  }

  // How far the state after the impact is from that at the start.
  get closing() {
    const { q, v } = stateOf(this.period, this.states.at(-1), this.p);
    const after = evaluate("impact_map", { t: this.period, q, v, p: this.p });
    return distance([...after.q_plus, ...after.v_plus], this.start);
  }

  // The state at a time, with the integrator's own accuracy between its nodes.
  at(t) {
    const h = this.period / this.steps;
    const node = Math.max(0, Math.min(Math.floor(t / h), this.steps - 1));
    const rest = t - node * h;
    return stateOf(t, rest === 0 ? this.states[node] : advance(node * h, this.states[node], rest, this.p), this.p);
  }

  // All that is drawn or plotted at a time; what the model does not have is null.
  seen(t) {
    const state = this.at(t);
    const of = (name, output) => (knows(name) ? evaluate(name, state)[output] : null);
    const { positions, masses, ...lines } = evaluate("drawing", state);
    return {
      ...state, positions, masses, lines,
      foot: of("swing_foot", "foot"),
      com: of("centre_of_mass", "com"),
      force: of("ground_force", "force"),
      contact: of("stance_foot", "stance")?.[0] ?? 0,
      cop: of("centre_of_pressure", "cop"),
      offset: of("centre_of_pressure", "offset"),
      zmp: of("zmp", "zmp"),
      d: of("zmp", "d"),
      torque: of("controller_torque", "u"),
    };
  }

  // What is seen at evenly spaced times, both ends included.
  samples(count) {
    return Array.from({ length: count }, (_, i) => this.seen((this.period * i) / (count - 1)));
  }
}
