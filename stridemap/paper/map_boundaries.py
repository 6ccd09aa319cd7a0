"""The boundaries of gaits in the plane of the paper's map, computed from its sweep and kept beside it."""

import hashlib
import json
import os
from collections.abc import Callable
from pathlib import Path

import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq

from stridemap.paper.points import PLANE
from stridemap.paper.select import at
from stridemap.paper.sweeps import PaperSweeps
from stridemap.services import told
from stridemap.solver.boundaries.of_cells import CellSurvey
from stridemap.solver.boundaries.smooth import SmoothLine
from stridemap.solver.boundaries.survey import Boundary
from stridemap.solver.branches.conditions import GaitConditions
from stridemap.solver.branches.plane import Plane, middle_edges
from stridemap.solver.branches.survey import Survey
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.options import ContinuationOptions, SearchOptions

NAMES = ("k", "alpha")
"""The two parameters of the map."""

FORMAT = 2
"""Of the file in which boundaries are kept; it rises when what is computed changes."""

STEPS = ContinuationOptions(ds_max=0.2, min_tangent_cosine=0.97, easy_tangent_cosine=0.995)
"""Longer steps than those of `stridemap boundary`: between them the lines are drawn along their tangents."""


def map_boundaries(sweeps: PaperSweeps, progress: Callable[[str], None] | None = None) -> pd.DataFrame:
    """All boundaries of gaits in the plane of the map, as lines that are fine enough to be drawn.

    They are computed when they are first asked for, which takes about two minutes, and read again from a file
    beside the sweep afterwards, as long as the sweep is the same.

    Parameters
    ----------
    sweeps : PaperSweeps
    progress : callable, optional
        Takes a line that says what is being done.

    Returns
    -------
    DataFrame
        A row per point, with the columns ``boundary, type, period_n, gait, borders_stable`` of
        ``stridemap boundary --out`` and all parameters.
    """
    gaits = at(sweeps.gaits("map"), omega=PLANE["omega"])
    path, key = sweeps.folder / "map-boundaries.parquet", _key(sweeps, gaits)
    if (kept := _read(path, key)) is not None:
        return kept
    with told("boundaries of the map", progress) as say:
        survey = cell_survey(sweeps, gaits, say)
        table = lines_table(survey.boundaries(), survey)
    _write(path, table, key)
    return table


def cell_survey(sweeps: PaperSweeps, gaits: pd.DataFrame, progress: Callable[[str], None]) -> CellSurvey:
    """How the boundaries in the plane of the map are found from its gaits."""
    config = sweeps.configs["map"]
    model = load(config.model)
    solver, orbits = Solver.for_model(model), Orbits.from_columns(model, gaits)
    plane = Plane.of_orbits(orbits, NAMES, config.grid["k"], config.grid["alpha"])
    (left, right), (bottom, top) = middle_edges(plane.x), middle_edges(plane.y)
    along = Survey(
        solver,
        orbits.params[0].copy(),
        NAMES[0],
        left,
        right,
        1,
        0,
        1,
        SearchOptions(),
        STEPS,
        GaitConditions(solver.kernels, None),
        lambda _: None,
    )
    return CellSurvey(
        along, NAMES, (left, bottom), (right, top), 1, progress, False, plane=plane, orbits=orbits
    )


def lines_table(boundaries: list[Boundary], survey: CellSurvey) -> pd.DataFrame:
    """Boundaries as a table of points, finely enough to be drawn, and exact beside the middles of cells."""
    frames = []
    names = survey.along.solver.model.spec.names
    fixed = dict(zip(names, survey.along.params.tolist(), strict=True))
    for number, one in enumerate(boundaries):
        line = SmoothLine.of(one).exact_beside(one, survey.plane.x, survey.plane.y)
        along = dict(zip(NAMES, line.points.T, strict=True))
        columns = {
            "boundary": number,
            "type": one.type,
            "period_n": one.period_n,
            "gait": line.is_gait,
            "borders_stable": line.borders_stable,
        }
        frames.append(pd.DataFrame(columns | {name: along.get(name, fixed[name]) for name in names}))
    return pd.concat(frames, ignore_index=True) if frames else pd.DataFrame()


# -- the file ------------------------------------------------------------------------------------------------


def _key(sweeps: PaperSweeps, gaits: pd.DataFrame) -> str:
    """What the lines depend on: the model, the grid, the cycles of the sweep, and this program's format."""
    config = sweeps.configs["map"]
    cycles = hashlib.sha256(gaits[[*NAMES, "period", "spectral_radius"]].to_numpy().tobytes()).hexdigest()
    parts = [FORMAT, load(config.model).hash, config.config_hash, cycles, vars(STEPS)]
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def _read(path: Path, key: str) -> pd.DataFrame | None:
    """The lines that were kept, or None where there are none for this sweep."""
    try:
        table = pq.read_table(path)
    except (OSError, pa.ArrowException):
        return None
    return table.to_pandas() if (table.schema.metadata or {}).get(b"stridemap") == key.encode() else None


def _write(path: Path, lines: pd.DataFrame, key: str) -> None:
    """Keep lines: the file is written whole or not at all."""
    table = pa.Table.from_pandas(lines, preserve_index=False)
    table = table.replace_schema_metadata({"stridemap": key})
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    pq.write_table(table, temporary)
    os.replace(temporary, path)
