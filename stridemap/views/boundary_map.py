"""Boundaries of gaits and their bifurcations in the plane of two parameters."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.boundaries.boundaries import Boundaries
from stridemap.units import Units
from stridemap.views.markers import BOUNDARY_LINES, BOUNDARY_NAMES, MARKERS, POINTS
from stridemap.views.optional import require_pictures
from stridemap.views.sizes import in_units

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SIZE = (6.2, 4.2)
"""Width and height in inches."""


def boundary_map(
    boundaries: Boundaries,
    *,
    gaits_only: bool = True,
    stable_only: bool = False,
    units: Units | None = None,
) -> "Figure":
    """Draw boundaries in the plane of their two parameters.

    Where a boundary limits stable gaits it is thick; elsewhere thin.

    Parameters
    ----------
    boundaries : Boundaries
    gaits_only : bool
        Whether parts and points at which cycles are not gaits are left out.
    stable_only : bool
        Whether parts that do not limit stable gaits are left out.
    units : Units, optional
        The size of a robot: values are in its SI units.

    Returns
    -------
    matplotlib.figure.Figure
        It belongs to no window; ``figure.savefig(path)`` writes it.

    Raises
    ------
    InputError
        When matplotlib is missing.
    """
    require_pictures()
    from stridemap.views import style

    with style.styled():
        figure = style.new_figure(*SIZE)
        axes = figure.subplots()
        labelled: set[str] = set()
        factors, words = zip(
            *(in_units(boundaries.model, name, units) for name in boundaries.vary), strict=True
        )
        for one in boundaries:
            plane = one.cycles[:, -2:] * factors
            gait, stable = one.is_gait, one.borders_stable
            label = MARKERS[one.type][1] if one.type in MARKERS else BOUNDARY_NAMES[one.type]
            colour, dashes = BOUNDARY_LINES[one.type]
            for weight in (0, 1, 2):
                shown = (gait & stable, gait & ~stable, ~gait)[2 - weight]
                if (weight == 0 and gaits_only) or (weight < 2 and stable_only):
                    continue
                piece = shown[:-1] & shown[1:]
                if not piece.any():
                    continue
                x, y = (np.where(_kept(piece), plane[:, k], np.nan) for k in (0, 1))
                axes.plot(
                    x,
                    y,
                    color=colour,
                    linestyle=(0, dashes) if dashes else "-",
                    linewidth=(0.4, 0.8, 1.8)[weight],
                    label=None if label in labelled else label,
                )
                labelled.add(label)
        for point in boundaries.points:
            marker, name = POINTS[point.type]
            if point.type != "corner" and (point.gait or not gaits_only):
                first, second = boundaries.vary
                axes.plot(
                    [point.params[first] * factors[0]],
                    [point.params[second] * factors[1]],
                    marker=marker,
                    linestyle="",
                    markersize=4.5,
                    color=style.DARK,
                    label=None if name in labelled else name,
                )
                labelled.add(name)
        across, up = (f"{name}{word}" for name, word in zip(boundaries.vary, words, strict=True))
        ends = np.array(boundaries.ranges) * np.array(factors)[:, None]
        axes.set(xlabel=across, ylabel=up, xlim=ends[0], ylim=ends[1])
        axes.set_title(boundaries.model.title)
        if labelled:
            axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5))
    return figure


def _kept(piece: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Points at either end of a piece that is drawn."""
    return np.append(piece, False) | np.append(False, piece)
