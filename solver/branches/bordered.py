"""Bordered systems, which tell where a cycle has a given multiplier.

With the derivative J of a chain's residual, W the part of it that leads from the last step back to the first,
and

    M(lambda) = J + (1 - lambda) W,

lambda is a Floquet multiplier of the cycle where M(lambda) is singular. Bordered by any two vectors b and c,

    [ M  b ] [ w ]   [ 0 ]
    [ c' 0 ] [ g ] = [ 1 ]

g is zero there and smooth, and its derivative is ``-psi' dM w`` with the solution psi of the transposed
system (W. Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 2000, chapter 3).
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.equations import CycleEquations
from stridemap.solver.linear import solved

Array = NDArray[np.float64]


def wrap(equations: CycleEquations) -> Array:
    """The matrix W: what leads from the first point to the residual of the last step, shape (N, N)."""
    width, nz = equations.chain.width, equations.chain.width - 1
    size = equations.n_unknowns
    matrix = np.zeros((size, size))
    matrix[np.arange(size - width, size - 1), np.arange(nz)] = 1.0
    return matrix


@dataclass(frozen=True)
class Bordered:
    """Bordered systems of M(lambda) at k points.

    Parameters
    ----------
    w, psi : ndarray, shape (k, N)
        Solutions of the systems and of their transposes.
    g : ndarray, shape (k,)
    """

    w: NDArray[Any]
    psi: NDArray[Any]
    g: NDArray[Any]

    @classmethod
    def of(cls, matrix: NDArray[Any], b: NDArray[Any], c: NDArray[Any]) -> "Bordered":
        """Solve the systems with borders b and c."""
        count, size = matrix.shape[:2]
        whole = np.zeros((count, size + 1, size + 1), dtype=matrix.dtype)
        whole[:, :size, :size], whole[:, :size, size], whole[:, size, :size] = matrix, b, c
        right = np.zeros((count, size + 1), dtype=matrix.dtype)
        right[:, size] = 1.0
        one, other = solved(whole, right), solved(whole.transpose(0, 2, 1), right)
        return cls(one[:, :size], other[:, :size], one[:, size])
