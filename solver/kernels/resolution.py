"""How many RK steps a step of the walker needs: the resolution follows its fastest mode."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.kernels.catalogue import CYCLE_N_RK, SEARCH_N_RK
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]
Index = NDArray[np.int64]

SEARCH_PHASE, BRANCH_PHASE, CYCLE_PHASE = 1.5, 0.75, 0.45
"""Phase of the fastest mode in one RK step at most. A search needs only to come near; but at twice its phase,
sweeps were seen to lose cycles with a stiff spring. A branch that is nearly vertical is moved much by an
error of the residual: at the phase of the search, by two cells of the default sweep."""

KEPT = 50_000
"""Points whose fastest mode is kept, some 200 bytes each; when they are more, all are given up."""

BRANCH_N_RK = tuple(sorted({*SEARCH_N_RK, *CYCLE_N_RK}))
"""Resolutions with which branches are followed."""


def distinct(n_rk: Index) -> list[int]:
    """The resolutions among these, ascending.

    Not `numpy.unique`, which loads `numpy.ma`: 0.06 s of every command.
    """
    return sorted(set(n_rk.tolist()))


@dataclass(frozen=True)
class Resolution:
    """Chooses among the resolutions for which there are kernels.

    Parameters
    ----------
    model : Model
    """

    model: Model
    _known: dict[bytes, float] = field(default_factory=dict, repr=False, compare=False)

    def fastest_mode(self, params: Array) -> Array:
        """Largest modulus of an eigenvalue of the swing phase linearised upright at rest, shape (n,).

        They are kept: a search asks for the same ones again and again.
        """
        points = [point.tobytes() for point in params]
        modes = np.array([self._known.get(point, np.nan) for point in points])
        missing = np.flatnonzero(np.isnan(modes)).tolist()
        if missing:
            new = {points[row]: row for row in missing}
            computed = dict(zip(new, self._fastest_mode(params[list(new.values())]).tolist(), strict=True))
            modes[missing] = [computed[points[row]] for row in missing]
            if len(self._known) + len(computed) > KEPT:
                self._known.clear()
            self._known.update(computed)
        return modes

    def _fastest_mode(self, params: Array) -> Array:
        n = len(self.model.coordinates)
        rest = {"t": 0.0, "q": np.zeros(n), "v": np.zeros(n), "p": params}
        dv_dq = self.model.evaluate("state_derivative_dq", **rest)["dv_dq"]
        dv_dv = self.model.evaluate("state_derivative_dv", **rest)["dv_dv"]
        kinematics = np.broadcast_to(np.eye(n, 2 * n, n), (len(params), n, 2 * n))
        linear = np.concatenate([kinematics, np.concatenate([dv_dq, dv_dv], axis=2)], axis=1)
        # Beyond the range of numbers: any resolution will do, Newton's method fails at each.
        modes = np.full(len(params), np.inf)
        finite = np.isfinite(linear).all(axis=(1, 2))
        modes[finite] = np.abs(np.linalg.eigvals(linear[finite])).max(axis=1)
        return modes

    def cycle_n_rk(self, period: Array, params: Array) -> Index:
        """RK steps with which limit cycles of these periods are first computed, shape (n,)."""
        return coarsest(_phase(period, self.fastest_mode(params)), CYCLE_N_RK, CYCLE_PHASE)

    def search_n_rk(self, period: Array, params: Array) -> Index:
        """RK steps of a search near a period, shape (n,)."""
        return coarsest(_phase(period, self.fastest_mode(params)), SEARCH_N_RK, SEARCH_PHASE)

    def branch_n_rk(self, period: Array, mode: Array) -> Index:
        """RK steps with which branches are followed near a period, where the fastest mode is known."""
        return coarsest(_phase(period, mode), BRANCH_N_RK, BRANCH_PHASE)


def _phase(period: Array, mode: Array) -> Array:
    """Phase of a mode in a period; 0 where that is not a number, which no resolution helps."""
    with np.errstate(over="ignore", invalid="ignore"):
        phase: Array = mode * np.abs(period)
    return np.nan_to_num(phase, posinf=0.0)


def coarsest(phase: Array, choices: tuple[int, ...], per_rk_step: float = 1.0) -> Index:
    """Fewest RK steps of at most `per_rk_step` of a phase each; the most there are where that is too few."""
    index = np.searchsorted(np.array(choices) * per_rk_step, phase)
    return np.array(choices)[np.minimum(index, len(choices) - 1)]
