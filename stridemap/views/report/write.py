"""Puts the page together and writes it."""

import base64
import hashlib
import json
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import Any

import pandas as pd

from stridemap.errors import InputError, short
from stridemap.solver.model.model import Model
from stridemap.tables.whole_file import whole_file
from stridemap.views import palette
from stridemap.views.report import sections
from stridemap.views.report.branches import Given
from stridemap.views.report.claims import claims as verdict_list
from stridemap.views.report.claims import read_claims
from stridemap.views.report.curves import curves as encoded
from stridemap.views.report.curves import read_curves
from stridemap.views.report.payload import NEEDED, payload
from stridemap.views.report.references import Reference
from stridemap.views.report.shown import read_shown
from stridemap.views.report.thinning import MOST_CYCLES

SCRIPTS = (
    "numbers.js",
    "data.js",
    "units.js",
    "walker.js",
    "scale.js",
    "colours.js",
    "references.js",
    "filter.js",
    "pen.js",
    "axes.js",
    "curves.js",
    "zoom.js",
    "map.js",
    "patches.js",
    "joining.js",
    "branches.js",
    "slice.js",
    "scatter.js",
    "charts.js",
    "lines.js",
    "stage.js",
    "strip.js",
    "cycle.js",
    "bar.js",
    "export.js",
    "print.js",
    "selection.js",
    "address.js",
    "page.js",
    "controls.js",
    "start.js",
)
"""The page's own programs, in the order in which they build on each other."""

PROGRAM = """
"use strict";
(async () => {{
const equations = {equations};
{own}
}})();
"""

LARGEST = 200e6
"""Bytes of a page that a browser still opens."""


@dataclass(frozen=True)
class ReportSummary:
    """What was written.

    Parameters
    ----------
    path : pathlib.Path
    size : int
        Bytes.
    orbits, cells : int
        Limit cycles and grid cells shown.
    all_orbits, all_cells : int
        Those of the sweep.
    """

    path: Path
    size: int
    orbits: int
    cells: int
    all_orbits: int
    all_cells: int


