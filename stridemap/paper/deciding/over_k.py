"""A measure against the spring stiffness, one panel for each pair of alpha and omega, as the paper has it."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np
import pandas as pd

from stridemap.paper.claim import shown
from stridemap.paper.cycle_tables import CycleTables
from stridemap.paper.points import OMEGAS
from stridemap.paper.select import compass, slices, stable
from stridemap.quantities import QUANTITIES
from stridemap.views.small_figures import Axis, Curve, Guide, Mark, Panel, SmallFigure, look_of, rows_axis

Evidence = Mapping[str, Any]
Draw = Callable[[CycleTables, Evidence], SmallFigure]
MarksOf = Callable[[Evidence, str, Mapping[str, float]], Iterable[Mark]]
"""The marks of a panel: from the parts of the statement, the panel's name, and its alpha and omega."""

MOST = 80
"""Unstable cycles of a panel that are drawn; they are only for orientation."""

LABELS = {"spectral_radius": "largest |μ|", "d_max": "d_max in L", "cot": "cost of transport"}


def title(point: Mapping[str, float]) -> str:
    """The title of a panel at an alpha and an omega."""
    return ", ".join(f"{symbol} = {point[name]:g}" for name, symbol in SYMBOLS.items() if name in point)


SYMBOLS = {"alpha": "α", "omega": "ω"}


def mark_at(entry: Evidence, holds: bool, point: Mapping[str, float]) -> Iterable[Mark]:
    """A mark at the least value of a measure, if there is one."""
    if entry.get("least") is not None:
        k = entry["least_at_k"]
        yield Mark(k, entry["least"], holds, shown(entry["least"], ".3g"), {"k": k, **point})


def least_of_part(parts: Evidence, name: str, point: Mapping[str, float]) -> Iterable[Mark]:
    """For statements with one part at each alpha and omega: the least value that its part names."""
    if name in parts:
        yield from mark_at(parts[name], parts[name]["holds"], point)


def least_of_groups(pattern: str) -> MarksOf:
    """For statements with parts about groups, such as ``"{group} at {name}"``: the least value of each."""

    def marks(parts: Evidence, name: str, point: Mapping[str, float]) -> Iterable[Mark]:
        seen = set()
        for group in "ABCDE":
            for what in ("", " among stable"):
                entry = parts.get(pattern.format(group=group, name=name) + what, {})
                key = (entry.get("least_at_k"), entry.get("holds"))
                if key not in seen:  # the main branch and its stable part often have the same least value
                    seen.add(key)
                    yield from mark_at(entry, bool(entry.get("holds")), point)

    return marks


def a_against_b_and_c(parts: Evidence, name: str, point: Mapping[str, float]) -> Iterable[Mark]:
    """The least values of A, B and C; that of A is as stated if it is above both others."""
    found = {g: parts.get(f"A above {g} at {name}", {}) for g in "BC"}
    yield from mark_at(found["B"].get("A", {}), all(part.get("holds") for part in found.values()), point)
    for g, part in found.items():
        yield from mark_at(part.get(g, {}), bool(part.get("holds")), point)


def over_k(
    column: str,
    marks: MarksOf,
    caption: str,
    *,
    groups: str | None = None,
    reference: bool = False,
    omegas: Sequence[float] = OMEGAS,
) -> Draw:
    """Make the function that draws a measure over k.

    Parameters
    ----------
    column : str
        The measure.
    marks : callable
    caption : str
    groups : str, optional
        Letters of the groups that are shown; by default all.
    reference : bool
        Whether the compass's value is drawn.
    omegas : sequence of float
        Which panels are drawn.
    """

    def draw(data: CycleTables, evidence: Evidence) -> SmallFigure:
        parts, panels = evidence["parts"], []
        for name, alpha, omega, orbits in slices(data):
            if omega in omegas:
                point = {"alpha": alpha, "omega": omega}
                here = orbits if groups is None else orbits[orbits["group"].isin(list(groups))]
                value = compass(data, omega, column) if reference else np.nan
                panels.append(_panel(here, column, point, list(marks(parts, name, point)), value))
        return SmallFigure(caption, panels)

    return draw


