"""Options of what the solver does, as records that check themselves; the same words everywhere."""

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from stridemap.errors import InputError

if TYPE_CHECKING:
    from stridemap.solver.model.model import Model

STARTS_MAX = 1_000_000
STARTS_PER_SECOND = 5_000
"""Assumed speed of the search, used only to say what too many starts would cost."""


class Options:
    """What all records of options can do."""

    @classmethod
    def from_mapping(cls, values: Any) -> Self:
        """A record from words and values.

        Raises
        ------
        InputError
            For an unknown word, or a value that is not allowed.
        """
        if isinstance(values, cls):
            return values
        if not isinstance(values, Mapping):
            raise InputError(f"options must be a {cls.__name__} or a mapping of words, not {values!r}")
        known = [one.name for one in fields(cls)]  # type: ignore[arg-type]
        for name in values:
            if name not in known:
                raise InputError(f"unknown option {name!r}; the options are {', '.join(known)}")
        return cls(**values)

    def _check(self, name: str, allowed: bool, what: str) -> None:
        """Refuse a value of an option."""
        if not allowed:
            raise InputError(f"{name} = {getattr(self, name)!r} is not allowed: {what}")

    def _check_number(self, name: str, low: float, high: float) -> None:
        """Refuse what is not a number between two ends, themselves excluded."""
        value = getattr(self, name)
        needed = (
            f"a number between {low:g} and {high:g} is needed"
            if high < np.inf
            else (f"a finite number above {low:g} is needed")
        )
        self._check(name, isinstance(value, int | float) and not isinstance(value, bool), needed)
        try:
            number = float(value)
        except OverflowError:
            number = np.inf
        self._check(name, low < number < high, needed)
        object.__setattr__(self, name, number)  # 2 and 2.0 are one value, and have one hash


@dataclass(frozen=True)
class SearchOptions(Options):
    """Options of the search for all limit cycles at a point.

    Parameters
    ----------
    starts : int
        Number of quasi-random starts per point.
    seed : int
        Seed of their scrambling.
    period_min, period_max : float or None
        Periods that count: ``period_min < T <= period_max``; what is None is taken from the model.

    Raises
    ------
    InputError
        For values out of range.
    """

    starts: int = 512
    seed: int = 0
    period_min: float | None = None
    period_max: float | None = None

    def __post_init__(self) -> None:
        whole = all(isinstance(n, int) and not isinstance(n, bool) for n in (self.starts, self.seed))
        if not whole:
            raise InputError(f"starts = {self.starts!r} and seed = {self.seed!r} must be whole numbers")
        self._check("starts", self.starts >= 1, "at least 1 start is needed")
        if self.starts > STARTS_MAX:
            hours = self.starts / STARTS_PER_SECOND / 3600
            raise InputError(
                f"starts = {self.starts:,} is not allowed: at most {STARTS_MAX:,} (so many would take about "
                f"{hours:.2g} hours per point); a few hundred find nearly every cycle"
            )
        self._check("seed", 0 <= self.seed < 2**32, "a whole number from 0 to 4,294,967,295 is needed")
        for name in ("period_min", "period_max"):
            if getattr(self, name) is not None:
                self._check_number(name, 0.0, np.inf)
        low, high = self.period_range
        if low >= high:
            raise InputError(
                f"the period range {low:g} to {high:g} is not allowed: 0 < period_min < period_max"
            )

    def resolved_for(self, model: "Model") -> "SearchOptions":
        """These options, with the model's period range where none is given."""
        low, high = model.period_range
        return replace(
            self,
            period_min=low if self.period_min is None else self.period_min,
            period_max=high if self.period_max is None else self.period_max,
        )

    @property
    def period_range(self) -> tuple[float, float]:
        """(period_min, period_max); an end that is not given is the least or the greatest possible."""
        low = np.nextafter(0, 1) if self.period_min is None else self.period_min
        return float(low), np.inf if self.period_max is None else self.period_max

    @property
    def wider_period_range(self) -> tuple[float, float]:
        """A range in which a sweep follows branches that leave the range and come back."""
        low, high = self.period_range
        return 0.85 * low, 1.15 * high


@dataclass(frozen=True)
class AcceptanceOptions(Options):
    """What a solution of Newton's method must satisfy to be accepted as a limit cycle.

    Errors are in terms of the model's own length and time (see `stridemap.solver.model.scales`).

    Parameters
    ----------
    max_residual : float
        Largest closing error.
    max_integration_error : float
        A cycle whose integration error stays above it at the finest resolution is marked `inaccurate`.
    target_integration_error : float
        Cycles are refined until the integration error is below it.
    max_state_error : float
        Cycles are refined until the error of section point and period is below it as well; near a fold that
        error is much larger than the integration error. A cycle for which it cannot be reached is marked
        `inaccurate`.
    standing_angle : float
        Stance angle at touchdown below which the solution is a walker standing still, which closes with any
        period.

    Raises
    ------
    InputError
        For values out of range.
    """

    max_residual: float = 1e-11
    max_integration_error: float = 1e-9
    target_integration_error: float = 1e-11
    max_state_error: float = 1e-10
    standing_angle: float = 1e-6

    def __post_init__(self) -> None:
        for one in fields(self):
            self._check_number(one.name, 0.0, 1.0)
        self._check(
            "target_integration_error",
            self.target_integration_error <= self.max_integration_error,
            f"it must not be above max_integration_error = {self.max_integration_error:g}",
        )


@dataclass(frozen=True)
class ContinuationOptions(Options):
    """Step control of pseudo-arclength continuation.

    Lengths are measured in a space where 1 is the distance between the two parameter points, or the
    half-width of the search box.

    Parameters
    ----------
    ds_min, ds_max : float
        Shortest and longest arclength step.
    step_growth, step_shrink : float
        Factors of the arclength step after one that was easily corrected, and after one that failed.
    max_steps : int
        Arclength steps along a branch, failed ones included.
    max_corrections : int
        Corrections with one derivative.
    tolerance : float
        Length of a correction that is the last: what comes out is a guess, to be converged.
    max_contraction : float
        Largest ratio of one correction to the one before.
    max_correction_ratio : float
        Largest ratio of the first correction to the arclength step.
    min_tangent_cosine : float
        Smallest cosine of the angle by which the tangent turns in one arclength step.

    Raises
    ------
    InputError
        For values out of range.
    """

    ds_min: float = 1e-3
    ds_max: float = 1.5
    step_growth: float = 2.0
    step_shrink: float = 0.35
    max_steps: int = 24
    max_corrections: int = 4
    tolerance: float = 1e-4
    max_contraction: float = 0.5
    max_correction_ratio: float = 0.5
    min_tangent_cosine: float = 0.7

    def __post_init__(self) -> None:
        for name in ("max_steps", "max_corrections"):
            value = getattr(self, name)
            whole = isinstance(value, int) and not isinstance(value, bool)
            self._check(name, whole and 1 <= value <= 10**6, "a whole number from 1 to 1,000,000 is needed")
        for name in ("ds_min", "ds_max", "tolerance"):
            self._check_number(name, 0.0, np.inf)
        self._check("ds_min", self.ds_min <= self.ds_max, f"it must not be above ds_max = {self.ds_max:g}")
        self._check_number("step_growth", float(np.nextafter(1, 0)), np.inf)  # 1 itself is allowed
        for name in ("step_shrink", "max_contraction", "max_correction_ratio", "min_tangent_cosine"):
            self._check_number(name, 0.0, 1.0)
