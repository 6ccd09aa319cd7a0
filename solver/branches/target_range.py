"""What may be looked for, in which range of a parameter, and at which values it is searched."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]

VALUES = 33
"""Values of the parameter, spread evenly over its range, at which all cycles are searched."""
OCTAVES = 6
"""Beside these the value that the point has, halved and doubled up to so many times."""
NUMERICAL = ("residual", "integration_error", "state_error", "multiplier_error")
"""Quantities that say something of the computation and nothing of the gait."""
DECADE = 10.0
"""Without an end, a range leads up to so many times the value that the point has."""


def wanted(model: Model, target: str | Mapping[str, Any]) -> tuple[str, float]:
    """Quantity and value of a target such as ``"speed = 0.45"`` or ``{"speed": 0.45}``.

    Raises
    ------
    InputError
        When it is not of this form, the model lacks the quantity, or the value is not a finite number.
    """
    if isinstance(target, str):
        name, equals, text = (part.strip() for part in target.partition("="))
        if not (name and equals and text):
            raise InputError(f"the target {target!r} is not understood; write it as 'speed = 0.45'")
        value: Any = text
    elif isinstance(target, Mapping) and len(target) == 1:
        ((name, value),) = target.items()
    else:
        raise InputError(f"the target {target!r} is not understood; write it as 'speed = 0.45'")
    number = _number(value)
    if number is None:
        raise InputError(f"{name} = {value!r} of the target is not a finite number")
    _check_quantity(model, str(name))
    return str(name), number


def _number(value: Any) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float | str | np.number):
        return None
    try:
        number = float(value)
    except (ValueError, OverflowError):
        return None
    return number if math.isfinite(number) else None


def _check_quantity(model: Model, name: str) -> None:
    """Refuse what has no value that changes continuously."""
    lacking = "spring_mode" not in model.spec.functions, model.spec.wobbling is None
    absent = {"group": lacking[0], "x_zero_crossings": lacking[1], "wobble_amplitude": lacking[1]}
    measured = {n: q for n, q in model.measured.items() if q.type == "float" and not absent.get(n, False)}
    numbers = ["period", *(n for n in measured if n not in NUMERICAL), *model.section]
    if name in numbers:
        return
    known = ", ".join(numbers)
    if name in model.measured and not absent.get(name, False):
        raise InputError(
            f"{name} cannot be a target: it does not vary continuously; targets of {model.name} are {known}"
        )
    raise InputError(f"{model.name} has no quantity {name!r}; targets are {known}")


def span(model: Model, parameter: str, point: Array, given: Any) -> tuple[float, float]:
    """The range of a parameter.

    Parameters
    ----------
    model : Model
    parameter : str
    point : ndarray, shape (n_params,)
        Values of all parameters.
    given : (float, float) or None
        If it is None, the parameter's own range; an end that this lacks is a tenth of the point's value, or
        ten times that.

    Raises
    ------
    InputError
        When the parameter is unknown or counts something, the range is not two numbers in ascending order
        within the parameter's own, or none can be guessed.
    """
    if parameter not in model.spec.names:
        model.point({parameter: 0.0})  # says which parameters there are
    current = float(point[model.spec.names.index(parameter)])
    (one,) = (p for p in model.parameters if p.name == parameter)
    if one.counts:
        raise InputError(
            f"{parameter} ({one.meaning}) cannot vary: it counts something and means nothing between whole "
            f"numbers; vary another parameter, or sweep {parameter} over whole numbers"
        )
    if given is not None:
        low, high = _ends(parameter, given)
        return one.check(low), one.check(high)
    low = one.lower if one.lower is not None else (current / DECADE if current > 0 else current * DECADE)
    high = one.upper if one.upper is not None else (current * DECADE if current > 0 else current / DECADE)
    edge = 1e-6 * (high - low)
    low, high = low + edge * one.lower_open, high - edge * one.upper_open
    if not low < high:
        raise InputError(
            f"{parameter} = {current:g} does not say in which range to look; give one (its values are "
            f"{one.allowed})"
        )
    return low, high


def _ends(parameter: str, given: Any) -> tuple[float, float]:
    """Two numbers in ascending order."""
    pair = isinstance(given, tuple | list) and len(given) == 2
    low, high = (_number(end) for end in given) if pair else (None, None)
    if low is None or high is None or not low < high:
        said = " ".join(map(str, given)) if pair else repr(given)
        raise InputError(
            f"the range {said} of {parameter} is not allowed: it takes two finite numbers in ascending order"
        )
    return low, high


def values_within(low: float, high: float, current: float) -> Array:
    """Values at which all cycles are searched, ascending: spread evenly, and around the point's own."""
    around = current * 2.0 ** np.arange(-OCTAVES, OCTAVES + 1)
    inside = around[(around > low) & (around < high)]
    return np.unique(np.concatenate([np.linspace(low, high, VALUES), inside]))
