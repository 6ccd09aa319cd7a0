"""Declarations whose mechanics contradict themselves are refused, with what is wrong and how to mend it.

Whether the mass matrix has an inverse and whether relabelling, touchdown and section fit each other is tried
at some points, with the parameters' defaults.
"""

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

import mpmath
import sympy as sp

from stridemap.derive.validate.names import refuse

if TYPE_CHECKING:
    from stridemap.derive.mechanics import Mechanics
    from stridemap.derive.walker import Walker

TRIES = 12
TOLERANCE = 1e-9


def try_out(walker: "Walker") -> None:
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


def _relabelling(walker: "Walker") -> None:
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
            f"relabel is no involution: to swap the legs twice does not give {wrong} back, but "
            f"{(twice * q)[list(q).index(wrong)]}; correct the new value of {wrong}",
        )


def _masses(walker: "Walker", values: Mapping[sp.Symbol, float]) -> None:
    """No mass or moment of inertia is negative."""
    light = {walker.massless.mass: 1.0} if walker.massless is not None else {}
    for body in walker.bodies:
        for what, value in (("mass", body.mass), ("inertia", body.inertia)):
            number = value.subs({**values, **light}).evalf()
            if not (number.is_real and number.is_finite and number >= 0):
                refuse(
                    walker,
                    f"the {what} of the body {body.name} is {number.n(6)} with the parameters' defaults; it "
                    "must not be negative",
                )


def _inertia(walker: "Walker", values: Mapping[sp.Symbol, float]) -> None:
    """Every coordinate moves a mass, and no two move all of them alike."""
    q = list(walker.q)
    massless = walker.massless
    parts = [(body.mass, _standing(walker, body.position).jacobian(q)) for body in walker.bodies]
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
    phase = walker.coordinates.index(walker.phase) if walker.phase else None
    for place in _points(walker, values):
        matrix = mpmath.zeros(len(q))
        for mass, jacobian in parts:
            rows = mpmath.matrix(jacobian.subs({**values, **place}).evalf().tolist())
            matrix += mpmath.mpf(sp.sympify(mass).subs(values).evalf()) * (rows.T * rows)
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


def _locks(walker: "Walker", values: Mapping[sp.Symbol, float]) -> None:
    """The locks leave something to move, and none repeats others."""
    if not walker.locks:
        return
    jacobian = sp.Matrix(walker.locks).jacobian(list(walker.q))
    ranks = [
        jacobian.subs({**values, **place}).evalf(30).rank(iszerofunc=_nearly_zero)
        for place in _points(walker, values)
    ]
    if max(ranks) < len(walker.locks):
        refuse(
            walker,
            f"of the {len(walker.locks)} locks only {max(ranks)} can be told apart by the rates; "
            "leave out those that follow from others",
        )
    if len(walker.locks) >= len(walker.q):
        refuse(walker, "locks leave no coordinate free to move; lock fewer")


def _nearly_zero(number: sp.Expr) -> bool:
    return bool(abs(number) < TOLERANCE)


def _standing(walker: "Walker", point: sp.Matrix) -> sp.Matrix:
    from stridemap.derive.walker import STANCE_FOOT

    return point.subs(dict(zip(STANCE_FOOT, walker.stance, strict=True)))


def _points(walker: "Walker", values: Mapping[sp.Symbol, float]) -> Iterator[dict[sp.Symbol, float]]:
    """Some places near the middle of the search box, always the same ones."""
    for i in range(1, TRIES + 1):
        place = {}
        for j, symbol in enumerate(walker.q):
            middle, width = walker.search_box.get(symbol.name, (0.0, 0.5))
            # Fractions of multiples of the golden ratio fill an interval evenly.
            spread = math.modf(i * 0.6180339887498949 + j * 0.7548776662466927)[0]
            place[symbol] = middle + width * (2 * spread - 1) * 0.5 + 1e-3 * (j + 1)
        yield place


def touchdowns(walker: "Walker", values: Mapping[sp.Symbol, float]) -> Iterator[dict[sp.Symbol, float]]:
    """Some places just before admissible touchdowns, by Newton's method along the condition's gradient.

    Parameters
    ----------
    walker : Walker
    values : mapping of Symbol to float
        Parameters.
    """
    q = list(walker.q)
    strike, region = walker.strike.subs(values), walker.touchdown.region.subs(values)
    condition = sp.lambdify(q, strike, "mpmath")
    gradient = sp.lambdify(q, list(sp.Matrix([strike]).jacobian(q)), "mpmath")
    admissible = sp.lambdify(q, region, "mpmath")
    back = _before(walker)
    for after in _points(walker, values):
        # Starts lie around the state just after touchdown; before it, the legs had each other's names.
        place = [float(e.subs({**values, **after}).evalf()) for e in back]
        try:
            for _ in range(60):
                slope = gradient(*place)
                step = condition(*place) / sum(s * s for s in slope)
                place = [x - step * s for x, s in zip(place, slope, strict=True)]
            found = abs(condition(*place)) < 1e-12 and admissible(*place) < 0
        except (ZeroDivisionError, ValueError, OverflowError, TypeError):  # the last: complex numbers
            continue
        if found:
            yield dict(zip(q, place, strict=True))


