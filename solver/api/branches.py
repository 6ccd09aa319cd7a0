"""All branches of limit cycles over one parameter."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from stridemap.errors import InputError
from stridemap.solver.api.arguments import MAX_PERIOD_N, joined, limit_of_friction, quiet, whole
from stridemap.solver.backends.base import Backend
from stridemap.solver.backends.selection import named_backend
from stridemap.solver.branches.branches import Branches
from stridemap.solver.branches.conditions import GaitConditions
from stridemap.solver.branches.survey import Survey
from stridemap.solver.branches.target_range import span
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model
from stridemap.solver.options import ContinuationOptions, SearchOptions

MAX_CASCADE = 6
"""Doublings in a row: one more than lead to `MAX_PERIOD_N` steps are refused in any case."""

MAX_SEEDS = 1000
"""Values of the parameter at which cycles are searched for: each takes about a second."""


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
    options: ContinuationOptions | Mapping[str, Any] | None = None,
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
    options : ContinuationOptions or mapping, optional
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
    if vary in given:
        raise InputError(
            f"{vary} = {given[vary]!r} is fixed, but it is the parameter that varies; leave it out"
        )
    point = loaded.point(given)
    low, high = span(loaded, vary, point, range)
    whole("period_n", period_n, 1, MAX_PERIOD_N)
    whole("cascade", cascade, 0, MAX_CASCADE)
    whole("seeds", seeds, 1, MAX_SEEDS)
    if period_n * 2**cascade > MAX_PERIOD_N:
        raise InputError(
            f"cascade = {cascade} from period_n = {period_n} leads to cycles of {period_n * 2**cascade} "
            f"steps; at most {MAX_PERIOD_N} are followed: lower one of them"
        )
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
        ContinuationOptions.from_mapping(options or {}),
        GaitConditions(solver.kernels, limit_of_friction(friction_limit)),
        progress or quiet,
    )
    fixed = {
        name: value for name, value in zip(loaded.spec.names, point.tolist(), strict=True) if name != vary
    }
    return Branches(loaded, vary, (low, high), fixed, survey.branches())
