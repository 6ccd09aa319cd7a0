"""A function as a straight-line program: one ordered list of named intermediate terms.

Everything that is printed, in whatever language, prints this list, so that all of it computes the
same numbers in the same order.
"""

import re
from collections.abc import Container, Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import count

import sympy as sp

from stridemap.derive.simplify import simplified
from stridemap.derive.terms import Term, statements

FIRST_TERM = 10**6
"""Number of the first unnamed term: beyond those of shared terms, until all are numbered as they stand."""


@dataclass(frozen=True)
class Entry:
    """One scalar of an argument: its symbol, unit and meaning."""

    symbol: sp.Symbol
    unit: str
    meaning: str


@dataclass(frozen=True)
class Argument:
    """A named vector argument and what its entries are.

    Parameters
    ----------
    name : str
    entries : tuple of Entry
        A single entry makes it a scalar when `scalar` is true.
    scalar : bool
    """

    name: str
    entries: tuple[Entry, ...]
    scalar: bool = False


@dataclass(frozen=True)
class Output:
    """A named result: a scalar, a vector, shape (n, 1), or a matrix, shape (n, m).

    `is_matrix` tells a matrix of one column from a vector.
    """

    name: str
    value: sp.Matrix | sp.Expr
    meaning: str
    is_matrix: bool = False

    @property
    def shape(self) -> tuple[int, ...]:
        """() for a scalar, (n,) for a vector, (n, m) for a matrix."""
        if not isinstance(self.value, sp.MatrixBase):
            return ()
        rows, columns = self.value.shape
        return (rows, columns) if self.is_matrix or columns > 1 else (rows,)

    @property
    def entries(self) -> list[sp.Expr]:
        """The scalars in row-major order."""
        return list(self.value) if isinstance(self.value, sp.MatrixBase) else [self.value]


@dataclass(frozen=True)
class Program:
    """A function in static single assignment form.

    Parameters
    ----------
    name : str
        The quantity, for example ``mass_matrix``.
    summary, source : str
        What it computes, and the equation it comes from.
    arguments : tuple of Argument
        Only those that the function reads.
    statements : tuple of (Symbol, sympy.Expr)
        Intermediate terms; each uses arguments and earlier terms only.
    outputs : tuple of Output
        In terms of arguments and intermediate terms.
    signature : tuple of Argument
        All arguments of functions of its kind, whether this one reads them or not: the same for every model.
    """

    name: str
    summary: str
    source: str
    arguments: tuple[Argument, ...]
    statements: tuple[tuple[sp.Symbol, sp.Expr], ...]
    outputs: tuple[Output, ...]
    signature: tuple[Argument, ...] = ()

    @cached_property
    def operations(self) -> int:
        """Number of arithmetic operations and function calls."""
        terms = [e for _, e in self.statements] + [e for o in self.outputs for e in o.entries]
        return int(sum(sp.count_ops(e) for e in terms))

    @cached_property
    def used(self) -> set[sp.Symbol]:
        """Argument entries that some term reads."""
        terms = [e for _, e in self.statements] + [e for o in self.outputs for e in o.entries]
        return set().union(*(e.free_symbols for e in terms))


@dataclass(frozen=True)
class Factors:
    """Factors ``L D U`` of a matrix: unit triangular `lower` and `upper`, and the diagonal `pivots`."""

    lower: sp.Matrix
    pivots: list[sp.Expr]
    upper: sp.Matrix


def free(name: str, taken: Container[str]) -> str:
    """`name`, with underscores behind it until nothing else is called so."""
    while name in taken:
        name += "_"
    return name


