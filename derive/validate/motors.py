"""Motors that contradict themselves, each other or the walker are refused.

What their expressions may hold is checked with all others in `names`.
"""

import math

import mpmath
import sympy as sp

from stridemap.derive.declaration import Declaration
from stridemap.derive.motors import record
from stridemap.derive.parts import STANCE_FOOT, Motor
from stridemap.derive.trials import in_numbers, trial_points
from stridemap.derive.validate.mechanics import TOLERANCE
from stridemap.derive.validate.refusal import refuse
from stridemap.derive.validate.reserved import meaning
from stridemap.derive.validate.shared_torques import validate_torques
from stridemap.quantities import LIMIT_USE, of_motor
from stridemap.words import ATTRIBUTES


def validate_motors(walker: Declaration) -> None:
    """Look for contradictions in the motors of a declaration whose names and shapes are sound.

    Parameters
    ----------
    walker : Walker

    Raises
    ------
    InputError
        For the first one found.
    """
    _names(walker)
    for motor in walker.actuators:
        _numbers(walker, motor)
        _moves(walker, motor)
    _columns(walker)
    for motor in walker.motors:
        if motor.bodies:
            _bodies(walker, motor)
    validate_torques(walker)


def _names(walker: Declaration) -> None:
    seen = set()
    for motor in walker.actuators:
        name = motor.name
        if not isinstance(name, str) or not name.isidentifier() or not name.isascii() or name.startswith("_"):
            refuse(
                walker,
                f"the motor {name!r} cannot be a part of a column's name; use letters, digits and "
                "underscores, and begin with a letter",
            )
        if name in seen:
            plain = name in {c.name for c in walker.torques}
            what = f"a torque on {name} and a motor {name}" if plain else f"two motors called {name}"
            refuse(walker, f"there are {what}; rename one of them")
        seen.add(name)


def _numbers(walker: Declaration, motor: Motor) -> None:
    """Limit, efficiency and kind are what they can be."""
    limit, share = motor.limit, motor.efficiency
    if limit is not None and not (_is_number(limit) and limit > 0):
        refuse(
            walker,
            f"the limit of the motor {motor.name} is {limit!r}; it must be a number above 0, or None for "
            "no limit",
        )
    if not (_is_number(share) and 0 < share <= 1):
        refuse(
            walker,
            f"the efficiency of the motor {motor.name} is {share!r}; it must be a number above 0 and up to 1",
        )
    if motor.kind not in (None, "torque", "force"):
        refuse(
            walker, f'the kind of the motor {motor.name} is {motor.kind!r}; it must be "torque" or "force"'
        )


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def _moves(walker: Declaration, motor: Motor) -> None:
    """A motor drives something that the walker's motion changes."""
    if walker.phase is not None and walker.phase.symbol in motor.drives.free_symbols:
        refuse(
            walker,
            f"the motor {motor.name} drives {walker.phase.name}, the clock's phase, which is not a motion; "
            "give it an angle or a length to drive",
        )
    if not motor.drives.free_symbols & {*walker.q, *STANCE_FOOT}:
        angles = ", ".join(body.name for body in motor.bodies if body.angle == 0)
        remedy = (
            f"give angle= to the bodies it acts between ({angles} has none)"
            if angles
            else "give an angle or a length in terms of the coordinates"
        )
        refuse(walker, f"the motor {motor.name} drives {motor.drives}, which does not move; {remedy}")


