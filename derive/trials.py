"""Positions at which what a declaration says is tried out in numbers."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import lru_cache
from typing import Any

import sympy as sp

from stridemap.derive.declaration import Declaration

TRIES = 12
"""Number of positions."""

LIGHT = 0.1
"""What a mass that vanishes is while a declaration is tried out."""


def trial_points(walker: Declaration, values: Mapping[sp.Symbol, float]) -> Iterator[dict[sp.Symbol, float]]:
    """Some positions near the middle of the search box, always the same ones.

    Parameters
    ----------
    walker : Walker
    values : mapping of Symbol to float
        Parameters.
    """
    boxes = {s: walker.search_box[s.name] for s in walker.q if s.name in walker.search_box}
    middles = {**values, **{symbol: middle for symbol, (middle, _) in boxes.items()}}
    for symbol in walker.q:
        if symbol not in boxes:  # what the section fixes lies where the others have it
            middle = sp.sympify(walker.section.get(symbol, 0)).subs(middles)
            boxes[symbol] = (float(middle) if middle.is_number and middle.is_real else 0.0, 0.5)
    for i in range(1, TRIES + 1):
        position = {}
        for j, symbol in enumerate(walker.q):
            middle, width = boxes[symbol]
            # Fractions of multiples of the golden ratio fill an interval evenly.
            spread = math.modf(i * 0.6180339887498949 + j * 0.7548776662466927)[0]
            position[symbol] = middle + width * (2 * spread - 1) * 0.5 + 1e-3 * (j + 1)
        yield position


def in_numbers(value: sp.Expr | sp.Matrix, place: Mapping[sp.Symbol, float]) -> sp.Expr | sp.Matrix:
    """An expression or matrix with numbers for its symbols.

    Parameters
    ----------
    value : sympy.Expr or sympy.Matrix
    place : mapping of Symbol to number
        Each symbol that does not occur takes as long as one that does, so such are left out.
    """
    known = value.free_symbols
    return value.subs({s: x for s, x in place.items() if s in known})


def compiled(
    walker: Declaration, expressions: Iterable[sp.Expr]
) -> Callable[[Mapping[sp.Symbol, Any]], list[Any]]:
    """A function from coordinates and parameters to the values of expressions: much faster than `subs`.

    Parameters
    ----------
    walker : Walker
    expressions : iterable of sympy.Expr
        Of the coordinates, the parameters and a mass that vanishes, which is `LIGHT`.
    """
    light = {} if walker.massless is None else {walker.massless.mass: LIGHT}
    symbols = (*walker.q, *(a.symbol for a in walker.parameters), *light)
    function = _function(symbols, tuple(map(sp.sympify, expressions)))
    return lambda values: function(*({**light, **values}[s] for s in symbols))


@lru_cache(64)
def _function(symbols: tuple[sp.Symbol, ...], expressions: tuple[sp.Expr, ...]) -> Callable[..., list[Any]]:
    """The function, made once: the same expressions are asked for again with other parameters."""
    # Stand-ins for all names: a parameter may be called like what the function itself uses.
    made: Callable[..., list[Any]] = sp.lambdify(symbols, list(expressions), "mpmath", dummify=True, cse=True)
    return made
