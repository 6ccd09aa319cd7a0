"""Declarations that contradict themselves are refused, with what is wrong and how to mend it.

What can be seen from the names and shapes is looked at first. Whether the mass matrix has an inverse and
whether the relabelling fits the touchdown condition is tried at random points, with the parameters' defaults.
"""

import keyword
import math
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, NoReturn

import mpmath
import sympy as sp

from stridemap.errors import InputError

if TYPE_CHECKING:
    from stridemap.derive.declaration import Coordinate, Parameter, Walker
    from stridemap.derive.mechanics import Mechanics

RESERVED = frozenset(
    "t q v p z u xp M h dh side d com foot force zmp mass weight pull length positions masses kinetic "
    "potential auto break case char const continue default do double else enum extern float for goto if inline "
    "int long register restrict return short signed sizeof static struct switch typedef union unsigned void "
    "volatile while sin cos tan sqrt exp log pow abs main period status stable model params state".split()
) | frozenset(keyword.kwlist)
"""Names that mean something else in generated code or in tables."""

TRIES = 12
TOLERANCE = 1e-9


def check(walker: "Walker") -> None:
    """Look for contradictions in a declaration.

    Parameters
    ----------
    walker : Walker

    Raises
    ------
    InputError
        For the first one found.
    """
    _names(walker)
    _parameters(walker.parameters, walker.name)
    _references(walker)
    _shapes(walker)
    _symbols(walker)
    _translation(walker)
    _search(walker)
    _relabelling(walker)
    values = {a.symbol: a.default for a in walker.parameters}
    _inertia(walker, values)
    _after_touchdown(walker, values)


def _refuse(walker: "Walker", sentence: str) -> NoReturn:
    raise InputError(f"model {walker.name}: {sentence}")


# -- names and shapes ------------------------------------------------------------------------------------


def _names(walker: "Walker") -> None:
    kinds = [("model", walker.name)]
    kinds += [("coordinate", c.name) for c in walker.coordinates]
    kinds += [("rate of a coordinate", c.rate.name) for c in walker.coordinates]
    kinds += [("parameter", a.name) for a in walker.parameters]
    kinds += [("line", line.name) for line in walker.drawing]
    seen: dict[str, str] = {}
    for kind, name in kinds:
        if not name.isidentifier() or not name.isascii() or name.startswith("_"):
            _refuse(
                walker,
                f"the {kind} {name!r} is no name for generated code; use letters, digits and underscores",
            )
        if name in RESERVED and kind != "model":
            _refuse(
                walker, f"the {kind} {name} has a name that generated code needs itself; call it otherwise"
            )
        if kind != "model" and name in seen:
            if {kind, seen[name]} == {"parameter", "coordinate"}:
                _refuse(walker, f"the parameter {name} shadows the coordinate {name}; rename one of them")
            _refuse(walker, f"there is a {seen[name]} and a {kind} called {name}; rename one of them")
        seen[name] = kind
    if not walker.coordinates:
        _refuse(walker, "it has no coordinates; give at least one")
    if not walker.bodies:
        _refuse(walker, "it has no bodies; give at least one with a mass")


def _parameters(parameters: "Iterable[Parameter]", model: str) -> None:
    for a in parameters:
        below = a.lower is not None and (a.default < a.lower or (a.default == a.lower and a.lower_open))
        above = a.upper is not None and (a.default > a.upper or (a.default == a.upper and a.upper_open))
        if not math.isfinite(a.default) or below or above:
            low = "(" if a.lower_open or a.lower is None else "["
            high = ")" if a.upper_open or a.upper is None else "]"
            ends = [str(end) if x is None else f"{x:g}" for x, end in ((a.lower, "-inf"), (a.upper, "inf"))]
            raise InputError(
                f"model {model}: the default {a.default:g} of the parameter {a.name} is not in its own range "
                f"{low}{', '.join(ends)}{high}; change one of them"
            )


def _references(walker: "Walker") -> None:
    """What names coordinates names those of the model."""
    symbols, rates = list(walker.q), list(walker.v)
    named: list[tuple[str, Coordinate | None]] = [("torques", c) for c in walker.torques]
    named += [("massless", c) for c in (walker.massless.coordinates if walker.massless else ())]
    named += [("stance_angle", walker.stance_angle), ("wobbling", walker.wobbling)]
    for where, coordinate in named:
        if coordinate is not None and coordinate not in walker.coordinates:
            known = ", ".join(c.name for c in walker.coordinates)
            name = getattr(coordinate, "name", coordinate)
            _refuse(
                walker, f"{where} names {name}, which is no coordinate of it; its coordinates are {known}"
            )
    for symbol in walker.relabel:
        if symbol not in symbols:
            twin = str(symbol) in {c.name for c in walker.coordinates}
            cure = "; take Coordinate(...).symbol, which is real" if twin else ""
            _refuse(walker, f"relabel gives {symbol} a new value, but that is no coordinate of it{cure}")
    for symbol in symbols:
        if symbol not in walker.relabel:
            _refuse(walker, f"relabel says nothing of {symbol}; write {{{symbol}: {symbol}}} if it stays")
    for symbol in walker.section:
        if symbol not in symbols and symbol not in rates:
            _refuse(walker, f"section fixes {symbol}, which is neither a coordinate nor a rate of it")


