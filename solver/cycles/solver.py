"""Limit cycles from guesses, on arrays of points: Newton's method, refinement, acceptance."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Backend, Kernels, Searched
from stridemap.solver.backends.selection import load_kernels
from stridemap.solver.cycles.acceptance import Candidates, depends_on_resolution
from stridemap.solver.cycles.batches import batches
from stridemap.solver.cycles.duplicates import first_of_each
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.kernels.catalogue import CYCLE_N_RK, FINE_N_RK, NEARLY, SEARCH_RESIDUAL
from stridemap.solver.kernels.dormand_prince import ORDER
from stridemap.solver.kernels.resolution import Resolution, coarsest, distinct
from stridemap.solver.linear import solved
from stridemap.solver.model.model import Model
from stridemap.solver.model.scales import Scales
from stridemap.solver.options import AcceptanceOptions

Array = NDArray[np.float64]

Mask = NDArray[np.bool_]

POLISHES, USES, POLISHED, NEAR, FAR = 12, 2, 1e-6, 0.05, 20.0
"""Newton steps from a good guess at most, and those with one derivative; and sizes of a step, in terms of the
scales, after which no other is needed, the derivative is good for another one, and none helps."""

FAR_AHEAD = 1.0
"""How far a tangent is followed at most, in terms of the scales."""

SAME_END = 0.02
"""Distance, in terms of the scales, of two ends of a search that do not close, if they are taken for one."""


class Ended(NamedTuple):
    """How Newton's method from rough guesses ended.

    Section points with periods, shape (n, nz + 1); whether it closed in a possible step, in one that is not
    (a walker that hangs, walks backwards or falls over), or not at all, shape (n,) each.
    """

    u: Array
    closed: Mask
    impossible: Mask
    open: Mask


@dataclass(frozen=True)
class Solver:
    """Finds limit cycles of one model.

    Parameters
    ----------
    model : Model
    kernels : Kernels
    acceptance : AcceptanceOptions
    """

    model: Model
    kernels: Kernels
    acceptance: AcceptanceOptions = field(default_factory=AcceptanceOptions)

    @classmethod
    def for_model(
        cls, model: Model, backend: Backend | None = None, acceptance: AcceptanceOptions | None = None
    ) -> "Solver":
        """The solver of a model with its kernels on a backend, by default the fastest that there is."""
        return cls(model, load_kernels(model, backend), acceptance or AcceptanceOptions())

    @cached_property
    def resolution(self) -> Resolution:
        """Chooses how many RK steps a step of the walker gets."""
        return Resolution(self.model)

    def search(self, guesses: Array, params: Array) -> tuple[Array, Mask]:
        """Newton's method from rough guesses: solutions, and whether each is one; see `searched`."""
        out = self.searched(guesses, params)
        return out.u, out.closed

    def quick_search(self, guesses: Array, params: Array, steps: int | None = None) -> tuple[Array, Mask]:
        """The same where many guesses lead to each solution: see `Kernels.quick_search`."""
        out = self._ended(partial(self.kernels.quick_search, steps=steps), guesses, params)
        return out.u, out.closed

    def searched(self, guesses: Array, params: Array) -> Ended:
        """Newton's method from rough guesses.

        Where it nearly closes at a resolution that does not resolve the motion, the end counts as closed: to
        close it is a matter of the resolution, which `converge` raises. Of such ends that are near each other
        only one counts.

        Parameters
        ----------
        guesses : ndarray, shape (n, nz + 1)
            Section point and period.
        params : ndarray, shape (n, n_params)
        """
        return self._ended(self.kernels.search, guesses, params)

    def _ended(self, search: Callable[[int, Array, Array], Searched], guesses: Array, params: Array) -> Ended:
        """How searches with one of the backend's methods end."""
        u, size = np.full(guesses.shape, np.nan), np.full(len(guesses), np.nan)
        promising = np.zeros(len(guesses), dtype=bool)
        n_rk = self.resolution.search_n_rk(guesses[:, -1], params)
        scale = Scales.of(self.model).residual
        for n in distinct(n_rk):
            at = np.flatnonzero(n_rk == n)
            u[at], residual = search(n, guesses[at], params[at])
            size[at] = np.abs(residual / scale).max(axis=1)
            with np.errstate(invalid="ignore"):
                near = (size[at] >= SEARCH_RESIDUAL) & (size[at] < NEARLY) & (u[at, -1] > 0)
            at = at[near & np.isfinite(u[at]).all(axis=1)]
            promising[at] = depends_on_resolution(self.kernels, n, u[at], params[at])
        with np.errstate(invalid="ignore"):
            closed = (size < SEARCH_RESIDUAL) & np.isfinite(u).all(axis=1) & (u[:, -1] > 0)
        closed |= self._one_of_each(promising, u, params)
        u = self.model.wrapped(u)
        possible = np.zeros(len(u), dtype=bool)
        possible[closed] = self.can_be_a_step(u[closed], params[closed])
        return Ended(u, closed & possible, closed & ~possible, ~closed)

    def _one_of_each(self, promising: Mask, u: Array, params: Array) -> Mask:
        """Those that are not near others of the same parameters, shape (n,)."""
        out = np.zeros_like(promising)
        rows = np.flatnonzero(promising)
        if len(rows):
            _, cell = np.unique(params[rows], axis=0, return_inverse=True)
            scale = Scales.of(self.model).unknowns
            out[rows[first_of_each(cell.ravel(), u[rows], SAME_END, None, scale)]] = True
        return out

    def polished(self, guesses: Array, params: Array) -> tuple[Array, Array]:
        """Solutions near good guesses at the resolution with which branches are followed.

        Parameters
        ----------
        guesses : ndarray, shape (n, nz + 1)
        params : ndarray, shape (n, n_params)

        Returns
        -------
        u : ndarray, shape (n, nz + 1)
        moved : ndarray, shape (n,)
            How far they are from the guesses, in terms of the scales; infinite where there is none.
        """
        u, scale = guesses.copy(), Scales.of(self.model).unknowns
        n_rk = self.resolution.branch_n_rk(u[:, -1], self.resolution.fastest_mode(params))
        last, open_ = np.full(len(u), np.inf), np.arange(len(u))
        jacobian, residual = np.empty((len(u), *2 * u.shape[1:])), np.empty(u.shape)
        used = np.full(len(u), USES)  # of the derivative
        for _ in range(POLISHES):
            old = (used >= USES) | (last[open_] > NEAR)
            again, same = np.flatnonzero(old), np.flatnonzero(~old)
            if len(again):
                at = open_[again]
                jacobian[again], residual[again] = self.kernels.jacobian(n_rk[at], u[at], params[at])
                used[again] = 0
            if len(same):
                at = open_[same]
                residual[same] = self.kernels.residual(n_rk[at], u[at], params[at])
            change = -solved(jacobian, residual)
            u[open_] += change
            last[open_], used = np.abs(change / scale).max(axis=1), used + 1
            with np.errstate(invalid="ignore"):
                go_on = (last[open_] > POLISHED) & (last[open_] < FAR)
            open_, jacobian, residual, used = open_[go_on], jacobian[go_on], residual[go_on], used[go_on]
            if not len(open_):
                break
        with np.errstate(invalid="ignore"):
            good = (last < 10 * POLISHED) & (u[:, -1] > 0)
        moved = np.abs((u - guesses) / scale).max(axis=1)
        return self.model.wrapped(u), np.where(good, moved, np.inf)

    def predicted(self, u: Array, params: Array, target: Array) -> Array:
        """Guesses at other parameters from solutions: on their tangents, where these do not lead far.

        Parameters
        ----------
        u : ndarray, shape (n, nz + 1)
            Section points and periods of solutions.
        params, target : ndarray, shape (n, n_params)
            Their parameters, and those of the guesses.

        Returns
        -------
        ndarray, shape (n, nz + 1)
            The solution itself where its tangent leads farther than `FAR_AHEAD`.
        """
        out, scale = u.copy(), Scales.of(self.model).unknowns
        # Targets on both sides of a solution, or at several distances, ask for the same derivative.
        way = target - params
        far = np.take_along_axis(way, np.abs(way).argmax(axis=1)[:, None], axis=1)
        way = np.divide(way, far, out=np.zeros(way.shape), where=far != 0)
        one, same = _distinct_rows(np.hstack([u, params, way]))
        n_rk = self.resolution.branch_n_rk(u[one, -1], self.resolution.fastest_mode(params[one]))
        jacobian, slope, _ = self.kernels.jacobian_along(n_rk, u[one], params[one], way[one])
        change = -far * solved(jacobian, slope)[same]
        with np.errstate(invalid="ignore"):
            good = np.abs(change / scale).max(axis=1) < FAR_AHEAD
        out[good] += change[good]
        return out

    def can_be_a_step(self, u: Array, params: Array) -> Mask:
        """Whether the swing foot lands on the admissible side, with the stance leg above the ground."""
        after = self.model.evaluate("section_state", z=u[:, :-1], p=params)
        before = self.model.evaluate("before_touchdown", q=after["q"], p=params)["q_minus"]
        side = self.model.evaluate("touchdown_condition", q=before, v=after["v"], p=params)["side"]
        can: Mask = side < 0
        if self.model.stance_index is not None:
            can &= np.abs(before[:, self.model.stance_index]) < np.pi / 2
        return can

    def converge(self, guesses: Array, params: Array, period_range: tuple[float, float]) -> Orbits:
        """Limit cycles from good guesses, with everything that is measured; failures carry their reason.

        Parameters
        ----------
        guesses : ndarray, shape (n, nz + 1)
        params : ndarray, shape (n, n_params)
        period_range : (float, float)
            Periods outside are marked `Status.OUT_OF_RANGE`.

        Returns
        -------
        Orbits, length n
            In the order of the guesses.
        """
        if not len(guesses):
            return Orbits.empty(self.model)
        u = guesses.copy()
        n_rk = self.resolution.cycle_n_rk(u[:, -1], params)
        parts, places = [], []
        for n in LEVELS:
            waiting = np.flatnonzero(n_rk == n)
            for at in batches(waiting, n):
                candidates = Candidates.solve(self.kernels, self.acceptance, n, u[at], params[at])
                excess, unresolved = candidates.excess(), candidates.unresolved()
                refine = (excess > 1) | unresolved
                if n < LEVELS[-1]:
                    # The error falls with the order's power of the resolution: go where it will do.
                    factor = np.where(unresolved, 2.0, np.maximum(1.1 * excess ** (1 / ORDER), 1.01))
                    n_rk[at[refine]] = coarsest(n * factor[refine], LEVELS)
                    closed = refine & candidates.closed
                    u[at[closed]] = candidates.corrected()[closed]
                else:
                    refine[:] = False
                done = np.flatnonzero(~refine)
                parts.append(candidates.take(done).orbits(period_range, unresolved[done]))
                places.append(at[done])
        return Orbits.concatenate(self.model, parts).take(np.argsort(np.concatenate(places)))


def _distinct_rows(rows: Array) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """The first of each set of rows that are alike to the last bit, and in which set each row is."""
    whole = np.ascontiguousarray(rows + 0.0).view(f"V{rows.itemsize * rows.shape[1]}")  # no zero is negative
    _, first, inverse = np.unique(whole.ravel(), return_index=True, return_inverse=True)
    return first, inverse.ravel()


LEVELS = (*CYCLE_N_RK, *FINE_N_RK)
"""All resolutions of limit cycles."""
