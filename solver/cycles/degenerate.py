"""Why there can be no limit cycle at a point of parameter space, where the equations themselves say so.

At the end of a parameter's range a walker may lose what makes it one: a spring without stiffness holds
nothing, a mass of zero has no inertia.
"""

from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.model.model import Model

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

STATES = 6
"""States at which the equations are looked at."""

AT_ONCE = 4096
"""Points that are looked at together, so that the memory for it is bounded."""

SAME = 1e-9
"""Difference, as a part of a shift, below which two shifted coordinates are one."""

SINGULAR = 1e-13
"""Smallest over largest eigenvalue of a mass matrix, scaled to a diagonal of ones, that is taken for
singular."""


def why_no_cycle(model: Model, point: Array) -> str | None:
    """A sentence that says why the equations have no limit cycle at a point; None where they do not say so.

    Parameters
    ----------
    model : Model
    point : ndarray, shape (n_params,)
    """
    if _without_inertia(model, point):
        culprits = _because_of(model, point, lambda p: ~_without_inertia(model, p))
        return (
            f"{culprits} the mass matrix is singular: part of the walker has no inertia, and the equations "
            "do not say how it moves"
        )
    for name in _positions(model):
        if not _is_held(model, name, point):
            culprits = _because_of(model, point, partial(_is_held, model, name))
            mass = " (a free mass has no gait)" if name == model.spec.wobbling else ""
            return (
                f"{culprits} nothing holds {name}: a motion that is shifted along {name} is a motion too, so "
                f"that there is no limit cycle, which stands by itself{mass}"
            )
    return None


def have_no_cycle(model: Model, points: Array) -> Mask:
    """Whether `why_no_cycle` has something to say of points, many at a time.

    Parameters
    ----------
    model : Model
    points : ndarray, shape (n, n_params)

    Returns
    -------
    ndarray of bool, shape (n,)
    """
    out = np.zeros(len(points), dtype=bool)
    for first in range(0, len(points), AT_ONCE):
        some = points[first : first + AT_ONCE]
        one = _without_inertia(model, some)
        for name in _positions(model):
            one = one | ~_is_held(model, name, some)
        out[first : first + AT_ONCE] = one
    return out


def _positions(model: Model) -> list[str]:
    """Coordinates that are free on the section, but for a clock's phase."""
    return [name for name in model.coordinates if name in model.section and name != model.spec.phase]


def _because_of(model: Model, point: Array, cured: Callable[[Array], Mask]) -> str:
    """The parameters that are at an end of their range, and whose preset would cure it: "with k = 0"."""
    named = []
    for i, parameter in enumerate(model.parameters):
        at_end = point[i] in (parameter.lower, parameter.upper)
        other = point.copy()
        other[i] = parameter.default if parameter.default != point[i] else _inside(point[i], parameter.upper)
        if at_end and cured(other):
            named.append(f"{parameter.name} = {point[i]:g}")
    return f"with {' and '.join(named)}" if named else "here"


def _inside(value: float, upper: float | None) -> float:
    """A value beside an end of a range."""
    return value - 0.1 * (abs(value) or 1.0) if value == upper else value + 0.1 * (abs(value) or 1.0)


def _states(model: Model) -> tuple[Array, Array, Array]:
    """Times, coordinates and rates of some states in and around the search box."""
    rng = np.random.default_rng(0)
    middle, half = np.array([model.spec.search_box[name] for name in model.section]).reshape(-1, 2).T
    reach = np.where(half > 0, half, 0.1)
    z = middle + reach * rng.uniform(-1, 1, (STATES, len(middle)))
    at = model.evaluate("section_state", z=z, p=np.tile(model.point({}), (STATES, 1)))
    q = at["q"] + 0.01 * rng.uniform(-1, 1, at["q"].shape)
    v = at["v"] + 0.01 * rng.uniform(-1, 1, at["v"].shape)
    return rng.uniform(0, 1, STATES), q, v


def _is_held(model: Model, name: str, points: Array) -> Mask:
    """Whether motion, impact or touchdown depends on one coordinate, but that an impact leaves it as it is.

    The exact derivatives say so: beside a stiff controller the force of a spring is lost in rounding.

    Parameters
    ----------
    points : ndarray, shape (..., n_params)

    Returns
    -------
    ndarray of bool, shape (...)
    """
    t, q, v = _states(model)
    p, i = points[..., None, :], model.coordinates.index(name)
    derivatives = [
        model.evaluate("state_derivative_dq", t=t, q=q, v=v, p=p)["dv_dq"][..., i],
        model.evaluate("touchdown_condition_dq", q=q, v=v, p=p)["h_dq"][..., None, i],
        model.evaluate("impact_map_dq", q=q, v=v, p=p)["v_plus_dq"][..., i],
    ]
    shift = np.zeros(q.shape[1])
    shift[i] = model.spec.search_box[name][1] or 0.1
    before, after = (model.evaluate("impact_map", q=at, v=v, p=p)["q_plus"] for at in (q, q + shift))
    moved = np.abs(after - before - shift) > SAME * np.abs(shift).max()
    held = [one.any(axis=(-2, -1)) for one in (*derivatives, moved)]
    return np.asarray(np.logical_or.reduce(held))


def _without_inertia(model: Model, points: Array) -> Mask:
    """Whether some motion of the walker has no kinetic energy, for points of shape (..., n_params)."""
    if "mass_matrix" not in model.spec.functions:
        return np.zeros(points.shape[:-1], dtype=bool)
    _, q, _ = _states(model)
    matrices = model.evaluate("mass_matrix", q=q, p=points[..., None, :])["M"]
    finite = np.isfinite(matrices).all(axis=(-3, -2, -1))
    root = np.sqrt(np.abs(np.diagonal(matrices, axis1=-2, axis2=-1)))
    massless = np.asarray(~(root > 0).all(axis=(-2, -1)))
    usable = np.asarray(finite & ~massless)
    scaled = np.where(usable[..., None, None, None], matrices, np.eye(matrices.shape[-1]))
    root = np.where(usable[..., None, None], root, 1.0)
    values = np.linalg.eigvalsh(scaled / root[..., :, None] / root[..., None, :])
    singular = (values[..., 0] <= SINGULAR * values[..., -1]).all(axis=-1)
    return np.asarray(finite & (massless | singular))
