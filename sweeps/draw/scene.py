"""A limit cycle as a scene: where everything is that a frame of an animation shows."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.solver.motion import Motion, motion
from stridemap.solver.orbit import Orbit

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Scene:
    """One step of a limit cycle in n frames, the next touchdown not among them.

    Positions are from the stance foot, in leg lengths.

    Parameters
    ----------
    seen : Motion
        n + 1 samples.
    positions : ndarray, shape (n + 1, n_masses, 2)
    lines : dict of str to ndarray, shape (n + 1, n_points, 2)
    step : ndarray, shape (2,)
        From one contact point to the next.
    middle : ndarray, shape (n + 1,)
        Horizontal place that the view is centred on; it moves evenly, and by a step in a step.
    """

    seen: Motion
    positions: Array
    lines: dict[str, Array]
    step: Array
    middle: Array

    @property
    def names(self) -> list[str]:
        """The masses, in the order of `positions`."""
        return list(self.seen.model.manifest["masses"])

    @property
    def springs(self) -> set[str]:
        """Those of the lines that are springs."""
        return {line["name"] for line in self.seen.model.manifest["lines"] if line["spring"]}


def scene(orbit: Orbit, frames: int, magnify: float = 1.0) -> Scene:
    """The scene of a limit cycle.

    Parameters
    ----------
    orbit : Orbit
    frames : int
        Frames a step.
    magnify : float
        The wobbling mass's way is drawn so many times as long as it is.

    Raises
    ------
    InputError
        When the orbit is none, or has no wobbling mass whose way could be magnified.
    """
    seen = motion(orbit, frames + 1)
    positions, lines = seen.positions, seen.lines
    if magnify != 1:
        positions, lines = _magnified(seen, orbit, magnify)
    p = seen.model.point(orbit.params)
    last = {"t": seen.t[-1], "q": seen.q[-1], "v": seen.v[-1], "p": p}
    step = seen.model.evaluate("swing_foot", **last)["position"]
    share = np.linspace(0, 1, frames + 1)
    return Scene(seen, positions, lines, step, step[0] * (share - 0.5))


def _magnified(seen: Motion, orbit: Orbit, magnify: float) -> tuple[Array, dict[str, Array]]:
    name = seen.model.manifest["wobbling"]
    if name is None:
        raise InputError(
            f"magnify = {magnify:g} is not possible: {orbit.model} has no wobbling mass; leave it out"
        )
    q = seen.q.copy()
    q[..., seen.model.coordinates.index(name)] *= magnify
    drawn = seen.model.evaluate("drawing", q=q, p=seen.model.point(orbit.params))
    return drawn["positions"], {line: drawn[line] for line in seen.lines}
