"""The largest power that all motors of a walker take and give together, in continuous time."""

from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Advanced
from stridemap.solver.kernels.observation import power
from stridemap.solver.observables.events import Index, Trace, brackets
from stridemap.solver.observables.reductions import extreme

Array = NDArray[np.float64]

TOTAL = "total"
"""Name of the row that a `Signed` trace adds."""


@dataclass(frozen=True)
class Signed(Trace):
    """A trace with one row more, a sum of rows with signs.

    Parameters
    ----------
    rows : ndarray of int, shape (m,)
    signs : ndarray, shape (m,)
    """

    rows: Index
    signs: Array

    @classmethod
    def of_powers(cls, trace: Trace, signs: Array) -> "Signed":
        """The powers of all motors, each with a sign, summed."""
        rows = np.array([trace.row(power(name)) for name in trace.kernels.model.actuated])
        g, dg = (np.concatenate([x, (x[..., rows] @ signs)[..., None]], axis=-1) for x in (trace.g, trace.dg))
        return cls(trace.kernels, trace.params, trace.period, trace.w, g, dg, rows, signs)

    def row(self, name: str) -> int:
        """Row of an observable."""
        return self.g.shape[2] - 1 if name == TOTAL else super().row(name)

    def advance(self, orbit: Index, node: Index, tau: Array) -> Advanced:
        """State with work, observables and derivatives at a time `tau` after a node."""
        w, g, dg = super().advance(orbit, node, tau)
        g, dg = (np.concatenate([x, (x[:, self.rows] @ self.signs)[:, None]], axis=1) for x in (g, dg))
        return Advanced(w, g, dg)


def peak_power(trace: Trace) -> Array:
    """Largest sum over motors of the absolute power, shape (n,).

    With the right signs the sum of absolute values is a smooth sum, and with any others it is smaller: its
    largest value is the largest of those with the signs that occur.
    """
    motors = trace.kernels.model.actuated
    if not motors:
        return np.zeros(len(trace.period))
    if len(motors) == 1:
        return extreme(trace, power(motors[0]), np.absolute)
    each = [extreme(Signed.of_powers(trace, signs), TOTAL, np.absolute) for signs in _signs(trace)]
    peak: Array = np.max([np.zeros(len(trace.period)), *each], axis=0)
    return peak


def _signs(trace: Trace) -> list[Array]:
    """Signs of the motors' powers that occur together, but for those of all; at nodes and between them."""
    rows = [trace.row(power(name)) for name in trace.kernels.model.actuated]
    at_nodes = trace.g[:, :, rows] < 0
    crossed = np.zeros_like(at_nodes)
    for j, name in enumerate(trace.kernels.model.actuated):
        found = brackets(trace, power(name))
        crossed[found.orbit, found.node, j] = True
    patterns = {tuple(pattern) for pattern in np.unique(at_nodes.reshape(-1, len(rows)), axis=0).tolist()}
    several = np.concatenate([at_nodes, crossed], axis=2)[crossed.any(axis=2)]
    for pattern in np.unique(several, axis=0).tolist():
        before, flips = pattern[: len(rows)], pattern[len(rows) :]
        choices = ((sign, not sign) if flip else (sign,) for sign, flip in zip(before, flips, strict=True))
        patterns |= set(product(*choices))
    signed = {tuple(-1.0 if sign != pattern[0] else 1.0 for sign in pattern) for pattern in patterns}
    return [np.array(pattern) for pattern in sorted(signed)]
