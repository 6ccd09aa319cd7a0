"""``stridemap find``: the value of a parameter for which a quantity takes a wanted value."""

import json
import sys
from typing import Annotated, Any

import typer

from stridemap.cli.options import (
    FOUND,
    NOTHING,
    JsonOption,
    ModelOption,
    SetOption,
    option_values,
    parameters,
    whole,
)


def find(
    context: typer.Context,
    target: Annotated[str, typer.Option(help="What is wanted of a limit cycle, such as 'speed = 0.45'.")],
    vary: Annotated[str, typer.Option(help="The parameter that may vary.")],
    range_: Annotated[
        tuple[str, str] | None,
        typer.Option("--range", metavar="LOW HIGH", help="Between which values; by default all."),
    ] = None,
    model: ModelOption = "wobbling",
    set_: SetOption = None,
    starts: Annotated[int, whole("Number of quasi-random starts at each value.")] = 512,
    search: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME=VALUE", help="An option of the search: seed, period_min, period_max."),
    ] = None,
    backend: Annotated[
        str | None, typer.Option(help="What runs the kernels: lanes, scalar or interpreter.")
    ] = None,
    json_: JsonOption = False,
) -> int:
    """Find the value of a parameter for which a limit cycle has a wanted speed, cost, period or the like.

    All limit cycles with the wanted value are printed.
    """
    from stridemap.cli.output import print_orbits
    from stridemap.solver.api.targets import find as find_
    from stridemap.solver.options import SearchOptions

    params = parameters(context.args, set_)
    ends: Any = range_  # whoever knows what is allowed refuses what is not a number
    options = SearchOptions.from_mapping({"starts": starts, **option_values("--search", search)})
    found = find_(model, target, vary, range=ends, params=params, options=options, backend=backend)
    if json_:
        out = {
            "model": model,
            "target": {"quantity": found.quantity, "value": found.value},
            "vary": found.parameter,
            "range": list(found.range),
            "cycles_seen": found.n_seen,
            "seen": None if found.seen is None else list(found.seen),
            "orbits": [{"params": dict(o.params), **o.to_dict()} for o in found.orbits],
        }
        print(json.dumps(out, indent=1, allow_nan=False))
    elif len(found):
        print_orbits(found.orbits, found.parameter)
    else:
        print(found.summary, file=sys.stderr)
    return FOUND if len(found) else NOTHING
