"""Boundaries from the cells of a map: against special points of branches, and cells against a search."""

import numpy as np
import pytest

import stridemap
from stridemap.solver.boundaries.of_cells import CellSurvey, crosses
from stridemap.solver.boundaries.smooth import SmoothLine
from stridemap.solver.branches.conditions import GaitConditions
from stridemap.solver.branches.plane import Plane, middle_edges
from stridemap.solver.branches.survey import Survey
from stridemap.solver.cycles.gait import is_physical_gait
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.options import ContinuationOptions, SearchOptions

K, ALPHA = np.linspace(5.5, 12.5, 8), np.array([0.24, 0.26, 0.28])
BETWEEN = 0.25
"""A mass ratio between two rows of cells."""


@pytest.fixture(scope="module")
def survey():
    """The plane of springs and mass ratios around group B, from a search of its cells."""
    model = load("wobbling")
    solver = Solver.for_model(model)
    points = np.array([model.point({"k": k, "alpha": a, "omega": 3.0}) for a in ALPHA for k in K])
    orbits = find_all(solver, points, SearchOptions(starts=128))[1]
    gaits = orbits.take(np.flatnonzero(is_physical_gait(orbits)))
    plane = Plane.of_orbits(gaits, ("k", "alpha"), K, ALPHA)
    (left, right), (bottom, top) = middle_edges(K), middle_edges(ALPHA)
    along = Survey(
        solver, points[0], "k", left, right, 1, 0, 1, SearchOptions(), ContinuationOptions(),
        GaitConditions(solver.kernels, None), lambda _: None,
    )  # fmt: skip
    return CellSurvey(
        along, ("k", "alpha"), (left, bottom), (right, top), 1, lambda _: None, False,
        plane=plane, orbits=gaits,
    )  # fmt: skip


@pytest.fixture(scope="module")
def boundaries(survey):
    return survey.boundaries()


def test_there_is_a_boundary_between_cells_of_different_classes(survey, boundaries):
    classes = survey.plane.classes
    assert (
        len(survey.unexplained([]))
        == (classes[:, 1:] != classes[:, :-1]).sum() + (classes[1:] != classes[:-1]).sum()
    )
    assert survey.unexplained(boundaries) == []


def test_boundaries_pass_where_branches_have_their_special_points(survey, boundaries):
    """Between the rows of cells, lines lie where Newton's method finds special points on branches."""
    low, high = survey.low[0], survey.high[0]
    found = stridemap.branches(
        "wobbling", vary="k", range=(low, high), params={"alpha": BETWEEN, "omega": 3.0}, seeds=3
    )
    for boundary in boundaries:
        smooth = SmoothLine.of(boundary)
        line = smooth.points
        y = line[:, 1] - BETWEEN
        for i in np.flatnonzero((y[1:] > 0) != (y[:-1] > 0)).tolist():
            k = np.interp(0.0, np.sort(y[i : i + 2]), line[i : i + 2, 0][np.argsort(y[i : i + 2])])
            at = np.array([one.value for one in found.special if one.type == boundary.type])
            assert np.abs(at - k).min() < 1e-4, (boundary.type, k, at)
            # On a row of cells it is exact beside the middle of a cell, and only there.
            exact = smooth.exact_beside(boundary, k + np.array([-0.5, 0.01, 0.5]), np.array([BETWEEN]))
            (there,) = exact.points[exact.points[:, 1] == BETWEEN]
            assert np.abs(at - there[0]).min() < 1e-8, (boundary.type, there, at)
            assert len(exact.points) == len(exact.is_gait) == len(exact.borders_stable) == len(line) + 1
            assert np.array_equal(np.delete(exact.points, i + 1, axis=0), line)
            far = smooth.exact_beside(boundary, k + np.array([-0.5, 0.5]), np.array([BETWEEN]))
            assert np.array_equal(far.points, line)
    assert {"fold", "pd"} <= {one.type for one in boundaries}


def test_each_is_followed_once(boundaries):
    for number, one in enumerate(boundaries):
        for other in boundaries[:number]:
            if one.type == other.type:
                ends = one.cycles[[0, -1]]
                apart = np.linalg.norm(
                    (ends[:, None] - other.cycles[None]) / one.curve.equations.scale, axis=2
                )
                assert apart.min(axis=1).max() > 1e-4


def test_smooth_lines_pass_through_their_points_and_between_them(boundaries):
    """The middle between two points is compared with the point that Newton's method finds from it."""
    boundary = max(boundaries, key=lambda one: len(one.points))
    line = SmoothLine.of(boundary, parts=2)
    assert np.allclose(line.points[::2], boundary.cycles[:, -2:], rtol=0, atol=1e-12)
    curve = boundary.curve
    for i in range(0, len(boundary.points) - 1, 7):
        one, other = boundary.points[i], boundary.points[i + 1]
        found = curve.corrected((one.x + other.x) / 2, one.tangent, one.n_rk, 10)
        assert found.converged
        nearest = np.linalg.norm(
            (SmoothLine.of(boundary, 50).points - found.x[-2:]) / [60.0, 1.0], axis=1
        ).min()
        assert nearest < 2e-4


def test_flags_of_a_smooth_line_are_those_of_its_points(boundaries):
    for boundary in boundaries:
        line = SmoothLine.of(boundary, parts=3)
        assert line.is_gait[::3].tolist() == boundary.is_gait.tolist()
        assert line.borders_stable[::3].tolist() == boundary.borders_stable.tolist()


def test_pieces_cross_a_segment():
    line = np.array([[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [3.0, 1.0]])
    here, there = np.array([0.0, 0.5]), np.array([2.2, 0.5])
    assert crosses(line, here, there).tolist() == [True, True, False]
    assert crosses(line, here, np.array([3.0, 0.5])).tolist() == [True, True, True]
    assert crosses(line, np.array([0.0, 2.0]), np.array([3.0, 2.0])).tolist() == [False, False, False]
