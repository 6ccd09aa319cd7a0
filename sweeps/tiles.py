"""One piece of work of a sweep: all new limit cycles of a block of cells.

A pure function of its input, so that the result does not depend on who computes it, or when.
"""

from collections import Counter
from collections.abc import Callable, Sequence
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches import arcs_in_lanes
from stridemap.solver.branches.conditions import GaitConditions
from stridemap.solver.branches.continuation import Followed, Known, follow
from stridemap.solver.cycles.acceptance import CLEARLY, DOUBTFUL, clearly_no_gaits
from stridemap.solver.cycles.duplicates import DUPLICATE, SEARCH_TOLERANCE, backwards, first_of_each, grouped
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import starts
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.cycles.status import FOUND, STATUSES
from stridemap.solver.kernels.catalogue import CYCLE_N_RK
from stridemap.solver.model.scales import Scales
from stridemap.sweeps.apart import one_by_one
from stridemap.sweeps.changes import Stretches
from stridemap.sweeps.connections import ATTEMPTS, open_links
from stridemap.sweeps.families import with_smallest
from stridemap.sweeps.lines import Lines
from stridemap.sweeps.software import refuse_other
from stridemap.sweeps.solutions import NONE, SAME_BRANCH, Guesses, Links, Solutions
from stridemap.sweeps.special import Locator, SpecialPoint
from stridemap.sweeps.special_columns import special_columns
from stridemap.sweeps.tasks import Result, Task

_T = TypeVar("_T")
_S = TypeVar("_S", bound=Solutions)
Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

ACROSS = 16
"""Of at most so many solutions in a row along a branch, one is tried in the cells beside its own."""

BEYOND = 0.1
"""Of the distance between two cells: so far beyond a fold a cell is tried that the branch may pass."""

NEWTON_STEPS, NEWTON_STEPS_ACROSS = 7, 5
"""Newton steps at most from a start, and from where the tangent leads in a cell beside: a solution that is
there is near. Searches that do not close take most of the time, and nearly all of what a few more steps would
find is found from other starts, or along its branch."""

BESIDE = 0.2
"""A guess that is no farther from a known solution of its cell, in terms of scales, leads there: no search
begins at it."""

BRANCHES = 2**32
"""Numbers of branches that a tile has for its own."""


def work(task: Task) -> Result:
    """Search a tile until nothing new appears in it.

    Parameters
    ----------
    task : Task

    Returns
    -------
    Result
        A cell whose computation raises is a failure with its reason; the others are not affected.

    Raises
    ------
    CompilerError
        When the task's backend cannot be had here.
    WorkerError
        When this process runs other software than the one that made the task.
    """
    refuse_other(task.software)
    search = _Search(task)
    search.relax()
    cells, branch, orbits = search.gaits()
    special = search.special()
    return Result(
        task.round,
        task.tile,
        {"cell": cells, "branch": branch, **orbits.columns()},
        search.failures,
        search.new,
        search.outgoing,
        search.links,
        search.joins,
        special_columns(task.model, task.grid, task.params, special),
        dict(search.discarded),
    )


