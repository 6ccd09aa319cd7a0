"""Floquet multipliers from the exact derivative of the step map."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def step_map_derivative(jacobian: Array) -> Array:
    """Derivative of the step map at limit cycles.

    The period follows the section point: with ``h(z, T) = 0`` at touchdown,
    ``dP = P_z - P_T h_z / h_T``.

    Parameters
    ----------
    jacobian : ndarray, shape (n, nz + 1, nz + 1)
        Derivative of the residual ``(P - z, h)`` with respect to ``(z, T)``.

    Returns
    -------
    ndarray, shape (n, nz, nz)
        Not finite where the foot only touches: there h_T is zero.
    """
    nz = jacobian.shape[-1] - 1
    p_z = jacobian[:, :nz, :nz] + np.eye(nz)
    p_t, h_z, h_t = jacobian[:, :nz, nz:], jacobian[:, nz:, :nz], jacobian[:, nz:, nz:]
    with np.errstate(divide="ignore", invalid="ignore"):
        return p_z - p_t @ h_z / h_t


def multipliers(jacobian: Array) -> NDArray[np.complex128]:
    """Floquet multipliers by falling modulus.

    Parameters
    ----------
    jacobian : ndarray, shape (n, nz + 1, nz + 1)
        As for `step_map_derivative`.

    Returns
    -------
    ndarray of complex, shape (n, nz)
        NaN where the derivative is not finite.
    """
    return sorted_eigenvalues(step_map_derivative(jacobian))


def sorted_eigenvalues(derivative: Array) -> NDArray[np.complex128]:
    """Eigenvalues of matrices by falling modulus, shape (n, nz); NaN where a matrix is not finite.

    Parameters
    ----------
    derivative : ndarray, shape (n, nz, nz)
    """
    finite = np.isfinite(derivative).all(axis=(1, 2))
    values = np.full(derivative.shape[:2], np.nan + 0j)
    if finite.any():
        values[finite] = np.linalg.eigvals(derivative[finite])
    order = np.lexsort((-values.imag, -values.real, -np.abs(values)))
    return np.take_along_axis(values, order, axis=-1)
