"""``stridemap report``: a sweep as one explorable HTML file."""

from pathlib import Path
from typing import Annotated

import typer

from stridemap.cli.options import FOUND, INTERRUPTED, DeriveTimeoutOption, SetOption, box, parameters, whole
from stridemap.cli.paper_options import (
    SweepsOption,
    ThinOption,
    WorkersOption,
    say_interrupted,
    sweep_progress,
)
from stridemap.errors import InputError
from stridemap.services import shown


def report(
    folder: Annotated[
        Path | None,
        typer.Argument(metavar="SWEEP_DIR", help="Output folder of a sweep; by default the paper's map."),
    ] = None,
    *,
    out: Annotated[Path, typer.Option(metavar="FILE.html", help="The file to write.")],
    model: Annotated[
        str | None, typer.Option("--model", help="File of the sweep's model, if it is not a built-in one.")
    ] = None,
    claims: Annotated[
        Path | None, typer.Option(metavar="FILE", help="What `stridemap claims --json` printed.")
    ] = None,
    curves: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Boundaries to draw: what `stridemap boundary --out` wrote."),
    ] = None,
    branches: Annotated[
        list[Path] | None,
        typer.Option(
            metavar="FILE",
            help="Branches to draw in slices: what `stridemap branch --out` wrote; may be repeated.",
        ),
    ] = None,
    part: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME=LOW:HIGH", help="Show the grid between two values of a parameter only."),
    ] = None,
    most_cycles: Annotated[
        int, whole("Limit cycles above which every so many values of the grid are shown.")
    ] = 100_000,
    sweeps: SweepsOption = None,
    workers: WorkersOption = None,
    set_: SetOption = None,
    thin: ThinOption = 1,
    derive_timeout: DeriveTimeoutOption = None,
) -> int:
    """Write a sweep as one HTML file that opens without network: map, cycles, and the walker moving.

    Without SWEEP_DIR it is the map of the paper's sweeps, with the verdicts of `stridemap claims`; what is
    not finished is swept first. --sweeps, --workers, --set and --thin are for these sweeps.
    """
    from stridemap.paper import report as report_paper
    from stridemap.paper.points import KEPT
    from stridemap.paper.sweeps import default_folder
    from stridemap.views import write_report

    if folder is not None:
        given = {"--sweeps": sweeps, "--workers": workers, "--set": set_, "--thin": thin > 1 or None}
        unusable = [option for option, value in given.items() if value is not None]
        if unusable:
            raise InputError(
                f"{', '.join(unusable)} cannot be given with the sweep in {folder}, but only for the paper's "
                "sweeps; leave it out, or leave the folder out"
            )
        with shown("writing the report"):
            summary = write_report(
                folder,
                out,
                claims,
                model,
                curves,
                branches=branches or (),
                part=box(part, "--part"),
                most_cycles=most_cycles,
                kept=KEPT,
            )
    elif curves is not None:
        raise InputError(
            "--curves is for the sweep in SWEEP_DIR; give that folder, or leave --curves out: the paper's "
            "map has its own"
        )
    elif model is not None:
        raise InputError("--model is for the sweep in SWEEP_DIR; give that folder, or leave --model out")
    elif part is not None:
        raise InputError("--part is for the sweep in SWEEP_DIR; give that folder, or leave --part out")
    else:
        params = parameters([], set_)
        where = default_folder(params, thin) if sweeps is None else sweeps
        try:
            with sweep_progress() as progress:
                summary = report_paper(
                    out,
                    claims=claims,
                    branches=branches or (),
                    sweeps=where,
                    params=params,
                    thin=thin,
                    workers=workers,
                    progress=progress,
                )
        except KeyboardInterrupt:
            say_interrupted(where)
            return INTERRUPTED
    of = [
        f"{shown:,}" if shown == every else f"{shown:,} of {every:,}"
        for shown, every in ((summary.orbits, summary.all_orbits), (summary.cells, summary.all_cells))
    ]
    print(f"report of {of[0]} limit cycles in {of[1]} cells: {summary.path} ({summary.size / 1e6:.1f} MB)")
    return FOUND
