"""``stridemap boundary``: all bifurcations and ends of gaits as curves in the plane of two parameters."""

import json
import sys
from pathlib import Path
from typing import Annotated

import typer

from stridemap.cli.branch import write_figure
from stridemap.cli.options import (
    FOUND,
    NOTHING,
    ContinuationOption,
    FrictionOption,
    JsonOption,
    ModelOption,
    PeriodNOption,
    SearchOption,
    SetOption,
    TableOption,
    number_pairs,
    option_values,
    parameters,
    whole,
)


def boundary(
    context: typer.Context,
    vary: Annotated[list[str], typer.Option(metavar="NAME", help="A parameter that varies: give two.")],
    range_: Annotated[
        list[str],
        typer.Option("--range", metavar="LOW HIGH", help="Lowest and highest value, in the same order."),
    ],
    model: ModelOption = "wobbling",
    set_: SetOption = None,
    period_n: PeriodNOption = 1,
    lines: Annotated[int, whole("Values of each parameter at which branches are followed.")] = 4,
    seeds: Annotated[int, whole("Values on each of these lines at which cycles are searched for.")] = 6,
    friction_limit: FrictionOption = None,
    starts: Annotated[int, whole("Number of quasi-random starts at each of these values.")] = 256,
    search: SearchOption = None,
    continuation: ContinuationOption = None,
    out: TableOption = None,
    plot: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Draw the boundaries (.svg, .png, .pdf).")
    ] = None,
    json_: JsonOption = False,
) -> int:
    """Follow all bifurcations and ends of gaits in the plane of two parameters."""
    from stridemap.cli.output import print_table
    from stridemap.cli.progress import show_lines
    from stridemap.solver.api.boundaries import boundaries
    from stridemap.solver.branches.tables import table_writer
    from stridemap.solver.options import ContinuationOptions, SearchOptions
    from stridemap.views.branch_diagram import check_picture

    if out is not None:
        table_writer(out)
    if plot is not None:
        check_picture(plot)
    with show_lines("boundaries") as say:
        found = boundaries(
            model,
            vary,
            number_pairs(range_, "--range"),
            parameters(context.args, set_),
            period_n=period_n,
            lines=lines,
            seeds=seeds,
            friction_limit=friction_limit,
            search=SearchOptions.from_mapping({"starts": starts, **option_values("--search", search)}),
            options=ContinuationOptions.from_mapping(option_values("--continuation", continuation)),
            progress=say,
        )
    if out is not None:
        found.save(out)
    if plot is not None:
        write_figure(found.plot(), plot)
    if json_:
        print(json.dumps(found.to_dict(), indent=1, allow_nan=False))
    elif len(found):
        print(found)
        rows = [["type", *found.vary, "period", "gait", "meets", "boundary"]]
        rows += [
            [
                one.type,
                *(f"{one.params[name]:.12g}" for name in found.vary),
                f"{one.period:.10g}",
                "yes" if one.gait else "no",
                one.meets or "-",
                str(one.boundary),
            ]
            for one in found.points
        ]
        if len(rows) > 1:
            print_table(rows)
    else:
        print("no boundary found", file=sys.stderr)
    return FOUND if len(found) else NOTHING
