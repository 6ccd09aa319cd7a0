"""Regions between curves that are known: areas in closed form, cells on their sides, what is too narrow."""

import numpy as np
import pytest

from stridemap.paper.drawings.raster import extent
from stridemap.paper.drawings.regions import UNKNOWN, Regions
from stridemap.solver.branches.plane import NONE, STABLE, UNSTABLE, Plane

GRID = (np.arange(20) + 0.5) / 20
"""Middles of 20 cells from 0 to 1."""


def plane_of(classes):
    """A plane of the unit square whose cells are of the class that a function gives at their middles."""
    x, y = np.meshgrid(GRID, GRID)
    found = classes(x, y)
    return Plane(("a", "b"), GRID, GRID, found, np.full(found.shape, -1))


def area(polygons):
    """By the shoelace formula."""
    total = 0.0
    for x, y in (one.T for one in polygons):
        total += abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) / 2
    return total


def circle(radius, n=2000):
    angle = np.linspace(0, 2 * np.pi, n)
    return np.column_stack([0.5 + radius * np.cos(angle), 0.5 + radius * np.sin(angle)])


def nothing(x, y):
    raise AssertionError("every region holds a cell")


def test_rings_have_their_areas():
    def classes(x, y):
        r = np.hypot(x - 0.5, y - 0.5)
        return np.where(r < 0.2, STABLE, np.where(r < 0.4, UNSTABLE, NONE))

    plane = plane_of(classes)
    assert extent(plane) == pytest.approx((0, 1, 0, 1))
    regions = Regions.between([circle(0.2), circle(0.4)], plane, (0.0, 1.0, 0.0, 1.0))
    found = regions.classes(plane, lambda x, y: classes(x, y))
    assert not len(regions.on_the_other_side(plane, found))
    inner, outer = np.pi * 0.2**2, np.pi * 0.4**2
    assert area(regions.polygons(found, STABLE)) == pytest.approx(inner, abs=1e-4)
    assert area(regions.polygons(found, UNSTABLE)) == pytest.approx(outer - inner, abs=1e-4)
    assert area(regions.polygons(found, NONE)) == pytest.approx(1 - outer, abs=1e-4)


def test_where_curves_cross_nothing_is_left_out():
    """Four regions of a cross, of which two that touch in a point are of one class."""
    lines = [np.array([[-0.1, -0.1], [1.1, 1.1]]), np.array([[-0.1, 1.1], [1.1, -0.1]])]
    plane = plane_of(lambda x, y: np.where(np.abs(x - 0.5) > np.abs(y - 0.5), STABLE, UNSTABLE))
    regions = Regions.between(lines, plane, (0.0, 1.0, 0.0, 1.0))
    found = regions.classes(plane, lambda x, y: np.where(np.abs(x - 0.5) > np.abs(y - 0.5), STABLE, UNSTABLE))
    assert area(regions.polygons(found, STABLE)) == pytest.approx(0.5, abs=1e-4)
    assert area(regions.polygons(found, UNSTABLE)) == pytest.approx(0.5, abs=1e-4)


def test_a_curve_that_separates_nothing_is_not_an_edge():
    plane = plane_of(lambda x, y: np.where(x < 0.6, STABLE, NONE))
    across = [np.array([[0.6, -0.1], [0.6, 1.1]]), np.array([[0.31, -0.1], [0.29, 1.1]])]
    regions = Regions.between(across, plane, (0.0, 1.0, 0.0, 1.0))
    found = regions.classes(plane, nothing)
    (one,) = regions.polygons(found, STABLE)
    assert area([one]) == pytest.approx(0.6, abs=1e-9)
    assert set(np.round(one[:, 0], 12)) == {0.0, 0.6}


def test_a_cell_on_the_other_side_is_found():
    plane = plane_of(lambda x, y: np.where(x < 0.6, STABLE, NONE))
    plane.classes[7, 3] = UNSTABLE
    regions = Regions.between([np.array([[0.6, -0.1], [0.6, 1.1]])], plane, (0.0, 1.0, 0.0, 1.0))
    assert regions.on_the_other_side(plane, regions.classes(plane, nothing)).tolist() == [[7, 3]]


def test_a_region_without_a_cell_is_asked_for_where_it_is_widest():
    """Between x = 0.503 and 0.507 there is no middle of a cell; the sliver beside it cannot be seen."""
    plane = plane_of(lambda x, y: np.where(x < 0.5, STABLE, NONE))
    lines = [np.array([[at, -0.1], [at, 1.1]]) for at in (0.503, 0.507, 0.50701)]
    asked = []

    def elsewhere(x, y):
        asked.extend(x.tolist())
        return np.full(len(x), UNSTABLE)

    regions = Regions.between(lines, plane, (0.0, 1.0, 0.0, 1.0))
    found = regions.classes(plane, elsewhere)
    assert asked == pytest.approx([0.505])
    assert found.tolist() == [STABLE, UNSTABLE, UNKNOWN, NONE]
    assert area(regions.polygons(found, UNSTABLE)) == pytest.approx(0.004, abs=1e-9)


def test_without_curves_there_is_one_region():
    plane = plane_of(lambda x, y: np.full(x.shape, UNSTABLE))
    regions = Regions.between([], plane, (0.0, 1.0, 0.0, 1.0))
    assert regions.count == 1
    assert area(regions.polygons(regions.classes(plane, nothing), UNSTABLE)) == pytest.approx(1)
