"""What every backend offers: the kernels of a model, called on arrays of points, with named results.

A backend is a value that is passed as an argument. It says what the last bits of its results depend on
(`Backend.arithmetic`); two backends whose arithmetic is equal give the same bytes.
"""

import ctypes
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends import chained
from stridemap.solver.kernels import catalogue
from stridemap.solver.kernels.catalogue import ADVANCE, Kernel
from stridemap.solver.kernels.resolution import distinct
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]
Index = NDArray[np.int64]


ONE_POINT = "one point at a time, without contraction, sines of the C library"
"""Arithmetic of C for one point at a time, and of CasADi's virtual machine: the same operations in order."""


class Searched(NamedTuple):
    """Of Newton's method from rough guesses: solutions, shape (n, nz + 1), and the residuals there."""

    u: Array
    residual: Array


class Solved(NamedTuple):
    """Of Newton's method from good guesses.

    Solutions, shape (n, nz + 1); the Jacobians there, shape (n, nz + 1, nz + 1), row by row; the residuals.
    """

    u: Array
    jacobian: Array
    residual: Array


class Linearised(NamedTuple):
    """Jacobians, shape (n, nz + 1, nz + 1), row by row, and residuals, shape (n, nz + 1)."""

    jacobian: Array
    residual: Array


class LinearisedAlong(NamedTuple):
    """Jacobians, shape (n, nz + 1, nz + 1), row by row.

    Derivatives in directions of the parameters, and residuals, shape (n, nz + 1) each.
    """

    jacobian: Array
    along: Array
    residual: Array


class Traced(NamedTuple):
    """States with net works, observables and their time derivatives at the nodes, and residuals.

    Shapes (n, n_rk + 1, width), (n, n_rk + 1, n_observables) twice, and (n, nz + 1).
    """

    w: Array
    g: Array
    dg: Array
    residual: Array


class Advanced(NamedTuple):
    """States with net works, observables and their time derivatives after a part of an RK step."""

    w: Array
    g: Array
    dg: Array


class Directional(NamedTuple):
    """Residuals R at points x = (u, p), and derivatives in the directions a and b; shape (n, nz + 1) each.

    ``DR[a]``, ``DR[b]`` and the mixed second derivative ``D2R[a, b]``.
    """

    residual: Array
    along_a: Array
    along_b: Array
    mixed: Array


class Lockstep(NamedTuple):
    """A compiled algorithm, and where in memory it finds kernels."""

    library: ctypes.CDLL
    address: Callable[[Kernel], int]


