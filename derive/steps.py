"""Long expressions of a declaration as terms, so that what is derived from them grows with their length.

A controller that uses the model (feedback linearisation, virtual constraints) is a quotient of sums of sines.
Written out, its derivatives are far longer than itself; step by step they are a few times as long.
"""

from collections.abc import Mapping
from copy import copy
from dataclasses import fields, is_dataclass, replace
from typing import Any

import sympy as sp

from stridemap.derive.declaration import Declaration
from stridemap.derive.simplify import QUOTIENT, READABLE, expanded_size, has_quotient
from stridemap.derive.terms import Term, short, terms_in

STEP = 6
"""Operations of one step that are left together; a longer part becomes a term of its own."""

GEOMETRY = (
    "bodies",
    "swing_foot",
    "gravity",
    "stance",
    "touchdown",
    "relabel",
    "section",
    "drawing",
    "locks",
)
"""Fields that stay as they are declared: they are short, and what follows from them is to be readable."""


def in_steps(walker: Declaration) -> Declaration:
    """A copy of a declaration whose long expressions (torques, potentials, dampers) are terms."""
    changed = copy(walker)
    for field in fields(walker):
        if field.name not in GEOMETRY:
            object.__setattr__(changed, field.name, _inside(getattr(walker, field.name)))
    return changed


def _inside(value: Any) -> Any:
    if isinstance(value, sp.Expr):
        return straight_line(value) if is_long(value) else value
    if isinstance(value, Mapping):
        return {key: _inside(v) for key, v in value.items()}
    if isinstance(value, tuple):
        return tuple(map(_inside, value))
    if is_dataclass(value) and not isinstance(value, type):
        changes = {f.name: getattr(value, f.name) for f in fields(value)}
        changes = {k: v for k, v in changes.items() if isinstance(v, sp.Expr) and is_long(v)}
        return replace(value, **{k: straight_line(v) for k, v in changes.items()}) if changes else value
    return value


def is_long(expr: sp.Expr) -> bool:
    """Whether an expression is too long to be simplified whole."""
    if expr.has(Term):
        return True
    return sp.count_ops(expr) > QUOTIENT if has_quotient(expr) else expanded_size(expr) > READABLE


def straight_line(expr: sp.Expr, step: int = STEP) -> sp.Expr:
    """`expr` in terms of at most about `step` operations each, the last of which is what is returned.

    Nothing is multiplied out or simplified. Terms that are in it already keep their names.
    """
    known: dict[sp.Basic, sp.Expr] = {}

    def visit(part: sp.Basic) -> sp.Expr:
        if part not in known:
            known[part] = part if part.is_Atom else _shortened(part.func(*map(visit, part.args)), step)
        return known[part]

    for term in terms_in([expr]):
        definition = visit(term.definition)
        if isinstance(definition, Term) and not definition.name:
            definition = definition.definition
        known[term] = Term(term.name, definition)
    return visit(expr)


def _shortened(made: sp.Expr, step: int) -> sp.Expr:
    """A part as a term, if it is long, or dear, or would grow when it is differentiated."""
    divides = made.is_Pow and made.exp.is_negative and not made.base.is_Symbol
    return short("", made) if divides or sp.count_ops(made) > step else made
