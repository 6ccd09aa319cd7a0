"""Limit cycles and walks at one point of parameter space."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.services import shown
from stridemap.solver.api.arguments import MAX_PERIOD_N, joined, section_state, whole
from stridemap.solver.backends.base import Backend
from stridemap.solver.backends.selection import named_backend
from stridemap.solver.cycles.degenerate import why_no_cycle
from stridemap.solver.cycles.orbit import Orbit
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.several_steps import find_all_of_steps
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model
from stridemap.solver.observables.motion import Motion
from stridemap.solver.options import AcceptanceOptions, SearchOptions

if TYPE_CHECKING:
    from stridemap.solver.walks.simulator import Walk


def find_orbits(
    model: str | Path | Model,
    params: Mapping[str, float] | None = None,
    *,
    period_n: int = 1,
    options: SearchOptions | Mapping[str, Any] | None = None,
    acceptance: AcceptanceOptions | Mapping[str, Any] | None = None,
    backend: str | Backend | None = None,
    **keywords: float,
) -> Orbits:
    """All limit cycles of a number of walking steps at one point of parameter space, ordered by period.

    Parameters
    ----------
    model : str, path or Model
        Name of a built-in model, path of a model file (``.py``), folder that `stridemap derive` wrote, or
        what `load` or `derive_model` returned.
    params : mapping of str to float, optional
        Parameters by name; what is not given comes from the preset.
    period_n : int
        Number of walking steps after which the cycles close, and not before; 1 by default. Cycles of several
        steps have a search of their own, because they need not lie on a branch that leaves one of one step.
    options : SearchOptions or mapping, optional
    acceptance : AcceptanceOptions or mapping, optional
    backend : str or Backend, optional
        What runs the kernels: "lanes", "scalar" or "interpreter"; by default the fastest that works here.
    **keywords : float
        Parameters too: ``k=6`` says what ``params={"k": 6}`` says.

    Returns
    -------
    Orbits
        A sequence of `Orbit`; empty where no limit cycle was found.

    Raises
    ------
    InputError
        For an unknown model, parameter or backend, or a value out of range.

    Examples
    --------
    >>> orbits = find_orbits("wobbling", {"k": 6, "alpha": 0.25, "omega": 3})
    >>> [round(orbit.period, 4) for orbit in orbits]
    [1.1545, 1.1837]

    A gait of three steps beside the stable gait of one:

    >>> three = find_orbits("simplest_walker", period_n=3, slope=0.0124)
    >>> [(round(orbit.period, 4), orbit.stable) for orbit in three]
    [(11.4219, True), (11.5105, False)]
    """
    loaded = load(model)
    point = loaded.point(joined(params, keywords))
    search = SearchOptions.from_mapping(options or {})
    accepted = AcceptanceOptions.from_mapping(acceptance or {})
    whole("period_n", period_n, 1, MAX_PERIOD_N)
    solver = Solver.for_model(loaded, named_backend(backend), accepted)
    with shown("searching for limit cycles"):
        if period_n > 1:
            return find_all_of_steps(solver, point, period_n, search)
        found = find_all(solver, point[None, :], search)[1]
    return found if len(found) else _explained(found, point)


def _explained(none: Orbits, point: NDArray[np.float64]) -> Orbits:
    """No limit cycles, with the reason where the equations have one."""
    if none.search is None:
        return none
    return replace(none, search=replace(none.search, reason=why_no_cycle(none.model, point)))


def motion(orbit: Orbit, samples: int = 201) -> Motion:
    """One limit cycle as a motion over one step, whose arrays have no leading axis.

    Parameters
    ----------
    orbit : Orbit
    samples : int
        Number of times, both ends included.

    Raises
    ------
    InputError
        When there is no limit cycle, or for fewer than two samples.
    """
    return Orbit.required(orbit).motion(samples)


def simulate(
    model: str | Path | Model,
    state: Mapping[str, Any] | None = None,
    *,
    start: Mapping[str, Any] | None = None,
    steps: int = 10,
    params: Mapping[str, float] | None = None,
    **keywords: float,
) -> "Walk":
    """Walk from a state just after touchdown, or from within a step, with an event-driven integrator.

    Parameters
    ----------
    model : str, path or Model
        As for `find_orbits`.
    state : mapping of str to float, optional
        Section point; by default that of the limit cycle with the smallest spectral radius at that point.
    start : mapping of str to float, optional
        In place of `state`, a state within a step: every coordinate and every rate by name (a clock's rate
        may be left out), and ``t``, the time since the last touchdown, 0 if it is left out. The swing foot
        must not be below the ground.
    steps : int
    params : mapping of str to float, optional
        Parameters by name; what is not given comes from the preset.
    **keywords : float
        Parameters too.

    Returns
    -------
    Walk

    Raises
    ------
    InputError
        For unusable input, or when no state is given and there is no limit cycle.

    Examples
    --------
    >>> walk = simulate("simplest_walker", {"theta": 0.2, "dtheta": -0.2}, steps=10, slope=0.009)
    >>> walk.outcome.words, len(walk.steps)
    ('walked', 10)
    >>> walk.trajectory(0.1)
    <trajectory of simplest_walker: 409 rows, from 0 to 38.8158>
    """
    from stridemap.solver.walks.simulator import walk  # SciPy's integrators take a while to load

    loaded = load(model)
    point = loaded.point(joined(params, keywords))
    if start is not None and state is not None:
        raise InputError("state and start are two ways to say where a walk begins; give one of them")
    for name, given in (("state", state), ("start", start)):
        if given is not None and not isinstance(given, Mapping):
            raise InputError(f"{name} = {given!r} is not a mapping; write {name}={{'name': value}}")
    if isinstance(steps, bool) or not isinstance(steps, int | np.integer) or steps < 1:
        raise InputError(f"steps = {steps!r} is not allowed: a whole number of at least 1 is needed")
    if start is not None:
        return walk(loaded, point, None, steps, start=start)
    if state is None:
        orbits = find_all(Solver.for_model(loaded), point[None, :])[1]
        if not len(orbits):
            why = why_no_cycle(loaded, point)
            raise InputError(
                "there is no limit cycle to start from at this point; give a state"
                + ("" if why is None else f" ({why})")
            )
        state = orbits[int(orbits.spectral_radius.argmin())].state
    return walk(loaded, point, section_state(loaded.section, state), steps)
