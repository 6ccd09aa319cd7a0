"""Maps whose bifurcations are known in closed form, as if they were the step map of a walker."""

from functools import cached_property
from types import SimpleNamespace

import numpy as np
import sympy as sp

from stridemap.solver.backends.base import Directional, Linearised
from stridemap.solver.branches.equations import CycleEquations
from stridemap.solver.cycles.chain import Chain


class Map:
    """Kernels of a map z -> f(z, p); every step takes the time 1."""

    def __init__(self, f, z, p):
        self.f, self.z, self.p = sp.Matrix(f), list(z), list(p)
        nz = len(self.z)
        self.model = SimpleNamespace(
            spec=SimpleNamespace(
                names=tuple(map(str, self.p)),
                scales=(1.0,) * nz,
                search_box={str(one): (0.0, 1.0) for one in self.z},
            ),
            section=tuple(map(str, self.z)),
            period_range=(0.5, 1.5),
        )

    @cached_property
    def _functions(self):
        both = [*self.z, *self.p]
        first = self.f.jacobian(both)
        second = [sp.hessian(one, both) for one in self.f]
        return [sp.lambdify(both, what, "numpy") for what in (self.f, first, second)]

    def _at(self, which, u, params):
        values = [self._functions[which](*z[:-1], *p) for z, p in zip(u, params, strict=True)]
        return np.array(values, dtype=float)

    def residual(self, n_rk, u, params):
        value = self._at(0, u, params)[:, :, 0]
        return np.column_stack([value - u[:, :-1], u[:, -1] - 1.0])

    def jacobian(self, n_rk, u, params):
        nz = len(self.z)
        out = np.zeros((len(u), nz + 1, nz + 1))
        out[:, :nz, :nz] = self._at(1, u, params)[:, :, :nz] - np.eye(nz)
        out[:, nz, nz] = 1.0
        return Linearised(out, self.residual(n_rk, u, params))

    def directional(self, n_rk, u, params, a, b):
        nz = len(self.z)
        first, second = self._at(1, u, params), self._at(2, u, params)
        inner = [np.delete(one, nz, axis=1) for one in (a, b)]  # without the period
        along = []
        for one, direction in zip((a, b), inner, strict=True):
            change = np.einsum("mij,mj->mi", first, direction) - one[:, :nz]
            along.append(np.column_stack([change, one[:, nz]]))
        bend = np.einsum("mijk,mj,mk->mi", second, *inner)
        mixed = np.column_stack([bend, np.zeros(len(u))])
        return Directional(self.residual(n_rk, u, params), *along, mixed)


class MapEquations(CycleEquations):
    """Cycles of a map, which need no resolution."""

    def n_rk(self, x):
        return 24


def equations(f, z, p, params, n_steps=1, widths=None):
    """Cycles of a map over the parameters p[:len(widths)], two by default; the others have values."""
    free = 2 if widths is None else len(widths)
    names = tuple(map(str, p))[:free]
    return MapEquations(
        Chain(Map(f, z, p), n_steps), np.array(params, dtype=float), names, widths or (1.0,) * free
    )
