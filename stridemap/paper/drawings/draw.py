"""The figures of the paper by name, and their drawing into a folder."""

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from importlib import import_module
from pathlib import Path
from typing import Any

from stridemap.errors import InputError
from stridemap.services import shown
from stridemap.sweeps.run import Progress
from stridemap.views.optional import require_pictures

FIGURES = {
    "model": "sketch.draw",
    "map": "map.draw",
    "profiles": "time_profiles.draw_typical",
    "profiles-compass": "time_profiles.draw_compass",
    "multipliers": "curves.draw_multipliers",
    "d-max": "curves.draw_distance",
    "cot": "curves.draw_cost",
    "d-profiles": "time_profiles.draw_distance",
}
"""Name of each figure and what draws it, in the order of the paper."""

DEFAULT_FOLDER = Path("results/paper-figures")


def figures(
    out: str | Path = DEFAULT_FOLDER,
    only: Sequence[str] = (),
    *,
    sweeps: str | Path | None = None,
    params: Mapping[str, Any] | None = None,
    thin: int = 1,
    workers: int | None = None,
    executor: Executor | None = None,
    progress: Callable[[str, Progress], None] | None = None,
    say: Callable[[str], None] | None = None,
) -> list[Path]:
    """Draw the paper's figures from computed limit cycles, each as SVG and PNG.

    They are drawn from the sweeps that `claims` decides the statements by; a sweep that a figure needs is run
    if it is not finished.

    Parameters
    ----------
    out : path
        Folder of the figures.
    only : sequence of str
        Names of `FIGURES`; by default all. Sweeps that they do not need are not run.
    sweeps, params, thin, workers, executor, progress
        As for `claims`.
    say : callable, optional
        Takes a line that says what is being done when the boundaries of the map are computed.

    Returns
    -------
    list of pathlib.Path

    Raises
    ------
    InputError
        For an unknown name, a missing package, a folder that cannot be written, unusable parameters, or a
        folder with tables of another configuration.
    """
    for name in only:
        if name not in FIGURES:
            raise InputError(f"there is no figure {name!r}; figures are {', '.join(FIGURES)}")
    require_pictures()
    from stridemap.paper.drawings.material import Material
    from stridemap.paper.sweeps import paper_sweeps
    from stridemap.views import style

    material = Material(
        paper_sweeps(sweeps, params, thin, workers=workers, executor=executor, progress=progress), say
    )
    paths: list[Path] = []
    names = [name for name in FIGURES if not only or name in only]
    with shown("drawing the figures", "figures") as update:
        for number, name in enumerate(names):
            update(number, len(names), name)
            module, function = FIGURES[name].split(".")
            draw = getattr(import_module(f"stridemap.paper.drawings.{module}"), function)
            with style.styled():
                paths += style.write(draw(material), Path(out), name)
    return paths
