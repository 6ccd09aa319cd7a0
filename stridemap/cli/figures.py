"""``stridemap figures``: the paper's figures from computed data."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from stridemap.cli.options import FOUND, INTERRUPTED, whole


def figures(
    out: Annotated[Path, typer.Option(help="Folder of the figures and of the tables behind them.")] = Path(
        "results/paper-figures"
    ),
    only: Annotated[
        list[str] | None, typer.Option(metavar="NAME", help="A figure to draw; by default all are.")
    ] = None,
    workers: Annotated[int | None, whole("Number of processes; by default one a core.")] = None,
) -> int:
    """Draw the paper's figures as SVG and PNG; the sweeps that they need are run or, if there, used again.

    Figures: model, map, profiles, profiles-compass, multipliers, d-max, cot, d-profiles.
    """
    from stridemap.cli.progress import show
    from stridemap.paper.figures.draw import draw_figures

    try:
        with show() as progress:
            paths = draw_figures(out, only or (), workers=workers, progress=progress)
    except KeyboardInterrupt:
        print(f"interrupted: finished parts are kept in {out}; the same command goes on", file=sys.stderr)
        return INTERRUPTED
    for path in paths:
        print(path)
    return FOUND