def write_report(
    folder: str | Path,
    out: str | Path,
    claims: str | Path | Sequence[Mapping[str, Any]] | None = None,
    model: str | Path | None = None,
    curves: str | Path | pd.DataFrame | None = None,
    references: Sequence[Reference] = (),
    branches: Sequence[Given] = (),
    part: Mapping[str, tuple[float, float]] | None = None,
    most_cycles: int = MOST_CYCLES,
    kept: Mapping[str, Sequence[float]] | None = None,
) -> ReportSummary:
    """Write a sweep as one HTML file that needs no other file and no network.

    Of a sweep with more limit cycles than a page bears, every so many values of each axis are shown, and the
    page says so in its first lines.

    Parameters
    ----------
    folder : path
        Output folder of a finished sweep.
    out : path
        The file; folders on the way to it are made.
    claims : path or sequence of mapping, optional
        Verdicts to show: what ``stridemap claims --json`` printed, or records of `Claim.to_dict`.
    model : str or path, optional
        What the model is loaded by, where it is not a built-in one: the path of its file. Nothing that
        `folder` holds or names is run.
    curves : path or DataFrame, optional
        Boundaries to draw over the map: what ``stridemap boundary --out`` wrote, over two parameters of the
        sweep's grid.
    references : sequence of Reference, optional
        Values to compare with, such as those of another model: lines in slices, colours of the map, words of
        filters.
    branches : sequence of path or Branches, optional
        Branches over one parameter of the grid each, drawn in slices along it with their special points: what
        `stridemap.branches` gives, or the path that ``stridemap branch --out`` was given.
    part : mapping of str to tuple of two floats, optional
        Lowest and highest value of axes of the grid of which a part is shown: ``{"k": (0.5, 10.0)}``.
    most_cycles : int
        Limit cycles above which values of the grid are left out.
    kept : mapping of str to sequence of float, optional
        Values of axes that are left in if any are, such as those that a paper speaks of.

    Raises
    ------
    InputError
        When the folder does not hold a finished sweep, the sweep found nothing, is of another version of the
        model or of one that is neither built in nor given, when the claims, boundaries or branches cannot
        be read or do not belong to it, or the file cannot be written.
    """
    if isinstance(most_cycles, bool) or not isinstance(most_cycles, int) or most_cycles < 1:
        raise InputError(f"most_cycles = {short(most_cycles)} is not allowed: at least 1 is needed")
    shown = read_shown(folder, model, part, most_cycles, kept)
    loaded, provenance, orbits, cells = shown.model, shown.provenance, shown.orbits, shown.cells
    _check_functions(loaded)
    lines = _curves(loaded, provenance["configuration"], curves)
    data = payload(loaded, shown.configuration, orbits, cells, lines, references, branches)
    verdicts = read_claims(claims) if isinstance(claims, str | Path) else claims
    page = _page(
        title=sections.text(f"Limit cycles: {loaded.title}"),
        heading=sections.text(loaded.title),
        lead=sections.lead(shown),
        keys=sections.keys(loaded),
        claims=(verdict_section := verdict_list(loaded, verdicts)),
        claims_link='<a href="#claims">Statements of the paper</a>' if verdict_section else "",
        provenance=sections.provenance(loaded, provenance),
        # A `<` could end the element that holds the data.
        data=json.dumps(data, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c"),
        equations=_within_script(loaded.text(f"{loaded.name}.js")),
    ).encode()
    if len(page) > LARGEST:
        raise InputError(
            f"the page would be {len(page) / 1e6:,.0f} MB, more than the {LARGEST / 1e6:.0f} MB that "
            "browsers open well; show fewer limit cycles, or a part of the grid"
        )
    path = Path(out)
    _write(path, page)
    return ReportSummary(path, len(page), len(orbits), len(cells), shown.all_orbits, shown.all_cells)


def _curves(
    model: Model, configuration: Mapping[str, Any], given: str | Path | pd.DataFrame | None
) -> list[dict[str, Any]]:
    """The boundaries that were given, as the page takes them."""
    if given is None:
        return []
    if isinstance(given, pd.DataFrame):
        return encoded(model, configuration, given)
    return encoded(model, configuration, read_curves(given), f"the boundaries in {given}")


def _check_functions(model: Model) -> None:
    """Refuse a model that lacks what the page moves it by."""
    if missing := [name for name in NEEDED if name not in model.spec.functions]:
        raise InputError(
            f"the model {model.name} cannot be shown: it lacks the function {' and '.join(missing)}; "
            "derive it with this version of stridemap"
        )


def _within_script(program: str) -> str:
    """A program that cannot end the element it stands in: a model's title may stand in its comments."""
    return re.sub(r"<(?=/script|!--|script)", r"\\u003c", program, flags=re.IGNORECASE)


def _page(**parts: str) -> str:
    """Fill the places ``{{name}}`` of the page's template."""
    source = files("stridemap.views.report")
    parts["style"] = source.joinpath("page.css").read_text(encoding="utf-8") + palette.style_sheet()
    own = "\n".join(source.joinpath(name).read_text(encoding="utf-8") for name in SCRIPTS)
    parts["script"] = PROGRAM.format(equations=parts.pop("equations"), own=own)
    # The browser runs this program and no other, whatever else should have got into the page.
    digest = hashlib.sha256(parts["script"].encode()).digest()
    parts["allowed"] = f"'sha256-{base64.b64encode(digest).decode()}'"
    template = source.joinpath("page.html").read_text(encoding="utf-8")
    return re.sub(r"\{\{(\w+)\}\}", lambda match: parts[match[1]], template)


def check_out(out: str | Path) -> None:
    """Try whether a page can be written, before hours are spent on what it shows.

    Raises
    ------
    InputError
        When it cannot.
    """
    _write(Path(out), None)


def _write(path: Path, page: bytes | None) -> None:
    """Write the file whole or not at all; without a page, only try."""
    if os.path.isdir(path):
        raise InputError(
            f"{path} is a folder; give the name of a file to write, such as {path / 'report.html'}"
        )
    if os.path.exists(path) and not os.path.isfile(path):  # a device or a pipe would be replaced by the page
        raise InputError(f"{path} is not a file; give the name of a file to write")
    try:
        with whole_file(path, replace=page is not None) as file:
            file.write(page or b"")
    except OSError as error:
        reason = (
            "a folder on the way is a file" if isinstance(error, FileExistsError) else error.strerror or error
        )
        raise InputError(
            f"cannot write {path} ({reason}); give a file in a folder that can be written"
        ) from None
