"""Limit cycles as values."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from enum import StrEnum
from typing import Any, NoReturn


class Status(StrEnum):
    """How a search for a limit cycle ended."""

    CONVERGED = "converged"
    """A limit cycle, closed to 1e-11, with an integration error below 1e-9."""
    INACCURATE = "inaccurate"
    """A limit cycle whose integration error stays above 1e-9 at the finest resolution."""
    NOT_CONVERGED = "not_converged"
    """Newton's method did not close the cycle."""
    NOT_A_STEP = "not_a_step"
    """Closed, but not at a descending foot ahead of the hip, or the walker turns over on the way."""
    LATER_TOUCHDOWN = "later_touchdown"
    """Closed, but an earlier touchdown would have ended the step."""
    OUT_OF_RANGE = "out_of_range"
    """Closed, with a period outside the range that was asked for."""

    @property
    def found(self) -> bool:
        """Whether it is a limit cycle."""
        return self in (Status.CONVERGED, Status.INACCURATE)


class FrozenDict(dict[str, float]):
    """A dict that refuses to be changed; otherwise as any, for JSON, pickles and `dataclasses.asdict`."""

    def _refuse(self, *_args: Any, **_values: Any) -> NoReturn:
        """Raise TypeError."""
        raise TypeError("this dict cannot be changed; change a copy, dict(...)")

    __setitem__ = __delitem__ = __ior__ = _refuse
    clear = pop = popitem = setdefault = update = _refuse

    def __reduce__(self) -> tuple[Any, ...]:
        """Made anew in one piece."""
        return FrozenDict, (dict(self),)


@dataclass(frozen=True)
class Orbit:
    """A limit cycle, or the reason why there is none; numbers of a failure are NaN.

    Units: upper-body mass M, leg length L, time sqrt(L/g).

    Parameters
    ----------
    model : str
    params : mapping of str to float
        Every parameter of the model.
    status : Status
    state : mapping of str to float
        The section point, just after touchdown.
    period : float
    multipliers : tuple of complex
        Floquet multipliers by falling modulus.
    spectral_radius : float
        Largest modulus of a multiplier.
    stable : bool
        Whether it is below 1.
    group : str or None
        Solution group: A, B, C, ... by whole oscillations of the spring in one period.
    step_length, speed : float
    d_max : float
        Largest distance between stance foot and zero moment point; NaN where the contact is lost.
    work, work_positive, work_net : float
        Integral of the absolute, positive and signed power of the hip over a step.
    cot, cot_per_speed : float
        Work per weight and step length; the paper's variant, work per weight and mean speed.
    min_vertical_force : float
        Smallest vertical ground force; the contact is physical if it is positive.
    friction : float
        Largest ratio of horizontal to vertical ground force; NaN where the contact is lost.
    clearance : float
        Lowest height of the swing foot (negative: the scuff that compass models ignore).
    peaks : int
        Local maxima of the stance angle's rate within the step.
    x_zero_crossings : int or None
        Sign changes of the wobbling mass's position within the step.
    residual : float
        Largest entry of the closing error.
    integration_error : float
        Largest change of the closing error at twice the resolution.
    """

    model: str
    params: Mapping[str, float]
    status: Status
    state: Mapping[str, float] = field(default_factory=dict)
    period: float = math.nan
    multipliers: tuple[complex, ...] = ()
    spectral_radius: float = math.nan
    stable: bool = False
    group: str | None = None
    step_length: float = math.nan
    speed: float = math.nan
    d_max: float = math.nan
    work: float = math.nan
    work_positive: float = math.nan
    work_net: float = math.nan
    cot: float = math.nan
    cot_per_speed: float = math.nan
    min_vertical_force: float = math.nan
    friction: float = math.nan
    clearance: float = math.nan
    peaks: int = 0
    x_zero_crossings: int | None = None
    residual: float = math.nan
    integration_error: float = math.nan

    def __post_init__(self) -> None:
        object.__setattr__(self, "params", FrozenDict(self.params))
        object.__setattr__(self, "state", FrozenDict(self.state))

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON, without model and parameters; what is not a number is None."""
        out: dict[str, Any] = {}
        for f in fields(self):
            value = getattr(self, f.name)
            if f.name in ("model", "params"):
                continue
            if f.name == "state":
                value = dict(value)
            elif f.name == "multipliers":
                value = [[m.real, m.imag] for m in value]
            elif isinstance(value, Status):
                value = str(value)
            elif isinstance(value, float) and not math.isfinite(value):
                value = None
            out[f.name] = value
        return out


def group_letter(index: int) -> str:
    """Letter of a solution group: 0 is A, 25 is Z, 26 is AA.

    Parameters
    ----------
    index : int
        Number of whole spring oscillations in one period.
    """
    letters = ""
    index += 1
    while index > 0:
        index, rest = divmod(index - 1, 26)
        letters = chr(ord("A") + rest) + letters
    return letters
