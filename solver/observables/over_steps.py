"""From the measures of each walking step to those of a cycle of several steps.

How a quantity adds up stands in its registry entry (`Quantity.over_steps`).
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.spec import Quantity

Array = NDArray[Any]

OF_DECLARED = {"maximum": "maximum", "minimum": "minimum", "amplitude": "maximum", "final": "last"}
"""How a quantity that a model file declares adds up, by its reduction."""


def over_steps(
    quantities: Mapping[str, Quantity], steps: Mapping[str, Array | None], periods: Array, n_steps: int
) -> dict[str, Array | None]:
    """Measures of cycles of several steps.

    Parameters
    ----------
    quantities : mapping of str to Quantity
    steps : mapping of str to ndarray, shape (m * n_steps,), or None
        Measures of each walking step, the steps of a cycle one after another.
    periods : ndarray, shape (m, n_steps)
    n_steps : int

    Returns
    -------
    dict of str to ndarray, shape (m,), or None
        None where the model lacks a quantity, or where it is not defined for several steps.
    """
    lengths = np.asarray(steps["step_length"]).reshape(-1, n_steps)
    # What is per unit of absolute length counts a step that leads back as well.
    weights = {"by_length": np.abs(lengths), "by_time": periods}
    whole = {"by_length": np.abs(lengths.sum(axis=1)), "by_time": periods.sum(axis=1)}
    out: dict[str, Array | None] = {}
    for name, values in steps.items():
        quantity = quantities[name]
        rule = quantity.over_steps or OF_DECLARED.get(quantity.reduction, "")
        each = None if values is None or not rule else np.asarray(values).reshape(-1, n_steps)
        if each is None:
            out[name] = None
        elif rule in weights:
            out[name] = (each * weights[rule]).sum(axis=1) / whole[rule]
        elif rule == "per_speed":
            total = (each * weights["by_length"] / periods).sum(axis=1)
            out[name] = total * whole["by_time"] / whole["by_length"]
        else:
            out[name] = _PLAIN[rule](each)
    return out


_PLAIN = {
    "sum": lambda each: each.sum(axis=1),
    "maximum": lambda each: each.max(axis=1),
    "minimum": lambda each: each.min(axis=1),
    "cycle": lambda each: each[:, 0],
    "last": lambda each: each[:, -1],
}
