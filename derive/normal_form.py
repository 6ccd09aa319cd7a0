"""Sums of sines and cosines with polynomial coefficients: what the mechanics of links is made of.

Products of sines and cosines become sums, so that two expressions that are equal have the same form and what
cancels is gone. The work is a number of products of polynomials, which is bounded beforehand.
"""

from collections.abc import Callable, Iterable
from functools import cache

import sympy as sp
from sympy.polys.rings import PolyElement, PolyRing

Key = tuple[sp.Expr, bool]
"""An angle and whether it is its sine; the cosine of zero is the number one."""

Sum = dict[Key, PolyElement]

ONE: Key = (sp.S.Zero, False)


class TooLargeError(Exception):
    """The normal form has more terms than are allowed."""


def normal_form(
    expr: sp.Expr,
    largest: int,
    constants: Iterable[sp.Symbol] = (),
    name: Callable[[sp.Expr], sp.Expr] | None = None,
) -> sp.Expr | None:
    """An expression as a sum of sines and cosines with coefficients; None where it is too large.

    Parameters
    ----------
    expr : sympy.Expr
        What is neither a sum, a product, a positive power, a sine nor a cosine in it is taken for a symbol.
    largest : int
        Products of terms that may be formed.
    constants : iterable of Symbol
        Symbols whose polynomials are kept together.
    name : callable, optional
        What is made of each polynomial of the constants alone.
    """
    generators: set[sp.Expr] = set()
    _collect(expr, generators)
    ring = PolyRing(sorted(generators, key=sp.default_sort_key), sp.QQ) if generators else PolyRing([], sp.QQ)
    try:
        found = _Transform(ring, largest).of(expr)
    except TooLargeError:
        return None
    fixed = {i for i, g in enumerate(ring.symbols) if g.free_symbols <= set(constants)} if name else set()
    parts = []
    for angle, is_sine in sorted(found, key=lambda key: (sp.default_sort_key(key[0]), key[1])):
        call = sp.sin(angle) if is_sine else sp.cos(angle)
        parts.append(_coefficient(found[angle, is_sine], fixed, name) * call)
    return sp.Add(*parts)


def _coefficient(poly: PolyElement, fixed: set[int], name: Callable[[sp.Expr], sp.Expr] | None) -> sp.Expr:
    if name is None:
        return _short(poly.as_expr())
    groups: dict[tuple[int, ...], PolyElement] = {}
    for powers, number in poly.terms():
        rest = tuple(0 if i in fixed else p for i, p in enumerate(powers))
        own = tuple(p if i in fixed else 0 for i, p in enumerate(powers))
        groups.setdefault(rest, poly.ring.zero)
        groups[rest] += poly.ring.from_dict({own: number})
    return sp.Add(
        *(
            name(_short(own.as_expr())) * poly.ring.from_dict({rest: sp.QQ(1)}).as_expr()
            for rest, own in groups.items()
        )
    )


def _short(expr: sp.Expr) -> sp.Expr:
    """A polynomial with what its terms have in common taken out."""
    return expr if sp.count_ops(expr) <= 1 else sp.factor_terms(expr)


def _collect(expr: sp.Expr, generators: set[sp.Expr]) -> None:
    if expr.is_Add or expr.is_Mul:
        for a in expr.args:
            _collect(a, generators)
    elif expr.is_Pow and expr.exp.is_Integer and expr.exp.is_positive:
        _collect(expr.base, generators)
    elif not (expr.is_Rational or isinstance(expr, sp.sin | sp.cos)):
        generators.add(expr)


class _Transform:
    """Expressions to sums, over one ring of polynomials."""

    def __init__(self, ring: PolyRing, largest: int) -> None:
        self._ring = ring
        self._left = largest
        self._half = sp.QQ(1, 2)

    def of(self, expr: sp.Expr) -> Sum:
        """The sum that an expression is."""
        if expr.is_Add:
            total: Sum = {}
            for a in expr.args:
                for key, poly in self.of(a).items():
                    self._add(total, key, poly)
            return total
        if expr.is_Mul:
            product = {ONE: self._ring.one}
            for a in expr.args:
                product = self._times(product, self.of(a))
            return product
        if expr.is_Pow and expr.exp.is_Integer and expr.exp.is_positive:
            base, product = self.of(expr.base), {ONE: self._ring.one}
            for _ in range(int(expr.exp)):
                product = self._times(product, base)
            return product
        if isinstance(expr, sp.sin | sp.cos):
            single: Sum = {}
            self._put(single, sp.expand(expr.args[0]), isinstance(expr, sp.sin), self._ring.one)
            return single
        if expr.is_Rational:
            return {ONE: self._ring.ground_new(sp.QQ(int(expr.p), int(expr.q)))}
        return {ONE: self._ring.gens[self._ring.symbols.index(expr)]}

    def _times(self, one: Sum, other: Sum) -> Sum:
        self._left -= sum(map(len, one.values())) * sum(map(len, other.values()))
        if self._left < 0:
            raise TooLargeError
        total: Sum = {}
        for (a, a_sine), p in one.items():
            for (b, b_sine), q in other.items():
                product = p * q
                if (a, a_sine) == ONE or (b, b_sine) == ONE:
                    self._add(total, (b, b_sine) if (a, a_sine) == ONE else (a, a_sine), product)
                    continue
                product = product * self._half
                both = a_sine and b_sine
                self._put(total, _sum(a, b), a_sine != b_sine, -product if both else product)
                # sin(a) cos(b) has + sin(a - b), cos(a) sin(b) has - sin(a - b).
                self._put(
                    total, _sum(a, -b), a_sine != b_sine, -product if b_sine and not a_sine else product
                )
        return total

    def _put(self, total: Sum, angle: sp.Expr, is_sine: bool, poly: PolyElement) -> None:
        """Add a sine or cosine, with the angle's sign made unique."""
        if angle == 0:
            if not is_sine:
                self._add(total, ONE, poly)
            return
        if angle.could_extract_minus_sign():
            angle = -angle
            poly = -poly if is_sine else poly
        self._add(total, (angle, is_sine), poly)

    @staticmethod
    def _add(total: Sum, key: Key, poly: PolyElement) -> None:
        known = total.get(key)
        if known is not None:
            poly = known + poly
        if poly:
            total[key] = poly
        else:
            total.pop(key, None)


@cache
def _sum(a: sp.Expr, b: sp.Expr) -> sp.Expr:
    return sp.expand(a + b)
