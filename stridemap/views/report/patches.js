// Patches of cells of one group: where its letter stands, and where the border to another group runs.

// The cells of each connected patch that bears one letter: [letter, [[column, row], ...]].
function patchesOf(letters) {
  const seen = letters.map((row) => row.map(() => false));
  const found = [];
  for (let r = 0; r < letters.length; r++) {
    for (let c = 0; c < letters[r].length; c++) {
      if (!letters[r][c] || seen[r][c]) continue;
      const letter = letters[r][c];
      const [patch, open] = [[], [[c, r]]];
      while (open.length) {
        const [x, y] = open.pop();
        if (letters[y]?.[x] !== letter || seen[y][x]) continue;
        seen[y][x] = true;
        patch.push([x, y]);
        open.push([x + 1, y], [x - 1, y], [x, y + 1], [x, y - 1]);
      }
      found.push([letter, patch]);
    }
  }
  return found;
}

// How many steps each cell is from one of another letter.
function depthsOf(letters) {
  const depths = letters.map((row) => new Uint16Array(row.length));
  const [rows, columns] = [letters.length, letters[0].length];
  const step = (r, c, other, at) => (letters[other]?.[at] === letters[r][c] ? depths[other][at] + 1 : 1);
  for (let r = 0; r < rows; r++) for (let c = 0; c < columns; c++) depths[r][c] = Math.min(step(r, c, r - 1, c), step(r, c, r, c - 1));
  for (let r = rows - 1; r >= 0; r--) {
    for (let c = columns - 1; c >= 0; c--) depths[r][c] = Math.min(depths[r][c], step(r, c, r + 1, c), step(r, c, r, c + 1));
  }
  return depths;
}

// The cell of a patch that lies deepest within it; of several, the one nearest to their middle.
function deepest(patch, depths) {
  const depth = patch.reduce((most, [c, r]) => Math.max(most, depths[r][c]), 0);
  const left = patch.filter(([c, r]) => depths[r][c] === depth);
  const mean = (i) => left.reduce((sum, cell) => sum + cell[i], 0) / left.length;
  const middle = [mean(0), mean(1)];
  const away = ([c, r]) => Math.hypot(c - middle[0], r - middle[1]);
  return left.reduce((best, cell) => (away(cell) < away(best) ? cell : best));
}

// Edges between cells of different groups, as pairs of the cell and the side on which its neighbour lies.
function bordersOf(letters) {
  const found = [];
  for (let r = 0; r < letters.length; r++) {
    for (let c = 0; c < letters[r].length; c++) {
      for (const [side, other] of [["right", letters[r][c + 1]], ["top", letters[r + 1]?.[c]]]) {
        if (letters[r][c] && other && other !== letters[r][c]) found.push([c, r, side]);
      }
    }
  }
  return found;
}
