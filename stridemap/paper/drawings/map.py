"""The map: where in the plane of two parameters limit cycles are, stable ones and others."""

from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from stridemap.paper.drawings.material import SOLUTIONS, Material
from stridemap.paper.drawings.raster import NONE, STABLE, letters, rastered
from stridemap.paper.points import PLANE
from stridemap.solver.branches.refinement import refined
from stridemap.solver.model.loading import load
from stridemap.views import style

HEIGHT = 66 * style.MM
TIMES = 2
"""Number of times that the cells along the edges are halved."""


def draw(material: Material) -> Figure:
    """The map of the paper: spring stiffness and mass ratio at one frequency."""
    config = material.sweeps.configs["map"]
    grid, omega = config.grid, PLANE["omega"]
    coarse = rastered(material.map, "k", grid["k"], "alpha", grid["alpha"])
    of = refined(load(config.model), {**config.params, "omega": omega}, coarse, material.map, TIMES)
    figure = style.new_figure(style.COLUMN, HEIGHT)
    axes = figure.add_subplot()
    colours = ListedColormap([style.NONE, style.UNSTABLE, style.STABLE])
    axes.imshow(
        of.classes, cmap=colours, vmin=NONE, vmax=STABLE, origin="lower", extent=of.extent, aspect="auto"
    )
    for letter, k, alpha in letters(of, HEIGHT / style.COLUMN):
        axes.annotate(
            letter, (k, alpha), ha="center", va="center", fontsize=10, fontweight="bold", bbox=_backed()
        )
    for letter, (_, k) in SOLUTIONS.items():
        axes.plot(
            k, PLANE["alpha"], "o", ms=4, mfc=style.WHITE, mec=style.BLACK, mew=0.9, gid=letter, clip_on=False
        )
        axes.annotate(
            letter, (k, PLANE["alpha"]), (3.5, -3.5), textcoords="offset points", ha="left", va="top",
            fontstyle="italic", bbox=_backed(),
        )  # fmt: skip
    axes.set(xlabel="spring stiffness $k$  [$Mg/L$]", ylabel=r"mass ratio $\alpha$  [–]")
    axes.set(xlim=of.extent[:2], ylim=of.extent[2:])  # beyond, nothing was searched
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
    """A pale ground behind a letter, so that it can be read on every class."""
    return {"boxstyle": "round,pad=0.12", "facecolor": "white", "edgecolor": "none", "alpha": 0.85}
