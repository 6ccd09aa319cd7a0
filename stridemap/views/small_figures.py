"""Small figures that show what decides a verdict: plain records, which travel as JSON.

A figure has panels; in a panel lie curves or dots, bars, shaded bands, lines that stand for a threshold or a
reference, and marks: the points that decide. What a thing looks like is said by a word of `LOOKS`, whose
colours are those of `stridemap.views.palette`.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from stridemap.views import palette

LOOKS = ("plain", "stable", "unstable", "compass", "group", *(f"group-{g}" for g in palette.GROUPS))
"""What a curve, a bar or a line may look like."""

DIGITS = 5
"""Significant digits of curves, which are only drawn; marks have nine."""


def look_of(group: Any) -> str:
    """How things of a group look."""
    return f"group-{group}" if group in palette.GROUPS else "group"


@dataclass(frozen=True)
class Axis:
    """An axis, of numbers or of rows that have names.

    Parameters
    ----------
    label : str
    low, high : float
        Its ends; for rows, -0.5 and their number less a half.
    rows : sequence of str
        Names of the rows, which are at 0, 1, 2 ..., the first at the top.
    """

    label: str
    low: float
    high: float
    rows: Sequence[str] = ()


def rows_axis(names: Sequence[str]) -> Axis:
    """An axis of rows."""
    return Axis("", -0.5, len(names) - 0.5, tuple(names))


@dataclass(frozen=True)
class Curve:
    """Points that are joined by a line, or that are dots; a letter or a word above them."""

    look: str
    x: Sequence[float]
    y: Sequence[float]
    dots: bool = False
    text: str = ""


@dataclass(frozen=True)
class Bar:
    """A bar along a row, with a text; `at` as in `Mark`."""

    look: str
    row: int
    low: float
    high: float
    text: str = ""
    at: Mapping[str, float] | None = None


@dataclass(frozen=True)
class Mark:
    """A point that decides.

    Parameters
    ----------
    x, y : float
    holds : bool
        Whether what is stated is so there.
    text : str
        What it says, in a few words.
    at : mapping of str to float, optional
        Values of parameters, where it can be looked at.
    """

    x: float
    y: float
    holds: bool
    text: str = ""
    at: Mapping[str, float] | None = None


@dataclass(frozen=True)
class Guide:
    """A line across a panel at a value of an axis, "x" or "y": a threshold or a reference."""

    axis: str
    value: float
    label: str = ""
    look: str = "plain"


@dataclass(frozen=True)
class Band:
    """A shaded range of an axis, "x" or "y"."""

    axis: str
    low: float
    high: float
    label: str = ""


@dataclass(frozen=True)
class Panel:
    """A panel of a figure."""

    title: str
    x: Axis
    y: Axis
    curves: Sequence[Curve] = ()
    bars: Sequence[Bar] = ()
    marks: Sequence[Mark] = ()
    guides: Sequence[Guide] = ()
    bands: Sequence[Band] = ()


@dataclass(frozen=True)
class SmallFigure:
    """Panels and what they show."""

    caption: str
    panels: Sequence[Panel]

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON; what is not finite has been left out."""
        return {"caption": self.caption, "panels": [_plain(asdict(_finite(panel))) for panel in self.panels]}


def _finite(panel: Panel) -> Panel:
    """A panel without points that cannot be drawn."""
    curves = []
    for curve in panel.curves:
        x, y = np.asarray(curve.x, dtype=float), np.asarray(curve.y, dtype=float)
        good = np.isfinite(x) & np.isfinite(y)
        along, up = ([float(f"{v:.{DIGITS}g}") for v in values[good]] for values in (x, y))
        curves.append(Curve(curve.look, along, up, curve.dots, curve.text))
    return Panel(
        panel.title, panel.x, panel.y, [curve for curve in curves if curve.x],
        [bar for bar in panel.bars if math.isfinite(bar.low + bar.high)],
        [mark for mark in panel.marks if math.isfinite(mark.x + mark.y)],
        [guide for guide in panel.guides if math.isfinite(guide.value)],
        panel.bands,
    )  # fmt: skip


