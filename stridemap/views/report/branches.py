"""Branches for the slice of the page: read from tables that anybody may have written, and encoded."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pyarrow as pa
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.solver.branches.branches import Branches
from stridemap.solver.model.model import Model
from stridemap.views import palette
from stridemap.views.branch_lines import kinds_of, looks_between, placed
from stridemap.views.markers import BOUNDARY_LINES, BOUNDARY_NAMES, MARKERS
from stridemap.views.report.curves import check_fixed, check_units
from stridemap.views.report.encoding import Encoder

Given = str | Path | Branches
"""What the page takes branches from."""

MOST_POINTS = 200_000
"""Rows of tables beyond which the page would become slow."""


def read_branches(given: Given) -> tuple[pd.DataFrame, pd.DataFrame, str]:
    """Tables of points and of special points, and what they are called in errors.

    Parameters
    ----------
    given : path or Branches
        A path is the one that ``stridemap branch --out`` was given: the special points lie beside it.

    Raises
    ------
    InputError
        When a table cannot be read.
    """
    if isinstance(given, Branches):
        return given.to_frame(), given.special_frame(), "the branches"
    path = Path(given)
    try:
        read = pd.read_csv if path.suffix == ".csv" else pd.read_parquet
        tables = [read(one) for one in (path, path.with_stem(f"{path.stem}_special"))]
    except (OSError, ValueError, pa.ArrowException) as error:
        raise InputError(
            f"cannot read branches from {path} ({error}); give what `stridemap branch --out` wrote, with the "
            f"file {path.stem}_special{path.suffix} beside it"
        ) from None
    check_units(tables[0], f"the branches in {path}")
    return tables[0], tables[1], f"the branches in {path}"


def branches(
    model: Model,
    configuration: Mapping[str, Any],
    orbits: pd.DataFrame,
    given: Sequence[Given],
    encoder: Encoder,
) -> list[dict[str, Any]]:
    """Branches as plain values for JSON, one entry per table.

    Parameters
    ----------
    model : Model
    configuration : mapping
        Of the sweep: branches at other values of what it fixes do not belong to it.
    orbits : DataFrame
        The sweep's limit cycles: what they are measured by is what is drawn of branches.
    given : sequence of path or Branches
    encoder : Encoder

    Raises
    ------
    InputError
        When a table cannot be read, lacks a column, holds what is not allowed or does not belong to the
        sweep.
    """
    return [_encoded(model, configuration, orbits, *read_branches(one), encoder) for one in given]


def special_looks() -> dict[str, Any]:
    """Name, letters, marker and colour of each type of special point."""
    bifurcation = {"bp": (palette.DARK, ())}
    return {
        name: {
            "name": BOUNDARY_NAMES.get(name, "branch point"),
            "letters": letters,
            "marker": marker,
            "colour": {**BOUNDARY_LINES, **bifurcation}[name][0],
        }
        for name, (marker, letters) in MARKERS.items()
    }


def _encoded(
    model: Model,
    configuration: Mapping[str, Any],
    orbits: pd.DataFrame,
    points: pd.DataFrame,
    special: pd.DataFrame,
    source: str,
    encoder: Encoder,
) -> dict[str, Any]:
    names = list(model.spec.names)
    _check(points, special, names, source)
    varies = _varying(points, names, source)
    if varies not in configuration["grid"]:
        raise InputError(
            f"{source} are over {varies}, which the sweep does not vary; give branches over a parameter of "
            f"its grid: {', '.join(configuration['grid'])}"
        )
    check_fixed(model, configuration, points, source, "branches")
    lines = _lines(points, special, varies, _drawable(points, special, orbits))
    return {
        "varies": varies,
        "at": {
            name: float(points[name].iloc[0])
            for name in names
            if name in configuration["grid"] and name != varies
        },
        "lines": encoder.table(lines),
    }


def _check(points: pd.DataFrame, special: pd.DataFrame, names: list[str], source: str) -> None:
    """Refuse tables without what is needed."""
    wanted = "give what `stridemap branch --out` wrote for this model"
    needed = ("branch", "period_n", "gait", "arclength", "spectral_radius", *names)
    for table, columns in ((points, needed), (special, ("branch", "type", "arclength", "gait", *names))):
        if table is special and table.empty:
            continue
        for name in columns:
            if name not in table:
                raise InputError(f"{source} lack the column {name}; {wanted}")
            numbers = table[name]
            if name in ("type", "spectral_radius"):
                continue
            if not (pd.api.types.is_numeric_dtype(numbers) and np.isfinite(numbers.astype(float)).all()):
                raise InputError(f"the column {name} of {source} must hold finite numbers; {wanted}")
    if not pd.api.types.is_numeric_dtype(points["spectral_radius"]):
        raise InputError(f"the column spectral_radius of {source} must hold numbers; {wanted}")
    unknown = [str(one) for one in special.get("type", pd.Series(dtype=str)).unique() if one not in MARKERS]
    if unknown:
        known = ", ".join(MARKERS)
        raise InputError(f"{source} have the special point {unknown[0]!r}, not one of {known}; {wanted}")
    if points.empty:
        raise InputError(f"{source} have no points; {wanted}")
    if len(points) + len(special) > MOST_POINTS:
        raise InputError(
            f"{source} have {len(points) + len(special):,} points, more than the {MOST_POINTS:,} that a page "
            "shows well; give fewer"
        )


def _varying(points: pd.DataFrame, names: list[str], source: str) -> str:
    """The parameter that changes along branches."""
    found = [name for name in names if points[name].max() > points[name].min()]
    if len(found) != 1:
        raise InputError(
            f"along {source} {len(found)} parameters change ({', '.join(found) or 'none'}); a slice shows "
            "branches over one"
        )
    return found[0]


def _drawable(points: pd.DataFrame, special: pd.DataFrame, orbits: pd.DataFrame) -> list[str]:
    """Columns of numbers that cycles of the sweep, branches and their special points have in common."""
    return [
        name
        for name in points
        if name in orbits
        and (name in special or special.empty)
        and pd.api.types.is_numeric_dtype(points[name])
        and not pd.api.types.is_bool_dtype(points[name])
        and name not in ("branch", "cell")
    ]


def _lines(points: pd.DataFrame, special: pd.DataFrame, varies: str, columns: Sequence[str]) -> pd.DataFrame:
    """Points of branches with their special points where they lie, along each branch.

    The column ``look`` is that of the piece after a row: 0 where there is no gait or the branch ends, 1
    unstable, 2 stable. ``type`` is that of a special point, ``words`` what is to be said of it.
    """
    parts = []
    columns = [name for name in columns if name not in (varies, "period_n")]
    for number, one in points.groupby("branch", sort=True):
        one = one.sort_values("arclength", kind="stable")
        met = special[special["branch"] == number] if len(special) else special
        lengths = one["arclength"].to_numpy(dtype=float)
        at = met["arclength"].to_numpy(dtype=float) if len(met) else np.empty(0)
        order = placed(lengths, at)
        largest = one["spectral_radius"].to_numpy(dtype=float)
        kinds = kinds_of(one["gait"].to_numpy(dtype=bool), largest)
        part = {
            varies: np.append(one[varies].to_numpy(dtype=float), met[varies] if len(met) else at)[order],
            "branch": np.full(len(order), number),
            "period_n": np.full(len(order), int(one["period_n"].iloc[0])),
            "look": np.append(looks_between(order, kinds), 0),
            "type": _types(met, len(lengths))[order],
            "words": _words(met, len(lengths))[order],
        }
        for name in columns:
            part[name] = np.append(one[name].to_numpy(dtype=float), met[name] if len(met) else at)[order]
        parts.append(pd.DataFrame(part))
    lines = pd.concat(parts, ignore_index=True)
    # Of what is no gait only its edges are drawn, where gaits begin or end.
    shown = (lines["look"] > 0) | (lines["look"].shift(fill_value=0) > 0) | (lines["type"] != "")
    lines = lines[shown].reset_index(drop=True)
    return lines.assign(type=lines["type"].replace("", None), words=lines["words"].replace("", None))


def _types(met: pd.DataFrame, n: int) -> NDArray[Any]:
    """Types of special points that are of gaits, after n points that are none."""
    types = met["type"].where(met["gait"].astype(bool), "").tolist() if len(met) else []
    return np.concatenate([np.full(n, "", dtype=object), np.asarray(types, dtype=object)])


def _words(met: pd.DataFrame, n: int) -> NDArray[Any]:
    """Supercritical or subcritical, after n points of which neither is said."""
    said = met["criticality"].fillna("").tolist() if "criticality" in met else [""] * len(met)
    return np.concatenate([np.full(n, "", dtype=object), np.asarray(said, dtype=object)])
