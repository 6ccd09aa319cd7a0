"""Walking with an event-driven integrator: the independent check on everything else.

Nothing here is shared with the step map but the equations of motion: adaptive steps instead of fixed
ones, an event that is searched for instead of a period that is an unknown, plain floating-point numbers
instead of compiled kernels. Every swing phase is integrated with SciPy's DOP853; its dense output brackets
the touchdown, and the state there comes from integrating up to it, not from interpolation.

The step map's Runge-Kutta method has the coefficients of the same family; the test against a Taylor
integrator (heyoka) covers what the two could have in common.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import DOP853, DenseOutput, OdeSolution, solve_ivp
from scipy.optimize import brentq

from stridemap.errors import InputError, short
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]

TIME_LIMIT = 20.0
"""Longest swing phase that is waited for, in sqrt(L/g)."""
MAX_STEPS = 10_000
"""Steps of the integrator in one swing phase: a hundred or two are usual, the stiffest torque that was tried
needs some thousands, and one that turns a billion times in a step would take days."""
SAMPLES = 8
"""Samples per step of the integrator, between which an event is looked for."""
FIRST_STEP = 1e-3
"""Of the integrator. SciPy's own guess is not a number for huge rates, and it then never returns."""
MOST_WALKED = 1_000_000
"""Steps of a walk: about 20 of them are computed per second."""
FORCE_SAMPLES = 257
"""Times in a step at which the ground force is sampled."""


class Outcome(StrEnum):
    """How a walk, or one swing phase of it, ended."""

    WALKED = "walked"
    """All steps were walked; the swing phase ended with a touchdown."""
    FELL = "fell"
    """The stance leg went beyond the horizontal."""
    NO_TOUCHDOWN = "no_touchdown"
    """The swing foot did not touch down within the time limit."""
    FAILED = "failed"
    """The integrator gave up: the motion leaves the range of numbers."""


@dataclass(frozen=True)
class Step:
    """One step of a walk.

    Parameters
    ----------
    state : mapping of str to float
        Section point just after the touchdown that ended the step.
    period : float
        Time since the touchdown before.
    step_length : float
        Distance from the stance foot to the foot that touched down.
    min_vertical_force : float
        Smallest vertical ground force at `FORCE_SAMPLES` times.
    """

    state: Mapping[str, float]
    period: float
    step_length: float
    min_vertical_force: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "state", MappingProxyType(dict(self.state)))

    def __reduce__(self) -> tuple[Any, ...]:
        """Read-only views do not pickle; plain dicts do."""
        return Step, (dict(self.state), self.period, self.step_length, self.min_vertical_force)

    @property
    def contact(self) -> bool:
        """Whether the ground pushed all the time; a walk goes on as if it could pull."""
        return self.min_vertical_force > 0


@dataclass(frozen=True)
class Walk:
    """Consecutive steps and how they ended.

    Parameters
    ----------
    model : str
    params : mapping of str to float
    steps : tuple of Step
        Those that were completed.
    outcome : Outcome
    """

    model: str
    params: Mapping[str, float]
    steps: tuple[Step, ...]
    outcome: Outcome

    def __post_init__(self) -> None:
        object.__setattr__(self, "params", MappingProxyType(dict(self.params)))

    def __reduce__(self) -> tuple[Any, ...]:
        """Read-only views do not pickle; plain dicts do."""
        return Walk, (self.model, dict(self.params), self.steps, self.outcome)


@dataclass(frozen=True)
class Swing:
    """A swing phase from just after one touchdown to just before the next.

    Parameters
    ----------
    outcome : Outcome
        `Outcome.WALKED` if it ended with a touchdown.
    duration : float
    end : ndarray, shape (2 n_q,)
        Coordinates and rates at its end, before the impact.
    dense : scipy.integrate.OdeSolution
        The motion in between.
    """

    outcome: Outcome
    duration: float
    end: Array
    dense: OdeSolution

    def __call__(self, t: Any) -> Array:
        """Coordinates and rates at times within the phase, shape (..., 2 n_q)."""
        return np.moveaxis(self.dense(t), 0, -1)


