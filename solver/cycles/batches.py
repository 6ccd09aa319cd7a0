"""Points in batches: what is known of all nodes of their steps takes memory, and time to fetch from it."""

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.kernels.catalogue import CYCLE_N_RK

Index = NDArray[np.int64]

BATCH, FINE_BATCH = 40_000, 100_000
"""RK steps that are kept in memory at once, those of all points together. So few stay in the processor's
caches; where kernels are chained from pieces, each batch costs calls of its own, and is larger."""


def batches(points: Index, n_rk: int) -> list[Index]:
    """Points in batches, in order; none is empty.

    Parameters
    ----------
    points : ndarray of int, shape (n,)
    n_rk : int
        RK steps of each.
    """
    at_once = max((BATCH if n_rk <= 2 * CYCLE_N_RK[-1] else FINE_BATCH) // n_rk, 1)
    return [points[i : i + at_once] for i in range(0, len(points), at_once)]