def _plain(value: Any) -> Any:
    """A value as JSON has it, with nine digits."""
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if isinstance(value, bool | np.bool_):
        return bool(value)
    if isinstance(value, int | np.integer):
        return int(value)
    return float(f"{value:.9g}") if isinstance(value, float | np.floating) else value


# -- reading -------------------------------------------------------------------------------------------------


def figure_from(found: Any) -> SmallFigure:
    """A figure from what `SmallFigure.to_dict` made, whoever wrote it.

    Raises
    ------
    ValueError
        When it is something else.
    """
    fields = _mapping(found)
    return SmallFigure(_text(fields.get("caption")), [_panel(panel) for panel in _list(fields.get("panels"))])


def _panel(found: Any) -> Panel:
    of = _mapping(found)
    return Panel(
        _text(of.get("title")), _axis(of.get("x")), _axis(of.get("y")),
        [_curve(_mapping(one)) for one in _list(of.get("curves"))],
        [
            Bar(_look(b), _whole(b.get("row")), _number(b.get("low")), _number(b.get("high")),
                _text(b.get("text")), _place(b.get("at")))
            for b in map(_mapping, _list(of.get("bars")))
        ],
        [
            Mark(_number(m.get("x")), _number(m.get("y")), m.get("holds") is True, _text(m.get("text")),
                 _place(m.get("at")))
            for m in map(_mapping, _list(of.get("marks")))
        ],
        [
            Guide(_which(g), _number(g.get("value")), _text(g.get("label")), _look(g))
            for g in map(_mapping, _list(of.get("guides")))
        ],
        [
            Band(_which(b), _number(b.get("low")), _number(b.get("high")), _text(b.get("label")))
            for b in map(_mapping, _list(of.get("bands")))
        ],
    )  # fmt: skip


def _axis(found: Any) -> Axis:
    of = _mapping(found)
    low, high = _number(of.get("low")), _number(of.get("high"))
    if not high - low > 1e-9 * max(abs(low), abs(high), 1e-30):
        raise ValueError(f"an axis from {low} to {high}")
    return Axis(_text(of.get("label")), low, high, [_text(row) for row in _list(of.get("rows"))])


def _curve(of: Mapping[str, Any]) -> Curve:
    x, y = ([_number(v) for v in _list(of.get(name))] for name in ("x", "y"))
    if len(x) != len(y):
        raise ValueError(f"{len(x)} and {len(y)} coordinates")
    return Curve(_look(of), x, y, of.get("dots") is True, _text(of.get("text")))


def _place(found: Any) -> dict[str, float] | None:
    return None if found is None else {_text(key): _number(value) for key, value in _mapping(found).items()}


def _look(of: Mapping[str, Any]) -> str:
    if of.get("look") not in list(LOOKS):
        raise ValueError(f"the look {of.get('look')!r}")
    return str(of["look"])


def _which(of: Mapping[str, Any]) -> str:
    if of.get("axis") not in ["x", "y"]:
        raise ValueError(f"the axis {of.get('axis')!r}")
    return str(of["axis"])


def _mapping(found: Any) -> Mapping[str, Any]:
    if not isinstance(found, Mapping):
        raise ValueError(f"{type(found).__name__} in place of an object")
    return found


def _list(found: Any) -> Sequence[Any]:
    if not isinstance(found, list | tuple):
        raise ValueError(f"{type(found).__name__} in place of a list")
    return found


def _text(found: Any) -> str:
    if not isinstance(found, str):
        raise ValueError(f"{type(found).__name__} in place of a text")
    return found


def _whole(found: Any) -> int:
    if not isinstance(found, int) or isinstance(found, bool):
        raise ValueError(f"{type(found).__name__} in place of a whole number")
    return found


def _number(found: Any) -> float:
    if not isinstance(found, int | float) or isinstance(found, bool) or not abs(found) < 1e100:
        raise ValueError(f"{str(found)[:40]} in place of a number")
    return float(found)