def _shapes(walker: "Walker") -> None:
    from stridemap.derive.declaration import Coordinate, Parameter

    vectors = [(f"the position of the body {b.name}", b.position) for b in walker.bodies]
    vectors += [("swing_foot", walker.swing_foot), ("gravity", walker.gravity), ("stance", walker.stance)]
    vectors += [(f"a point of the line {line.name}", p) for line in walker.drawing for p in line.points]
    for what, value in vectors:
        shape = getattr(value, "shape", None)
        if shape != (2, 1):
            _refuse(walker, f"{what} has shape {shape}; a point has shape (2, 1), as sympy.Matrix([x, y])")
    for what, value in _scalars(walker):
        if isinstance(value, Parameter | Coordinate):
            kind = type(value).__name__
            _refuse(walker, f"{what} is the {kind} {value.name} itself; take its symbol, {kind}(...).symbol")
        if not isinstance(value, sp.Expr):
            _refuse(walker, f"{what} is {value!r}, and must be one SymPy expression")


def _scalars(walker: "Walker") -> Iterator[tuple[str, Any]]:
    for body in walker.bodies:
        yield f"the mass of the body {body.name}", body.mass
        yield f"the inertia of the body {body.name}", body.inertia
        yield f"the angle of the body {body.name}", body.angle
    yield "the touchdown's condition", walker.touchdown.condition
    yield "the touchdown's region", walker.touchdown.region
    yield "the dissipation", walker.dissipation
    for name, value in walker.potentials.items():
        yield f"the potential {name}", value
    for coordinate, value in walker.torques.items():
        yield f"the torque on {coordinate.name}", value
    for symbol, value in walker.relabel.items():
        yield f"the new value of {symbol} in relabel", value
    for symbol, value in walker.section.items():
        yield f"the value of {symbol} in section", value
    for i, value in enumerate(walker.locks, 1):
        yield f"lock {i}", value
    if walker.clock is not None:
        yield "the rate of the clock", walker.clock.rate
    if walker.spring_mode is not None:
        yield "spring_mode", walker.spring_mode


def _symbols(walker: "Walker") -> None:
    """Every symbol is a parameter, or something else that may stand there."""
    from stridemap.derive.declaration import STANCE_FOOT, TIME

    parameters = {a.symbol for a in walker.parameters}
    q, v, base = set(walker.q), set(walker.v), set(STANCE_FOOT)
    massless = {walker.massless.mass} if walker.massless is not None else set()
    if walker.massless is not None and massless & parameters:
        _refuse(walker, f"{walker.massless.mass} goes to zero, so it cannot be a parameter; take it out")
    allowed = {
        "mass": parameters | massless,
        "inertia": parameters | massless,
        "angle": parameters | q,
        "potential": parameters | q | base | massless,
        "dissipation": parameters | q | v | massless,
        "torque": parameters | q | v | {TIME} | massless,
        "touchdown": parameters | q,
        "new": parameters | q,
        "value": parameters | q | v,
        "lock": parameters | q,
        "rate": parameters,
        "spring_mode": parameters,
    }
    checked = []
    for what, value in _scalars(walker):
        kind = next(k for k in allowed if what.removeprefix("the ").startswith(k))
        checked.append((what, value, allowed[kind]))
    checked += [
        (f"the position of the body {b.name}", b.position, parameters | q | base) for b in walker.bodies
    ]
    checked += [("swing_foot", walker.swing_foot, parameters | q | base)]
    checked += [("gravity", walker.gravity, parameters), ("stance", walker.stance, parameters | q)]
    checked += [
        (f"a point of the line {line.name}", p, parameters | q | base)
        for line in walker.drawing
        for p in line.points
    ]
    names = {s.name: s for s in parameters | q | v}
    for what, value, known in checked:
        for symbol in sorted(value.free_symbols - known, key=str):
            twin = names.get(symbol.name)
            if twin is not None and twin != symbol:
                cure = (
                    f"it is not the declared {symbol}: take Parameter(...).symbol or Coordinate(...).symbol"
                )
            elif twin is not None:
                cure = "that may not stand there"
            else:
                cure = f'declare Parameter("{symbol}", ...), or write what it stands for'
            _refuse(walker, f"{what} has the symbol {symbol}, which is no parameter; {cure}")


