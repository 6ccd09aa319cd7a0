"""The map: where in the plane of two parameters limit cycles are, stable ones and others."""

import string
from dataclasses import dataclass

import numpy as np
import pandas as pd
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt, label

from stridemap.sweeps.draw import style
from stridemap.sweeps.draw.data import PLANE, TYPICAL, Data

NONE, UNSTABLE, STABLE = 0, 1, 2
"""Classes of a cell, from what is found in it."""

HEIGHT = 66 * style.MM
SMALLEST = 0.004
"""Share of the map's area below which a patch of one group gets no letter."""


@dataclass(frozen=True)
class Raster:
    """Classes and groups of the cells of a plane.

    Parameters
    ----------
    x, y : ndarray, shapes (n,) and (m,)
        Evenly spaced values of the two parameters.
    classes : ndarray of int, shape (m, n)
        `NONE`, `UNSTABLE` (no stable cycle) or `STABLE`.
    groups : ndarray of int, shape (m, n)
        Group of the cell's most stable cycle, 0 for A; -1 where there is none.
    """

    x: NDArray[np.float64]
    y: NDArray[np.float64]
    classes: NDArray[np.int64]
    groups: NDArray[np.int64]

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """Left, right, bottom and top of the cells, whose middles are the values."""
        (left, right), (bottom, top) = (
            (v[0] - (v[1] - v[0]) / 2, v[-1] + (v[-1] - v[-2]) / 2) for v in (self.x, self.y)
        )
        return float(left), float(right), float(bottom), float(top)


def raster(orbits: pd.DataFrame, x: str, xs: tuple[float, ...], y: str, ys: tuple[float, ...]) -> Raster:
    """Classify the cells of the plane of parameters `x` and `y` by the limit cycles found in them."""
    classes = np.full((len(ys), len(xs)), NONE)
    groups = np.full((len(ys), len(xs)), -1)
    # The most stable cycle of a cell comes last, and stays.
    rows = orbits.sort_values("spectral_radius", ascending=False)
    at = np.searchsorted(ys, rows[y]), np.searchsorted(xs, rows[x])
    classes[at] = np.where(rows["stable"], STABLE, UNSTABLE)
    groups[at] = [-1 if g is None else string.ascii_uppercase.index(g) for g in rows["group"]]
    return Raster(np.array(xs), np.array(ys), classes, groups)


def letters(of: Raster) -> list[tuple[str, float, float]]:
    """The letter of each group with the place, in parameters, where its widest patch is widest."""
    out = []
    aspect = np.array([HEIGHT / len(of.y), style.COLUMN / len(of.x)])
    for group in range(of.groups.max() + 1):
        patches, count = label(of.groups == group)
        sizes = np.bincount(patches.ravel(), minlength=count + 1)[1:]
        if not count or sizes.max() < SMALLEST * of.groups.size:
            continue
        inside = np.pad(patches == 1 + sizes.argmax(), 1)  # the map's own edge bounds a patch too
        room = distance_transform_edt(inside, sampling=aspect)[1:-1, 1:-1]
        row, column = np.unravel_index(room.argmax(), room.shape)
        out.append((string.ascii_uppercase[group], float(of.x[column]), float(of.y[row])))
    return out


def draw(data: Data) -> Figure:
    """The map of the paper: spring stiffness and mass ratio at one frequency."""
    table = data.map
    grid, omega = table.config.grid, table.config.params["omega"]
    of = raster(table.orbits, "k", grid["k"], "alpha", grid["alpha"])
    figure = style.new_figure(style.COLUMN, HEIGHT)
    axes = figure.add_subplot()
    colours = ListedColormap([style.NONE, style.UNSTABLE, style.STABLE])
    axes.imshow(
        of.classes, cmap=colours, vmin=NONE, vmax=STABLE, origin="lower", extent=of.extent, aspect="auto"
    )
    for letter, k, alpha in letters(of):
        axes.annotate(
            letter, (k, alpha), ha="center", va="center", fontsize=10, fontweight="bold", bbox=_backed()
        )
    for letter, (_, k) in TYPICAL.items():
        axes.plot(k, PLANE["alpha"], "o", ms=4, mfc=style.WHITE, mec=style.BLACK, mew=0.9, gid=letter)
        axes.annotate(
            letter, (k, PLANE["alpha"]), (3.5, -3.5), textcoords="offset points", ha="left", va="top",
            fontstyle="italic", bbox=_backed(),
        )  # fmt: skip
    axes.set(xlabel="spring stiffness $k$  [$Mg/L$]", ylabel=r"mass ratio $\alpha$  [–]")
    axes.set(xlim=(0, of.extent[1]), ylim=(0, of.extent[3]))
    handles = [
        Patch(facecolor=colour, edgecolor=style.BLACK, linewidth=0.5, label=text)
        for colour, text in (
            (style.STABLE, "stable"), (style.UNSTABLE, "unstable only"), (style.NONE, "none found"),
        )
    ]  # fmt: skip
    figure.legend(handles=handles, loc="outside upper center", ncols=3, handlelength=1.2, columnspacing=1.2)
    axes.set_title(rf"$\omega = {omega:g}\,\sqrt{{g/L}}$", loc="right", fontsize=7)
    return figure


def _backed() -> dict:
    """A pale ground behind a letter, so that it reads on every class."""
    return {"boxstyle": "round,pad=0.12", "facecolor": "white", "edgecolor": "none", "alpha": 0.85}
