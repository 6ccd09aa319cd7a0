"""``stridemap claims``: the paper's statements, decided by computation."""

import json
import signal
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NoReturn

import typer
from rich.console import Console
from rich.table import Table

from stridemap.cli.options import FOUND, INTERRUPTED, JsonOption, SetOption, parameters, whole

if TYPE_CHECKING:
    from stridemap.paper.claim import Claim
    from stridemap.sweeps.run import Progress


_ORDER = (
    "Where four numbers stand in a row they are at alpha, omega = (0.25, 2), (0.5, 2), (0.25, 3), (0.5, 3)."
)


def claims(
    json_: JsonOption = False,
    out: Annotated[
        Path | None, typer.Option(help="Folder of the sweeps; by default results/paper-claims.")
    ] = None,
    workers: Annotated[int | None, whole("Number of processes; by default one a core.")] = None,
    set_: SetOption = None,
    thin: Annotated[int, whole("Search only every Nth value of k and alpha: faster, and less sure.")] = 1,
) -> int:
    """Decide the statements of the paper, C1 to C20, by computation: holds, in part, or differs.

    The limit cycles they are about are swept the first time, and read again afterwards; an interrupted run
    goes on where it was. What the paper does not print can be set: beta, Kp, Kd, S and gamma.
    docs/claims.md has the definitions, --json the numbers behind each verdict.
    """
    from stridemap.paper.data import FREE
    from stridemap.paper.evaluate import claims as decide
    from stridemap.paper.evaluate import default_folder
    from stridemap.solver.model.loading import load

    params = parameters([], set_)
    folder = default_folder(params, thin) if out is None else out
    signal.signal(signal.SIGTERM, _interrupt)
    try:
        with _progress() as progress:
            decided = decide(folder, params=params, thin=thin, workers=workers, progress=progress)
    except KeyboardInterrupt:
        print(f"interrupted: finished parts are kept in {folder}; the same command goes on", file=sys.stderr)
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
            print(f"Searched at every {thin}th value of k and alpha only: what is narrow may be missing.")
        values = ", ".join(f"{name} = {value:g}" for name, value in used.items())
        print(f"{values}: {origin}; cycles in {folder}")
    return FOUND


def _interrupt(*_: object) -> NoReturn:
    raise KeyboardInterrupt


@contextmanager
def _progress() -> "Iterator[Callable[[str, Progress], None]]":
    """Show how far each sweep is, one after another."""
    from stridemap.cli.progress import show

    current: dict[str, Any] = {}
    with ExitStack() as stack:

        def update(name: str, seen: "Progress") -> None:
            if name not in current:
                stack.close()
                current.clear()
                print(f"sweep {name}", file=sys.stderr)
                current[name] = stack.enter_context(show())
            current[name](seen)

        yield update


def _print(decided: "Sequence[Claim]") -> None:
    """A table on a terminal; plain lines elsewhere, a line a statement."""
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
