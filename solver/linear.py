"""Linear systems on arrays: what has no solution is NaN, and spoils none of its neighbours."""

from typing import Any

import numpy as np
from numpy.typing import NDArray


def solved(matrix: NDArray[Any], right: NDArray[Any]) -> NDArray[Any]:
    """Solutions of linear systems; NaN where there is none.

    Parameters
    ----------
    matrix : ndarray, shape (..., n, n)
    right : ndarray, shape (..., n)

    Returns
    -------
    ndarray, shape (..., n)
    """
    size = right.shape[-1]
    matrices, rights = matrix.reshape(-1, size, size), right.reshape(-1, size)
    finite = np.isfinite(matrices).all(axis=(1, 2)) & np.isfinite(rights).all(axis=1)
    out = np.full(rights.shape, np.nan, dtype=np.result_type(matrices, rights))
    try:
        out[finite] = np.linalg.solve(matrices[finite], rights[finite][:, :, None])[:, :, 0]
    except np.linalg.LinAlgError:  # one of them is singular to the last bit
        for i in np.flatnonzero(finite):
            try:
                out[i] = np.linalg.solve(matrices[i], rights[i])
            except np.linalg.LinAlgError:
                continue
    return out.reshape(right.shape)


def inverted(matrices: NDArray[Any]) -> NDArray[Any]:
    """Inverses, real or complex; NaN where there is none.

    Parameters
    ----------
    matrices : ndarray, shape (n, m, m)

    Returns
    -------
    ndarray, shape (n, m, m)
    """
    out = np.full_like(matrices, np.nan)
    good = np.isfinite(matrices).all(axis=(1, 2))
    try:
        out[good] = np.linalg.inv(matrices[good])
    except np.linalg.LinAlgError:  # one of them is singular to the last bit
        for i in np.flatnonzero(good):
            try:
                out[i] = np.linalg.inv(matrices[i])
            except np.linalg.LinAlgError:
                continue
    return out
