"""What is measured on cycles of several walking steps: each step is traced, and their measures add up."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.cycles.chain import Chain
from stridemap.solver.cycles.errors import differences, size
from stridemap.solver.kernels.resolution import distinct
from stridemap.solver.linear import solved
from stridemap.solver.model.scales import Scales
from stridemap.solver.observables.events import Trace
from stridemap.solver.observables.measures import Cycles, measured
from stridemap.solver.observables.over_steps import over_steps

Array = NDArray[np.float64]


def chain_measures(
    chain: Chain, n_rk: Sequence[int], u: Array, params: Array, multipliers: NDArray[np.complex128]
) -> dict[str, Any]:
    """Every measured quantity of cycles of n steps, by name.

    Parameters
    ----------
    chain : Chain
    n_rk : sequence of int, length m
        RK steps per walking step with which the cycles were computed; they are traced with twice as many.
    u : ndarray, shape (m, n_steps * (nz + 1))
    params : ndarray, shape (m, n_params)
    multipliers : ndarray of complex, shape (m, nz)

    Returns
    -------
    dict of str to ndarray, shape (m,), or None
        None where the model lacks a quantity, or where it is not defined for several steps.
    """
    resolution, model, n = np.asarray(n_rk), chain.kernels.model, chain.n_steps
    parts, places = [], []
    for each in distinct(resolution):
        at = np.flatnonzero(resolution == each)
        steps = u[at].reshape(len(at) * n, -1)
        point = np.repeat(params[at], n, axis=0)
        traced = chain.kernels.trace(2 * each, steps, point)
        residual, integration, state, multiplier = (
            np.repeat(one, n) for one in _errors(chain, each, u[at], params[at], multipliers[at])
        )
        cycles = Cycles(
            model,
            point,
            steps,
            np.repeat(multipliers[at], n, axis=0),
            residual,
            integration,
            state,
            multiplier,
            Trace.of(chain.kernels, steps, point, traced),
        )
        values = measured(cycles)
        if n > 1:
            values = over_steps(model.measured, values, steps[:, -1].reshape(-1, n), n)
        parts.append(values)
        places.append(at)
    back = np.argsort(np.concatenate(places), kind="stable")
    return {
        name: None if parts[0][name] is None else np.concatenate([part[name] for part in parts])[back]
        for name in parts[0]
    }


def _errors(
    chain: Chain, n_rk: int, u: Array, params: Array, multipliers: NDArray[np.complex128]
) -> tuple[Array, Array, Array, Array]:
    """Residuals, and errors of integration, state and multipliers, shape (m,) each, in the model's scales."""
    scales = Scales.of(chain.kernels.model)
    unknowns, entries = np.tile(scales.unknowns, chain.n_steps), np.tile(scales.residual, chain.n_steps)
    coarse, closing = chain.jacobian(n_rk, u, params)
    finer = chain.residual(2 * n_rk, u, params)
    change = solved(coarse, -finer)
    refined = chain.jacobian(2 * n_rk, u + np.nan_to_num(change), params).jacobian
    return (
        size(closing, entries),
        size(finer - closing, entries),
        size(change, unknowns),
        differences(multipliers, chain.multipliers(refined)),
    )
