"""Time profiles over one step: the state of typical solutions, and the distance of foot and ZMP."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from stridemap.paper.drawings.material import SOLUTIONS, Material
from stridemap.paper.points import PLANE
from stridemap.solver.observables.motion import Motion
from stridemap.views import style
from stridemap.views.notation import latex_axis, state_labels, time_label

SAMPLES = 401


def draw_typical(material: Material) -> Figure:
    """State of the typical solutions: one column per solution, one row per coordinate or rate."""
    spec = material.typical["a"].model.spec
    labels = state_labels(spec)
    figure = style.new_figure(style.COLUMN, 118 * style.MM)
    panels = figure.subplots(len(labels), len(SOLUTIONS), sharex="col", sharey="row")
    for column, (letter, cycle) in enumerate(material.typical.items()):
        seen = cycle.motion(SAMPLES)
        for row, name in enumerate(labels):
            _profile(panels[row, column], seen, name, style.SOLUTIONS[letter]["color"])
        group, k = SOLUTIONS[letter]
        panels[0, column].set_title(f"({letter}) group {group}\n$k = {k:g}$")
        panels[-1, column].set_xlim(0, cycle.period)
        panels[-1, column].set_xticks([0, 0.5, 1])
    for row, (symbol, unit) in enumerate(labels.values()):
        panels[row, 0].set_ylabel(f"{symbol}\n{unit}")
    figure.align_ylabels(panels[:, 0])
    panels[-1, 1].set_xlabel(time_label(spec))
    return figure


def draw_compass(material: Material) -> Figure:
    """State of the walker without a wobbling mass at the same frequency."""
    cycle = material.compass(PLANE["omega"])
    seen, spec = cycle.motion(SAMPLES), cycle.model.spec
    figure = style.new_figure(style.COLUMN, 58 * style.MM)
    panels = figure.subplots(len(spec.coordinates), 2, sharex=True)
    for axes, (name, (symbol, unit)) in zip(panels.T.ravel(), state_labels(spec).items(), strict=True):
        _profile(axes, seen, name, style.BLACK)
        axes.set_ylabel(f"{symbol} {unit}")
        axes.set_xlim(0, cycle.period)
    for axes in panels[-1]:
        axes.set_xlabel(time_label(spec))
    return figure


def draw_distance(material: Material) -> Figure:
    """Signed distance of stance foot and ZMP over a step, typical solutions and compass."""
    figure = style.new_figure(style.COLUMN, 58 * style.MM)
    axes = figure.add_subplot()
    _zero(axes)
    cycles = {**material.typical, "compass": material.compass(PLANE["omega"])}
    for letter, cycle in cycles.items():
        seen = cycle.motion(SAMPLES)
        name = "compass" if letter == "compass" else f"{letter}:  $k = {SOLUTIONS[letter][1]:g}$"
        axes.plot(seen.t, seen.d, label=name, **style.SOLUTIONS[letter])
    spec = cycles["compass"].model.spec
    length = spec.units.length
    axes.set(xlabel=time_label(spec), ylabel=latex_axis("stance foot − ZMP:  $d$", length, spec.units))
    axes.set_xlim(0, max(cycle.period for cycle in cycles.values()))
    axes.legend(loc="upper right")
    return figure


def peaks(values: np.ndarray) -> np.ndarray:
    """Indices of the local maxima inside of sampled values."""
    return 1 + np.flatnonzero((values[1:-1] > values[:-2]) & (values[1:-1] >= values[2:]))


def _profile(axes: Axes, seen: Motion, name: str, colour: str) -> None:
    """One coordinate or rate; the peaks of the stance leg's rate, which distinguish groups, are marked."""
    values = seen.coordinate(name)
    _zero(axes)
    axes.plot(seen.t, values, color=colour, linewidth=1.3)
    if name == f"d{seen.model.spec.stance_angle}":
        at = peaks(values)
        mark: dict[str, Any] = {"ms": 3.5, "mfc": style.WHITE, "mec": style.BLACK, "mew": 0.8}
        axes.plot(seen.t[at], values[at], "v", zorder=3, **mark)
    axes.margins(y=0.12)


def _zero(axes: Axes) -> None:
    axes.axhline(0, color=style.GREY, linewidth=0.5, zorder=0)
