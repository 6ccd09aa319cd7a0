"""Named intermediate terms: expressions that are kept as short lists of steps, and never multiplied out.

A `Term` stands for an expression wherever a symbol could stand, and knows what it stands for. What is made of
terms is a straight-line program from the start: each step is short, and a term that is used often is
written, differentiated and simplified once. So the work grows with the number of steps, while the expression
written out in full can grow exponentially.
"""

import hashlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache
from typing import Any

import sympy as sp

from stridemap.derive import given
from stridemap.errors import InputError
from stridemap.errors import short as shown

DEEP = 20
"""Terms in a row beyond which they are treated from the first to the last instead of by recursion."""


class Term(sp.Symbol):
    """A symbol that stands for an expression of parameters, coordinates, rates, time and earlier terms.

    Derivatives and substitutions see through it: they give another term, or a number where nothing is left.
    `free_symbols` are those of what it stands for.

    Parameters
    ----------
    name : str
        What it is called in generated code, where nothing else is called so; "" if any name will do. Letters
        without accents, digits and underscores, the first a letter.
    definition : sympy.Expr
        What it stands for. A number, a symbol and another term stay what they are.

    Raises
    ------
    InputError
        When the name cannot be one, or the definition is not a single expression.
    """

    definition: sp.Expr
    _digest: str
    _free: frozenset[sp.Symbol]
    _depth: int
    _known: dict[Any, sp.Expr]

    def __new__(cls, name: str, definition: Any, **_: Any) -> Any:
        """A term, or the definition itself where it is a number, a symbol or another term."""
        if not isinstance(name, str) or (name and not _is_name(name)):
            raise InputError(
                f"a Term has the name {shown(name)}, which cannot stand in generated code; "
                "take letters, digits and underscores, a letter first"
            )
        definition = given.expression(definition, f"what the Term {shown(name)} stands for")
        if definition.is_Number or definition.is_Symbol:
            return definition
        return _interned(name, definition)

    @property
    def free_symbols(self) -> set[sp.Basic]:
        """Symbols of what it stands for; no term is among them."""
        return set(self._free)

    def _hashable_content(self) -> tuple[Any, ...]:
        return (self.name, self._digest)

    def __getnewargs_ex__(self) -> tuple[tuple[str, sp.Expr], dict[str, Any]]:
        return (self.name, self.definition), {}

    def __reduce_ex__(self, protocol: Any) -> tuple[Any, ...]:
        return Term, (self.name, self.definition)

    def sort_key(self, order: Any = None) -> Any:
        """Terms of one name are in an order of their own, which does not change from run to run."""
        return self.class_key(), (2, (self.name, self._digest)), sp.S.One.sort_key(), sp.S.One

    def _sympyrepr(self, _: Any) -> str:
        return f"Term({self.name!r}, {self._digest})"

    def _sympystr(self, _: Any) -> str:
        return self.name or f"term_{self._digest[:6]}"

    def _eval_derivative(self, s: sp.Expr) -> sp.Expr:
        if s not in self._free:
            return sp.Integer(int(s == self))
        for term in self._undone(s):
            name = f"{term.name}_{s.name}" if term.name else ""
            term._known[s] = short(name, term.definition.diff(s))
        return self._known[s]

    def _eval_derivative_n_times(self, s: sp.Expr, n: Any) -> sp.Expr:
        return sp.Basic._eval_derivative_n_times(self, s, n)

    def _undone(self, key: Any) -> Iterator["Term"]:
        """Earlier terms and this one for which nothing is known under a key, the earliest first."""
        if key not in self._known:
            earlier = terms_in([self.definition]) if self._depth > DEEP else ()
            yield from (t for t in (*earlier, self) if key not in t._known)

    def _eval_subs(self, old: sp.Basic, new: sp.Basic) -> sp.Expr:
        if isinstance(old, sp.Symbol) and old not in self._free:
            return self
        for term in self._undone((old, new)):
            term._known[old, new] = term._with(term.definition.subs(old, new))
        return self._known[old, new]

    def _xreplace(self, rule: Mapping[sp.Basic, sp.Basic]) -> tuple[sp.Expr, bool]:
        if self in rule:
            return rule[self], True
        pairs = frozenset(rule.items())
        for term in self._undone(pairs):
            term._known[pairs] = term._with(term.definition._xreplace(rule)[0])
        return self._known[pairs], self._known[pairs] is not self

    def _with(self, definition: sp.Expr) -> sp.Expr:
        return self if definition == self.definition else Term(self.name, definition)

    def _eval_evalf(self, prec: int) -> sp.Expr | None:
        value = self.definition._eval_evalf(prec)
        return value if value is not None and not value.free_symbols else self


