"""Whether special points are what they are called: ``python -m benchmarks.special_points``.

Branches over a random parameter are followed from random parameters of each built-in model. Each of their
special points is asked for the residual of the equations that define it, and for being truly crossed: on the
branch, shortly before and after it, what it is named for has different signs. For some bifurcations of stable
gaits the event-driven simulator, which knows of neither derivatives nor branches, walks from beside the cycle
on either side: a small displacement has to shrink on one and grow on the other.
"""

import argparse
from collections import Counter
from dataclasses import dataclass, field

import numpy as np

import stridemap
from stridemap.solver.branches.arclength import CurvePoint, advanced
from stridemap.solver.branches.bifurcation import SpecialType
from stridemap.solver.branches.branches import Branches, SpecialPoint
from stridemap.solver.branches.conditions import GaitConditions, GaitEnd
from stridemap.solver.branches.special import tests, unstable_count
from stridemap.solver.branches.survey import Branch
from stridemap.solver.model.loading import available, load
from stridemap.solver.model.model import Model

RESIDUAL = 1e-11
"""Largest residual of a special point."""

BESIDE = (1e-3, 1e-4, 1e-5)
"""Arclengths before and after a special point at which signs are compared: the first at which it is alone."""

SINGULAR = 1e-6
"""Largest share of the smallest singular value in the largest one at a branch point."""

APART = (0.003, 0.01, 0.03, 0.1)
"""Arclengths at which walks begin beside a bifurcation: the first at which the multiplier is `CLEAR` of 1."""

CLEAR = 0.02
"""Least distance of the largest modulus from 1 on either side."""

DISPLACED = 1e-6
"""Of the section's scales: what a walk begins beside its cycle."""

SETTLING = 10
"""Cycles after which only the largest multipliers are left of a displacement."""


@dataclass
class Tally:
    """What was seen so far."""

    branches: int = 0
    types: Counter[str] = field(default_factory=Counter)
    residual: float = 0.0
    walked: int = 0
    faults: list[str] = field(default_factory=list)


def random_problem(rng: np.random.Generator) -> tuple[Model, str, tuple[float, float], dict[str, float]]:
    """A model, a parameter with a range, and the others, all near the preset."""
    model = load(str(rng.choice(available())))
    real = [p for p in model.parameters if p.default > 0 and not p.counts]
    varies = real[rng.integers(len(real))]
    params = {}
    for p in real:
        value = p.default * rng.uniform(0.85, 1.15)
        params[p.name] = min(value, p.upper) if p.upper is not None else value
    low, high = varies.default * 0.6, varies.default * 1.5
    del params[varies.name]
    return model, varies.name, (low, high if varies.upper is None else min(high, varies.upper)), params


def beside(branch: Branch, one: SpecialPoint, ds: float) -> tuple[CurvePoint, CurvePoint] | None:
    """The points of a branch at an arclength before and after a special point."""
    curve = branch.curve
    start = branch.points[max(int(np.searchsorted(branch.arclength, one.arclength)) - 1, 0)]
    way = curve.dot(unknowns(one) - start.x, start.tangent)
    before, after = (advanced(curve, start, way + side * ds, 8) for side in (-1, 1))
    return None if before is None or after is None else (before, after)


def unknowns(one: SpecialPoint) -> np.ndarray:
    """Unknowns of a special point, and its value of the parameter."""
    return np.append(np.ravel(one.steps), one.value)


def is_crossed(branch: Branch, one: SpecialPoint, conditions: GaitConditions) -> bool:
    """Whether what a special point is named for changes its sign there."""
    if one.type == SpecialType.BP:
        x = unknowns(one)
        matrix, _ = branch.curve.linearised(x, branch.curve.n_rk(x))
        values = np.linalg.svd(matrix * branch.curve.scale, compute_uv=False)
        return bool(values[-1] < SINGULAR * values[0])
    for ds in BESIDE:
        sides = beside(branch, one, ds)
        if sides is None:
            continue
        if one.type in tuple(SpecialType):
            first, second = (tests(branch.curve, side)[SpecialType(one.type)] for side in sides)
        else:
            name, chain = GaitEnd(one.type), branch.curve.chain
            first, second = (
                conditions.of_cycles(
                    [side.n_rk],
                    side.x[None, :-1],
                    branch.curve.equations.point(side.x[-1])[None, :],
                    chain.n_steps,
                    [name],
                )[name][0]
                for side in sides
            )
        if first * second < 0:
            return True
    return False


