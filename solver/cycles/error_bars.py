"""The error bars of limit cycles: how far section point, period and multipliers are from the exact ones."""

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Kernels
from stridemap.solver.cycles.errors import Correction, multiplier_error, size
from stridemap.solver.cycles.precise import finer
from stridemap.solver.model.scales import Scales

Array = NDArray[np.float64]


def error_bars(
    kernels: Kernels, n_rk: int, u: Array, params: Array, jacobian: Array, correction: Correction
) -> tuple[Array, Array]:
    """Errors of section points with periods, and of multipliers, shape (m,) each.

    They come from the corrected cycle, corrected once more. The multipliers are compared with those of a
    cycle that is off by the error of the state, rounding included.

    Parameters
    ----------
    kernels : Kernels
    n_rk : int
        RK steps with which the cycles were solved.
    u : ndarray, shape (m, nz + 1)
    params : ndarray, shape (m, n_params)
    jacobian : ndarray, shape (m, nz + 1, nz + 1)
        Derivative of the residual at `u` with `n_rk` RK steps.
    correction : Correction
    """
    scale = Scales.of(kernels.model).unknowns
    change, spread = correction.change, correction.spread
    moved = u + change + spread
    refined, residual = kernels.jacobian(finer(n_rk), moved, params)
    # Without the rounding of the residual: what is left of a quadratic one where it vanishes to first order.
    exact = np.flatnonzero(correction.exact)
    residual[exact] = 0.5 * ((refined - jacobian)[exact] @ change[exact][:, :, None])[:, :, 0]
    again = Correction.of(refined, residual, moved, scale, n_rk)
    rounding = np.where(correction.exact, 0.0, again.rounding)
    second = again.change + spread
    # In a fold itself every correction is half of the one before: what is left is their sum.
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.minimum(size(second, scale) / size(change, scale), 0.6)
    ratio[~(size(change, scale) > 100 * rounding)] = 0.0  # or it is rounding
    rest = 1 / (1 - ratio)
    state = np.hypot(size(change + rest[:, None] * second, scale), rounding)
    return state, rest * multiplier_error(jacobian, refined, scale, n_rk)
