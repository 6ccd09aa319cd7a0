"""The solver's public functions, by model name and parameters."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.solver.backends.base import Backend
from stridemap.solver.backends.selection import named_backend
from stridemap.solver.branches.branches import Branches
from stridemap.solver.branches.conditions import GaitConditions
from stridemap.solver.branches.survey import Survey
from stridemap.solver.branches.target_range import span, values_within, wanted
from stridemap.solver.branches.targets import Target, hits
from stridemap.solver.cycles.orbit import Orbit
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model
from stridemap.solver.observables.motion import Motion
from stridemap.solver.options import AcceptanceOptions, ArclengthOptions, SearchOptions
from stridemap.solver.walks.simulator import Walk, walk

MAX_PERIOD_N = 64
"""Most steps of a cycle: the unknowns of all steps are solved for together."""

MAX_CASCADE = 6
MAX_SEEDS = 1000


def find_orbits(
    model: str | Path | Model,
    params: Mapping[str, float] | None = None,
    *,
    options: SearchOptions | Mapping[str, Any] | None = None,
    acceptance: AcceptanceOptions | Mapping[str, Any] | None = None,
    backend: str | Backend | None = None,
    **keywords: float,
) -> Orbits:
    """All limit cycles of one walking step at one point of parameter space, ordered by period.

    Parameters
    ----------
    model : str, path or Model
        Name of a built-in model, path of a model file (``.py``), folder that `stridemap derive` wrote, or
        what `load` or `derive_model` returned.
    params : mapping of str to float, optional
        Parameters by name; what is not given comes from the preset.
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
    """
    loaded = load(model)
    point = loaded.point(joined(params, keywords))
    search = SearchOptions.from_mapping(options or {})
    accepted = AcceptanceOptions.from_mapping(acceptance or {})
    solver = Solver.for_model(loaded, named_backend(backend), accepted)
    return find_all(solver, point[None, :], search)[1]


@dataclass(frozen=True)
class Matches:
    """Limit cycles whose quantity has a wanted value, and where it was looked for.

    Parameters
    ----------
    quantity : str
    value : float
        The wanted one.
    parameter : str
        The parameter that was varied.
    range : (float, float)
        Between which values.
    orbits : Orbits
        The limit cycles, by rising value of the parameter; empty where there is none.
    seen : (float, float) or None
        Smallest and largest value of the quantity among all cycles that were seen; None where it was not
        measured on any.
    n_seen : int
        Number of these cycles.
    """

    quantity: str
    value: float
    parameter: str
    range: tuple[float, float]
    orbits: Orbits
    seen: tuple[float, float] | None
    n_seen: int

    def __len__(self) -> int:
        return len(self.orbits)

    @property
    def values(self) -> NDArray[np.float64]:
        """Values of the parameter, shape (n,)."""
        return self.orbits.params[:, self.orbits.model.spec.names.index(self.parameter)]

    @property
    def summary(self) -> str:
        """What was found, or what was seen instead, in a sentence."""
        where = f"{self.parameter} from {self.range[0]:.6g} to {self.range[1]:.6g}"
        what = f"{self.quantity} = {self.value:.6g}"
        if len(self):
            return f"{len(self)} limit cycle{'s' * (len(self) > 1)} with {what} for {where}"
        if not self.n_seen:
            return f"no limit cycle at all was found for {where}"
        if self.seen is None:
            return f"no limit cycle has {what} for {where}: it is not defined on the {self.n_seen} seen"
        low, high = self.seen
        return (
            f"no limit cycle with {what} was found for {where}: on the {self.n_seen} that were seen, "
            f"{self.quantity} is between {low:.6g} and {high:.6g}"
        )


def find(
    model: str | Path | Model,
    target: str | Mapping[str, float],
    vary: str,
    *,
    range: tuple[Any, Any] | None = None,
    params: Mapping[str, float] | None = None,
    options: SearchOptions | Mapping[str, Any] | None = None,
    backend: str | Backend | None = None,
    **keywords: float,
) -> Matches:
    """Values of a parameter for which a quantity of a limit cycle takes a wanted value, with the cycles.

    All limit cycles are searched at some fifty values of the parameter, and the branch of each is traced
    through folds; the solutions on these branches are found to rounding. A branch that is born and dies
    between two of the values is not seen; a narrower range shows it.

    Parameters
    ----------
    model : str, path or Model
        As for `find_orbits`.
    target : str or mapping
        ``"speed = 0.45"`` or ``{"speed": 0.45}``: a measured quantity that varies continuously, ``period``,
        or an entry of the state just after touchdown.
    vary : str
        The parameter that is varied.
    range : (float, float), optional
        Between which values; by default those that are allowed, where one end has none up to ten times the
        value that the point has.
    params : mapping of str to float, optional
        Parameters by name; what is not given comes from the preset.
    options : SearchOptions or mapping, optional
        Of the search at each value.
    backend : str or Backend, optional
        As for `find_orbits`.
    **keywords : float
        Parameters too.

    Returns
    -------
    Matches

    Raises
    ------
    InputError
        For an unknown model, parameter or quantity, a target that is not understood, or a range that is not
        allowed.

    Examples
    --------
    On which slope does a rimless wheel with spokes 0.6 rad apart roll with speed 0.45?

    >>> found = find("rimless_wheel", "speed = 0.45", "slope", spokes=np.pi / 0.3, lambda2=1, range=(0, 0.3))
    >>> round(found.values[0].item(), 12)
    0.087643564919
    """
    loaded = load(model)
    point = loaded.point(joined(params, keywords))
    quantity, value = wanted(loaded, target)
    if vary not in loaded.spec.names:
        loaded.point({vary: 0.0})  # says which parameters there are
    current = float(point[loaded.spec.names.index(vary)])
    low, high = span(loaded, vary, current, range)
    search = SearchOptions.from_mapping(options or {})
    solver = Solver.for_model(loaded, named_backend(backend))
    sought = Target(quantity, value, vary, low, high)
    found, seen = hits(solver, point, sought, values_within(low, high, current), search)
    amounts = sought.of(seen)
    amounts = amounts[np.isfinite(amounts)]
    reach = (float(amounts.min()), float(amounts.max())) if len(amounts) else None
    return Matches(quantity, value, vary, (low, high), found, reach, len(seen))


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
    return orbit.motion(samples)


def simulate(
    model: str | Path | Model,
    state: Mapping[str, Any] | None = None,
    *,
    start: Mapping[str, Any] | None = None,
    steps: int = 10,
    params: Mapping[str, float] | None = None,
    **keywords: float,
) -> Walk:
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
            raise InputError("there is no limit cycle to start from at this point; give a state")
        state = orbits[int(orbits.spectral_radius.argmin())].state
    return walk(loaded, point, section_state(loaded.section, state), steps)


def branches(
    model: str | Path | Model,
    vary: str,
    range: tuple[float, float],
    params: Mapping[str, float] | None = None,
    *,
    period_n: int = 1,
    cascade: int = 0,
    seeds: int = 12,
    friction_limit: float | None = None,
    search: SearchOptions | Mapping[str, Any] | None = None,
    options: ArclengthOptions | Mapping[str, Any] | None = None,
    backend: str | Backend | None = None,
    progress: Callable[[str], None] | None = None,
    **keywords: float,
) -> Branches:
    """All branches of limit cycles over one parameter, with their bifurcations and the ends of gaits.

    Cycles are searched for at several values of the parameter; each branch is followed once, both ways,
    around folds and through the ends of gaits, as far as the range, the period and the search box reach.

    Parameters
    ----------
    model : str, path or Model
        As for `find_orbits`.
    vary : str
        Name of the parameter that varies.
    range : (float, float)
        Its lowest and its highest value.
    params : mapping of str to float, optional
        The other parameters by name; what is not given comes from the preset.
    period_n : int
        Number of walking steps after which the cycles close.
    cascade : int
        How many doublings in a row are followed onto the branches of twice the period.
    seeds : int
        Number of values of the parameter at which cycles are searched for.
    friction_limit : float, optional
        Largest ratio of horizontal to vertical ground force of a gait.
    search : SearchOptions or mapping, optional
        By default 256 starts at each value.
    options : ArclengthOptions or mapping, optional
        Step control.
    backend : str or Backend, optional
        As for `find_orbits`.
    progress : callable, optional
        Takes a line that says what is being done.
    **keywords : float
        Parameters too.

    Returns
    -------
    Branches

    Raises
    ------
    InputError
        For an unknown model or parameter, an empty range, or a value that is not allowed.

    Examples
    --------
    >>> found = branches("simplest_walker", vary="slope", range=(0.001, 0.018))
    >>> [(one.type, round(one.value, 9)) for one in found.special]
    [('pd', 0.015088438)]
    """
    loaded = load(model)
    given = joined(params, keywords)
    low, high = _range(loaded, vary, range)
    if vary in given:
        raise InputError(
            f"{vary} = {given[vary]!r} is fixed, but it is the parameter that varies; leave it out"
        )
    point = loaded.point({**given, vary: low})
    _whole("period_n", period_n, 1, MAX_PERIOD_N)
    _whole("cascade", cascade, 0, MAX_CASCADE)
    _whole("seeds", seeds, 1, MAX_SEEDS)
    if period_n * 2**cascade > MAX_PERIOD_N:
        raise InputError(
            f"cascade = {cascade} from period_n = {period_n} leads to cycles of {period_n * 2**cascade} "
            f"steps; at most {MAX_PERIOD_N} are followed: lower one of them"
        )
    if friction_limit is not None and not (_is_number(friction_limit) and friction_limit > 0):
        raise InputError(f"friction_limit = {friction_limit!r} is not allowed: a number above 0 is needed")
    solver = Solver.for_model(loaded, named_backend(backend))
    survey = Survey(
        solver,
        point,
        vary,
        low,
        high,
        period_n,
        cascade,
        seeds,
        SearchOptions.from_mapping({"starts": 256} if search is None else search),
        ArclengthOptions.from_mapping(options or {}),
        GaitConditions(solver.kernels, friction_limit),
        progress or _quiet,
    )
    fixed = {
        name: value for name, value in zip(loaded.spec.names, point.tolist(), strict=True) if name != vary
    }
    return Branches(loaded, vary, (low, high), fixed, survey.branches())


def joined(params: Mapping[str, float] | None, keywords: Mapping[str, float]) -> dict[str, float]:
    """Parameters given as a mapping and as keywords.

    Raises
    ------
    InputError
        When `params` is not a mapping, or a parameter is given in both.
    """
    if params is not None and not isinstance(params, Mapping):
        raise InputError(f"params = {params!r} is not a mapping; write params={{'name': value}}")
    if twice := sorted(set(params or {}) & set(keywords)):
        raise InputError(f"{', '.join(twice)} is given twice, in params and as a keyword; leave one out")
    return {**(params or {}), **keywords}


def section_state(names: tuple[str, ...], state: Mapping[str, Any]) -> NDArray[np.float64]:
    """A section point from its entries by name, shape (nz,).

    Raises
    ------
    InputError
        When a name is missing or unknown, or a value is not a finite number.
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
            raise InputError(f"{name} = {value!r} of the state is not a finite number")
    return np.array([float(state[name]) for name in names])


