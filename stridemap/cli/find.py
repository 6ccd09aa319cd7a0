"""``stridemap find``: the value of a parameter for which a quantity takes a wanted value."""

import json
import sys
from typing import Annotated, Any

import typer

from stridemap.cli.options import (
    FOUND,
    NOTHING,
    CsvOption,
    JsonOption,
    ModelOption,
    SearchBoxOption,
    SearchOption,
    SetOption,
    one_format,
    parameters,
    whole,
)
from stridemap.cli.si import Size, UnitsOption


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
    search: SearchOption = None,
    search_box: SearchBoxOption = None,
    backend: Annotated[
        str | None, typer.Option(help="What runs the kernels: lanes, scalar or interpreter.")
    ] = None,
    units: UnitsOption = None,
    json_: JsonOption = False,
    csv: CsvOption = False,
) -> int:
    """Find the value of a parameter for which a limit cycle has a wanted speed, cost, period or the like.

    All limit cycles with the wanted value are printed.
    """
    from stridemap.cli.output import print_csv, print_orbits
    from stridemap.solver.api.targets import find as find_
    from stridemap.solver.model.loading import load
    from stridemap.solver.options import SearchOptions

    one_format(json_, csv)
    size = Size.of(load(model), units)
    params = size.all_own(parameters(context.args, set_))
    ends: Any = range_  # whoever knows what is allowed refuses what is not a number
    if size.units is not None:
        target, ends = _own(target, vary, range_, size)
    options = SearchOptions.from_mapping(size.search(starts, search, search_box))
    found = find_(model, target, vary, range=ends, params=params, options=options, backend=backend)
    if json_:
        out = {
            "model": model,
            **size.said,
            "target": {"quantity": found.quantity, "value": size.shown(found.quantity, found.value)},
            "vary": found.parameter,
            "range": [size.shown(found.parameter, end) for end in found.range],
            "cycles_seen": found.n_seen,
            "seen": None if found.seen is None else [size.shown(found.quantity, one) for one in found.seen],
            "orbits": [size.all_shown({"params": dict(o.params), **o.to_dict()}) for o in found.orbits],
        }
        print(json.dumps(out, indent=1, allow_nan=False))
    elif csv:
        print_csv(found.orbits, size)
    elif len(found):
        print_orbits(found.orbits, size, found.parameter)
    else:
        print(found.summary, file=sys.stderr)
    return FOUND if len(found) else NOTHING


def _own(target: str, vary: str, ends: tuple[str, str] | None, size: Size) -> tuple[str, Any]:
    """A target and a range in SI units, as the model has them; what is not a number stays as it is."""
    name, equals, text = (part.strip() for part in target.partition("="))
    if equals and isinstance(value := _number(text), float):
        target = f"{name} = {size.own(name, value)!r}"
    return target, ends and tuple(size.own(vary, _number(end)) for end in ends)


def _number(text: str) -> Any:
    try:
        return float(text)
    except ValueError:
        return text
