"""``stridemap boundary``: all bifurcations and ends of gaits as curves in the plane of two parameters."""

import json
import sys
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stridemap.cli.branch import sized, write_figure
from stridemap.cli.options import (
    FOUND,
    NOTHING,
    ContinuationOption,
    CsvOption,
    FrictionOption,
    JsonOption,
    ModelOption,
    PeriodNOption,
    SearchBoxOption,
    SearchOption,
    SetOption,
    TableOption,
    number_pairs,
    one_format,
    option_values,
    parameters,
    whole,
)
from stridemap.cli.si import Size, UnitsOption

if TYPE_CHECKING:
    from stridemap.solver.boundaries.boundaries import Boundaries


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
    search_box: SearchBoxOption = None,
    continuation: ContinuationOption = None,
    out: TableOption = None,
    plot: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Draw the boundaries (.svg, .png, .pdf).")
    ] = None,
    units: UnitsOption = None,
    json_: JsonOption = False,
    csv: CsvOption = False,
) -> int:
    """Follow all bifurcations and ends of gaits in the plane of two parameters."""
    from stridemap.cli.progress import show_lines
    from stridemap.solver.api.boundaries import boundaries
    from stridemap.solver.branches.tables import save_tables, table_writer
    from stridemap.solver.model.loading import load
    from stridemap.solver.options import ContinuationOptions, SearchOptions
    from stridemap.tables.export import csv_text
    from stridemap.views.branch_diagram import check_picture

    one_format(json_, csv)
    if out is not None:
        table_writer(out)
    if plot is not None:
        check_picture(plot)
    size, given = Size.of(load(model), units), parameters(context.args, set_)
    ends = number_pairs(range_, "--range")
    # Whoever needs as many ranges as parameters refuses others.
    own = [size.ends(name, one) for name, one in zip(vary, ends, strict=False)] + ends[len(vary) :]
    searched = size.search(starts, search, search_box)
    with show_lines("boundaries") as say:
        found = boundaries(
            model,
            vary,
            own,
            size.all_own(given),
            period_n=period_n,
            lines=lines,
            seeds=seeds,
            friction_limit=friction_limit,
            search=SearchOptions.from_mapping(searched),
            options=ContinuationOptions.from_mapping(option_values("--continuation", continuation)),
            progress=say,
        )
    if out is not None:
        tables = {"": found.to_frame, "_points": found.points_frame}
        save_tables(out, {name: partial(sized, size, make) for name, make in tables.items()})
    if plot is not None:
        write_figure(found.plot(units=size.units), plot)
    if json_:
        print(json.dumps(_plain(found, size, ends, given), indent=1, allow_nan=False))
    elif csv:
        print(csv_text(size.frame(found.to_frame())), end="")
    elif len(found):
        first, second = found.vary
        factors = size.factor(first), size.factor(second)
        print(found.summary(factors, (size.unit(first), size.unit(second))))
        _print_points(found, size)
    else:
        print("no boundary found", file=sys.stderr)
    return FOUND if len(found) else NOTHING


def _print_points(found: "Boundaries", size: Size) -> None:
    """Print the points at which two things happen at once as a table."""
    from stridemap.cli.output import print_table

    rows = [["type", *map(size.titled, found.vary), size.titled("period"), "gait", "meets", "boundary"]]
    rows += [
        [
            one.type,
            *(f"{size.shown(name, one.params[name]):.12g}" for name in found.vary),
            f"{size.shown('period', one.period):.10g}",
            "yes" if one.gait else "no",
            one.meets or "-",
            str(one.boundary),
        ]
        for one in found.points
    ]
    if len(rows) > 1:
        print_table(rows)


def _plain(
    found: "Boundaries", size: Size, ends: list[tuple[float, float]], given: Mapping[str, Any]
) -> dict[str, Any]:
    """Plain values for JSON in the units in which they are printed; what was given has its own digits."""
    plain = found.to_dict()
    if size.units is None:
        return plain
    out = {**size.all_shown(plain), **size.said, "ranges": [list(one) for one in ends]}
    out["params"] |= {name: float(value) for name, value in given.items()}
    for one in out["boundaries"]:
        one["curve"] = [
            [size.shown(name, value) for name, value in zip(found.vary, point, strict=True)]
            for point in one["curve"]
        ]
    return out
