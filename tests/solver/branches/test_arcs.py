"""Arclength steps of many branches: in C++, several at a time, they are those of NumPy."""

import ctypes
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.backends.lanes import Lanes
from stridemap.solver.branches import arcs as arcs_module
from stridemap.solver.branches import arcs_in_lanes
from stridemap.solver.branches.arcs import Arcs, Lines
from stridemap.solver.branches.arcs_in_lanes import arcs_for
from stridemap.solver.branches.heads import Heads
from stridemap.solver.branches.stops import Stops
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.options import IN_SWEEPS_OF_CYCLES
from tests.oracles.kernels import needs_compiler

pytestmark = needs_compiler

RANGES = {
    "wobbling": ("k", 0.5, 60.0, (0.3, 3.0)),
    "compass": ("omega", 2.0, 4.0, (0.3, 3.0)),
    "goswami_compass": ("slope", 0.01, 0.09, (0.3, 3.0)),
}


def beginnings(name, values=8, backend=None):
    """Lines along one parameter, all cycles at some of its values as points on them, and tangents there."""
    model = load(name)
    parameter, low, high, _ = RANGES[name]
    solver = Solver.for_model(model, backend)
    at = np.linspace(low, high, values + 2)[1:-1]
    points = np.array([model.point({parameter: value}) for value in at])
    cell, cycles = find_all(Solver.for_model(model), points)
    first, last = (np.tile(model.point({parameter: end}), (len(cell), 1)) for end in (low, high))
    lines = Lines(solver, first, last)
    x = np.column_stack([cycles.u, (at[cell] - low) / (high - low)])
    return lines, x, lines.tangents(x)[0]


def arcs(kind, name, lines, x, tangent, options=IN_SWEEPS_OF_CYCLES, known=0):
    """What takes arclength steps; so many of the points are known and no beginnings."""
    stops = Stops(x, lines.number, lines.scale)
    return kind(lines, options, RANGES[name][3], stops, tangent[: len(x) - known])


def heads_at(x, tangent, options=IN_SWEEPS_OF_CYCLES, ways=(1, -1)):
    """Branches that set out both ways."""
    ds, number = np.full(len(x), options.ds), np.arange(len(x))
    return Heads.concatenate([Heads.beginning(number, way > 0, x, way * tangent, ds) for way in ways])


