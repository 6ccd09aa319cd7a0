"""The time series of a walk: evenly spaced samples, and both sides of every impact."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.solver.model.model import Model
from stridemap.solver.walks.equations import Equations
from stridemap.solver.walks.outcomes import Outcome
from stridemap.solver.walks.swing import Swing
from stridemap.words import TRAJECTORY_COLUMNS

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Words = NDArray[np.str_]

SAMPLE, BEFORE, AFTER, END = "sample", "before_impact", "after_impact", "end"
"""What a row is: one of the evenly spaced samples, a side of an impact, or where the walk broke off."""

LEGS = ("left", "right")
"""The stance leg of odd steps and of even ones."""

MAX_ROWS = 10_000_000
"""Rows of a series: about a gigabyte."""


@dataclass(frozen=True, eq=False)
class Trajectory:
    """A walk as a time series; n rows in order of time.

    The rows whose `event` is ``"sample"`` are evenly spaced: ``time = 0, dt, 2 dt, ...`` up to the end of the
    walk. Every impact adds two rows of one time, ``"before_impact"`` and ``"after_impact"``: before it
    coordinates and rates are those of the step that ends, and after it those of the step that begins, whose
    legs have swapped names. A sample at the very time of an impact is the state after it. A walk that breaks
    off without a touchdown ends with a row ``"end"``.

    Positions are in the world's frame, along the ground and away from it: its origin is that of the first
    step's frame, where a stance foot without radius stands.

    Parameters
    ----------
    model : Model
    dt : float
        Spacing of the samples, in the model's unit of time.
    time : ndarray, shape (n,)
        Since the start of the walk.
    step : ndarray of int, shape (n,)
        Number of the step, from 1.
    step_time : ndarray, shape (n,)
        Since the touchdown that began the step.
    stance_leg : ndarray of str, shape (n,)
        ``"left"`` in the first step and every second one after it, else ``"right"``.
    event : ndarray of str, shape (n,)
        ``"sample"``, ``"before_impact"``, ``"after_impact"`` or ``"end"``.
    q, v : ndarray, shape (n, n_q)
        Coordinates and rates, in the order of `Model.coordinates`.
    stance_foot, swing_foot : ndarray, shape (n, 2)
        The feet in the world's frame; for round feet, the centres of their arcs.
    """

    model: Model
    dt: float
    time: Array
    step: Index
    step_time: Array
    stance_leg: Words
    event: Words
    q: Array
    v: Array
    stance_foot: Array
    swing_foot: Array

    def __len__(self) -> int:
        return len(self.time)

    def __repr__(self) -> str:
        """Rows and duration."""
        return f"<trajectory of {self.model.name}: {len(self)} rows, from 0 to {self.time[-1]:.6g}>"

    def take(self, rows: Any) -> "Trajectory":
        """Some of the rows, by a mask, a slice or numbers."""
        arrays = {name: getattr(self, name)[rows] for name in _ARRAYS}
        return Trajectory(self.model, self.dt, **arrays)

    @property
    def samples(self) -> "Trajectory":
        """The evenly spaced rows alone."""
        return self.take(self.event == SAMPLE)

    def coordinate(self, name: str) -> Array:
        """A coordinate, or with a leading ``d`` its rate, by name, shape (n,).

        Raises
        ------
        InputError
            When the model has no such coordinate.
        """
        names = self.model.coordinates
        if name in names:
            return self.q[:, names.index(name)]
        if name[:1] == "d" and name[1:] in names:
            return self.v[:, names.index(name[1:])]
        raise InputError(
            f"{self.model.name} has no coordinate {name!r}; its coordinates are {', '.join(names)}"
        )

    def columns(self) -> dict[str, NDArray[Any]]:
        """One array per column, in the order of the tables that are written."""
        columns: dict[str, NDArray[Any]] = {
            "time": self.time,
            "step": self.step,
            "step_time": self.step_time,
            "stance_leg": self.stance_leg.astype(object),
            "event": self.event.astype(object),
        }
        names = self.model.coordinates
        columns |= dict(zip(names, self.q.T, strict=True))
        columns |= dict(zip((f"d{name}" for name in names), self.v.T, strict=True))
        for foot, where in (("stance_foot", self.stance_foot), ("swing_foot", self.swing_foot)):
            columns |= {f"{foot}_x": where[:, 0], f"{foot}_y": where[:, 1]}
        return columns

    def to_frame(self) -> Any:
        """The rows as a `pandas.DataFrame`, with the columns of the tables that are written."""
        import pandas as pd

        return pd.DataFrame(self.columns())


_ARRAYS = (
    "time", "step", "step_time", "stance_leg", "event", "q", "v", "stance_foot", "swing_foot",
)  # fmt: skip


def sampled(walker: Equations, phases: Iterable[tuple[Swing, Array | None]], dt: float) -> Trajectory:
    """The time series of swing phases in a row.

    Parameters
    ----------
    walker : Equations
    phases : iterable of (Swing, ndarray or None)
        Each phase with the section point after its touchdown; None ends the walk.
    dt : float
        Spacing of the samples.

    Raises
    ------
    InputError
        When dt is not a number above 0, when there would be more than `MAX_ROWS` rows, or when a coordinate
        has the name of a column.
    """
    _check_names(walker.model)
    step = _number(dt)
    rows: list[_Rows] = []
    clock, offset, next_, number = 0.0, np.zeros(2), 0, 0
    landed: Array | None = None
    for number, (phase, landed) in enumerate(phases, 1):
        ends = clock + phase.duration
        last = _last_before(ends, step, landed is not None)
        if last - next_ > MAX_ROWS or sum(len(row.time) for row in rows) > MAX_ROWS:
            raise InputError(
                f"dt = {step:g} is not allowed: it gives more than {MAX_ROWS:,} rows; take a larger one"
            )
        k = np.arange(next_, last + 1, dtype=np.float64)
        next_ = last + 1
        local = np.clip(phase.begin + (k * step - clock), phase.begin, phase.begin + phase.duration)
        if len(k):
            rows.append(_Rows.of(walker, number, k * step, local, phase(local), SAMPLE, offset))
        if landed is None:
            if phase.outcome is not Outcome.WALKED:
                rows.append(_end_row(walker, number, ends, phase, END, offset))
            break
        rows.append(_end_row(walker, number, ends, phase, BEFORE, offset))
        after = walker.start(landed)
        offset = offset + np.subtract(walker.swing_foot(phase.end)[0], walker.stance_foot(after))
        one = np.array([ends])
        rows.append(_Rows.of(walker, number + 1, one, 0 * one, after[None, :], AFTER, offset))
        clock = ends
    if landed is not None and next_ * step <= clock:  # a sample at the very end of the walk
        one = np.array([next_ * step])
        rows.append(_Rows.of(walker, number + 1, one, 0 * one, walker.start(landed)[None, :], SAMPLE, offset))
    joined = {name: np.concatenate([getattr(row, name) for row in rows]) for name in _ARRAYS}
    return Trajectory(walker.model, step, **joined)


@dataclass(frozen=True)
class _Rows:
    """Rows of one kind within one step."""

    time: Array
    step: Index
    step_time: Array
    stance_leg: Words
    event: Words
    q: Array
    v: Array
    stance_foot: Array
    swing_foot: Array

    @classmethod
    def of(
        cls, walker: Equations, step: int, time: Array, local: Array, y: Array, event: str, offset: Array
    ) -> "_Rows":
        n, m, model = walker.n, len(time), walker.model
        q, v, p = y[:, :n], y[:, n:], np.array(walker.p)
        return cls(
            time,
            np.full(m, step),
            local,
            np.full(m, LEGS[(step - 1) % 2]),
            np.full(m, event, dtype="<U13"),
            q,
            v,
            offset + model.evaluate("stance_foot", q=q, p=p)["stance"],
            offset + model.evaluate("swing_foot", q=q, v=v, p=p)["foot"],
        )


def _end_row(walker: Equations, step: int, time: float, phase: Swing, event: str, offset: Array) -> _Rows:
    local = np.array([phase.begin + phase.duration])
    return _Rows.of(walker, step, np.array([time]), local, phase.end[None, :], event, offset)


def _last_before(end: float, dt: float, exclusive: bool) -> int:
    """Number of the last sample up to an end, or before it."""
    last = int(end / dt)
    while (last + 1) * dt <= end:
        last += 1
    while last * dt > end or (exclusive and last * dt == end):
        last -= 1
    return last


def _number(dt: Any) -> float:
    good = isinstance(dt, int | float | np.number) and not isinstance(dt, bool)
    if not good or not np.isfinite(dt) or not dt > 0:
        raise InputError(f"dt = {dt!r} is not allowed: a number above 0 is needed")
    return float(dt)


def _check_names(model: Model) -> None:
    taken = sorted({e.name for a in ("q", "v") for e in model.spec.entries(a)} & set(TRAJECTORY_COLUMNS))
    if taken:
        raise InputError(
            f"the coordinate {taken[0]} of {model.name} has the name of a column of time series; rename it"
        )
