"""Functions that generated code has no form for, or that are not smooth, are refused before a derivation."""

from collections.abc import Iterable, Iterator
from typing import Any

import sympy as sp

from stridemap.derive.declaration import Declaration
from stridemap.derive.printers.expression import CALLS, HIGHEST_POWER
from stridemap.derive.terms import Term, terms_in
from stridemap.derive.validate.refusal import refuse

LOWEST_POWER = 2 - HIGHEST_POWER
"""Two derivatives are taken of some expressions, each of which lowers a power by one."""

_LIMIT = "soften the limit, for instance u_max tanh(x/u_max) for a torque that saturates"
_SWITCH = "soften the switch with (1 + tanh(s x))/2 and a steep s"
_REMEDIES = {
    "Max": _LIMIT + " or (a + b + sqrt((a - b)^2 + eps^2))/2 for the larger of a and b",
    "Min": _LIMIT + " or (a + b - sqrt((a - b)^2 + eps^2))/2 for the smaller of a and b",
    "Abs": "soften the corner with sqrt(x^2 + eps^2)",
    "sign": "soften the jump with tanh(s x) and a steep s",
    "Heaviside": _SWITCH,
    "Piecewise": f"{_SWITCH} in front of each piece",
    "floor": "a jump has no derivative; write a smooth function in its place",
    "ceiling": "a jump has no derivative; write a smooth function in its place",
    "frac": "a jump has no derivative; write a sine in its place",
    "Mod": "a jump has no derivative; use the sine or cosine of an angle, which repeat by themselves",
    "atan2": "write atan(y/x) where x keeps its sign, or 2 atan(y/(sqrt(x^2 + y^2) + x))",
    "arg": "write atan(y/x) where x keeps its sign",
    "sec": "write 1/cos(x)",
    "csc": "write 1/sin(x)",
    "cot": "write cos(x)/sin(x)",
    "sinc": "write sin(x)/x where x is never zero",
    "asinh": "write log(x + sqrt(x^2 + 1))",
    "acosh": "write log(x + sqrt(x^2 - 1))",
    "atanh": "write log((1 + x)/(1 - x))/2",
    "coth": "write 1/tanh(x)",
    "sech": "write 1/cosh(x)",
    "csch": "write 1/sinh(x)",
}
"""What can be written in place of a function, by its name."""


def validate_smooth(walker: Declaration, expressions: Iterable[tuple[str, Any]]) -> None:
    """Look for functions that equations cannot hold.

    Parameters
    ----------
    walker : Walker
    expressions : iterable of (str, sympy.Expr or sympy.Matrix)
        What is to be looked at, with what it is.

    Raises
    ------
    InputError
        For the first one found, with what can be written in its place.
    """
    for what, value in expressions:
        for part in _parts(value):
            if said := _fault(part):
                refuse(walker, f"{what} {said}")


def _parts(value: Any) -> Iterator[sp.Basic]:
    """Every part of an expression, each once, the whole first."""
    entries = list(value) if isinstance(value, sp.MatrixBase) else [sp.sympify(value)]
    todo = [*entries, *(t.definition for t in terms_in(entries))]
    seen: set[sp.Basic] = set()
    while todo:
        part = todo.pop(0)
        if part not in seen:
            seen.add(part)
            yield part
            todo += [a for a in part.args if not isinstance(a, Term)]


def _fault(part: sp.Basic) -> str | None:
    """What is wrong with the outermost operation of an expression; None where nothing is."""
    name = part.func.__name__
    if part.is_Add or part.is_Mul or part.is_Symbol or part.func in CALLS or part is sp.pi:
        return None
    if part.is_Rational and part.is_finite:
        return None
    if isinstance(part, sp.Pow):
        return _power(part)
    if part.is_number and part.is_Atom:
        return f"has the number {part}; generated code has fractions and pi only"
    known = ", ".join(CALLS.values())
    remedy = _REMEDIES.get(name, f"write it with + - * /, powers, sqrt, {known}")
    why = "is not smooth" if name in _NOT_SMOOTH else "is not a function that generated code has"
    return f"has the function {name}, which {why}; {remedy}"


_NOT_SMOOTH = frozenset("Max Min Abs sign Heaviside Piecewise floor ceiling frac Mod atan2 arg".split())


def _power(part: sp.Pow) -> str | None:
    exponent = part.exp
    if (2 * exponent).is_Integer and LOWEST_POWER <= exponent <= HIGHEST_POWER:
        return None
    return (
        f"has the power {part}; exponents are integers or halves from {LOWEST_POWER} to {HIGHEST_POWER}; "
        "write exp(a*log(x)) for any other power of a positive x"
    )
