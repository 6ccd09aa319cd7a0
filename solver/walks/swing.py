"""One swing phase, integrated with SciPy's DOP853 up to the event that ends it.

The dense output brackets a touchdown, and the state there comes from integrating up to it, not from
interpolation.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import DOP853, DenseOutput, OdeSolution

from stridemap.solver.model.model import Model
from stridemap.solver.model.scales import Scales
from stridemap.solver.walks.equations import Equations
from stridemap.solver.walks.events import Watch, at_start, touch_down
from stridemap.solver.walks.outcomes import Outcome
from stridemap.solver.walks.start import section_start

Array = NDArray[np.float64]

TIME_LIMIT = 25.0
"""Longest swing phase that is waited for, in terms of the model's scale of time."""
FIRST_STEP = 1e-3
"""Of the integrator, in terms of the scale of time. SciPy's own guess is not a number for huge rates, and it
then never returns."""
MAX_STEPS = 10_000
"""Steps of the integrator in one swing phase: a hundred or two are usual, the stiffest torque that was tried
needs some thousands, and one that turns a billion times in a step would take days."""
RTOL, ATOL = 1e-12, 1e-14
"""Tolerances of the integrator."""


@dataclass(frozen=True)
class Swing:
    """A swing phase from its first state to just before the event that ends it.

    Parameters
    ----------
    outcome : Outcome
        `Outcome.WALKED` if it ended with a touchdown.
    begin, duration : float
        Time since the last touchdown at its first state, and how long it lasted from there.
    end : ndarray, shape (2 n_q,)
        Coordinates and rates at its end, before the impact.
    dense : scipy.integrate.OdeSolution
        The motion in between.
    """

    outcome: Outcome
    begin: float
    duration: float
    end: Array
    dense: OdeSolution

    def __call__(self, t: Any) -> Array:
        """Coordinates and rates at times since the last touchdown, shape (..., 2 n_q)."""
        return np.moveaxis(self.dense(t), 0, -1)


def swing(
    model: Model,
    params: Array,
    state: Array,
    rtol: float = RTOL,
    atol: float = ATOL,
    time_limit: float | None = None,
) -> Swing:
    """One swing phase from a section point, up to its first touchdown.

    Parameters
    ----------
    model : Model
    params : ndarray, shape (n_params,)
    state : ndarray, shape (nz,)
        Section point, just after touchdown.
    rtol, atol : float
        Tolerances of the integrator.
    time_limit : float, optional
        Longest duration that is waited for; by default `TIME_LIMIT` scales of time.

    Raises
    ------
    InputError
        When the state is not `nz` finite numbers.
    """
    walker = Equations(model, params)
    return swing_from(walker, 0.0, section_start(walker, state), True, rtol, atol, time_limit)


def phases(
    walker: Equations, t: float, y: Array, steps: int, rtol: float = RTOL, atol: float = ATOL
) -> Iterator[tuple[Swing, Array | None]]:
    """Swing phases in a row, each with the section point after its touchdown, None where it has none.

    Parameters
    ----------
    walker : Equations
    t : float
        Time since the last touchdown of the first state.
    y : ndarray, shape (2 n_q,)
        The first state.
    steps : int
    rtol, atol : float
        Tolerances of the integrator.
    """
    for i in range(steps):
        phase = swing_from(walker, t, y, i == 0, rtol, atol)
        z = walker.land(phase.end) if phase.outcome is Outcome.WALKED else None
        yield phase, z
        if z is None:
            return
        t, y = 0.0, walker.start(z)


def swing_from(
    walker: Equations,
    t: float,
    y: Array,
    first: bool,
    rtol: float = RTOL,
    atol: float = ATOL,
    time_limit: float | None = None,
) -> Swing:
    """One swing phase from any state.

    Parameters
    ----------
    walker : Equations
    t : float
        Time since the last touchdown.
    y : ndarray, shape (2 n_q,)
    first : bool
        Whether a walk begins with it.
    rtol, atol : float
        Tolerances of the integrator.
    time_limit : float, optional
        Time since the last touchdown at which it is given up; by default `TIME_LIMIT` scales of time.
    """
    unit = Scales.of(walker.model).time
    time_limit = TIME_LIMIT * unit if time_limit is None else time_limit
    if (outcome := at_start(walker, t, y, first)) is not None:
        return Swing(outcome, t, 0.0, y, OdeSolution([t, t], [_Standstill(t, y)]))
    solver = DOP853(
        walker.rate,
        t,
        y,
        max(time_limit, t),
        rtol=rtol,
        atol=atol,
        first_step=min(FIRST_STEP * unit, time_limit),
    )
    times, watch = [t], Watch(walker, t, y, first)
    pieces: list[DenseOutput] = []
    outcome, end = Outcome.NO_TOUCHDOWN, solver.y
    while solver.status == "running":
        with np.errstate(over="ignore", invalid="ignore"):
            solver.step()
        if solver.status == "failed" or len(pieces) >= MAX_STEPS:
            outcome = Outcome.FAILED
            break
        piece = solver.dense_output()
        pieces.append(piece)
        event, at = watch.event(piece)
        end = solver.y
        if event is Outcome.WALKED:
            at, end = touch_down(walker, piece, at, rtol, atol)
        elif event is not None:
            end = piece(at)
        times.append(max(at, math.nextafter(times[-1], math.inf)))
        if event is not None:
            outcome = event
            break
    if not pieces:
        pieces, times = [_Standstill(t, solver.y)], [t, t]
    return Swing(outcome, t, times[-1] - t, end, OdeSolution(times, pieces))


class _Standstill(DenseOutput):
    """A motion of no duration."""

    def __init__(self, t: float, y: Array) -> None:
        super().__init__(t, t)
        self._y = y

    def _call_impl(self, t: Any) -> Array:
        return np.multiply.outer(self._y, np.ones_like(t))
