"""Options of what the solver does, as records that check themselves; the same words everywhere."""

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError, short

if TYPE_CHECKING:
    from stridemap.solver.model.model import Model

STARTS_MAX, MANY = 1_000_000, 10**15
STARTS_PER_SECOND = 5_000
"""The most starts that are allowed, how many may be quoted digit by digit, and the assumed speed of the
search, used only to say what too many starts would cost."""


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
            raise InputError(f"{name} = {short(getattr(self, name))} is not allowed: {what}")

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
        Number of quasi-random starts per point, to begin with.
    seed : int
        Seed of their scrambling.
    period_min, period_max : float or None
        Periods that count: ``period_min < T <= period_max``; what is None is taken from the model.
    max_starts : int or None
        As long as a limit cycle was reached from one start alone, as many starts again are made, up to so
        many; by default 8 times `starts`. Not in a sweep, where neighbours make up for what a cell misses.
    search_box : mapping of str to (float, float)
        Least and greatest value of the starts, by entry of the section; what is not given is taken from the
        model.
    widen : float
        Factor on the width of the model's search box, in all entries that `search_box` does not name.

    Raises
    ------
    InputError
        For values out of range.
    """

    starts: int = 512
    seed: int = 0
    period_min: float | None = None
    period_max: float | None = None
    max_starts: int | None = None
    search_box: Any = ()
    widen: float = 1.0

    def __post_init__(self) -> None:
        for name in ("starts", "seed"):
            value = getattr(self, name)
            whole = isinstance(value, int) and not isinstance(value, bool)
            self._check(name, whole, "a whole number is needed")
        if self.max_starts is not None:
            number = isinstance(self.max_starts, int) and not isinstance(self.max_starts, bool)
            needed = f"a whole number from starts = {short(self.starts)} to {STARTS_MAX:,} is needed"
            self._check("max_starts", number and self.starts <= self.max_starts <= STARTS_MAX, needed)
        self._check_number("widen", 0.0, np.inf)
        object.__setattr__(self, "search_box", _box(self.search_box))
        self._check("starts", self.starts >= 1, "at least 1 start is needed")
        if self.starts > STARTS_MAX:
            hours = min(self.starts, MANY) / STARTS_PER_SECOND / 3600
            quoted = f"{self.starts:,}" if self.starts <= MANY else short(self.starts)
            raise InputError(
                f"starts = {quoted} is not allowed: at most {STARTS_MAX:,} (so many would take "
                f"{'about' if self.starts <= MANY else 'more than'} {hours:.2g} hours per point); "
                "a few hundred find nearly every cycle"
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
    def most_starts(self) -> int:
        """Starts per point at most."""
        return min(8 * self.starts, STARTS_MAX) if self.max_starts is None else self.max_starts

    def box_for(self, model: "Model") -> NDArray[np.float64]:
        """Middle and half-width of the starts, shape (nz, 2), by entry of the section.

        Raises
        ------
        InputError
            Where `search_box` names what is not an entry of the model's section.
        """
        given = dict(self.search_box)
        for name in given:
            if name not in model.section:
                raise InputError(
                    f"search_box names {short(name)}, which is not an entry of the section of {model.name}: "
                    f"{', '.join(model.section)}"
                )
        rows = []
        for name in model.section:
            middle, half = model.spec.search_box[name]
            low, high = given.get(name, (0.0, 0.0))
            rows.append(
                (0.5 * (low + high), 0.5 * (high - low)) if name in given else (middle, half * self.widen)
            )
        return np.array(rows).reshape(len(rows), 2)

    def room_for(self, model: "Model") -> NDArray[np.float64]:
        """Least and greatest value of cycles that are followed, shape (nz, 2), by entry of the section.

        They lie `FARTHEST` half-widths from the middle of the model's own box, or of the box of these options
        where that reaches farther.

        Raises
        ------
        InputError
            As `box_for`.
        """
        reach = np.array([-FARTHEST, FARTHEST])
        boxes = np.array([SearchOptions().box_for(model), self.box_for(model)])
        ends = boxes[..., :1] + reach * boxes[..., 1:]
        return np.stack([ends[..., 0].min(axis=0), ends[..., 1].max(axis=0)], axis=1)

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


FARTHEST = 8.0
"""How many half-widths of the search box away from its middle a branch ends: gaits were seen at six."""


def _box(given: Any) -> tuple[tuple[str, tuple[float, float]], ...]:
    """A search box as pairs of a name and its ends, by name: a record of options is a value.

    Raises
    ------
    InputError
        When it is not a mapping of names to two finite numbers in order.
    """
    entries = dict(given) if isinstance(given, Mapping | tuple) else None
    if entries is None:
        raise InputError(
            f"search_box = {short(given)} is not allowed: a mapping of names to two numbers is needed"
        )
    out = []
    for name, ends in sorted(entries.items()):
        pair = list(ends) if isinstance(ends, list | tuple) else []
        numbers = all(isinstance(end, int | float) and not isinstance(end, bool) for end in pair)
        if len(pair) != 2 or not numbers or not (-np.inf < pair[0] < pair[1] < np.inf):
            raise InputError(
                f"search_box of {name} = {short(ends)} is not allowed: two finite numbers, the lower one "
                "first"
            )
        out.append((str(name), (float(pair[0]), float(pair[1]))))
    return tuple(out)


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
    """Step control of pseudo-arclength continuation: of branches, of boundaries, and of sweeps.

    Lengths are measured in a space where 1 is the length of the parameter's range (in a sweep that of a line
    of the grid), and the half-width of the model's search box; and for the period the model's range of
    periods (in a sweep its scale of time). Sweeps only need guesses from branches, and have longer steps by
    default: `IN_SWEEPS`.

    Parameters
    ----------
    ds, ds_min, ds_max : float
        First, shortest and longest arclength step.
    step_growth, step_shrink : float
        Factors of the arclength step after one along which the tangent hardly turned, and after one that
        failed.
    max_steps : int
        Arclength steps along a branch each way, failed ones included.
    max_corrections : int
        Newton corrections of one point.
    min_tangent_cosine, easy_tangent_cosine : float
        Smallest cosine of the angle by which the tangent turns in one arclength step, and that above which
        the next one is longer.

    Raises
    ------
    InputError
        For values out of range.
    """

    ds: float = 0.01
    ds_min: float = 1e-7
    ds_max: float = 0.05
    step_growth: float = 1.3
    step_shrink: float = 0.5
    max_steps: int = 2000
    max_corrections: int = 5
    min_tangent_cosine: float = 0.9925
    easy_tangent_cosine: float = 0.999

    def __post_init__(self) -> None:
        for name in ("max_steps", "max_corrections"):
            value = getattr(self, name)
            whole = isinstance(value, int) and not isinstance(value, bool)
            self._check(name, whole and 1 <= value <= 10**6, "a whole number from 1 to 1,000,000 is needed")
        for name in ("ds", "ds_min", "ds_max"):
            self._check_number(name, 0.0, np.inf)
        self._check("ds_min", self.ds_min <= self.ds, f"it must not be above ds = {self.ds:g}")
        self._check("ds", self.ds <= self.ds_max, f"it must not be above ds_max = {self.ds_max:g}")
        self._check_number("step_growth", float(np.nextafter(1, 0)), np.inf)
        for name in ("step_shrink", "min_tangent_cosine", "easy_tangent_cosine"):
            self._check_number(name, 0.0, 1.0)


IN_SWEEPS = ContinuationOptions(
    ds=0.02,
    ds_min=1e-5,
    ds_max=0.1,
    step_growth=2.0,
    step_shrink=0.4,
    max_steps=600,
    max_corrections=4,
    min_tangent_cosine=0.94,
    easy_tangent_cosine=0.98,
)
"""How a sweep follows branches by default."""

IN_SWEEPS_OF_CYCLES = replace(IN_SWEEPS, ds=0.05, ds_max=0.4)
"""The same where special points are not located: nothing need be seen between two points of a branch."""
