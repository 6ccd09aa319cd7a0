"""Values to compare with, such as those of the walker without a wobbling mass."""

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import pandas as pd

from stridemap.errors import InputError
from stridemap.quantities import QUANTITIES
from stridemap.solver.model.model import Model

ERRORS = ("residual", "integration_error", "state_error", "multiplier_error")
"""Quantities that say how good a computation was: nothing is compared with them."""


@dataclass(frozen=True)
class Reference:
    """A value of a quantity that cycles are compared with.

    Parameters
    ----------
    quantity : str
        Name of the quantity.
    value : float
    label : str
        A word that says whose value it is, such as ``"compass"``; filters of the report use it.
    parameters : mapping of str to float
        Where it holds: at cycles with these values of parameters; empty for everywhere.
    """

    quantity: str
    value: float
    label: str
    parameters: Mapping[str, float] = field(default_factory=dict)


def references_of(orbits: pd.DataFrame, label: str, names: Sequence[str]) -> list[Reference]:
    """The values of other cycles as references: of all quantities, at each value of some parameters.

    Where several cycles have the same parameters it is the most stable one that is compared with; unstable
    ones are left out.

    Parameters
    ----------
    orbits : DataFrame
        A table of cycles.
    label : str
        As for `Reference`.
    names : sequence of str
        The parameters that the table varies.
    """
    stable = orbits[orbits["stable"].fillna(False).astype(bool)].sort_values("spectral_radius")
    best = stable.drop_duplicates(list(names)) if names else stable.head(1)
    quantities = [
        name
        for name, one in QUANTITIES.items()
        if name in best and one.type in ("float", "int") and name not in ERRORS
    ]
    return [
        Reference(name, float(row[name]), label, {key: float(row[key]) for key in names})
        for _, row in best.sort_values(list(names)).iterrows()
        for name in quantities
        if not pd.isna(row[name]) and math.isfinite(row[name])
    ]


def checked(
    model: Model, configuration: Mapping[str, Any], orbits: pd.DataFrame, given: Iterable[Reference]
) -> list[Reference]:
    """References of quantities that the table has, refused where they do not belong to the sweep.

    Raises
    ------
    InputError
        For a label that is not a word, a value that is not finite, or a parameter that the model lacks.
    """
    found = []
    for one in given:
        if not re.fullmatch("[A-Za-z][A-Za-z0-9_]{0,99}", one.label):
            raise InputError(
                f"the label {one.label!r} of a reference is not a word; give letters, digits and _ only"
            )
        if one.label in (*orbits.columns, *model.preset, "stable", "and", "or", "not"):
            raise InputError(
                f"the label {one.label} of a reference is the name of a column, of a parameter or of an "
                "operation; give another word"
            )
        if not all(map(math.isfinite, [one.value, *one.parameters.values()])):
            raise InputError(f"the reference {one.label} of {one.quantity} is not a finite number")
        for name in one.parameters:
            if name not in model.preset:
                raise InputError(
                    f"the reference {one.label} is given at {name}, which {model.name} does not have; its "
                    f"parameters are {', '.join(model.preset)}"
                )
        fixed = {**model.preset, **configuration["params"]}
        here = all(
            name in configuration["grid"] or math.isclose(fixed[name], value, rel_tol=1e-9)
            for name, value in one.parameters.items()
        )
        if here and one.quantity in orbits:
            found.append(one)
    return found
