"""All boundaries of limit cycles in the plane of two parameters."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from stridemap.errors import InputError
from stridemap.solver.api.arguments import MAX_PERIOD_N, joined, limit_of_friction, quiet, whole
from stridemap.solver.api.branches import MAX_SEEDS
from stridemap.solver.backends.base import Backend
from stridemap.solver.backends.selection import named_backend
from stridemap.solver.boundaries.boundaries import Boundaries
from stridemap.solver.boundaries.survey import BoundarySurvey
from stridemap.solver.branches.conditions import GaitConditions
from stridemap.solver.branches.survey import Survey
from stridemap.solver.branches.target_range import span
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model
from stridemap.solver.options import ContinuationOptions, SearchOptions

MAX_LINES = 100
"""Values of each parameter at which branches are followed: each takes some seconds to a minute."""


def boundaries(
    model: str | Path | Model,
    vary: Sequence[str],
    ranges: Sequence[tuple[float, float]],
    params: Mapping[str, float] | None = None,
    *,
    period_n: int = 1,
    lines: int = 4,
    seeds: int = 6,
    friction_limit: float | None = None,
    search: SearchOptions | Mapping[str, Any] | None = None,
    options: ContinuationOptions | Mapping[str, Any] | None = None,
    backend: str | Backend | None = None,
    progress: Callable[[str], None] | None = None,
    **keywords: float,
) -> Boundaries:
    """All bifurcations and ends of gaits as curves in the plane of two parameters.

    Branches over one parameter are followed at several values of the other, and the other way round
    (`lines`); every boundary that they cross is then followed once, both ways, as far as the ranges, the
    period and the search box reach. A boundary that crosses none of these lines is not found.

    Parameters
    ----------
    model : str, path or Model
        As for `find_orbits`.
    vary : (str, str)
        Names of the two parameters.
    ranges : ((float, float), (float, float))
        Lowest and highest value of each.
    params : mapping of str to float, optional
        The other parameters by name; what is not given comes from the preset.
    period_n : int
        Number of walking steps after which the cycles close.
    lines : int
        Number of values of each parameter at which branches over the other one are followed.
    seeds : int
        Number of values, on each of these lines, at which cycles are searched for.
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
    Boundaries

    Raises
    ------
    InputError
        For an unknown model or parameter, the same parameter twice, an empty range, or a value that is not
        allowed.

    Examples
    --------
    The slopes at which the compass's gait doubles its period, by the ratio of its masses:

    >>> found = boundaries("goswami_compass", ("slope", "mu"), ((0.05, 0.1), (1, 4)), lines=1, seeds=2)
    >>> [one.type for one in found]
    ['pd']
    """
    loaded = load(model)
    given = joined(params, keywords)
    names = _pair("vary", vary, "two names of parameters")
    pairs = _pair("ranges", ranges, "two pairs of numbers, one for each parameter")
    if names[0] == names[1]:
        raise InputError(f"vary = {names[0]!r} twice; two different parameters are needed")
    for name in names:
        if name in given:
            raise InputError(
                f"{name} = {given[name]!r} is fixed, but it is a parameter that varies; leave it out"
            )
    point = loaded.point(given)
    ends = [span(loaded, name, point, pair) for name, pair in zip(names, pairs, strict=True)]
    whole("period_n", period_n, 1, MAX_PERIOD_N)
    whole("lines", lines, 1, MAX_LINES)
    whole("seeds", seeds, 1, MAX_SEEDS)
    solver = Solver.for_model(loaded, named_backend(backend))
    along = Survey(
        solver,
        point,
        names[0],
        *ends[0],
        period_n,
        0,
        seeds,
        SearchOptions.from_mapping({"starts": 256} if search is None else search),
        ContinuationOptions.from_mapping(options or {}),
        GaitConditions(solver.kernels, limit_of_friction(friction_limit)),
        quiet,
    )
    low, high = (ends[0][0], ends[1][0]), (ends[0][1], ends[1][1])
    survey = BoundarySurvey(along, (names[0], names[1]), low, high, lines, progress or quiet)
    values = zip(loaded.spec.names, point.tolist(), strict=True)
    fixed = {name: value for name, value in values if name not in names}
    return Boundaries(loaded, (names[0], names[1]), (ends[0], ends[1]), fixed, survey.boundaries())


def _pair(word: str, given: Any, what: str) -> list[Any]:
    """Two entries of a sequence; a string is none."""
    entries = list(given) if isinstance(given, Sequence) and not isinstance(given, str) else []
    if len(entries) != 2:
        said = ", ".join(map(str, entries)) if entries else repr(given)
        raise InputError(f"{word} = {said} is not allowed: {what} are needed")
    return entries
