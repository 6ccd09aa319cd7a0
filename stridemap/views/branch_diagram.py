"""Bifurcation diagrams: branches of limit cycles over a parameter, with their special points."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.solver.branches.arclength import EndReason
from stridemap.solver.branches.branches import Branches, SpecialPoint
from stridemap.solver.model.model import Model
from stridemap.units import Units
from stridemap.views.branch_lines import NO_GAIT, STABLE, UNSTABLE, kinds_of, looks_between, placed
from stridemap.views.markers import MARKERS
from stridemap.views.optional import require_pictures
from stridemap.views.sizes import in_units
from stridemap.words import multiplier_columns

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

SIZE = (5.2, 3.6)
"""Width and height in inches."""

LOOSE = (EndReason.PERIOD, EndReason.STALLED, EndReason.REGION, EndReason.STEPS)
"""Reasons to follow a branch no further that do not say that its gaits end."""

NOT_FOLLOWED = "not followed on"


def branch_diagram(
    branches: Branches, y: str = "period", *, gaits_only: bool = False, units: Units | None = None
) -> "Figure":
    """Draw a bifurcation diagram.

    Stable cycles are solid, unstable ones dashed, and cycles that are not gaits thin and grey. Bifurcations
    and ends of gaits have markers, and so has an end that only the limits of following make.

    Parameters
    ----------
    branches : Branches
    y : str
        What is drawn over the parameter: ``period`` or an entry of the section, which are drawn for each step
        of a cycle; or any other column of ``branches.to_frame()``.
    gaits_only : bool
        Whether cycles that are not gaits are left out.
    units : Units, optional
        The size of a robot: values are in its SI units.

    Returns
    -------
    matplotlib.figure.Figure
        It belongs to no window; ``figure.savefig(path)`` writes it.

    Raises
    ------
    InputError
        When there is no such column, or matplotlib is missing.
    """
    check_column(branches.model, y)
    require_pictures()
    from stridemap.views import style

    with style.styled():
        figure = style.new_figure(*SIZE)
        axes = figure.subplots()
        (across, along), (up, upwards) = (
            in_units(branches.model, name, units) for name in (branches.vary, y)
        )
        steps = y in (*branches.model.section, "period")
        tables = None if steps else (branches.to_frame(), branches.special_frame())
        for number in range(len(branches)):
            drawn = _drawn(branches, number, y, tables)
            drawn = replace(drawn, x=drawn.x * across, y=drawn.y * up)
            _draw(axes, drawn, gaits_only)
            _mark(axes, drawn, gaits_only)
        axes.set(xlabel=f"{branches.vary}{along}", ylabel=f"{_label(branches, y)}{upwards}")
        axes.set(xlim=[end * across for end in branches.range])
        axes.set_title(branches.model.title)
        if axes.get_legend_handles_labels()[1]:
            axes.legend(loc="best")
    return figure


def check_column(model: Model, y: str) -> None:
    """Refuse what cannot be drawn over the parameter.

    Raises
    ------
    InputError
        When y is neither an entry of the section, the period, nor a number that is measured on the model.
    """
    measured = [name for name, one in model.measured.items() if one.type in ("float", "int")]
    multipliers = [name for i in range(len(model.section)) for name in multiplier_columns(i)]
    known = list(dict.fromkeys([*model.section, "period", *measured, *multipliers]))
    if y not in known:
        raise InputError(f"{y!r} cannot be drawn; what can be is {', '.join(known)}")


def check_picture(path: Path) -> None:
    """Refuse a path whose ending does not name a kind of picture.

    Raises
    ------
    InputError
        For such an ending, or when matplotlib is missing.
    """
    require_pictures()
    from matplotlib.backend_bases import FigureCanvasBase

    kinds = sorted(FigureCanvasBase.get_supported_filetypes())
    if path.suffix[1:] not in kinds:
        raise InputError(f"{path} has no ending that names a kind of picture: {', '.join(kinds)}")


@dataclass(frozen=True)
class _Drawn:
    """A branch as it is drawn, its special points among its points."""

    x: Array
    """Values of the parameter, shape (m,)."""
    y: Array
    """What is drawn, shape (m, curves)."""
    look: NDArray[np.int_]
    """Of the piece after each point but the last, shape (m - 1,)."""
    special: dict[int, SpecialPoint]
    """By their place among the points."""
    loose: list[int]
    """Places of its ends within the range at which gaits may go on."""


def _drawn(branches: Branches, number: int, y: str, tables: tuple[Any, Any] | None) -> _Drawn:
    """A branch with its special points put where they lie, so that looks change there and not beside them.

    What is measured stands in the tables of points and of special points; without them each step is drawn.
    """
    branch = branches[number]
    special = [one for one in branches.special if one.branch == number]
    lengths = np.array([*branch.arclength, *(one.arclength for one in special)])
    x = np.array([*branch.x[:, -1], *(one.value for one in special)])
    names = [*branches.model.section, "period"]
    n = len(branch.points)
    if tables is None:
        steps = branch.x[:, :-1].reshape(n, branch.period_n, -1)
        at_special = [[step[names.index(y)] for step in one.steps] for one in special]
        values = np.concatenate([steps[:, :, names.index(y)], np.reshape(at_special, (-1, branch.period_n))])
    else:
        parts = [table.loc[table["branch"] == number, y] for table in tables if len(table)]
        values = np.concatenate([np.asarray(part, dtype=np.float64) for part in parts])[:, None]
    order = placed(lengths[:n], lengths[n:])
    largest = np.array([np.abs(point.multipliers).max(initial=0.0) for point in branch.points])
    look = looks_between(order, kinds_of(branch.is_gait, largest))
    places = {int(np.flatnonzero(order == n + i)[0]): one for i, one in enumerate(special)}
    ends = zip((0, -1), branch.reasons, strict=True)
    loose = [end for end, reason in ends if reason in LOOSE and branch.is_gait[end]]
    return _Drawn(x[order], values[order], look, places, loose)


def _draw(axes: "Axes", drawn: _Drawn, gaits_only: bool) -> None:
    """The curves of one branch, in pieces of one look each."""
    from stridemap.views import style

    looks: dict[int, dict[str, Any]] = {
        STABLE: {"color": style.BLUE, "linewidth": 1.6, "linestyle": "-"},
        UNSTABLE: {"color": style.DARK, "linewidth": 0.9, "linestyle": (0, (4, 2))},
        NO_GAIT: {"color": style.GREY, "linewidth": 0.5, "linestyle": (0, (4, 2))},
    }
    begins = np.flatnonzero(np.append(True, drawn.look[1:] != drawn.look[:-1]))
    for first, last in zip(begins, [*begins[1:], len(drawn.look)], strict=True):
        look = int(drawn.look[first])
        if look or not gaits_only:
            piece = slice(first, last + 1)
            axes.plot(drawn.x[piece], drawn.y[piece], **looks[look])
    for end in drawn.loose:
        known = NOT_FOLLOWED in axes.get_legend_handles_labels()[1]
        axes.plot(
            np.full(drawn.y.shape[1], drawn.x[end]),
            drawn.y[end],
            linestyle="",
            marker="h",
            markersize=4.5,
            color=style.GREY,
            label=None if known else NOT_FOLLOWED,
        )


def _mark(axes: "Axes", drawn: _Drawn, gaits_only: bool) -> None:
    """Markers of the special points, one entry of the legend per type."""
    from stridemap.views import style

    labelled = set(axes.get_legend_handles_labels()[1])
    for at, one in drawn.special.items():
        if gaits_only and not one.gait:
            continue
        marker, label = MARKERS[one.type]
        look: dict[str, Any] = {
            "marker": marker,
            "linestyle": "",
            "markersize": 4.5,
            "color": style.VERMILION if one.type in ("fold", "pd", "ns", "bp") else style.GREEN,
            "zorder": 3,
        }
        if one.criticality == "subcritical":
            look["markerfacecolor"] = style.WHITE
        values = drawn.y[at]
        axes.plot(
            np.full(len(values), drawn.x[at]), values, label=None if label in labelled else label, **look
        )
        labelled.add(label)


def _label(branches: Branches, y: str) -> str:
    """A label of the vertical axis."""
    if y == "period":
        return "step period"
    quantity = branches.model.measured.get(y)
    return y if quantity is None else quantity.label
