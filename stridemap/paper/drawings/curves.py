"""Quantities of limit cycles against one parameter, along their branches."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from stridemap.columns import unit_of
from stridemap.paper.drawings.material import Material
from stridemap.quantities import QUANTITIES
from stridemap.solver.model.loading import load
from stridemap.spec import UnitNames
from stridemap.views import style
from stridemap.views.notation import latex_axis

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Curve:
    """What is plotted: a quantity, and the part of its axis that is shown.

    Branches run far beyond that part where cycles come to a standstill and the cost of transport grows
    without bound.

    Parameters
    ----------
    quantity : str
        A name of `stridemap.quantities.QUANTITIES`.
    shown : (float, float)
        Ends of the axis, in units of the compass walker's value.
    """

    quantity: str
    shown: tuple[float, float]

    def label(self, units: UnitNames) -> str:
        """Text of the axis."""
        quantity = QUANTITIES[self.quantity]
        formula = f"  ${quantity.formula}$" if quantity.formula else ""
        return latex_axis(quantity.label + formula, unit_of(quantity.kind, units), units)


MULTIPLIER = Curve("spectral_radius", (0.94, 1.75))
DISTANCE = Curve("d_max", (0.8, 1.6))
COST = Curve("cot", (0.6, 1.8))

APART = 4.5
"""Least distance of two letters above a panel, in units of the spring stiffness."""


def draw_multipliers(material: Material) -> Figure:
    """Largest Floquet multiplier against the spring stiffness."""
    return _draw(material, MULTIPLIER)


def draw_distance(material: Material) -> Figure:
    """Largest distance of stance foot and ZMP against the spring stiffness."""
    return _draw(material, DISTANCE)


def draw_cost(material: Material) -> Figure:
    """Cost of transport against the spring stiffness."""
    return _draw(material, COST)


def pieces(branch: pd.DataFrame, quantity: str, parameter: str = "k") -> list[tuple[bool, Floats, Floats]]:
    """Pieces of a branch between changes of stability: whether each is stable, and its points.

    Both pieces end at the point where the largest multiplier is 1, by linear interpolation. There is a gap
    where cycles lose contact with the ground.
    """
    x, radius = branch[parameter].to_numpy(), branch["spectral_radius"].to_numpy()
    y = branch[quantity].where(branch["min_vertical_force"] > 0).to_numpy(dtype=np.float64)
    stable = branch["stable"].fillna(False).to_numpy(dtype=bool)
    changes = np.flatnonzero(stable[1:] != stable[:-1])
    out = []
    edges = [0, *(changes + 1), len(x)]
    for first, last in pairwise(edges):
        xs, ys = x[first:last], y[first:last]
        if first:
            at = _interpolated(first - 1, x, y, radius)
            xs, ys = np.append(at[0], xs), np.append(at[1], ys)
        if last < len(x):
            at = _interpolated(last - 1, x, y, radius)
            xs, ys = np.append(xs, at[0]), np.append(ys, at[1])
        out.append((bool(stable[first]), xs, ys))
    return out


def _interpolated(i: int, x: Floats, y: Floats, radius: Floats) -> tuple[float, float]:
    share = (1 - radius[i]) / (radius[i + 1] - radius[i])
    return float(x[i] + share * (x[i + 1] - x[i])), float(y[i] + share * (y[i + 1] - y[i]))


def _draw(material: Material, curve: Curve) -> Figure:
    """Panels as in the paper: one row per frequency, one column per mass ratio."""
    config = material.sweeps.configs["lines"]
    grid, spec = config.grid, load(config.model).spec
    figure = style.new_figure(style.COLUMN, 84 * style.MM)
    panels = figure.subplots(len(grid["omega"]), len(grid["alpha"]), sharex=True, sharey="row", squeeze=False)
    for row, omega in enumerate(grid["omega"]):
        compass = material.compass(omega)
        for column, alpha in enumerate(grid["alpha"]):
            axes = panels[row, column]
            draw_panel(axes, material.branch_sets[alpha, omega], curve.quantity)
            reference = float(compass.row[curve.quantity])
            axes.axhline(reference, zorder=1, **style.COMPASS_LINE)
            axes.set_title(rf"$\alpha = {alpha:g}$, $\omega = {omega:g}$", pad=12)
            axes.set(xlim=(0, grid["k"][-1]), ylim=[share * reference for share in curve.shown])
    (spring,) = (parameter for parameter in spec.parameters if parameter.name == "k")
    figure.supxlabel(latex_axis("spring stiffness  $k$", spring.unit, spec.units), fontsize=8)
    figure.supylabel(curve.label(spec.units), fontsize=8)
    figure.legend(handles=_legend(), loc="outside upper center", ncols=3, columnspacing=1.4)
    return figure


def draw_panel(axes: Axes, of: list[pd.DataFrame], quantity: str) -> None:
    """Draw branches, with the letter of each group above the middle of its stable cycles."""
    for branch in of:
        for stable, x, y in pieces(branch, quantity):
            line = style.STABLE_LINE if stable else style.UNSTABLE_LINE
            axes.plot(x, y, zorder=3 if stable else 2, **line)
    everything = pd.concat(of)
    edge = -np.inf
    for letter, rows in everything[everything["stable"].fillna(False).astype(bool)].groupby("group"):
        edge = max((rows["k"].min() + rows["k"].max()) / 2, edge + APART)
        axes.text(
            edge, 1.01, letter, transform=axes.get_xaxis_transform(),
            ha="center", va="bottom", fontsize=7.5, fontweight="bold",
        )  # fmt: skip


def _legend() -> list[Line2D]:
    lines = {"stable": style.STABLE_LINE, "unstable": style.UNSTABLE_LINE, "compass": style.COMPASS_LINE}
    return [Line2D([], [], label=name, **line) for name, line in lines.items()]
