"""Every field of a declaration holds what it is annotated with.

The annotations of `Declaration` and its parts are the one list of what goes where: a field that is added is
checked without a change here. What a name, a number or an expression must be beyond its kind is for `names`
and `mechanics`.
"""

import math
import types
import typing
from collections.abc import Iterable, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from typing import Any

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.core.function import AppliedUndef

from stridemap.derive import given
from stridemap.derive.declaration import Declaration
from stridemap.derive.parts import Coordinate, Parameter
from stridemap.derive.terms import terms_in
from stridemap.derive.validate.refusal import refuse
from stridemap.errors import short as shown

SHOWN = 100
"""Characters of a name that a sentence quotes."""


def validate_types(walker: Declaration) -> None:
    """Look for fields that hold something of another kind.

    Parameters
    ----------
    walker : Walker

    Raises
    ------
    InputError
        For the first one found.
    """
    for name, annotation in _hints(Declaration).items():
        where = f"the {name}" if annotation is sp.Expr else name
        _check(walker, where, getattr(walker, name), annotation)


@cache
def _hints(cls: Any) -> dict[str, Any]:
    """The annotations of the fields of a record."""
    found = typing.get_type_hints(cls)
    return {one.name: found[one.name] for one in fields(cls)}


def _check(walker: Declaration, where: str, value: Any, annotation: Any) -> None:
    """Refuse `value` unless it is of the kind of `annotation`; `where` names it in the sentence."""
    origin, arguments = typing.get_origin(annotation), typing.get_args(annotation)
    if origin in (types.UnionType, typing.Union):
        if value is None and type(None) in arguments:
            return
        kinds = [one for one in arguments if one is not type(None)]
        if len(kinds) == 1:
            _check(walker, where, value, kinds[0])
    elif origin is tuple and arguments[-1] is Ellipsis:
        _check_tuple(walker, where, value, arguments[0])
    elif origin is tuple:
        pair = isinstance(value, tuple | list) and len(value) == len(arguments)
        if not pair or not all(map(_is_number, value)):
            what = _PAIRS.get(where, "{where} {value}; a middle and a half-width of at least 0 are needed")
            refuse(walker, what.format(where=where, value=shown(value)))
    elif isinstance(origin, type) and issubclass(origin, Mapping):
        _check_mapping(walker, where, value, arguments)
    elif _is_record(annotation):
        if not isinstance(value, annotation):
            refuse(walker, f"{where} is {shown(value)}, which is not a {annotation.__name__}")
        _check_record(walker, where, value)
    elif annotation in _PLAIN:
        allowed, what = _PLAIN[annotation]
        if isinstance(value, Parameter | Coordinate):
            kind = type(value).__name__
            refuse(walker, f"{where} is the {kind} {value.name} itself; take its symbol, {kind}(...).symbol")
        if not allowed(value):
            refuse(walker, f"{where} is {shown(value)}; it must be {what}")
        if annotation in (sp.Expr, sp.Matrix) and isinstance(value, sp.Basic | sp.MatrixBase):
            if value.has(*_UNDONE):
                refuse(
                    walker,
                    f"{where} is {shown(value)}, which is not made of numbers, symbols and functions alone; "
                    "carry out what stands in it (.doit()), or write it out",
                )
            if any(map(given.is_out_of_range, [value, *(t.definition for t in terms_in(_entries(value)))])):
                refuse(walker, f"{where} has {given.OUT_OF_RANGE}")
            if value.has(sp.nan, sp.oo, -sp.oo, sp.zoo):
                refuse(walker, f"{where} is {shown(value)}, which is not finite; correct it")


def _check_tuple(walker: Declaration, where: str, value: Any, kind: Any) -> None:
    word = f"{kind.__name__}(...)" if _is_record(kind) else "expression" if kind is sp.Expr else "entry"
    if not isinstance(value, tuple):
        refuse(walker, f"{where} is not a tuple; write ({word},) even for a single one")
    for i, entry in enumerate(value, 1):
        if _is_record(kind) and not isinstance(entry, kind):
            refuse(walker, f"{where} holds {shown(entry)}, which is not a {kind.__name__}")
        _check(walker, f"entry {i} of {where}", entry, kind)


def _check_mapping(walker: Declaration, where: str, value: Any, kinds: Iterable[Any]) -> None:
    if not isinstance(value, Mapping):
        refuse(walker, f"{where} is {shown(value)}; it must be a dict")
    of_key, of_value = kinds
    for key, entry in value.items():
        if not isinstance(key, of_key):
            kind = "text" if of_key is str else of_key.__name__
            refuse(walker, f"{where} names {shown(key)}, which is not a {kind}")
        name = shown(key) if isinstance(key, str) and not key.isidentifier() else getattr(key, "name", key)
        named = _ENTRIES.get(where, "{name} of {where}").format(name=name, where=where)
        _check(walker, named, entry, of_value)


_ENTRIES = {
    "torques": "the torque on {name}",
    "potentials": "the potential {name}",
    "relabel": "the new value of {name} in relabel",
    "section": "the value of {name} in section",
    "search_box": "search_box gives {name}",
}
"""What an entry of a dict is called."""


def _check_record(walker: Declaration, where: str, record: Any) -> None:
    """The fields of a part, in the words of its name where it has one."""
    cls: Any = type(record)
    kind = cls.__name__.lower()
    kind = {"measured": "quantity", "unitnames": "units"}.get(kind, kind)
    name = getattr(record, "name", None)
    whole = f"the {kind} {name}" if isinstance(name, str) and len(name) <= SHOWN else f"the {kind}"
    for field, annotation in _hints(cls).items():
        if field == "default" and not isinstance(getattr(record, field), int):
            continue  # `names` has a sentence for it
        _check(walker, f"the {field} of {whole}", getattr(record, field), annotation)


def _is_record(annotation: Any) -> bool:
    return isinstance(annotation, type) and is_dataclass(annotation)


def _is_number(value: Any) -> bool:
    """Whether something is a number that a float can hold."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    try:
        return not math.isnan(float(value))
    except OverflowError:
        return False


def _entries(value: sp.Basic | sp.MatrixBase) -> list[sp.Basic]:
    return list(value) if isinstance(value, sp.MatrixBase) else [value]


def _is_expression(value: Any) -> bool:
    """Whether something is one expression; plain numbers count."""
    if isinstance(value, sp.MatrixBase) or not isinstance(value, sp.Expr):
        return _is_number(value) and math.isfinite(value)
    return value.is_commutative is not False


def _is_point(value: Any) -> bool:
    return isinstance(value, sp.MatrixBase) and all(_is_expression(x) for x in value)


_PAIRS = {
    "period_range": "period_range = {value} is not allowed; "
    "give (shortest, longest) with 0 < shortest < longest"
}
"""What pairs of numbers must be."""

_UNDONE = (AppliedUndef, ExprWithLimits, sp.Derivative, sp.Lambda, sp.Order, sp.Subs)
"""What stands in expressions that are not values: something to be carried out, or not known at all."""

_PLAIN: dict[Any, tuple[Any, str]] = {
    str: (lambda value: isinstance(value, str), "a text"),
    bool: (lambda value: isinstance(value, bool), "True or False"),
    float: (_is_number, "a number"),
    int: (lambda value: isinstance(value, int) and not isinstance(value, bool), "a whole number"),
    sp.Symbol: (lambda value: isinstance(value, sp.Symbol), "a symbol"),
    sp.Expr: (_is_expression, "a single SymPy expression"),
    sp.Matrix: (_is_point, "a point of SymPy expressions, as sympy.Matrix([x, y])"),
}
"""What each plain annotation allows, and how that is said."""
