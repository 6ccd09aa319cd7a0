"""``stridemap export``: a table for other programs."""

from pathlib import Path
from typing import Annotated

import typer

from stridemap.cli.options import FOUND, NOTHING, TableArgument, TableModelOption
from stridemap.cli.si import TableUnitsOption, table_units
from stridemap.errors import InputError

KINDS = ("csv", "mat", "nc", "parquet")


def export(
    table: TableArgument,
    *,
    to: Annotated[
        str | None,
        typer.Option(
            metavar="KIND", help="csv, mat (MATLAB), nc (netCDF) or parquet; by default --out's ending."
        ),
    ] = None,
    out: Annotated[
        Path | None, typer.Option(metavar="FILE", help="The file to write; by default beside the table.")
    ] = None,
    where: Annotated[
        str | None,
        typer.Option(metavar="CONDITION", help="Write these rows only, such as 'stable and k < 10'."),
    ] = None,
    columns: Annotated[
        str | None,
        typer.Option(metavar="NAME,...", help="Write these columns only, such as k,alpha,cot."),
    ] = None,
    by: Annotated[
        str, typer.Option(metavar="DIMENSION", help="Of a sweep in nc, behind its grid: cycle or branch.")
    ] = "cycle",
    model: TableModelOption = None,
    units: TableUnitsOption = None,
) -> int:
    """Write a table for other programs: of a sweep, a branch, limit cycles or a walk."""
    from stridemap.tables.export import check_ending
    from stridemap.tables.streaming import export_file

    target = _target(table, to, out)
    check_ending(target)
    names = None if columns is None else [name.strip() for name in columns.split(",")]
    written, rows = export_file(
        table, target, by, model=model, units=table_units(units), columns=names, where=where
    )
    for path in written:
        print(path)
    return FOUND if rows else NOTHING


def _target(table: Path, to: str | None, out: Path | None) -> Path:
    """The file to write: as it is named, or beside the table with the ending of its kind."""
    if to is not None and to not in KINDS:
        raise InputError(f"--to {to} is not a kind of file; kinds are {', '.join(KINDS)}")
    if out is None:
        if to is None:
            raise InputError(
                f"say what to write: --to {', --to '.join(KINDS)}, or --out FILE with such an ending"
            )
        target = table / f"orbits.{to}" if table.is_dir() else table.with_suffix(f".{to}")
        if target == table:
            raise InputError(f"{table} is of that kind already; name another file with --out")
        return target
    if to is not None and out.suffix != f".{to}":
        raise InputError(f"--out {out} does not end in .{to}, which --to asks for; leave one of them out")
    return out
