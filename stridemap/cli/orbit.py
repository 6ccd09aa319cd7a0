"""``stridemap orbit``: all limit cycles at one point."""

import json
import sys
from typing import Annotated

import typer

from stridemap.cli.options import (
    FOUND,
    NOTHING,
    DeriveTimeoutOption,
    JsonOption,
    ModelOption,
    PeriodNOption,
    SetOption,
    box,
    option_values,
    parameters,
    whole,
)


def orbit(
    context: typer.Context,
    model: ModelOption = "wobbling",
    set_: SetOption = None,
    period_n: PeriodNOption = 1,
    starts: Annotated[int, whole("Number of quasi-random starts.")] = 512,
    search: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=VALUE",
            help="An option of the search: seed, period_min, period_max, max_starts, widen.",
        ),
    ] = None,
    search_box: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=LOW:HIGH", help="Where starts lie in an entry of the state; see --search widen=2."
        ),
    ] = None,
    acceptance: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=VALUE", help="An option of the acceptance, such as max_integration_error."
        ),
    ] = None,
    backend: Annotated[
        str | None, typer.Option(help="What runs the kernels: lanes, scalar or interpreter.")
    ] = None,
    json_: JsonOption = False,
    derive_timeout: DeriveTimeoutOption = None,
) -> int:
    """Print all limit cycles at one point of parameter space."""
    from stridemap.cli.output import print_orbits, print_search
    from stridemap.solver.api.points import find_orbits
    from stridemap.solver.model.loading import load
    from stridemap.solver.options import AcceptanceOptions, SearchOptions

    params = parameters(context.args, set_)
    chosen = {"starts": starts, **option_values("--search", search), "search_box": box(search_box)}
    options = SearchOptions.from_mapping(chosen)
    accepted = AcceptanceOptions.from_mapping(option_values("--acceptance", acceptance))
    orbits = find_orbits(
        model, params, period_n=period_n, options=options, acceptance=accepted, backend=backend
    )
    if json_:
        loaded = load(model)
        point = dict(zip(loaded.spec.names, loaded.point(params).tolist(), strict=True))
        found = [o.to_dict() for o in orbits]
        search_ = orbits.search.to_dict() if orbits.search else None
        out = {"model": model, "params": point, "orbits": found, "search": search_}
        print(json.dumps(out, indent=1, allow_nan=False))
    elif len(orbits):
        print_orbits(orbits)
    else:
        print("no limit cycle found", file=sys.stderr)
    if orbits.search and not json_:
        print_search(orbits.search)
    return FOUND if len(orbits) else NOTHING