def _is_name(name: str) -> bool:
    return name.isascii() and name.isidentifier() and not name.startswith("_")


@cache
def _interned(name: str, definition: sp.Expr) -> Term:
    """The one term of this name and definition, so that equal terms are identical."""
    term: Term = sp.Symbol.__xnew__(Term, name, real=True)
    term.definition = definition
    term._free = frozenset(definition.free_symbols)
    term._depth = 1 + max((t._depth for t in definition.atoms(Term)), default=0)
    term._known = {}  # derivatives and substitutions that were asked for
    term._digest = hashlib.sha256(f"{name}={sp.srepr(definition)}".encode()).hexdigest()[:32]
    return term


def short(name: str, expr: sp.Expr) -> sp.Expr:
    """`expr` as a term, unless it is a single cheap operation, which is shorter than a name."""
    return expr if sp.count_ops(expr) <= 1 else Term(name, expr)


def terms_in(exprs: Iterable[sp.Basic]) -> Iterator[Term]:
    """All terms that expressions are made of, each after those that it uses itself."""
    done: set[Term] = set()
    for expr in exprs:
        # Without recursion: a chain of terms may be longer than Python's stack.
        stack = [(t, False) for t in _direct(expr)]
        while stack:
            term, ready = stack.pop()
            if term in done:
                continue
            if ready:
                done.add(term)
                yield term
            else:
                stack.append((term, True))
                stack += [(t, False) for t in _direct(term.definition)]


def _direct(expr: sp.Basic) -> list[Term]:
    """Terms that stand in an expression itself, in a fixed order."""
    return sorted(expr.atoms(Term), key=sp.default_sort_key, reverse=True)


def mapped(expr: sp.Basic, change: Callable[[sp.Basic], sp.Basic]) -> sp.Basic:
    """`change` of an expression, and of what every term in it stands for."""
    known: dict[sp.Basic, sp.Basic] = {}
    for term in terms_in([expr]):
        definition = change(_plain(term.definition, known))
        known[term] = term if definition == term.definition else Term(term.name, definition)
    return change(_plain(expr, known))


def opened(expr: Any) -> Any:
    """An expression or matrix with every term replaced by what it stands for."""
    if isinstance(expr, sp.MatrixBase):
        return expr.applyfunc(opened)
    if not isinstance(expr, sp.Basic):
        return expr
    known: dict[sp.Basic, sp.Basic] = {}
    for term in terms_in([expr]):
        known[term] = _plain(term.definition, known)
    return _plain(expr, known)


def _plain(expr: sp.Basic, known: Mapping[sp.Basic, sp.Basic]) -> sp.Basic:
    """`expr` with the terms that stand in it directly replaced."""
    return expr.xreplace({t: known[t] for t in expr.atoms(Term)})


def operations(expr: sp.Expr) -> int:
    """Operations of an expression, each term counted once."""
    return int(sp.count_ops(expr)) + sum(int(sp.count_ops(t.definition)) for t in terms_in([expr]))


def statements(
    exprs: Sequence[sp.Expr], name: Callable[[Term], sp.Symbol]
) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Expr]]:
    """The terms of expressions as statements, each in earlier ones, and the expressions in their symbols.

    Parameters
    ----------
    exprs : sequence of sympy.Expr
    name : callable
        Gives the symbol that a term is called from then on.
    """
    symbols: dict[sp.Basic, sp.Basic] = {}
    found: dict[sp.Symbol, sp.Expr] = {}
    for term in terms_in(exprs):
        symbol = symbols[term] = name(term)
        found[symbol] = _plain(term.definition, symbols)
    return found, [_plain(e, symbols) for e in exprs]
