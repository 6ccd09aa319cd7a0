// Filters: expressions such as `cot < compass and friction < .3` over the columns of the sweep and its parameters.
//
// A name stands for a number, a word or a truth of one cycle. What is missing is neither so nor not so: a comparison
// with it keeps no cycle, and neither does its opposite.

class FilterError extends Error {}

const TOKEN = /\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([\p{L}_][\p{L}\p{N}_]*)|("[^"]*"|'[^']*')|(<=|>=|==|!=|≤|≥|≠|\|μ\||\*\*|[-+*/^()<>=,−]))/uy;
const PLAIN = { "≤": "<=", "≥": ">=", "≠": "!=", "=": "==", "−": "-", "**": "^" };
const COMPARE = {
  "<": (a, b) => a < b, "<=": (a, b) => a <= b, ">": (a, b) => a > b, ">=": (a, b) => a >= b, "==": (a, b) => a === b, "!=": (a, b) => a !== b,
};
const FUNCTIONS = { abs: Math.abs, sqrt: Math.sqrt, log: Math.log, exp: Math.exp };
const HELP = "write something like cot < 0.3 and stable";

function tokens(text) {
  const found = [];
  TOKEN.lastIndex = 0;
  while (text.slice(TOKEN.lastIndex).trim()) {
    const from = TOKEN.lastIndex;
    const match = TOKEN.exec(text);
    if (!match) throw new FilterError(`The filter has “${[...text.slice(from).trim()][0]}”, which is not part of an expression; ${HELP}.`);
    const [, number, name, string, sign] = match;
    if (number) found.push({ kind: "number", value: Number(number), text: number });
    else if (name) found.push({ kind: /^(and|or|not)$/i.test(name) ? name.toLowerCase() : "name", text: name });
    else if (string) found.push({ kind: "word", text: string.slice(1, -1) });
    else if (sign === "|μ|") found.push({ kind: "name", text: "spectral_radius" });
    else found.push({ kind: PLAIN[sign] ?? sign, text: sign });
  }
  return found;
}

// Each node is {type, of(row)}: a number (NaN where it is missing), a word (null), or a truth (null where not known).
class FilterParser {
  constructor(text) {
    this.tokens = tokens(text);
    this.at = 0;
    this.depth = 0;
  }

  peek(...kinds) {
    return kinds.includes(this.tokens[this.at]?.kind);
  }

  next() {
    return this.tokens[this.at++];
  }

  whole() {
    const node = this.truth(this.either(), "The filter");
    if (this.at < this.tokens.length) throw new FilterError(`The filter goes on with “${this.tokens[this.at].text}” where “and”, “or” or its end should be; ${HELP}.`);
    return node;
  }

  truth(node, what) {
    if (node.unknown) throw node.unknown;
    if (node.type !== "truth") throw new FilterError(`${what} must say what holds, but “${node.text}” is a ${node.type}; compare it, as in ${node.type === "word" ? `${node.text} = "…"` : `${node.text} < 1`}.`);
    return node;
  }

  number(node, sign) {
    if (node.type !== "number") throw new FilterError(`“${node.text}” is a ${node.type}, and “${sign}” needs numbers.`);
    return node;
  }

  joined(one, sign, other) {
    return `${one.text} ${sign} ${other.text}`;
  }

  either() {
    let left = this.both();
    while (this.peek("or")) {
      this.next();
      const [a, b] = [this.truth(left, "What stands before “or”"), this.truth(this.both(), "What stands after “or”")];
      left = { type: "truth", text: this.joined(a, "or", b), of: (row) => {
        const [x, y] = [a.of(row), b.of(row)];
        return x || y ? true : x === null || y === null ? null : false;
      } };
    }
    return left;
  }

  both() {
    let left = this.negated();
    while (this.peek("and")) {
      this.next();
      const [a, b] = [this.truth(left, "What stands before “and”"), this.truth(this.negated(), "What stands after “and”")];
      left = { type: "truth", text: this.joined(a, "and", b), of: (row) => {
        const [x, y] = [a.of(row), b.of(row)];
        return x === false || y === false ? false : x === null || y === null ? null : true;
      } };
    }
    return left;
  }

