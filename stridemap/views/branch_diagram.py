"""Bifurcation diagrams: branches of limit cycles over a parameter, with their special points."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.solver.branches.branches import Branches
from stridemap.solver.model.model import Model
from stridemap.views.optional import require_pictures
from stridemap.words import multiplier_columns

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from stridemap.solver.branches.survey import Branch

Array = NDArray[np.float64]

SIZE = (5.2, 3.6)
"""Width and height in inches."""

MARKERS = {
    "fold": ("o", "LP"),
    "pd": ("D", "PD"),
    "ns": ("s", "NS"),
    "bp": ("*", "BP"),
    "grazing": ("|", "grazing"),
    "early_touchdown": ("v", "early touchdown"),
    "backward": ("<", "backward"),
    "fall": ("x", "fall"),
    "contact": ("^", "contact lost"),
    "friction": ("P", "friction"),
}
"""Marker and label of each type of special point; LP, PD, NS and BP are the field's letters."""


def branch_diagram(branches: Branches, y: str = "period", *, gaits_only: bool = False) -> "Figure":
    """Draw a bifurcation diagram.

    Stable cycles are solid, unstable ones dashed, and cycles that are not gaits thin and grey. Bifurcations
    and ends of gaits have markers.

    Parameters
    ----------
    branches : Branches
    y : str
        What is drawn over the parameter: ``period`` or an entry of the section, which are drawn for each step
        of a cycle; or any other column of ``branches.to_frame()``.
    gaits_only : bool
        Whether cycles that are not gaits are left out.

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
        curves = [_values(branches, number, y) for number in range(len(branches))]
        for branch, values in zip(branches, curves, strict=True):
            _draw(axes, branch, values, gaits_only)
        _mark(axes, branches, curves, gaits_only)
        axes.set(xlabel=branches.vary, ylabel=_label(branches, y), xlim=branches.range)
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


def _values(branches: Branches, number: int, y: str) -> Array:
    """What is drawn of a branch, shape (points, curves)."""
    branch = branches[number]
    names = [*branches.model.section, "period"]
    if y in names:
        steps = branch.x[:, :-1].reshape(len(branch.points), branch.period_n, -1)
        values: Array = steps[:, :, names.index(y)]
        return values
    frame = branches.to_frame()
    column: Array = frame.loc[frame["branch"] == number, y].to_numpy(dtype=np.float64)[:, None]
    return column


def _draw(axes: "Axes", branch: "Branch", values: Array, gaits_only: bool) -> None:
    """The curves of one branch, in pieces of one look each."""
    from stridemap.views import style

    x, gait = branch.x[:, -1], branch.is_gait
    stable = np.array([np.abs(point.multipliers).max(initial=0.0) < 1.0 for point in branch.points])
    looks: dict[int, dict[str, Any]] = {
        2: {"color": style.BLUE, "linewidth": 1.6, "linestyle": "-"},
        1: {"color": style.DARK, "linewidth": 0.9, "linestyle": (0, (4, 2))},
        0: {"color": style.GREY, "linewidth": 0.5, "linestyle": (0, (4, 2))},
    }
    kind = np.where(gait, np.where(stable, 2, 1), 0)
    # A piece between two points looks as the less of both.
    piece = np.minimum(kind[:-1], kind[1:])
    begins = np.flatnonzero(np.append(True, piece[1:] != piece[:-1]))
    for first, last in zip(begins, [*begins[1:], len(piece)], strict=True):
        look = int(piece[first])
        if look or not gaits_only:
            axes.plot(x[first : last + 1], values[first : last + 1], **looks[look])


def _mark(axes: "Axes", branches: Branches, curves: list[Array], gaits_only: bool) -> None:
    """Markers of the special points, one entry of the legend per type."""
    from stridemap.views import style

    labelled: set[str] = set()
    for one in branches.special:
        if gaits_only and not one.gait:
            continue
        branch, values = branches[one.branch], curves[one.branch]
        near = np.abs(branch.x[:, -1] - one.value) / branch.curve.width
        state = np.array([one.state[name] for name in branches.model.section])
        first = branch.x[:, : len(state)]
        near = near + np.abs((first - state) / branch.curve.scale[: len(state)]).sum(axis=1)
        at = int(near.argmin())
        marker, label = MARKERS[one.type]
        solid = one.criticality != "subcritical"
        look: dict[str, Any] = {
            "marker": marker,
            "linestyle": "",
            "markersize": 4.5,
            "color": style.VERMILION if one.type in ("fold", "pd", "ns", "bp") else style.GREEN,
            "markerfacecolor": None if solid else style.WHITE,
            "zorder": 3,
        }
        look = {name: value for name, value in look.items() if value is not None}
        axes.plot(
            np.full(values.shape[1], one.value),
            values[at],
            label=None if label in labelled else label,
            **look,
        )
        labelled.add(label)


def _label(branches: Branches, y: str) -> str:
    """A label of the vertical axis."""
    if y == "period":
        return "step period"
    quantity = branches.model.measured.get(y)
    return y if quantity is None else quantity.label
