"""Declarations that contradict themselves are refused, with what is wrong and how to mend it.

Here is what can be seen from names and shapes; what the mechanics need is in `mechanics`.
"""

import math
from collections.abc import Iterator
from typing import Any

import sympy as sp

from stridemap.derive.declaration import Declaration
from stridemap.derive.parts import (
    STANCE_FOOT,
    TIME,
    Coordinate,
    Parameter,
)
from stridemap.derive.terms import Term
from stridemap.derive.validate.refusal import refuse
from stridemap.derive.validate.reserved import FILES, better, in_code, meaning
from stridemap.derive.validate.smooth import validate_smooth
from stridemap.errors import short
from stridemap.quantities import KINDS
from stridemap.spec import REDUCTIONS
from stridemap.words import ATTRIBUTES

BREAKING = ("*/", "/*", '"""', "\\")
"""What ends or bends comments."""


def validate_names(walker: Declaration) -> None:
    """Look for contradictions that names, kinds and shapes show.

    Parameters
    ----------
    walker : Walker

    Raises
    ------
    InputError
        For the first one found.
    """
    _quantities(walker)
    _names(walker)
    _texts(walker)
    _parameters(walker)
    _references(walker)
    _shapes(walker)
    validate_smooth(walker, [*_scalars(walker), *_points(walker)])
    _symbols(walker)
    _translation(walker)
    _search(walker)


# -- kinds, names and shapes -----------------------------------------------------------------------------


def _quantities(walker: Declaration) -> None:
    """Reductions and kinds of declared quantities are known ones; `types` has looked at all fields."""
    for one in walker.quantities:
        for field, value, allowed in (("reduction", one.reduction, REDUCTIONS), ("kind", one.kind, KINDS)):
            if value not in allowed:
                refuse(
                    walker,
                    f"the {field} of the quantity {one.name} is {value!r}; "
                    f"it must be one of {', '.join(allowed)}",
                )


def _texts(walker: Declaration) -> None:
    """Texts stand in comments of generated code, which they must not end."""
    texts = [walker.title, walker.reference, *vars(walker.units).values(), *walker.sources.values()]
    described: list[Coordinate | Parameter] = [*walker.coordinates, *walker.parameters]
    texts += [text for x in described for text in (x.unit, x.meaning)]
    texts += [body.name for body in walker.bodies]
    texts += [text for one in walker.quantities for text in (one.label, one.definition)]
    texts += [motor.meaning for motor in walker.motors]
    for text in texts:
        if not isinstance(text, str) or not text.isprintable() or any(x in text for x in BREAKING):
            refuse(
                walker, f"the text {text!r} cannot stand in a comment of generated code; write plain words"
            )


def _names(walker: Declaration) -> None:
    kinds = [("model", walker.name)]
    kinds += [("coordinate", c.name) for c in walker.coordinates]
    kinds += [("rate of a coordinate", c.rate.name) for c in walker.coordinates]
    kinds += [("parameter", a.name) for a in walker.parameters]
    kinds += [("line", line.name) for line in walker.drawing]
    kinds += [("quantity", one.name) for one in walker.quantities]
    kinds += [("potential", f"v_{name}") for name in walker.potentials]
    if "gravity" in walker.potentials:
        refuse(walker, "the potential gravity is added automatically, from the bodies' masses; leave it out")
    seen: dict[str, str] = {}
    for kind, name in kinds:
        if not isinstance(name, str) or not name.isidentifier() or not name.isascii() or name.startswith("_"):
            own = name.removeprefix("v_") if kind == "potential" else name
            refuse(
                walker,
                f"the {kind} {own!r} cannot be a name in generated code; use letters, digits "
                "and underscores, and begin with a letter",
            )
        _refuse_taken(walker, kind, name)
        if kind != "model" and name in seen:
            if {kind, seen[name]} == {"parameter", "coordinate"}:
                refuse(walker, f"the parameter {name} shadows the coordinate {name}; rename one of them")
            refuse(walker, f"there is a {seen[name]} and a {kind} called {name}; rename one of them")
        if kind != "model":
            seen[name] = kind
    if not walker.coordinates:
        refuse(walker, "it has no coordinates; give at least one")
    if not walker.bodies:
        refuse(walker, "it has no bodies; give at least one with a mass")


