"""The limit cycles that the paper's statements are about, as tables.

Four sweeps, whose configurations lie beside this file, are run or read again from where an earlier run left
them.
"""

import math
import tomllib
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.paper.branch_tables import EDGE_COLUMNS, edge_table, minima_table
from stridemap.paper.profiles import BESIDE, beside, with_profiles
from stridemap.paper.profiles import COLUMNS as PROFILE_COLUMNS
from stridemap.solver.branches.main_branch import on_main_branch
from stridemap.solver.cycles.gait import is_physical_gait
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model
from stridemap.sweeps.config import SweepConfig, parse_config
from stridemap.sweeps.run import Progress, sweep
from stridemap.sweeps.store import read_cells, read_orbits

SWEEPS = ("typical", "compass", "lines", "map")
"""Names of the sweeps: the three typical solutions, the compass, `k` at four points, and `k` with `alpha`."""

FREE = ("beta", "Kp", "Kd", "S", "gamma")
"""Parameters whose values the paper does not print."""

ALPHAS, OMEGAS = (0.25, 0.5), (2.0, 3.0)

MEASURES = (
    "status", "step_length", "min_vertical_force", "period", "spectral_radius", "stable", "d_max", "cot",
    "cot_per_speed", "peaks",
)  # fmt: skip
_WALKER = (*MEASURES, "k", "alpha", "omega", "group", "x_zero_crossings")


@dataclass(frozen=True)
class PaperData:
    """The tables from which the statements are decided; they hold only cycles that are physical gaits.

    Parameters
    ----------
    typical : DataFrame
        Cycles at the three typical solutions, with time profiles, and laid beside the compass's.
    compass : DataFrame
        Cycles of the compass, a row each.
    lines : DataFrame
        Cycles over `k` at the pairs of alpha and omega. ``main`` tells whether one is on the main branch; the
        columns of time profiles are filled for stable cycles.
    between : DataFrame
        Cycles between the springs of `lines`, where measures are smallest.
    edges : DataFrame
        Bisected edges of the ranges with stable cycles.
    map : DataFrame
        Cycles over `k` and alpha at both omega.
    line_k, map_k, map_alpha : ndarray
        What was searched: values of `k` of the lines, and of `k` and alpha of the map.
    """

    typical: pd.DataFrame
    compass: pd.DataFrame
    lines: pd.DataFrame
    between: pd.DataFrame
    edges: pd.DataFrame
    map: pd.DataFrame
    line_k: NDArray[np.float64]
    map_k: NDArray[np.float64]
    map_alpha: NDArray[np.float64]

    def __post_init__(self) -> None:
        for name, columns in {
            "typical": (*_WALKER, *PROFILE_COLUMNS, *BESIDE),
            "compass": (*MEASURES, "omega"),
            "lines": (*_WALKER, *PROFILE_COLUMNS, "main"),
            "between": (*_WALKER, "main"),
            "edges": EDGE_COLUMNS,
            "map": _WALKER,
        }.items():
            require(getattr(self, name), columns, name)
        for name in ("compass", "lines", "map"):
            require_cycles(getattr(self, name), name)


def require(table: pd.DataFrame, columns: Sequence[str], name: str) -> None:
    """Refuse a table without the columns that the statements need.

    Raises
    ------
    InputError
        Naming the first that is missing.
    """
    for column in columns:
        if column not in table.columns:
            raise InputError(
                f"the table {name} has no column {column}; give tables of the sweeps that belong here"
            )


def require_cycles(table: pd.DataFrame, name: str) -> None:
    """Refuse a table without a cycle that counts; only at the typical solutions there may be none.

    Raises
    ------
    InputError
        Naming the sweep.
    """
    if table.empty and name != "typical":
        raise InputError(
            f"the sweep {name} holds no limit cycle that walks, so that nothing can be decided; "
            "choose other parameters, or sweep into another folder"
        )


