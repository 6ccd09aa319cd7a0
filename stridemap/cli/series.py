"""The time series of a walk as a file: Parquet or CSV, by the file's ending."""

import io
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from stridemap.errors import InputError

ENDINGS = (".parquet", ".csv")


def check_ending(path: Path) -> None:
    """Refuse a path whose ending does not say what kind of file is meant.

    Raises
    ------
    InputError
    """
    if path.suffix not in ENDINGS:
        raise InputError(f"{path} is not allowed as a trajectory: its ending must be {' or '.join(ENDINGS)}")


def write_series(columns: Mapping[str, Any], path: Path, about: dict[str, Any]) -> None:
    """Write a time series; equal walks give equal bytes.

    Parameters
    ----------
    columns : mapping of str to ndarray, shape (n,)
    path : pathlib.Path
        Ending in ``.parquet`` or ``.csv``.
    about : dict
        What the walk is, as JSON: it goes into the metadata of a Parquet file.

    Raises
    ------
    InputError
        For another ending, or a path that cannot be written.
    """
    import pyarrow as pa
    import pyarrow.csv
    import pyarrow.parquet as pq

    check_ending(path)
    table = pa.table(dict(columns))
    out = io.BytesIO()
    if path.suffix == ".csv":
        pyarrow.csv.write_csv(table, out, pyarrow.csv.WriteOptions(quoting_style="none"))
    else:
        described = {"stridemap": json.dumps(about, allow_nan=False)}
        pq.write_table(table.replace_schema_metadata(described), out)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(out.getvalue())
    except OSError as error:
        raise InputError(
            f"cannot write {path} ({error.strerror or error}); give a path that can be written"
        ) from None
