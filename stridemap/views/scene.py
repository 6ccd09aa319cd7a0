"""A limit cycle as a scene: where everything is that a frame of an animation shows."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.solver.cycles.orbit import Orbit
from stridemap.solver.observables.motion import Motion
from stridemap.spec import Line, Mass

Array = NDArray[np.float64]

VIEW = (-0.75, 0.75, -0.16, 1.34)
"""The smallest square that is shown: left, right, bottom and top of a panel, in heights of the walker."""
MARGIN, TITLE = 0.1, 0.34
"""Around what is shown, for the discs, and above it, for the title."""
LEVEL = 1e-9
"""A rise of the ground per step that is smaller is rounding."""


@dataclass(frozen=True)
class Scene:
    """One step of a limit cycle in n frames, and the moment of the next touchdown.

    Positions are measured from the stance foot in heights of the walker, so that walkers in any units fit
    the picture.

    Parameters
    ----------
    seen : Motion
        n + 1 samples.
    positions : ndarray, shape (n + 1, n_masses, 2)
    lines : dict of str to ndarray, shape (n + 1, n_points, 2)
    masses : ndarray, shape (n_masses,)
        As shares of the whole.
    force : ndarray, shape (n + 1, 2)
        Ground force in terms of the weight.
    contact, cop, zmp : ndarray, shape (n + 1,)
        Horizontal positions of the contact with the ground, of the centre of pressure, where the ground force
        acts, and of the paper's zero moment point, from which its distance d is measured.
    step : float
        From one contact point to the next.
    middle : ndarray, shape (n + 1,)
        Horizontal position that the view is centred on; it moves evenly, by one step length per step.
    radius : float
        Of round feet; 0 for point feet.
    rise : float
        By how much the next foothold is higher than this one: the walker climbs stairs.
    feet : (ndarray, ndarray), shape (n + 1, 2) each
        Stance foot and swing foot; the centres of their arcs where they are round.
    view : (float, float, float, float)
        Left, right, bottom and top of the picture, against the middle and the level of the ground there.
    """

    seen: Motion
    positions: Array
    lines: dict[str, Array]
    masses: Array
    force: Array
    contact: Array
    cop: Array
    zmp: Array
    step: float
    middle: Array
    radius: float
    rise: float
    feet: tuple[Array, Array]
    view: tuple[float, float, float, float]

    @property
    def bodies(self) -> tuple[Mass, ...]:
        """The masses with their roles, in the order of `positions`."""
        return self.seen.model.spec.masses

    @property
    def drawn_lines(self) -> tuple[Line, ...]:
        """The lines with their roles."""
        return self.seen.model.spec.lines


def scenes(orbit: Orbit, frames: int, magnify: float = 1.0) -> list[Scene]:
    """The scenes of all steps of a limit cycle, in one view: see `scene`."""
    each = [scene(orbit, frames, magnify, number) for number in range(orbit.period_n)]
    left, _, bottom, _ = min((one.view for one in each), key=lambda view: view[0])
    height = max(one.view[3] - one.view[2] for one in each)
    side = max(-2 * left, height)
    return [replace(one, view=(-side / 2, side / 2, bottom, bottom + side)) for one in each]


def scene(orbit: Orbit, frames: int, magnify: float = 1.0, number: int = 0) -> Scene:
    """The scene of one step of a limit cycle.

    Parameters
    ----------
    orbit : Orbit
    frames : int
        Frames per step.
    magnify : float
        Factor by which the displacement of the wobbling mass is drawn larger than it is.
    number : int
        Which step of a cycle of several.

    Raises
    ------
    InputError
        When the orbit was not found, or has no wobbling mass whose displacement could be magnified.
    """
    seen = orbit.motion(frames + 1)
    if orbit.steps:
        seen = seen.step(number)
    positions, lines = seen.positions, seen.lines
    if magnify != 1:
        positions, lines = _magnified(seen, orbit, magnify)
    model, p = seen.model, seen.model.point(orbit.params)
    height = max(float(points[..., 1].max()) for points in (positions, *lines.values()))
    load = model.evaluate("total_mass", p=p)
    stance = model.evaluate("stance_foot", q=seen.q, p=p)["stance"] / height
    swing = model.evaluate("swing_foot", q=seen.q, v=seen.v, p=p)["foot"] / height
    step = float(swing[-1, 0] - stance[0, 0]) if orbit.steps else orbit.step_length / height
    rise = float(swing[-1, 1] - stance[0, 1])
    if abs(rise) < LEVEL:
        rise = 0.0
    middle = step * (np.linspace(0, 1, frames + 1) - 0.5)
    scaled = {name: points / height for name, points in lines.items()}
    shown = np.concatenate(
        [points.reshape(frames + 1, -1, 2) for points in (positions / height, *scaled.values())], 1
    )
    return Scene(
        seen,
        positions / height,
        scaled,
        seen.masses / load["mass"],
        seen.force / load["weight"],
        seen.contact / height,
        seen.cop / height,
        (seen.contact - seen.d) / height,
        step,
        middle,
        float(stance[0, 1]),
        rise,
        (stance, swing),
        _view(shown, middle, rise / step * middle if step else 0 * middle),
    )


def _view(shown: Array, middle: Array, level: Array) -> tuple[float, float, float, float]:
    """A square around everything that is shown, which moves along with the walker; at least `VIEW`."""
    x, y = shown[..., 0] - middle[:, None], shown[..., 1] - level[:, None]
    left, right, bottom, _ = VIEW
    side = max(right - left, 2 * (float(np.abs(x).max()) + MARGIN), float(y.max()) + TITLE - bottom)
    return -side / 2, side / 2, bottom, bottom + side


def _magnified(seen: Motion, orbit: Orbit, magnify: float) -> tuple[Array, dict[str, Array]]:
    name = seen.model.spec.wobbling
    if name is None:
        raise InputError(
            f"magnify = {magnify:g} is not possible: {orbit.model.name} has no wobbling mass; leave it out"
        )
    q = seen.q.copy()
    q[..., seen.model.coordinates.index(name)] *= magnify
    drawn = seen.model.evaluate("drawing", q=q, p=seen.model.point(orbit.params))
    return drawn["positions"], {line: drawn[line] for line in seen.lines}
