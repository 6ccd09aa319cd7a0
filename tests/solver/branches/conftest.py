"""Limit cycles of the wobbling walker over a range of springs, on either side of a gap."""

from dataclasses import dataclass

import numpy as np
import pytest

from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.options import SearchOptions


@dataclass(frozen=True)
class Line:
    """Cycles at every value of `k`, ordered by `k` and period."""

    k: np.ndarray
    orbits: Orbits


@pytest.fixture(scope="session")
def solver():
    return Solver.for_model(load("wobbling"))


@pytest.fixture(scope="session")
def find(solver):
    """Every cycle at one or several values of parameters, from fresh starts at each."""

    def found(starts=48, **values):
        rows = [dict(zip(values, row, strict=True)) for row in np.broadcast(*values.values())]
        points = np.array([solver.model.point(row) for row in rows])
        return find_all(solver, points, SearchOptions(starts=starts))[1]

    return found


@pytest.fixture(scope="session")
def line(find):
    """Group A ends in a fold below k = 4.5, group B begins in one below k = 6 and is stable at first."""
    k = np.arange(3.5, 12.1, 0.5)
    return Line(k, find(k=k))
