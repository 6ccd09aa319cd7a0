"""What the commands about the paper have in common: the folder of its sweeps, and how far each sweep is."""

import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stridemap.cli.options import end_like_interrupted, whole

if TYPE_CHECKING:
    from stridemap.sweeps.run import Progress

SweepsOption = Annotated[
    Path | None,
    typer.Option(
        "--sweeps",
        metavar="FOLDER",
        help="Folder of the paper's sweeps; by default results/paper-sweeps, with --set and --thin appended.",
    ),
]
WorkersOption = Annotated[
    int | None, whole("Number of processes that run the sweeps; by default one per core.")
]
ThinOption = Annotated[
    int, whole("Search only every Nth value of k and alpha, which is faster and less certain.")
]


@contextmanager
def sweep_progress() -> "Iterator[Callable[[str, Progress], None]]":
    """Show how far each sweep is, one after another; a termination counts as an interruption."""
    from stridemap.cli.progress import show

    end_like_interrupted()
    current: dict[str, Any] = {}
    with ExitStack() as stack:

        def update(name: str, seen: "Progress") -> None:
            if name not in current:
                stack.close()
                current.clear()
                current[name] = stack.enter_context(show(f"sweep {name}, "))
            current[name](seen)

        yield update


def say_interrupted(folder: Path) -> None:
    """Say where the finished parts of interrupted sweeps are."""
    print(f"interrupted: finished parts are kept in {folder}; the same command continues", file=sys.stderr)
