"""What every backend offers: named results in their natural order, and shapes that are checked."""

import numpy as np
import pytest

from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.backends.lanes import Lanes
from stridemap.solver.backends.selection import load_kernels
from stridemap.solver.kernels import catalogue
from stridemap.solver.kernels.step_map import StepMap
from stridemap.solver.model.loading import load

pytestmark = pytest.mark.quick


def test_inputs_of_a_wrong_shape_are_refused():
    kernels = Interpreter().kernels(load("compass"))
    with pytest.raises(ValueError, match=r"trace_48: input p has shape \(3, 5\), not \(3, 6\)"):
        kernels.trace(48, np.zeros((3, 4)), np.zeros((3, 5)))


def test_no_points_are_mapped_to_no_points():
    model = load("compass")
    traced = load_kernels(model, None).trace(48, np.zeros((0, 4)), np.zeros((0, 6)))
    assert (traced.w.shape, traced.residual.shape) == ((0, 49, 5), (0, 4))
    assert load_kernels(model, None).jacobian(24, np.zeros((0, 4)), np.zeros((0, 6))).jacobian.shape == (
        0,
        4,
        4,
    )


def test_results_are_named_and_matrices_are_row_by_row():
    """Against CasADi's own matrices: entry [i, j] is the derivative of residual i with respect to u_j."""
    model = load("compass")
    p, u = model.point({}), np.array([0.09, -0.17, -0.003, 1.2])
    kernels = Interpreter().kernels(model)
    wanted, closing = (m.full() for m in StepMap(model).jacobian(24)(u, p))
    assert np.abs(wanted - wanted.T).max() > 0.1  # or rows and columns would not differ
    found = kernels.jacobian(24, u[None], p[None])
    np.testing.assert_array_equal(found.jacobian[0], wanted)
    np.testing.assert_array_equal(found.residual[0], closing.ravel())
    np.testing.assert_allclose(kernels.residual(24, u[None], p[None])[0], closing.ravel(), rtol=0, atol=1e-14)
    size = 1e-6
    for j, e in enumerate(np.eye(4)):
        ahead, behind = (kernels.residual(24, (u + s * size * e)[None], p[None])[0] for s in (1, -1))
        np.testing.assert_allclose(wanted[:, j], (ahead - behind) / (2 * size), rtol=0, atol=1e-7)
    solved = kernels.limit_cycle(24, u[None], p[None])
    np.testing.assert_allclose(solved.residual, 0, atol=1e-13)
    again = kernels.jacobian(24, solved.u, p[None])
    np.testing.assert_array_equal(solved.jacobian, again.jacobian)
    rough = kernels.search(12, u[None], p[None])
    np.testing.assert_allclose(rough.u, solved.u, rtol=0, atol=1e-5)


def test_backends_are_values():
    assert Lanes() == Lanes()
    assert Lanes("gcc") != Lanes()
    assert hash(Interpreter()) == hash(Interpreter())
    assert load_kernels(load("compass"), Interpreter()) is load_kernels(load("compass"), Interpreter())
    assert load_kernels(load("compass"), Interpreter()).backend == Interpreter()


def test_kernels_have_names_in_c():
    assert [k.name for k in (catalogue.search(12), catalogue.trace(48), catalogue.ADVANCE)] == [
        "search_12", "trace_48", "advance",
    ]  # fmt: skip
