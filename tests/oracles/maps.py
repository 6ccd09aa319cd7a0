"""Maps in the place of a walker's step map, whose cycles and bifurcations are known in closed form.

A curve of such cycles is the same curve as a walker's for all that follows it: only the kernels are others.
Their derivatives are SymPy's.
"""

from dataclasses import dataclass
from functools import cached_property
from types import SimpleNamespace
from typing import Any

import numpy as np
import sympy as sp

from stridemap.solver.backends.base import Directional, Linearised, LinearisedAlong
from stridemap.solver.branches.curve import Curve
from stridemap.solver.branches.equations import CycleEquations
from stridemap.solver.cycles.chain import Chain

x, y, p, T = sp.symbols("x y p T", real=True)


@dataclass(frozen=True)
class MapKernels:
    """Kernels of the residual ``(P(z, T) - z, condition(z, T))``.

    Parameters
    ----------
    images : tuple of sympy.Expr
        P, in terms of x, y, T and p: one for each entry of z.
    condition : sympy.Expr
        What is zero at the end of a step.
    error : float
        By how much p is off with 24 RK steps, as if something were integrated; the order is 8.
    variables, parameters : tuple of sympy.Symbol
        z, of which as many count as there are images, and p.
    """

    images: tuple[Any, ...]
    condition: Any = T - 1
    error: float = 0.0
    variables: tuple[Any, ...] = (x, y)
    parameters: tuple[Any, ...] = (p,)

    @property
    def z(self):
        return self.variables[: len(self.images)]

    @cached_property
    def model(self):
        names = tuple(map(str, self.z))
        spec = SimpleNamespace(
            names=tuple(map(str, self.parameters)),
            scales=(1.0,) * len(names),
            search_box=dict.fromkeys(names, (0.0, 1.0)),
        )
        scales = SimpleNamespace(
            residual=np.ones(len(names) + 1), unknowns=np.ones(len(names) + 1)
        )  # where `Scales.of` keeps them
        return SimpleNamespace(section=names, period_range=(0.5, 1.5), spec=spec, _scales=scales)

    @cached_property
    def functions(self):
        """The residual, and its first and second derivatives with respect to (z, T, p)."""
        unknowns = (*self.z, T, *self.parameters)
        residual = sp.Matrix([*(a - b for a, b in zip(self.images, self.z, strict=True)), self.condition])
        first = residual.jacobian(unknowns)
        second = [sp.hessian(row, unknowns) for row in residual]
        return tuple(sp.lambdify(unknowns, one, "numpy") for one in (residual, first, second))

    def _each(self, number, n_rk, u, params):
        off = self.error * (24 / np.reshape(n_rk, (-1, 1))) ** 8 if self.error else 0.0
        with np.errstate(all="ignore"):
            rows = [self.functions[number](*a, *b) for a, b in zip(u, params + off, strict=True)]
        return np.array(rows, dtype=float)

    def residual(self, n_rk, u, params):
        return self._each(0, n_rk, u, params)[:, :, 0]

    def jacobian(self, n_rk, u, params):
        return Linearised(self._each(1, n_rk, u, params)[:, :, : u.shape[1]], self.residual(n_rk, u, params))

    def jacobian_along(self, n_rk, u, params, d):
        along = np.einsum("nij,nj->ni", self._each(1, n_rk, u, params)[:, :, u.shape[1] :], d)
        jacobian, residual = self.jacobian(n_rk, u, params)
        return LinearisedAlong(jacobian, along, residual)

    def directional(self, n_rk, u, params, a, b):
        first, second = self._each(1, n_rk, u, params), self._each(2, n_rk, u, params)
        along = [np.einsum("nij,nj->ni", first, one) for one in (a, b)]
        mixed = np.einsum("nkij,ni,nj->nk", second, a, b)
        return Directional(self.residual(n_rk, u, params), *along, mixed)


class MapEquations(CycleEquations):
    """The equations of cycles of a map: there is nothing to integrate."""

    def n_rk(self, x):
        return 24


def curve(*images, period=sp.S.One, width=1.0, error=0.0, condition=None):
    """Cycles of a map over p; 1 along the curve is 1 in every entry of z and in the period, `width` in p."""
    kernels = MapKernels(images, T - period if condition is None else condition, error)
    return Curve(MapEquations(Chain(kernels), np.zeros(1), ("p",), (width,)))


def equations(images, variables, parameters):
    """Cycles of a map over two parameters."""
    kernels = MapKernels(tuple(images), variables=tuple(variables), parameters=tuple(parameters))
    return MapEquations(Chain(kernels), np.zeros(2), tuple(map(str, parameters)), (1.0, 1.0))