class Kernels(ABC):
    """The kernels of one model, mapped over arrays of points.

    In what follows u is a section point with its period, shape (n, nz + 1), p are parameters, shape
    (n, n_params), and `n_rk` is the number of RK steps per step of the walker: of all, or of each point,
    shape (n,). Where a point's computation breaks down its results are NaN.

    Parameters
    ----------
    model : Model
    backend : Backend
        What runs them.
    """

    library: Path | None = None
    """The compiled file that they are in, where there is one."""

    def __init__(self, model: Model, backend: "Backend") -> None:
        self.model: Model = model
        self.backend = backend
        self.functions: Mapping[Kernel, ca.Function] = _functions(model)
        self._shapes = {kernel: catalogue.shapes(model, kernel) for kernel in catalogue.KERNELS}

    @property
    @abstractmethod
    def compiler(self) -> str:
        """Compiler and flags, or what runs in their place."""

    @abstractmethod
    def _map(self, kernel: Kernel, inputs: list[Array], outputs: list[Array]) -> None:
        """Call `kernel` for every point; fills `outputs`."""

    def _map_each(
        self, kernels: Sequence[Kernel], rows: Sequence[Index], inputs: list[Array], outputs: list[Array]
    ) -> None:
        """Call each of some kernels for rows of its own; fills `outputs`."""
        for kernel, at in zip(kernels, rows, strict=True):
            parts = [out[at] for out in outputs]
            self._map(kernel, [one[at] for one in inputs], parts)
            for out, part in zip(outputs, parts, strict=True):
                out[at] = part

    def search(self, n_rk: int, u: Array, p: Array) -> Searched:
        """Newton's method from rough guesses."""
        return Searched(*self.call(catalogue.search(n_rk), u, p))

    def quick_search(self, n_rk: int, u: Array, p: Array, steps: int | None = None) -> Searched:
        """The same where many guesses lead to each solution, so that some of them may be lost for speed.

        Single precision will do. The residuals are in double precision in any case.

        Parameters
        ----------
        n_rk : int
        u : ndarray, shape (n, nz + 1)
        p : ndarray, shape (n, n_params)
        steps : int, optional
            Newton steps, at least 1, after which it may stop; what came near may take some more. A backend
            that cannot stop early takes as many as the kernel does.
        """
        return self.search(n_rk, u, p)

    def prepare_search_and_following(self) -> None:
        """Compile now what quick searches and following take, and not when they are first asked for.

        Raises
        ------
        CompilerError
            When the compiler fails.
        """
        return

    def lockstep(self, driver: Path) -> Lockstep | None:
        """An algorithm around the kernels that works on several points at a time; None where none can.

        It is compiled when it is first asked for. A backend that wraps another one must hand on the other's:
        where there is none, NumPy does the same, with other last digits.

        Parameters
        ----------
        driver : Path
            C++ that is compiled after lanes.h and lockstep.h.

        Raises
        ------
        CompilerError
            When the compiler fails.
        """
        return None

    def limit_cycle(self, n_rk: int, u: Array, p: Array) -> Solved:
        """Newton's method from good guesses."""
        kernel = catalogue.limit_cycle(n_rk)
        compiled = kernel in self.functions
        u, jacobian, residual = self.call(kernel, u, p) if compiled else chained.limit_cycle(self, n_rk, u, p)
        return Solved(u, _by_rows(jacobian), residual)

    def residual(self, n_rk: int | Index, u: Array, p: Array) -> Array:
        """Closing errors with the touchdown condition, shape (n, nz + 1)."""
        if isinstance(n_rk, np.ndarray):
            return self._each(catalogue.residual, n_rk, u, p)[0]
        kernel = catalogue.residual(n_rk)
        if kernel not in self.functions:
            return chained.jacobian(self, n_rk, u, p)[1]
        (residual,) = self.call(kernel, u, p)
        return residual

    def precise_residual(self, n_rk: int, u: Array, p: Array) -> Array:
        """Residuals to many more digits than those of doubles, shape (n, nz + 1); NaN where there are none.

        They tell what the rounding of a residual does. Not every backend has them, nor every resolution.
        """
        return np.full(u.shape, np.nan)

    def jacobian(self, n_rk: int | Index, u: Array, p: Array) -> Linearised:
        """Residuals with their derivatives with respect to u."""
        if isinstance(n_rk, np.ndarray):
            jacobian, residual = self._each(catalogue.jacobian, n_rk, u, p)
            return Linearised(_by_rows(jacobian), residual)
        kernel = catalogue.jacobian(n_rk)
        compiled = kernel in self.functions
        jacobian, residual = self.call(kernel, u, p) if compiled else chained.jacobian(self, n_rk, u, p)
        return Linearised(_by_rows(jacobian), residual)

    def jacobian_along(self, n_rk: int | Index, u: Array, p: Array, d: Array) -> LinearisedAlong:
        """Residuals with their derivatives with respect to u, and in directions `d` of the parameters.

        Parameters
        ----------
        n_rk : int or ndarray of int, shape (n,)
            Of `SEARCH_N_RK` and `CYCLE_N_RK`.
        u : ndarray, shape (n, nz + 1)
        p, d : ndarray, shape (n, n_params)

        Raises
        ------
        KeyError
            When there is no kernel for a resolution.
        """
        each = n_rk if isinstance(n_rk, np.ndarray) else np.full(len(u), n_rk)
        jacobian, along, residual = self._each(catalogue.jacobian_along, each, u, p, d)
        return LinearisedAlong(_by_rows(jacobian), along, residual)

    def directional(self, n_rk: int, u: Array, p: Array, a: Array, b: Array) -> Directional:
        """Residuals with exact derivatives of first and second order in two directions of (u, p).

        Parameters
        ----------
        n_rk : int
        u : ndarray, shape (n, nz + 1)
        p : ndarray, shape (n, n_params)
        a, b : ndarray, shape (n, nz + 1 + n_params)
            Directions: changes of u, then of the parameters.
        """
        whole = _directional(self.model, n_rk)
        parts = [u, p, *np.split(a, [u.shape[1]], axis=1), *np.split(b, [u.shape[1]], axis=1)]
        outputs = [np.full(u.shape, np.nan) for _ in range(4)]
        for i, row in enumerate(zip(*parts, strict=True)):
            for out, value in zip(outputs, whole(*row), strict=True):
                out[i] = value.full().ravel()
        return Directional(*outputs)

    def trace(self, n_rk: int, u: Array, p: Array) -> Traced:
        """Whole steps, observed at their nodes."""
        kernel = catalogue.trace(n_rk)
        return Traced(
            *(self.call(kernel, u, p) if kernel in self.functions else chained.trace(self, n_rk, u, p))
        )

    def advance(self, t: Array, w: Array, h: Array, p: Array) -> Advanced:
        """One RK step of size h from a node at time t, observed at its end."""
        return Advanced(*self.call(ADVANCE, t, w, h, p))

    def call(self, kernel: Kernel, *inputs: Array) -> list[Array]:
        """Call a kernel at n points.

        Parameters
        ----------
        kernel : Kernel
        *inputs : ndarray, shape (n, size of the input)
            One array per input, in the kernel's order; one row per point.

        Returns
        -------
        list of ndarray
            One array per output: shape (n, rows), or (n, columns, rows) for a matrix, as CasADi stores it.
            NaN where a point's computation broke down.
        """
        return self._called([kernel], None, *inputs)

    def _each(self, kind: Callable[[int], Kernel], n_rk: Index, *inputs: Array) -> list[Array]:
        """Call a kind of kernel at n points, each at its own resolution, of those that have a kernel."""
        levels = distinct(n_rk) or [catalogue.SEARCH_N_RK[0]]
        if len(levels) == 1:
            return self.call(kind(levels[0]), *inputs)
        return self._called([kind(n) for n in levels], [np.flatnonzero(n_rk == n) for n in levels], *inputs)

    def _called(self, kernels: Sequence[Kernel], rows: Sequence[Index] | None, *inputs: Array) -> list[Array]:
        """Call one kernel at all points, or each of some that are alike at rows of its own."""
        kernel = kernels[0]
        shapes = self._shapes[kernel]
        n = len(inputs[0])
        arrays = [np.ascontiguousarray(x, dtype=np.float64) for x in inputs]
        for (name, size), array in zip(shapes.inputs.items(), arrays, strict=True):
            if array.size != n * size:
                raise ValueError(f"{kernel.name}: input {name} has shape {array.shape}, not ({n}, {size})")
        outputs = [np.empty((n, rows * columns)) for rows, columns in shapes.outputs]
        if n:
            points = [a.reshape(n, -1) for a in arrays]
            if rows is None:
                self._map(kernel, points, outputs)
            else:
                self._map_each(kernels, rows, points, outputs)
        return [
            out if columns == 1 else out.reshape(n, columns, rows)
            for out, (rows, columns) in zip(outputs, shapes.outputs, strict=True)
        ]


