"""What the tiles of a sweep have found, taken together: counts by cell, branches, and the tables.

The limit cycles themselves stay in the parts until the tables are written, which is done in pieces.
"""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from numpy.typing import NDArray

from stridemap.solver.cycles.degenerate import have_no_cycle, why_no_cycle
from stridemap.solver.cycles.status import CODES, STATUSES, Status
from stridemap.sweeps.config import SweepConfig
from stridemap.sweeps.connections import open_links
from stridemap.sweeps.families import families, with_smallest
from stridemap.sweeps.files import GROUP_ROWS, Pieces
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.merging import FirstSeen, ranges
from stridemap.sweeps.parts import orbit_columns, orbits_of
from stridemap.sweeps.solutions import Links
from stridemap.sweeps.special_tables import in_order, special_table_of
from stridemap.sweeps.store import Store
from stridemap.sweeps.tables import cell_schema, cell_table, orbit_schema
from stridemap.sweeps.tasks import Result

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


class Found:
    """What was found so far.

    Parameters
    ----------
    config : SweepConfig
    grid : Grid
    """

    def __init__(self, config: SweepConfig, grid: Grid) -> None:
        self.model, self.params, self.grid = config.loaded, config.params, grid
        self.options = config.search.options
        self.parts: list[tuple[int, int]] = []
        self.failures: dict[int, str] = {}
        # How many cycles, stable ones, and solutions of each status that were thrown away there are in cells.
        self.orbits, self.stable = (np.zeros(grid.n_cells, dtype=np.int32) for _ in range(2))
        self.discarded = np.zeros((grid.n_cells, len(STATUSES)), dtype=np.int32)
        self.n_orbits = 0
        self._branches = FirstSeen()
        self._joins = [np.empty((0, 2), dtype=np.int64)]
        self._links: list[Links] = []
        self._special: list[pa.Table] = []

    def counted(self, result: Result) -> int:
        """How many limit cycles of a result count."""
        return int(np.count_nonzero(self._counts(np.asarray(result.orbits["period"]))))

    def add(self, result: Result) -> None:
        """Take up a result that is stored as a part, in the order of rounds and of tiles."""
        self.parts.append((result.round, result.tile))
        self.failures |= result.failures
        for (where, status), n in result.discarded.items():
            self.discarded[where, CODES[Status(status)]] += n
        self._joins.append(result.joins)
        self._links.append(result.links)
        if len(special := special_table_of(self.model, result.special)):
            self._special.append(special)
        columns = (result.orbits[name] for name in ("branch", "cell", "period"))
        branch, cell, period = (np.asarray(column) for column in columns)
        counts = self._counts(period)
        stable = np.asarray(pc.fill_null(result.orbits["stable"], False))
        np.add.at(self.orbits, cell[counts], 1)
        np.add.at(self.stable, cell[counts & stable], 1)
        self._branches.add(branch[counts], cell[counts], period[counts])
        self.n_orbits += int(counts.sum())

    @property
    def joins(self) -> Ints:
        """Branches that are one with others, each with the smallest of its family, shape (n, 2)."""
        self._joins = [with_smallest(np.concatenate(self._joins))]
        return self._joins[0]

    def next_links(self) -> Links:
        """Links to be followed that have not been: one for each pair of families that may be one."""
        links = Links.concatenate(self._links, len(self.model.section) + 1)
        at = open_links(links, self.joins)
        self._links = [links.take(np.delete(np.arange(len(links)), at))]
        return links.take(at)

    def tables(self, store: Store) -> tuple[Pieces, Pieces, pa.Table]:
        """Limit cycles and cells, which are made as they are written, and special points.

        Parameters
        ----------
        store : Store
            Where the parts are.
        """
        special = pa.concat_tables([special_table_of(self.model, {}), *self._special])
        # Cycles come first: families of which there is none in a cell get the numbers after theirs.
        met, beside = self._branches.branches(), special["branch"].to_numpy()
        numbers = families(np.concatenate([met, beside]), self.joins)
        axis = self.grid.longest_axis
        width = float(np.ptp(self.grid.axes[axis])) or 1.0
        special = in_order(self.model, self.grid.names[axis], width, _numbered(special, numbers[len(met) :]))
        orbits = self._orbit_tables(store, met, numbers[: len(met)])
        cells = map(self._cell_table, range(0, self.grid.n_cells, GROUP_ROWS))
        return (
            Pieces(orbit_schema(self.model), self.n_orbits, orbits),
            Pieces(cell_schema(self.model), self.grid.n_cells, cells),
            special,
        )

    def _counts(self, period: Any) -> Any:
        """Whether a period is in the range that was asked for, and not just near it."""
        shortest, longest = self.options.period_range
        return (period > shortest) & (period <= longest)

    def _orbit_tables(self, store: Store, branches: Ints, families_: Ints) -> Iterator[pa.Table]:
        """All limit cycles in the order of ranges of cells, with the numbers of their families."""
        columns = orbit_columns(self.model)
        parts = (orbits_of(self.model, store.read_part(*one, columns)) for one in self.parts)
        counted = (part.filter(pa.array(self._counts(part["period"].to_numpy()))) for part in parts)
        order = np.argsort(branches)
        sorted_ = branches[order]
        for table in store.by_cells(counted, ranges(self.orbits)):
            at = order[np.searchsorted(sorted_, table["branch"].to_numpy())]
            numbered = [_numbered(table, families_[at])]
            del table  # what is written need not stay here
            yield numbered.pop()

    def _cell_table(self, first: int) -> pa.Table:
        """The table of so many cells as are written at a time."""
        cells = range(first, min(first + GROUP_ROWS, self.grid.n_cells))
        rows = slice(cells.start, cells.stop)
        points = self.grid.points(self.model, self.params, cells)
        found = self.orbits[rows]
        # Where a parameter is at an end of its allowed range, the equations may degenerate.
        ends = np.array([[one.lower, one.upper] for one in self.model.parameters], dtype=float).T
        asked = np.flatnonzero((points[:, None, :] == ends).any(axis=(1, 2)) & (found == 0))
        degenerate = np.zeros(len(cells), dtype=bool)
        degenerate[asked] = have_no_cycle(self.model, points[asked])
        status, reason = zip(*map(self._cell, cells, found.tolist(), points, degenerate), strict=True)
        counts = {"orbits": found, "stable_orbits": self.stable[rows]}
        return cell_table(self.model, points, counts, status, reason, first)

    def _cell(self, cell: int, found: int, point: Floats, degenerate: bool) -> tuple[str, str | None]:
        """Status of a cell, and why it is failed or empty, or lacks something."""
        if cell in self.failures:
            return "failed", self.failures[cell]
        thrown = dict(zip(Status, self.discarded[cell].tolist(), strict=True))
        if found:
            lost = thrown[Status.UNRESOLVED]
            return "found", f"not all: {_thrown_away({Status.UNRESOLVED: lost})}" if lost else None
        lower, upper = self.options.period_range
        why = (
            f"no limit cycle with {lower:g} < period <= {upper:g} was found, from the starts or from "
            "neighbouring cells"
        )
        if any(thrown.values()):
            why += f"; thrown away: {_thrown_away(thrown)}"
        return "empty", f"{why}; {why_no_cycle(self.model, point)}" if degenerate else why


def _numbered(table: pa.Table, branch: Ints) -> pa.Table:
    """A table with other numbers of branches."""
    column = table.schema.get_field_index("branch")
    return table.set_column(column, table.schema.field("branch"), pa.array(branch))


def _thrown_away(counts: Mapping[Status, int]) -> str:
    """How many solutions were no limit cycle, and why."""
    known = (status for status in Status if counts.get(status))
    return ", ".join(f"{counts[one]} solution{'' if counts[one] == 1 else 's'} {one.reason}" for one in known)
