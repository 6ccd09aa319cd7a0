"""Positions at which what a declaration says is tried out in numbers."""

import math
from collections.abc import Iterator, Mapping

import sympy as sp

from stridemap.derive.declaration import Declaration

TRIES = 12
"""Number of positions."""


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