def _refuse_taken(walker: Declaration, kind: str, name: str) -> None:
    """Refuse a name that means something else."""
    if kind == "model":
        taken = in_code(name) or ("the name of a generated file" if name in FILES else None)
        if taken is not None:
            refuse(walker, f"it has {taken}; choose another name for the model, such as {name}_walker")
        return
    taken = meaning(name)
    variant = name.removeprefix(f"{walker.name}_")
    if variant != name and (variant.endswith("_float") or variant.startswith("old_")):
        taken = "a name that variants of the generated functions in C have"
    if kind == "quantity" and name in ATTRIBUTES:
        taken = "the name of an attribute that every limit cycle has"
    if kind == "line" and name in ("positions", "masses"):
        taken = "the name of another part of the drawing"
    if taken is None:
        return
    if kind == "rate of a coordinate":
        remedy = f"choose another name for the coordinate, such as {better(name[1:])}"
        refuse(
            walker,
            f"the rate of the coordinate {name[1:]} is called {name}, which is {taken}; {remedy}",
        )
    plain = name if meaning(name) else variant
    refuse(walker, f"the {kind} {name} has {taken}; choose another name, such as {better(plain)}")


def _parameters(walker: Declaration) -> None:
    for a in walker.parameters:
        if not isinstance(a.default, int | float) or not math.isfinite(a.default):
            refuse(
                walker,
                f"the default {a.default!r} of the parameter {a.name} is not a finite number; give one",
            )
        below = a.lower is not None and (a.default < a.lower or (a.default == a.lower and a.lower_open))
        above = a.upper is not None and (a.default > a.upper or (a.default == a.upper and a.upper_open))
        if below or above:
            low = "(" if a.lower_open or a.lower is None else "["
            high = ")" if a.upper_open or a.upper is None else "]"
            ends = [str(end) if x is None else f"{x:g}" for x, end in ((a.lower, "-inf"), (a.upper, "inf"))]
            refuse(
                walker,
                f"the default {a.default:g} of the parameter {a.name} is not in its own range "
                f"{low}{', '.join(ends)}{high}; change one of them",
            )


def _references(walker: Declaration) -> None:
    """What names coordinates names those of the model."""
    symbols, rates = list(walker.q), list(walker.v)
    named: list[tuple[str, Coordinate | None]] = [("torques", c) for c in walker.torques]
    named += [("massless", c) for c in (walker.massless.coordinates if walker.massless else ())]
    named += [("stance_angle", walker.stance_angle), ("wobbling", walker.wobbling)]
    for where, coordinate in named:
        if coordinate is not None and coordinate not in walker.coordinates:
            known = ", ".join(c.name for c in walker.coordinates)
            name = getattr(coordinate, "name", coordinate)
            refuse(walker, f"{where} names {name}, which is not one of its coordinates; they are {known}")
    for symbol in walker.relabel:
        if symbol not in symbols:
            remedy = "take Coordinate(...).symbol" if str(symbol) in map(str, symbols) else "leave it out"
            refuse(
                walker,
                f"relabel gives {symbol} a new value, but {symbol} is not one of its coordinates; {remedy}",
            )
    for symbol in symbols:
        if symbol not in walker.relabel:
            refuse(
                walker,
                f"relabel does not say what becomes of {symbol}; write {{{symbol}: {symbol}}} if it stays",
            )
    for symbol in walker.section:
        if symbol not in symbols and symbol not in rates:
            twin = str(symbol) in map(str, symbols + rates)
            remedy = "take .symbol or .rate of a Coordinate" if twin else "leave it out"
            refuse(
                walker,
                f"section fixes {symbol}, which is neither one of its coordinates nor a rate; {remedy}",
            )


def _points(walker: Declaration) -> Iterator[tuple[str, Any]]:
    for body in walker.bodies:
        yield f"the position of the body {body.name}", body.position
    yield from (("swing_foot", walker.swing_foot), ("gravity", walker.gravity), ("stance", walker.stance))
    for line in walker.drawing:
        yield from ((f"a point of the line {line.name}", point) for point in line.points)


def _shapes(walker: Declaration) -> None:
    for what, value in _points(walker):
        shape = getattr(value, "shape", None)
        if shape != (2, 1):
            refuse(walker, f"{what} has shape {shape}; a point has shape (2, 1), as sympy.Matrix([x, y])")
    for what, value in _scalars(walker):
        if isinstance(value, Parameter | Coordinate):
            kind = type(value).__name__
            refuse(walker, f"{what} is the {kind} {value.name} itself; take its symbol, {kind}(...).symbol")
        if not isinstance(value, sp.Expr) or isinstance(value, sp.MatrixBase):
            refuse(walker, f"{what} is {value!r}; it must be a single SymPy expression")
    for symbol, value in walker.section.items():
        if twice := value.free_symbols & walker.section.keys():
            refuse(walker, f"section gives {symbol} in terms of {min(map(str, twice))}, which it fixes too")


