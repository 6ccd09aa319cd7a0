"""``stridemap sweep``: all limit cycles of a grid of parameters."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from stridemap.cli.options import (
    FOUND,
    INTERRUPTED,
    NOTHING,
    DeriveTimeoutOption,
    end_like_interrupted,
    whole,
)
from stridemap.errors import InputError


def sweep(
    config: Annotated[Path, typer.Argument(help="TOML file of the sweep.")],
    out: Annotated[Path, typer.Option(help="Output folder.")],
    workers: Annotated[int | None, whole("Number of processes; by default one per core.")] = None,
    dask: Annotated[
        str | None,
        typer.Option(
            metavar="ADDRESS", help="Scheduler of a Dask cluster that does the work, or its scheduler file."
        ),
    ] = None,
    resume: Annotated[bool, typer.Option("--resume", help="Continue from finished tiles.")] = False,
    backend: Annotated[
        str | None, typer.Option(help="What runs the kernels: lanes, scalar or interpreter.")
    ] = None,
    csv: Annotated[
        bool, typer.Option("--csv", help="Write orbits.csv too, as `stridemap export --to csv` does.")
    ] = False,
    tile_cells: Annotated[
        int | None, whole("Most cells of a tile, for more workers; which cycles are found may depend on it.")
    ] = None,
    derive_timeout: DeriveTimeoutOption = None,
) -> int:
    """Find all limit cycles of a grid of parameters; writes orbits, cells and special points as tables."""
    from stridemap.cli.progress import show
    from stridemap.sweeps.run import sweep as sweep_

    if dask is not None and workers is not None:
        raise InputError(
            "--dask and --workers cannot be given together: a cluster has workers of its own; leave one of "
            "them out"
        )
    end_like_interrupted()
    try:
        with show() as progress:
            summary = sweep_(
                config,
                out,
                workers=workers,
                dask=dask,
                resume=resume,
                backend=backend,
                tile_cells=tile_cells,
                progress=progress,
            )
    except KeyboardInterrupt:
        print(f"interrupted: finished tiles are kept in {out}; continue with --resume", file=sys.stderr)
        return INTERRUPTED
    if csv:
        from stridemap.sweeps.config import load_config
        from stridemap.tables.streaming import export_file

        export_file(out, out / "orbits.csv", model=load_config(config).model)
    done = "was finished before" if summary.already_finished else "finished"
    failed = (
        f", {summary.failed_cells:,} cells failed (see the reasons in cells.parquet)"
        if summary.failed_cells
        else ""
    )
    print(
        f"sweep {done}: {summary.orbits:,} limit cycles ({summary.stable_orbits:,} stable) "
        f"in {summary.cells:,} cells{failed}; tables in {summary.folder}"
    )
    counts = [f"{n:,} {name}" for name, n in summary.special.items()]
    counts += [f"{summary.special_not_located:,} not located"] if summary.special_not_located else []
    if counts:
        print(f"special points along the lines of the grid: {', '.join(counts)}")
    return FOUND if summary.orbits else NOTHING