def _before(walker: "Walker") -> list[sp.Expr]:
    q = sp.Matrix(list(walker.q))
    new = sp.Matrix([walker.relabel[s] for s in q])
    swap = new.jacobian(q)
    return list(swap.inv() * (q - (new - swap * q)))


def _after_touchdown(walker: "Walker", values: Mapping[sp.Symbol, float]) -> None:
    """The condition, and what the section fixes of the coordinates, hold just after touchdown."""
    found = False
    for before in touchdowns(walker, values):
        found = True
        everything = {**values, **before}
        after = {s: float(sp.sympify(e).subs(everything).evalf()) for s, e in walker.relabel.items()}
        rest = float(walker.strike.subs({**values, **after}).evalf())
        if abs(rest) > TOLERANCE:
            refuse(
                walker,
                f"the touchdown's condition is {rest:.6g} just after touchdown and must be zero, because the "
                "old stance foot is still on the ground: correct relabel, or write a condition that is zero "
                "for both feet on the ground whichever is in front",
            )
        _same_place(walker, {**values, **before}, {**values, **after})
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
        refuse(
            walker,
            "no touchdown was found near the search box: the touchdown's condition has no zero where its "
            "region is negative; correct the condition, the region or search_box",
        )


def _same_place(
    walker: "Walker", before: Mapping[sp.Symbol, float], after: Mapping[sp.Symbol, float]
) -> None:
    """The centre of mass stays where it is when the legs swap names and the other foot is the stance foot."""
    from stridemap.derive.walker import STANCE_FOOT

    mass = sum(body.mass for body in walker.bodies)
    centre = sum((body.mass * body.position for body in walker.bodies), sp.zeros(2, 1)) / mass
    if walker.massless is not None:
        centre = centre.subs(walker.massless.mass, 0.1)
    origin = dict.fromkeys(STANCE_FOOT, 0)
    was, landed = (m.subs(origin).subs(before) for m in (centre, walker.swing_foot))
    now = landed + centre.subs(origin).subs(after)
    moved = float((now - was).evalf().norm())
    if moved > TOLERANCE * (1 + float(was.evalf().norm())):
        refuse(
            walker,
            f"to swap the legs moves the centre of mass by {moved:.6g}: the coordinates in relabel do not "
            "describe the walker that has just touched down, seen from its new stance foot; correct relabel",
        )


def check_rates(mechanics: "Mechanics") -> None:
    """Rates that the section fixes follow from the others just after every impact.

    Parameters
    ----------
    mechanics : Mechanics

    Raises
    ------
    InputError
        When one does not.
    """
    walker = mechanics.walker
    fixed = {s: e for s, e in walker.section.items() if s in set(walker.v)}
    fixed = {s: e for s, e in fixed.items() if walker.phase is None or s != walker.phase.rate}
    if not fixed:
        return
    values = {a.symbol: a.default for a in walker.parameters}
    for i, before in enumerate(touchdowns(walker, values)):
        rates = {s: 0.3 * math.cos(2.0 * i + 3.0 * j + 1.0) for j, s in enumerate(walker.v)}
        if walker.phase is not None and walker.clock is not None:
            rates[walker.phase.rate] = float(walker.clock.rate.subs(values))
        place = {**values, **before, **rates}
        matrix, right = (
            mpmath.matrix(part.subs(place).evalf().tolist()) for part in mechanics.impact_equations
        )
        solved = list(mpmath.lu_solve(matrix, right))[: len(walker.q)]  # without the locks' forces
        after = {s: float(sp.sympify(e).subs(place).evalf()) for s, e in walker.relabel.items()}
        after |= dict(zip(walker.v, map(float, solved), strict=True))
        for symbol, value in fixed.items():
            wanted = float(sp.sympify(value).subs({**values, **after}).evalf())
            if abs(after[symbol] - wanted) > TOLERANCE * (1 + abs(wanted)):
                refuse(
                    walker,
                    f"section fixes {symbol} = {value}, but the impact can make it {after[symbol]:.6g} where "
                    f"that is {wanted:.6g}; correct it or leave {symbol} free",
                )
