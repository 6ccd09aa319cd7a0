"""Declarations whose mechanics contradict themselves are refused, with what is wrong and how to mend it.

Whether the mass matrix has an inverse and whether relabelling, touchdown and section fit each other is tried
at some points, with the parameters' defaults.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice

import mpmath
import sympy as sp

from stridemap.derive.declaration import Declaration
from stridemap.derive.parts import STANCE_FOOT
from stridemap.derive.trials import compiled, in_numbers, trial_points
from stridemap.derive.validate.refusal import refuse

TOLERANCE = 1e-9


def validate_mechanics(walker: Declaration) -> None:
    """Look for contradictions in the mechanics of a declaration whose names and shapes are sound.

    Parameters
    ----------
    walker : Walker

    Raises
    ------
    InputError
        For the first one found.
    """
    values = {a.symbol: a.default for a in walker.parameters}
    _relabelling(walker)
    _masses(walker, values)
    _inertia(walker, values)
    _locks(walker, values)
    _after_touchdown(walker, values)


def _relabelling(walker: Declaration) -> None:
    q = sp.Matrix(list(walker.q))
    new = sp.Matrix([walker.relabel[s] for s in q])
    swap = new.jacobian(q)
    if swap.free_symbols & set(q):
        refuse(walker, "relabel is not linear in the coordinates; choose coordinates in which it is")
    twice = (swap * swap).applyfunc(sp.simplify)
    if twice != sp.eye(len(q)):
        wrong = next(s for i, s in enumerate(q) if twice[i, :] != sp.eye(len(q))[i, :])
        refuse(
            walker,
            f"relabel is not its own inverse: swapping the legs twice must give {wrong} back, and gives "
            f"{(twice * q)[list(q).index(wrong)]}; correct the new values of the coordinates in relabel",
        )


def _masses(walker: Declaration, values: Mapping[sp.Symbol, float]) -> None:
    """No mass or moment of inertia is negative."""
    light = {walker.massless.mass: 1.0} if walker.massless is not None else {}
    for body in walker.bodies:
        for what, value in (("mass", body.mass), ("inertia", body.inertia)):
            number = in_numbers(value, {**values, **light}).evalf()
            if not (number.is_real and number.is_finite and number >= 0):
                refuse(
                    walker,
                    f"the {what} of the body {body.name} is {number.n(6)} with the parameters' defaults; it "
                    "must not be negative; correct it or the defaults",
                )


def _inertia(walker: Declaration, values: Mapping[sp.Symbol, float]) -> None:
    """Every coordinate moves a mass, and no two move all of them alike."""
    q = list(walker.q)
    parts = [(body.mass, _on_stance(walker, body.position).jacobian(q)) for body in walker.bodies]
    parts += [(body.inertia, sp.Matrix([body.angle]).jacobian(q)) for body in walker.bodies]
    for j, coordinate in enumerate(walker.coordinates):
        moved = any(mass != 0 and not jacobian[:, j].is_zero_matrix for mass, jacobian in parts)
        if not moved and coordinate != walker.phase:
            refuse(
                walker,
                f"the coordinate {coordinate.name} has no inertia: no body moves with it; give a body that "
                "does a mass, or take the coordinate out",
            )
    entries = [e for mass, jacobian in parts for e in (mass, *jacobian)]
    at = compiled(walker, entries)
    phase = walker.coordinates.index(walker.phase) if walker.phase else None
    for position in trial_points(walker, values):
        matrix, numbers = mpmath.zeros(len(q)), iter(at({**values, **position}))
        for _, jacobian in parts:
            mass = next(numbers)
            rows = mpmath.matrix([list(islice(numbers, jacobian.cols)) for _ in range(jacobian.rows)])
            matrix += mpmath.mpf(mass) * (rows.T * rows)
        if phase is not None:
            matrix[phase, phase] += 1
        scale = mpmath.mpf(1)
        for i in range(len(q)):
            scale *= max(matrix[i, i], mpmath.mpf("1e-30"))
        if abs(mpmath.det(matrix)) > 1e-12 * scale:
            return
    refuse(
        walker,
        "the mass matrix has no inverse: some coordinates move all bodies alike; take one of "
        f"{', '.join(map(str, q))} out, or give another body a mass",
    )


def _locks(walker: Declaration, values: Mapping[sp.Symbol, float]) -> None:
    """The locks leave something to move, and none repeats others."""
    if not walker.locks:
        return
    jacobian = sp.Matrix(walker.locks).jacobian(list(walker.q))
    ranks = [
        in_numbers(jacobian, {**values, **position}).evalf(30).rank(iszerofunc=_nearly_zero)
        for position in trial_points(walker, values)
    ]
    if max(ranks) < len(walker.locks):
        refuse(
            walker,
            f"of the {len(walker.locks)} locks only {max(ranks)} are independent; leave out those "
            "that follow from others",
        )
    if len(walker.locks) >= len(walker.q):
        refuse(walker, "the locks leave no coordinate free to move; lock fewer")


def _nearly_zero(number: sp.Expr) -> bool:
    return bool(abs(number) < TOLERANCE)


def _on_stance(walker: Declaration, point: sp.Matrix) -> sp.Matrix:
    return point.subs(dict(zip(STANCE_FOOT, walker.stance, strict=True)))


def touchdowns(walker: Declaration, values: Mapping[sp.Symbol, float]) -> Iterator[dict[sp.Symbol, float]]:
    """Some positions just before admissible touchdowns.

    Parameters
    ----------
    walker : Walker
    values : mapping of Symbol to float
        Parameters.
    """
    return (position for position, admissible in _zeros(walker, values) if admissible)


def _zeros(
    walker: Declaration, values: Mapping[sp.Symbol, float]
) -> Iterator[tuple[dict[sp.Symbol, float], bool]]:
    """Zeros of the touchdown condition, each with whether it is admissible.

    Found by Newton's method along the condition's gradient.
    """
    q = list(walker.q)
    gradient = sp.Matrix([walker.guard]).jacobian(q)
    condition = compiled(walker, [walker.guard, *gradient])
    side = compiled(walker, [walker.touchdown.region])
    back = compiled(walker, _before(walker))
    for after in trial_points(walker, values):
        # Starts lie around the state just after touchdown; before it, the legs had each other's names.
        try:
            position = [float(x) for x in back({**values, **after})]
            for _ in range(60):
                now = position
                rest, *slope = condition({**values, **dict(zip(q, now, strict=True))})
                step = rest / sum(s * s for s in slope)
                position = [x - step * s for x, s in zip(now, slope, strict=True)]
                if position == now:
                    break
            there = {**values, **dict(zip(q, map(float, position), strict=True))}
            found, admissible = abs(condition(there)[0]) < 1e-12, bool(side(there)[0] < 0)
        except (ZeroDivisionError, ValueError, OverflowError, TypeError):  # the last: complex numbers
            continue
        if found:
            yield {s: there[s] for s in q}, admissible


def _before(walker: Declaration) -> list[sp.Expr]:
    q = sp.Matrix(list(walker.q))
    new = sp.Matrix([walker.relabel[s] for s in q])
    swap = new.jacobian(q)
    return list(swap.inv() * (q - (new - swap * q)))


def _after_touchdown(walker: Declaration, values: Mapping[sp.Symbol, float]) -> None:
    """The condition, and what the section fixes of the coordinates, hold just after touchdown."""
    found = False
    fixed = {s: e for s, e in walker.section.items() if s in set(walker.q)}
    relabelled = compiled(walker, walker.relabel.values())
    at = compiled(walker, [walker.guard, *_centre_and_foot(walker), *fixed.values()])
    for before in touchdowns(walker, values):
        found = True
        everything = {**values, **before}
        after = dict(zip(walker.relabel, map(float, relabelled(everything)), strict=True))
        was, now = ([float(x) for x in at({**values, **position})] for position in (before, after))
        if abs(now[0]) > TOLERANCE:
            refuse(
                walker,
                f"the touchdown's condition is {now[0]:.6g} just after touchdown and must be zero, because "
                f"the old stance foot is still on the ground; {_condition_remedy(walker, everything, after)}",
            )
        _same_position(walker, was[1:5], now[1:5])
        for (symbol, value), wanted in zip(fixed.items(), now[5:], strict=True):
            if abs(after[symbol] - wanted) > TOLERANCE:
                refuse(
                    walker,
                    f"section fixes {symbol} = {value}, but just after touchdown {symbol} can be "
                    f"{after[symbol]:.6g} where that is {wanted:.6g}; correct it or leave {symbol} free",
                )
    if not found:
        if next(_zeros(walker, values), None) is None:
            refuse(
                walker,
                "no touchdown was found near the search box: the touchdown's condition is not zero anywhere "
                "there; correct the condition or search_box",
            )
        refuse(
            walker,
            "no touchdown was found near the search box: where the touchdown's condition is zero, its "
            "region is not negative; correct the region (perhaps its sign), relabel or search_box",
        )


def _condition_remedy(
    walker: Declaration, before: Mapping[sp.Symbol, float], after: Mapping[sp.Symbol, float]
) -> str:
    """What to correct where the condition is not zero after touchdown: it, or the relabelling."""
    height = _on_stance(walker, walker.swing_foot)[1] - walker.stance[1]
    was, now = (float(sp.sympify(height).subs({**before, **q}).evalf()) for q in ({}, after))
    if abs(was) <= TOLERANCE < abs(now):
        return (
            "correct relabel; if no values of the coordinates describe the walker that has just touched down "
            "(the legs are not alike, or a knee is bent that the other leg lacks), give both legs the same "
            "coordinates"
        )
    return "write a condition that is zero with both feet on the ground, whichever is in front"


def _centre_and_foot(walker: Declaration) -> list[sp.Expr]:
    """Centre of mass and swing foot, from the stance foot: x and y of each."""
    mass = sum(body.mass for body in walker.bodies)
    centre = sum((body.mass * body.position for body in walker.bodies), sp.zeros(2, 1)) / mass
    origin = dict.fromkeys(STANCE_FOOT, 0)
    return [*centre.subs(origin), *sp.Matrix(walker.swing_foot).subs(origin)]


def _same_position(walker: Declaration, before: Sequence[float], after: Sequence[float]) -> None:
    """The centre of mass stays where it is when the legs swap names and the other foot is the stance foot.

    Both are centre of mass and swing foot, as `_centre_and_foot` has them.
    """
    x, y, landed_x, landed_y = before
    moved = math.hypot(landed_x + after[0] - x, landed_y + after[1] - y)
    if moved > TOLERANCE * (1 + math.hypot(x, y)):
        refuse(
            walker,
            f"swapping the legs moves the centre of mass by {moved:.6g}: the coordinates in relabel do not "
            "describe the walker that has just touched down, seen from its new stance foot; correct "
            "relabel, or the bodies where the two legs are not alike",
        )