  negated() {
    if (!this.peek("not")) return this.comparison();
    this.next();
    this.deeper();
    const node = this.truth(this.negated(), "What stands after “not”");
    this.depth--;
    return { type: "truth", text: `not ${node.text}`, of: (row) => { const x = node.of(row); return x === null ? null : !x; } };
  }

  // Comparisons may follow each other: 0.2 < cot < 0.3.
  comparison() {
    let left = this.sum();
    const parts = [];
    while (this.peek(...Object.keys(COMPARE))) {
      const { kind, text } = this.next();
      const right = this.sum();
      parts.push(this.compared(left, kind, text, right));
      left = right;
    }
    if (!parts.length) {
      if (left.label) throw new FilterError(`“${left.text}” stands for a value to compare with; write something like cot < ${left.text}.`);
      return left;
    }
    const text = parts.map((part) => part.text).join(" and ");
    return { type: "truth", text, of: (row) => {
      let known = true;
      for (const part of parts) {
        const x = part.of(row);
        if (x === false) return false;
        if (x === null) known = null;
      }
      return known;
    } };
  }

  compared(left, kind, sign, right) {
    const [a, b] = this.referred(this.worded(left, right), this.worded(right, left));
    if (a.type !== b.type) throw new FilterError(`“${a.text}” is a ${a.type} and “${b.text}” a ${b.type}, which cannot be compared.`);
    if (a.type !== "number" && !["==", "!="].includes(kind)) throw new FilterError(`“${a.text}” is a ${a.type}: it can be compared with = or != only.`);
    const holds = COMPARE[kind];
    return { type: "truth", text: this.joined(a, sign, b), of: (row) => {
      const [x, y] = [a.of(row), b.of(row)];
      return x === null || y === null || Number.isNaN(x) || Number.isNaN(y) ? null : holds(x, y);
    } };
  }

  // A name that is not known, compared with a word: group = B.
  worded(node, other) {
    if (!node.unknown) return node;
    if (other.type === "word" && !other.unknown) return { type: "word", text: node.text, of: () => node.text };
    throw node.unknown;
  }

  // A reference, in a comparison with one quantity that has it.
  referred(left, right) {
    const label = [...(left.labels ?? []), ...(right.labels ?? [])][0];
    if (!label) return [left, right];
    const names = [...new Set([...(left.names ?? []), ...(right.names ?? [])])];
    const fitting = names.filter((name) => hasReference(name, label));
    if (fitting.length !== 1) {
      const why = names.length ? `${names.map((name) => `“${name}”`).join(" and ")} ${names.length > 1 ? "are compared at once" : "does not have one"}` : "no quantity is compared with it";
      throw new FilterError(`“${label}” stands for the value that the compared quantity has there, but ${why}; write something like ${references.find((one) => one.label === label).quantity} < ${label}.`);
    }
    const column = referenceColumn(fitting[0], label);
    return [left, right].map((node) => ({ ...node, of: (row) => node.of(row, column) }));
  }

  arithmetic(left, sign, right, act) {
    const [a, b] = [left, right].map((node) => { if (node.unknown) throw node.unknown; return this.number(node, sign); });
    const merge = (key) => [...(a[key] ?? []), ...(b[key] ?? [])];
    return { type: "number", text: this.joined(a, sign, b), names: merge("names"), labels: merge("labels"), of: (row, reference) => act(a.of(row, reference), b.of(row, reference)) };
  }

  sum() {
    let left = this.product();
    while (this.peek("+", "-")) {
      const { kind } = this.next();
      left = this.arithmetic(left, kind, this.product(), kind === "+" ? (x, y) => x + y : (x, y) => x - y);
    }
    return left;
  }

  product() {
    let left = this.power();
    while (this.peek("*", "/")) {
      const { kind } = this.next();
      left = this.arithmetic(left, kind, this.power(), kind === "*" ? (x, y) => x * y : (x, y) => x / y);
    }
    return left;
  }

  power() {
    if (this.peek("-", "+")) {
      const { kind } = this.next();
      this.deeper();
      const node = this.arithmetic({ type: "number", text: "0", of: () => 0 }, kind, this.power(), kind === "-" ? (x, y) => x - y : (x, y) => x + y);
      this.depth--;
      return { ...node, text: node.text.slice(2) };
    }
    const base = this.atom();
    if (!this.peek("^")) return base;
    this.next();
    this.deeper();
    const node = this.arithmetic(base, "^", this.power(), (x, y) => x ** y);
    this.depth--;
    return node;
  }

