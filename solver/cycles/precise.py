"""Cycles close to a fold, of whose error rounding is much: by residuals to twice the digits."""

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Kernels, Solved, Traced
from stridemap.solver.cycles.errors import Correction, size
from stridemap.solver.kernels.catalogue import CYCLE_N_RK
from stridemap.solver.linear import solved
from stridemap.solver.model.scales import Scales

Array = NDArray[np.float64]

MUCH = 0.05
"""Rounding in terms of a correction from which on it is looked at: its estimate may be a tenth of it."""

TINY = 1.5e-14
"""Rounding that is not looked at, in terms of the scales."""

POLISHES = 3
"""Corrections at most of a cycle that rounding has moved."""

POLISHED = 1e-11
"""A correction that is the last: what is left is less, and is part of the error bar."""


def finer(n_rk: int) -> int:
    """A resolution at which the error is at most a tenth: the next one, or half as many RK steps again."""
    return next((n for n in CYCLE_N_RK if n > n_rk), 3 * n_rk // 2)


def _rough(correction: Correction, scale: Array) -> NDArray[np.intp]:
    """Those of which rounding may be much of the correction."""
    with np.errstate(invalid="ignore"):
        much: NDArray[np.bool_] = correction.rounding > np.maximum(
            MUCH * size(correction.change, scale), TINY
        )
    return np.flatnonzero(much)


def _known(
    kernels: Kernels, n_rk: int, cycles: Solved, params: Array, traced: Traced, whichever: bool = False
) -> Correction:
    """Corrections, with what rounding does to each cycle in the place of what it may do where that is much.

    Of all of them with `whichever`.
    """
    scale = Scales.of(kernels.model).unknowns
    out = Correction.of(cycles.jacobian, traced.residual, cycles.u, scale, 2 * n_rk)
    at = np.arange(len(params)) if whichever else _rough(out, scale)
    change = -solved(cycles.jacobian[at], kernels.precise_residual(finer(n_rk), cycles.u[at], params[at]))
    good = np.isfinite(change).all(axis=1)
    at, change = at[good], change[good]
    out.put(at, Correction(change, np.zeros(len(at)), np.zeros_like(change)))
    return out


def _polished(kernels: Kernels, n_rk: int, u: Array, params: Array, jacobian: Array) -> Array:
    """Solutions without the rounding of their residuals; as they are where that is not to be had."""
    scale, out = Scales.of(kernels.model).unknowns, u.copy()
    open_, last = np.arange(len(u)), np.full(len(u), np.inf)
    for _ in range(POLISHES):
        step = -solved(jacobian[open_], kernels.precise_residual(n_rk, out[open_], params[open_]))
        now = size(step, scale)
        better = now < 0.5 * last[open_]
        out[open_[better]] += step[better]
        last[open_] = now
        open_ = open_[better & (now > POLISHED)]
        if not len(open_):
            break
    return out


def checked(
    kernels: Kernels, n_rk: int, cycles: Solved, params: Array, limit: float
) -> tuple[Solved, Traced, Correction]:
    """Solutions with their traces at twice the resolution, and what these change in them.

    Those that rounding moves by more than a limit are solved without it.

    Parameters
    ----------
    kernels : Kernels
    n_rk : int
        RK steps with which they were solved.
    cycles : Solved
        Of n points.
    params : ndarray, shape (n, n_params)
    limit : float
        In terms of the scales.
    """
    scale = Scales.of(kernels.model).unknowns
    traced = kernels.trace(2 * n_rk, cycles.u, params)
    correction = _known(kernels, n_rk, cycles, params, traced)
    far = np.flatnonzero(correction.exact & (size(correction.change, scale) > limit))
    if not len(far):
        return cycles, traced, correction
    u = _polished(kernels, n_rk, cycles.u[far], params[far], cycles.jacobian[far])
    better = Solved(u, *kernels.jacobian(n_rk, u, params[far]))
    again = kernels.trace(2 * n_rk, u, params[far])
    for whole, part in zip((*cycles, *traced), (*better, *again), strict=True):
        whole[far] = part
    correction.put(far, _known(kernels, n_rk, better, params[far], again, whichever=True))
    return cycles, traced, correction
