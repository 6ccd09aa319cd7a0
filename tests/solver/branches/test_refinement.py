"""A map made finer: its given cells are kept, and its edges run where searches at each cell find them."""

import numpy as np
import pytest

from stridemap.solver.branches.plane import NO_GROUP, NONE, STABLE, UNSTABLE, Plane
from stridemap.solver.branches.refinement import refined
from stridemap.solver.cycles.gait import is_physical_gait
from stridemap.solver.cycles.orbits import Orbits

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


@pytest.fixture(scope="module")
def fine(solver, gaits, coarse):
    return refined(solver, coarse, gaits, 2)


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


def test_the_axes_are_halved(fine):
    np.testing.assert_allclose(fine.x, np.arange(4.0, 12.1, 0.25), rtol=1e-15)
    np.testing.assert_allclose(fine.y, np.linspace(0.2, 0.3, 9), rtol=1e-15)
    assert fine.classes.shape == fine.groups.shape == (9, 33)
    assert fine.names == NAMES


def test_given_cells_are_kept(coarse, fine):
    np.testing.assert_array_equal(fine.classes[::4, ::4], coarse.classes)
    np.testing.assert_array_equal(fine.groups[::4, ::4], coarse.groups)


def test_edges_run_where_searches_find_them(fine, find):
    row = 3
    edges = np.flatnonzero(fine.classes[row, 1:] != fine.classes[row, :-1])
    cells = sorted({*edges.tolist(), *(edges + 1).tolist()})
    assert len(cells) >= 4
    found = find(k=fine.x[cells], alpha=fine.y[row], starts=256)
    found = found.take(is_physical_gait(found))
    for j in cells:
        assert fine.classes[row, j] == class_of(found.take(found.params[:, 0] == fine.x[j])), fine.x[j]


def test_a_map_without_edges_is_computed_nowhere(solver, gaits):
    inner = gaits.take(gaits.stable & (gaits.params[:, 0] >= 7) & (gaits.params[:, 0] <= 9))
    plane = Plane.of_orbits(inner, NAMES, K[3:6], ALPHA)
    assert (plane.classes == STABLE).all()
    fine = refined(_Idle(solver), plane, inner, 2)
    assert fine.classes.shape == (9, 9)
    assert (fine.classes == STABLE).all()
    assert (fine.groups == 1).all()


def test_no_cycles(solver):
    nothing = Orbits.empty(solver.model)
    fine = refined(_Idle(solver), Plane.of_orbits(nothing, NAMES, K, ALPHA), nothing, 1)
    assert fine.classes.shape == (5, 17)
    assert (fine.classes == NONE).all() and (fine.groups == NO_GROUP).all()


def test_cycles_of_several_planes_are_refused(solver, gaits, coarse, find):
    both = Orbits.concatenate(solver.model, [gaits, find(k=8.0, omega=2.5)])
    with pytest.raises(ValueError, match="of k and alpha must agree in all others"):
        refined(solver, coarse, both, 1)


class _Idle:
    """A solver of the same model that cannot search."""

    def __init__(self, solver):
        self.model = solver.model
