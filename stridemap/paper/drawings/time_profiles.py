"""Time profiles over one step: the state of typical solutions, and the distance of foot and ZMP."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from stridemap.paper.figures.material import PLANE, TYPICAL, Data
from stridemap.solver.observables.motion import Motion, motion
from stridemap.views import style

SAMPLES = 401
TIME = r"time $t$  [$\sqrt{L/g}$]"
SYMBOLS = {
    "theta1": (r"$\theta_1$", "[rad]"),
    "theta2": (r"$\theta_2$", "[rad]"),
    "x": ("$x$", "[$L$]"),
    "dtheta1": (r"$\dot{\theta}_1$", r"[$\sqrt{g/L}$]"),
    "dtheta2": (r"$\dot{\theta}_2$", r"[$\sqrt{g/L}$]"),
    "dx": (r"$\dot{x}$", r"[$\sqrt{gL}$]"),
}
"""Symbol and unit of what is plotted."""


def draw_typical(data: Data) -> Figure:
    """State of the three typical solutions: a column each, a row a coordinate or rate."""
    names = list(SYMBOLS)
    figure = style.new_figure(style.COLUMN, 118 * style.MM)
    panels = figure.subplots(len(names), len(TYPICAL), sharex="col", sharey="row")
    for column, (letter, orbit) in enumerate(data.typical.items()):
        seen = motion(orbit, SAMPLES)
        for row, name in enumerate(names):
            _profile(panels[row, column], seen, name, style.SOLUTIONS[letter]["color"])
        group, k = TYPICAL[letter]
        panels[0, column].set_title(f"({letter}) group {group}\n$k = {k:g}$")
        panels[-1, column].set_xlim(0, orbit.period)
        panels[-1, column].set_xticks([0, 0.5, 1])
    for row, name in enumerate(names):
        panels[row, 0].set_ylabel("\n".join(SYMBOLS[name]))
    figure.align_ylabels(panels[:, 0])
    panels[-1, 1].set_xlabel(TIME)
    return figure


def draw_compass(data: Data) -> Figure:
    """State of the walker without a wobbling mass at the same frequency."""
    orbit = data.compass(PLANE["omega"])
    seen = motion(orbit, SAMPLES)
    figure = style.new_figure(style.COLUMN, 58 * style.MM)
    panels = figure.subplots(2, 2, sharex=True)
    for axes, name in zip(panels.T.ravel(), ("theta1", "theta2", "dtheta1", "dtheta2"), strict=True):
        _profile(axes, seen, name, style.BLACK)
        axes.set_ylabel(" ".join(SYMBOLS[name]))
        axes.set_xlim(0, orbit.period)
    for axes in panels[-1]:
        axes.set_xlabel(TIME)
    return figure


def draw_distance(data: Data) -> Figure:
    """Signed distance of stance foot and ZMP over a step, typical solutions and compass."""
    figure = style.new_figure(style.COLUMN, 58 * style.MM)
    axes = figure.add_subplot()
    _zero(axes)
    orbits = {**data.typical, "compass": data.compass(PLANE["omega"])}
    for letter, orbit in orbits.items():
        seen = motion(orbit, SAMPLES)
        name = "compass" if letter == "compass" else f"{letter}:  $k = {TYPICAL[letter][1]:g}$"
        axes.plot(seen.t, seen.d, label=name, **style.SOLUTIONS[letter])
    axes.set(xlabel=TIME, ylabel="stance foot − ZMP:  $d$  [$L$]")
    axes.set_xlim(0, max(orbit.period for orbit in orbits.values()))
    axes.legend(loc="upper right")
    return figure


def peaks(values: np.ndarray) -> np.ndarray:
    """Indices of the local maxima inside of sampled values."""
    return 1 + np.flatnonzero((values[1:-1] > values[:-2]) & (values[1:-1] >= values[2:]))


def _profile(axes: Axes, seen: Motion, name: str, colour: str) -> None:
    """One coordinate or rate; the peaks of the stance leg's rate, which tell groups apart, get a mark."""
    values = seen.coordinate(name)
    _zero(axes)
    axes.plot(seen.t, values, color=colour, linewidth=1.3)
    if name == "d" + seen.model.manifest["stance_angle"]:
        at = peaks(values)
        mark: dict[str, Any] = {"ms": 3.5, "mfc": style.WHITE, "mec": style.BLACK, "mew": 0.8}
        axes.plot(seen.t[at], values[at], "v", zorder=3, **mark)
    axes.margins(y=0.12)


def _zero(axes: Axes) -> None:
    axes.axhline(0, color=style.GREY, linewidth=0.5, zorder=0)
