"""Tables from files: sweeps, branches, boundaries, limit cycles and walks, whichever of our commands wrote them."""

import json
import os
from pathlib import Path
from typing import Any

from stridemap.errors import InputError
from stridemap.solver.model.loading import available, load
from stridemap.spec import ModelSpec
from stridemap.tables.table import SWEPT, Table

ENDINGS = (".parquet", ".csv")


def read_table(path: str | Path, model: Any = None) -> Table:
    """Read a table with the meaning and the unit of each of its columns.

    Parameters
    ----------
    path : str or path
        Output folder of a sweep, or one of its two tables; or a ``.parquet`` or ``.csv`` file that ``stridemap
        orbit``, ``branch``, ``boundary`` or ``simulate`` wrote.
    model : str, path or Model, optional
        The table's model, where the file does not say what its columns hold, as a ``.csv`` cannot; and of a
        sweep, where its model does not come with stridemap.

    Returns
    -------
    Table

    Raises
    ------
    InputError
        When there is no such table.
    """
    path = Path(path)
    if os.path.isdir(path) or path.name in SWEPT:
        return _swept(path, model)
    if path.suffix not in ENDINGS:
        raise InputError(
            f"{path} is not a table; give the output folder of a sweep, or a file that ends in "
            f"{' or '.join(ENDINGS)}"
        )
    spec = None if model is None else load(model).spec
    frame = _read(path)
    if spec is None and path.suffix == ".parquet":
        spec = _spec_of_walk(path)
    if spec is not None and not frame.attrs:
        strange = [name for name in spec.names if name not in frame.columns and "time" not in frame.columns]
        if strange:
            raise InputError(
                f"{path} has no column {strange[0]}, which tables of {spec.name} have; name the model that it "
                "is of"
            )
    table = Table.of_frame(frame, spec if not frame.attrs else None)
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
        cells=read.cells,
    )


def _read(path: Path) -> Any:
    """The rows of a file."""
    import pandas as pd
    import pyarrow as pa

    if os.path.exists(path) and not os.path.isfile(path):  # to open a pipe would wait for ever
        raise InputError(f"cannot read {path} (it is not a file); give a file")
    try:
        if path.suffix == ".csv":
            frame = pd.read_csv(path, float_precision="round_trip", keep_default_na=True)
        else:
            frame = pd.read_parquet(path)
    except (pa.ArrowException, pd.errors.ParserError, pd.errors.EmptyDataError, UnicodeDecodeError) as error:
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


def _spec_of_walk(path: Path) -> ModelSpec | None:
    """The model that the metadata of a walk name, if it comes with stridemap."""
    import pyarrow.parquet as pq

    metadata = pq.read_schema(path).metadata or {}
    try:
        name = json.loads(metadata.get(b"stridemap", b"null"))["model"]
    except (KeyError, TypeError, ValueError):
        return None
    return load(name).spec if isinstance(name, str) and name in available() else None
