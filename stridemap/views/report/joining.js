// Cycles of neighbouring columns that are one after the other on a branch, so that a line may join them.

const JOINED = { far: 0.25, clear: 0.5 };

// What tells two cycles of one branch apart: its section point and its period, in parts of their ranges.
class States {
  constructor(rows) {
    const names = [...model.section.map(({ name }) => name), "period"];
    this.columns = names.map((name) => orbits.numbers(name));
    this.ranges = this.columns.map((column) => {
      const values = rows.map((row) => column[row]);
      return values.reduce((a, b) => Math.max(a, b), -Infinity) - values.reduce((a, b) => Math.min(a, b), Infinity) || 1;
    });
  }

  distance(one, other) {
    return Math.hypot(...this.columns.map((column, i) => (column[one] - column[other]) / this.ranges[i]));
  }
}

// Pairs of rows to join: `rows` are pairs [column, row]. Two cycles of one branch in one column lie on both sides of
// a fold. So each is joined to the nearest one of the next column, if it is the nearest to that one as well, clearly
// nearer than any other, and near at all. Nothing is joined across a column without a cycle of the branch.
function joined(rows) {
  if (!orbits.has("branch") || rows.length < 2) return [];
  const branch = orbits.numbers("branch");
  return joinedBy(rows, (row) => branch[row], new States(rows.map(([, row]) => row)));
}

function joinedBy(rows, branchOf, states) {
  const places = new Map();
  for (const [column, row] of rows) {
    const key = `${branchOf(row)}:${column}`;
    if (!places.has(key)) places.set(key, []);
    places.get(key).push(row);
  }
  const pairs = [];
  for (const [key, here] of places) {
    const [number, column] = key.split(":").map(Number);
    const there = places.get(`${number}:${column + 1}`);
    if (there) pairs.push(...nearestPairs(here, there, states));
  }
  return pairs;
}

function nearestPairs(here, there, states) {
  const away = here.map((one) => there.map((other) => states.distance(one, other)));
  const least = (values) => values.reduce((best, value, i) => (value < values[best] ? i : best), 0);
  return here.flatMap((one, i) => {
    const j = least(away[i]);
    const column = away.map((line) => line[j]);
    if (least(column) !== i || away[i][j] > JOINED.far) return [];
    const others = [...away[i].filter((_, k) => k !== j), ...column.filter((_, k) => k !== i)];
    return others.some((value) => away[i][j] > JOINED.clear * value) ? [] : [[one, there[j]]];
  });
}