@dataclass
class Builder:
    """Collects named intermediate terms and closes them into a `Program`.

    Parameters
    ----------
    arguments : tuple of Argument
        Arguments that the function may read; no term is named like one of them or of their entries.
    """

    arguments: tuple[Argument, ...]
    named: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)

    @cached_property
    def taken(self) -> frozenset[str]:
        """Names of arguments and of their entries."""
        names = [a.name for a in self.arguments] + [e.symbol.name for a in self.arguments for e in a.entries]
        return frozenset(names)

    def symbol(self, name: str) -> sp.Symbol:
        """A symbol of that name, or of a similar one that no argument bears."""
        return sp.Symbol(free(name, self.taken), real=True)

    def let(self, name: str, expr: sp.Expr, shorten: bool = True) -> sp.Expr:
        """Name an intermediate term; numbers and plain symbols are passed through."""
        expr = simplified(sp.sympify(expr)) if shorten else sp.sympify(expr)
        if expr.is_Number or expr.is_Symbol:
            return expr
        symbol = self.symbol(name)
        if symbol in self.named:
            raise ValueError(f"two intermediate terms are named {name}")
        self.named[symbol] = expr
        return symbol

    def let_vector(self, name: str, values: Iterable[sp.Expr], shorten: bool = True) -> sp.Matrix:
        """Name the entries of a vector ``<name>_1``, ``<name>_2``, ..."""
        return sp.Matrix([self.let(f"{name}_{i}", e, shorten) for i, e in enumerate(values, 1)])

    def let_symmetric(self, name: str, matrix: sp.Matrix) -> sp.Matrix:
        """Name the entries of a symmetric matrix ``<name>_11``, ``<name>_12``, ..., each once."""
        named = sp.Matrix(matrix)
        for i in range(matrix.rows):
            for j in range(i + 1):
                named[i, j] = named[j, i] = self.let(f"{name}_{j + 1}{i + 1}", matrix[i, j])
        return named

    def let_matrix(self, name: str, matrix: sp.Matrix, symmetric: bool = True) -> sp.Matrix:
        """Name the entries of a square matrix, those of a symmetric one once each."""
        if symmetric:
            return self.let_symmetric(name, matrix)
        return sp.Matrix(*matrix.shape, lambda i, j: self.let(f"{name}_{i + 1}{j + 1}", matrix[i, j]))

    def factor(self, name: str, matrix: sp.Matrix, symmetric: bool = True) -> "Factors":
        """Factor a matrix as ``L D U``, unrolled, with unit triangular L and U (U is L^T if symmetric).

        There is no pivoting: the matrices here are positive definite, or triangular in blocks that are.
        """
        n = matrix.rows
        lower, upper = sp.eye(n), sp.eye(n)
        pivots: list[sp.Expr] = []
        for j in range(n):
            done = range(j)
            pivot = matrix[j, j] - sum(lower[j, m] * upper[m, j] * pivots[m] for m in done)
            pivots.append(self.let(f"{name}_D{j + 1}", pivot))
            for i in range(j + 1, n):
                rest = matrix[i, j] - sum(lower[i, m] * upper[m, j] * pivots[m] for m in done)
                lower[i, j] = self.let(f"{name}_L{i + 1}{j + 1}", rest / pivots[j])
                if symmetric:
                    upper[j, i] = lower[i, j]
                else:
                    rest = matrix[j, i] - sum(lower[j, m] * upper[m, i] * pivots[m] for m in done)
                    upper[j, i] = self.let(f"{name}_U{j + 1}{i + 1}", rest / pivots[j])
        return Factors(lower, pivots, upper)

    def solve(self, name: str, factors: "Factors", right: sp.Matrix) -> sp.Matrix:
        """Solve ``L D U y = right`` by substitution, unrolled; the unknowns are named ``<name>_i``."""
        lower, upper = factors.lower, factors.upper
        n = lower.rows
        forward: list[sp.Expr] = []
        for i in range(n):
            term = right[i] - sum(lower[i, m] * forward[m] for m in range(i))
            forward.append(self.let(f"{name}_f{i + 1}", term))
        solution = sp.zeros(n, 1)
        for i in reversed(range(n)):
            term = forward[i] / factors.pivots[i] - sum(upper[i, m] * solution[m] for m in range(i + 1, n))
            solution[i] = self.let(f"{name}_{i + 1}", term)
        return solution

    def close(self, name: str, summary: str, source: str, outputs: Iterable[Output]) -> Program:
        """Share common subexpressions, order the terms and keep the arguments that are used."""
        arguments, outputs = self.arguments, tuple(outputs)
        raw = [*self.named.values(), *(e for o in outputs for e in o.entries)]
        taken = {*self.taken, *(s.name for s in self.named)}
        own, raw = _terms_by_name(raw, {*taken, *(o.name for o in outputs)})
        taken |= {s.name for s in own if not isinstance(s, sp.Dummy)}
        raw = [*own.values(), *raw]
        trig = _named_trigonometry(raw, taken)
        taken |= {*(s.name for s in trig.values()), *(o.name for o in outputs)}
        fresh = (sp.Dummy(f"t{i}", real=True) for i in range(1, 10**6))
        shared, reduced = sp.cse(
            [e.xreplace(trig) for e in raw],
            symbols=fresh,
            order="canonical",
        )
        terms, reduced = _without_trivial(dict(shared), reduced)
        terms, reduced = _under_their_names(terms, reduced, [*own, *self.named])
        terms, reduced = _without_copies(terms, reduced, own)
        terms |= {symbol: call for call, symbol in trig.items()}
        results = iter(reduced)
        closed = tuple(replace(o, value=_refill(o, results)) for o in outputs)
        ordered = list(_in_order(terms, [e for o in closed for e in o.entries]))
        numbered = _renumbered([s for s, _ in ordered], taken)
        statements = tuple((numbered.get(s, s), _fewer_signs(e.xreplace(numbered))) for s, e in ordered)
        closed = tuple(replace(o, value=_fewer_signs(o.value.xreplace(numbered))) for o in closed)
        program = Program(name, summary, source, arguments, statements, closed)
        known = {e.symbol for a in arguments for e in a.entries} | {s for s, _ in statements}
        if unknown := program.used - known:
            raise ValueError(f"{name} uses {sorted(map(str, unknown))}, which no argument or term defines")
        kept = tuple(a for a in arguments if program.used & {e.symbol for e in a.entries})
        return Program(name, summary, source, kept, statements, closed, arguments)


