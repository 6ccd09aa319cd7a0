"""The solver's public functions for one point, by model name and keyword parameters."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from stridemap.errors import InputError
from stridemap.solver.cycles import search
from stridemap.solver.cycles.orbit import Orbit
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model
from stridemap.solver.walks.simulator import Walk, walk


def find_orbits(
    model: str | Path | Model, *, options: search.SearchOptions | None = None, **params: float
) -> list[Orbit]:
    """All limit cycles at one point of parameter space, ordered by period.

    Parameters
    ----------
    model : str, path or Model
        Name of a built-in model, path of a model file (``.py``), folder that `stridemap derive` wrote, or
        what `load` or `derive_model` returned.
    options : SearchOptions, optional
    **params : float
        Parameters by name; what is not given comes from the preset.

    Returns
    -------
    list of Orbit
        Empty where no limit cycle was found.

    Raises
    ------
    InputError
        For an unknown model or parameter, or a value out of range.

    Examples
    --------
    >>> [round(orbit.period, 4) for orbit in find_orbits("wobbling", k=6, alpha=0.25, omega=3)]
    [1.1545, 1.1837]
    """
    loaded = load(model)
    return search.find_orbits(loaded, loaded.point(params)[None, :], options)[0]


def simulate(
    model: str | Path | Model, state: Mapping[str, Any] | None = None, *, steps: int = 10, **params: float
) -> Walk:
    """Walk from a state just after touchdown, with an event-driven integrator.

    Parameters
    ----------
    model : str, path or Model
        As for `find_orbits`.
    state : mapping of str to float, optional
        Section point; by default the limit cycle with the smallest largest multiplier at that point.
    steps : int
    **params : float
        Parameters by name; what is not given comes from the preset.

    Returns
    -------
    Walk

    Raises
    ------
    InputError
        For unusable input, or when no state is given and there is no limit cycle.
    """
    loaded = load(model)
    point = loaded.point(params)
    if steps < 1:
        raise InputError(f"steps = {steps} is not allowed: at least 1 step is needed")
    if state is None:
        orbits = search.find_orbits(loaded, point[None, :])[0]
        if not orbits:
            raise InputError("there is no limit cycle to start from at this point; give a state")
        state = min(orbits, key=lambda orbit: orbit.spectral_radius).state
    return walk(loaded, point, section_state(loaded.section, state), steps)


def section_state(names: tuple[str, ...], state: Mapping[str, Any]) -> np.ndarray:
    """A section point from its entries by name, shape (nz,).

    Raises
    ------
    InputError
        When a name is missing or unknown, or a value is no finite number.
    """
    if set(state) != set(names):
        missing, unknown = sorted(set(names) - set(state)), sorted(set(state) - set(names))
        parts = [f"missing: {', '.join(missing)}"] * bool(missing) + [
            f"unknown: {', '.join(unknown)}"
        ] * bool(unknown)
        raise InputError(f"a state needs {', '.join(names)}; {'; '.join(parts)}")
    for name in names:
        value = state[name]
        if (
            isinstance(value, bool)
            or not isinstance(value, int | float | np.number)
            or not np.isfinite(value)
        ):
            raise InputError(f"{name} = {value!r} of the state is no finite number")
    return np.array([float(state[name]) for name in names])
