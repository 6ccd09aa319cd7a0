"""What following limit cycles over `k` adds to the tables of the paper's sweeps, as tables."""

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from stridemap.solver.branches.edges import bisected
from stridemap.solver.branches.joining import branches
from stridemap.solver.branches.minima import minima
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.solver import Solver

Array = NDArray[np.float64]

MINIMIZED = ("spectral_radius", "d_max", "cot", "cot_per_speed")
"""Measures whose smallest values the statements speak of."""

EDGE_COLUMNS = ("alpha", "omega", "group", "k_grid", "side", "k")
"""Columns of a table of edges: the last grid point with a stable cycle, the side of it on which the edge is
(-1 or 1), and the edge."""


def edge_table(solver: Solver, orbits: Orbits, k: Array) -> pd.DataFrame:
    """The edges of all ranges with stable cycles, as a table with `EDGE_COLUMNS`.

    Parameters
    ----------
    solver : Solver
    orbits : Orbits
        Physical gaits at pairs of alpha and omega.
    k : ndarray
        Every value of `k` that was searched, ascending.
    """
    edges = bisected(solver, orbits, "k", k)
    rows = orbits.take(edges.row).columns()
    table = {name: rows[name] for name in ("alpha", "omega", "group")}
    return pd.DataFrame({**table, "k_grid": rows["k"], "side": edges.side, "k": edges.value})


def minima_table(solver: Solver, orbits: Orbits, main: NDArray[np.bool_], k: Array) -> pd.DataFrame:
    """Cycles between the values of `k` that were searched, where a measure is smallest.

    The columns are those of ``orbits.parquet`` without the cell, and ``main``, as given.

    Parameters
    ----------
    solver : Solver
    orbits : Orbits, length n
        Physical gaits at pairs of alpha and omega.
    main : ndarray of bool, shape (n,)
        Whether each is on the main branch.
    k : ndarray
        Every value of `k` that was searched, ascending.
    """
    found = minima(solver, orbits, main, "k", k, MINIMIZED)
    return found.orbits.to_frame().assign(main=found.on_main_branch)


def branch_tables(solver: Solver, orbits: Orbits, k: Array) -> list[pd.DataFrame]:
    """The branches over `k` at one alpha and omega, one table each, with their cycles in order.

    The columns are those of ``orbits.parquet`` without the cell, and ``on_grid``: whether the sweep found the
    cycle, or following the branch between two values of `k`.

    Parameters
    ----------
    solver : Solver
    orbits : Orbits
        All cycles at one alpha and omega.
    k : ndarray
        Every value of `k` that was searched, ascending.
    """
    joined = branches(solver, orbits, "k", k)
    return [branch.orbits.to_frame().assign(on_grid=branch.on_grid) for branch in joined]