def _panel(
    orbits: pd.DataFrame, column: str, point: Mapping[str, float], marks: Sequence[Mark], reference: float
) -> Panel:
    firm = stable(orbits)
    loose = orbits[orbits["main"].astype(bool) & ~orbits.index.isin(firm.index)].sort_values("k")
    loose = loose.iloc[np.unique(np.linspace(0, len(loose) - 1, MOST).astype(int))] if len(loose) else loose
    curves = [Curve("unstable", loose["k"].to_list(), loose[column].to_list(), dots=True)]
    for group, rows in firm.groupby("group"):
        curves.append(
            Curve(look_of(group), rows["k"].to_list(), rows[column].to_list(), dots=True, text=str(group))
        )
    decisive = [*firm[column], *(mark.y for mark in marks), reference]
    guides = [Guide("y", reference, f"compass {shown(reference, '.3g')}", "compass")]
    if column == "spectral_radius":
        guides.append(Guide("y", 1.0))
    low, high = ends(decisive)
    return Panel(
        title(point),
        Axis("spring stiffness k", *ends([*orbits["k"], *(mark.x for mark in marks)], 0.03)),
        Axis(LABELS.get(column, QUANTITIES[column].label), low, high + 0.15 * (high - low)),
        curves, marks=marks, guides=guides,
    )  # fmt: skip


def ends(values: Iterable[float], pad: float = 0.12) -> tuple[float, float]:
    """Ends of an axis with all values and a little room."""
    finite = [value for value in values if np.isfinite(value)] or [0.0]
    low, high = min(finite), max(finite)
    room = pad * (high - low) or 0.1 * abs(high) or 1.0
    return low - room, high + room


# -- C14 and C19 ---------------------------------------------------------------------------------------------


def growth(column: str) -> Draw:
    """The figure of `grows`: change with alpha and with omega, then the measure over k."""
    lines = over_k(column, least_of_groups("with k, {group} at {name}"), "")

    def draw(data: CycleTables, evidence: Evidence) -> SmallFigure:
        parts = evidence["parts"]
        panels = [
            panel
            for direction, steps in (("alpha", "0.25 → 0.5"), ("omega", "2 → 3"))
            for panel in _changes(parts, direction, f"with {SYMBOLS[direction]}, {steps}")
        ]
        return SmallFigure(
            "Change of a group's mean with α and with ω, of the main branch and of stable cycles alone: as "
            f"stated where it is above zero. Over k, the smallest {LABELS[column]} of a group is marked.",
            [*panels, *lines(data, evidence).panels],
        )

    return draw


def _changes(parts: Evidence, direction: str, name: str) -> Iterable[Panel]:
    """How much the mean over each group changes, in percent."""
    entries = {
        part.removeprefix(f"with {direction}, "): entry
        for part, entry in parts.items()
        if part.startswith(f"with {direction}, ")
    }
    if not entries:
        return
    rows = [
        part.replace(" at alpha ", ", α ").replace(" at omega ", ", ω ").replace(" among stable", ", stable")
        for part in entries
    ]
    changes = [100 * (entry["means"][1] / entry["means"][0] - 1) for entry in entries.values()]
    marks = [
        Mark(
            change,
            i,
            entry["holds"],
            f"{change:{'+.0f' if abs(change) >= 10 else '+.2g'}} %".replace("-", "\u2212"),
        )
        for i, (change, entry) in enumerate(zip(changes, entries.values(), strict=True))
    ]
    low, high = ends([*changes, 0.0], 0.3)
    yield Panel(
        name,
        Axis("change of the mean in %", low, high),
        rows_axis(rows),
        marks=marks,
        guides=[Guide("x", 0.0)],
    )
