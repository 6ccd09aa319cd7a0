"""A table of limit cycles, branches or a walk as a value: its rows, and what its columns hold."""

import html
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from stridemap.columns import KEY, Column, described, description
from stridemap.errors import InputError
from stridemap.quantities import QUANTITIES
from stridemap.services import service
from stridemap.words import CELL_COLUMNS, TRAJECTORY_COLUMNS, hint

if TYPE_CHECKING:
    import pandas as pd

    from stridemap.spec import ModelSpec
    from stridemap.units import Units

SWEPT = ("orbits.parquet", "cells.parquet")
"""The two tables of a sweep."""


@dataclass(frozen=True, eq=False)
class Table:
    """A table with the meaning and the unit of each of its columns: what `stridemap.read_table` returns.

    Parameters
    ----------
    frame : pandas.DataFrame
        The rows.
    columns : mapping of str to Column
        What each column holds.
    model : str
        Name of the model; empty where the table does not say.
    what : str
        What a row is, in the plural: ``"limit cycles"``.
    grid : mapping of str to tuple of float
        Of a sweep: the values of each parameter of its grid.
    cells : pandas.DataFrame or None
        Of a sweep: its grid cells, one row each.
    units : mapping of str to float
        Of a sweep: the size of the robot in whose SI units its file was written.
    parameters : tuple of str
        Of a sweep: the parameters of its model.
    """

    frame: "pd.DataFrame"
    columns: Mapping[str, Column]
    model: str = ""
    what: str = "rows"
    grid: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    cells: "pd.DataFrame | None" = None
    units: Mapping[str, float] = field(default_factory=dict)
    parameters: tuple[str, ...] = ()

    @classmethod
    def of_frame(
        cls, frame: "pd.DataFrame", spec: "ModelSpec | None" = None, what: str = "rows", **more: Any
    ) -> "Table":
        """The table of a data frame, by what it says of itself or by a model's specification."""
        if spec is not None:
            frame = described(frame, spec, what)
        told, said = description(frame)
        known = {**_KNOWN, **told}
        columns = {str(name): known.get(str(name)) or Column(str(name), str(name)) for name in frame.columns}
        model, kind = said.get("model", ""), said.get("what", what)
        return cls(
            frame,
            columns,
            model if isinstance(model, str) else "",
            kind if isinstance(kind, str) else what,
            **more,
        )

    def __len__(self) -> int:
        return len(self.frame)

    def __repr__(self) -> str:
        of = f" of {self.model}" if self.model else ""
        grid = " x ".join(f"{len(values):,} {name}" for name, values in self.grid.items())
        where = f" over {grid}" if grid else ""
        return f"<table of {len(self):,} {self.what}{of}{where}: {len(self.columns)} columns>"

    def _repr_html_(self) -> str:
        """A table for notebooks, with the unit of each column."""
        shown = self.frame.head(10).rename(columns=lambda name: self.columns[name].name)
        units = [one.unit if one.unit != "1" else "" for one in self.columns.values()]
        shown.columns = [
            f"{name} [{unit}]" if unit else name for name, unit in zip(shown, units, strict=True)
        ]
        more = f"<p>and {len(self) - 10:,} more</p>" if len(self) > 10 else ""
        rows = shown.to_html(index=False)
        return f'<p>{html.escape(repr(self)[1:-1])}</p><div style="overflow-x: auto">{rows}</div>{more}'

    def column(self, name: Any) -> "pd.Series":
        """The values of a column.

        Raises
        ------
        InputError
            When there is no such column.
        """
        if not isinstance(name, str) or name not in self.columns:
            raise InputError(
                f"there is no column {name!r}{hint(str(name), self.columns)}; "
                f"columns are {', '.join(self.columns)}"
            )
        return self.frame[name]

    def where(self, condition: str) -> "Table":
        """The rows for which a condition holds, such as ``"stable and k < 10"``.

        Names are columns, compared with numbers and with each other; ``and``, ``or`` and ``not`` join
        conditions. Where a value is missing, it is not known whether the condition holds, and the row is left
        out.

        Raises
        ------
        InputError
            When it is not a condition on columns that the table has.
        """
        from stridemap.tables.where import selected

        return replace(self, frame=self.frame[selected(self.frame, condition)])

    def to_frame(self) -> "pd.DataFrame":
        """The rows as a `pandas.DataFrame`; ``frame.attrs["stridemap"]`` says what its columns hold."""
        columns = {name: one.to_dict() for name, one in self.columns.items()}
        frame = self.frame.copy()
        frame.attrs[KEY] = {"model": self.model, "what": self.what, "columns": columns}
        return frame

    def to_xarray(self, by: str = "cycle") -> Any:
        """The table as an `xarray.Dataset`.

        The dimensions of a sweep are the parameters of its grid and ``cycle``, which numbers the limit cycles
        of each cell by rising period from 0; or, by branch, ``branch`` and ``passage``, since a branch that
        turns back passes a cell several times. The dimension of any other table is ``row``, and that of the
        limit cycles of one point ``cycle``. Entries without a limit cycle are NaN, and in texts empty. Each
        variable has the attributes ``long_name`` and ``units``.

        Parameters
        ----------
        by : {"cycle", "branch"}

        Raises
        ------
        InputError
            When xarray is not installed, or the arrays would be too large.
        """
        return service("to_xarray")(self, by)

    def to_si(self, units: "Units") -> "Table":
        """The table in SI units, for a robot of a given size.

        Raises
        ------
        InputError
            When the table is in SI units already, or its columns have units that no size converts.
        """
        converted: Table = service("in_si")(self, units)
        return converted

    def export(self, path: Any, by: str = "cycle") -> Any:
        """Write the table for other programs.

        Parameters
        ----------
        path : str or path
            Its ending says what is written. ``.csv``: comma-separated values with all digits, and beside it
            ``<name>_columns.csv`` with the meaning and the unit of each column. ``.mat``: a file of MATLAB 5
            with a struct of columns, ``units`` and ``meanings`` by column, and of a sweep also ``cells`` and
            ``grid``. ``.nc``: netCDF 3 with the dimensions of `to_xarray`. ``.parquet``: a table that says of
            itself what its columns hold.
        by : {"cycle", "branch"}
            Of a sweep in ``.nc``: the dimension behind those of its grid.

        Returns
        -------
        list of pathlib.Path

        Raises
        ------
        InputError
            For another ending.
        StorageError
            When a file cannot be written.
        """
        return service("export")(self, path, by)

    def plot(self, x: str, y: str, **options: Any) -> Any:
        """Draw one column over another with matplotlib: see `stridemap.views.plot_table`."""
        return service("plot_table")(self, x, y, **options)


def table_of(found: Any, what: str = "limit cycles") -> Table:
    """The table of what has a model and a ``to_frame``: limit cycles, branches, boundaries.

    Parameters
    ----------
    found : Orbits, Branches or Boundaries
    what : str
        What a row is, in the plural.
    """
    return Table.of_frame(found.to_frame(), found.model.spec, what)


def _known() -> dict[str, Column]:
    """What is known of columns without a model: their words, and the units of pure numbers."""
    out = {name: Column(name, label) for name, label in {**TRAJECTORY_COLUMNS, **CELL_COLUMNS}.items()}
    for name, one in QUANTITIES.items():
        plain = "1" if one.kind == "number" and one.type in ("float", "int") else ""
        out[name] = Column(name, one.label, plain, plain, plain)
    return out


_KNOWN = _known()
