"""What the page is given: a sweep's tables as columns of numbers, and its model.

Numbers travel with the digits that the page shows (`stridemap.views.report.encoding`). Trajectories do
not travel: the page integrates the step that it shows, from the section point of the table and with the
equations of the model.
"""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

import pandas as pd
from scipy.integrate import DOP853

from stridemap.quantities import KINDS, QUANTITIES
from stridemap.solver.model.model import Model
from stridemap.spec import Parameter
from stridemap.views.notation import printed, rate_symbol, symbol, units
from stridemap.views.report.branches import Given, special_looks
from stridemap.views.report.branches import branches as encoded_branches
from stridemap.views.report.curves import looks
from stridemap.views.report.encoding import Encoder
from stridemap.views.report.references import Reference, checked
from stridemap.views.report.si import si_names, si_powers
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
    references: Sequence[Reference] = (),
    branches: Sequence[Given] = (),
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
    references : sequence of Reference
        Values of quantities to compare with.
    branches : sequence of path or Branches
        Branches over one parameter each.

    Raises
    ------
    InputError
        For a reference or branches that do not belong to the sweep.
    """
    encoder = Encoder()
    states = (*model.section, "period")
    names = si_names(model.spec)
    hidden = {"cell", *(parameter.name for parameter in model.parameters)}
    return {
        "model": _model(model),
        "axes": [
            {
                "name": parameter.name,
                "symbol": symbol(parameter.name),
                "unit": printed(parameter.unit),
                "si": names.get(printed(parameter.unit), ""),
                "meaning": parameter.meaning,
                "values": configuration["grid"][parameter.name],
                "preset": parameter.default,
            }
            for parameter in axes(model, configuration)
        ],
        "fixed": configuration["params"],
        "cells": encoder.table(cells[["status", "reason"]]),
        "orbits": encoder.table(orbits[["cell", *(name for name in orbits if name not in hidden)]], states),
        "branches": encoded_branches(model, configuration, orbits, branches, encoder),
        "special": special_looks() if branches else {},
        "bytes": encoder.packed(),
        "measures": _measures(model, orbits, hidden),
        "curves": list(curves),
        "looks": looks(curves),
        "references": [asdict(one) for one in checked(model, configuration, orbits, references)],
        "si": si_powers(model.spec),
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
    names = si_names(spec)
    return {
        "name": model.name,
        "title": model.title,
        "parameters": [
            {"name": p.name, "symbol": symbol(p.name), "meaning": p.meaning, "unit": printed(p.unit)}
            for p in model.parameters
        ],
        "coordinates": [
            {
                "name": c.name,
                "unit": printed(c.unit),
                "symbol": symbol(c.name),
                "rate_symbol": rate_symbol(c.name),
                "rate_unit": printed(c.rate_unit),
                "si": names.get(printed(c.unit), ""),
                "rate_si": names.get(printed(c.rate_unit), ""),
            }
            for c in spec.coordinates
        ],
        "section": [_section(name, model, names) for name in model.section],
        "motors": [
            {"symbol": symbol(m.name), "unit": printed(m.unit), "si": KINDS[m.kind][1]} for m in spec.motors
        ],
        "units": units(spec.units),
        "si_units": {kind: si for kind, (_, si) in KINDS.items()},
        "masses": [asdict(mass) for mass in spec.masses],
        "lines": [asdict(line) for line in spec.lines],
        "inputs": {name: list(function.arguments) for name, function in spec.functions.items()},
    }


def _section(name: str, model: Model, names: Mapping[str, str]) -> dict[str, str]:
    """Symbol and units of an entry of the section point: a coordinate, a rate, or one of the model's own."""
    rates = {f"d{c.name}": c for c in model.spec.coordinates}
    if name in rates:
        shown, unit = rate_symbol(name[1:]), rates[name].rate_unit
    else:
        own = {c.name: c.unit for c in model.spec.coordinates}
        shown, unit = symbol(name), own.get(name, "1")
    return {"name": name, "symbol": shown, "unit": printed(unit), "si": names.get(printed(unit), "")}


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
    return [
        {
            "name": q.name,
            "label": q.label,
            "unit": unit[q.kind],
            "si": KINDS[q.kind][1],
            "meaning": q.definition,
        }
        for q in known
    ]
