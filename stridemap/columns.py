"""What each column of a table holds: a few words, its unit in the model, and its unit in SI.

Tables, plots, files for other programs and what the command line prints take their words from here. It needs
the standard library only.
"""

import ast
import math
import re
from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any

from stridemap.quantities import KINDS, measured_on
from stridemap.spec import ModelSpec, UnitNames
from stridemap.words import CELL_COLUMNS, TRAJECTORY_COLUMNS, column, multiplier_columns

SCALED = "sqrt(L/g)"
"""The unit of time of models that are written in units of a mass, a length and gravity."""

_SI = ("kg", "m", "s")
_NAMED: Mapping[tuple[float, float, float], str] = {
    (1, 1, -2): "N", (1, 2, -2): "N m", (1, 2, -3): "W", (1, 1, -1): "N s", (1, 0, -2): "N/m",
    (1, 0, -1): "N s/m", (1, 2, -1): "N m s", (0, 1, -1): "m/s", (0, 1, -2): "m/s^2", (0, 0, -1): "1/s",
}  # fmt: skip
"""Names of units by their powers of kilogram, metre and second."""


@dataclass(frozen=True)
class Column:
    """What a column holds.

    Parameters
    ----------
    name : str
    label : str
        A few words for axes and tables.
    unit : str
        In the model's own words: ``"M g L"``, ``"1"`` for a pure number, empty for what has no unit.
    scale : str
        The same formed from M, L, g and rad, so that a size of a robot converts it; empty where none can.
    si : str
        Its SI unit; empty where it has none.
    """

    name: str
    label: str
    unit: str = ""
    scale: str = ""
    si: str = ""

    @property
    def in_si(self) -> "Column":
        """The same column once its numbers are in SI units."""
        return Column(self.name, self.label, self.si or self.unit, "", self.si)

    @property
    def axis(self) -> str:
        """Label and unit, in plain text."""
        return f"{self.label} [{self.unit}]" if self.unit not in ("", "1") else self.label

    def to_dict(self) -> dict[str, str]:
        """Plain values for the metadata of a table."""
        return asdict(self)


# -- units ---------------------------------------------------------------------------------------------------


def unit_value(unit: str, values: Mapping[str, float]) -> float:
    """The value of a unit formed from others by products, quotients, powers and square roots.

    Parameters
    ----------
    unit : str
        Such as ``"M g / L"``; between two factors a blank means a product.
    values : mapping of str to float
        Of each unit that it may be formed from.

    Raises
    ------
    ArithmeticError, AttributeError, KeyError, RecursionError, SyntaxError, TypeError, ValueError
        When it is not such a unit.
    """
    tree = ast.parse(re.sub(r"(?<=[\w)])\s+(?=[\w(])", "*", unit.strip()).replace("^", "**"))
    (statement,) = tree.body
    return _value(statement.value, values)  # type: ignore[attr-defined]


def _value(node: ast.expr, values: Mapping[str, float]) -> float:
    """The value of a parsed unit; raises anything for what is not a unit."""
    match node:
        case ast.Name(id=name):
            return values[name]
        case ast.Constant(value=int(one)) if one == 1 and one is not True:
            return 1.0
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=int(power))) if power <= 9:
            return _value(left, values) ** power
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            return _value(left, values) * _value(right, values)
        case ast.BinOp(left=left, op=ast.Div(), right=right):
            return _value(left, values) / _value(right, values)
        case ast.Call(func=ast.Name(id="sqrt"), args=[radicand], keywords=[]):
            return math.sqrt(_value(radicand, values))
    raise ValueError


def powers(unit: str) -> tuple[float, float, float]:
    """Powers of mass, length and gravity in a unit that is formed from M, L, g and rad."""

    def power(**doubled: float) -> float:
        return round(2 * math.log2(unit_value(unit, {"M": 1, "L": 1, "g": 1, "rad": 1, **doubled}))) / 2

    return power(M=2), power(L=2), power(g=2)


def unit_of(kind: str, names: UnitNames) -> str:
    """Unit of a kind of quantity in a model's own units, written as in a specification.

    Parameters
    ----------
    kind : str
        A key of `stridemap.quantities.KINDS`.
    names : UnitNames
        What the model calls its units.
    """
    own = {"mass": names.mass, "length": names.length, "time": names.time, "energy": names.energy}
    scaled, si = KINDS[kind]
    if kind in own:
        return own[kind]
    if names.time == SCALED:
        words = {"M": names.mass, "L": names.length}
        return re.sub(r"\b[ML]\b", lambda match: words[match[0]], scaled)
    if (names.mass, names.length, names.time) == _SI:
        return si
    return _composed(kind, names)


def _composed(kind: str, names: UnitNames) -> str:
    """A unit as a product of powers of the units of mass, length and time."""
    # Units are formed from M, L and g; g is a length over a time squared. Powers are in halves.
    mass, length, gravity = powers(KINDS[kind][0])
    factors = {names.mass: mass, names.length: length + gravity, names.time: -2 * gravity}
    words = [f"{name}^{power:g}" if power != 1 else name for name, power in factors.items() if power]
    return " ".join(words) or ("rad" if KINDS[kind][0] == "rad" else "1")


