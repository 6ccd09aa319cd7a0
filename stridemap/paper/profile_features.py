"""Features of time profiles that the statements speak of, as columns of the table of cycles."""

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from stridemap.solver.model.model import Model
from stridemap.solver.observables.motion import Motion, motions

Array = NDArray[np.float64]

SAMPLES = 401
"""Evenly spaced over a step, both ends included. The middle is one of them and belongs to both halves."""

ANGLES = ("theta1", "theta2")


def sampled(model: Model, orbits: pd.DataFrame) -> Motion:
    """The cycles of a table as motions."""
    cycles = orbits[[*model.section, "period"]].to_numpy(dtype=np.float64)
    params = orbits[[parameter.name for parameter in model.parameters]].to_numpy(dtype=np.float64)
    return motions(model, cycles, params, SAMPLES)


def with_profiles(model: Model, orbits: pd.DataFrame) -> pd.DataFrame:
    """Cycles of the walker with a wobbling mass, with columns that describe `x` and `d` over a step.

    ``x_first``, ``x_second`` : mean of `x` over either half of the step. ``x_first_behind``,
    ``x_second_ahead`` : share of that half in which `x` is negative, and positive. ``x_travel`` : greatest
    minus least `x`. ``x_maxima`` : local maxima within the step. The same for `d`: ``d_first``,
    ``d_second``, ``d_first_positive``, ``d_second_negative``, ``d_travel``; ``d_start`` is `d` just after
    touchdown, ``d_sign_changes`` how often its sign changes and ``d_crossing`` when it first does, in
    periods.
    """
    if orbits.empty:
        return orbits.assign(**{name: np.empty(0) for name in COLUMNS})
    motion = sampled(model, orbits)
    return orbits.assign(**_of_x(motion.coordinate("x")), **_of_d(motion.d))


def compare_with(model: Model, orbits: pd.DataFrame, other: Model, cycle: pd.DataFrame) -> pd.DataFrame:
    """Cycles compared with one cycle of another model, at the same fractions of the step.

    The columns are about the angles of the legs and their rates. ``likeness`` is the least of the four
    correlations with the other model's cycle over the step, and so 1 for curves of one shape.
    ``angle_difference`` and ``rate_difference`` are the greatest difference as a share of the range that the
    angle, or the rate, covers in the other model's cycle. They are NaN where there is not exactly one such
    cycle.
    """
    columns = {name: np.full(len(orbits), np.nan) for name in COMPARED}
    if len(orbits) and len(cycle) == 1:
        one, reference = sampled(model, orbits), sampled(other, cycle)
        correlation, difference = [], []
        for name in (*ANGLES, *(f"d{angle}" for angle in ANGLES)):
            here, there = one.coordinate(name), reference.coordinate(name)[0]
            correlation.append([np.corrcoef(curve, there)[0, 1] for curve in here])
            difference.append(np.abs(here - there).max(axis=1) / np.ptp(there))
        angles = len(ANGLES)
        columns = {
            "likeness": np.min(correlation, axis=0),
            "angle_difference": np.max(difference[:angles], axis=0),
            "rate_difference": np.max(difference[angles:], axis=0),
        }
    return orbits.assign(**columns)


def _halves(values: Array) -> tuple[Array, Array]:
    middle = SAMPLES // 2
    return values[:, : middle + 1], values[:, middle:]


def _of_x(x: Array) -> dict[str, Array]:
    first, second = _halves(x)
    rise = np.diff(x, axis=1)
    return {
        "x_first": first.mean(axis=1),
        "x_second": second.mean(axis=1),
        "x_first_behind": (first < 0).mean(axis=1),
        "x_second_ahead": (second > 0).mean(axis=1),
        "x_travel": np.ptp(x, axis=1),
        "x_maxima": ((rise[:, :-1] > 0) & (rise[:, 1:] <= 0)).sum(axis=1),
    }


def _of_d(d: Array) -> dict[str, Array]:
    first, second = _halves(d)
    changes = np.signbit(d[:, 1:]) != np.signbit(d[:, :-1])
    return {
        "d_first": first.mean(axis=1),
        "d_second": second.mean(axis=1),
        "d_first_positive": (first > 0).mean(axis=1),
        "d_second_negative": (second < 0).mean(axis=1),
        "d_travel": np.ptp(d, axis=1),
        "d_start": d[:, 0],
        "d_sign_changes": changes.sum(axis=1),
        "d_crossing": np.where(changes.any(axis=1), (changes.argmax(axis=1) + 0.5) / (SAMPLES - 1), np.nan),
    }


COLUMNS = tuple([*_of_x(np.zeros((1, SAMPLES))), *_of_d(np.zeros((1, SAMPLES)))])
"""Names of the columns that `with_profiles` always adds."""

COMPARED = ("likeness", "angle_difference", "rate_difference")
"""Names of the columns that `compare_with` adds."""