  deeper() {
    if (++this.depth > 100) throw new FilterError("The filter has more than 100 expressions within each other; write it with fewer.");
  }

  atom() {
    const token = this.next();
    if (!token) throw new FilterError(`The filter ends where a name or a number should be; ${HELP}.`);
    if (token.kind === "number") return { type: "number", text: token.text, of: () => token.value };
    if (token.kind === "word") return { type: "word", text: `"${token.text}"`, of: () => token.text };
    if (token.kind === "(") return this.closed(() => this.either());
    if (token.kind === "name") return this.peek("(") && Object.hasOwn(FUNCTIONS, token.text) ? this.applied(token.text) : this.named(token.text);
    throw new FilterError(`The filter has “${token.text}” where a name or a number should be; ${HELP}.`);
  }

  closed(inner) {
    this.deeper();
    const node = inner();
    this.depth--;
    if (!this.peek(")")) throw new FilterError("The filter has an opening bracket without a closing one; add “)”.");
    this.next();
    return { ...node, text: `(${node.text})` };
  }

  applied(name) {
    this.next();
    const inner = this.number(this.closed(() => this.sum()), name);
    return { ...inner, text: `${name}${inner.text}`, of: (row, reference) => FUNCTIONS[name](inner.of(row, reference)) };
  }

  named(text) {
    const name = aliases.get(text) ?? text;
    if (quantities.has(name) || (orbits.has(name) && orbits.source[name].type === "number")) {
      const values = quantities.get(name)?.numbers() ?? orbits.numbers(name);
      return { type: "number", text, names: [name], of: (row) => values[row] };
    }
    if (orbits.has(name)) {
      const type = orbits.source[name].type === "bool" ? "truth" : "word";
      return { type, text, of: (row) => orbits.entry(name, row) };
    }
    if (referenceLabels.includes(name)) return { type: "number", text, label: true, labels: [name], of: (row, reference) => (reference ? reference[row] : NaN) };
    if (name === "true" || name === "false") return { type: "truth", text, of: () => name === "true" };
    if (Object.hasOwn(report.fixed, name)) return { type: "number", text, names: [name], of: () => report.fixed[name] };
    return { type: "word", text, of: () => null, unknown: new FilterError(`“${text}” is not a column of this sweep, a parameter${referenceLabels.length ? `, “${referenceLabels.join("”, “")}”` : ""} or “stable”; ${likeName(text)}`) };
  }
}

// Other ways to write names: symbols of parameters, and |μ|.
const aliases = new Map([
  ...model.parameters.filter(({ name, symbol }) => name !== symbol).map(({ name, symbol }) => [symbol, name]),
  ...(Object.hasOwn(report.fixed, "mu") || quantities.has("mu") ? [] : [["mu", "spectral_radius"], ["μ", "spectral_radius"]]),
]);

// The known name that is most like another one, as a question.
function likeName(text) {
  const known = [...quantities.keys(), ...Object.keys(orbits.source), ...Object.keys(report.fixed), ...referenceLabels];
  const distance = (a, b) => {
    let line = Array.from({ length: b.length + 1 }, (_, j) => j);
    for (let i = 1; i <= a.length; i++) {
      const next = [i];
      for (let j = 1; j <= b.length; j++) next[j] = Math.min(next[j - 1] + 1, line[j] + 1, line[j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1));
      line = next;
    }
    return line[b.length];
  };
  const lower = text.slice(0, 60).toLowerCase();
  const away = known.map((name) => [name.startsWith(lower) ? 0.5 : distance(lower, name.toLowerCase()), name]);
  const [least, name] = away.reduce((best, one) => (one[0] < best[0] ? one : best), [Infinity, ""]);
  return least <= Math.max(1, text.length / 3) ? `did you mean “${name}”?` : "the names stand under the filter.";
}

// From an expression to a function that says whether a row passes it; every row does where it is empty.
function compileFilter(text) {
  if (!text.trim()) return null;
  const parser = new FilterParser(text.slice(0, 2000));
  const node = parser.whole();
  if (node.unknown) throw node.unknown;
  return (row) => node.of(row) === true;
}
