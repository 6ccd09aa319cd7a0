"""Shorter forms of an expression, sought with effort that is bounded by the expression's size.

`simplified` gives short expressions the form that reads best. What would take long is brought into a normal
form instead, in which products of sines and cosines are sums of sines and cosines; and what is too large even
for that, or has sums in denominators, is left as it is. Bounds are numbers of terms and not of seconds, so that
the result is the same on every machine.
"""

from functools import cache
from math import comb

import sympy as sp

from stridemap.derive.normal_form import normal_form
from stridemap.derive.terms import Term

READABLE = 70
"""Terms that an expression may have, when it is multiplied out, to be given its most readable form."""

QUOTIENT = 30
"""Operations that an expression with sums in denominators may have to be given its most readable form."""

PRODUCTS = 20_000
"""Products of two terms that may be formed to bring an expression into normal form."""


@cache
def simplified(expr: sp.Expr) -> sp.Expr:
    """The shortest of a few equivalent forms, so that equations stay checkable by eye.

    Parameters
    ----------
    expr : sympy.Expr
        Terms in it are taken for symbols.
    """
    if expr.is_Atom:
        return expr
    if terms := sorted(expr.atoms(Term), key=sp.default_sort_key):
        stand_in = {t: sp.Symbol(f"{t.name}_{i}", real=True) for i, t in enumerate(terms)}
        back = {s: t for t, s in stand_in.items()}
        return simplified(expr.xreplace(stand_in)).xreplace(back)
    if has_quotient(expr):
        return _readable(expr) if sp.count_ops(expr) <= QUOTIENT else expr
    if expanded_size(expr) <= READABLE:
        return _readable(expr)
    found = normal_form(expr, PRODUCTS)
    return expr if found is None else min(expr, found, sp.factor_terms(found), key=sp.count_ops)


def _readable(expr: sp.Expr) -> sp.Expr:
    expanded = sp.expand(expr)
    reduced = sp.trigsimp(expanded)
    candidates = [expr, expanded, reduced, sp.factor(reduced)]
    for symbol in sorted(reduced.free_symbols, key=lambda s: s.name):
        candidates += [sp.collect(expanded, symbol), sp.collect(reduced, symbol)]
    candidates += [sp.factor_terms(c) for c in candidates]
    return min(candidates, key=lambda e: (sp.count_ops(e), sp.default_sort_key(e)))


def has_quotient(expr: sp.Expr) -> bool:
    """Whether a sum stands in a denominator, which an expansion multiplies and never cancels."""
    return any(p.exp.is_negative and p.base.is_Add for p in expr.atoms(sp.Pow))


def expanded_size(expr: sp.Expr) -> int:
    """An upper bound of the number of terms that an expression has when it is multiplied out."""
    if expr.is_Add:
        return sum(expanded_size(a) for a in expr.args)
    if expr.is_Mul:
        size = 1
        for a in expr.args:
            size *= expanded_size(a)
        return size
    if expr.is_Pow and expr.exp.is_Integer and expr.exp.is_positive:
        terms, power = expanded_size(expr.base), int(expr.exp)
        return comb(terms + power - 1, power)
    return 1
