"""All cycles at a point of parameter space that close after n walking steps, and not before.

They are looked for by a search of their own: a cycle of several steps need not lie on a branch that leaves a
cycle of one step. Guesses are chains of steps that were really walked: from many section points, the
touchdown is found and the walker put down, n times.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.cycles.acceptance import verdicts
from stridemap.solver.cycles.chain import Chain
from stridemap.solver.cycles.chain_measures import chain_measures
from stridemap.solver.cycles.duplicates import DUPLICATE
from stridemap.solver.cycles.orbits import Orbits, column
from stridemap.solver.cycles.search import find_all, starts
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.cycles.status import FOUND, Status
from stridemap.solver.kernels.catalogue import CYCLE_N_RK
from stridemap.solver.linear import solved
from stridemap.solver.observables.events import Trace
from stridemap.solver.options import SearchOptions

Array = NDArray[np.float64]

NEAR = 0.1
"""Half-width of the cloud of starts about each cycle of one step, as a part of the search box."""

SETTLING = 30
"""Steps that are walked from some of the starts before the guess begins: these settle near what attracts."""


@dataclass(frozen=True)
class _Steps:
    """The step map with its touchdown, on many section points at once."""

    solver: Solver
    n_rk: int
    params: Array
    period_range: tuple[float, float]

    def walk(self, z: Array, period: Array) -> tuple[Array, Array]:
        """Next section points and the periods of the steps there; NaN where no touchdown was found."""
        kernels, u = self.solver.kernels, np.column_stack([z, period])
        params = np.repeat(self.params[None, :], len(u), axis=0)
        low, high = self.period_range
        for _ in range(8):
            jacobian, residual = kernels.jacobian(self.n_rk, u, params)
            with np.errstate(divide="ignore", invalid="ignore"):
                change = residual[:, -1] / jacobian[:, -1, -1]
            u[:, -1] -= np.clip(np.nan_to_num(change, nan=np.inf), -0.3 * high, 0.3 * high)
            u[:, -1] = np.clip(u[:, -1], 0.5 * low, 1.2 * high)
        residual = kernels.residual(self.n_rk, u, params)
        there = u[:, :-1] + residual[:, :-1]
        box = np.array([self.solver.model.spec.search_box[name] for name in self.solver.model.section])
        with np.errstate(invalid="ignore"):
            landed = np.abs(residual[:, -1]) < 1e-8
            landed &= (np.abs(there - box[:, 0]) < 2 * box[:, 1]).all(axis=1)
        there[~landed] = np.nan
        return there, u[:, -1]


def find_chains(
    solver: Solver, point: Array, n_steps: int, options: SearchOptions | None = None
) -> tuple[Array, int]:
    """All cycles of n steps at a point, as unknowns of chains.

    Parameters
    ----------
    solver : Solver
    point : ndarray, shape (n_params,)
    n_steps : int
        At least 2.
    options : SearchOptions, optional

    Returns
    -------
    u : ndarray, shape (m, n_steps * (nz + 1))
        Each begins with its longest step; in order of the whole period.
    n_rk : int
        RK steps per walking step with which they were computed.
    """
    options = (options or SearchOptions()).resolved_for(solver.model)
    _, single = find_all(solver, point[None, :], options)
    chain = Chain(solver.kernels, n_steps)
    longest = np.array([options.period_range[1]])
    n_rk = int(solver.resolution.cycle_n_rk(longest, point[None, :])[0])
    guesses = _guesses(solver, point, n_steps, options, single.u, n_rk)
    params = np.repeat(point[None, :], len(guesses), axis=0)
    return _distinct(chain, chain.newton(n_rk, guesses, params), options.period_range), n_rk


def find_all_of_steps(
    solver: Solver, point: Array, n_steps: int, options: SearchOptions | None = None
) -> Orbits:
    """All limit cycles of n steps at a point, ordered by their whole period.

    Each is refined until its state is accurate, as a cycle of one step is. What closes but is not a gait is
    left out.

    Parameters
    ----------
    solver : Solver
    point : ndarray, shape (n_params,)
    n_steps : int
        At least 2.
    options : SearchOptions, optional
    """
    options = (options or SearchOptions()).resolved_for(solver.model)
    u, n_rk = find_chains(solver, point, n_steps, options)
    chain = Chain(solver.kernels, n_steps)
    parts = [_accepted(solver, chain, one[None, :], point[None, :], n_rk, options) for one in u]
    found = Orbits.concatenate(solver.model, [part for part in parts if part is not None])
    return found.take(np.argsort(found.period, kind="stable"))


def _accepted(
    solver: Solver, chain: Chain, u: Array, params: Array, n_rk: int, options: SearchOptions
) -> Orbits | None:
    """One cycle at the resolution that it needs, measured; None where it is not a gait."""
    limits, model = solver.acceptance, solver.model
    finer = [n for n in CYCLE_N_RK if n > n_rk]
    while True:
        matrix, closing = chain.jacobian(n_rk, u, params)
        u = u - solved(matrix, closing)  # the last correction: near a fold a small residual is not enough
        matrix = chain.jacobian(n_rk, u, params).jacobian
        multipliers = chain.multipliers(matrix)
        measures = chain_measures(chain, [n_rk], u, params, multipliers)
        integration, state = (float(measures[name][0]) for name in ("integration_error", "state_error"))
        if (integration <= limits.target_integration_error and state <= limits.max_state_error) or not finer:
            break
        n_rk = finer.pop(0)
        u = chain.newton(n_rk, u, params)
        if not np.isfinite(u).all():
            return None
    steps = u.reshape(chain.n_steps, -1)
    each = np.repeat(params, chain.n_steps, axis=0)
    trace = Trace.of(solver.kernels, steps, each, solver.kernels.trace(2 * n_rk, steps, each))
    accurate = np.full(chain.n_steps, integration < limits.max_integration_error)
    codes = verdicts(trace, options.period_range, accurate, limits)
    if not np.isin(codes, FOUND).all():
        return None
    good = state < limits.max_state_error and (codes == Status.CONVERGED.code).all()
    status = Status.CONVERGED if good else Status.INACCURATE
    width = chain.width
    return Orbits(
        model,
        params,
        np.append(steps[0, :-1], steps[:, -1].sum())[None, :],
        np.array([status.code]),
        np.full((1, width, width), np.nan),
        multipliers,
        {name: column(model.measured[name], values, 1) for name, values in measures.items()},
        steps=steps[None, :, :],
    )


def _guesses(
    solver: Solver, point: Array, n_steps: int, options: SearchOptions, single: Array, n_rk: int
) -> Array:
    """Chains of steps from many starts: over the whole search box, and about the cycles of one step."""
    model, n = solver.model, options.starts
    wide = starts(model, options)
    around = np.empty((0, wide.shape[1]))
    if len(single):
        cloud = starts(model, replace(options, seed=options.seed + 1))
        middle = np.array([model.spec.search_box[name][0] for name in model.section])
        offset = np.column_stack([cloud[:, :-1] - middle, np.zeros(n)])
        around = single[np.arange(n) % len(single)] + NEAR * offset
    search_n_rk = int(solver.resolution.search_n_rk(np.array([options.period_range[1]]), point[None, :])[0])
    steps = _Steps(solver, search_n_rk, point, options.period_range)
    begin = np.concatenate([wide, around])
    begin = np.concatenate([begin, _settled(steps, around)])
    z, period, columns = begin[:, :-1], begin[:, -1], []
    for _ in range(n_steps):
        there, period = steps.walk(z, period)
        columns.append(np.column_stack([z, period]))
        z = there
    whole = np.stack(columns, axis=1)
    good = np.isfinite(whole).all(axis=(1, 2)) & np.isfinite(z).all(axis=1)
    return whole[good].reshape(good.sum(), -1)


def _settled(steps: _Steps, begin: Array) -> Array:
    """Where walks from some starts are after many steps; those that fell are left out."""
    z, period = begin[:, :-1], begin[:, -1]
    for _ in range(SETTLING):
        z, period = steps.walk(z, period)
        good = np.isfinite(z).all(axis=1)
        z, period = z[good], period[good]
        if not len(z):
            break
    return np.column_stack([z, period])


def _distinct(chain: Chain, u: Array, period_range: tuple[float, float]) -> Array:
    """Solutions that close after all steps and not before, each once, whichever step it began with."""
    n, width = chain.n_steps, chain.width
    u = u[np.isfinite(u).all(axis=1)].reshape(-1, n, width)
    periods = u[:, :, -1]
    u = u[((periods > period_range[0]) & (periods <= period_range[1])).all(axis=1)]
    for part in range(1, n):
        if n % part == 0:  # it closes after `part` steps already
            u = u[np.abs(u - np.roll(u, part, axis=1)).max(axis=(1, 2)) > 100 * DUPLICATE]
    kept: list[Array] = []
    for one in u[np.argsort(u[:, :, -1].sum(axis=1), kind="stable")]:
        turned = np.roll(one, -int(one[:, -1].argmax()), axis=0)
        if all(
            min(np.abs(np.roll(turned, k, axis=0) - other).max() for k in range(n)) > DUPLICATE
            for other in kept
        ):
            kept.append(turned)
    return np.array(kept).reshape(len(kept), n * width)
