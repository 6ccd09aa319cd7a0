"""``stridemap claims``: the paper's statements, decided by computation."""

import json
import textwrap
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

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

WIDTH = 79
"""Letters of a line."""

VerboseOption = Annotated[
    bool,
    typer.Option("--verbose", help="Print sections, deciding numbers and what is not so as well."),
]


def claims(
    json_: JsonOption = False,
    sweeps: SweepsOption = None,
    workers: WorkersOption = None,
    set_: SetOption = None,
    thin: ThinOption = 1,
    verbose: VerboseOption = False,
    out: Annotated[Path | None, typer.Option(hidden=True)] = None,
) -> int:
    """Decide the statements of the paper, C1 to C20, by computation: holds, in part, or differs.

    Prints one line per statement; --verbose adds what decides each. The limit cycles that they are about are
    swept the first time and read again afterwards; an interrupted run is continued. What the paper does not
    print can be set: beta, Kp, Kd, S and gamma. docs/claims.md has the definitions, --json the numbers behind
    each verdict.
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
        print(_json({"claims": entries, "params": used, "origin": origin}))
    else:
        _print(decided, verbose)
        if thin > 1:
            which = f"Only every {_ordinal(thin)} value of k and alpha"
            print(f"{which} was searched: what is narrow may be missing.")
        values = ", ".join(f"{name} = {value:g}" for name, value in used.items())
        print(f"{values}: {origin}; cycles in {folder}")
    return FOUND


def _print(decided: "Sequence[Claim]", verbose: bool) -> None:
    """Print one line per statement, as plain text everywhere; what decides it below, if that is wanted."""
    from stridemap.views.report.verdicts import tally

    for one in decided:
        parts = one.evidence["parts"]
        so = sum(part["holds"] for part in parts.values())
        count = f" ({so} of {len(parts)})" if one.verdict == "in part" else ""
        print(f"{one.id:<4} {one.verdict.value:<8} {one.short}{count}")
        if verbose:
            _print_rest(one)
    print(tally(one.verdict.value for one in decided))


def _print_rest(one: "Claim") -> None:
    """Print the statement, its section, the deciding numbers, and what is not so."""
    print(_filled(f"{one.statement}." + (f" (Section {one.where})" if one.where else "")))
    if one.listed:
        print(_filled(f"{one.numbers.partition(':')[0]}:"))
        width = max(map(len, one.listed))
        for name, value in one.listed.items():
            print(f"       {name:<{width}}  {value}")
    elif said := one.numbers.partition("; not so: ")[0]:
        print(_filled(said))
    failing = [name for name, part in one.evidence["parts"].items() if not part["holds"]]
    if failing:
        print(_filled(f"not so: {', '.join(failing)}"))


def _filled(text: str) -> str:
    return textwrap.fill(text, WIDTH, initial_indent=5 * " ", subsequent_indent=7 * " ")


def _ordinal(number: int) -> str:
    """A number as a place in a row, such as 2nd or 11th."""
    last = 0 if number % 100 in (11, 12, 13) else number % 10
    return f"{number}{({1: 'st', 2: 'nd', 3: 'rd'}).get(last, 'th')}"


def _json(content: dict[str, Any]) -> str:
    """JSON to be read, in which each figure stands on a line of its own."""
    figures = [claim.pop("figure") for claim in content["claims"]]
    for i, claim in enumerate(content["claims"]):
        claim["figure"] = f"@{i}@"
    text = json.dumps(content, indent=1, allow_nan=False)
    for i, figure in enumerate(figures):
        text = text.replace(f'"@{i}@"', json.dumps(figure, separators=(",", ":"), allow_nan=False), 1)
    return text
