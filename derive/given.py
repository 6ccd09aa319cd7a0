"""What the functions that a declaration is written with are given: one expression, or a matrix of them.

A declaration itself is checked field by field in `validate`; here is what runs before there is one.
"""

from typing import Any

import sympy as sp

from stridemap.errors import InputError
from stridemap.errors import short as shown

SMALLEST, LARGEST = sp.Rational(1, 10**300), sp.Integer(10) ** 300
"""Bounds of a number in an expression: doubles reach from 1e-308 to 1e308, and products need room."""

OUT_OF_RANGE = (
    "a number that is too large or too small for double precision; "
    "write it with numbers between 1e-300 and 1e300"
)
"""The end of a sentence."""


def expression(value: Any, what: str) -> sp.Expr:
    """`value` as one SymPy expression.

    Parameters
    ----------
    value : Any
    what : str
        Begins the sentence of the error, as in "the radius of rolling_arc".

    Raises
    ------
    InputError
        When it is something else, such as a text, a truth value, a list, or a `Parameter` in place of its
        symbol; and when it has a number that generated code cannot hold.
    """
    if isinstance(value, sp.Expr) and not isinstance(value, sp.MatrixBase | sp.MatrixExpr):
        return _held(value, what)
    if isinstance(value, int | float) and not isinstance(value, bool):
        return _held(sp.sympify(value), what)
    raise InputError(f"{what} is {shown(value)}; it must be a single SymPy expression{_cure(value)}")


def matrix(value: Any, what: str) -> sp.MatrixBase:
    """`value`, which must be a matrix; `what` begins the sentence of the error.

    Raises
    ------
    InputError
        When it is something else.
    """
    if isinstance(value, sp.MatrixBase):
        return value
    raise InputError(f"{what} is {shown(value)}; it must be a sympy.Matrix of expressions{_cure(value)}")


def is_out_of_range(value: sp.Basic | sp.MatrixBase) -> bool:
    """Whether an expression has a number that generated code cannot hold, in a fraction or by itself."""
    numbers = (number for number in value.atoms(sp.Rational, sp.Float) if number.is_finite)
    parts = [p for n in numbers for p in ((n.p, n.q) if isinstance(n, sp.Rational) else (n,))]
    return any(part != 0 and not SMALLEST < abs(part) < LARGEST for part in parts)


def _held(value: sp.Expr, what: str) -> sp.Expr:
    if is_out_of_range(value):
        raise InputError(f"{what} has {OUT_OF_RANGE}")
    return value


def _cure(value: Any) -> str:
    return "; take its symbol, .symbol" if hasattr(type(value), "symbol") else ""