def _quiet(line: str) -> None:
    """Report nothing."""


def _range(model: Model, vary: str, given: Any) -> tuple[float, float]:
    """The two ends of the parameter's range, both of which must be allowed."""
    if vary not in model.spec.names:
        raise InputError(
            f"{vary!r} is not a parameter of the model {model.name}; "
            f"its parameters are {', '.join(model.spec.names)}"
        )
    try:
        low, high = given
    except (TypeError, ValueError):
        raise InputError(
            f"range = {given!r} is not understood; give its two ends, such as (0.1, 60)"
        ) from None
    for end in (low, high):
        if not _is_number(end):
            raise InputError(f"range = {given!r} is not allowed: {end!r} is not a finite number")
    parameter = next(one for one in model.parameters if one.name == vary)
    low, high = (parameter.check(float(end)) for end in (low, high))
    if low >= high:
        raise InputError(f"the range of {vary} from {low:g} to {high:g} is empty: the first must be lower")
    return low, high


def _is_number(value: Any) -> bool:
    number = isinstance(value, int | float | np.number) and not isinstance(value, bool)
    return bool(number and np.isfinite(value))


def _whole(name: str, value: Any, low: int, high: int) -> None:
    whole = isinstance(value, int | np.integer) and not isinstance(value, bool)
    if not whole or not low <= value <= high:
        raise InputError(f"{name} = {value!r} is not allowed: a whole number from {low} to {high} is needed")