class _Walker:
    """The equations of one model at one parameter point, on plain floats."""

    def __init__(self, model: Model, params: Array) -> None:
        self.model = model
        self.p = [float(value) for value in params]
        self.n = len(model.coordinates)
        self.stance = model.stance_index
        self._state_derivative = self._bind("state_derivative")
        self._touchdown_condition = self._bind("touchdown_condition")
        self._impact_map = self._bind("impact_map")

    def _bind(self, name: str) -> Callable[[float, list[float]], dict[str, Any]]:
        """A generated function of time and state, with numbers for sines and cosines."""
        function, n, p = getattr(self.model.equations, name), self.n, self.p
        inputs = self.model.spec.functions[name].arguments
        indices = [("t", "q", "v", "p").index(key) for key in inputs]

        def call(t: float, y: list[float]) -> dict[str, Any]:
            values = (t, y[:n], y[n:], p)
            return function(math, *[values[i] for i in indices])

        return call

    def rate(self, t: float, y: Array) -> list[float]:
        """Time derivative of the state."""
        try:
            out = self._state_derivative(t, y.tolist())
        except (ValueError, OverflowError, ZeroDivisionError):
            # Beyond the range of numbers; the integrator then gives up by itself.
            return [math.nan] * (2 * self.n)
        return out["dq"] + out["dv"]

    def touchdown(self, y: Array) -> tuple[float, float, float]:
        """Touchdown condition, its rate, and what is negative where a touchdown counts."""
        out = self._touchdown_condition(0.0, y.tolist())
        return out["h"], out["dh"], out["side"]

    def start(self, z: Array) -> Array:
        """State of a section point."""
        out = self.model.evaluate("section_state", z=z, p=np.array(self.p))
        return np.concatenate([out["q"], out["v"]])

    def land(self, y: Array) -> Array:
        """Section point after the impact."""
        out = self._impact_map(0.0, y.tolist())
        values = dict(zip(self.model.coordinates, out["q_plus"], strict=True))
        rates = {f"d{c}": v for c, v in zip(self.model.coordinates, out["v_plus"], strict=True)}
        z = np.array([(values | rates)[name] for name in self.model.section])
        return self.model.wrapped(z)

    def advance(self, t: float, y: Array, to: float, rtol: float, atol: float) -> Array:
        """State at the time `to`, integrated from `t`."""
        return solve_ivp(self.rate, (t, to), y, "DOP853", rtol=rtol, atol=atol).y[:, -1]


def walk(
    model: Model, params: Array, state: Array, steps: int, rtol: float = 1e-12, atol: float = 1e-14
) -> Walk:
    """Walk a number of steps from a section point; a fall is an outcome, not an error.

    Parameters
    ----------
    model : Model
    params : ndarray, shape (n_params,)
    state : ndarray, shape (nz,)
        Section point, just after touchdown.
    steps : int
    rtol, atol : float
        Tolerances of the integrator.

    Raises
    ------
    InputError
        When the state is not `nz` finite numbers, or `steps` is below 1.
    """
    if not 1 <= steps <= MOST_WALKED:
        raise InputError(
            f"steps = {short(steps)} is not allowed: at least 1 step and at most {MOST_WALKED:,} can be "
            "walked (so many take hours)"
        )
    z = np.array(state, dtype=np.float64)
    walker = _Walker(model, params)
    walked: list[Step] = []
    outcome = Outcome.WALKED
    while outcome is Outcome.WALKED and len(walked) < steps:
        phase = swing(model, params, z, rtol, atol)
        outcome = phase.outcome
        if outcome is Outcome.WALKED:
            z = walker.land(phase.end)
            walked.append(_step(walker, phase, z))
    names = [parameter.name for parameter in model.parameters]
    return Walk(model.source, dict(zip(names, walker.p, strict=True)), tuple(walked), outcome)


def _step(walker: _Walker, phase: Swing, z: Array) -> Step:
    model, n = walker.model, walker.n
    t = np.linspace(0.0, phase.duration, FORCE_SAMPLES)
    y = phase(t)
    force = model.evaluate("ground_force", t=t, q=y[:, :n], v=y[:, n:], p=np.array(walker.p))["force"]
    landed = model.evaluate("section_state", z=z, p=np.array(walker.p))
    length = model.evaluate("step_length", q=landed["q"], p=np.array(walker.p))["length"]
    return Step(
        state=dict(zip(model.section, z.tolist(), strict=True)),
        period=phase.duration,
        step_length=float(length),
        min_vertical_force=float(force[:, 1].min()),
    )


