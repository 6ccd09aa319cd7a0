"""All limit cycles at points of parameter space: many starts, Newton's method, duplicates merged."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.stats import qmc

from stridemap.errors import InputError
from stridemap.solver.cycles.orbit import Orbit
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]

STARTS_MAX = 1_000_000
STARTS_PER_SECOND = 5_000
"""Assumed speed of the search, used only to say what too many starts would cost."""

DUPLICATE = 1e-6
"""Largest difference, in any section coordinate or the period, between two solutions that are one."""

SEARCH_TOLERANCE = 10 * DUPLICATE
"""The same for solutions of a search, which stops early."""


@dataclass(frozen=True)
class SearchOptions:
    """Options of the search for all limit cycles at a point.

    Parameters
    ----------
    starts : int
        Number of quasi-random starts a point.
    seed : int
        Seed of their scrambling.
    period_min, period_max : float or None
        Periods that count: ``period_min < T <= period_max``; what is None is taken from the model.

    Raises
    ------
    InputError
        For values out of range.
    """

    starts: int = 512
    seed: int = 0
    period_min: float | None = None
    period_max: float | None = None

    def __post_init__(self) -> None:
        if self.starts < 1:
            raise InputError(f"starts = {self.starts} is not allowed: at least 1 start is needed")
        if self.starts > STARTS_MAX:
            hours = self.starts / STARTS_PER_SECOND / 3600
            raise InputError(
                f"starts = {self.starts:,} is not allowed: at most {STARTS_MAX:,} (so many would take about "
                f"{hours:.2g} hours a point); a few hundred find nearly every cycle"
            )
        low, high = self.period_range
        if not (0 < low < np.inf and low < high <= np.inf) or self.period_max == np.inf:
            raise InputError(
                f"the period range {low:g} to {high:g} is not allowed: 0 < period_min < period_max"
            )

    def of(self, model: Model) -> "SearchOptions":
        """These options, with the model's period range where none is given."""
        low, high = model.period_range
        return replace(
            self,
            period_min=low if self.period_min is None else self.period_min,
            period_max=high if self.period_max is None else self.period_max,
        )

    @property
    def period_range(self) -> tuple[float, float]:
        """(period_min, period_max); an end that is not given is the least or the greatest possible."""
        low = np.nextafter(0, 1) if self.period_min is None else self.period_min
        return float(low), np.inf if self.period_max is None else self.period_max

    @property
    def wider_period_range(self) -> tuple[float, float]:
        """A range in which a sweep follows branches that leave the range and come back."""
        low, high = self.period_range
        return 0.85 * low, 1.15 * high


def starts(model: Model, options: SearchOptions, point: int = 0) -> Array:
    """Quasi-random starts over the model's search box and the range of periods.

    Periods are spread evenly; section points crowd around the middle of the box, where gaits are, without
    leaving out its edges.

    Parameters
    ----------
    model : Model
    options : SearchOptions
    point : int
        Points of a grid may get starts of their own.

    Returns
    -------
    ndarray, shape (options.starts, nz + 1)
        Section points with periods (Sobol points, scrambled).
    """
    box = np.array([model.spec.search_box[name] for name in model.section])
    sobol = qmc.Sobol(len(box) + 1, rng=np.random.default_rng([options.seed, point]))
    # Sobol points are balanced in powers of two; a part of them is cut off.
    unit = sobol.random_base2(int(np.ceil(np.log2(options.starts))))[: options.starts]
    section = box[:, 0] + box[:, 1] * (2 * unit[:, :-1] - 1) ** 3
    shortest, longest = options.of(model).period_range
    period = shortest + (longest - shortest) * unit[:, -1:]
    return np.hstack([section, period])


def find_orbits(model: Model, points: Array, options: SearchOptions | None = None) -> list[list[Orbit]]:
    """All limit cycles at each of n points.

    Parameters
    ----------
    model : Model
    points : ndarray, shape (n, n_parameters)
    options : SearchOptions, optional

    Returns
    -------
    list of list of Orbit
        For each point its limit cycles, ordered by period.
    """
    options = (options or SearchOptions()).of(model)
    if not len(points):
        return []
    solver = Solver.of(model)
    cell = np.repeat(np.arange(len(points)), options.starts)
    # The same starts for each: what is found at a point does not depend on the others.
    u, closed = solver.search(np.tile(starts(model, options), (len(points), 1)), points[cell])
    cell, u = distinct(cell[closed], u[closed])
    orbits = solver.complete(u, points[cell], options.period_range)
    return merge(len(points), cell, orbits)


def offer(model: Model, points: Array, guesses: Array, options: SearchOptions | None = None) -> list[Orbit]:
    """One limit cycle a point, from a guess; failures are values with their reason.

    Parameters
    ----------
    model : Model
    points : ndarray, shape (n, n_parameters)
    guesses : ndarray, shape (n, nz + 1)
        Section point and period.
    options : SearchOptions, optional

    Returns
    -------
    list of Orbit, length n
    """
    options = (options or SearchOptions()).of(model)
    solver = Solver.of(model)
    u, _ = solver.search(guesses, points)
    return solver.complete(u, points, options.period_range)


def distinct(
    cell: NDArray[np.int64], u: Array, tolerance: float = SEARCH_TOLERANCE
) -> tuple[NDArray[np.int64], Array]:
    """One of each set of solutions of the same cell that agree, in the order of cell, then period.

    Parameters
    ----------
    cell : ndarray of int, shape (n,)
    u : ndarray, shape (n, nz + 1)
    tolerance : float
    """
    order = np.lexsort((*u.T[:-1], u[:, -1], cell))
    kept: list[int] = []
    first = 0
    for i in order:
        while first < len(kept) and (
            cell[kept[first]] != cell[i] or u[i, -1] - u[kept[first], -1] > tolerance
        ):
            first += 1
        if all(np.abs(u[i] - u[j]).max() > tolerance for j in kept[first:]):
            kept.append(int(i))
    return cell[kept], u[kept]


def merge(n: int, cell: Sequence[int] | NDArray[np.int64], orbits: Sequence[Orbit]) -> list[list[Orbit]]:
    """Found limit cycles of each of n cells without duplicates, ordered by period.

    Parameters
    ----------
    n : int
    cell : sequence of int
        Cell of each orbit.
    orbits : sequence of Orbit
    """
    out: list[list[Orbit]] = [[] for _ in range(n)]
    # Failures go first: a period that is not a number has no place in an order.
    found = [(c, orbit) for c, orbit in zip(cell, orbits, strict=True) if orbit.status.found]
    for c, orbit in sorted(found, key=lambda pair: _key(pair[1])):
        if not any(same(orbit, other) for other in out[c]):
            out[c].append(orbit)
    return out


def same(one: Orbit, other: Orbit) -> bool:
    """Whether two orbits at one point are the same cycle."""
    if abs(one.period - other.period) > DUPLICATE:
        return False
    return all(abs(value - other.state[name]) <= DUPLICATE for name, value in one.state.items())


def section_point(orbit: Orbit) -> list[float]:
    """Section point and period of an orbit: a guess for its neighbours."""
    return [*orbit.state.values(), orbit.period]


def _key(orbit: Orbit) -> tuple[float, ...]:
    return (orbit.period, *orbit.state.values())
