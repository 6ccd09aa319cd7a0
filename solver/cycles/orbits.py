"""Many limit cycles of one model as arrays: what the solver speaks inside."""

import html
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Self, overload

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.cycles.orbit import Orbit, missing
from stridemap.solver.cycles.status import CODES, STATUSES, Status
from stridemap.solver.model.model import Model
from stridemap.spec import Quantity
from stridemap.words import multiplier_columns

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_DTYPES = {"float": np.float64, "int": np.int64, "bool": np.bool_, "str": object}
_PLAIN = {"float": float, "int": int, "bool": bool, "str": str}


@dataclass(frozen=True, eq=False, repr=False)
class Orbits(Sequence[Orbit]):
    """Limit cycles of one model, or what was found in their place, n of them.

    A sequence of `Orbit`: ``orbits[0]``, ``for orbit in orbits``, ``orbits[orbits.stable]``. Every measured
    quantity is an attribute with one entry per cycle: ``orbits.cot``, shape (n,).

    Parameters
    ----------
    model : Model
    params : ndarray, shape (n, n_params)
    u : ndarray, shape (n, nz + 1)
        Section points and periods.
    codes : ndarray of int, shape (n,)
        `Status.code` of each.
    jacobian : ndarray, shape (n, nz + 1, nz + 1)
        Derivative of the residual with respect to u; NaN where it is not known.
    multipliers : ndarray of complex, shape (n, nz)
        NaN for a failure.
    measures : mapping of str to ndarray, shape (n,)
        Every measured quantity; an array of None where the model lacks it.
    """

    model: Model
    params: Array
    u: Array
    codes: Index
    jacobian: Array
    multipliers: NDArray[np.complex128]
    measures: Mapping[str, NDArray[Any]]

    # -- made --------------------------------------------------------------------------------------------

    @classmethod
    def empty(cls, model: Model) -> Self:
        """None at all."""
        nz, n_params = len(model.section), len(model.parameters)
        return cls(
            model,
            np.empty((0, n_params)),
            np.empty((0, nz + 1)),
            np.empty(0, dtype=np.int64),
            np.empty((0, nz + 1, nz + 1)),
            np.empty((0, nz), dtype=np.complex128),
            {name: unmeasured(quantity, 0) for name, quantity in model.measured.items()},
        )

    @classmethod
    def concatenate(cls, model: Model, parts: Iterable["Orbits"]) -> "Orbits":
        """All of several, in order."""
        found = list(parts)
        if not found:
            return cls.empty(model)
        if len(found) == 1:
            return found[0]
        arrays = {name: np.concatenate([getattr(part, name) for part in found]) for name in _ARRAYS}
        measures = {name: np.concatenate([part.measures[name] for part in found]) for name in model.measured}
        return cls(model=model, measures=measures, **arrays)

    @classmethod
    def from_columns(cls, model: Model, columns: Mapping[str, Any]) -> "Orbits":
        """Limit cycles from the columns of a table, such as those of `stridemap.read_orbits`.

        Parameters
        ----------
        model : Model
        columns : mapping of str to array_like, shape (n,)
            Parameters, section point, period and status; multipliers and measures where they are known.
        """

        def array(name: str) -> Array:
            return np.asarray(columns[name], dtype=np.float64)

        codes = np.array([CODES[Status(value)] for value in columns["status"]], dtype=np.int64)
        n, nz = len(codes), len(model.section)
        multipliers = np.full((n, nz), np.nan + 0j)
        for i in range(nz):
            real, imaginary = multiplier_columns(i)
            if real in columns:
                multipliers[:, i] = array(real) + 1j * array(imaginary)
        return cls(
            model,
            np.column_stack([array(name) for name in model.spec.names]),
            np.column_stack([array(name) for name in (*model.section, "period")]),
            codes,
            np.full((n, nz + 1, nz + 1), np.nan),
            multipliers,
            {name: column(quantity, columns.get(name), n) for name, quantity in model.measured.items()},
        )

    def take(self, index: Any) -> "Orbits":
        """Some of them: by number, by a mask, or by a slice."""
        if not isinstance(index, slice):
            index = np.asarray(index)
            index = index if index.size else index.astype(np.intp)  # an empty list is one of floats
        arrays = {name: getattr(self, name)[index] for name in _ARRAYS}
        return Orbits(
            model=self.model, measures={name: m[index] for name, m in self.measures.items()}, **arrays
        )

    # -- a sequence --------------------------------------------------------------------------------------

    def __len__(self) -> int:
        return len(self.u)

    @overload
    def __getitem__(self, index: int) -> Orbit: ...
    @overload
    def __getitem__(self, index: slice | NDArray[Any] | Sequence[int]) -> "Orbits": ...
    def __getitem__(self, index: Any) -> "Orbit | Orbits":
        """One cycle for a number; several for a slice, a mask or a list of numbers."""
        if not isinstance(index, int | np.integer):
            return self.take(index)
        if not -len(self) <= index < len(self):
            raise IndexError(f"there is no cycle {index}: there are {len(self)}")
        return self._orbit(int(index))

    def __getattr__(self, name: str) -> NDArray[Any]:
        measures = self.__dict__.get("measures", {})
        if name not in measures:
            raise AttributeError(f"Orbits have no attribute {name!r}; measured are {', '.join(measures)}")
        column: NDArray[Any] = measures[name]
        return column

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self.measures})

    def _orbit(self, i: int) -> Orbit:
        status: Status = STATUSES[self.codes[i]]
        params = dict(zip(self.model.spec.names, self.params[i].tolist(), strict=True))
        if not status.found:
            return Orbit(self.model, params, status, measures={"residual": self.residual[i].item()})
        *state, period = self.u[i].tolist()
        return Orbit(
            self.model,
            params,
            status,
            dict(zip(self.model.section, state, strict=True)),
            period,
            tuple(self.multipliers[i].tolist()),
            {name: _scalar(column[i]) for name, column in self.measures.items()},
        )

    # -- columns -----------------------------------------------------------------------------------------

    @property
    def status(self) -> NDArray[np.object_]:
        """`Status` of each, shape (n,)."""
        statuses: NDArray[np.object_] = STATUSES[self.codes]
        return statuses

    @property
    def found(self) -> NDArray[np.bool_]:
        """Which of them are limit cycles, shape (n,)."""
        return np.isin(self.codes, [code for status, code in CODES.items() if status.found])

    @property
    def period(self) -> Array:
        """Periods, shape (n,)."""
        return self.u[:, -1]

    def columns(self) -> dict[str, NDArray[Any]]:
        """One array per column, in the order of the tables that a sweep writes, without the cell."""
        out = dict(zip(self.model.spec.names, self.params.T, strict=True))
        out["status"] = np.array([status.value for status in self.status], dtype=object)
        out |= dict(zip((*self.model.section, "period"), self.u.T, strict=True))
        for i, multiplier in enumerate(self.multipliers.T):
            real, imaginary = multiplier_columns(i)
            out[real], out[imaginary] = multiplier.real, multiplier.imag
        return out | dict(self.measures)

    def to_frame(self) -> Any:
        """The cycles as a `pandas.DataFrame`, one row each, with the columns of ``orbits.parquet``."""
        import pandas as pd

        return pd.DataFrame(self.columns())

    # -- shown -------------------------------------------------------------------------------------------

    def __repr__(self) -> str:
        count = f"{len(self)} limit cycle{'' if len(self) == 1 else 's'} of {self.model.name}"
        if not len(self):
            return f"<{count}>"
        return "\n".join([f"<{count}", *(f"  {i}: {text}" for i, text in enumerate(map(_line, self))), ">"])

    def _repr_html_(self) -> str:
        """A table for notebooks."""
        shown = [n for n in _SHOWN if any(value is not None for value in self.measures.get(n, [0]))]
        head = "".join(f"<th>{html.escape(word)}</th>" for word in ("", *shown))
        rows = (
            f"<tr><th>{i}</th>{''.join(f'<td>{html.escape(_cell(getattr(o, n)))}</td>' for n in shown)}</tr>"
            for i, o in enumerate(self)
        )
        caption = f"{len(self)} limit cycles of {html.escape(self.model.name)}"
        return f"<table><caption>{caption}</caption><tr>{head}</tr>{''.join(rows)}</table>"