def configurations(params: Mapping[str, Any] | None = None, thin: int = 1) -> dict[str, SweepConfig]:
    """The configurations of the sweeps, by name.

    Parameters
    ----------
    params : mapping, optional
        Values of parameters in `FREE` in place of the preset's.
    thin : int
        Only every so-manieth value of the ranges is searched: faster, and less decided.

    Raises
    ------
    InputError
        For a parameter that the paper fixes or the model has not, or a value out of range.
    """
    if thin < 1:
        raise InputError(f"thin = {thin} is not allowed: at least 1 is needed")
    for name in params or {}:
        if name not in FREE:
            raise InputError(
                f"{name} cannot be set here: the statements are about given k, alpha and omega; "
                f"what can be set is {', '.join(FREE)}"
            )
    out = {}
    for name in SWEEPS:
        data = tomllib.loads(files("stridemap.paper").joinpath(f"{name}.toml").read_text("utf-8"))
        for axis in data["grid"].values():
            if isinstance(axis, dict):
                axis["num"] = math.ceil((axis["num"] - 1) / thin) + 1
        data["params"] = data.get("params", {}) | dict(params or {})
        out[name] = parse_config(data, f"the sweep {name}")
    return out


def collect(
    out: str | Path,
    params: Mapping[str, Any] | None = None,
    *,
    thin: int = 1,
    workers: int | None = None,
    executor: Executor | None = None,
    progress: Callable[[str, Progress], None] | None = None,
) -> PaperData:
    """Run the sweeps, or read what an earlier run finished, and make the tables.

    Parameters
    ----------
    out : path
        Folder; each sweep has a folder in it.
    params, thin
        As for `configurations`.
    workers, executor
        As for `stridemap.sweep`.
    progress : callable, optional
        Called with the name of the sweep and a `Progress`.

    Raises
    ------
    InputError
        For unusable parameters or folders, among them those with another configuration's tables, and when
        nothing walks.
    """
    found, cells = {}, {}
    for name, config in configurations(params, thin).items():
        folder = Path(out) / name

        def report(seen: Progress, name: str = name) -> None:
            if progress:
                progress(name, seen)

        sweep(config, folder, workers=workers, executor=executor, resume=True, progress=report)
        orbits = read_orbits(folder)
        found[name] = orbits[is_physical_gait(orbits)].reset_index(drop=True)
        require_cycles(found[name], name)
        cells[name] = read_cells(folder)
    return tables(found, cells)


def tables(found: Mapping[str, pd.DataFrame], cells: Mapping[str, pd.DataFrame]) -> PaperData:
    """Add to the tables of the sweeps what they do not hold.

    Parameters
    ----------
    found : mapping of str to DataFrame
        Cycles that count, by sweep.
    cells : mapping of str to DataFrame
        Grid cells, by sweep.
    """
    walker, compass = load("wobbling"), load("compass")
    solver, orbits = Solver.for_model(walker), Orbits.from_columns(walker, found["lines"])
    main = on_main_branch(orbits, "k")
    lines = _lines(walker, found["lines"], main)
    line_k = np.sort(cells["lines"]["k"].unique())
    return PaperData(
        typical=_typical(walker, found["typical"], compass, found["compass"]),
        compass=found["compass"],
        lines=lines,
        between=minima_table(solver, orbits, main, line_k),
        edges=edge_table(solver, orbits, line_k),
        map=found["map"],
        line_k=line_k,
        map_k=np.sort(cells["map"]["k"].unique()),
        map_alpha=np.sort(cells["map"]["alpha"].unique()),
    )


def _typical(walker: Model, orbits: pd.DataFrame, compass: Model, cycles: pd.DataFrame) -> pd.DataFrame:
    profiled = with_profiles(walker, orbits)
    return beside(walker, profiled, compass, cycles[cycles["omega"].isin(orbits["omega"])])


def _lines(walker: Model, orbits: pd.DataFrame, main: NDArray[np.bool_]) -> pd.DataFrame:
    profiles = with_profiles(walker, orbits[orbits["stable"]])[list(PROFILE_COLUMNS)]
    return orbits.assign(main=main).join(profiles)
