"""What a declared motor is without its expressions: whether it gives a torque or a force, and its record."""

from typing import Literal

import sympy as sp

from stridemap import spec
from stridemap.derive.declaration import Declaration
from stridemap.derive.parts import STANCE_FOOT, Motor

_ANGLES = ("rad", "1", "deg")
_INVERSE = (sp.acos, sp.asin, sp.atan, sp.atan2)


def kind_of(walker: Declaration, motor: Motor) -> Literal["torque", "force"]:
    """Whether a motor drives an angle, with a torque, or a length, with a force.

    Where the declaration does not say it, units tell for what is linear in the coordinates, and else whether
    what it drives grows with the walker's lengths; where the lengths are plain numbers, the form tells.

    Parameters
    ----------
    walker : Walker
    motor : Motor
    """
    if motor.kind is not None:
        return motor.kind
    moving = motor.drives.free_symbols
    moved = [c for c in walker.coordinates if c.symbol in moving]
    linear = not any(motor.drives.diff(c.symbol).free_symbols & {*walker.q, *STANCE_FOOT} for c in moved)
    if moved and linear and not moving & set(STANCE_FOOT):
        return "torque" if all(c.unit in _ANGLES for c in moved) else "force"
    lengths = [c.symbol for c in walker.coordinates if c.unit == walker.units.length]
    lengths += [a.symbol for a in walker.parameters if a.unit == walker.units.length]
    lengths += list(STANCE_FOOT)
    if any(x in moving for x in lengths) and _grows(motor.drives, lengths):
        return "force"
    return "torque" if motor.drives.has(*_INVERSE) else "force"


def _grows(drives: sp.Expr, lengths: list[sp.Symbol]) -> bool:
    """Whether what is driven doubles with all lengths, at a point."""
    symbols = sorted(drives.free_symbols, key=str)
    point = {s: sp.Rational(7 + 3 * i, 11) for i, s in enumerate(symbols)}
    doubled = {s: 2 * x if s in lengths else x for s, x in point.items()}
    once, twice = (drives.subs(where).evalf() for where in (point, doubled))
    return bool(abs(twice - 2 * once) < 1e-9 * (1 + abs(once)))


def record(walker: Declaration, motor: Motor) -> spec.Motor:
    """What the specification says of a motor.

    Parameters
    ----------
    walker : Walker
    motor : Motor
    """
    kind = kind_of(walker, motor)
    return spec.Motor(
        name=motor.name,
        kind=kind,
        unit=walker.units.of_motor(kind),
        meaning=motor.meaning,
        drives=str(motor.drives),
        limit=None if motor.limit is None else float(motor.limit),
        efficiency=float(motor.efficiency),
    )
