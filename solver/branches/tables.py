"""Tables of cycles along curves: their columns, their files, and multipliers that are followed."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError, StorageError
from stridemap.solver.branches.equations import CycleEquations
from stridemap.words import multiplier_columns

Array = NDArray[np.float64]


def cycle_columns(
    equations: CycleEquations, cycles: Array, multipliers: NDArray[np.complex128]
) -> dict[str, Array]:
    """Parameters, section point of the first step, whole period and multipliers, by column.

    Parameters
    ----------
    equations : CycleEquations
    cycles : ndarray, shape (m, N + f)
        Unknowns of neighbouring cycles, and the parameters that vary.
    multipliers : ndarray of complex, shape (m, nz)
    """
    model = equations.model
    steps = np.array([equations.steps(cycle) for cycle in cycles])
    params = np.array([equations.point(cycle[equations.n_unknowns :]) for cycle in cycles])
    out = dict(zip(model.spec.names, params.T, strict=True))
    out |= dict(zip(model.section, steps[:, 0, :-1].T, strict=True))
    out["period"] = steps[:, :, -1].sum(axis=1)
    for i, followed in enumerate(by_continuity(multipliers).T):
        real, imaginary = multiplier_columns(i)
        out[real], out[imaginary] = followed.real, followed.imag
    return out


def point_row(point: Any) -> dict[str, Any]:
    """A single point with ``params, state`` and ``multipliers`` as a row of a table."""
    row = {name: value for name, value in vars(point).items() if not isinstance(value, dict | tuple)}
    row |= point.params | point.state
    for i, value in enumerate(point.multipliers):
        real, imaginary = multiplier_columns(i)
        row |= {real: value.real, imaginary: value.imag}
    return row


def save_tables(path: str | Path, tables: Mapping[str, Callable[[], Any]]) -> list[Path]:
    """Write tables beside each other, each under the path's name with an addition.

    Parameters
    ----------
    path : str or path
        Ends in ``.parquet`` or ``.csv``.
    tables : mapping of str to callable
        By addition, what makes a `pandas.DataFrame`.

    Raises
    ------
    InputError
        For another ending.
    StorageError
        When a file cannot be written.
    """
    path, writer, paths = Path(path), table_writer(path), []
    for addition, make in tables.items():
        target = path.with_stem(f"{path.stem}{addition}")
        try:
            getattr(make(), writer)(target, index=False)
        except OSError as error:
            raise StorageError(
                f"cannot write {target} ({error.strerror or error}); give a path that can be written"
            ) from None
        paths.append(target)
    return paths


def table_writer(path: str | Path) -> str:
    """The method of a data frame that writes the kind of file that a path's ending names.

    Raises
    ------
    InputError
        For an ending that names none.
    """
    writers = {".parquet": "to_parquet", ".csv": "to_csv"}
    suffix = Path(path).suffix
    if suffix not in writers:
        raise InputError(f"{path} must end in {' or '.join(writers)}")
    return writers[suffix]


def by_continuity(multipliers: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """Multipliers in such an order at each point that every column is a continuous curve.

    Parameters
    ----------
    multipliers : ndarray of complex, shape (m, nz)
        In any order at each of m neighbouring points. Where they are not finite, as at a grazing touchdown,
        they stay as they are.

    Returns
    -------
    ndarray of complex, shape (m, nz)
    """
    from scipy.optimize import linear_sum_assignment  # takes half a second to load

    out = multipliers.copy()
    finite = np.flatnonzero(np.isfinite(out).all(axis=1)).tolist()
    for number, i in enumerate(finite[1:], 1):
        last = out[finite[number - 1]]
        expected = last if number == 1 else 2 * last - out[finite[number - 2]]
        near = np.abs(expected[:, None] - out[i][None, :]) + np.abs(last[:, None] - out[i][None, :])
        out[i] = out[i][linear_sum_assignment(near)[1]]
    return out


def pair(value: complex) -> list[float | None]:
    """Real and imaginary part for JSON, which has no infinity."""
    return [part if np.isfinite(part) else None for part in (value.real, value.imag)]
