"""One column of a table over another: a mark per row, a colour for a third column."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from stridemap.columns import SCALED, Column
from stridemap.errors import InputError
from stridemap.spec import UnitNames
from stridemap.tables.gridded import plain_values
from stridemap.tables.table import Table
from stridemap.views import palette
from stridemap.views.optional import require_pictures

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

SIZE = (5.2, 3.6)
"""Width and height in inches."""

QUANTILES = (0.02, 0.98)
"""Of what is drawn: the range of a scale of colours. A few extreme values would take all of it."""

MOST_MARKS = 3_000
"""Rows beyond which the marks of a drawing are made of pixels: each mark takes some 100 bytes."""

MOST_CLASSES = 12
"""Texts that a legend can tell apart."""

GROUP_COLOURS = {**palette.GROUPS, "none": palette.GREY, "other": palette.PALE}
"""Groups of gaits have the same colours in all pictures."""


def plot_table(
    table: Table,
    x: str,
    y: str,
    *,
    colour: str | None = None,
    where: str | None = None,
) -> "Figure":
    """Draw one column of a table over another.

    Stable cycles are filled marks, unstable ones hollow, and those of which it is not known crosses. Points
    of one branch that follow each other are joined by a thin line.

    Parameters
    ----------
    table : Table
        Of a sweep, a branch, boundaries, limit cycles or a walk.
    x, y : str
        Columns that hold numbers.
    colour : str, optional
        A column that gives the marks their colours: numbers on a scale from the 2 to the 98 % quantile of
        what is drawn (about 1 for `spectral_radius`), anything else by a legend.
    where : str, optional
        A condition, such as ``"stable and k < 10"``: only rows for which it holds are drawn; see
        `Table.where`.

    Returns
    -------
    matplotlib.figure.Figure
        It belongs to no window; ``figure.savefig(path)`` writes it.

    Raises
    ------
    InputError
        For a column that there is not or that does not hold numbers, a condition that is not understood or
        holds for no row, or a missing package.
    """
    check_columns(table, x, y, colour)
    shown = table if where is None else table.where(where)
    horizontal, vertical = _numbers(shown, x), _numbers(shown, y)
    drawn = np.isfinite(horizontal) & np.isfinite(vertical)
    if not drawn.any():
        given = f" with {where}" if where else ""
        raise InputError(
            f"there is nothing to draw: of {len(table):,} rows none{given} has both {x} and {y}; "
            "choose other columns or another condition"
        )
    require_pictures()
    from stridemap.views import style

    with style.styled():
        figure = style.new_figure(*SIZE)
        axes = figure.subplots()
        if "arclength" in table.columns:
            _join(axes, table, shown, x, y)
        size = float(np.clip(4000 / drawn.sum(), 3, 14))
        marks = _Marks(axes, shown.frame, horizontal, vertical, drawn, size)
        marks.draw(shown, colour)
        if entries := marks.entries():
            figure.legend(handles=entries, loc="outside upper right", ncols=6)
        axes.set(xlabel=axis_text(table.columns[x]), ylabel=axis_text(table.columns[y]))
        axes.set_title(_title(table, where), fontsize=7.5)
    return figure


def check_columns(table: Table, x: str, y: str, colour: str | None = None) -> None:
    """Refuse columns that a table does not have, or that do not hold numbers where these are needed.

    Raises
    ------
    InputError
    """
    for name in (x, y):
        if plain_values(table.column(name)).dtype == object:
            numeric = [n for n in table.columns if plain_values(table.frame[n].head(100)).dtype != object]
            raise InputError(
                f"{name} holds no numbers, so that it cannot be an axis; columns of numbers are "
                f"{', '.join(numeric)}"
            )
    if colour is not None:
        table.column(colour)


def axis_text(column: Column) -> str:
    """Text of an axis: what the column holds, its name and its unit."""
    from stridemap.views.notation import latex_unit

    label = column.name if column.label == column.name else f"{column.label}, {column.name}"
    if column.unit in ("", "1"):
        return _plain(label)
    scaled = column.scale != "" and column.unit != column.si
    names = UnitNames() if scaled else UnitNames("kg", "m", "s", "J")
    assert not scaled or names.time == SCALED
    return f"{_plain(label)}  [{latex_unit(column.unit, names)}]"


def _plain(text: str) -> str:
    return text.replace("$", r"\$")


def _numbers(table: Table, name: str) -> Array:
    return np.asarray(plain_values(table.frame[name]), dtype=np.float64)


def _title(table: Table, where: str | None) -> str:
    of = f" of {table.model}" if table.model else ""
    condition = f", {where}" if where else ""
    text = f"{table.what}{of}{condition}"
    return _plain(text if len(text) <= 90 else f"{text[:87]}...")


def _join(axes: "Axes", table: Table, shown: Table, x: str, y: str) -> None:
    """Thin lines through rows of a branch that follow each other and are drawn."""
    from stridemap.views import style

    numbers = "branch" if "branch" in table.columns else "boundary"
    if numbers not in table.columns:
        return
    kept = table.frame.index.isin(shown.frame.index)
    horizontal, vertical = (np.where(kept, _numbers(table, name), np.nan) for name in (x, y))
    which = plain_values(table.frame[numbers])
    for number in np.unique(which):
        of = which == number
        axes.plot(horizontal[of], vertical[of], color=style.GREY, linewidth=0.6, zorder=1)


class _Marks:
    """Marks at points, filled or hollow by stability."""

    def __init__(self, axes: "Axes", frame: "pd.DataFrame", x: Array, y: Array, drawn: Mask, size: float):
        self.axes, self.frame, self.x, self.y, self.drawn, self.size = axes, frame, x, y, drawn, size
        self.classes: dict[str, str] = {}
        self.looks: set[str] = set()

    def draw(self, table: Table, colour: str | None) -> None:
        """All of them, coloured by a column or by stability alone."""
        from stridemap.views import style

        if colour is None:
            self._put(np.full(len(self.x), True), style.BLUE)
            return
        values = plain_values(table.frame[colour])
        if values.dtype == object or values.dtype == bool or _few_truths(table, colour):
            self._classes(table, colour)
        else:
            self._scale(table, colour, values.astype(np.float64))

    def _classes(self, table: Table, colour: str) -> None:
        """A colour and an entry of the legend for each text; the rarest share one."""
        from stridemap.views import style

        column = table.frame[colour]
        words = np.array(["none" if gap else _word(v) for v, gap in zip(column, column.isna(), strict=True)])
        names, counts = np.unique(words[self.drawn], return_counts=True)
        if len(names) > MOST_CLASSES:
            often = set(names[np.argsort(-counts, kind="stable")[: MOST_CLASSES - 1]].tolist())
            words = np.array([word if word in often else "other" for word in words])
            names = np.unique(words[self.drawn])
        colours = (style.BLUE, style.VERMILION, style.GREEN, style.PURPLE, style.SKY, style.DARK, style.BLACK)
        for i, name in enumerate(names.tolist()):
            chosen = GROUP_COLOURS.get(name, style.DARK) if colour == "group" else colours[i % len(colours)]
            self.classes[f"{colour} {name}"] = chosen
            self._put(words == name, chosen)

    def _scale(self, table: Table, colour: str, values: Array) -> None:
        """Colours of a scale, whose range is that of what is drawn without its few extremes."""
        import matplotlib as mpl
        from matplotlib.cm import ScalarMappable
        from matplotlib.colors import LinearSegmentedColormap, Normalize

        from stridemap.views import style

        known = values[self.drawn & np.isfinite(values)]
        if not len(known):
            raise InputError(
                f"no row that is drawn has a value of {colour}; choose another column for the colour"
            )
        low, high = np.quantile(known, QUANTILES).tolist()
        cmap = mpl.colormaps["viridis"]
        if colour == "spectral_radius" and low < 1 < high:
            # As far above 1 as below it, where there is no end to how unstable a cycle can be.
            low, high = (low, 2 - low) if 1 - low > 0.01 else (2 - high, high)
            sides = [style.BLUE, style.GREY, style.VERMILION]
            cmap = LinearSegmentedColormap.from_list("about 1", sides)
        norm = Normalize(low, high if high > low else low + 1e-12 + abs(low) * 1e-9)
        colours = cmap(norm(values))
        gaps = ~np.isfinite(values)
        if (gaps & self.drawn).any():
            colours[gaps] = mpl.colors.to_rgba(style.GREY)
        self._put(np.full(len(values), True), colours)
        ends = (known.min() < low, known.max() > high)
        extend = {(True, True): "both", (True, False): "min", (False, True): "max"}.get(ends, "neither")
        bar = self.axes.figure.colorbar(ScalarMappable(norm, cmap), ax=self.axes, extend=extend, pad=0.02)
        bar.set_label(axis_text(table.columns[colour]))

    def entries(self) -> list[Any]:
        """Entries of the legend: a colour per class, and the look of stable and unstable cycles."""
        from matplotlib.lines import Line2D

        from stridemap.views import style

        def entry(name: str, colour: str, marker: str = "o", fill: bool = True) -> Any:
            look: dict[str, Any] = {"marker": marker, "color": colour, "linestyle": "", "markersize": 4}
            return Line2D([], [], label=name, fillstyle="full" if fill else "none", **look)

        out = [entry(name, colour) for name, colour in self.classes.items()]
        looks = {"stable": ("o", True), "unstable": ("o", False), "stability not known": ("x", True)}
        out += [entry(name, style.DARK, *look) for name, look in looks.items() if name in self.looks]
        return out

    def _put(self, of: Mask, colour: Any) -> None:
        """Marks of some rows: filled for stable, hollow for unstable, crosses for what is not known."""
        from stridemap.views import style

        if "stable" not in self.frame.columns:
            groups = [("", self.drawn & of, "full")]
        else:
            stable = self.frame["stable"]
            known, yes = ~stable.isna().to_numpy(), (stable == True).fillna(False).to_numpy(dtype=bool)  # noqa: E712
            groups = [
                ("unstable", self.drawn & of & known & ~yes, "hollow"),
                ("stability not known", self.drawn & of & ~known, "cross"),
                ("stable", self.drawn & of & yes, "full"),
            ]
        for name, rows, look in groups:
            if not rows.any():
                continue
            self.looks.add(name)
            colours = colour if isinstance(colour, str) else colour[rows]
            shape: dict[str, Any] = {"marker": "o", "facecolors": colours, "edgecolors": "none"}
            if look == "hollow":
                shape = {"marker": "o", "facecolors": style.WHITE, "edgecolors": colours, "linewidths": 0.6}
            elif look == "cross":
                shape = {"marker": "x", "c": colours, "linewidths": 0.7}
            shape |= {"zorder": 2, "rasterized": len(self.x) > MOST_MARKS}
            self.axes.scatter(self.x[rows], self.y[rows], self.size, **shape)


def _few_truths(table: Table, colour: str) -> bool:
    """Whether a column holds truths with gaps, which are numbers elsewhere."""
    return str(table.frame[colour].dtype) == "boolean"


def _word(value: Any) -> str:
    return {True: "yes", False: "no"}[bool(value)] if isinstance(value, bool | np.bool_) else str(value)