def _si_unit(scale: str) -> str:
    """SI unit of what has a unit formed from M, L, g and rad."""
    mass, length, gravity = powers(scale)
    dimension = mass, length + gravity, -2 * gravity
    angle = "rad" if re.search(r"\brad\b", scale) else ""
    if not any(dimension):
        return angle or "1"
    if angle and dimension == (0, 0, -1):
        return "rad/s"
    if scale == "sqrt(g/L)":  # frequencies of the models are angular
        return "rad/s"
    if dimension in _NAMED:
        return f"{_NAMED[dimension]}{angle and f' {angle}'}"
    factors = [
        f"{name}^{power:g}" if power != 1 else name
        for name, power in zip(_SI, dimension, strict=True)
        if power
    ]
    return " ".join([*factors, *([angle] if angle else [])])


# -- columns -------------------------------------------------------------------------------------------------


def columns_of(spec: ModelSpec) -> dict[str, Column]:
    """Every column that a table of a model can have, by name.

    Parameters
    ----------
    spec : ModelSpec
    """
    out: dict[str, Column] = {}
    for argument in ("p", "q", "v"):
        for entry in spec.entries(argument):
            out[entry.name] = _written(entry.name, entry.meaning, entry.unit, spec.units)
    for name, quantity in measured_on(spec).items():
        numeric = quantity.type in ("float", "int")
        out[name] = _of_kind(name, quantity.label, quantity.kind if numeric else None, spec.units)
    out["period"] = _of_kind("period", column("period") or "", "time", spec.units)
    for i in range(len(spec.section)):
        for name, part in zip(multiplier_columns(i), ("real", "imaginary"), strict=True):
            out[name] = Column(name, f"Floquet multiplier {i}, {part} part", "1", "1", "1")
    kinds = {"time": "time", "step_time": "time"} | {
        f"{foot}_foot_{axis}": "length" for foot in ("stance", "swing") for axis in "xy"
    }
    for name, label in {**TRAJECTORY_COLUMNS, **CELL_COLUMNS}.items():
        out.setdefault(name, _of_kind(name, label, kinds.get(name), spec.units))
    out["status"] = Column("status", "how it ended")
    out["arclength"] = Column("arclength", CELL_COLUMNS["arclength"], "1")
    for name in (*spec.section, "period", *spec.names):
        out[f"tangent_{name}"] = Column(f"tangent_{name}", f"tangent of the branch along {name}", "1")
    crossing = {"multiplier": CELL_COLUMNS["multiplier"]}
    crossing |= {f"null_{name}": f"{CELL_COLUMNS['null']}, along {name}" for name in spec.section}
    for name, meaning in crossing.items():
        for ending, part in (("re", "real"), ("im", "imaginary")):
            out[f"{name}_{ending}"] = Column(f"{name}_{ending}", f"{meaning}, {part} part", "1")
    return out


def _of_kind(name: str, label: str, kind: str | None, names: UnitNames) -> Column:
    """A column of a kind of quantity; None is one without a unit."""
    if kind is None:
        return Column(name, label)
    unit, (scaled, si) = unit_of(kind, names), KINDS[kind]
    if kind == "number":
        return Column(name, label, "1", "1", "1")
    return Column(name, label, unit, *_converted(names, scaled, si))


def _written(name: str, label: str, unit: str, names: UnitNames) -> Column:
    """A column whose unit a model's declaration writes."""
    if unit in ("", "1", "rad"):
        return Column(name, label, unit or "1", unit or "1", unit or "1")
    if names.time != SCALED:
        return Column(name, label, unit, *_converted(names, "", unit))
    words = {names.mass: "M", names.length: "L"}
    scale = re.sub(r"[A-Za-z_]\w*", lambda match: words.get(match[0], match[0]), unit)
    try:
        return Column(name, label, unit, scale, _si_unit(scale))
    except (ArithmeticError, AttributeError, KeyError, RecursionError, SyntaxError, TypeError, ValueError):
        return Column(name, label, unit)  # a unit of another kind, which no size converts


def _converted(names: UnitNames, scale: str, si: str) -> tuple[str, str]:
    """Scale and SI unit in a model's units: itself where it is written in SI, nothing in others."""
    if names.time == SCALED:
        return scale, si
    return ("1", si) if (names.mass, names.length, names.time) == _SI else ("", "")


# -- in a frame ----------------------------------------------------------------------------------------------

KEY = "stridemap"
"""Under which a data frame's ``attrs`` say what its columns hold."""


def described(frame: Any, spec: ModelSpec, what: str, same: Mapping[str, str] | None = None) -> Any:
    """A data frame that says of itself what its columns hold; Parquet files keep that.

    Parameters
    ----------
    frame : pandas.DataFrame
    spec : ModelSpec
    what : str
        What a row is, in the plural: "limit cycles".
    same : mapping of str to str, optional
        Columns that hold the same as another: the value of a parameter that varies.
    """
    known = columns_of(spec)
    known |= {name: replace(known[other], name=name) for name, other in (same or {}).items()}
    columns = {name: known[name].to_dict() for name in frame.columns if name in known}
    frame.attrs[KEY] = {"model": spec.name, "what": what, "columns": columns}
    return frame


def description(frame: Any) -> tuple[dict[str, Column], dict[str, Any]]:
    """Columns that a data frame describes, by name, and what else it says; nothing is taken on trust."""
    said = frame.attrs.get(KEY) if isinstance(getattr(frame, "attrs", None), Mapping) else None
    if not isinstance(said, Mapping) or not isinstance(said.get("columns"), Mapping):
        return {}, {}
    out = {}
    for name, one in said["columns"].items():
        if isinstance(one, Mapping) and all(isinstance(v, str) and len(v) < 300 for v in one.values()):
            plain = {key: "".join(c for c in one[key] if c.isprintable()) for key in one}
            if set(plain) == set(Column.__dataclass_fields__):
                out[str(name)] = Column(**plain)
    return out, dict(said)