def _scalars(walker: Declaration) -> Iterator[tuple[str, Any]]:
    for body in walker.bodies:
        yield f"the mass of the body {body.name}", body.mass
        yield f"the inertia of the body {body.name}", body.inertia
        yield f"the angle of the body {body.name}", body.angle
    yield "the touchdown's condition", walker.touchdown.condition
    yield "the touchdown's region", walker.touchdown.region
    yield "the dissipation", walker.dissipation
    yield "the ground's angle", walker.ground
    yield "the rise", walker.rise
    for name, value in walker.potentials.items():
        yield f"the potential {name}", value
    for coordinate, value in walker.torques.items():
        yield f"the torque on {coordinate.name}", value
    for motor in walker.motors:
        yield f"the torque of the motor {motor.name}", motor.torque
        yield f"the drive of the motor {motor.name}", motor.drives
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
    for one in walker.quantities:
        yield f"the expression of the quantity {one.name}", one.expression


def _symbols(walker: Declaration) -> None:
    """Every symbol is a parameter, or something else that may stand there."""
    parameters = {a.symbol for a in walker.parameters}
    q, v, base = set(walker.q), set(walker.v), set(STANCE_FOOT)
    massless = {walker.massless.mass} if walker.massless is not None else set()
    if walker.massless is not None and massless & parameters:
        refuse(walker, f"{walker.massless.mass} goes to zero, so it cannot be a parameter; take it out")
    allowed = {
        "mass": parameters | massless,
        "inertia": parameters | massless,
        "angle": parameters | q,
        "potential": parameters | q | base | massless,
        "ground": parameters,
        "rise": parameters,
        "dissipation": parameters | q | v | massless,
        "torque": parameters | q | v | {TIME} | massless,
        "drive": parameters | q | base,
        "touchdown": parameters | q,
        "new": parameters | q,
        "value": parameters | q | v,
        "lock": parameters | q,
        "rate": parameters,
        "spring_mode": parameters,
        "expression": parameters | q | v | {TIME},
    }
    damping = walker.dissipation
    if damping != 0 and not damping.has(Term) and not damping.free_symbols & v:
        refuse(
            walker,
            f"the dissipation {short(damping)} has no rate in it, so it damps nothing; write half the "
            "power that is lost, such as c * rate**2 / 2, or leave it out",
        )
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
    elsewhere = base | massless | {TIME}
    names = {s.name: s for s in elsewhere | parameters | q | v}
    for what, value, known in checked:
        for symbol in sorted(value.free_symbols - known, key=str):
            twin = names.get(symbol.name)
            if twin is not None and twin != symbol:
                remedy = (
                    f"it is not the declared {symbol}: take Parameter(...).symbol or Coordinate(...).symbol"
                )
            elif twin is not None:
                remedy = "it may not stand there"
            else:
                remedy = f'declare Parameter("{symbol}", ...), or write what it stands for'
            refuse(walker, f"{what} has the symbol {symbol}, which is not a parameter; {remedy}")


def _translation(walker: Declaration) -> None:
    """Points move along with the stance foot."""
    points = [(f"the position of the body {b.name}", b.position) for b in walker.bodies]
    points += [("swing_foot", walker.swing_foot)]
    for what, point in points:
        if (point - STANCE_FOOT).applyfunc(sp.expand).free_symbols & set(STANCE_FOOT):
            refuse(walker, f"{what} does not move along with the stance foot; write STANCE_FOOT + ...")


def _two_numbers(value: Any) -> bool:
    if not isinstance(value, tuple | list) or len(value) != 2:
        return False
    return all(isinstance(x, int | float) and math.isfinite(x) for x in value)


def _search(walker: Declaration) -> None:
    names = walker.section_names
    for name in names:
        if name not in walker.search_box:
            refuse(walker, f"search_box lacks {name}; give {name} a middle and a half-width")
    known = {s.name for s in (*walker.q, *walker.v)}
    for name, box in walker.search_box.items():
        if name not in known:
            refuse(
                walker,
                f"search_box names {name}, which is neither one of its coordinates nor a rate; leave it out",
            )
        if not _two_numbers(box) or box[1] < 0:
            refuse(
                walker, f"search_box gives {name} {box}; a middle and a half-width of at least 0 are needed"
            )
    low, high = walker.period_range if walker.period_range and _two_numbers(walker.period_range) else (0, 0)
    if not 0 < low < high:
        refuse(
            walker,
            f"period_range = {walker.period_range} is not allowed; "
            "give (shortest, longest) with 0 < shortest < longest",
        )