def _under_their_names(
    shared: dict[sp.Symbol, sp.Expr], reduced: list[sp.Expr], named: list[sp.Symbol]
) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Expr]]:
    """All terms by name, and the results: a shared term that is the whole of a named one bears its name."""
    alias: dict[sp.Symbol, sp.Symbol] = {}
    for symbol, expr in zip(named, reduced, strict=False):
        if expr in shared:
            alias.setdefault(expr, symbol)
    terms = {alias.get(s, s): e.xreplace(alias) for s, e in shared.items()}
    for symbol, expr in zip(named, reduced, strict=False):
        if symbol not in terms:
            terms[symbol] = expr.xreplace(alias)
    return terms, [e.xreplace(alias) for e in reduced[len(named) :]]


def _terms_by_name(raw: list[sp.Expr], taken: set[str]) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Expr]]:
    """The terms in expressions as statements, and the expressions with the terms' symbols in them."""
    known = set(taken)
    numbers = count(FIRST_TERM)

    def name(term: Term) -> sp.Symbol:
        if not term.name:
            return sp.Dummy(f"t{next(numbers)}", real=True)
        found = free(term.name, known)
        known.add(found)
        return sp.Symbol(found, real=True)

    return statements(raw, name)


def _without_copies(
    terms: dict[sp.Symbol, sp.Expr], exprs: list[sp.Expr], own: Container[sp.Symbol]
) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Expr]]:
    """Leave out those of `own` that are nothing but another term, or a number."""
    copies = {s: e for s, e in terms.items() if s in own and e.is_Atom}
    if not copies:
        return terms, exprs
    for symbol, expr in copies.items():
        while expr in copies:
            expr = copies[expr]
        copies[symbol] = expr
    kept = {s: e.xreplace(copies) for s, e in terms.items() if s not in copies}
    return kept, [e.xreplace(copies) for e in exprs]


