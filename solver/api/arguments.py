"""What the arguments of public functions are, and which of them are refused."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError

MAX_PERIOD_N = 64
"""Most steps of a cycle: the unknowns of all steps are solved for together."""


def joined(params: Mapping[str, float] | None, keywords: Mapping[str, float]) -> dict[str, float]:
    """Parameters given as a mapping and as keywords.

    Raises
    ------
    InputError
        When `params` is not a mapping, or a parameter is given in both.
    """
    if params is not None and not isinstance(params, Mapping):
        raise InputError(f"params = {params!r} is not a mapping; write params={{'name': value}}")
    if twice := sorted(set(params or {}) & set(keywords)):
        raise InputError(f"{', '.join(twice)} is given twice, in params and as a keyword; leave one out")
    return {**(params or {}), **keywords}


def section_state(names: tuple[str, ...], state: Mapping[str, Any]) -> NDArray[np.float64]:
    """A section point from its entries by name, shape (nz,).

    Raises
    ------
    InputError
        When a name is missing or unknown, or a value is not a finite number.
    """
    if set(state) != set(names):
        missing, unknown = sorted(set(names) - set(state)), sorted(set(state) - set(names))
        parts = [f"missing: {', '.join(missing)}"] * bool(missing) + [
            f"unknown: {', '.join(unknown)}"
        ] * bool(unknown)
        raise InputError(f"a state needs {', '.join(names)}; {'; '.join(parts)}")
    for name in names:
        value = state[name]
        if (
            isinstance(value, bool)
            or not isinstance(value, int | float | np.number)
            or not np.isfinite(value)
        ):
            raise InputError(f"{name} = {value!r} of the state is not a finite number")
    return np.array([float(state[name]) for name in names])


def whole(name: str, value: Any, low: int, high: int) -> None:
    """Refuse what is not a whole number from `low` to `high`.

    Raises
    ------
    InputError
        For anything else.
    """
    number = isinstance(value, int | np.integer) and not isinstance(value, bool)
    if not number or not low <= value <= high:
        raise InputError(f"{name} = {value!r} is not allowed: a whole number from {low} to {high} is needed")


def limit_of_friction(value: Any) -> float | None:
    """A largest ratio of horizontal to vertical ground force, or None where there is none.

    Raises
    ------
    InputError
        When it is not a number above 0.
    """
    if value is None:
        return None
    number = isinstance(value, int | float | np.number) and not isinstance(value, bool)
    if not (number and np.isfinite(value) and value > 0):
        raise InputError(f"friction_limit = {value!r} is not allowed: a number above 0 is needed")
    return float(value)


def quiet(line: str) -> None:
    """Report nothing."""
