"""``stridemap animate``: a limit cycle as a looping GIF."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from stridemap.cli.options import (
    FOUND,
    NOTHING,
    DeriveTimeoutOption,
    ModelOption,
    PeriodNOption,
    SetOption,
    parameters,
    whole,
)
from stridemap.cli.si import GivenUnitsOption, Size


def animate(
    context: typer.Context,
    out: Annotated[Path, typer.Option(help="The GIF to write.")],
    model: ModelOption = "wobbling",
    set_: SetOption = None,
    group: Annotated[str | None, typer.Option(help="Show the most stable cycle of this group.")] = None,
    cycle: Annotated[int | None, whole("Show this cycle, as `stridemap orbit` numbers them.")] = None,
    period_n: PeriodNOption = 1,
    steps: Annotated[int | None, whole("Number of steps until it repeats, an even number.")] = None,
    fps: Annotated[int, whole("Frames per second.")] = 25,
    size: Annotated[int, whole("Width and height in pixels.")] = 320,
    magnify: Annotated[
        float, typer.Option(help="Enlarge the displacement of the wobbling mass by this factor.")
    ] = 1.0,
    units: GivenUnitsOption = None,
    derive_timeout: DeriveTimeoutOption = None,
) -> int:
    """Show a limit cycle walking, as a GIF that loops; by default the most stable one at the point."""
    from stridemap.solver.api.points import find_orbits
    from stridemap.solver.model.loading import load
    from stridemap.views.animation import animate as animate_
    from stridemap.views.animation import choose

    robot = Size.of(load(model), units)
    params = robot.all_own(parameters(context.args, set_))
    orbits = find_orbits(model, params, period_n=period_n)
    if not orbits:
        print("no limit cycle found", file=sys.stderr)
        return NOTHING
    chosen = choose(orbits, group, cycle)
    print(animate_([chosen], out, steps=steps, fps=fps, size=size, magnify=magnify))
    return FOUND
