"""The frame of a declaration: the swing foot touches down on the x-axis, which is the ground.

In another frame state, period and multipliers come out right, and the cost of transport, the friction and the
clearance do not. So it is tried at some touchdowns, with the parameters' defaults and with others.
"""

import math
from collections.abc import Mapping
from itertools import islice

import sympy as sp

from stridemap.derive.declaration import Declaration
from stridemap.derive.parts import STANCE_FOOT
from stridemap.derive.trials import compiled
from stridemap.derive.validate.mechanics import TOLERANCE, touchdowns
from stridemap.derive.validate.refusal import refuse

TOUCHDOWNS = 6
"""Touchdowns that are looked at; on stairs, whose condition has other zeros too, all that are found."""

Values = Mapping[sp.Symbol, float]


def validate_gravity(walker: Declaration) -> None:
    """Gravity points straight down where the declaration says how the ground falls.

    Parameters
    ----------
    walker : Walker

    Raises
    ------
    InputError
        When it does not.
    """
    if walker.ground != 0 and sp.simplify(walker.gravity[0]) != 0:
        refuse(
            walker,
            f"gravity is {list(walker.gravity)} and ground is {walker.ground}: where ground says how the "
            "ground falls, points and gravity are those of somebody who stands upright; give "
            "gravity = (0, -g), or leave ground out and write all points along the ground",
        )


def validate_ground(walker: Declaration, declared: Declaration) -> None:
    """The swing foot is on the ground at touchdown, or as much higher as stairs are.

    Parameters
    ----------
    walker : Walker
        With the x-axis along the ground.
    declared : Walker
        As it was written.

    Raises
    ------
    InputError
        When it is not.
    """
    defaults = {a.symbol: float(a.default) for a in walker.parameters}
    for values in (defaults, _moved(walker)):
        feet = _feet(walker, values)
        if not feet:
            continue
        try:
            rise = float(walker.rise.subs(values).evalf())
        except TypeError:
            refuse(
                walker,
                f"rise is {walker.rise}, which is not a number with the parameters' defaults; correct it",
            )
        sizes = [TOLERANCE * (1e-3 + math.hypot(x, y)) for x, y in feet]
        # A condition for stairs has zeros below the ground, too: where the foot that was left stands.
        level = all(abs(abs(y) - abs(rise)) <= size for (_, y), size in zip(feet, sizes, strict=True))
        if level and any(abs(y - rise) <= size for (_, y), size in zip(feet, sizes, strict=True)):
            continue
        changed = [a.name for a in walker.parameters if values[a.symbol] != defaults[a.symbol]]
        where = f" (with {', '.join(f'{n} = {values[sp.Symbol(n, real=True)]:.4g}' for n in changed)})"
        refuse(walker, _sentence(declared, feet, rise, where if changed else ""))


def _moved(walker: Declaration) -> dict[sp.Symbol, float]:
    """Every parameter away from its default, within its range."""
    values = {}
    for i, a in enumerate(walker.parameters):
        default, change = float(a.default), (0.02 + 0.04 * abs(a.default)) * (1 + 0.3 * math.cos(i))
        for candidate in (default + change, default - change, default):
            above = a.lower is None or candidate > a.lower
            if above and (a.upper is None or candidate < a.upper):
                values[a.symbol] = candidate
                break
        else:
            values[a.symbol] = default
    return values


def _feet(walker: Declaration, values: Values) -> list[tuple[float, float]]:
    """Where the swing foot is from the stance foot, at some touchdowns."""
    places = dict(zip(STANCE_FOOT, walker.stance, strict=True))
    foot = compiled(walker, sp.Matrix(walker.swing_foot).subs(places) - walker.stance)
    feet = []
    for before in islice(touchdowns(walker, values), TOUCHDOWNS if walker.rise == 0 else None):
        try:
            x, y = map(float, foot({**values, **before}))
        except TypeError:
            continue
        feet.append((x, y))
    return feet


def _sentence(walker: Declaration, feet: list[tuple[float, float]], rise: float, where: str) -> str:
    """What is wrong, and the cure that fits it."""
    x, y = max(feet, key=lambda foot: abs(foot[1] - rise))
    start = f"at touchdown{where} the swing foot is at a height of {y:.6g}, {x:.6g} ahead, and must be "
    start += f"at {rise:.6g}, the rise" if rise else "at 0, on the x-axis, which lies along the ground"
    if walker.ground != 0:
        return f"{start}; correct ground = {walker.ground}, the touchdown's condition or swing_foot"
    angles = [math.atan2(-y, x) if x > 0 else math.atan2(y, -x) for x, y in feet]
    if not rise and max(angles) - min(angles) < 1e-7:
        return (
            f"{start}. It touches down on ground that falls by {angles[0]:.6g} rad: give ground = that angle "
            "in terms of parameters, with gravity straight down, (0, -g); for stairs give rise = the height "
            "of a step in place of it"
        )
    heights = [abs(y) for _, y in feet]
    if max(heights) - min(heights) < 1e-7:
        return f"{start}; for stairs give rise = the height of a step (negative where they lead down)"
    return f"{start}; correct the touchdown's condition, swing_foot or ground"