def _columns(walker: Declaration) -> None:
    """The columns of motors bear names that nothing else bears."""
    taken = {s.name: "coordinate" for s in walker.q} | {s.name: "rate of a coordinate" for s in walker.v}
    taken |= {a.name: "parameter" for a in walker.parameters}
    taken |= {one.name: "quantity" for one in walker.quantities}
    several = len(walker.actuators) > 1
    motors = [(motor, record(walker, motor)) for motor in walker.actuators]
    columns = [(motor, one.name) for motor, written in motors for one in of_motor(written, several)]
    columns += [(motor, LIMIT_USE.name) for motor in walker.actuators if motor.limit is not None][:1]
    for motor, name in columns:
        what = meaning(name) or ("the name of an attribute" if name in ATTRIBUTES else None)
        what = what or (f"the name of a {taken[name]}" if name in taken else None)
        if what is not None:
            mine = name.endswith(f"_{motor.name}")
            remedy = f"rename the motor, such as {motor.name}_motor" if mine else f"rename {name}"
            refuse(walker, f"the motor {motor.name} has a column {name}, which is {what}; {remedy}")
        taken[name] = f"column of the motor {motor.name}"


def _bodies(walker: Declaration, motor: Motor) -> None:
    """The bodies of a motor are the walker's, and count their angles in the same sense."""
    angles = {body.name: body.angle for body in walker.bodies}
    for body in motor.bodies:
        if body.name not in angles or angles[body.name] != body.angle:
            refuse(
                walker,
                f"the motor {motor.name} acts on a body {body.name} with the angle {body.angle}, which is "
                "not one of the walker's bodies; declare the motor with the walker's own",
            )
    senses = [_sense(walker, body.angle) for body in motor.bodies]
    for body, sense in zip(motor.bodies, senses, strict=True):
        if sense is not None and abs(abs(sense) - 1) > TOLERANCE:
            refuse(
                walker,
                f"the angle {body.angle} of the body {body.name} changes by {sense:.6g} when the walker is "
                "turned by 1 rad, so it is not the body's orientation; correct angle",
            )
    if len(senses) == 2 and None not in senses and senses[0] != senses[1]:
        one, other = motor.bodies
        refuse(
            walker,
            f"the bodies {one.name} and {other.name} count their angles in opposite senses, so the "
            f"difference is not what the motor {motor.name} drives; write "
            f"drives={one.angle + other.angle}, or turn the sense of one",
        )


def _sense(walker: Declaration, angle: sp.Expr) -> float | None:
    """By how much an angle changes when the walker turns by 1 rad as one rigid body, from x to y.

    None where that cannot be known: where the coordinates allow no such turn, or the bodies' positions do not
    show how the angle takes part in it.
    """
    q = list(walker.q)
    masses = {} if walker.massless is None else {walker.massless.mass: 0.1}
    values = {a.symbol: a.default for a in walker.parameters} | masses | dict.fromkeys(STANCE_FOOT, 0)
    points = [*(body.position for body in walker.bodies), walker.swing_foot]
    for position in trial_points(walker, values):
        where = {**values, **position}
        rows = in_numbers(sp.Matrix.vstack(*(p.jacobian(q) for p in points)), where).evalf(30)
        places = [in_numbers(p, where).evalf(30) for p in points]
        turned = sp.Matrix([x for p in places for x in (-p[1], p[0])])
        gradient = in_numbers(sp.Matrix([angle]).jacobian(q), where).evalf(30)
        with mpmath.workdps(30):
            return _of_turn(*(mpmath.matrix(m.tolist()) for m in (rows, turned, gradient)))
    return None


def _of_turn(rows: mpmath.matrix, turned: mpmath.matrix, gradient: mpmath.matrix) -> float | None:
    """The change of an angle with `gradient` in the turn ``rows * change = turned``; None if undetermined."""
    u, s, v = mpmath.svd_r(rows)
    scale = max(s)
    rank = sum(1 for x in s if x > 1e-12 * scale)
    change = mpmath.zeros(rows.cols, 1)
    for k in range(rank):
        along = sum(u[i, k] * turned[i] for i in range(rows.rows)) / s[k]
        change += along * v[k, :].T
    missed = max(abs(x) for x in rows * change - turned)
    shown = gradient - gradient * v[:rank, :].T * v[:rank, :]
    if missed > 1e-9 * scale or max(abs(x) for x in shown) > 1e-9:
        return None
    sense = float((gradient * change)[0])
    return float(round(sense)) if abs(sense - round(sense)) < TOLERANCE else sense