class _Search:
    """The search in one tile; grows the solutions of its cells."""

    def __init__(self, task: Task) -> None:
        self.task = task
        self.solver = Solver.for_model(task.model, task.backend, task.acceptance)
        self.scale = Scales.of(task.model).unknowns
        self.width = len(self.scale)
        # If a compiler fails, that is not the fault of some cells.
        self.solver.kernels.prepare_search_and_following()
        arcs_in_lanes.prepared(self.solver.kernels)
        self.lines = Lines.of(task.grid, task.cells)
        self.failures: dict[int, str] = {}
        self.discarded: Counter[tuple[int, str]] = Counter()
        self._known = [task.seen]
        self._landmarks = [task.seen.some_of_each_branch(ACROSS)]
        self._outgoing: list[Guesses] = []
        self._lost: list[Guesses] = []  # where a branch seemed to pass a cell and nothing was near
        self._beyond: list[Solutions] = []  # on no branch yet, from just beyond folds
        self._arrivals: list[tuple[Guesses, Solutions]] = []
        self.links = Links.empty(self.width)  # what following is to decide
        self._joins: list[tuple[Ints, Ints]] = []
        self._followed: list[tuple[Solutions, Followed]] = []
        self._next = task.tile * BRANCHES + len(np.unique(task.seen.branch))

    @property
    def known(self) -> Solutions:
        """All solutions so far, those of earlier rounds first."""
        if len(self._known) > 1:
            self._known = [self._all(self._known)]
        return self._known[0]

    @property
    def new(self) -> Solutions:
        """The solutions that this round has found."""
        return self.known.take(np.arange(len(self.task.seen), len(self.known)))

    @property
    def outgoing(self) -> Guesses:
        """Guesses for other tiles."""
        return self._guesses(self._outgoing)

    @property
    def joins(self) -> Ints:
        """Branches that are one with others, each with the smallest of its family, shape (n, 2)."""
        return with_smallest(
            np.concatenate([np.empty((0, 2), dtype=np.int64), *map(np.column_stack, self._joins)])
        )

    def relax(self) -> None:
        """Solve from guesses, follow what is new along its line, try what that gives beside it, and so on."""
        model, task = self.task.model, self.task
        made = [(cell, starts(model, task.search, cell)) for cell in task.seeds.tolist()]
        seeds = [
            Guesses(cells, u, np.full(len(u), NONE), cells)
            for cells, u in ((np.full(len(u), cell), u) for cell, u in made)
        ]
        guesses = self._guesses([task.incoming, *seeds])
        while len(guesses) or self._beyond:
            guesses = self._not_beside_known(guesses)
            arrived = self._one_by_one(self._solve, guesses, guesses.cell)
            self._arrivals += arrived
            beyond, self._beyond = self._beyond, []
            found = self._along_lines(self._all([*(solutions for _, solutions in arrived), *beyond]))
            lost, self._lost = self._lost, []
            guesses = self._guesses([self._across(found), *lost])
        self._link()

    def gaits(self) -> tuple[Ints, Ints, Orbits]:
        """New limit cycles: their cells, ascending, and branches."""
        shortest, longest = self.task.search.period_range
        margin = CLEARLY * self.scale[-1]
        new = self.new
        new = new.take((new.u[:, -1] > shortest - margin) & (new.u[:, -1] <= longest + margin))
        parts = self._one_by_one(self._converge, new, new.cell)
        found = self._all([cycles for cycles, _ in parts])
        order = np.argsort(found.cell, kind="stable")
        orbits = Orbits.concatenate(self.task.model, [orbits for _, orbits in parts])
        return found.cell[order], found.branch[order], orbits.take(order)

    def special(self) -> list[SpecialPoint]:
        """Special points on what was followed along lines."""
        if not self._followed or not self.task.special_points:
            return []
        grid, axis = self.task.grid, self.task.grid.longest_axis
        conditions = GaitConditions(self.solver.kernels, None, self.task.search.period_range)
        locator = Locator(conditions, grid.names[axis], *grid.axes[axis][[0, -1]].tolist())
        stretches = self._stretches()
        try:
            return locator.special_points(stretches)
        except Exception:
            out = []
            for one in np.unique(stretches.branch):
                part = stretches.take(stretches.branch == one)
                try:
                    out += locator.special_points(part)
                except Exception as error:
                    self.failures[int(part.cell[0])] = f"{type(error).__name__}: {error}"
            return out

    def _stretches(self) -> Stretches:
        """All that was followed along lines, as points at parameters."""
        lines, model, axis = self.lines, self.task.model, self.task.grid.longest_axis
        name = self.task.grid.names[axis]
        values = self.task.grid.axes[axis][lines.first : lines.last + 1]
        length, column = values[-1] - values[0], model.spec.names.index(name)
        parts, count = [], 0
        for begun, followed in self._followed:
            first = lines.line_of(begun.cell)[followed.branch]
            params = self._points(first)
            s = followed.x[:, -1]
            params[:, column] = np.where(s == 1, values[-1], values[0] + s * length)
            tangent = followed.tangent.copy()
            tangent[:, -1] *= length
            stretch = count + 2 * followed.branch + followed.ahead
            count += 2 * len(begun)
            parts.append((first, begun.branch[followed.branch], stretch, followed.x[:, :-1], params, tangent))
        cell, branch, stretch, u, params, tangent = (np.concatenate(c) for c in zip(*parts, strict=True))
        n_rk = self.solver.resolution.branch_n_rk(u[:, -1], self._fastest_modes(cell, params[:, column]))
        return Stretches(cell, branch, stretch, u, params, tangent, n_rk)

    def _fastest_modes(self, cell: Ints, values: Floats) -> Floats:
        """The faster of the fastest modes in the two cells between which each point of a line lies."""
        lines, axis = self.lines, self.task.grid.longest_axis
        first, line = np.unique(cell, return_inverse=True)
        places = np.arange(len(lines))
        cells = np.concatenate([lines.cell_at(np.full(len(lines), one), places) for one in first.tolist()])
        modes = self.solver.resolution.fastest_mode(self._points(cells)).reshape(len(first), -1)
        own = self.task.grid.axes[axis][lines.first : lines.last + 1]
        at = np.clip(np.searchsorted(own, values, "right") - 1, 0, len(own) - 2)
        return np.maximum(modes[line.ravel(), at], modes[line.ravel(), at + 1])

    def _not_beside_known(self, guesses: Guesses) -> Guesses:
        """Those that are not beside a known solution, to which the search would lead; links of the others."""
        row = guesses.same_as(self.known, BESIDE, self.scale)
        row[guesses.cell == guesses.origin] = NONE
        beside = np.flatnonzero(row != NONE)
        known = self.known.take(row[beside])
        self._arrivals.append((guesses.take(beside), Solutions(known.cell, known.u, guesses.branch[beside])))
        return guesses.take(row == NONE)

    def _solve(self, guesses: Guesses) -> tuple[Guesses, Solutions]:
        """Guesses that lead to solutions, and these."""
        u, points = guesses.u.copy(), self._points(guesses.cell)
        across = guesses.origin != guesses.cell
        u[across] = self.solver.predicted(u[across], self._points(guesses.origin[across]), points[across])
        closed = np.zeros(len(u), dtype=bool)
        for some, steps in ((~across, NEWTON_STEPS), (across, NEWTON_STEPS_ACROSS)):
            u[some], closed[some] = self.solver.quick_search(u[some], points[some], steps)
        at = np.flatnonzero(closed)
        kept, group = grouped(guesses.cell[at], u[at], SEARCH_TOLERANCE, backwards(u), self.scale)
        polished, moved = self.solver.polished(u[at[kept]], points[at[kept]])
        u[at], closed[at] = polished[group], (moved < np.inf)[group]
        shortest, longest = self.task.search.wider_period_range
        closed &= (u[:, -1] > shortest) & (u[:, -1] <= longest)
        return guesses.take(closed), Solutions(guesses.cell, u, guesses.branch).take(closed)

    def _along_lines(self, open_: Solutions) -> list[Solutions]:
        """Follow solutions that are not known along their lines, and enter all that this gives."""
        begun = self._numbered(self._distinct(self._unknown(open_)))
        self._enter(begun)
        return [begun, *self._one_by_one(self._follow, begun, self.lines.line_of(begun.cell))]

    def _follow(self, begun: Solutions) -> Solutions:
        """What following solutions along their lines in both directions gives, as far as it is not known."""
        lines = self.lines
        if len(lines) == 1:
            return begun.take(np.arange(0))
        first, last = (lines.cell_at(begun.cell, np.full(len(begun), i)) for i in (0, len(lines) - 1))
        followed = follow(
            self.solver,
            begun.u,
            lines.positions[lines.place_of(begun.cell)],
            self._points(first),
            self._points(last),
            self.task.search.wider_period_range,
            self.task.continuation,
            may_be_gaits=lambda u, params: self._clear_cases(u, params) == DOUBTFUL,
            known=self._landmarks_beside(begun),
        )
        self._followed.append((begun, followed))
        passed = followed.crossings(lines.positions, BEYOND * np.diff(lines.positions).min())
        cells = lines.cell_at(begun.cell[passed.branch], passed.position)
        branch = np.where(passed.beyond, NONE, begun.branch[passed.branch])
        guesses = Guesses(cells, passed.u, branch, cells)
        here = self._is_here(guesses.cell)
        self._outgoing.append(guesses.take(~here & ~passed.beyond))
        guesses = guesses.take(here)
        u, moved = self.solver.polished(guesses.u, self._points(guesses.cell))
        near, beyond = moved < SAME_BRANCH, guesses.branch == NONE
        solutions = Solutions(guesses.cell, u, guesses.branch)
        if (near & beyond).any():
            self._beyond.append(solutions.take(near & beyond))
        self._lost.append(guesses.take(~near & ~beyond))
        return self._entered(solutions.take(near & ~beyond))

    def _landmarks_beside(self, begun: Solutions) -> Known:
        """Some solutions of each known branch on the lines of those that begin."""
        lines, known = self.lines, self._all(self._landmarks)
        line, first = np.unique(lines.line_of(begun.cell), return_index=True)
        of = lines.line_of(known.cell)
        at = np.flatnonzero(np.isin(of, line))
        known = known.take(at)
        row = first[np.searchsorted(line, of[at])]
        return Known(known.u, lines.positions[lines.place_of(known.cell)], row)

    def _entered(self, solutions: Solutions) -> Solutions:
        """Enter those solutions that are not known; the branches of the others are known ones."""
        self._join(solutions)
        new = self._unknown(solutions)
        kept, group = grouped(new.cell, new.u, SEARCH_TOLERANCE, backwards(new.u), self.scale)
        self._joins.append((new.branch, new.branch[kept][group]))
        new = new.take(np.sort(kept))
        self._enter(new)
        return new

    def _across(self, found: list[Solutions]) -> Guesses:
        """Guesses in cells beside solutions of each branch; those for other tiles are handed on."""
        samples = self._all([part.some_of_each_branch(ACROSS) for part in found])
        self._landmarks.append(samples)
        row, cell = self.task.grid.beside(samples.cell)
        guesses = Guesses(cell, samples.u[row], samples.branch[row], samples.cell[row])
        here = self._is_here(cell)
        self._outgoing.append(guesses.take(~here))
        return guesses.take(here)

    def _link(self) -> None:
        """Note which branches of different lines, or of different tiles, are one, or may be."""
        guesses = self._guesses([part for part, _ in self._arrivals])
        arrived = self._all([part for _, part in self._arrivals])
        away = np.abs((arrived.u - guesses.u) / self.scale).max(axis=1, initial=0.0)
        along = guesses.origin == guesses.cell
        self._join(arrived.take(along & (away < SAME_BRANCH)))
        at = self._same(arrived)
        order = np.argsort(away, kind="stable")
        order = order[(~along & (at != NONE))[order]]
        one = guesses.take(order)
        links = Links(one.cell, one.u, one.branch, one.origin, self.known.branch[at[order]])
        self.links = links.take(open_links(links, self.joins, ATTEMPTS))

    def _converge(self, solutions: Solutions) -> tuple[Solutions, Orbits]:
        """Limit cycles that are not known, from solutions of the search."""
        points = self._points(solutions.cell)
        codes = self._clear_cases(solutions.u, points)
        doubtful = np.flatnonzero(codes == DOUBTFUL)
        orbits = self.solver.converge(
            solutions.u[doubtful], points[doubtful], self.task.search.wider_period_range
        )
        codes[doubtful] = orbits.codes
        lost = ~np.isin(codes, FOUND)
        for cell, code in zip(solutions.cell[lost].tolist(), codes[lost].tolist(), strict=True):
            self.discarded[cell, STATUSES[code].value] += 1
        at = np.flatnonzero(orbits.found)
        rows = doubtful[at]
        cycles = Solutions(solutions.cell[rows], orbits.u[at], solutions.branch[rows])
        # Newton's method at full resolution may have moved on to a cycle that is there already.
        kept = first_of_each(cycles.cell, cycles.u, DUPLICATE, None, self.scale)
        kept = kept[cycles.take(kept).same_as(self.task.known, DUPLICATE, self.scale) == NONE]
        return cycles.take(kept), orbits.take(at[kept])

    def _clear_cases(self, u: Floats, points: Floats) -> Ints:
        """Codes of the statuses of solutions that are clearly not gaits, `DOUBTFUL` for the others."""
        return clearly_no_gaits(self.solver.kernels, 2 * CYCLE_N_RK[0], u, points)

    def _one_by_one(self, method: Callable[[_S], _T], solutions: _S, group: Ints) -> list[_T]:
        """Apply a method to all solutions; where that raises, to those of each group by themselves."""
        return one_by_one(method, solutions, group, self.failures)

    def _numbered(self, solutions: Solutions) -> Solutions:
        """Solutions with numbers of branches of their own."""
        first = self._next
        self._next += len(solutions)
        return Solutions(solutions.cell, solutions.u, first + np.arange(len(solutions)))

    def _join(self, solutions: Solutions) -> None:
        """Note which branches are one, because a solution is known on another one."""
        at = self._same(solutions)
        both = np.flatnonzero((at != NONE) & (solutions.branch != NONE))
        self._joins.append((solutions.branch[both], self.known.branch[at[both]]))

    def _same(self, solutions: Solutions) -> Ints:
        """Rows of known solutions that are the same; `NONE` where there is none."""
        return solutions.same_as(self.known, SEARCH_TOLERANCE, self.scale)

    def _unknown(self, solutions: Solutions) -> Solutions:
        return solutions.take(self._same(solutions) == NONE)

    def _distinct(self, solutions: Solutions) -> Solutions:
        u = solutions.u
        return solutions.take(first_of_each(solutions.cell, u, SEARCH_TOLERANCE, backwards(u), self.scale))

    def _enter(self, solutions: Solutions) -> None:
        self._known.append(solutions)

    def _all(self, parts: Sequence[Solutions]) -> Solutions:
        return Solutions.concatenate(parts, self.width)

    def _guesses(self, parts: Sequence[Guesses]) -> Guesses:
        return Guesses.concatenate(parts, self.width)

    def _is_here(self, cells: Ints) -> NDArray[np.bool_]:
        return np.isin(cells, self.task.cells)

    def _points(self, cells: Ints) -> Floats:
        return self.task.grid.points(self.task.model, self.task.params, cells)
