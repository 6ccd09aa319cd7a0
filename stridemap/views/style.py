"""How all figures look: sizes, line styles, and how they are written.

Nothing depends on colour alone: classes of the map differ in luminance, lines in width or dashes.
"""

import io
import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from stridemap.errors import InputError
from stridemap.views import palette
from stridemap.views.palette import (
    BLACK,
    BLUE,
    DARK,
    GREEN,
    GREY,
    PALE,
    PURPLE,
    SKY,
    VERMILION,
    WHITE,
)  # fmt: skip

__all__ = [
    "BLACK", "BLUE", "COLUMN", "COMPASS_LINE", "DARK", "DPI", "GREEN", "GREY", "MM", "NONE", "PALE", "PURPLE",
    "RC", "SKY", "SOLUTIONS", "STABLE", "STABLE_LINE", "UNSTABLE", "UNSTABLE_LINE", "VERMILION", "WHITE",
    "new_figure", "panel_label", "put", "styled", "write",
]  # fmt: skip

MM = 1 / 25.4
COLUMN = 80 * MM
"""Width of a single column of the paper, in inches."""
DPI = 200

STABLE, UNSTABLE, NONE = palette.STABLE, palette.UNSTABLE, palette.NONE
"""Classes of the map."""

STABLE_LINE: dict[str, Any] = {
    "color": palette.STABLE, "linewidth": 2.2, "linestyle": "-", "solid_capstyle": "butt",
}  # fmt: skip
UNSTABLE_LINE: dict[str, Any] = {"color": palette.UNSTABLE_LINE, "linewidth": 0.7, "linestyle": "-"}
COMPASS_LINE: dict[str, Any] = {"color": palette.COMPASS, "linewidth": 0.9, "linestyle": (0, (5, 2.5))}

SOLUTIONS: dict[str, dict[str, Any]] = {
    "a": {"color": palette.GROUPS["A"], "linewidth": 1.3, "linestyle": "-"},
    "b": {"color": palette.GROUPS["B"], "linewidth": 1.3, "linestyle": (0, (6, 1.5))},
    "c": {"color": palette.GROUPS["C"], "linewidth": 1.3, "linestyle": (0, (5, 1.2, 1, 1.2))},
    "compass": COMPASS_LINE,
}
"""Lines of the typical solutions and of the compass walker, which differ in colour and dashes."""

RC = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],  # comes with matplotlib: the same on every machine
    "mathtext.fontset": "dejavusans",
    "font.size": 7.5,
    "axes.labelsize": 8,
    "axes.titlesize": 8,
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
    "legend.fontsize": 7,
    "axes.linewidth": 0.6,
    "axes.labelpad": 2.5,
    "axes.titlepad": 3.5,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.major.size": 2.5,
    "ytick.major.size": 2.5,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "legend.frameon": False,
    "legend.handlelength": 2.2,
    "legend.borderaxespad": 0.3,
    "svg.fonttype": "none",  # text stays text
    "svg.hashsalt": "stridemap",
    "figure.dpi": DPI,
    "savefig.dpi": DPI,
    "image.interpolation": "none",
}


@contextmanager
def styled() -> Iterator[None]:
    """The style, for as long as the context lasts: from the making of a figure to its writing."""
    with mpl.rc_context({**mpl.rcParamsDefault, "backend": mpl.rcParams["backend"], **RC}):
        yield


class Drawing(Figure):
    """A figure that notebooks show by itself, also where pyplot was not imported."""

    def _repr_html_(self) -> str:
        """The figure as an element of a page."""
        return svg(self)


def new_figure(width: float, height: float) -> Figure:
    """An empty figure of a size in inches, independent of pyplot and its windows."""
    figure = Drawing(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    figure.get_layout_engine().set(w_pad=0.02, h_pad=0.02, wspace=0.03, hspace=0.03)
    return figure


def panel_label(axes: Axes, text: str) -> None:
    """A bold label in the upper left corner outside of a panel."""
    axes.set_title(text, loc="left", fontweight="bold")


def write(figure: Figure, folder: Path, name: str) -> list[Path]:
    """Write a figure as SVG and PNG, without a date, so that the same figure is the same bytes.

    Returns
    -------
    list of pathlib.Path

    Raises
    ------
    InputError
        When a file cannot be written.
    """
    paths = []
    for kind, metadata in (("svg", {"Date": None, "Creator": None}), ("png", {"Software": None})):
        content = io.BytesIO()
        figure.savefig(content, format=kind, metadata=metadata)
        paths.append(put(folder / f"{name}.{kind}", content.getvalue()))
    return paths


def svg(figure: Figure) -> str:
    """A figure as an SVG element for a page."""
    content = io.StringIO()
    with styled():
        figure.savefig(content, format="svg", metadata=_UNDATED["svg"])
    text = content.getvalue()
    return re.sub(r"<metadata>.*?</metadata>\s*", "", text[text.index("<svg") :], flags=re.DOTALL)


def save(figure: Figure, path: Path) -> Path:
    """Write a figure in the format of its path's ending, without a date: equal figures are equal bytes.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    kind = path.suffix[1:]
    content = io.BytesIO()
    with styled():
        figure.savefig(content, format=kind, metadata=_UNDATED.get(kind))
    return put(path, content.getvalue())


_UNDATED: dict[str, dict[str, None]] = {
    "svg": {"Date": None, "Creator": None},
    "png": {"Software": None},
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
}
"""What a file of each kind leaves out of its metadata."""


def put(path: Path, content: bytes) -> Path:
    """Write a file, whose folder is made if it is not there.

    Raises
    ------
    InputError
        When that cannot be done.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        if os.path.exists(path) and not os.path.isfile(path) and not os.path.isdir(path):
            raise OSError(None, "it is not a file")  # to write into a pipe waits for who reads it
        path.write_bytes(content)
    except OSError as error:
        raise InputError(
            f"cannot write {path} ({error.strerror or error}); give a path that can be written"
        ) from None
    return path
