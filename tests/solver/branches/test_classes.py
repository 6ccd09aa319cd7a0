"""Classes of points between the cells of a map are those that searches find there."""

import numpy as np
import pytest

from stridemap.solver.branches.classes import classes_at
from stridemap.solver.branches.plane import NO_GROUP, NONE, STABLE, UNSTABLE, Plane
from stridemap.solver.cycles.gait import is_physical_gait

K, ALPHA = np.arange(4.0, 12.1, 1.0), np.array([0.2, 0.25, 0.3])
NAMES = ("k", "alpha")


@pytest.fixture(scope="module")
def gaits(find):
    k, alpha = np.meshgrid(K, ALPHA)
    found = find(k=k.ravel(), alpha=alpha.ravel())
    return found.take(is_physical_gait(found))


@pytest.fixture(scope="module")
def coarse(gaits):
    return Plane.of_orbits(gaits, NAMES, K, ALPHA)


def class_of(orbits):
    return NONE if not len(orbits) else STABLE if orbits.stable.any() else UNSTABLE


def test_cells_are_classified_by_their_cycles(gaits, coarse):
    assert coarse.classes.shape == coarse.groups.shape == (len(ALPHA), len(K))
    for i, alpha in enumerate(ALPHA):
        for j, k in enumerate(K):
            here = gaits.take((gaits.params[:, 1] == alpha) & (gaits.params[:, 0] == k))
            assert coarse.classes[i, j] == class_of(here), (k, alpha)
            letter = here.group[here.spectral_radius.argmin()] if len(here) else None
            assert coarse.groups[i, j] == ("ABCDE".index(letter) if letter else NO_GROUP)
    assert {NONE, UNSTABLE, STABLE} == set(coarse.classes.ravel().tolist())


def test_points_between_cells_are_what_searches_find_there(solver, find, gaits, coarse):
    k, alpha = (axis.ravel() for axis in np.meshgrid(np.arange(4.25, 12, 0.75), [0.21, 0.29]))
    found = find(k=k, alpha=alpha)
    found = found.take(is_physical_gait(found))
    expected = [class_of(found.take((found.params[:, 0] == x) & (found.params[:, 1] == y)))
                for x, y in zip(k, alpha, strict=True)]  # fmt: skip
    assert classes_at(solver, coarse, gaits, k, alpha).tolist() == expected
    assert len(set(expected)) > 1
