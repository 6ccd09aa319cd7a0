"""``stridemap claims``: the paper's statements, decided by computation."""

import json
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from stridemap.cli.options import FOUND, INTERRUPTED, JsonOption, SetOption, parameters
from stridemap.cli.paper_options import (
    SweepsOption,
    ThinOption,
    WorkersOption,
    say_interrupted,
    sweep_progress,
)
from stridemap.errors import InputError

if TYPE_CHECKING:
    from stridemap.paper import Claim

_ORDER = "Where four numbers are listed, they are at alpha, omega = (0.25, 2), (0.5, 2), (0.25, 3), (0.5, 3)."


def claims(
    json_: JsonOption = False,
    sweeps: SweepsOption = None,
    workers: WorkersOption = None,
    set_: SetOption = None,
    thin: ThinOption = 1,
    out: Annotated[Path | None, typer.Option(hidden=True)] = None,
) -> int:
    """Decide the statements of the paper, C1 to C20, by computation: holds, in part, or differs.

    The limit cycles that they are about are swept the first time and read again afterwards; an interrupted
    run is continued. What the paper does not print can be set: beta, Kp, Kd, S and gamma. docs/claims.md has
    the definitions, --json the numbers behind each verdict.
    """
    from stridemap.paper import claims as decide
    from stridemap.paper.sweeps import FREE, default_folder
    from stridemap.solver.model.loading import load

    if out is not None:
        raise InputError(f"--out is called --sweeps now: write --sweeps {out}")
    params = parameters([], set_)
    folder = default_folder(params, thin) if sweeps is None else sweeps
    try:
        with sweep_progress() as progress:
            decided = decide(folder, params=params, thin=thin, workers=workers, progress=progress)
    except KeyboardInterrupt:
        say_interrupted(folder)
        return INTERRUPTED
    used = {name: load("wobbling").preset[name] for name in FREE} | params
    origin = "set by hand" if params else "identified from the paper's statements, not published in it"
    if json_:
        entries = [one.to_dict() for one in decided]
        print(json.dumps({"claims": entries, "params": used, "origin": origin}, indent=1, allow_nan=False))
    else:
        _print(decided)
        print(_ORDER)
        if thin > 1:
            print(f"Only every {thin}th value of k and alpha was searched: what is narrow may be missing.")
        values = ", ".join(f"{name} = {value:g}" for name, value in used.items())
        print(f"{values}: {origin}; cycles in {folder}")
    return FOUND


def _print(decided: "Sequence[Claim]") -> None:
    """Print a table on a terminal; plain lines elsewhere, one per statement."""
    from rich.console import Console
    from rich.table import Table

    console = Console()
    if console.is_terminal:
        table = Table("", "statement", "verdict", "deciding numbers", show_lines=True)
        for one in decided:
            table.add_row(one.id, one.statement, one.verdict.value, one.numbers)
        console.print(table)
    else:
        for one in decided:
            print(f"{one.id:<4} {one.verdict.value:<8} {one.statement}. {one.numbers}")
    count = Counter(one.verdict.value for one in decided)
    print(f"{count['holds']} hold, {count['in part']} hold in part, {count['differs']} differ")
