"""Where a walk begins: at a section point, just after a touchdown, or anywhere within a step."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError, short
from stridemap.solver.walks.equations import Equations

Array = NDArray[np.float64]

TIME = "t"
"""Entry of a start that says how long ago the last touchdown was."""

BELOW = 1e-9
"""How far below the ground a foot may be, in terms of the height of the centre of mass: rounding."""


def section_start(walker: Equations, state: Array) -> Array:
    """State of a section point, shape (2 n_q,).

    Raises
    ------
    InputError
        When it is not as many finite numbers as the section has entries.
    """
    z, model = np.asarray(state, dtype=np.float64), walker.model
    if z.shape != (len(model.section),) or not np.isfinite(z).all():
        raise InputError(
            f"the state {z.tolist()} is not allowed: {model.name} takes "
            f"{len(model.section)} finite numbers ({', '.join(model.section)})"
        )
    y = walker.start(z)
    if not np.isfinite(y).all():
        raise InputError(
            f"the state {short(z.tolist())} is not allowed: other entries follow from it, and are too "
            "large to be numbers"
        )
    return y


def start_within(walker: Equations, start: Mapping[str, Any]) -> tuple[float, Array]:
    """Time since the last touchdown, and state, shape (2 n_q,), of a start within a step.

    Parameters
    ----------
    walker : Equations
    start : mapping of str to float
        Every coordinate and every rate by name, save the rate of a clock, and ``t``, the time since the last
        touchdown; 0 if it is left out.

    Raises
    ------
    InputError
        When a name is missing or unknown, a value is not a finite number, the time is negative, the stance
        leg has fallen, or the swing foot is below the ground.
    """
    model = walker.model
    names = [e.name for e in (*model.spec.entries("q"), *model.spec.entries("v"))]
    given = dict(start)
    t = _number(TIME, given.pop(TIME, 0.0))
    if t < 0:
        raise InputError(f"{TIME} = {t:g} of the start is not allowed: the last touchdown lies in the past")
    if model.spec.phase is not None:
        given.setdefault(f"d{model.spec.phase}", _rate_of_the_clock(walker, f"d{model.spec.phase}"))
    if set(given) != set(names):
        missing, unknown = sorted(set(names) - set(given)), sorted(map(str, set(given) - set(names)))
        parts = [f"missing: {', '.join(missing)}"] if missing else []
        parts += [f"unknown: {', '.join(unknown)}"] if unknown else []
        raise InputError(
            f"a start within a step needs {', '.join(names)}, and may say {TIME}, the time since the last "
            f"touchdown; {'; '.join(parts)}"
        )
    y = np.array([_number(name, given[name]) for name in names])
    _check_above_ground(walker, y)
    return t, y


def _number(name: str, value: Any) -> float:
    good = isinstance(value, int | float | np.number) and not isinstance(value, bool)
    if not good or not np.isfinite(value):
        raise InputError(f"{name} = {value!r} of the start is not a finite number")
    return float(value)


def _rate_of_the_clock(walker: Equations, name: str) -> float:
    """A clock keeps its own rate, which the section knows."""
    box, model = walker.model.spec.search_box, walker.model
    y = walker.start(np.array([box[entry][0] for entry in model.section]))
    return float(y[[e.name for e in (*model.spec.entries("q"), *model.spec.entries("v"))].index(name)])


def _check_above_ground(walker: Equations, y: Array) -> None:
    """Refuse a start whose swing foot is below the ground, or has passed through it ahead."""
    stance = walker.model.stance_index
    if stance is not None and abs(y[stance]) > np.pi / 2:
        name = walker.model.coordinates[stance]
        raise InputError(
            f"{name} = {y[stance]:g} of the start is not allowed: the stance leg is beyond the horizontal"
        )
    height = walker.swing_foot(y)[0][1] - walker.ground
    h, _, side = walker.touchdown(y)
    slack = BELOW * abs(walker.centre_of_mass(y)[0][1])
    if height < -slack or (h > 0 and side < 0 and not walker.in_double_support(y) and height <= slack):
        where = f"{-height:g} {walker.model.spec.units.length} below" if height < -slack else "at or below"
        raise InputError(
            f"the start is not allowed: its swing foot is {where} the ground; give coordinates for which it "
            "is above (straight legs scuff through the ground near mid-stance: start before or after that)"
        )