class Backend(ABC):
    """Something that runs kernels."""

    @property
    @abstractmethod
    def arithmetic(self) -> str:
        """What the last bits of the results depend on."""

    @abstractmethod
    def kernels(self, model: Model) -> Kernels:
        """The kernels of a model.

        Raises
        ------
        CompilerError
            When the compiler fails.
        InputError
            When the C is not the one that the manifest names.
        """


@cache
def _functions(model: Model) -> Mapping[Kernel, ca.Function]:
    return catalogue.Catalogue(model)


@cache
def _directional(model: Model, n_rk: int) -> ca.Function:
    """(u, p, a_u, a_p, b_u, b_p) -> (R, DR[a], DR[b], D2R[a, b]), by CasADi's own differentiation."""
    residual = _functions(model)[catalogue.residual(n_rk)]
    u, p = (ca.MX.sym(name, *residual.size_in(name)) for name in ("u", "p"))
    a_u, b_u, a_p, b_p = (ca.MX.sym(n, *x.shape) for n, x in (("a", u), ("b", u), ("a_p", p), ("b_p", p)))
    x, value = ca.vertcat(u, p), residual(u, p)
    along_a, along_b = (ca.jtimes(value, x, ca.vertcat(*one)) for one in ((a_u, a_p), (b_u, b_p)))
    mixed = ca.jtimes(along_a, x, ca.vertcat(b_u, b_p))
    inputs = [u, p, a_u, a_p, b_u, b_p]
    return ca.Function("directional", inputs, [ca.densify(e) for e in (value, along_a, along_b, mixed)])


def _by_rows(matrices: Array) -> Array:
    """CasADi stores matrices column by column."""
    return matrices.transpose(0, 2, 1)
