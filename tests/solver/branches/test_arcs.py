"""Arclength steps of many branches: in C++, several at a time, they are those of NumPy."""

from dataclasses import replace

import numpy as np
import pytest

from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.backends.lanes import Lanes
from stridemap.solver.branches.arcs import Arcs, Lines
from stridemap.solver.branches.arcs_in_lanes import arcs_for
from stridemap.solver.branches.heads import Heads
from stridemap.solver.branches.stops import Stops
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.options import IN_SWEEPS_OF_CYCLES

RANGES = {
    "wobbling": ("k", 0.5, 60.0, (0.3, 3.0)),
    "compass": ("omega", 2.0, 4.0, (0.3, 3.0)),
    "goswami_compass": ("slope", 0.01, 0.09, (0.3, 3.0)),
}


def beginnings(name, values=8, backend=None):
    """Lines along one parameter with all cycles at some of its values: a solver, lines, points, tangents."""
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


def arcs(kind, name, lines, x, tangent, options=IN_SWEEPS_OF_CYCLES):
    stops = Stops(x, lines.number, lines.scale)
    return kind(lines, options, RANGES[name][3], stops, tangent)


def heads_at(x, tangent, options=IN_SWEEPS_OF_CYCLES):
    return Heads.beginning(np.arange(len(x)), True, x, tangent, np.full(len(x), options.ds))


@pytest.mark.parametrize("corrections", [IN_SWEEPS_OF_CYCLES.max_corrections, 1])
@pytest.mark.parametrize("name", RANGES)
def test_steps_in_lanes_are_those_one_by_one(name, corrections):
    """From the same points, all along the branches: they are good or not, as long, and end alike."""
    lines, x, tangent = beginnings(name)
    options = replace(IN_SWEEPS_OF_CYCLES, max_corrections=corrections)
    one, lanes = (arcs(kind, name, lines, x, tangent, options) for kind in (Arcs, arcs_for))
    assert type(one) is not type(lanes)
    heads, met, refused, ended = heads_at(x, tangent), set(), 0, 0
    for _ in range(120):
        heads = one.going(heads)
        if not len(heads):
            break
        these, those = (each.taken(heads, 1) for each in (one, lanes))
        np.testing.assert_array_equal(these.heads.branch, those.heads.branch)
        np.testing.assert_array_equal(these.passed.branch, those.passed.branch)
        np.testing.assert_array_equal(these.heads.steps, those.heads.steps)
        assert set(these.met.tolist()) == set(those.met.tolist())
        for column in ("x", "tangent", "bend", "ds", "idle"):
            np.testing.assert_allclose(
                getattr(these.heads, column), getattr(those.heads, column), rtol=1e-6, atol=1e-7
            )
        np.testing.assert_allclose(these.passed.x, those.passed.x, rtol=0, atol=1e-9)
        np.testing.assert_allclose(these.passed.tangent, those.passed.tangent, rtol=0, atol=1e-7)
        met |= set(these.met.tolist())
        refused += len(heads) - len(these.passed.x)
        ended += (these.heads.ds == 0).sum()
        heads = these.heads
    assert ended
    if name == "wobbling":  # where branches meet one another, and turn sharply
        assert met
        assert refused > 5


def test_a_round_is_so_many_steps_failed_ones_included():
    lines, x, tangent = beginnings("wobbling")
    whole = arcs(arcs_for, "wobbling", lines, x, tangent).taken(heads_at(x, tangent), 8)
    single = arcs(arcs_for, "wobbling", lines, x, tangent)
    heads, points = heads_at(x, tangent), []
    for _ in range(8):
        heads, passed, _ = single.taken(single.going(heads), 1)
        points.append(passed)
    for branch in range(len(x)):
        some = np.concatenate([one.x[one.branch == branch] for one in points])
        np.testing.assert_array_equal(some, whole.passed.x[whole.passed.branch == branch])
    left = single.going(heads)
    row = np.flatnonzero(np.isin(whole.heads.branch, left.branch))
    np.testing.assert_array_equal(whole.heads.take(row).x, left.x)
    np.testing.assert_array_equal(whole.heads.take(row).idle, left.idle)
    assert (whole.heads.steps <= 8).all()


def test_options_end_branches():
    """After so many steps, and where they would have to be shorter than allowed."""
    lines, x, tangent = beginnings("wobbling")
    for kind in (Arcs, arcs_for):
        few = replace(IN_SWEEPS_OF_CYCLES, max_steps=3)
        done = arcs(kind, "wobbling", lines, x, tangent, few).taken(heads_at(x, tangent), 8)
        assert done.heads.steps.max(initial=0) <= 3
        assert np.bincount(done.passed.branch).max() == 3
        long = replace(IN_SWEEPS_OF_CYCLES, ds=0.4, ds_min=0.4)
        done = arcs(kind, "wobbling", lines, x, tangent, long).taken(heads_at(x, tangent, long), 8)
        short = done.heads.take(done.heads.ds < 0.4)
        assert not len(arcs(kind, "wobbling", lines, x, tangent, long).going(short))
        assert np.bincount(done.passed.branch, minlength=len(x)).min() == 0


def test_a_branch_does_not_depend_on_others_nor_on_the_processor():
    lines, x, tangent = beginnings("wobbling")
    all_ = arcs(arcs_for, "wobbling", lines, x, tangent).taken(heads_at(x, tangent), 8)
    for branch in range(0, len(x), 5):
        head = heads_at(x, tangent).take(np.array([branch]))
        alone = arcs(arcs_for, "wobbling", lines, x, tangent).taken(head, 8)
        here = all_.passed.branch == branch
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


def test_without_lanes_steps_are_taken_in_numpy():
    lines, x, tangent = beginnings("compass", 2, Interpreter())
    assert type(arcs(arcs_for, "compass", lines, x, tangent)) is Arcs