_ARRAYS = ("params", "u", "codes", "jacobian", "multipliers")

_SHOWN = ("group", "period", "stable", "spectral_radius", "step_length", "speed", "cot", "min_vertical_force")
"""Columns of the table in a notebook; all others are attributes."""


def unmeasured(quantity: Quantity, n: int) -> NDArray[Any]:
    """A column of a quantity that was not measured, shape (n,)."""
    dtype = object if quantity.optional else _DTYPES[quantity.type]
    return np.full(n, missing(quantity), dtype=dtype)


def column(quantity: Quantity, values: Any, n: int) -> NDArray[Any]:
    """Measured values as a column; one of None where the model lacks the quantity."""
    if values is None:
        return unmeasured(quantity, n)
    if not quantity.optional:
        return np.asarray(values, dtype=_DTYPES[quantity.type])
    plain = _PLAIN[quantity.type]  # whole numbers with gaps may come as floats
    given = np.asarray(values).tolist()
    known = [None if value is None or (value == value) is not True else plain(value) for value in given]
    return np.array(known, dtype=object)


def _scalar(value: Any) -> Any:
    return value.item() if isinstance(value, np.generic) else value


def _line(orbit: Orbit) -> str:
    return repr(orbit).strip("<>").replace(f" of {orbit.model.name}", "")


def _cell(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else "" if value is None else str(value)