def trajectory(
    model: Model, params: Array, state: Array, samples: int = 201, rtol: float = 1e-12, atol: float = 1e-14
) -> tuple[Array, Array]:
    """The motion during one swing phase, at evenly spaced times.

    Parameters
    ----------
    model : Model
    params : ndarray, shape (n_params,)
    state : ndarray, shape (nz,)
        Section point, just after touchdown.
    samples : int
    rtol, atol : float
        Tolerances of the integrator.

    Returns
    -------
    t : ndarray, shape (samples,)
        From 0 to the touchdown, or to where the motion ended without one.
    y : ndarray, shape (samples, 2 n_q)
        Coordinates and rates.
    """
    phase = swing(model, params, state, rtol, atol)
    t = np.linspace(0.0, phase.duration, samples)
    return t, phase(t)


def swing(
    model: Model,
    params: Array,
    state: Array,
    rtol: float = 1e-12,
    atol: float = 1e-14,
    time_limit: float = TIME_LIMIT,
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
    time_limit : float

    Raises
    ------
    InputError
        When the state is not `nz` finite numbers.
    """
    z = np.asarray(state, dtype=np.float64)
    if z.shape != (len(model.section),) or not np.isfinite(z).all():
        raise InputError(
            f"the state {z.tolist()} is not allowed: {model.name} takes "
            f"{len(model.section)} finite numbers ({', '.join(model.section)})"
        )
    walker = _Walker(model, params)
    solver = DOP853(
        walker.rate,
        0.0,
        walker.start(z),
        time_limit,
        rtol=rtol,
        atol=atol,
        first_step=min(FIRST_STEP, time_limit),
    )
    times, below = [0.0], False
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
        event, t, below = _first_event(walker, piece, below)
        end = solver.y
        if event is Outcome.WALKED:
            t, end = _touch_down(walker, piece, t, rtol, atol)
        times.append(max(t, math.nextafter(times[-1], math.inf)))
        if event is not None:
            outcome = event
            break
    if not pieces:
        pieces, times = [_Standstill(solver.y)], [0.0, 0.0]
    return Swing(outcome, times[-1], end, OdeSolution(times, pieces))


def _first_event(walker: _Walker, piece: DenseOutput, below: bool) -> tuple[Outcome | None, float, bool]:
    """Look for a touchdown or a fall in one step of the integrator.

    The condition is sampled `SAMPLES` times; where it turns towards zero and back between two samples,
    the turning point is sampled as well.

    Parameters
    ----------
    walker : _Walker
    piece : scipy.integrate.DenseOutput
    below : bool
        Whether the condition was negative at the end of the step before: deciding it once keeps a zero at
        the seam from being seen twice, or not at all.

    Returns
    -------
    event : Outcome or None
    t : float
        Its time.
    below : bool
        Whether the condition is negative at the end.
    """
    times = np.linspace(piece.t_old, piece.t, SAMPLES + 1)
    states = piece(times).T
    seen = [walker.touchdown(y) for y in states]
    for i in range(SAMPLES):
        left, right = times[i].item(), times[i + 1].item()
        (_, dh_left, _), (h_right, dh_right, _) = seen[i], seen[i + 1]
        below_then, below = below, h_right < 0
        rising = below_then and not below
        turns = (dh_left > 0 > dh_right) if below_then else (dh_left < 0 < dh_right)
        if below_then == below and turns:
            middle = brentq(lambda t: walker.touchdown(piece(t))[1], left, right)
            rising = (walker.touchdown(piece(middle))[0] < 0) != below
            left, right = (left, middle) if below else (middle, right)
        if rising:
            t = _rising_zero(walker, piece, left, right)
            if walker.touchdown(piece(t))[2] < 0:
                return Outcome.WALKED, t, below
        if walker.stance is not None and abs(states[i + 1, walker.stance]) > math.pi / 2:
            return Outcome.FELL, right, below
    return None, piece.t, below


def _rising_zero(walker: _Walker, piece: DenseOutput, left: float, right: float) -> float:
    """Zero of the touchdown condition between two times; on the left where rounding leaves no bracket."""

    def h(t: float) -> float:
        return walker.touchdown(piece(t))[0]

    return float(brentq(h, left, right, xtol=1e-15)) if h(left) < 0 <= h(right) else left


def _touch_down(
    walker: _Walker, piece: DenseOutput, t: float, rtol: float, atol: float
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


class _Standstill(DenseOutput):
    """A motion of no duration."""

    def __init__(self, y: Array) -> None:
        super().__init__(0.0, 0.0)
        self._y = y

    def _call_impl(self, t: Any) -> Array:
        return np.multiply.outer(self._y, np.ones_like(t))
