"""``stridemap report``: a sweep as one explorable HTML file."""

from pathlib import Path
from typing import Annotated

import typer

PAPER = Path("results/paper")


def report(
    folder: Annotated[Path, typer.Argument(metavar="SWEEP_DIR", help="Output folder of a sweep.")] = PAPER,
    *,
    out: Annotated[Path, typer.Option(metavar="FILE.html", help="The file to write.")],
    model: Annotated[
        str | None, typer.Option("--model", help="File of the sweep's model, if it is not a built-in one.")
    ] = None,
    claims: Annotated[
        Path | None, typer.Option(metavar="FILE", help="What `stridemap claims --json` printed.")
    ] = None,
) -> int:
    """Write a sweep as one HTML file that opens without network: map, cycles, and the walker moving."""
    from stridemap.views.report.write import write_report

    summary = write_report(folder, out, claims, model)
    print(
        f"report of {summary.orbits:,} limit cycles in {summary.cells:,} cells: {summary.path} "
        f"({summary.size / 1e6:.1f} MB)"
    )
    return 0
