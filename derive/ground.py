"""A walker that is declared upright, with its y-axis vertical, as seen from the ground that it walks on.

Everything that is derived and measured has the x-axis along the ground. A declaration with `ground` has it
horizontal; here its points and its gravity are turned.
"""

from copy import copy
from dataclasses import replace

import sympy as sp

from stridemap.derive.declaration import Declaration
from stridemap.derive.normal_form import normal_form
from stridemap.derive.parts import STANCE_FOOT
from stridemap.derive.simplify import PRODUCTS


def in_ground_frame(walker: Declaration) -> Declaration:
    """A declaration with the x-axis along the ground; the same one where it is so already.

    Parameters
    ----------
    walker : Walker
    """
    if walker.ground == 0:
        return walker
    level = walker.to_level
    places = dict(zip(STANCE_FOOT, level * STANCE_FOOT, strict=True))

    def turned(point: sp.Matrix) -> sp.Matrix:
        arm = point - STANCE_FOOT
        if arm.applyfunc(sp.expand).free_symbols & set(STANCE_FOOT):  # a place on the ground
            return (level.T * point.subs(places, simultaneous=True)).as_immutable()
        return (STANCE_FOOT + (level.T * arm.applyfunc(sp.expand)).applyfunc(_short)).as_immutable()

    changes = {
        "ground": sp.S.Zero,
        "gravity": (level.T * walker.gravity).as_immutable(),
        "bodies": tuple(replace(body, position=turned(body.position)) for body in walker.bodies),
        "swing_foot": turned(walker.swing_foot),
        "drawing": tuple(replace(line, points=tuple(map(turned, line.points))) for line in walker.drawing),
        "potentials": {name: v.subs(places, simultaneous=True) for name, v in walker.potentials.items()},
        "motors": tuple(
            replace(motor, drives=motor.drives.subs(places, simultaneous=True)) for motor in walker.motors
        ),
    }
    found = copy(walker)
    for name, value in changes.items():
        object.__setattr__(found, name, value)
    return found


def _short(expr: sp.Expr) -> sp.Expr:
    """Products of sines and cosines as those of sums."""
    found = normal_form(expr, PRODUCTS)
    return expr if found is None else found