@pytest.mark.parametrize("corrections", [IN_SWEEPS_OF_CYCLES.max_corrections, 1])
@pytest.mark.parametrize("limits", [{}, {"SIDEWAYS": 1e-6}, {"CORRECTION_RATIO": 0.01}], ids=str)
@pytest.mark.parametrize("name", RANGES)
def test_steps_in_lanes_are_those_one_by_one(name, limits, corrections, monkeypatch):
    """From the same points, all along the branches: they are good or not, as long, and end alike."""
    lines, x, tangent = beginnings(name)
    for limit, value in limits.items():
        monkeypatch.setattr(arcs_module, limit, value)
    options = replace(IN_SWEEPS_OF_CYCLES, max_corrections=corrections)
    one, many = (arcs(kind, name, lines, x, tangent, options, len(x) // 4) for kind in (Arcs, arcs_for))
    assert type(one) is not type(many)
    heads, met, refused, ended = heads_at(x, tangent), set(), 0, 0
    for _ in range(120):
        these, those = (each.taken(heads, 1) for each in (one, many))
        for column in ("branch", "ahead", "steps"):
            np.testing.assert_array_equal(getattr(these.heads, column), getattr(those.heads, column))
        np.testing.assert_array_equal(these.passed.branch, those.passed.branch)
        np.testing.assert_array_equal(these.passed.ahead, those.passed.ahead)
        assert set(these.met.tolist()) == set(those.met.tolist())
        for column in ("x", "tangent"):
            both = (getattr(each.passed, column) / lines.scale for each in (these, those))
            np.testing.assert_allclose(*both, rtol=0, atol=1e-6)
        for column in ("bend", "ds", "idle"):
            both = (getattr(each.heads, column) for each in (these, those))
            np.testing.assert_allclose(*both, rtol=1e-5, atol=1e-5)
        met |= set(these.met.tolist())
        refused += len(heads) - len(these.passed.x)
        ended += len(heads) - len(these.heads)
        heads = these.heads
        if not len(heads):
            break
    assert ended or limits
    if name == "wobbling":  # where branches meet one another, and turn sharply
        assert met
        assert refused > 5


def test_a_round_is_so_many_steps_failed_ones_included():
    lines, x, tangent = beginnings("wobbling")
    whole = arcs(arcs_for, "wobbling", lines, x, tangent).taken(heads_at(x, tangent), 8)
    single = arcs(arcs_for, "wobbling", lines, x, tangent)
    heads, points = heads_at(x, tangent), []
    for _ in range(8):
        heads, passed, _ = single.taken(heads, 1)
        points.append(passed)
    for branch in range(len(x)):
        for ahead in (True, False):
            some = np.concatenate([one.x[(one.branch == branch) & (one.ahead == ahead)] for one in points])
            here = (whole.passed.branch == branch) & (whole.passed.ahead == ahead)
            np.testing.assert_array_equal(some, whole.passed.x[here])
    for column in ("branch", "x", "idle", "steps"):
        np.testing.assert_array_equal(getattr(whole.heads, column), getattr(heads, column))
    assert (whole.heads.steps == 8).all()


def test_options_end_branches():
    """After so many steps, and where they would have to be shorter than allowed."""
    lines, x, tangent = beginnings("wobbling")
    for kind in (Arcs, arcs_for):
        few = replace(IN_SWEEPS_OF_CYCLES, max_steps=3)
        done = arcs(kind, "wobbling", lines, x, tangent, few).taken(heads_at(x, tangent, ways=(1,)), 8)
        assert not len(done.heads)
        assert np.bincount(done.passed.branch).max() == 3
        long = replace(IN_SWEEPS_OF_CYCLES, ds=0.4, ds_min=0.4)
        heads = heads_at(x, tangent, long, ways=(1,))
        done = arcs(kind, "wobbling", lines, x, tangent, long).taken(heads, 8)
        assert np.bincount(done.passed.branch, minlength=len(x)).min() == 0
        assert (done.heads.ds == 0.4).all()


def test_a_branch_depends_neither_on_others_nor_on_the_number_of_lanes():
    lines, x, tangent = beginnings("wobbling")
    all_ = arcs(arcs_for, "wobbling", lines, x, tangent).taken(heads_at(x, tangent), 8)
    for branch in range(0, len(x), 5):
        head = heads_at(x, tangent, ways=(1,)).take(np.array([branch]))
        alone = arcs(arcs_for, "wobbling", lines, x, tangent).taken(head, 8)
        here = (all_.passed.branch == branch) & all_.passed.ahead
        np.testing.assert_array_equal(alone.passed.x, all_.passed.x[here])
        np.testing.assert_array_equal(alone.passed.tangent, all_.passed.tangent[here])
    narrow, *_ = beginnings("wobbling", backend=Lanes(instructions=()))
    other = arcs(arcs_for, "wobbling", narrow, x, tangent).taken(heads_at(x, tangent), 8)
    for column in ("branch", "x", "tangent"):
        np.testing.assert_array_equal(getattr(other.passed, column), getattr(all_.passed, column))


def test_what_is_not_a_number_ends_and_spoils_nothing():
    lines, x, tangent = beginnings("wobbling")
    bad = x.copy()
    bad[::3] = np.nan
    for kind in (Arcs, arcs_for):
        some = arcs(kind, "wobbling", lines, x, tangent).taken(heads_at(bad, tangent), 4).passed
        all_ = arcs(kind, "wobbling", lines, x, tangent).taken(heads_at(x, tangent), 4).passed
        good = all_.branch % 3 != 0
        assert set(some.branch.tolist()) == set(all_.branch[good].tolist())
        if kind is arcs_for:
            np.testing.assert_array_equal(some.x, all_.x[good])


def test_what_python_fills_is_what_the_library_reads():
    lockstep = arcs_in_lanes.prepared(Lanes().kernels(load("compass")))
    size = lockstep.library.lockstep_arcs_size
    assert size(0) == ctypes.sizeof(arcs_in_lanes._Course)
    assert size(1) == ctypes.sizeof(arcs_in_lanes._Heads)


def test_the_library_is_looked_up_once(monkeypatch):
    """Not in the middle of a sweep, when a compiler may be gone."""
    kernels = Lanes().kernels(load("compass"))
    first = arcs_in_lanes.prepared(kernels)
    monkeypatch.setattr(Path, "read_text", None)
    assert arcs_in_lanes.prepared(kernels) is first


def test_without_lanes_steps_are_taken_in_numpy():
    lines, x, tangent = beginnings("compass", 2, Interpreter())
    assert type(arcs(arcs_for, "compass", lines, x, tangent)) is Arcs
