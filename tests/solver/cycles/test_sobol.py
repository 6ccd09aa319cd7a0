"""Quasi-random points, against SciPy's to the last bit."""

import numpy as np
import pytest
from scipy.stats import qmc

from stridemap.solver.cycles.sobol import DIMENSIONS, sobol_points

pytestmark = pytest.mark.quick


@pytest.mark.parametrize("dimensions", range(1, DIMENSIONS + 2))
def test_points_are_those_of_scipy(dimensions):
    assert DIMENSIONS == 40
    for m, seed in ((0, [0, 0]), (1, [1, 0]), (9, [0, 0]), (6, [3, 10**6])):
        found = sobol_points(dimensions, m, np.random.default_rng(seed))
        wanted = qmc.Sobol(dimensions, rng=np.random.default_rng(seed)).random_base2(m)
        assert found.dtype == wanted.dtype
        np.testing.assert_array_equal(found, wanted)


def test_the_largest_number_of_starts_that_is_allowed():
    found = sobol_points(3, 20, np.random.default_rng([7, 7]))
    np.testing.assert_array_equal(found, qmc.Sobol(3, rng=np.random.default_rng([7, 7])).random_base2(20))
