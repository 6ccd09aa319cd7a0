"""Events within a swing phase: touchdowns ahead and behind, falls and rest, on the integrator's own steps.

Each step of the integrator is looked at in a few samples of its dense output. Where the touchdown condition
changes its sign between two of them, or turns towards zero and back, its zeros are located; what a zero means
is decided by the state there.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import DenseOutput
from scipy.optimize import brentq

from stridemap.solver.walks.equations import Equations
from stridemap.solver.walks.outcomes import Outcome

Array = NDArray[np.float64]

SAMPLES = 8
"""Samples per step of the integrator, between which an event is looked for."""
REST = 1e-6
"""A walker is at rest where no rate is above this part of its own largest value in the swing phase, and none
will be if it goes on for as long as the phase has lasted."""


@dataclass
class Watch:
    """Watches one swing phase for the event that ends it.

    Parameters
    ----------
    walker : Equations
    begin : float
        Time of its first state.
    first : ndarray, shape (2 n,)
        Its first state.
    of_walk : bool
        Whether the walk begins with it.
    """

    walker: Equations
    begin: float
    first: Array
    of_walk: bool
    below: bool = field(init=False)
    """Whether the touchdown condition was negative at the end of the step before: deciding it once keeps a
    zero at the seam from being seen twice, or not at all."""
    _largest: Array | None = field(default=None, init=False)

    def __post_init__(self) -> None:
        walker, y = self.walker, self.first
        self.below = walker.touchdown(y)[0] < 0 and not walker.in_double_support(y)

    def event(self, piece: DenseOutput) -> tuple[Outcome | None, float]:
        """The first event in one step of the integrator, and its time; (None, the step's end) without one."""
        times = np.linspace(piece.t_old, piece.t, SAMPLES + 1)
        states = piece(times).T
        seen = [self.walker.touchdown(y) for y in states]
        for i in range(SAMPLES):
            retreats = seen[i + 1][2] > seen[i][2]
            for left, right in self._sign_changes(piece, times[i : i + 2].tolist(), seen[i : i + 2]):
                rising = self.below
                self.below = not self.below
                t = zero(self.walker, piece, left, right, rising)
                y = piece(t)
                side = self.walker.touchdown(y)[2]
                if rising and side < 0:
                    return Outcome.WALKED, t
                if side >= 0 and retreats and self._on_the_foot_behind(y):
                    return back(self.walker, self.first, self.of_walk), t
            if (fall := fallen(self.walker, states[i + 1])) is not None:
                return fall, float(times[i + 1])
        return (Outcome.STOPS if self._at_rest(piece) else None), piece.t

    def _sign_changes(
        self, piece: DenseOutput, times: list[float], seen: list[tuple[float, float, float]]
    ) -> Iterator[tuple[float, float]]:
        """Intervals between two samples in each of which the condition changes its sign once, in order."""
        (left, right), (_, dh_left, _), (h_right, dh_right, _) = times, *seen
        if self.below != (h_right < 0):
            yield left, right
            return
        turns = (dh_left > 0 > dh_right) if self.below else (dh_left < 0 < dh_right)
        if turns:
            middle = brentq(lambda t: self.walker.touchdown(piece(t))[1], left, right)
            if (self.walker.touchdown(piece(middle))[0] < 0) != self.below:
                yield left, middle
                yield middle, right

    def _on_the_foot_behind(self, y: Array) -> bool:
        """Whether a walker with both feet on the ground has come back onto the foot behind."""
        walker = self.walker
        if walker.centre_of_mass(y)[1][0] >= 0:
            return False
        (x, height), (_, speed) = walker.swing_foot(y)
        stance = walker.stance_foot(y)
        reach = math.hypot(x - stance[0], height - stance[1])
        if abs(height - stance[1]) > 1e-6 * reach and abs(height - walker.ground) > 1e-6 * reach:
            return True  # the foot that touches is another one: the spoke behind
        return x < stance[0] and speed < 0

    def _at_rest(self, piece: DenseOutput) -> bool:
        """Whether the rates have died out, and the accelerations with them; not where a clock acts."""
        if not self.walker.autonomous:
            return False
        n, y = self.walker.n, piece(piece.t)
        rates = np.abs(piece(np.array([piece.t_old, piece.t]))[n:]).max(axis=1)
        self._largest = rates if self._largest is None else np.maximum(self._largest, rates)
        soon = np.abs(self.walker.rate(piece.t, y)[n:]) * (piece.t - self.begin)
        return bool((np.maximum(np.abs(y[n:]), soon) <= REST * self._largest).all())


def at_start(walker: Equations, t: float, y: Array, first: bool) -> Outcome | None:
    """What ends a swing phase before it has begun: a walker that cannot leave the foot behind.

    Parameters
    ----------
    walker : Equations
    t : float
    y : ndarray, shape (2 n,)
        The phase's first state.
    first : bool
        Whether the walk begins with it.
    """
    if not np.isfinite(y).all() or walker.touchdown(y)[2] < 0 or not walker.in_double_support(y):
        return None
    moves = walker.centre_of_mass(y)[1][0]
    resting = not y[walker.n :].any()
    state = np.concatenate([y[: walker.n], walker.rate(t, y)[walker.n :]]) if resting else y
    if walker.alternates(y):
        pressed = walker.swing_foot(state)[1][1] < 0
    else:
        pressed = walker.centre_of_mass(state)[1][0] < 0
    if resting:
        stays = pressed or not state[walker.n :].any()
        return Outcome.STOPS if stays and walker.autonomous else None
    return back(walker, y, first) if pressed and moves < 0 else None


def back(walker: Equations, first: Array, of_walk: bool) -> Outcome:
    """What it is to come onto the foot behind: rocking back, or going back if the walk began with that."""
    if not of_walk or walker.centre_of_mass(first)[1][0] >= 0:
        return Outcome.ROCKS_BACK
    pull = float(walker.model.evaluate("total_mass", p=np.array(walker.p))["pull"])
    return Outcome.GOES_UPHILL if pull > 0 else Outcome.GOES_BACKWARD


def fallen(walker: Equations, y: Array) -> Outcome | None:
    """A fall: the stance leg beyond the horizontal, or, without an angle for it, the mass on the ground."""
    stance = walker.model.stance_index
    if stance is not None:
        down = abs(y[stance]) > math.pi / 2
    else:
        down = walker.centre_of_mass(y)[0][1] <= 0
    if not down:
        return None
    return Outcome.FALLS_FORWARD if walker.lean(y) >= 0 else Outcome.FALLS_BACKWARD


def zero(walker: Equations, piece: DenseOutput, left: float, right: float, rising: bool) -> float:
    """Zero of the touchdown condition between two times; on the left where rounding leaves no bracket."""
    sign = 1.0 if rising else -1.0

    def h(t: float) -> float:
        return sign * walker.touchdown(piece(t))[0]

    return float(brentq(h, left, right, xtol=1e-15)) if h(left) < 0 <= h(right) else left


def touch_down(
    walker: Equations, piece: DenseOutput, t: float, rtol: float, atol: float
) -> tuple[float, Array]:
    """Time and state of a touchdown near `t`: integrated up to it, then Newton's method on the time."""
    y = walker.advance(piece.t_old, piece(piece.t_old), t, rtol, atol)
    for _ in range(3):
        h, dh, _ = walker.touchdown(y)
        if dh <= 0 or abs(h) > 1e-6 * dh or abs(h) < 1e-17:
            break  # it only grazes the ground: there is nothing better than the interpolant's zero
        y = walker.advance(t, y, t - h / dh, rtol, atol)
        t -= h / dh
    return t, y
