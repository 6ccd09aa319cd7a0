"""What the page is given: a sweep's tables as columns of numbers, and its model.

Numbers travel as they stand in the tables, in double precision, so that the page shows the same digits.
Trajectories do not travel: the page integrates the step that it shows, from the section point of the
table and with the equations of the model.
"""

import base64
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np
import pandas as pd
from scipy.integrate import DOP853

from stridemap.quantities import QUANTITIES
from stridemap.solver.model.model import Model
from stridemap.spec import Parameter
from stridemap.views.notation import printed, rate_symbol, symbol, units
from stridemap.views.report.curves import looks
from stridemap.words import is_multiplier

NEEDED = ("section_state", "state_derivative", "impact_map", "swing_foot", "drawing")
"""Generated functions without which no walker can be shown."""

_STAGES = len(DOP853.B)


def payload(
    model: Model,
    configuration: Mapping[str, Any],
    orbits: pd.DataFrame,
    cells: pd.DataFrame,
    curves: Sequence[Mapping[str, Any]] = (),
) -> Any:
    """Return plain values for JSON.

    Parameters
    ----------
    model : Model
    configuration : mapping
        Of the sweep, as in its provenance.
    orbits, cells : pandas.DataFrame
        The sweep's tables.
    curves : sequence of mapping
        Boundaries, as from `stridemap.views.report.curves.curves`.
    """
    hidden = {"cell", *(parameter.name for parameter in model.parameters)}
    return {
        "model": _model(model),
        "axes": [
            {
                "name": parameter.name,
                "symbol": symbol(parameter.name),
                "unit": printed(parameter.unit),
                "meaning": parameter.meaning,
                "values": configuration["grid"][parameter.name],
                "preset": parameter.default,
            }
            for parameter in axes(model, configuration)
        ],
        "fixed": configuration["params"],
        "cells": _table(cells[["status", "reason"]]),
        "orbits": _table(orbits[["cell", *(name for name in orbits if name not in hidden)]]),
        "measures": _measures(model, orbits, hidden),
        "curves": list(curves),
        "looks": looks(curves),
        "tableau": {
            "a": [[float(a) for a in row[:i]] for i, row in enumerate(DOP853.A[:_STAGES])],
            "b": DOP853.B.tolist(),
            "c": DOP853.C[:_STAGES].tolist(),
        },
    }


def axes(model: Model, configuration: Mapping[str, Any]) -> list[Parameter]:
    """Return the parameters that a sweep varied, in the model's order, which is that of the cells' numbers.

    The configuration in a file's provenance has its keys sorted.
    """
    return [parameter for parameter in model.parameters if parameter.name in configuration["grid"]]


def _model(model: Model) -> dict[str, Any]:
    spec = model.spec
    return {
        "name": model.name,
        "title": model.title,
        "parameters": [{"name": p.name, "symbol": symbol(p.name)} for p in model.parameters],
        "coordinates": [
            {
                "name": c.name,
                "unit": printed(c.unit),
                "symbol": symbol(c.name),
                "rate_symbol": rate_symbol(c.name),
                "rate_unit": printed(c.rate_unit),
            }
            for c in spec.coordinates
        ],
        "section": [
            {"name": name, "symbol": _section_symbol(name, model.coordinates)} for name in model.section
        ],
        "motors": [{"symbol": symbol(motor.name), "unit": printed(motor.unit)} for motor in spec.motors],
        "units": units(spec.units),
        "masses": [asdict(mass) for mass in spec.masses],
        "lines": [asdict(line) for line in spec.lines],
        "inputs": {name: list(function.arguments) for name, function in spec.functions.items()},
    }


def _section_symbol(name: str, coordinates: tuple[str, ...]) -> str:
    return rate_symbol(name[1:]) if name[:1] == "d" and name[1:] in coordinates else symbol(name)


def _measures(model: Model, orbits: pd.DataFrame, hidden: set[str]) -> list[dict[str, str]]:
    """Columns that are shown as measured quantities: the registry's, then those of the model's own."""
    shown = [
        name
        for name in orbits
        if name not in hidden
        and name not in model.section
        and not is_multiplier(name)
        and not orbits[name].isna().all()
    ]
    unit = units(model.spec.units)
    quantities = {**QUANTITIES, **model.measured}
    known = [quantity for name, quantity in quantities.items() if name in shown]
    return [{"name": q.name, "label": q.label, "unit": unit[q.kind], "meaning": q.definition} for q in known]


def _table(frame: pd.DataFrame) -> dict[str, Any]:
    return {"rows": len(frame), "columns": {name: _column(frame[name]) for name in frame}}


def _column(values: pd.Series) -> dict[str, Any]:
    """A column as base64 of little-endian numbers; words as indices into a list, -1 for none.

    Truth is 0 or 1, and 2 where it is not known.
    """
    if pd.api.types.is_bool_dtype(values):
        truth = np.where(values.isna(), 2, values.fillna(False).astype(bool))
        return {"type": "bool", "data": _base64(truth, "u1")}
    if pd.api.types.is_numeric_dtype(values):
        whole = pd.api.types.is_integer_dtype(values)
        if whole and not values.isna().any():
            return {"type": "i4", "whole": True, "data": _base64(values.to_numpy(), "<i4")}
        numbers = values.to_numpy(dtype=float, na_value=np.nan)
        return {"type": "f8", "whole": whole, "data": _base64(numbers, "<f8")}
    words = sorted(values.dropna().unique())
    index = {word: i for i, word in enumerate(words)}
    codes = np.array([index.get(word, -1) for word in values])
    return {"type": "word", "words": words, "data": _base64(codes, "<i4")}


def _base64(values: Any, kind: str) -> str:
    return base64.b64encode(np.ascontiguousarray(values, dtype=kind).tobytes()).decode("ascii")
