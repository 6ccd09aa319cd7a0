"""How true the estimated errors are: ``python -m benchmarks.errors``.

Random limit cycles of several walkers, and as many of the wobbling walker as there are next to folds, where a
small error of the integration is a large one of the cycle. Each is held against the same cycle in numbers of
34 digits, at a resolution that leaves nothing to be seen of it. An estimate is true when it is within a
factor of 3 of the error, or when both are below `ROUNDING`.
"""

import argparse
import time

import numpy as np

from benchmarks.references import Reference
from stridemap.solver.branches.continuation import follow
from stridemap.solver.cycles.errors import differences, size
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.model.scales import Scales
from stridemap.solver.options import SearchOptions

FACTOR = 3.0
ROUNDING = 1e-13
"""Errors below it are rounding."""

FOLD_STEPS = 10
"""Halvings of the distance to a fold."""

RANGES = {
    "wobbling": {"k": (0.3, 60.0), "alpha": (0.05, 0.6), "omega": (1.5, 4.0)},
    "compass": {"omega": (2.0, 4.0), "S": (0.1, 0.25), "gamma": (0.1, 0.25)},
    "goswami_compass": {"mu": (0.5, 10.0), "beta": (0.3, 3.0), "slope": (0.01, 0.08)},
    "simplest_walker": {"slope": (0.001, 0.018)},
    "round_feet": {"radius": (0.05, 0.4), "slope": (0.003, 0.02), "leg_mass": (0.2, 1.0)},
}
"""Where cycles are drawn, by model and parameter; evenly in its logarithm."""

OTHERS = 0.1
"""Share of the cycles of each walker but the first."""


def drawn(solver: Solver, n: int, seed: int) -> Orbits:
    """`n` cycles of a model."""
    model, rng = solver.model, np.random.default_rng(seed)
    options = SearchOptions(starts=48, max_starts=48).resolved_for(model)
    parts: list[Orbits] = []
    while sum(map(len, parts)) < n:
        points = np.tile(model.point({}), (64, 1))
        for name, (low, high) in RANGES[model.name].items():
            values = np.exp(rng.uniform(np.log(low), np.log(high), len(points)))
            points[:, model.spec.names.index(name)] = values
        parts.append(find_all(solver, points, options)[1])
    return Orbits.concatenate(model, parts).take(np.arange(n))


def near_folds(solver: Solver, orbits: Orbits, options: SearchOptions) -> Orbits:
    """Cycles closer to the fold between two of a point, where there are two: half way, again and again."""
    column = solver.model.spec.names.index("k")
    inside, outside = orbits.params[:, column].copy(), orbits.params[:, column] * 0.7
    points, guesses = orbits.params.copy(), orbits.u.copy()
    for _ in range(FOLD_STEPS):
        points[:, column] = 0.5 * (inside + outside)
        start = points.copy()
        start[:, column] = inside
        begin = np.zeros(len(points))
        followed = follow(solver, guesses, begin, start, points, options.wider_period_range)
        ends = followed.crossings(np.array([0.0, 1.0]))
        arrived = ends.position == 1
        reached = ends.branch[arrived]
        there = np.zeros(len(points), dtype=bool)
        there[reached] = True
        guesses[reached] = ends.u[arrived]
        middle = points[:, column]
        inside, outside = np.where(there, middle, inside), np.where(there, outside, middle)
    points[:, column] = inside
    last = solver.converge(guesses, points, options.period_range)
    at_a_fold = np.abs(inside / orbits.params[:, column] - 0.7) > 1e-3
    return last.take(np.flatnonzero(last.found & at_a_fold))


def untrue(estimate: np.ndarray, error: np.ndarray) -> np.ndarray:
    """Which estimates are off by more than `FACTOR`."""
    tiny = (estimate < ROUNDING) & (error < ROUNDING)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = estimate / error
    return ~tiny & ~((ratio < FACTOR) & (ratio > 1 / FACTOR))


class Tally:
    """Estimates and errors of cycles of several models."""

    def __init__(self, title: str) -> None:
        self.title = title
        self.rows: list[np.ndarray] = []

    def add(self, orbits: Orbits) -> None:
        """Hold cycles of one model against exact ones."""
        exact = Reference(orbits.model).cycles(orbits.u, orbits.params)
        error = size((exact.u - orbits.u).astype(float), Scales.of(orbits.model).unknowns)
        of_multipliers = differences(orbits.multipliers, exact.multipliers)
        condition, poor = np.linalg.cond(orbits.jacobian), orbits.status == "inaccurate"
        columns = (orbits.state_error, error, orbits.multiplier_error, of_multipliers, condition, poor)
        self.rows.append(np.column_stack(columns).astype(float))

    def report(self) -> None:
        """Print how true they are."""
        *columns, condition, poor = np.concatenate(self.rows).T
        print(f"{len(poor)} cycles {self.title}: condition {np.median(condition):.1e} in the median, at most "
              f"{condition.max():.1e}; {poor.sum():.0f} inaccurate")  # fmt: skip
        for name, estimate, error in (("state_error", *columns[:2]), ("multiplier_error", *columns[2:])):
            wrong = untrue(estimate, error)
            below, above = wrong & (estimate < error), np.maximum(estimate, error) > ROUNDING
            print(
                f"  {name}: true for {100 * (1 - wrong.mean()):.2f} % ({above.sum()} above rounding), too "
                f"small for {below.sum()}, too large for {(wrong & ~below).sum()}; largest error "
                f"{error.max():.1e}"
            )
            for i in np.flatnonzero(wrong).tolist():
                print(f"    estimate {estimate[i]:.1e}, error {error[i]:.1e}, condition {condition[i]:.1e}")


def main() -> None:
    """Print the shares of true estimates, and what a cycle costs."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cycles", type=int, default=1000)
    parser.add_argument("--near", type=int, default=200, help="cycles led to folds, where there is one")
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    some, folds = Tally("at random"), Tally("next to folds")
    for name in RANGES:
        solver, first = Solver.for_model(load(name)), name == next(iter(RANGES))
        share = 1 - OTHERS * (len(RANGES) - 1) if first else OTHERS
        orbits = drawn(solver, round(share * options.cycles), options.seed)
        some.add(orbits)
        if first:
            begun = time.process_time()
            solver.converge(orbits.u + 1e-6, orbits.params, (0.0, np.inf))
            print(f"{1e6 * (time.process_time() - begun) / len(orbits):.0f} us of processor time per cycle")
            led = orbits.take(np.arange(min(options.near, len(orbits))))
            folds.add(near_folds(solver, led, SearchOptions().resolved_for(solver.model)))
    some.report()
    folds.report()


if __name__ == "__main__":
    main()
