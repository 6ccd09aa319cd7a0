"""Walking with an event-driven integrator: the independent check on everything else.

Nothing here is shared with the step map but the equations of motion: adaptive steps instead of fixed
ones, an event that is searched for instead of a period that is an unknown, plain floating-point numbers
instead of compiled kernels (see `stridemap.solver.walks.swing`).

The step map's Runge-Kutta method has the coefficients of the same family; the test against a Taylor
integrator (heyoka) covers what the two could have in common.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError, short
from stridemap.services import shown
from stridemap.solver.model.model import Model
from stridemap.solver.walks.equations import Equations
from stridemap.solver.walks.outcomes import Outcome
from stridemap.solver.walks.start import TIME, section_start, start_within
from stridemap.solver.walks.swing import ATOL, RTOL, Swing, phases, swing
from stridemap.solver.walks.trajectory import Trajectory, sampled

__all__ = ["Outcome", "Step", "Swing", "Walk", "swing", "walk"]

Array = NDArray[np.float64]

MOST_WALKED = 1_000_000
"""Steps of a walk: about 20 of them are computed per second."""
FORCE_SAMPLES = 257
"""Times in a step at which the ground force is sampled."""


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
    start : mapping of str to float
        The first state: every coordinate and rate by name, and ``t``, the time since the last touchdown.
    """

    model: str
    params: Mapping[str, float]
    steps: tuple[Step, ...]
    outcome: Outcome
    start: Mapping[str, float]
    _how: "_How" = field(compare=False, repr=False)

    def __post_init__(self) -> None:
        for name in ("params", "start"):
            object.__setattr__(self, name, MappingProxyType(dict(getattr(self, name))))

    def __reduce__(self) -> tuple[Any, ...]:
        """Read-only views do not pickle; plain dicts do."""
        plain = dict(self.params), self.steps, self.outcome, dict(self.start)
        return Walk, (self.model, *plain, self._how)

    def trajectory(self, dt: float) -> Trajectory:
        """The walk as an evenly sampled time series, with both sides of every impact.

        The walk is integrated once more, with the same tolerances and therefore the same result; samples come
        from the dense output of SciPy's DOP853.

        Parameters
        ----------
        dt : float
            Time between two samples, in the model's unit of time.

        Raises
        ------
        InputError
            When dt is not a number above 0, or there would be more than ten million rows.
        """
        walker = Equations(self._how.model, np.array(list(self.params.values())))
        state = [value for name, value in self.start.items() if name != TIME]
        steps = len(self.steps) + (self.outcome is not Outcome.WALKED)
        run = phases(walker, self.start[TIME], np.array(state), steps, self._how.rtol, self._how.atol)
        return sampled(walker, run, dt)


@dataclass(frozen=True)
class _How:
    """What it takes to walk the same walk again."""

    model: Model
    rtol: float
    atol: float


def walk(
    model: Model,
    params: Array,
    state: Array | None,
    steps: int,
    rtol: float = RTOL,
    atol: float = ATOL,
    start: Mapping[str, Any] | None = None,
) -> Walk:
    """Walk a number of steps; a fall is an outcome, not an error.

    Parameters
    ----------
    model : Model
    params : ndarray, shape (n_params,)
    state : ndarray, shape (nz,), or None
        Section point, just after touchdown.
    steps : int
    rtol, atol : float
        Tolerances of the integrator.
    start : mapping of str to float, optional
        In place of `state`, a state within a step: see `stridemap.solver.walks.start.start_within`.

    Raises
    ------
    InputError
        When the state or start is not usable, or `steps` is below 1.
    """
    if not 1 <= steps <= MOST_WALKED:
        raise InputError(
            f"steps = {short(steps)} is not allowed: at least 1 step and at most {MOST_WALKED:,} can be "
            "walked (so many take hours)"
        )
    walker = Equations(model, params)
    if start is not None:
        t, y = start_within(walker, start)
    else:
        t, y = 0.0, section_start(walker, np.asarray(state))
    walked: list[Step] = []
    outcome = Outcome.WALKED
    with shown("walking", "steps") as update:
        for phase, z in phases(walker, t, y, steps, rtol, atol):
            outcome = phase.outcome
            if z is not None:
                walked.append(_step(walker, phase, z))
                update(len(walked), steps)
    names = [e.name for e in (*model.spec.entries("q"), *model.spec.entries("v"))]
    begin = {TIME: t, **dict(zip(names, y.tolist(), strict=True))}
    point = dict(zip(model.spec.names, walker.p, strict=True))
    return Walk(model.source, point, tuple(walked), outcome, begin, _How(model, rtol, atol))


def _step(walker: Equations, phase: Swing, z: Array) -> Step:
    model, n = walker.model, walker.n
    t = phase.begin + np.linspace(0.0, phase.duration, FORCE_SAMPLES)
    y = phase(t)
    force = model.evaluate("ground_force", t=t, q=y[:, :n], v=y[:, n:], p=np.array(walker.p))["force"]
    landed = model.evaluate("section_state", z=z, p=np.array(walker.p))
    length = model.evaluate("step_length", q=landed["q"], p=np.array(walker.p))["length"]
    return Step(
        state=dict(zip(model.section, z.tolist(), strict=True)),
        period=phase.begin + phase.duration,
        step_length=float(length),
        min_vertical_force=float(force[:, 1].min()),
    )
