"""Pictures of limit cycles for notebooks: what stands beside their tables, where matplotlib is installed."""

from typing import TYPE_CHECKING, Any

import numpy as np

from stridemap.errors import StridemapError
from stridemap.solver.cycles.orbit import Orbit
from stridemap.solver.cycles.orbits import Orbits

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def picture(found: Orbit | Orbits) -> str:
    """A picture of limit cycles as HTML; empty where there is nothing to draw, or nothing to draw with.

    Of one limit cycle, its phase portraits. Of several at one point of parameter space, their Floquet
    multipliers beside the unit circle; of others, the largest multiplier over the first parameter that
    differs.

    Parameters
    ----------
    found : Orbit or Orbits
    """
    try:
        if isinstance(found, Orbit):
            return "" if not found.status.found else _html(found.plot("phase", samples=101))
        drawn = found[found.found]
        if not len(drawn):
            return ""
        differs = [
            name
            for name, values in zip(drawn.model.spec.names, drawn.params.T, strict=True)
            if len(np.unique(values)) > 1
        ]
        if differs:
            return _html(drawn.plot(differs[0], "spectral_radius", colour="cot"))
        return _html(multiplier_plane(drawn))
    except StridemapError:  # without matplotlib, or for a model that cannot be drawn, the table says it all
        return ""


def multiplier_plane(orbits: Orbits) -> "Figure":
    """Floquet multipliers of limit cycles in the complex plane, with the unit circle.

    Parameters
    ----------
    orbits : Orbits

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        When matplotlib is missing.
    """
    from stridemap.views.optional import require_pictures

    require_pictures()
    from stridemap.views import style

    with style.styled():
        figure = style.new_figure(3.4, 3.0)
        axes = figure.subplots()
        around = np.exp(1j * np.linspace(0, 2 * np.pi, 121))
        axes.plot(around.real, around.imag, color=style.GREY, linewidth=0.8)
        colours = (style.BLUE, style.VERMILION, style.GREEN, style.PURPLE, style.SKY, style.DARK)
        for i, orbit in enumerate(orbits):
            values = np.array(orbit.multipliers)
            colour = colours[i % len(colours)]
            look: dict[str, Any] = {"markersize": 4.5, "linestyle": "", "marker": "o", "color": colour}
            look["markerfacecolor"] = colour if orbit.stable else style.WHITE
            axes.plot(values.real, values.imag, label=f"{i}: {orbit.stability}" if i < 8 else None, **look)
        axes.set(xlabel="real part of a multiplier", ylabel="imaginary part", aspect="equal")
        axes.legend(loc="center left", bbox_to_anchor=(1.02, 0.5))
    return figure


def _html(figure: "Figure") -> str:
    from stridemap.views import style

    return style.svg(figure)
