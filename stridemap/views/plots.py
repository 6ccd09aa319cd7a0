"""Plots of a limit cycle: its profiles over its steps, and its phase portraits."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from stridemap.columns import unit_of
from stridemap.errors import InputError
from stridemap.solver.cycles.orbit import Orbit
from stridemap.solver.observables.motion import Motion
from stridemap.views.optional import require_pictures

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

PANEL = (2.6, 1.9)
"""Width and height of a panel in inches."""


def plot(orbit: Orbit, kind: str = "profiles", *, samples: int = 201) -> "Figure":
    """Plot a limit cycle.

    Parameters
    ----------
    orbit : Orbit
    kind : {"profiles", "phase"}
        ``profiles``: coordinates, rates, ground force, the paper's distance `d` and how far the centre of
        pressure is ahead of the contact, against time over the cycle. ``phase``: the rate of each coordinate
        against the coordinate; a dot marks the state just after touchdown, and a dotted line the jump at the
        impact.
    samples : int
        Number of times per step, both ends included.

    Returns
    -------
    matplotlib.figure.Figure
        It belongs to no window; ``figure.savefig(path)`` writes it.

    Raises
    ------
    InputError
        For an unknown kind, an orbit that was not found, fewer than two samples, or a missing package.
    """
    if not isinstance(kind, str) or kind not in KINDS:
        raise InputError(f"kind = {kind!r} is not a kind of plot; kinds are {', '.join(KINDS)}")
    require_pictures()
    from stridemap.views import style

    seen = orbit.motion(samples)
    steps = [seen.step(i) for i in range(orbit.period_n)] if orbit.steps else [seen]
    with style.styled():
        return KINDS[kind](steps, _title(orbit))


def _profiles(steps: Sequence[Motion], title: str) -> "Figure":
    """One column for coordinates and force; one for the rates."""
    from stridemap.views import palette, style
    from stridemap.views.notation import latex_axis, state_labels, time_label

    spec = steps[0].model.spec
    labels, n = state_labels(spec), len(spec.coordinates)
    figure, panels = _grid(n + 1, 2, title)
    begin = np.concatenate([[0.0], np.cumsum([seen.t[-1] for seen in steps])])
    # A gap between steps: what jumps at a touchdown is not joined.
    t = _joined([seen.t + start for seen, start in zip(steps, begin, strict=False)])
    for i, (name, (symbol, unit)) in enumerate(labels.items()):
        axes = panels[i % n, i // n]
        axes.plot(t, _joined([seen.coordinate(name) for seen in steps]), color=style.BLUE)
        axes.set_ylabel(f"{symbol}  {unit}")
    force, distance = panels[n]
    for component, symbol, look in ((1, "$F_y$", "-"), (0, "$F_x$", "--")):
        values = _joined([seen.force[:, component] for seen in steps])
        force.plot(t, values, look, color=palette.FORCE, label=symbol)
    force.set_ylabel(latex_axis("ground force", unit_of("force", spec.units), spec.units))
    force.legend()
    distance.plot(t, _joined([seen.d for seen in steps]), color=palette.ZMP, label="paper's $d$")
    ahead = _joined([seen.cop - seen.contact for seen in steps])
    distance.plot(t, ahead, "--", color=palette.FORCE, label="centre of pressure")
    distance.set_ylabel(latex_axis("distance", spec.units.length, spec.units))
    distance.legend()
    for axes in panels.ravel():
        shown = axes.get_ylim()
        axes.axhline(0, color=style.GREY, linewidth=0.5, zorder=0)
        axes.set(xlim=(0, begin[-1]), ylim=shown)
    for axes in panels[-1]:
        axes.set_xlabel(time_label(spec))
    return figure


def _phase(steps: Sequence[Motion], title: str) -> "Figure":
    """One panel per coordinate."""
    from stridemap.views import style
    from stridemap.views.notation import state_labels

    spec = steps[0].model.spec
    labels = state_labels(spec)
    figure, panels = _grid(1, len(spec.coordinates), title)
    for axes, coordinate in zip(panels[0], spec.coordinates, strict=True):
        for seen, after in zip(steps, [*steps[1:], steps[0]], strict=True):
            q, v = seen.coordinate(coordinate.name), seen.coordinate(f"d{coordinate.name}")
            next_q, next_v = after.coordinate(coordinate.name), after.coordinate(f"d{coordinate.name}")
            axes.plot(q, v, color=style.BLUE)
            # The impact, and the exchange of legs.
            axes.plot([q[-1], next_q[0]], [v[-1], next_v[0]], ":", color=style.DARK)
            axes.plot(q[0], v[0], "o", color=style.BLUE, markersize=4)
        axes.set_xlabel("  ".join(labels[coordinate.name]))
        axes.set_ylabel("  ".join(labels[f"d{coordinate.name}"]))
    return figure


def _joined(pieces: Sequence[Array]) -> Array:
    """Pieces one after another, with a gap between them."""
    return np.concatenate([part for piece in pieces for part in (piece, [np.nan])][:-1])


KINDS: Mapping[str, Callable[[Sequence[Motion], str], "Figure"]] = {"profiles": _profiles, "phase": _phase}
"""Kinds of plots, and what draws each."""


def _grid(rows: int, columns: int, title: str) -> "tuple[Figure, np.ndarray[Any, np.dtype[Any]]]":
    """An empty figure with panels that share their axes of time."""
    from stridemap.views import style

    figure = style.new_figure(PANEL[0] * columns, PANEL[1] * rows + 0.3)
    panels: np.ndarray[Any, np.dtype[Any]] = figure.subplots(rows, columns, sharex=rows > 1, squeeze=False)
    figure.suptitle(title)
    return figure, panels


def _title(orbit: Orbit) -> str:
    """Model, group and stability."""
    group = f", group {orbit.group}" if orbit.group else ""
    steps = f", {orbit.period_n} steps" if orbit.steps else ""
    return f"{orbit.model.title}{group}{steps}, {orbit.stability}"