def _translation(walker: "Walker") -> None:
    """Points move along with the stance foot."""
    from stridemap.derive.declaration import STANCE_FOOT

    points = [(f"the position of the body {b.name}", b.position) for b in walker.bodies]
    points += [("swing_foot", walker.swing_foot)]
    for what, point in points:
        if (point - STANCE_FOOT).applyfunc(sp.expand).free_symbols & set(STANCE_FOOT):
            _refuse(walker, f"{what} does not move along with the stance foot; write STANCE_FOOT + ...")


def _search(walker: "Walker") -> None:
    names = walker.section_names
    for name in names:
        if name not in walker.search_box:
            _refuse(walker, f"search_box lacks {name}; give its middle and half-width")
    known = {s.name for s in (*walker.q, *walker.v)}
    for name, box in walker.search_box.items():
        if name not in known:
            _refuse(walker, f"search_box names {name}, which is neither a coordinate nor a rate of it")
        if len(box) != 2 or not all(math.isfinite(x) for x in box) or box[1] < 0:
            _refuse(
                walker, f"search_box gives {name} {box}; a middle and a half-width of at least 0 are needed"
            )
    low, high = walker.period_range
    if not 0 < low < high < math.inf:
        _refuse(walker, f"period_range = {walker.period_range} is not allowed; 0 < shortest < longest")


# -- what the mechanics need -----------------------------------------------------------------------------


def _relabelling(walker: "Walker") -> None:
    q = sp.Matrix(list(walker.q))
    new = sp.Matrix([walker.relabel[s] for s in q])
    swap = new.jacobian(q)
    if swap.free_symbols & set(q):
        _refuse(walker, "relabel is not linear in the coordinates; choose coordinates in which it is")
    twice = (swap * swap).applyfunc(sp.simplify)
    if twice != sp.eye(len(q)):
        wrong = next(s for i, s in enumerate(q) if twice[i, :] != sp.eye(len(q))[i, :])
        _refuse(
            walker,
            f"relabel is no involution: to swap the legs twice does not give {wrong} back, but "
            f"{(twice * q)[list(q).index(wrong)]}; correct the new value of {wrong}",
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
            _refuse(
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
    _refuse(
        walker,
        "the mass matrix has no inverse: some coordinates move all bodies alike; take one of "
        f"{', '.join(map(str, q))} out, or give another body a mass",
    )


def _standing(walker: "Walker", point: sp.Matrix) -> sp.Matrix:
    from stridemap.derive.declaration import STANCE_FOOT

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
        except (ZeroDivisionError, ValueError, OverflowError):
            continue
        if abs(condition(*place)) < 1e-12 and admissible(*place) < 0:
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
            _refuse(
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
                    _refuse(
                        walker,
                        f"section fixes {symbol} = {value}, but just after touchdown {symbol} can be "
                        f"{after[symbol]:.6g} where that is {wanted:.6g}; correct it or leave {symbol} free",
                    )
    if not found:
        _refuse(
            walker,
            "no touchdown was found near the search box: the touchdown's condition has no zero where its "
            "region is negative; correct the condition, the region or search_box",
        )


def _same_place(
    walker: "Walker", before: Mapping[sp.Symbol, float], after: Mapping[sp.Symbol, float]
) -> None:
    """The centre of mass stays where it is when the legs swap names and the other foot is the stance foot."""
    from stridemap.derive.declaration import STANCE_FOOT

    mass = sum(body.mass for body in walker.bodies)
    centre = sum((body.mass * body.position for body in walker.bodies), sp.zeros(2, 1)) / mass
    if walker.massless is not None:
        centre = centre.subs(walker.massless.mass, 0.1)
    origin = dict.fromkeys(STANCE_FOOT, 0)
    was, landed = (m.subs(origin).subs(before) for m in (centre, walker.swing_foot))
    now = landed + centre.subs(origin).subs(after)
    moved = float((now - was).evalf().norm())
    if moved > TOLERANCE * (1 + float(was.evalf().norm())):
        _refuse(
            walker,
            f"to swap the legs moves the centre of mass by {moved:.6g}: the coordinates in relabel do not describe "
            "the walker that has just touched down, seen from its new stance foot; correct relabel",
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
        matrix = mpmath.matrix(mechanics.impact_mass_matrix.subs(place).evalf().tolist())
        momentum = mpmath.matrix(mechanics.impact_momentum.subs(place).evalf().tolist())
        solved = mpmath.lu_solve(matrix, momentum)
        after = {s: float(sp.sympify(e).subs(place).evalf()) for s, e in walker.relabel.items()}
        after |= dict(zip(walker.v, map(float, solved), strict=True))
        for symbol, value in fixed.items():
            wanted = float(sp.sympify(value).subs({**values, **after}).evalf())
            if abs(after[symbol] - wanted) > TOLERANCE * (1 + abs(wanted)):
                _refuse(
                    walker,
                    f"section fixes {symbol} = {value}, but the impact can make it {after[symbol]:.6g} where "
                    f"that is {wanted:.6g}; correct it or leave {symbol} free",
                )
