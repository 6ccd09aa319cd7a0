"""``stridemap branch``: all branches of limit cycles over one parameter."""

import json
import sys
from pathlib import Path
from typing import Annotated, Any

import typer

from stridemap.cli.options import (
    FOUND,
    NOTHING,
    ContinuationOption,
    CsvOption,
    FrictionOption,
    JsonOption,
    ModelOption,
    PeriodNOption,
    SearchOption,
    SetOption,
    TableOption,
    one_format,
    option_values,
    parameters,
    whole,
)


def branch(
    context: typer.Context,
    vary: Annotated[str, typer.Option(metavar="NAME", help="The parameter that varies.")],
    range_: Annotated[
        tuple[float, float], typer.Option("--range", metavar="LOW HIGH", help="Its lowest and highest value.")
    ],
    model: ModelOption = "wobbling",
    set_: SetOption = None,
    period_n: PeriodNOption = 1,
    cascade: Annotated[int, whole("Doublings in a row that are followed onto the doubled branches.")] = 0,
    seeds: Annotated[int, whole("Values of the parameter at which cycles are searched for.")] = 12,
    friction_limit: FrictionOption = None,
    starts: Annotated[int, whole("Number of quasi-random starts at each of these values.")] = 256,
    search: SearchOption = None,
    continuation: ContinuationOption = None,
    out: TableOption = None,
    plot: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Draw the bifurcation diagram (.svg, .png, .pdf).")
    ] = None,
    show: Annotated[str, typer.Option(metavar="COLUMN", help="What the diagram shows.")] = "period",
    json_: JsonOption = False,
    csv: CsvOption = False,
) -> int:
    """Follow all branches of limit cycles over one parameter and locate their special points."""
    from stridemap.cli.output import print_table
    from stridemap.cli.progress import show_lines
    from stridemap.solver.api.branches import branches
    from stridemap.solver.branches.tables import table_writer
    from stridemap.solver.model.loading import load
    from stridemap.solver.options import ContinuationOptions, SearchOptions
    from stridemap.tables.export import csv_text
    from stridemap.views.branch_diagram import check_column, check_picture

    one_format(json_, csv)
    if out is not None:
        table_writer(out)
    if plot is not None:
        check_picture(plot)
        check_column(load(model), show)
    with show_lines(f"branches over {vary}") as say:
        found = branches(
            model,
            vary,
            range_,
            parameters(context.args, set_),
            period_n=period_n,
            cascade=cascade,
            seeds=seeds,
            friction_limit=friction_limit,
            search=SearchOptions.from_mapping({"starts": starts, **option_values("--search", search)}),
            options=ContinuationOptions.from_mapping(option_values("--continuation", continuation)),
            progress=say,
        )
    if out is not None:
        found.save(out)
    if plot is not None:
        write_figure(found.plot(show), plot)
    if json_:
        print(json.dumps(found.to_dict(), indent=1, allow_nan=False))
    elif csv:
        print(csv_text(found.to_frame()), end="")
    elif len(found):
        print(found)
        rows = [["type", vary, "period", "steps", "gait", "multiplier", "branch"]]
        rows += [
            [
                one.type if one.criticality is None else f"{one.type}, {one.criticality}",
                f"{one.value:.12g}",
                f"{one.period:.10g}",
                str(one.period_n),
                "yes" if one.gait else "no",
                "-" if one.multiplier is None else f"{one.multiplier:.6g}",
                str(one.branch),
            ]
            for one in found.special
        ]
        print_table(rows)
    else:
        print("no limit cycle found", file=sys.stderr)
    return FOUND if len(found) else NOTHING


def write_figure(figure: Any, path: Path) -> None:
    """Write a figure in the format that its path's ending names."""
    from stridemap.errors import StorageError

    try:
        figure.savefig(path)
    except OSError as error:
        raise StorageError(
            f"cannot write {path} ({error.strerror or error}); give a path that can be written"
        ) from None
