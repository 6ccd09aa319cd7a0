"""``stridemap branch``: all branches of limit cycles over one parameter."""

import json
import sys
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

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
    SearchBoxOption,
    SearchOption,
    SetOption,
    TableOption,
    one_format,
    option_values,
    parameters,
    whole,
)
from stridemap.cli.si import Size, UnitsOption

if TYPE_CHECKING:
    from stridemap.solver.branches.branches import Branches


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
    search_box: SearchBoxOption = None,
    continuation: ContinuationOption = None,
    out: TableOption = None,
    plot: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Draw the bifurcation diagram (.svg, .png, .pdf).")
    ] = None,
    show: Annotated[str, typer.Option(metavar="COLUMN", help="What the diagram shows.")] = "period",
    units: UnitsOption = None,
    json_: JsonOption = False,
    csv: CsvOption = False,
) -> int:
    """Follow all branches of limit cycles over one parameter and locate their special points."""
    from stridemap.cli.progress import show_lines
    from stridemap.solver.api.branches import branches
    from stridemap.solver.branches.tables import save_tables, table_writer
    from stridemap.solver.model.loading import load
    from stridemap.solver.options import ContinuationOptions, SearchOptions
    from stridemap.tables.export import csv_text
    from stridemap.views.branch_diagram import check_column, check_picture

    one_format(json_, csv)
    if out is not None:
        table_writer(out)
    loaded = load(model)
    size, given = Size.of(loaded, units), parameters(context.args, set_)
    if plot is not None:
        check_picture(plot)
        check_column(loaded, show)
    searched = size.search(starts, search, search_box)
    with show_lines(f"branches over {vary}") as say:
        found = branches(
            model,
            vary,
            size.ends(vary, range_),
            size.all_own(given),
            period_n=period_n,
            cascade=cascade,
            seeds=seeds,
            friction_limit=friction_limit,
            search=SearchOptions.from_mapping(searched),
            options=ContinuationOptions.from_mapping(option_values("--continuation", continuation)),
            progress=say,
        )
    if out is not None:
        tables = {"": found.to_frame, "_special": found.special_frame}
        save_tables(out, {name: partial(sized, size, make) for name, make in tables.items()})
    if plot is not None:
        write_figure(found.plot(show, units=size.units), plot)
    if json_:
        print(json.dumps(_plain(found, size, range_, given), indent=1, allow_nan=False))
    elif csv:
        print(csv_text(size.frame(found.to_frame())), end="")
    elif len(found):
        print(found.summary(size.factor(vary), size.unit(vary)))
        _print_special(found, size)
    else:
        print("no limit cycle found", file=sys.stderr)
    return FOUND if len(found) else NOTHING


def sized(size: Size, make: Callable[[], Any]) -> Any:
    """What makes a data frame, in the units in which it is written."""
    return size.frame(make())


def _print_special(found: "Branches", size: Size) -> None:
    """Print the special points as a table."""
    from stridemap.cli.output import print_table

    vary = found.vary
    rows = [["type", size.titled(vary), size.titled("period"), "steps", "gait", "multiplier", "branch"]]
    rows += [
        [
            one.type if one.criticality is None else f"{one.type}, {one.criticality}",
            f"{size.shown(vary, one.value):.12g}",
            f"{size.shown('period', one.period):.10g}",
            str(one.period_n),
            "yes" if one.gait else "no",
            "-" if one.multiplier is None else f"{one.multiplier:.6g}",
            str(one.branch),
        ]
        for one in found.special
    ]
    print_table(rows)


def _plain(
    found: "Branches", size: Size, ends: tuple[float, float], given: Mapping[str, Any]
) -> dict[str, Any]:
    """Plain values for JSON in the units in which they are printed; what was given has its own digits."""
    plain = found.to_dict()
    if size.units is None:
        return plain
    names = [*found.model.section, "period"]
    out = {**size.all_shown(plain), **size.said, "range": list(ends)}
    out["params"] |= {name: float(value) for name, value in given.items()}
    for branch in out["branches"]:
        branch |= {key: size.shown(found.vary, branch[key]) for key in ("from", "to")}
        for one in branch["special"]:
            one["value"] = size.shown(found.vary, one["value"])
            one["steps"] = [
                [size.shown(name, value) for name, value in zip(names, step, strict=True)]
                for step in one["steps"]
            ]
    return out


def write_figure(figure: Any, path: Path) -> None:
    """Write a figure in the format that its path's ending names."""
    from stridemap.errors import StorageError

    try:
        figure.savefig(path)
    except OSError as error:
        raise StorageError(
            f"cannot write {path} ({error.strerror or error}); give a path that can be written"
        ) from None
