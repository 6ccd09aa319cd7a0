// Values to compare with, such as those of the walker without a wobbling mass, and where they hold.

const same = (a, b) => Math.abs(a - b) <= 1e-9 * Math.max(Math.abs(a), Math.abs(b));

const references = report.references.map((one) => ({
  ...one,
  // Pairs of an axis and a place on it; one at a value that the grid does not have is never met.
  at: Object.entries(one.parameters)
    .map(([name, value]) => [grid.axes.findIndex((axis) => axis.name === name), value])
    .filter(([axis]) => axis >= 0)
    .map(([axis, value]) => [axis, grid.axes[axis].values.findIndex((v) => same(v, value))]),
}));

const referenceLabels = [...new Set(references.map(({ label }) => label))];

// The reference of a quantity, by label, at the places of a cell on the axes; NaN where there is none.
function referenceAt(quantity, label, indices) {
  const found = references.find((one) => one.quantity === quantity && one.label === label && one.at.every(([axis, at]) => indices[axis] === at));
  return found ? found.value : NaN;
}

// Whether a quantity has any reference of a label.
const hasReference = (quantity, label) => references.some((one) => one.quantity === quantity && one.label === label);

// The reference of a quantity for every row; cells share it by the axes on which it depends.
const referenceColumns = new Map();

function referenceColumn(quantity, label) {
  const key = `${quantity} ${label}`;
  if (!referenceColumns.has(key)) {
    const known = new Map();
    const axes = [...new Set(references.filter((one) => one.quantity === quantity && one.label === label).flatMap(({ at }) => at.map(([axis]) => axis)))];
    const values = Float64Array.from(cellColumn, (cell) => {
      const indices = grid.indices(cell);
      const place = axes.map((axis) => indices[axis]).join();
      if (!known.has(place)) known.set(place, referenceAt(quantity, label, indices));
      return known.get(place);
    });
    referenceColumns.set(key, values);
  }
  return referenceColumns.get(key);
}
