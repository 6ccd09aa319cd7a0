"""What a page shows of a sweep: all of it, a part, or of a large one a thinned-out view."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from stridemap.errors import InputError
from stridemap.solver.model.model import Model
from stridemap.sweeps.reading import open_sweep
from stridemap.sweeps.store import CELLS, ORBITS
from stridemap.views.report.thinning import MOST_CYCLES, Thinned, thinned


@dataclass(frozen=True)
class Shown:
    """The rows of a sweep that a page shows.

    Parameters
    ----------
    model : Model
    provenance : mapping
        Of the whole sweep.
    grid : mapping of str to list of float
        The values that are shown of each axis.
    orbits, cells : DataFrame
        Their rows; cells are numbered on this grid.
    all_orbits, all_cells : int
        How many the sweep has.
    thinned : Thinned or None
        Which values are shown, where these are not all.
    """

    model: Model
    provenance: Mapping[str, Any]
    grid: Mapping[str, list[float]]
    orbits: pd.DataFrame
    cells: pd.DataFrame
    all_orbits: int
    all_cells: int
    thinned: Thinned | None = None

    @property
    def configuration(self) -> dict[str, Any]:
        """The sweep's configuration with the grid that is shown."""
        return {**self.provenance["configuration"], "grid": dict(self.grid)}


def read_shown(
    folder: str | Path,
    model: str | Path | None = None,
    part: Mapping[str, tuple[float, float]] | None = None,
    most: int = MOST_CYCLES,
    kept: Mapping[str, Sequence[float]] | None = None,
) -> Shown:
    """Read what a page shows; what it does not show is in memory a piece at a time.

    Parameters
    ----------
    folder, model
        As for `stridemap.sweeps.reading.open_sweep`.
    part, most, kept
        As for `thinned`.

    Raises
    ------
    InputError
        As `open_sweep`, and when the sweep, or the part of it, has no limit cycle.
    """
    sweep = open_sweep(folder, model)
    counts = sweep.frame(CELLS, ["orbits"])["orbits"].to_numpy()
    if not counts.any():
        raise InputError(f"the sweep in {folder} found no limit cycle, so there is nothing to show")
    chosen = thinned(sweep.axes, counts, part or {}, most, kept)
    cells = chosen.cells
    if not counts[cells].any():
        raise InputError(
            f"the sweep in {folder} found no limit cycle in the part that is chosen; choose a larger part"
        )
    number = np.full(len(counts), -1)
    number[cells] = np.arange(len(cells))

    def shown(frame: pd.DataFrame) -> Any:
        return number[frame["cell"].to_numpy()] >= 0

    orbits = sweep.frame(ORBITS, where=shown)
    orbits["cell"] = number[orbits["cell"].to_numpy()]
    rows = sweep.frame(CELLS, where=shown)
    rows["cell"] = np.arange(len(rows))
    if int(counts[cells].sum()) != len(orbits):
        raise InputError(
            f"the tables in {folder} are not those of a sweep: its cells do not have as many limit cycles as "
            "they say; sweep again"
        )
    return Shown(
        sweep.model,
        sweep.provenance,
        chosen.grid,
        orbits,
        rows,
        int(counts.sum()),
        len(counts),
        None if chosen.whole else chosen,
    )


def what_is_shown(shown: Shown, words: Mapping[str, str]) -> str:
    """One sentence of HTML that says how much of a sweep is shown, and how to see the rest; or nothing.

    Parameters
    ----------
    shown : Shown
    words : mapping of str to str
        What each axis is called in it, as HTML.
    """
    view = shown.thinned
    if view is None:
        return ""
    taken = [f"{_place(n)} value of {words[name]}" for name, n in view.strides.items() if n > 1]
    limited = [f"{words[name]} from {low:g} to {high:g}" for name, (low, high) in view.ends.items()]
    kind = "a thinned-out view" if view.thin else "a part"
    which = ", ".join([*(["every " + " and every ".join(taken)] if taken else []), *limited])
    parts = " ".join(f"--part {name}={low!r}:{high!r}" for name, (low, high) in view.full.items())
    command = "stridemap report SWEEP_DIR"  # no path in a file: equal sweeps give equal pages
    rest = (
        f"<code>{escape(f'{command} {parts} --out part.html')}</code> shows a part in full"
        if view.thin
        else f"<code>{escape(f'{command} --out whole.html')}</code> shows what else there is"
    )
    return (
        f"This page shows {kind} of the sweep, {which}: {len(shown.orbits):,} of {shown.all_orbits:,} limit "
        f"cycles in {len(shown.cells):,} of {shown.all_cells:,} cells; {rest}."
    )


def _place(number: int) -> str:
    """A number as an ordinal: 2nd, 3rd, 11th."""
    ending = "th" if number % 100 in (11, 12, 13) else {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th")
    return f"{number}{ending}"
