"""``stridemap plot``: one column of a table over another."""

from pathlib import Path
from typing import Annotated

import typer

from stridemap.cli.options import FOUND, TableArgument, TableModelOption
from stridemap.cli.si import TableUnitsOption, table_units


def plot(
    table: TableArgument,
    *,
    x: Annotated[str, typer.Option("--x", metavar="COLUMN", help="Along the horizontal axis.")],
    y: Annotated[str, typer.Option("--y", metavar="COLUMN", help="Along the vertical axis.")],
    out: Annotated[Path, typer.Option(metavar="FILE", help="The picture to write (.svg, .png, .pdf).")],
    colour: Annotated[
        str | None,
        typer.Option("--colour", "--color", metavar="COLUMN", help="What gives the marks their colours."),
    ] = None,
    where: Annotated[
        str | None,
        typer.Option(metavar="CONDITION", help="Draw these rows only, such as 'stable and k < 10'."),
    ] = None,
    model: TableModelOption = None,
    units: TableUnitsOption = None,
) -> int:
    """Draw one column of a table over another: of a sweep, a branch, limit cycles or a walk."""
    from stridemap.tables.reading import read_table, table_head
    from stridemap.tables.where import names_in, selected
    from stridemap.views.branch_diagram import check_picture
    from stridemap.views.scatter import check_columns, plot_table
    from stridemap.views.style import save

    check_picture(out)
    head, names = table_head(table, model, table_units(units)), None
    if head.grid:  # of a sweep, which may be large, only what is drawn is read
        check_columns(head, x, y, colour)
        wanted = {x, y, colour, "stable"}
        if where is not None:
            selected(head.frame, where)
            wanted |= set(names_in(where))
        names = [name for name in head.columns if name in wanted]
    read = read_table(table, model, table_units(units), names)
    figure = plot_table(read, x, y, colour=colour, where=where)
    save(figure, out)
    print(out)
    return FOUND
