"""The limit cycles that the paper's statements are about, as the tables from which they are decided."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.paper.branch_tables import EDGE_COLUMNS, edge_table, minima_table
from stridemap.paper.points import PLANE, TYPICAL
from stridemap.paper.profile_features import COLUMNS as PROFILE_COLUMNS
from stridemap.paper.profile_features import COMPARED, compare_with, sampled, with_profiles
from stridemap.paper.sweeps import PaperSweeps, require_gaits
from stridemap.services import shown
from stridemap.solver.branches.main_branch import on_main_branch
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model

_ORBIT = (
    "status", "step_length", "min_vertical_force", "period", "spectral_radius", "stable", "d_max", "cot",
    "cot_per_speed", "peaks",
)  # fmt: skip
_WALKER = (*_ORBIT, "k", "alpha", "omega", "group", "x_zero_crossings")
_PROFILED = (*_WALKER, *PROFILE_COLUMNS, "wobble_amplitude")


@dataclass(frozen=True)
class CycleTables:
    """The tables from which the statements are decided; they hold only cycles that are physical gaits.

    Parameters
    ----------
    typical : DataFrame
        Cycles at the three typical solutions, with their time profiles, compared with the compass's.
    compass : DataFrame
        Cycles of the compass, one per row.
    lines : DataFrame
        Cycles over `k` at the pairs of alpha and omega. ``main`` says whether one is on the main branch; the
        columns of time profiles are filled for stable cycles.
    minima : DataFrame
        Cycles between the springs of `lines`, where measures are smallest.
    edges : DataFrame
        Bisected edges of the ranges with stable cycles.
    map : DataFrame
        Cycles over `k` and alpha at both omega.
    line_k, map_k, map_alpha : ndarray
        What was searched: values of `k` of the lines, and of `k` and alpha of the map.
    profiles : mapping
        For drawings: of the most stable typical solution of each group, and of the compass at the same
        frequency (``compass``), `x`, `d` and the rate of theta1 over a step, as far as it has them.
    """

    typical: pd.DataFrame
    compass: pd.DataFrame
    lines: pd.DataFrame
    minima: pd.DataFrame
    edges: pd.DataFrame
    map: pd.DataFrame
    line_k: NDArray[np.float64]
    map_k: NDArray[np.float64]
    map_alpha: NDArray[np.float64]
    profiles: Mapping[str, Mapping[str, NDArray[np.float64]]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name, columns in {
            "typical": (*_PROFILED, *COMPARED),
            "compass": (*_ORBIT, "omega"),
            "lines": (*_PROFILED, "main"),
            "minima": (*_WALKER, "main"),
            "edges": EDGE_COLUMNS,
            "map": _WALKER,
        }.items():
            require(getattr(self, name), columns, name)
        for name in ("compass", "lines", "map"):
            require_gaits(getattr(self, name), name)


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


def cycle_tables(sweeps: PaperSweeps) -> CycleTables:
    """Make the tables from the sweeps, which are run where they are not finished.

    Parameters
    ----------
    sweeps : PaperSweeps

    Raises
    ------
    InputError
        For unusable folders, among them those with tables of another configuration, and when a sweep holds
        no physical gait.
    """
    gaits = {name: sweeps.gaits(name) for name in sweeps.configs}
    walker, compass = load("wobbling"), load("compass")
    solver, orbits = Solver.for_model(walker), Orbits.from_columns(walker, gaits["lines"])
    main = on_main_branch(orbits, "k")
    line_k = np.array(sweeps.configs["lines"].grid["k"])
    with shown("following what the statements are about") as update:
        update(detail="courses along a step")
        lines = _lines(walker, gaits["lines"], main)
        typical = _typical(walker, gaits["typical"], compass, gaits["compass"])
        update(detail="minima along branches")
        minima = minima_table(solver, orbits, main, line_k)
        update(detail="where gaits begin and end")
        edges = edge_table(solver, orbits, line_k)
    return CycleTables(
        typical=typical,
        compass=gaits["compass"],
        lines=lines,
        minima=minima,
        edges=edges,
        map=gaits["map"],
        line_k=line_k,
        map_k=np.array(sweeps.configs["map"].grid["k"]),
        map_alpha=np.array(sweeps.configs["map"].grid["alpha"]),
        profiles=_profiles(walker, typical, compass, gaits["compass"]),
    )


def _typical(walker: Model, orbits: pd.DataFrame, compass: Model, cycles: pd.DataFrame) -> pd.DataFrame:
    profiled = with_profiles(walker, orbits)
    return compare_with(walker, profiled, compass, cycles[cycles["omega"].isin(orbits["omega"])])


def _profiles(
    walker: Model, typical: pd.DataFrame, compass: Model, cycles: pd.DataFrame
) -> dict[str, dict[str, NDArray[np.float64]]]:
    """The profiles that are drawn."""
    chosen = {
        group: (walker, rows.sort_values("spectral_radius").iloc[[0]])
        for group, rows in typical[typical["stable"].fillna(False).astype(bool)].groupby("group")
        if set(rows["k"]) & {TYPICAL.get(str(group))}
    }
    same = cycles[cycles["omega"] == PLANE["omega"]].sort_values("spectral_radius")
    if len(same):
        chosen["compass"] = (compass, same.iloc[[0]])
    out = {}
    for name, (model, cycle) in chosen.items():
        motion = sampled(model, cycle)
        out[str(name)] = {
            **{
                c: motion.coordinate(c)[0]
                for c in ("x", "dtheta1")
                if c.removeprefix("d") in model.coordinates
            },
            "d": motion.d[0],
        }
    return out


def _lines(walker: Model, orbits: pd.DataFrame, main: NDArray[np.bool_]) -> pd.DataFrame:
    profiled = with_profiles(walker, orbits[orbits["stable"].fillna(False).astype(bool)])
    added = [name for name in profiled if name not in orbits]
    return orbits.assign(main=main).join(profiled[added])
