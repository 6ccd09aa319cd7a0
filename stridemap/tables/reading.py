"""Tables from files: of sweeps, branches, boundaries, limit cycles and walks."""

import json
import os
from dataclasses import replace
from pathlib import Path
from typing import Any

from stridemap.errors import InputError, short
from stridemap.solver.model.loading import available, load
from stridemap.spec import ModelSpec
from stridemap.tables.table import SWEPT, Table
from stridemap.units import Units

MODEL = "model"
"""What asks for the units of the model."""

ENDINGS = (".parquet", ".csv")


def read_table(path: str | Path, model: Any = None, units: "Units | str | None" = None) -> Table:
    """Read a table with the meaning and the unit of each of its columns.

    Parameters
    ----------
    path : str or path
        Output folder of a sweep, or one of its tables; or a ``.parquet`` or ``.csv`` file that a command
        of stridemap wrote.
    model : str, path or Model, optional
        The table's model, where the file does not say what its columns hold, as a ``.csv`` cannot; and of a
        sweep, where its model does not come with stridemap.

    units : Units or "model", optional
        The size of a robot: the table is converted to its SI units. Without it, the tables of a sweep whose
        file gives ``[units]`` are in SI units, and all others as they were written; with "model", those of a
        sweep are in the units of the model, in which they are stored.

    Returns
    -------
    Table

    Raises
    ------
    InputError
        When there is no such table.
    """
    if not (units is None or units == MODEL or isinstance(units, Units)):
        raise InputError(f"units = {short(units)} is not allowed; give stridemap.Units or {MODEL!r}")
    read = _found(Path(path), model)
    if units is None and read.units:
        return _as_given(read)
    return read.to_si(units) if isinstance(units, Units) else read


def _as_given(table: Table) -> Table:
    """The table of a sweep in the SI units that its file was written in, with the parameters that it gave."""
    converted = table.to_si(Units.from_mapping(table.units))
    # 3,500 N/m became a number without a unit and comes back: its last bit may differ then.
    names = table.parameters
    frames = [
        None if frame is None else frame.assign(**{n: _rounded(frame[n]) for n in names if n in frame})
        for frame in (converted.frame, converted.cells)
    ]
    grid = {name: tuple(_rounded(values)) for name, values in converted.grid.items()}
    return replace(converted, frame=frames[0], cells=frames[1], grid=grid)


def _rounded(values: Any) -> list[float]:
    return [float(f"{value:.15g}") for value in values]


def _found(path: Path, model: Any) -> Table:
    """The table of a file or a folder, in the units in which it is stored."""
    if os.path.isdir(path) or path.name in SWEPT:
        return _swept(path, model)
    if path.suffix not in ENDINGS:
        raise InputError(
            f"{path} is not a table; give the output folder of a sweep, or a file that ends in "
            f"{' or '.join(ENDINGS)}"
        )
    spec = None if model is None else load(model).spec
    frame, in_si = _read(path), False
    if spec is None and path.suffix == ".parquet":
        spec, in_si = _walk(path)
    if spec is not None and not frame.attrs:
        strange = [name for name in spec.names if name not in frame.columns and "time" not in frame.columns]
        if strange:
            raise InputError(
                f"{path} has no column {strange[0]}, which tables of {spec.name} have; name the model that "
                "it is of"
            )
    table = Table.of_frame(frame, spec if not frame.attrs else None)
    if in_si:
        table = replace(table, columns={name: one.in_si for name, one in table.columns.items()})
    if spec is not None and table.model and table.model != spec.name:
        raise InputError(f"{path} is of the model {table.model}, not of {spec.name}; name that one, or none")
    return table


def _swept(path: Path, model: Any) -> Table:
    """A table of a finished sweep: its limit cycles, or its cells where their file is named."""
    from stridemap.sweeps.reading import read_sweep
    from stridemap.sweeps.store import CELLS

    folder = path if os.path.isdir(path) else path.parent
    read = read_sweep(folder, model)
    configuration = read.provenance["configuration"]
    names = [name for name in read.model.spec.names if name in configuration["grid"]]
    grid = {name: tuple(configuration["grid"][name]) for name in names}
    cells = path.name == CELLS
    return Table.of_frame(
        read.cells if cells else read.orbits,
        read.model.spec,
        "grid cells" if cells else "limit cycles",
        grid=grid,
        units=configuration.get("units", {}),
        parameters=read.model.spec.names,
        cells=read.cells,
    )


def _read(path: Path) -> Any:
    """The rows of a file."""
    import pandas as pd
    import pyarrow as pa
    import pyarrow.csv

    if os.path.exists(path) and not os.path.isfile(path):  # to open a pipe would wait for ever
        raise InputError(f"cannot read {path} (it is not a file); give a file")
    try:
        if path.suffix == ".csv":
            options = pyarrow.csv.ConvertOptions(strings_can_be_null=True)
            frame = pyarrow.csv.read_csv(path, convert_options=options).to_pandas()
        else:
            frame = pd.read_parquet(path)
    except (pa.ArrowException, UnicodeDecodeError) as error:
        kind = "Parquet file" if path.suffix == ".parquet" else "table of comma-separated values"
        raise InputError(f"{path} is damaged or is not a {kind} ({_first(error)}); write it again") from None
    except OSError as error:
        reason = error.strerror or "it is damaged or is not a Parquet file"
        raise InputError(f"cannot read {path} ({reason}); give a file that can be read") from None
    if not all(isinstance(name, str) and name for name in frame.columns) or not len(frame.columns):
        raise InputError(f"{path} has columns without names; give a table that stridemap wrote")
    return frame


def _first(error: Exception) -> str:
    return str(error).splitlines()[0][:100] if str(error) else type(error).__name__


def _walk(path: Path) -> tuple[ModelSpec | None, bool]:
    """The model that the metadata of a walk name, if it comes with stridemap; whether it is in SI units."""
    import pyarrow.parquet as pq

    metadata = pq.read_schema(path).metadata or {}
    try:
        about = json.loads(metadata.get(b"stridemap", b"null"))
        name, in_si = about["model"], "units" in about
    except (KeyError, TypeError, ValueError, RecursionError):
        return None, False
    return (load(name).spec if isinstance(name, str) and name in available() else None), in_si
