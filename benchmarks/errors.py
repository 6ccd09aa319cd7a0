"""How true the estimated errors are: ``python -m benchmarks.errors``.

Random limit cycles of the wobbling walker, and as many that were led close to a fold, where a small error of
the integration is a large one of the cycle. Each is held against the same cycle at a much higher resolution.
An estimate is true when it is within a factor of 3 of what it estimates, or when both are rounding: below
`ROUNDING`, or below what a residual of `LAST_DIGITS` means for that cycle. The reference is no better there.
"""

import argparse
import time

import numpy as np

from stridemap.solver.branches.continuation import follow
from stridemap.solver.cycles import floquet
from stridemap.solver.cycles.errors import differences, inverted, size
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.model.scales import Scales
from stridemap.solver.options import SearchOptions

FACTOR = 3.0
ROUNDING = 1e-13
"""Errors below it are rounding."""

LAST_DIGITS = 4 * np.finfo(float).eps
"""Rounding of a residual."""

FOLD_STEPS = 10
"""Halvings of the distance to a fold."""

REFERENCE_N_RK = 768
RANGES = {"k": (0.3, 60.0), "alpha": (0.05, 0.6), "omega": (1.5, 4.0)}
"""Where cycles are drawn, by parameter; evenly in its logarithm."""


def drawn(solver: Solver, n: int, seed: int) -> Orbits:
    """`n` cycles."""
    model, rng = solver.model, np.random.default_rng(seed)
    options = SearchOptions(starts=48, max_starts=48).resolved_for(model)
    parts: list[Orbits] = []
    while sum(map(len, parts)) < n:
        points = np.tile(model.point({}), (64, 1))
        for name, (low, high) in RANGES.items():
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
        ends = follow(solver, guesses, start, points, options.wider_period_range)
        reached = ends.branch[ends.reached]
        there = np.zeros(len(points), dtype=bool)
        there[reached] = True
        guesses[reached] = ends.u[ends.reached]
        middle = points[:, column]
        inside, outside = np.where(there, middle, inside), np.where(there, outside, middle)
    points[:, column] = inside
    last = solver.converge(guesses, points, options.period_range)
    at_a_fold = np.abs(inside / orbits.params[:, column] - 0.7) > 1e-3
    return last.take(np.flatnonzero(last.found & at_a_fold))


def reference(solver: Solver, orbits: Orbits) -> tuple[np.ndarray, np.ndarray]:
    """Section points with periods and multipliers at a much higher resolution."""
    u = orbits.u.copy()
    for _ in range(5):
        jacobian, residual = solver.kernels.jacobian(REFERENCE_N_RK, u, orbits.params)
        u -= np.linalg.solve(jacobian, residual[:, :, None])[:, :, 0]
    return u, floquet.multipliers(solver.kernels.jacobian(REFERENCE_N_RK, u, orbits.params).jacobian)


def rounding(orbits: Orbits) -> np.ndarray:
    """What the rounding of a residual may move each cycle by, in terms of the scales."""
    scale = Scales.of(orbits.model).unknowns
    inverse = inverted(orbits.jacobian)
    return np.maximum(LAST_DIGITS * (np.abs(inverse).sum(axis=2) / scale).max(axis=1), ROUNDING)


def untrue(estimate: np.ndarray, error: np.ndarray, floor: np.ndarray) -> np.ndarray:
    """Which estimates are off by more than `FACTOR`."""
    tiny = (estimate < floor) & (error < floor)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = estimate / error
    return ~tiny & ~((ratio < FACTOR) & (ratio > 1 / FACTOR))


def report(solver: Solver, orbits: Orbits, title: str) -> None:
    """Print how true the estimates of some cycles are."""
    u, multipliers = reference(solver, orbits)
    scale, floor = Scales.of(solver.model).unknowns, rounding(orbits)
    condition = np.linalg.cond(orbits.jacobian)
    inaccurate = np.sum(orbits.status == "inaccurate")
    print(f"{len(orbits)} cycles {title}: condition {np.median(condition):.1e} in the median, at most "
          f"{condition.max():.1e}; {inaccurate} inaccurate")  # fmt: skip
    for name, estimate, error in (
        ("state_error", orbits.state_error, size(u - orbits.u, scale)),
        ("multiplier_error", orbits.multiplier_error, differences(orbits.multipliers, multipliers)),
    ):
        wrong = untrue(estimate, error, floor)
        below, above = wrong & (estimate < error), np.maximum(estimate, error) > floor
        print(
            f"  {name}: true for {100 * (1 - wrong.mean()):.2f} % ({above.sum()} above rounding), too small "
            f"for {below.sum()}, too large for {(wrong & ~below).sum()}; largest error {error.max():.1e}"
        )
        for i in np.flatnonzero(wrong)[:5].tolist():
            print(f"    estimate {estimate[i]:.1e}, error {error[i]:.1e}, rounding {floor[i]:.1e}")


def main() -> None:
    """Print the shares of true estimates, and what a cycle costs."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cycles", type=int, default=1000)
    parser.add_argument("--near", type=int, default=200, help="cycles next to folds")
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    solver = Solver.for_model(load("wobbling"))
    orbits = drawn(solver, options.cycles, options.seed)
    report(solver, orbits, "at random")
    search = SearchOptions().resolved_for(solver.model)
    if options.near:
        report(solver, near_folds(solver, orbits.take(np.arange(options.near)), search), "near folds")
    begun = time.process_time()
    solver.converge(orbits.u + 1e-6, orbits.params, (0.0, np.inf))
    print(f"{1e6 * (time.process_time() - begun) / len(orbits):.0f} us of processor time per complete cycle")


if __name__ == "__main__":
    main()