def rate(model: Model, branch: Branch, point: CurvePoint, rng: np.random.Generator) -> tuple[float, float]:
    """By how much a displacement grows per cycle, in a logarithm: as it is walked, and as multipliers say."""
    largest = float(np.log(np.abs(point.multipliers).max()))
    n, scales = branch.period_n, np.asarray(model.spec.scales)
    cycles = int(min(np.ceil(5 / abs(largest)), 200)) + SETTLING
    state = branch.curve.equations.steps(point.x)[0, :-1]
    params = dict(zip(model.spec.names, branch.curve.equations.point(point.x[-1]).tolist(), strict=True))
    names = model.section
    begin = state + DISPLACED * scales * rng.standard_normal(len(names))
    walk = stridemap.simulate(model, dict(zip(names, begin, strict=True)), steps=cycles * n, params=params)
    states = np.array([[step.state[name] for name in names] for step in walk.steps])[n - 1 :: n]
    if len(states) < cycles:
        return np.inf, largest  # it fell
    # A pair of complex multipliers turns the displacement round while it grows or shrinks.
    away = np.log(np.sqrt((((states - state) / scales) ** 2).sum(axis=1)))[SETTLING:]
    slope = np.polyfit(np.arange(len(away)), away, 1)[0]
    return float(slope), largest


def walks_agree(model: Model, branch: Branch, one: SpecialPoint, rng: np.random.Generator) -> bool | None:
    """Whether walks on both sides of a bifurcation say what it says; None where no side is stable."""
    for ds in APART:
        sides = beside(branch, one, ds)
        if sides is None:
            return None
        sizes = [np.abs(side.multipliers).max() for side in sides]
        if min(sizes) < 1 - CLEAR and max(sizes) > 1 + CLEAR and min(map(unstable_count, sides)) == 0:
            pairs = [rate(model, branch, side, rng) for side in sides]
            return all(walked * said > 0 for walked, said in pairs)
    return None


def examine(found: Branches, tally: Tally, walks: int, rng: np.random.Generator) -> None:
    """Ask all special points of branches, and walk beside some of them."""
    where = f"{found.model.name} over {found.vary}, {found.params}"
    for number, branch in enumerate(found):
        conditions = GaitConditions(branch.curve.chain.kernels, None, (0.0, np.inf))
        tally.branches += 1
        for one in (one for one in found.special if one.branch == number):
            tally.types[one.type] += 1
            tally.residual = max(tally.residual, one.residual)
            what = f"{one.type} at {one.value:.12g} of branch {number}, {where}"
            if not one.residual < RESIDUAL:
                tally.faults.append(f"residual {one.residual:.1e}: {what}")
            if not is_crossed(branch, one, conditions):
                tally.faults.append(f"not crossed: {what}")
            if one.gait and one.type in ("fold", "pd", "ns") and tally.walked < walks:
                agree = walks_agree(found.model, branch, one, rng)
                tally.walked += agree is not None
                if agree is False:
                    tally.faults.append(f"walks beside it say otherwise: {what}")


def main() -> None:
    """Follow random branches and print what does not hold."""
    parser = argparse.ArgumentParser(description="Examine the special points of random branches.")
    parser.add_argument("--branches", type=int, default=1000)
    parser.add_argument("--walks", type=int, default=50)
    parser.add_argument("--seed", type=int, default=0)
    arguments = parser.parse_args()
    rng, tally, shown = np.random.default_rng(arguments.seed), Tally(), 0
    while tally.branches < arguments.branches:
        model, varies, ends, params = random_problem(rng)
        found = stridemap.branches(
            model, varies, ends, params, seeds=2, cascade=1, search=stridemap.SearchOptions(starts=64)
        )
        examine(found, tally, arguments.walks, rng)
        for fault in tally.faults[shown:]:
            print(fault, flush=True)
        shown = len(tally.faults)
    counts = ", ".join(f"{n} {name}" for name, n in tally.types.most_common())
    print(
        f"{tally.branches} branches, {tally.types.total()} special points ({counts}); largest residual "
        f"{tally.residual:.1e}; walked beside {tally.walked}; {len(tally.faults)} do not hold"
    )


if __name__ == "__main__":
    main()
