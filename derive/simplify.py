"""Shorter forms of an expression, sought with effort that is bounded by the expression's size.

`simplified` gives short expressions the form that reads best. What would take long is brought into a normal
form instead, in which products of sines and cosines are sums of sines and cosines; and what is too large even
for that, or has sums in denominators, stays as it is. Bounds are numbers of terms and not of seconds, so
that the result is the same on every machine.
"""

from collections import Counter
from math import comb

import sympy as sp
from sympy.functions.elementary.hyperbolic import HyperbolicFunction

from stridemap.derive.normal_form import normal_form
from stridemap.derive.terms import Term

READABLE = 64
"""Terms that an expression may have, when it is multiplied out, to be given its most readable form."""

TRIED = 300
"""Terms when multiplied out, times different symbols and functions, up to which it is given that form."""

AT_ONCE = 200
"""Terms times different symbols and functions up to which SymPy seeks identities of other functions than
sines and cosines: in a larger sum it may try for minutes."""

GENERATORS = 14
"""Different symbols and functions up to which it is given that form."""

COLLECTED = 150
"""Operations of a normal form up to which it is tried to collect its terms by each of its symbols."""

QUOTIENT = 30
"""Operations that an expression with sums in denominators may have to be given its most readable form."""

PRODUCTS = 20_000
"""Products of two terms that may be formed to bring an expression into normal form."""


_KNOWN: dict[sp.Expr, sp.Expr] = {}
"""What has been simplified in this derivation."""


def start_afresh() -> None:
    """Forget what was simplified, so that no derivation depends on those before it in the process."""
    _KNOWN.clear()


def simplified(expr: sp.Expr) -> sp.Expr:
    """The shortest of a few equivalent forms, so that equations stay checkable by eye.

    Parameters
    ----------
    expr : sympy.Expr
        Terms in it are taken for symbols.
    """
    if expr not in _KNOWN:
        found = expr if expr.is_Atom else _simplified(expr)
        _KNOWN[expr] = found
        _KNOWN.setdefault(found, found)  # what has been shortened once is as short as it gets
    return _KNOWN[expr]


def _simplified(expr: sp.Expr) -> sp.Expr:
    if terms := sorted(expr.atoms(Term), key=sp.default_sort_key):
        stand_in = {t: sp.Symbol(f"{t.name}_{i}", real=True) for i, t in enumerate(terms)}
        back = {s: t for t, s in stand_in.items()}
        return simplified(expr.xreplace(stand_in)).xreplace(back)
    if has_quotient(expr):
        return _readable(expr) if sp.count_ops(expr) <= QUOTIENT else expr
    if expanded_size(expr) <= READABLE:
        expanded = sp.expand(expr)
        if _generators(expanded) <= GENERATORS and _effort(expanded) <= TRIED:
            return _readable(expr)
    found = normal_form(expr, PRODUCTS)
    if found is None:
        return expr
    candidates = [expr, found, sp.factor_terms(found)]
    if sp.count_ops(found) <= COLLECTED and not _denominators(found):
        candidates += _collected(found)
    return min(candidates, key=sp.count_ops)


def _collected(total: sp.Expr) -> list[sp.Expr]:
    """A sum with its terms collected by each symbol that several of them have."""
    terms = sp.Add.make_args(total)
    often = Counter(symbol for term in terms for symbol in term.free_symbols)
    several = sorted((s for s, times in often.items() if times > 1), key=lambda s: s.name)
    return [sp.collect(total, s) for s in several]


def _generators(expanded: sp.Expr) -> int:
    """Number of different symbols and functions."""
    return len(expanded.free_symbols) + len(expanded.atoms(sp.Function))


def _effort(expanded: sp.Expr) -> int:
    """Number of terms times that of different symbols and functions."""
    return len(sp.Add.make_args(expanded)) * _generators(expanded)


def _readable(expr: sp.Expr) -> sp.Expr:
    expanded = sp.expand(expr)
    whole = _reduced(expr, expanded)
    reduced = sp.expand(whole)
    base = min(reduced, expanded, key=sp.count_ops)
    candidates = [expr, expanded, whole, reduced, sp.factor(reduced)]
    candidates += _collected(base)
    candidates = list(dict.fromkeys(candidates))
    return _shortest([*candidates, *map(sp.factor_terms, candidates)])


def _reduced(expr: sp.Expr, expanded: sp.Expr) -> sp.Expr:
    """What is left of an expression when identities of sines and cosines have been used.

    Its normal form has it all, in milliseconds; identities of other functions are left to SymPy.
    """
    found = None if expr.has(sp.tan, HyperbolicFunction) else normal_form(expr, PRODUCTS)
    if found is not None:
        return found
    return sp.trigsimp(expanded) if _effort(expanded) <= AT_ONCE else expanded


def _shortest(candidates: list[sp.Expr]) -> sp.Expr:
    counted = [(sp.count_ops(e), e) for e in dict.fromkeys(candidates)]
    least = min(count for count, _ in counted)
    return min((e for count, e in counted if count == least), key=sp.default_sort_key)


def has_quotient(expr: sp.Expr) -> bool:
    """Whether sums of sines stand in a denominator, or several sums: what an expansion multiplies out."""
    below = _denominators(expr)
    return len(below) > 2 or any(base.has(sp.sin, sp.cos) for base in below)


def _denominators(expr: sp.Expr) -> set[sp.Expr]:
    return {p.base for p in expr.atoms(sp.Pow) if p.exp.is_negative and p.base.is_Add}


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
