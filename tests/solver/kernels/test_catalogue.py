"""Kernels: their sizes, which are known before they are built, and the coefficients of the method."""

import numpy as np
import pytest
from scipy.integrate import DOP853

from stridemap.solver.kernels.catalogue import KERNELS, Catalogue, c_name, search, shapes
from stridemap.solver.kernels.dormand_prince import NODES, STAGES, tableau
from stridemap.solver.model.loading import load

pytestmark = pytest.mark.quick


@pytest.mark.parametrize("name", ["wobbling", "rimless_wheel", "round_feet"])
def test_the_sizes_of_kernels_are_those_of_the_functions_that_are_built(name):
    model = load(name)
    catalogue = Catalogue(model)
    assert list(catalogue) == list(KERNELS) and len(catalogue) == len(KERNELS)
    for kernel, function in catalogue.items():
        known = shapes(model, kernel)
        assert function.name() == c_name(model, kernel)
        assert known.inputs == {function.name_in(i): function.nnz_in(i) for i in range(function.n_in())}
        assert list(known.outputs) == [function.size_out(i) for i in range(function.n_out())]
        assert [a * b for a, b in known.outputs] == [function.nnz_out(i) for i in range(function.n_out())]


def test_whether_there_is_a_kernel_is_known_without_building_it(monkeypatch):
    catalogue = Catalogue(load("compass"))
    monkeypatch.setattr(Catalogue, "_made", None)  # calling it would fail
    assert search(12) in catalogue
    assert search(13) not in catalogue
    with pytest.raises(KeyError):
        catalogue[search(13)]


def test_the_coefficients_are_those_of_scipy():
    stages, end = tableau()
    np.testing.assert_array_equal(stages, DOP853.A[:STAGES, :STAGES])
    np.testing.assert_array_equal(end, DOP853.B)
    np.testing.assert_array_equal(NODES, DOP853.C[:STAGES])
