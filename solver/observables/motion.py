"""Limit cycles as motions: everything that is drawn or plotted, sampled evenly over one step."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.solver.backends.base import Backend
from stridemap.solver.backends.selection import load_kernels
from stridemap.solver.kernels.resolution import Resolution, distinct
from stridemap.solver.model.model import Model
from stridemap.solver.observables.events import Trace

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Motion:
    """A step of the walker at evenly spaced times from just after a touchdown to just before the next.

    The leading axes, ``...`` below, are those of the cycles asked for, then n samples. Positions are from
    the stance foot. Units are the model's (``model.spec.units``): upper-body mass M, leg length L and time
    sqrt(L/g) unless it is written in SI units.

    Parameters
    ----------
    model : Model
    t : ndarray, shape (..., n)
    q, v : ndarray, shape (..., n, n_q)
        Coordinates and their rates, in the order of `Model.coordinates`.
    torque : ndarray, shape (..., n, n_actuators)
        In the order of `Model.actuated`.
    d : ndarray, shape (..., n)
        The paper's distance: stance foot minus the point ``x_g - Fx / Fy y_g``. It leaves out the change of
        angular momentum, so the ground force does not act there.
    cop : ndarray, shape (..., n)
        Centre of pressure, where the ground force acts: its position along the ground.
    contact : ndarray, shape (..., n)
        Position along the ground of the stance foot's contact: 0 for a point foot.
    force : ndarray, shape (..., n, 2)
        Ground force on the stance foot, horizontal and vertical.
    com : ndarray, shape (..., n, 2)
        Centre of mass.
    positions : ndarray, shape (..., n, n_masses, 2)
        The masses, in the order of ``model.spec.masses``.
    lines : dict of str to ndarray, shape (..., n, n_points, 2)
        The lines by which the walker is drawn, by name.
    masses : ndarray, shape (..., n_masses)
    """

    model: Model
    t: Array
    q: Array
    v: Array
    torque: Array
    d: Array
    cop: Array
    contact: Array
    force: Array
    com: Array
    positions: Array
    lines: dict[str, Array]
    masses: Array

    def step(self, number: int) -> "Motion":
        """One step of a cycle of several, whose arrays have no leading axis."""
        columns = {name: getattr(self, name)[number] for name in _COLUMNS}
        lines = {name: line[number] for name, line in self.lines.items()}
        return Motion(self.model, **columns, lines=lines)

    def coordinate(self, name: str) -> Array:
        """A coordinate, or with a leading ``d`` its rate, by name, shape (..., n).

        Raises
        ------
        InputError
            When the model has no such coordinate.
        """
        names = self.model.coordinates
        if name in names:
            return self.q[..., names.index(name)]
        if name[:1] == "d" and name[1:] in names:
            return self.v[..., names.index(name[1:])]
        known = ", ".join(names)
        raise InputError(f"{self.model.name} has no coordinate {name!r}; its coordinates are {known}")


_COLUMNS = ("t", "q", "v", "torque", "d", "cop", "contact", "force", "com", "positions", "masses")


def motions(
    model: Model,
    cycles: Array | Sequence[Sequence[float]],
    params: Array,
    samples: int,
    squeeze: bool = False,
    backend: Backend | None = None,
) -> Motion:
    """Many limit cycles of one model as motions, with the leading axis of the cycles.

    Parameters
    ----------
    model : Model
    cycles : array_like, shape (m, nz + 1)
        Section points with periods.
    params : ndarray, shape (m, n_params)
    samples : int
        Number of times, both ends included.
    squeeze : bool
        Whether the leading axis of a single cycle is left out.
    backend : Backend, optional
        What runs the kernels.

    Raises
    ------
    InputError
        For fewer than two samples.
    """
    if samples < 2:
        raise InputError(f"samples = {samples} is not allowed: at least 2 are needed")
    u = np.asarray(cycles, dtype=np.float64)
    t, w = _sampled(model, u, params, samples, backend)
    n = len(model.coordinates)
    values = {"t": t, "q": w[..., :n], "v": w[..., n : 2 * n], "p": params[:, None, :]}
    drawing = model.evaluate("drawing", **values)
    columns = {
        "t": t,
        "q": values["q"],
        "v": values["v"],
        "torque": _torques(model, values),
        "d": model.evaluate("zmp", **values)["d"],
        "cop": model.evaluate("centre_of_pressure", **values)["cop"],
        "contact": model.evaluate("stance_foot", **values)["stance"][..., 0],
        "force": model.evaluate("ground_force", **values)["force"],
        "com": model.evaluate("centre_of_mass", **values)["com"],
        "positions": drawing["positions"],
    }
    lines = {line.name: drawing[line.name] for line in model.spec.lines}
    masses = drawing["masses"][:, 0]
    if squeeze:
        columns = {name: column[0] for name, column in columns.items()}
        lines, masses = {name: line[0] for name, line in lines.items()}, masses[0]
    return Motion(model=model, **columns, lines=lines, masses=masses)


def _torques(model: Model, values: dict[str, Array]) -> Array:
    if not model.actuated:
        return np.zeros((*values["t"].shape, 0))
    return model.evaluate("controller_torque", **values)["u"]


def _sampled(
    model: Model, u: Array, params: Array, samples: int, backend: Backend | None
) -> tuple[Array, Array]:
    """Times, shape (m, samples), and states there, with the integrator's own accuracy between its nodes."""
    kernels = load_kernels(model, backend)
    m = len(u)
    n_rk = 2 * Resolution(model).cycle_n_rk(u[:, -1], params)
    t = u[:, -1:] * np.linspace(0, 1, samples)
    states = np.empty((m, samples, 2 * len(model.coordinates) + len(model.actuated)))
    for n in distinct(n_rk):
        at = np.flatnonzero(n_rk == n)
        trace = Trace.of(kernels, u[at], params[at], kernels.trace(n, u[at], params[at]))
        orbit = np.repeat(np.arange(len(at)), samples)
        node = np.minimum((np.tile(np.linspace(0, 1, samples), len(at)) * n).astype(np.int64), n - 1)
        tau = t[at].ravel() - node * trace.h[orbit]
        states[at] = trace.advance(orbit, node, tau).w.reshape(len(at), samples, -1)
    return t, states