def _without_trivial(
    shared: dict[sp.Symbol, sp.Expr], exprs: list[sp.Expr]
) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Expr]]:
    """Put shared terms of a single cheap operation (``2*beta``, ``dx**2``) back where they are used.

    They save nothing and hide the equation; a division is kept, because it is dear.
    """
    inlined: dict[sp.Symbol, sp.Expr] = {}
    kept: dict[sp.Symbol, sp.Expr] = {}
    for symbol, expr in shared.items():
        expr = expr.xreplace(inlined)
        division = any(p.exp.is_negative for p in expr.atoms(sp.Pow))
        if sp.count_ops(expr) <= 1 and not division:
            inlined[symbol] = expr
        else:
            kept[symbol] = expr
    return kept, [e.xreplace(inlined) for e in exprs]


def _fewer_signs(expr: sp.Expr | sp.Matrix) -> sp.Expr | sp.Matrix:
    """``-c*(a - b)`` written as ``c*(b - a)``, wherever that saves a minus sign."""

    def negatives(e: sp.Expr) -> int:
        return sum(bool(part.is_Number and part.is_negative) for part in sp.preorder_traversal(e))

    def turn(product: sp.Expr) -> sp.Expr:
        sums = [f for f in product.args if f.is_Add]
        turned = [sp.Mul(-1, product / f, -f) for f in sums]
        return min([product, *turned], key=negatives)

    return expr.replace(lambda e: e.is_Mul, turn)


def _renumbered(symbols: list[sp.Symbol], taken: set[str]) -> dict[sp.Symbol, sp.Symbol]:
    """Shared terms renamed ``t1``, ``t2``, ... in the order in which they now stand."""
    names = (f"t{i}" for i in range(1, 10**6) if f"t{i}" not in taken)
    return {s: sp.Symbol(next(names), real=True) for s in symbols if isinstance(s, sp.Dummy)}


def _refill(output: Output, results: Iterator[sp.Expr]) -> sp.Matrix | sp.Expr:
    if not isinstance(output.value, sp.MatrixBase):
        return next(results)
    return sp.Matrix(*output.value.shape, [next(results) for _ in output.value])


def _named_trigonometry(exprs: Iterable[sp.Expr], taken: Iterable[str]) -> dict[sp.Expr, sp.Symbol]:
    """A readable name for each sine and cosine: ``c_theta2``, ``s_theta1_minus_theta2``."""
    calls = sorted(set().union(*(e.atoms(sp.sin, sp.cos) for e in exprs)), key=sp.default_sort_key)
    calls = [call for call in calls if not call.atoms(sp.Dummy)]
    known, names = set(taken), {}
    for call in calls:
        text = str(call.args[0]).replace(" - ", "_minus_").replace(" + ", "_plus_").replace("-", "minus_")
        plain = ("s_" if call.func is sp.sin else "c_") + re.sub(r"\W+", "_", text).strip("_")
        names[call] = sp.Symbol(free(plain, known), real=True)
        known.add(names[call].name)
    return names


def _in_order(
    terms: dict[sp.Symbol, sp.Expr], results: Iterable[sp.Expr]
) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    """The terms that `results` need, each after those it uses."""
    done: set[sp.Symbol] = set()

    def visit(expr: sp.Expr) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
        for symbol in sorted(expr.free_symbols & terms.keys(), key=lambda s: (len(s.name), s.name)):
            if symbol not in done:
                done.add(symbol)
                yield from visit(terms[symbol])
                yield symbol, terms[symbol]

    for result in results:
        yield from visit(result)
