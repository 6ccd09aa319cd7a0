"""The figures of the paper by name, and their drawing into a folder."""

from collections.abc import Callable, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

from stridemap.errors import InputError
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


def draw_figures(
    folder: str | Path = DEFAULT_FOLDER,
    only: Sequence[str] = (),
    *,
    workers: int | None = None,
    progress: Callable[[Any], None] | None = None,
    report: Callable[[Path], None] = lambda path: None,
) -> list[Path]:
    """Draw the paper's figures from computed data, each as SVG and PNG.

    Parameters
    ----------
    folder : path
        Figures go there, and the tables that they are drawn from into its subfolder ``tables``. Tables that
        are there are used again.
    only : sequence of str
        Names of `FIGURES`; by default all. Data that they do not need are not computed.
    workers : int, optional
        Processes of the sweeps.
    progress : callable, optional
        As of `stridemap.sweep`.
    report : callable, optional
        Called with each file as it is written.

    Returns
    -------
    list of pathlib.Path

    Raises
    ------
    InputError
        For an unknown name, a missing package, a folder that cannot be written, or tables in it of another
        configuration.
    """
    for name in only:
        if name not in FIGURES:
            raise InputError(f"there is no figure {name!r}; figures are {', '.join(FIGURES)}")
    require_pictures()
    from stridemap.paper.figures.material import Data
    from stridemap.views import style

    data = Data(Path(folder) / "tables", workers, progress)
    paths = []
    for name, home in FIGURES.items():
        if only and name not in only:
            continue
        module, function = home.split(".")
        draw = getattr(import_module(f"stridemap.paper.figures.{module}"), function)
        with style.styled():
            for path in style.write(draw(data), Path(folder), name):
                report(path)
                paths.append(path)
    return paths
