"""Words that tables and options have taken, so that no parameter or coordinate of a model may bear them.

A leaf, like `stridemap.spec`: tables take their columns from here, and a declaration is checked against it.
"""

import difflib
import re
from collections.abc import Iterable

from stridemap.quantities import QUANTITIES

CELL_COLUMNS = {
    "cell": "number of the grid cell",
    "model": "name of the model",
    "params": "parameters of the cell",
    "state": "point on the section",
    "status": "how it ended",
    "reason": "why a cell failed",
    "orbits": "limit cycles found in the cell",
    "stable_orbits": "stable limit cycles found in the cell",
    "branch": "branch of limit cycles",
    "period_n": "walking steps until the gait repeats",
    "multipliers": "Floquet multipliers",
    "arclength": "distance along the branch",
    "steps": "section point and period of each step",
    "gait": "whether a walker could walk it",
    "type": "what happens at a special point",
    "value": "value of the parameter that varies",
    "boundary": "boundary in the plane of two parameters",
    "borders_stable": "whether gaits beside it are stable",
    "meets": "the other boundary at a corner",
    "curve": "points in the plane of two parameters",
    "multiplier": "the multiplier that crosses the unit circle",
    "crossing_slope": "how fast a special point is crossed",
    "criticality": "on which side doubled cycles exist",
    "null": "the direction that neither grows nor shrinks",
    "line": "first cell of the line of the grid",
    "lower": "lower end of where a special point lies, in the model's units",
    "upper": "upper end of where a special point lies, in the model's units",
}
"""Columns of tables and keys of JSON that are not measured quantities, each with what it holds."""


TRAJECTORY_COLUMNS = {
    "time": "time since the start of a walk",
    "step": "number of the step",
    "step_time": "time since the touchdown that began the step",
    "stance_leg": "leg on the ground",
    "event": "sample or side of an impact",
    "stance_foot_x": "stance foot along the ground",
    "stance_foot_y": "stance foot away from the ground",
    "swing_foot_x": "swing foot along the ground",
    "swing_foot_y": "swing foot away from the ground",
}
"""Columns of the time series of a walk, beside the coordinates and their rates, each with what it holds."""


def multiplier_columns(index: int) -> tuple[str, str]:
    """Columns of a multiplier's real and imaginary part; multipliers count from 0 by falling modulus."""
    return f"multiplier_{index}_re", f"multiplier_{index}_im"


_MULTIPLIER = re.compile(r"multiplier_\d+(_(re|im))?")


def is_multiplier(name: str) -> bool:
    """Whether a column holds a part of a Floquet multiplier."""
    return _MULTIPLIER.fullmatch(name) is not None


ATTRIBUTES = frozenset(
    "animate codes columns concatenate count empty found from_columns index jacobian known_stable measures "
    "model motion multipliers params period plot reason scaled search section_point simulate stability state "
    "status summary take to_dict to_frame to_xarray "
    "u".split()
)
"""Attributes of a limit cycle and of an array of them, which a quantity of that name would hide."""

OPTION_WORDS = frozenset(
    # options of the command line
    "acceptance backend branches by cascade check claims color colour columns config continuation csv curves "
    "cycle dask derive_timeout folder fps from friction_limit group header help json lines magnify model "
    "most_cycles name only out part period_n plot quiet range rate resume search search_box seeds set "
    "shell show size start starts state steps sweeps table target thin to trajectory units vary verbose "
    "where workers "
    # arguments of public functions
    "data executor options orbit orbits params path progress ranges samples source tile_cells "
    "titles".split()
)
"""Options of commands and arguments of public functions, which also take parameters by name."""


def column(name: str) -> str | None:
    """What the column of that name holds, or None where no table has such a column."""
    if name in QUANTITIES:
        return QUANTITIES[name].label
    if _MULTIPLIER.fullmatch(name):
        return "a Floquet multiplier"
    if name.startswith("tangent_"):
        return "the tangent of a branch"
    return CELL_COLUMNS.get(name)


def hint(name: str, known: Iterable[str]) -> str:
    """Return " (did you mean ...?)" if one of the `known` names is close to `name`, else nothing."""
    folded = {candidate.casefold(): candidate for candidate in known}
    close = difflib.get_close_matches(name.casefold(), folded, n=1)
    return f" (did you mean {folded[close[0]]}?)" if close else ""
