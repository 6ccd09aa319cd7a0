"""``stridemap figures``: the paper's figures from computed limit cycles."""

from pathlib import Path
from typing import Annotated

import typer

from stridemap.cli.options import FOUND, INTERRUPTED, SetOption, parameters
from stridemap.cli.paper_options import (
    SweepsOption,
    ThinOption,
    WorkersOption,
    say_interrupted,
    sweep_progress,
)


def figures(
    out: Annotated[Path, typer.Option(metavar="FOLDER", help="Folder of the figures.")] = Path(
        "results/paper-figures"
    ),
    only: Annotated[
        list[str] | None, typer.Option(metavar="NAME", help="A figure to draw; by default all are drawn.")
    ] = None,
    sweeps: SweepsOption = None,
    workers: WorkersOption = None,
    set_: SetOption = None,
    thin: ThinOption = 1,
) -> int:
    """Draw the paper's figures as SVG and PNG, from the sweeps that `stridemap claims` decides by.

    A sweep that a figure needs is run if it is not finished. Figures: model, map, profiles, profiles-compass,
    multipliers, d-max, cot, d-profiles.
    """
    from stridemap.paper import figures as draw
    from stridemap.paper.sweeps import default_folder

    params = parameters([], set_)
    folder = default_folder(params, thin) if sweeps is None else sweeps
    try:
        with sweep_progress() as progress:
            paths = draw(
                out,
                only or (),
                sweeps=folder,
                params=params,
                thin=thin,
                workers=workers,
                progress=progress,
            )
    except KeyboardInterrupt:
        say_interrupted(folder)
        return INTERRUPTED
    for path in paths:
        print(path)
    return FOUND
