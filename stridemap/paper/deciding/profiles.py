"""Time profiles of the typical solutions over one step, and numbers of them beside thresholds."""

from collections.abc import Mapping, Sequence

import numpy as np

from stridemap.paper.claim import shown
from stridemap.paper.cycle_tables import CycleTables
from stridemap.paper.deciding.over_k import Evidence, ends
from stridemap.paper.points import PLANE, TYPICAL
from stridemap.views.small_figures import (
    Axis,
    Band,
    Curve,
    Guide,
    Mark,
    Panel,
    SmallFigure,
    look_of,
    rows_axis,
)

STEP = Axis("time in steps", 0.0, 1.0)
RATE = "rate of θ₁"
EVERY = 4
"""Of the samples of a profile, one in so many is drawn."""


def place(group: str) -> Mapping[str, float]:
    """Where a typical solution is."""
    return {"k": TYPICAL[group], **PLANE}


def peaks(data: CycleTables, evidence: Evidence) -> SmallFigure:
    """C5: the rate of theta1 in the typical solutions, each peak marked."""
    parts = evidence["parts"]
    panels = []
    for number, group in enumerate(TYPICAL, 1):
        entry = parts.get(f"{group}: {number}", {})
        rate = data.profiles.get(group, {}).get("dtheta1", np.empty(0))
        at = _maxima(rate)
        marks = [Mark(i / (len(rate) - 1), rate[i], bool(entry.get("holds")), "", place(group)) for i in at]
        panels.append(
            Panel(
                f"{group}, k = {TYPICAL[group]:g}: {_count(entry.get('peaks'))}",
                STEP, Axis(RATE, *ends(rate)), [_profile(group, rate)], marks=marks,
            )
        )  # fmt: skip
    return SmallFigure("The rate of θ₁ in the typical solutions; marked are its peaks.", panels)


def _count(found: int | None) -> str:
    return "none found" if found is None else f"{found} peak{'' if found == 1 else 's'}"


def like_the_compass(data: CycleTables, evidence: Evidence) -> SmallFigure:
    """C6: the rate of theta1 beside the compass's, and how alike the profiles are."""
    parts = evidence["parts"]
    own = data.profiles.get("compass", {}).get("dtheta1", np.empty(0))
    panels = []
    for group in TYPICAL:
        rate = data.profiles.get(group, {}).get("dtheta1", np.empty(0))
        curves = [_profile(group, rate), Curve("compass", *_drawn(own))]
        panels.append(Panel(f"{group} and the compass", STEP, Axis(RATE, *ends([*rate, *own])), curves))
    part = parts["most like A"]
    axis = Axis("least correlation with the compass", -1.1, 1.1)
    alike = _numbers("likeness", part["least_correlation"], "A", part["holds"], axis)
    return SmallFigure(
        "The rate of θ₁ in the typical solutions and in the compass (dashed), and the least correlation "
        "of angles and rates of the legs.",
        [*panels, alike],
    )


def distance(data: CycleTables, evidence: Evidence) -> SmallFigure:
    """C15: the distance d over a step with its change of sign, and its range."""
    parts = evidence["parts"]
    known = {g: data.profiles[g]["d"] for g in TYPICAL if g in data.profiles}
    curves = [_profile(g, d, g) for g, d in known.items()]
    marks = [
        Mark(entry["d_crossing"], 0.0, entry["holds"], f"{g} {shown(entry['d_crossing'], '.2f')}", place(g))
        for g in TYPICAL
        if (entry := parts.get(f"signs in {g}", {})).get("d_crossing") is not None
    ]
    over = Panel(
        "d over one step", STEP, Axis("d in L", *ends([v for d in known.values() for v in d])), curves,
        marks=marks, guides=[Guide("y", 0.0)],
    )  # fmt: skip
    part = parts["A fluctuates most"]
    _, high = ends([0.0, *(v for v in part["travel"].values() if v is not None)])
    axis = Axis("greatest minus least d in L", 0.0, high)
    panels = [over, _numbers("range of d", part["travel"], "A", part["holds"], axis)]
    return SmallFigure(
        "The distance d in the typical solutions; marked is where it becomes negative.", panels
    )


def amplitude(data: CycleTables, evidence: Evidence) -> SmallFigure:
    """C20: the greatest modulus of x beside what counts as about 0.05."""
    parts = evidence["parts"]
    part = parts["rounds to 0.05"]
    bands = [
        Band("x", 0.025, 0.1, "within a factor of two of 0.05"),
        Band("x", 0.045, 0.055, "rounds to 0.05"),
    ]
    found = {g: value for g, value in part["amplitude"].items() if value is not None}
    _, high = ends([0.0, 0.105, *found.values()], 0.05)
    largest = max(found, key=found.__getitem__, default="")
    panel = _numbers("largest |x|", found, largest, part["holds"], Axis("|x| in L", 0.0, high), bands)
    curves = [_profile(g, data.profiles[g]["x"], g) for g in TYPICAL if g in data.profiles]
    values = [v for g in TYPICAL if g in data.profiles for v in data.profiles[g]["x"]]
    over = Panel(
        "x over one step", STEP, Axis("x in L", *ends([*values, -0.05, 0.05])), curves,
        guides=[Guide("y", -0.05), Guide("y", 0.05, "0.05")],
    )  # fmt: skip
    return SmallFigure(
        "Largest |x| of the typical solutions. Dark: rounds to 0.05; light: within a factor of two of it.",
        [panel, over],
    )


def _numbers(
    title: str,
    found: Mapping[str, float | None],
    best: str,
    holds: bool,
    axis: Axis,
    bands: Sequence[Band] = (),
) -> Panel:
    """One number of each typical solution, of which one decides."""
    values = {g: value for g, value in found.items() if value is not None}
    curves = [Curve(look_of(g), [v], [i], dots=True) for i, (g, v) in enumerate(values.items())]
    marks = [Mark(v, i, holds, "", place(g)) for i, (g, v) in enumerate(values.items()) if g == best]
    rows = [f"{g}  {shown(value, '.3g')}" for g, value in values.items()]
    return Panel(title, axis, rows_axis(rows or ["none"]), curves, marks=marks, bands=bands)


def _profile(group: str, values: np.ndarray, text: str = "") -> Curve:
    return Curve(look_of(group), *_drawn(values), text=text)


def _drawn(values: np.ndarray) -> tuple[list[float], list[float]]:
    """Fewer samples over a step from 0 to 1, both ends among them."""
    at = np.arange(0, len(values), EVERY)
    return (at / max(len(values) - 1, 1)).tolist(), np.asarray(values)[at].tolist()


def _maxima(values: np.ndarray) -> np.ndarray:
    rise = np.diff(values)
    return 1 + np.flatnonzero((rise[:-1] > 0) & (rise[1:] <= 0))
