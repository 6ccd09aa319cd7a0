"""Conditions on the rows of a table: a small language, of which nothing is ever run as a program."""

import ast
import operator
import re
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from stridemap.errors import InputError, short
from stridemap.words import hint

if TYPE_CHECKING:
    import pandas as pd


LONGEST = 1_000
"""Characters of a condition."""

_COMPARE: Mapping[type, Callable[[Any, Any], Any]] = {
    ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge,
    ast.Eq: operator.eq, ast.NotEq: operator.ne,
}  # fmt: skip
_ARITHMETIC: Mapping[type, Callable[[Any, Any], Any]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
    ast.Pow: operator.pow, ast.Mod: operator.mod,
}  # fmt: skip
_JOIN: Mapping[type, Callable[[Any, Any], Any]] = {
    ast.And: operator.and_, ast.Or: operator.or_,
}  # fmt: skip

_ALLOWED = (
    "write columns and numbers with <, <=, >, >=, ==, !=, in, and, or, not, + - * / ** and abs(), "
    "such as 'stable and k < 10'"
)


class _NotUnderstood(Exception):
    """What is wrong with a condition, as the rest of a sentence."""


def selected(frame: "pd.DataFrame", condition: Any) -> "pd.Series":
    """For which rows a condition holds: a column of bool.

    Missing values follow Kleene's logic: a comparison with one is not known, and neither is its opposite.
    Rows for which it is not known are not selected.

    Parameters
    ----------
    frame : pandas.DataFrame
    condition : str

    Raises
    ------
    InputError
        When it is not a condition, or names something that is not a column.
    """
    if not isinstance(condition, str) or not condition.strip():
        raise InputError(f"where = {short(condition)} is not a condition; {_ALLOWED}")
    try:
        if len(condition) > LONGEST:
            raise _NotUnderstood(f"it has more than {LONGEST:,} characters")
        try:
            tree = ast.parse(_in_words(condition.strip()), mode="eval").body
        except (SyntaxError, ValueError, MemoryError, RecursionError) as error:
            raise _NotUnderstood(_syntax(condition, error)) from None
        found = _Reader(frame).value(tree)
        if not _truths(found):
            raise _NotUnderstood("it is a value and not a condition; compare it with something")
    except RecursionError:
        raise InputError(f"where = {short(condition)} is nested too deep; {_ALLOWED}") from None
    except _NotUnderstood as error:
        raise InputError(f"where = {short(condition)} is not understood: {error}") from None
    return found.fillna(False).astype(bool)


def names_in(condition: str) -> list[str]:
    """The names of columns in a condition that `selected` has understood."""
    tree = ast.parse(_in_words(condition.strip()), mode="eval")
    called = {id(node.func) for node in ast.walk(tree) if isinstance(node, ast.Call)}
    names = [node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and id(node) not in called]
    return list(dict.fromkeys(names))


_WORDS = {"&": " and ", "&&": " and ", "|": " or ", "||": " or ", "~": " not "}
_SIGNS = re.compile(r"""('[^']*'|"[^"]*")|(&&?|\|\|?|~)""")


def _in_words(condition: str) -> str:
    """A condition with the signs &, | and ~ as words, which bind as those do in queries of pandas."""
    return _SIGNS.sub(lambda match: match[1] or _WORDS[match[2]], " ".join(condition.splitlines())).strip()


def _syntax(condition: str, error: Exception) -> str:
    plain = condition.replace("==", "").replace("<=", "").replace(">=", "").replace("!=", "")
    if "=" in plain:
        return "equality is written =="
    offset = getattr(error, "offset", None)
    place = f" at character {offset}" if isinstance(offset, int) and offset > 0 else ""
    return f"it breaks off or has something superfluous{place}; {_ALLOWED}"


def _truths(value: Any) -> bool:
    return str(getattr(value, "dtype", "")) == "boolean"


