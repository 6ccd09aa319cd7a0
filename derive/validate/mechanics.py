"""Declarations whose mechanics contradict themselves are refused, with what is wrong and how to mend it.

Whether the mass matrix has an inverse and whether relabelling, touchdown and section fit each other is tried
at some points, with the parameters' defaults.
"""

from collections.abc import Iterator, Mapping

import mpmath
import sympy as sp

from stridemap.derive.declaration import Declaration
from stridemap.derive.parts import STANCE_FOOT
from stridemap.derive.trials import trial_points
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
            number = value.subs({**values, **light}).evalf()
            if not (number.is_real and number.is_finite and number >= 0):
                refuse(
                    walker,
                    f"the {what} of the body {body.name} is {number.n(6)} with the parameters' defaults; it "
                    "must not be negative; correct it or the defaults",
                )


def _inertia(walker: Declaration, values: Mapping[sp.Symbol, float]) -> None:
    """Every coordinate moves a mass, and no two move all of them alike."""
    q = list(walker.q)
    massless = walker.massless
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
    if massless is not None:
        values = {**values, massless.mass: 0.1}
    known = [(sp.sympify(mass).subs(values).evalf(), jacobian.subs(values)) for mass, jacobian in parts]
    phase = walker.coordinates.index(walker.phase) if walker.phase else None
    for position in trial_points(walker, values):
        matrix = mpmath.zeros(len(q))
        for mass, jacobian in known:
            rows = mpmath.matrix(jacobian.subs(position).evalf().tolist())
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
        jacobian.subs({**values, **position}).evalf(30).rank(iszerofunc=_nearly_zero)
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
    guard, region = walker.guard.subs(values), walker.touchdown.region.subs(values)
    condition = sp.lambdify(q, guard, "mpmath")
    gradient = sp.lambdify(q, list(sp.Matrix([guard]).jacobian(q)), "mpmath")
    side = sp.lambdify(q, region, "mpmath")
    back = _before(walker)
    for after in trial_points(walker, values):
        # Starts lie around the state just after touchdown; before it, the legs had each other's names.
        position = [float(e.subs({**values, **after}).evalf()) for e in back]
        try:
            for _ in range(60):
                slope = gradient(*position)
                step = condition(*position) / sum(s * s for s in slope)
                position = [x - step * s for x, s in zip(position, slope, strict=True)]
            found, admissible = abs(condition(*position)) < 1e-12, bool(side(*position) < 0)
        except (ZeroDivisionError, ValueError, OverflowError, TypeError):  # the last: complex numbers
            continue
        if found:
            yield dict(zip(q, position, strict=True)), admissible


def _before(walker: Declaration) -> list[sp.Expr]:
    q = sp.Matrix(list(walker.q))
    new = sp.Matrix([walker.relabel[s] for s in q])
    swap = new.jacobian(q)
    return list(swap.inv() * (q - (new - swap * q)))


def _after_touchdown(walker: Declaration, values: Mapping[sp.Symbol, float]) -> None:
    """The condition, and what the section fixes of the coordinates, hold just after touchdown."""
    found = False
    # Parameters are put in once and coordinates at every position, which takes a fraction of the time.
    guard, (centre, foot) = walker.guard.subs(values), (m.subs(values) for m in _centre_and_foot(walker))
    for before in touchdowns(walker, values):
        found = True
        everything = {**values, **before}
        after = {s: float(sp.sympify(e).subs(everything).evalf()) for s, e in walker.relabel.items()}
        rest = float(guard.subs(after).evalf())
        if abs(rest) > TOLERANCE:
            refuse(
                walker,
                f"the touchdown's condition is {rest:.6g} just after touchdown and must be zero, because the "
                f"old stance foot is still on the ground; {_condition_remedy(walker, everything, after)}",
            )
        _same_position(walker, centre, foot, before, after)
        for symbol, value in walker.section.items():
            if symbol in after:
                wanted = float(sp.sympify(value).subs({**values, **after}).evalf())
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


def _centre_and_foot(walker: Declaration) -> tuple[sp.Matrix, sp.Matrix]:
    """Centre of mass and swing foot, from the stance foot."""
    mass = sum(body.mass for body in walker.bodies)
    centre = sum((body.mass * body.position for body in walker.bodies), sp.zeros(2, 1)) / mass
    if walker.massless is not None:
        centre = centre.subs(walker.massless.mass, 0.1)
    origin = dict.fromkeys(STANCE_FOOT, 0)
    return centre.subs(origin), sp.Matrix(walker.swing_foot).subs(origin)


def _same_position(
    walker: Declaration,
    centre: sp.Matrix,
    foot: sp.Matrix,
    before: Mapping[sp.Symbol, float],
    after: Mapping[sp.Symbol, float],
) -> None:
    """The centre of mass stays where it is when the legs swap names and the other foot is the stance foot."""
    was, landed = (m.subs(before) for m in (centre, foot))
    now = landed + centre.subs(after)
    moved = float((now - was).evalf().norm())
    if moved > TOLERANCE * (1 + float(was.evalf().norm())):
        refuse(
            walker,
            f"swapping the legs moves the centre of mass by {moved:.6g}: the coordinates in relabel do not "
            "describe the walker that has just touched down, seen from its new stance foot; correct "
            "relabel, or the bodies where the two legs are not alike",
        )
