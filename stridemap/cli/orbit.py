"""``stridemap orbit``: all limit cycles at one point."""

import json
import sys
from typing import Annotated

import typer

from stridemap.cli.options import (
    FOUND,
    NOTHING,
    CsvOption,
    DeriveTimeoutOption,
    JsonOption,
    ModelOption,
    PeriodNOption,
    SearchBoxOption,
    SetOption,
    one_format,
    option_values,
    parameters,
    whole,
)
from stridemap.cli.si import Size, UnitsOption


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
    search_box: SearchBoxOption = None,
    acceptance: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=VALUE", help="An option of the acceptance, such as max_integration_error."
        ),
    ] = None,
    backend: Annotated[
        str | None, typer.Option(help="What runs the kernels: lanes, scalar or interpreter.")
    ] = None,
    units: UnitsOption = None,
    json_: JsonOption = False,
    csv: CsvOption = False,
    derive_timeout: DeriveTimeoutOption = None,
) -> int:
    """Print all limit cycles at one point of parameter space."""
    from stridemap.cli.output import print_csv, print_orbits, print_search
    from stridemap.solver.api.points import find_orbits
    from stridemap.solver.model.loading import load
    from stridemap.solver.options import AcceptanceOptions, SearchOptions

    one_format(json_, csv)
    given = parameters(context.args, set_)
    loaded = load(model)
    size = Size.of(loaded, units)
    params = size.all_own(given)
    options = SearchOptions.from_mapping(size.search(starts, search, search_box))
    accepted = AcceptanceOptions.from_mapping(option_values("--acceptance", acceptance))
    orbits = find_orbits(
        model, params, period_n=period_n, options=options, acceptance=accepted, backend=backend
    )
    if json_:
        point = dict(zip(loaded.spec.names, loaded.point(params).tolist(), strict=True))
        point = {**size.all_shown(point), **{name: float(value) for name, value in given.items()}}
        found = [size.all_shown(o.to_dict()) for o in orbits]
        search_ = size.all_shown(orbits.search.to_dict()) if orbits.search else None
        out = {"model": model, **size.said, "params": point, "orbits": found, "search": search_}
        print(json.dumps(out, indent=1, allow_nan=False))
    elif csv:
        print_csv(orbits, size)
    elif len(orbits):
        print_orbits(orbits, size)
    else:
        print("no limit cycle found", file=sys.stderr)
    if orbits.search and not json_ and not csv:
        print_search(orbits.search, found=len(orbits) > 0)
    return FOUND if len(orbits) else NOTHING
