"""Boundaries for the map of the page: read from a table that anybody may have written, and encoded."""

import base64
import itertools
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pyarrow as pa

from stridemap.columns import description
from stridemap.errors import InputError
from stridemap.solver.model.model import Model
from stridemap.views.markers import BOUNDARY_LINES, BOUNDARY_NAMES

FLAGS = ("gait", "borders_stable")
"""Columns that say where a boundary is one of gaits, and where it limits stable ones."""

MOST_POINTS = 200_000
"""Rows of a table beyond which the page would become slow."""

SAME = 1e-9
"""Relative difference of two values of a parameter that are one."""


def read_curves(path: str | Path) -> pd.DataFrame:
    """The table of points that ``stridemap boundary --out`` wrote.

    Raises
    ------
    InputError
        When it cannot be read.
    """
    try:
        table = pd.read_csv(path) if str(path).endswith(".csv") else pd.read_parquet(path)
    except (OSError, ValueError, pa.ArrowException) as error:
        raise InputError(
            f"cannot read boundaries from {path} ({error}); give what `stridemap boundary --out` wrote"
        ) from None
    check_units(table, f"the boundaries in {path}")
    return table


def check_units(table: pd.DataFrame, source: str) -> None:
    """Refuse a table that says of itself that it is in SI units.

    Raises
    ------
    InputError
        For such a table.
    """
    known = description(table)[0].values()
    if any(one.unit == one.si != "" and one.unit not in ("1", "rad") for one in known):
        raise InputError(
            f"{source} are in SI units, and the report's in the model's; write them without --units"
        )


def curves(
    model: Model, configuration: Mapping[str, Any], table: pd.DataFrame, source: str = "the boundaries"
) -> list[dict[str, Any]]:
    """Boundaries as plain values for JSON, those parts of them on which cycles are gaits.

    Parameters
    ----------
    model : Model
    configuration : mapping
        Of the sweep: boundaries at other values of what it fixes do not belong to it.
    table : DataFrame
        With the columns ``boundary, type, gait, borders_stable`` and all parameters.
    source : str
        What the table is called in errors.

    Raises
    ------
    InputError
        When the table lacks a column or holds what is not allowed, or does not belong to the sweep.
    """
    names = list(model.spec.names)
    _check(table, names, source)
    pair = _varying(table, names, source)
    for name in pair:
        if name not in configuration["grid"]:
            raise InputError(
                f"{source} lie in the plane of {pair[0]} and {pair[1]}, but the sweep does not vary {name}; "
                "give boundaries over two parameters of its grid"
            )
    check_fixed(model, configuration, table, source, "boundaries")
    others = [name for name in names if name in configuration["grid"] and name not in pair]
    out = []
    for _, one in table.groupby("boundary", sort=True):
        at = {name: float(one[name].iloc[0]) for name in others}
        out += [piece | {"names": list(pair), "at": at} for piece in _pieces(one, pair)]
    return out


def looks(found: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Name, colour and dashes of the types that there are, in the order of `BOUNDARY_NAMES`."""
    types = {one["type"] for one in found}
    return {
        name: {"name": text, "colour": BOUNDARY_LINES[name][0], "dashes": list(BOUNDARY_LINES[name][1])}
        for name, text in BOUNDARY_NAMES.items()
        if name in types
    }


def _check(table: pd.DataFrame, names: list[str], source: str) -> None:
    """Refuse a table without what is needed."""
    wanted = "give what `stridemap boundary --out` wrote for this model"
    for name in ("boundary", "type", *FLAGS, *names):
        if name not in table:
            raise InputError(f"{source} lack the column {name}; {wanted}")
    for name in ("boundary", *FLAGS, *names):
        if not (pd.api.types.is_numeric_dtype(table[name]) and np.isfinite(table[name].astype(float)).all()):
            raise InputError(f"the column {name} of {source} must hold finite numbers; {wanted}")
    unknown = [str(one) for one in table["type"].unique() if one not in BOUNDARY_NAMES]
    if unknown:
        known = ", ".join(BOUNDARY_NAMES)
        raise InputError(f"{source} have the type {unknown[0]!r}, not one of {known}; {wanted}")
    if len(table) > MOST_POINTS:
        raise InputError(
            f"{source} have {len(table):,} points, more than the {MOST_POINTS:,} that a page shows well; "
            "give fewer"
        )


def _varying(table: pd.DataFrame, names: list[str], source: str) -> tuple[str, str]:
    """The two parameters that change along boundaries."""
    groups = table.groupby("boundary")[names]
    changes = (groups.max() > groups.min()).any()
    found = [name for name in names if changes[name]]
    if len(found) != 2:
        raise InputError(
            f"along {source} {len(found)} parameters change ({', '.join(found) or 'none'}); a map shows "
            "boundaries over two"
        )
    return found[0], found[1]


def check_fixed(
    model: Model, configuration: Mapping[str, Any], table: pd.DataFrame, source: str, kind: str
) -> None:
    """Refuse a table at other values of what a sweep does not vary.

    Parameters
    ----------
    model : Model
    configuration : mapping
        Of the sweep.
    table : DataFrame
        With a column for each parameter.
    source, kind : str
        What the table and what it holds are called in errors.

    Raises
    ------
    InputError
        For such a table.
    """
    fixed = {**model.preset, **configuration["params"]}
    for name in model.spec.names:
        if name in configuration["grid"]:
            continue
        if not np.isclose(table[name].to_numpy(dtype=float), fixed[name], rtol=SAME, atol=0.0).all():
            raise InputError(
                f"{source} are at {name} = {table[name].iloc[0]:g}, the sweep is at {fixed[name]:g}; "
                f"give {kind} that belong to it"
            )


def _pieces(one: pd.DataFrame, pair: tuple[str, str]) -> list[dict[str, Any]]:
    """Parts of one boundary on which cycles are gaits, and all of which limits stable gaits, or none."""
    gait, stable = (one[name].to_numpy(dtype=bool) for name in FLAGS)
    points = one[list(pair)].to_numpy(dtype=float)
    shown, thick = gait[:-1] & gait[1:], stable[:-1] & stable[1:]
    look = np.where(shown, np.where(thick, 2, 1), 0)
    edges = np.flatnonzero(np.diff(np.concatenate([[-1], look, [-1]])))
    return [
        {
            "type": str(one["type"].iloc[0]),
            "stable": bool(look[first] == 2),
            "points": base64.b64encode(points[first : last + 1].astype("<f8").tobytes()).decode("ascii"),
        }
        for first, last in itertools.pairwise(edges.tolist())
        if look[first]
    ]
