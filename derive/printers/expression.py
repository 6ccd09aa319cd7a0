"""One expression printer for all languages; it knows a few operations and refuses the rest.

C, Python and CasADi evaluate what it prints in the same order, so they agree to the last bit where
their sines do.
"""

from collections.abc import Callable, Mapping

import sympy as sp

from stridemap.derive.elementary import CALLS, HIGHEST_POWER


class ExpressionPrinter:
    """Prints an expression as infix code.

    Parameters
    ----------
    number : callable
        Prints an integer (a literal ``2`` is an int in Python but should be ``2.0`` in C).
    call : callable
        Prints a function call from its name and printed argument.
    pi : str
        How the number pi is written.
    names : mapping of Symbol to str
        What symbols are called, where it is not by their own names. (To rename them in the expression would
        change the order of its terms.)
    integer : callable, optional
        Prints an integer that stands beside something that is not one; by default as `number` does.
    """

    def __init__(
        self,
        number: Callable[[int], str],
        call: Callable[[str, str], str],
        pi: str,
        names: Mapping[sp.Symbol, str],
        integer: Callable[[int], str] | None = None,
    ) -> None:
        self._number = number
        self._integer = integer or number
        self._call = call
        self._pi = pi
        self._names = names

    def __call__(self, expr: sp.Expr) -> str:
        """Print `expr`; raises TypeError for an operation that is not in the table."""
        return self._sum(expr)

    def _sum(self, expr: sp.Expr) -> str:
        if not expr.is_Add:
            return self._product(expr)
        terms = expr.as_ordered_terms()
        leading = next((t for t in terms if not _negative(t)), terms[0])
        terms.remove(leading)
        text = self._product(leading)
        for term in terms:
            negative = _negative(term)
            text += (" - " if negative else " + ") + self._product(-term if negative else term)
        return text

    def _product(self, expr: sp.Expr) -> str:
        sign = ""
        if _negative(expr):
            sign, expr = "-", -expr
        coefficient, rest = expr.as_coeff_Mul()
        if not coefficient.is_Rational:
            raise TypeError(
                f"cannot print the number {coefficient}: generated code has only integers and fractions"
            )
        fraction = rest is sp.S.One and coefficient.q != 1
        first = (self._number if fraction else self._integer)(int(coefficient.p))
        above = [] if coefficient.p == 1 and rest is not sp.S.One else [first]
        below = [] if coefficient.q == 1 else [self._integer(int(coefficient.q))]
        for factor in rest.as_ordered_factors() if rest is not sp.S.One else []:
            base, exponent = factor.as_base_exp() if factor.is_Pow else (factor, sp.S.One)
            if exponent.is_negative:
                below += self._power(base, -exponent)
            else:
                above += self._power(base, exponent)
        text = sign + ("*".join(above) or self._integer(1))
        if not below:
            return text
        return f"{text}/{below[0]}" if len(below) == 1 else f"{text}/({'*'.join(below)})"

    def _power(self, base: sp.Expr, exponent: sp.Expr) -> list[str]:
        """A power as factors: the languages have no power of their own in common."""
        if not (2 * exponent).is_Integer or exponent > HIGHEST_POWER:
            raise TypeError(
                f"cannot print the power ({base})**({exponent}): generated code has exponents up to "
                f"{HIGHEST_POWER} that are integers or halves"
            )
        root = [] if exponent.is_Integer else [self._call("sqrt", self._sum(base))]
        return root + [self._atom(base)] * int(exponent)

    def _atom(self, expr: sp.Expr) -> str:
        if expr.is_Symbol:
            return self._names.get(expr, str(expr.name))
        if expr is sp.pi:
            return self._pi
        if expr.is_Add or (expr.is_Mul or expr.is_Pow):
            return f"({self._sum(expr)})"
        if expr.is_Integer:
            return self._integer(int(expr)) if expr >= 0 else f"({self._integer(int(expr))})"
        if expr.func in CALLS:
            return self._call(CALLS[expr.func], self._sum(expr.args[0]))
        known = ", ".join(CALLS.values())
        raise TypeError(
            f"cannot print {expr.func.__name__} in {expr}: generated code has + - * /, powers, {known}"
        )


def _negative(expr: sp.Expr) -> bool:
    """Whether a term bears a minus sign of its own."""
    return bool(expr.as_coeff_Mul()[0].is_negative)
