"""``stridemap simulate``: a walk, step by step."""

import json
from typing import Annotated, Any

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


def simulate(
    context: typer.Context,
    model: ModelOption = "wobbling",
    set_: SetOption = None,
    state: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME=VALUE", help="An entry of the state just after touchdown; all or none."),
    ] = None,
    steps: Annotated[int, whole("Number of steps to walk.")] = 10,
    json_: JsonOption = False,
    derive_timeout: DeriveTimeoutOption = None,
) -> int:
    """Walk from a state just after touchdown (by default the most stable limit cycle), step by step.

    The integrator is event-driven and shares nothing with the search for limit cycles.
    """
    from stridemap.cli.output import print_table
    from stridemap.solver.api import simulate as simulate_

    params = parameters(context.args, set_)
    start: dict[str, Any] = {}
    for word in state or ():
        assign(start, *split(word, "--state"))
    walk = simulate_(model, start or None, steps=steps, params=params)
    if json_:
        rows = [
            {"period": s.period, "step_length": s.step_length, "state": dict(s.state)} for s in walk.steps
        ]
        out = {"model": model, "params": dict(walk.params), "outcome": str(walk.outcome), "steps": rows}
        print(json.dumps(out, indent=1, allow_nan=False))
    else:
        names = list(walk.steps[0].state) if walk.steps else []
        table = [["step", "period", "length", *names]]
        for i, s in enumerate(walk.steps, 1):
            table.append(
                [str(i), f"{s.period:.9f}", f"{s.step_length:.9f}", *(f"{v:.9f}" for v in s.state.values())]
            )
        print_table(table)
        print(f"{walk.outcome.value.replace('_', ' ')} after {len(walk.steps)} of {steps} steps")
    return FOUND if len(walk.steps) == steps else NOTHING