class _Reader:
    """Values of the parts of a condition on the rows of a data frame."""

    def __init__(self, frame: "pd.DataFrame"):
        self.frame = frame

    def value(self, node: ast.expr) -> Any:
        """The value of a part: a column, a number or a text."""
        match node:
            case ast.Name(id=name):
                return self._column(name)
            case ast.Constant(value=value) if isinstance(value, str | int | float):
                return value
            case ast.UnaryOp(op=ast.USub() | ast.UAdd(), operand=inner):
                number = self._number(inner)
                return -number if isinstance(node.op, ast.USub) else number
            case ast.UnaryOp(op=ast.Not(), operand=inner):
                return ~self._truth(inner)
            case ast.BoolOp(op=op, values=parts):
                found = self._truth(parts[0])
                for part in parts[1:]:
                    found = _JOIN[type(op)](found, self._truth(part))
                return found
            case ast.BinOp(op=op, left=left, right=right) if type(op) in _ARITHMETIC:
                return self._computed(_ARITHMETIC[type(op)], self._number(left), self._number(right))
            case ast.Compare():
                return self._compared(node)
            case ast.Call(func=ast.Name(id="abs"), args=[inner], keywords=[]):
                return _gaps(abs(self._number(inner)))
            case ast.Call(func=ast.Name(id=name)):
                raise _NotUnderstood(f"{name}() is not a function here; only abs() is")
        raise _NotUnderstood(f"{short(ast.unparse(node))} is not allowed; {_ALLOWED}")

    def _column(self, name: str) -> Any:
        import pandas as pd

        if name not in self.frame.columns:
            raise _NotUnderstood(
                f"there is no column {name}{hint(name, self.frame.columns)}; "
                f"columns are {', '.join(self.frame.columns)}"
            )
        values = self.frame[name]
        if pd.api.types.is_bool_dtype(values.dtype) or _all_truths(values):
            return values.astype("boolean")
        if pd.api.types.is_numeric_dtype(values.dtype):
            return values.astype("Float64") if not pd.api.types.is_integer_dtype(values.dtype) else values
        return values.astype("string")

    def _truth(self, node: ast.expr) -> Any:
        found = self.value(node)
        if isinstance(found, bool):
            import pandas as pd

            return pd.Series(found, index=self.frame.index, dtype="boolean")
        if not _truths(found):
            what = short(ast.unparse(node))
            raise _NotUnderstood(f"{what} is a value and not a condition; compare it with something")
        return found

    def _number(self, node: ast.expr) -> Any:
        found = self.value(node)
        if isinstance(found, str) or str(getattr(found, "dtype", "")) in ("string", "str", "boolean"):
            raise _NotUnderstood(
                f"{short(ast.unparse(node))} is not a number, so that it cannot be computed with"
            )
        return found

    @staticmethod
    def _computed(operation: Callable[[Any, Any], Any], left: Any, right: Any) -> Any:
        if operation is operator.pow and isinstance(right, int | float) and abs(right) > 100:
            raise _NotUnderstood(f"a power of {right} is too high; at most 100 is allowed")
        try:
            return _gaps(operation(left, right))
        except (ArithmeticError, ValueError, TypeError):
            raise _NotUnderstood(f"{short(left)} and {short(right)} cannot be computed with so") from None

    def _compared(self, node: ast.Compare) -> Any:
        """A chain of comparisons: ``0 < k < 10``."""
        found, left = None, self.value(node.left)
        for op, right_node in zip(node.ops, node.comparators, strict=True):
            if isinstance(op, ast.In | ast.NotIn):
                one = self._among(left, right_node, node)
                one = ~one if isinstance(op, ast.NotIn) else one
                right: Any = left
            else:
                right = self.value(right_node)
                one = self._pair(op, left, right, node)
            found = one if found is None else found & one
            left = right
        return found

    def _pair(self, op: ast.cmpop, left: Any, right: Any, node: ast.expr) -> Any:
        import pandas as pd

        if type(op) not in _COMPARE:
            raise _NotUnderstood(f"{short(ast.unparse(node))} is not allowed; {_ALLOWED}")
        if not isinstance(left, pd.Series) and not isinstance(right, pd.Series):
            raise _NotUnderstood(f"{short(ast.unparse(node))} names no column")
        kinds = {_kind(left), _kind(right)}
        if len(kinds) > 1:
            raise _NotUnderstood(
                f"{short(ast.unparse(node))} compares a {_kind(left)} with a {_kind(right)}; "
                "texts stand in quotation marks, and truths are compared with True or False"
            )
        return _COMPARE[type(op)](left, right).astype("boolean")

    def _among(self, left: Any, node: ast.expr, whole: ast.expr) -> Any:
        import pandas as pd

        if not isinstance(node, ast.Tuple | ast.List | ast.Set) or not isinstance(left, pd.Series):
            raise _NotUnderstood(f"{short(ast.unparse(whole))}: in takes a list, such as group in ('A', 'B')")
        found = pd.Series(False, index=left.index, dtype="boolean")
        for part in node.elts:
            found = found | self._pair(ast.Eq(), left, self.value(part), whole)
        return found


def _kind(value: Any) -> str:
    """What a value is, in a word."""
    dtype = str(getattr(value, "dtype", ""))
    if dtype == "boolean" or isinstance(value, bool):
        return "truth"
    return "text" if dtype in ("string", "str") or isinstance(value, str) else "number"


def _gaps(value: Any) -> Any:
    """What was computed, missing where it is not a number: 0/0."""
    return value.astype("float64").astype("Float64") if hasattr(value, "dtype") else value


def _all_truths(values: Any) -> bool:
    """Whether a column of any objects holds truths, and nothing else but gaps."""
    if values.dtype != object:
        return False
    known = values.dropna()
    return len(known) > 0 and all(isinstance(one, bool) for one in known)
