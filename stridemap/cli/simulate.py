"""``stridemap simulate``: a walk, step by step, and as a time series."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stridemap.cli.options import (
    FOUND,
    NOTHING,
    DeriveTimeoutOption,
    JsonOption,
    ModelOption,
    SetOption,
    assign,
    parameters,
    split,
    whole,
)
from stridemap.cli.si import Size, UnitsOption
from stridemap.errors import InputError

if TYPE_CHECKING:
    from stridemap.solver.walks.simulator import Walk

RATE = 100.0
"""Rows of a time series per unit of time, unless it is said."""


def simulate(
    context: typer.Context,
    model: ModelOption = "wobbling",
    set_: SetOption = None,
    state: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME=VALUE", help="An entry of the state just after touchdown; all or none."),
    ] = None,
    start: Annotated[
        list[str] | None,
        typer.Option(
            "--from",
            metavar="NAME=VALUE",
            help="Start within a step: a coordinate or rate, all of them, and t, the time since touchdown.",
        ),
    ] = None,
    steps: Annotated[int, whole("Number of steps to walk.")] = 10,
    trajectory: Annotated[
        Path | None,
        typer.Option(help="Write the walk as a time series to this file (.parquet or .csv)."),
    ] = None,
    rate: Annotated[
        float | None, typer.Option(help=f"Samples of the time series per unit of time; {RATE:g} by default.")
    ] = None,
    units: UnitsOption = None,
    json_: JsonOption = False,
    derive_timeout: DeriveTimeoutOption = None,
) -> int:
    """Walk from a state just after touchdown (by default the most stable limit cycle), step by step.

    With --from the walk begins within a step. With --trajectory it is written as an evenly sampled series.

    The integrator is event-driven and shares nothing with the search for limit cycles.
    """
    from stridemap.cli.series import check_ending, write_series
    from stridemap.solver.api.points import simulate as simulate_
    from stridemap.solver.model.loading import load

    size = Size.of(load(model), units)
    dt = size.own("time", _spacing(rate, trajectory))
    if trajectory is not None:
        check_ending(trajectory)
    params = size.all_own(parameters(context.args, set_))
    walk = simulate_(
        model,
        _entries(state, "--state", size),
        start=_entries(start, "--from", size),
        steps=steps,
        params=params,
    )
    if trajectory is not None:
        about = {**_summary(model, walk, size), "rate": 1 / size.shown("time", dt)}
        about["outcome"] = walk.outcome.value
        write_series(size.all_shown(walk.trajectory(dt).columns()), trajectory, about)
    if json_:
        rows = [
            size.all_shown({"period": s.period, "step_length": s.step_length, "state": dict(s.state)})
            for s in walk.steps
        ]
        out = {**_summary(model, walk, size), "outcome": walk.outcome.value, "steps": rows}
        print(json.dumps(out, indent=1, allow_nan=False))
    else:
        _print(walk, steps, size)
    return FOUND if len(walk.steps) == steps else NOTHING


def _entries(words: list[str] | None, option: str, size: Size) -> dict[str, Any] | None:
    """Numbers by name from words ``NAME=VALUE``; None where there are none."""
    out: dict[str, Any] = {}
    for word in words or ():
        assign(out, *split(word, option))
    return {name: size.own("time" if name == "t" else name, value) for name, value in out.items()} or None


def _spacing(rate: float | None, trajectory: Path | None) -> float:
    """Time between two samples."""
    if rate is not None and trajectory is None:
        raise InputError(f"--rate {rate:g} has no effect without --trajectory; name a file to be written")
    chosen = RATE if rate is None else rate
    if not 0 < chosen < float("inf"):
        raise InputError(f"--rate {chosen:g} is not allowed: a finite number above 0 is needed")
    return 1 / chosen


def _summary(model: str, walk: "Walk", size: Size) -> dict[str, Any]:
    start = {name: size.shown("time" if name == "t" else name, value) for name, value in walk.start.items()}
    return {"model": model, **size.said, "params": size.all_shown(dict(walk.params)), "start": start}


def _print(walk: "Walk", steps: int, size: Size) -> None:
    """The steps as a table, and how the walk ended."""
    from stridemap.cli.output import print_table

    names = list(walk.steps[0].state) if walk.steps else []
    table = [["step", "period", "length", *names]]
    for i, s in enumerate(walk.steps, 1):
        seen = size.all_shown({"period": s.period, "step_length": s.step_length, **s.state})
        values = list(seen.values())
        table.append([str(i), *(f"{value:.9f}" for value in values)])
    print_table(table)
    if walk.outcome.sentence:
        print(walk.outcome.sentence)
    print(f"{walk.outcome.words} after {len(walk.steps)} of {steps} steps")
