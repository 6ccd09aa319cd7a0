"""What a language supplies so that the equations can be printed in it.

Every printer prints the same straight-line `Program`, term by term and with the same `ExpressionPrinter`, so
that all languages compute the same numbers in the same order. A new language is one class: how it writes
numbers, calls and pi, which words it has taken, and what its functions look like.
"""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import sympy as sp

from stridemap.derive.declaration import Declaration
from stridemap.derive.printers.expression import ExpressionPrinter
from stridemap.derive.program import Argument, Output, Program, free


@dataclass(frozen=True)
class Equations:
    """What is printed, and what a banner says of it.

    Parameters
    ----------
    walker : Walker
    programs : tuple of Program
        Every generated function, in order.
    generator : str
        Name and version of what derived it.
    hash : str
        SHA-256 of the equations.
    body : str, optional
        The functions in Python, which the hash is of, where they are printed already.
    """

    walker: Declaration
    programs: tuple[Program, ...]
    generator: str
    hash: str
    body: str = ""

    @property
    def model(self) -> str:
        """Name of the model."""
        return self.walker.name


class Printer(ABC):
    """One language.

    A language supplies `number`, `call` and `pi` for expressions, `reserved` for names, and `function` and
    `text` for the rest. `function` reads a program by `inputs`, `terms` and `results`, whose names and
    expressions are printed already.
    """

    pi: str
    """How the number pi is written."""

    reserved: frozenset[str] = frozenset()
    """Words that cannot be names of variables; an underscore is put behind a name that is one of them."""

    results_are_arguments = False
    """Whether results are written to arguments of their names, which local variables then cannot bear."""

    @abstractmethod
    def number(self, value: int) -> str:
        """An integer, written so that the quotient of two is a fraction."""

    def integer(self, value: int) -> str:
        """An integer beside something that is not one; by default as `number`."""
        return self.number(value)

    @abstractmethod
    def call(self, function: str, argument: str) -> str:
        """A call of ``sin``, ``sqrt``, ... (the names in `elementary.CALLS`) with a printed argument."""

    @abstractmethod
    def function(self, program: Program, model: str) -> list[str]:
        """The lines of one function."""

    @abstractmethod
    def text(self, equations: Equations) -> str:
        """The contents of the file with all functions."""

    # -- a program, printed ------------------------------------------------------------------------------

    def inputs(self, program: Program) -> Iterator[tuple[str, Argument, int]]:
        """Each entry of a vector argument that the function reads: local name, argument and index from 0."""
        names = self._names(program)
        for argument in program.arguments:
            for i, entry in enumerate(argument.entries):
                if entry.symbol in program.used and not argument.scalar:
                    yield names[entry.symbol], argument, i

    def terms(self, program: Program) -> Iterator[tuple[str, str]]:
        """Each intermediate term, in order: its name and expression."""
        names = self._names(program)
        for symbol, expr in program.statements:
            yield names[symbol], self.expression(expr, names)

    def results(self, program: Program) -> Iterator[tuple[Output, list[str]]]:
        """Each result with the expressions of its entries, row by row."""
        names = self._names(program)
        for out in program.outputs:
            yield out, [self.expression(expr, names) for expr in out.entries]

    def expression(self, expr: sp.Expr, names: Mapping[sp.Symbol, str] | None = None) -> str:
        """An expression; raises TypeError for an operation that generated code has no form for."""
        return ExpressionPrinter(self.number, self.call, self.pi, names or {}, self.integer)(expr)

    def result_name(self, program: Program, out: Output) -> str:
        """What a result is called among the arguments, where results are."""
        return free(out.name, {a.name for a in program.signature})

    def _names(self, program: Program) -> dict[sp.Symbol, str]:
        """What each entry and each term is called in this language."""
        scalars = {e.symbol for a in program.arguments if a.scalar for e in a.entries}
        taken = {a.name for a in program.arguments} | self.reserved
        if self.results_are_arguments:
            taken |= {a.name for a in program.signature} | {out.name for out in program.outputs}
            taken |= {self.result_name(program, out) for out in program.outputs}
        symbols = [e.symbol for a in program.arguments for e in a.entries if e.symbol not in scalars]
        symbols += [symbol for symbol, _ in program.statements]
        plain = {s.name for s in symbols}
        names = {}
        for symbol in symbols:
            name = symbol.name
            names[symbol] = free(name, taken | plain) if name in taken else name
            taken.add(names[symbol])
        return names


def shaped(out: Output, entries: list[str], opening: str = "[", closing: str = "]") -> str:
    """A result as one literal: a scalar, a list, or a list of rows."""
    if not out.shape:
        return entries[0]
    if len(out.shape) == 1:
        return opening + ", ".join(entries) + closing
    width = out.shape[1]
    rows = [entries[i : i + width] for i in range(0, len(entries), width)]
    return opening + ", ".join(opening + ", ".join(row) + closing for row in rows) + closing
