"""Parameters for which a quantity of a limit cycle takes a wanted value."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.services import shown
from stridemap.solver.api.arguments import joined
from stridemap.solver.backends.base import Backend
from stridemap.solver.backends.selection import named_backend
from stridemap.solver.branches.target_range import span, values_within, wanted
from stridemap.solver.branches.targets import Target, hits
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model
from stridemap.solver.options import SearchOptions


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
    low, high = span(loaded, vary, point, range)
    current = float(point[loaded.spec.names.index(vary)])
    search = SearchOptions.from_mapping(options or {})
    solver = Solver.for_model(loaded, named_backend(backend))
    sought = Target(quantity, value, vary, low, high)
    with shown(f"looking for {quantity} = {value:.6g} over {vary}"):
        found, seen = hits(solver, point, sought, values_within(low, high, current), search)
    amounts = sought.of(seen)
    amounts = amounts[np.isfinite(amounts)]
    reach = (float(amounts.min()), float(amounts.max())) if len(amounts) else None
    return Matches(quantity, value, vary, (low, high), found, reach, len(seen))
