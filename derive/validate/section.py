"""Rates that a declaration fixes on the section are those that the derived impact leaves."""

import math

import mpmath
import sympy as sp

from stridemap.derive.mechanics import Mechanics
from stridemap.derive.trials import in_numbers
from stridemap.derive.validate.mechanics import TOLERANCE, touchdowns
from stridemap.derive.validate.refusal import refuse


def validate_section_rates(mechanics: Mechanics) -> None:
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
            mpmath.matrix(in_numbers(part, place).evalf().tolist()) for part in mechanics.impact_equations
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
