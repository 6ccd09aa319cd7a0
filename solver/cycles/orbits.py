"""Many limit cycles of one model as arrays: what the solver speaks inside."""

import html
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Self, overload

import numpy as np
from numpy.typing import NDArray

from stridemap.columns import columns_of, described
from stridemap.errors import InputError
from stridemap.services import service
from stridemap.solver.cycles.orbit import SHOWN, Orbit, missing, plain
from stridemap.solver.cycles.report import SearchReport
from stridemap.solver.cycles.status import CODES, FOUND, STATUSES, Status
from stridemap.solver.model.model import Model
from stridemap.solver.model.scales import Scales
from stridemap.solver.observables.measures import decided
from stridemap.spec import Quantity
from stridemap.words import multiplier_columns

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_DTYPES = {"float": np.float64, "int": np.int64, "bool": np.bool_, "str": object}
NULLABLE = {"int": "Int64", "bool": "boolean"}
"""Types of pandas for columns in which something may be missing."""

_PLAIN = {"float": float, "int": int, "bool": bool, "str": str}


@dataclass(frozen=True, eq=False, repr=False)
class Orbits(Sequence[Orbit]):
    """Limit cycles of one model, or failures with their status; n entries.

    A sequence of `Orbit`: ``orbits[0]``, ``for orbit in orbits``, ``orbits[orbits.stable]``. Every measured
    quantity is an attribute with one entry per cycle: ``orbits.cot``, shape (n,).

    Parameters
    ----------
    model : Model
    params : ndarray, shape (n, n_params)
    u : ndarray, shape (n, nz + 1)
        Section points, and periods of the whole cycles.
    codes : ndarray of int, shape (n,)
        `Status.code` of each.
    jacobian : ndarray, shape (n, nz + 1, nz + 1)
        Derivative of the residual with respect to u; NaN where it is not known.
    multipliers : ndarray of complex, shape (n, nz)
        NaN for a failure.
    measures : mapping of str to ndarray, shape (n,)
        Every measured quantity; an array of None where the model lacks it.
    search : SearchReport or None
        What the search did that found them, and what it threw away; None for a selection of them, and for
        cycles of several steps.
    steps : ndarray, shape (n, period_n, nz + 1), or None
        Section point and period of each step of cycles of several steps; None for those of one step.
    """

    model: Model
    params: Array
    u: Array
    codes: Index
    jacobian: Array
    multipliers: NDArray[np.complex128]
    measures: Mapping[str, NDArray[Any]]
    search: SearchReport | None = None
    steps: Array | None = None

    def __post_init__(self) -> None:
        """Truths that are all known are an array of bool, as any mask."""
        measures = dict(self.measures)
        for name, quantity in self.model.measured.items():
            if quantity.type == "bool" and measures[name].dtype == object:
                measures[name] = as_mask(measures[name])
        object.__setattr__(self, "measures", measures)

    # -- made --------------------------------------------------------------------------------------------

    @classmethod
    def empty(cls, model: Model) -> Self:
        """No limit cycles."""
        nz, n_params = len(model.section), len(model.parameters)
        return cls(
            model,
            np.empty((0, n_params)),
            np.empty((0, nz + 1)),
            np.empty(0, dtype=np.int64),
            np.empty((0, nz + 1, nz + 1)),
            np.empty((0, nz), dtype=np.complex128),
            {name: column(quantity, None, 0) for name, quantity in model.measured.items()},
        )

    @classmethod
    def concatenate(cls, model: Model, parts: Iterable["Orbits"]) -> "Orbits":
        """All of several, in order."""
        found = [part for part in parts if len(part)]
        if not found:
            return cls.empty(model)
        if len(found) == 1:
            return found[0]
        if len({part.period_n for part in found}) > 1:
            raise InputError("cycles of different numbers of steps cannot stand in one Orbits")
        names = _ARRAYS if found[0].steps is None else (*_ARRAYS, "steps")
        arrays = {name: np.concatenate([getattr(part, name) for part in found]) for name in names}
        measures = {name: np.concatenate([part.measures[name] for part in found]) for name in model.measured}
        return cls(model=model, measures=measures, search=None, **arrays)

    @classmethod
    def from_columns(cls, model: Model, columns: Mapping[str, Any]) -> "Orbits":
        """Limit cycles from the columns of a table, such as those of `stridemap.read_orbits`.

        Parameters
        ----------
        model : Model
        columns : mapping of str to array_like, shape (n,)
            Parameters, section point, period and status; multipliers and measures where they are known.

        Raises
        ------
        InputError
            When a column that is needed is missing, or a status is not one.
        """
        unknowns = (*model.section, "period")
        for name in (*model.spec.names, "status", *unknowns):
            if name not in columns:
                raise InputError(f"the table has no column {name}, which limit cycles of {model.name} have")

        def array(name: str) -> Array:
            return np.asarray(columns[name], dtype=np.float64)

        words, place = np.unique(np.asarray(columns["status"], dtype=str), return_inverse=True)
        for word in words.tolist():
            if word not in list(Status):
                raise InputError(f"{word!r} is not a status; statuses are {', '.join(Status)}")
        codes = np.array([CODES[Status(word)] for word in words.tolist()], dtype=np.int64)[place.ravel()]
        n, nz = len(codes), len(model.section)
        multipliers = np.full((n, nz), np.nan + 0j)
        for i in range(nz):
            real, imaginary = multiplier_columns(i)
            if real in columns:
                multipliers[:, i] = array(real) + 1j * array(imaginary)
        radius = np.abs(multipliers).max(axis=1, initial=0.0)
        error = array("multiplier_error") if "multiplier_error" in columns else np.zeros(n)
        columns = {"spectral_radius": radius, "stable": decided(radius, np.nan_to_num(error)), **columns}
        return cls(
            model,
            np.column_stack([array(name) for name in model.spec.names]),
            np.column_stack([array(name) for name in unknowns]),
            codes,
            np.full((n, nz + 1, nz + 1), np.nan),
            multipliers,
            {name: column(quantity, columns.get(name), n) for name, quantity in model.measured.items()},
        )

    def take(self, index: Any) -> "Orbits":
        """A selection: by number, by a mask, or by a slice."""
        if not isinstance(index, slice):
            index = np.asarray(index)
            if index.dtype == object:  # a mask with None for what is not known: that is not selected
                index = np.array([one is not None and bool(one) for one in index.tolist()], dtype=np.bool_)
            index = index if index.size else index.astype(np.intp)  # an empty list is one of floats
        names = _ARRAYS if self.steps is None else (*_ARRAYS, "steps")
        arrays = {name: getattr(self, name)[index] for name in names}
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

    def __add__(self, other: "Orbits") -> "Orbits":
        """The cycles of both, which must be of one model."""
        if not isinstance(other, Orbits):
            return NotImplemented
        if other.model != self.model:
            raise InputError(f"cycles of {self.model.name} and {other.model.name} cannot stand in one Orbits")
        return Orbits.concatenate(self.model, [self, other])

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
            plain(period),
            tuple(self.multipliers[i].tolist()),
            {name: self._measure(name, i) for name in self.measures},
            () if self.steps is None else self._steps(i),
        )

    def _steps(self, i: int) -> tuple[dict[str, float], ...]:
        names = (*self.model.section, "period")
        assert self.steps is not None
        return tuple(dict(zip(names, step, strict=True)) for step in self.steps[i].tolist())

    def _measure(self, name: str, i: int) -> Any:
        value = plain(self.measures[name][i])
        return None if value is math.nan and self.model.measured[name].optional else value

    # -- columns -----------------------------------------------------------------------------------------

    @property
    def status(self) -> NDArray[np.object_]:
        """`Status` of each, shape (n,)."""
        statuses: NDArray[np.object_] = STATUSES[self.codes]
        return statuses

    @property
    def found(self) -> NDArray[np.bool_]:
        """Which of them are limit cycles, shape (n,)."""
        return np.isin(self.codes, FOUND)

    @property
    def scaled(self) -> Array:
        """Section points and periods in terms of the model's scales, shape (n, nz + 1): for comparisons."""
        scaled: Array = self.u / Scales.of(self.model).unknowns
        return scaled

    @property
    def known_stable(self) -> NDArray[np.bool_]:
        """Which of them are known to be stable, shape (n,); `stable` is None where that is not known."""
        return np.array([one is not None and bool(one) for one in self.stable.tolist()], dtype=np.bool_)

    @property
    def period(self) -> Array:
        """Periods, shape (n,)."""
        return self.u[:, -1]

    @property
    def period_n(self) -> int:
        """Number of walking steps after which the cycles close."""
        return 1 if self.steps is None else self.steps.shape[1]

    def columns(self) -> dict[str, NDArray[Any]]:
        """One array per column, in the order of the tables that a sweep writes, without the cell.

        Cycles of several steps have one column more, ``period_n``.
        """
        out = dict(zip(self.model.spec.names, self.params.T, strict=True))
        if self.steps is not None:
            out["period_n"] = np.full(len(self), self.period_n)
        out["status"] = _WORDS[self.codes]
        out |= dict(zip((*self.model.section, "period"), self.u.T, strict=True))
        for i, multiplier in enumerate(self.multipliers.T):
            real, imaginary = multiplier_columns(i)
            out[real], out[imaginary] = multiplier.real, multiplier.imag
        return out | dict(self.measures)

    def to_frame(self) -> Any:
        """The cycles as a `pandas.DataFrame`, one row each, with the columns of ``orbits.parquet``."""
        import pandas as pd

        frame = pd.DataFrame(self.columns())
        for name, quantity in self.model.measured.items():
            if quantity.optional and quantity.type in NULLABLE:
                frame[name] = frame[name].astype(NULLABLE[quantity.type])
        return described(frame, self.model.spec, "limit cycles")

    def to_xarray(self) -> Any:
        """The cycles as an `xarray.Dataset` over the dimension ``cycle``, each variable with its unit."""
        return service("to_xarray")(service("table_of")(self))

    def plot(self, x: str, y: str, **options: Any) -> Any:
        """Draw one column over another with matplotlib: see `stridemap.views.plot_table`."""
        return service("plot_table")(service("table_of")(self), x, y, **options)

    # -- shown -------------------------------------------------------------------------------------------

    def __repr__(self) -> str:
        count = f"{len(self)} limit cycle{'' if len(self) == 1 else 's'} of {self.model.name}"
        if not len(self):
            return f"<{count}>"
        lines = self._shown(lambda i: f"{i}: {self[i].summary}")
        return "\n".join([f"<{count}", *(f"  {line}" for line in lines), ">"])

    def _shown(self, line: Callable[[int], str]) -> list[str]:
        """Lines of all cycles, or of the first and the last where there are many."""
        if len(self) <= 2 * SHOWN_ENDS:
            return [line(i) for i in range(len(self))]
        between = [f"... {len(self) - 2 * SHOWN_ENDS:,} more"]
        last = range(len(self) - SHOWN_ENDS, len(self))
        return [*map(line, range(SHOWN_ENDS)), *between, *map(line, last)]

    def _repr_html_(self) -> str:
        """A table for notebooks, with units, and a picture where matplotlib is installed."""
        shown = [n for n in SHOWN if n != "group" or "spring_mode" in self.model.spec.functions]
        columns = columns_of(self.model.spec)
        differs = [
            name
            for name, values in zip(self.model.spec.names, self.params.T, strict=True)
            if len(values) and not (values == values[0]).all()
        ]
        shown = [*differs, *shown]
        head = "".join(f"<th>{html.escape(word)}</th>" for word in ("", *shown))
        units = (columns[name].unit if columns[name].unit != "1" else "" for name in shown)
        under = "".join(f"<td>{html.escape(unit)}</td>" for unit in ("", *units))

        def row(i: int) -> str:
            orbit = self[i]
            cells = "".join(f"<td>{html.escape(_cell(_entry(orbit, name)))}</td>" for name in shown)
            return f"<tr><th>{i}</th>{cells}</tr>"

        rows = [
            text if text.startswith("<tr>") else f'<tr><td colspan="{len(shown) + 1}">{text}</td></tr>'
            for text in self._shown(row)
        ]
        plural = "" if len(self) == 1 else "s"
        caption = f"{len(self):,} limit cycle{plural} of {html.escape(self.model.name)}"
        table = f"<table><caption>{caption}</caption><tr>{head}</tr><tr>{under}</tr>{''.join(rows)}</table>"
        return f"{table}{service('picture')(self)}"


_ARRAYS = ("params", "u", "codes", "jacobian", "multipliers")

SHOWN_ENDS = 10
"""How many of the first and of the last cycles are shown where there are many."""

_WORDS = np.array([str(status.value) for status in STATUSES], dtype=object)


def column(quantity: Quantity, values: Any, n: int, at: Any = slice(None)) -> NDArray[Any]:
    """A column of a measured quantity, shape (n,).

    Parameters
    ----------
    quantity : Quantity
    values : array_like or None
        Measured values of the rows `at`; None where the model lacks the quantity.
    n : int
    at : index, optional
        Rows that were measured; all by default. The others are filled as `missing` has it.
    """
    if quantity.type == "float":
        out = np.full(n, np.nan)
    else:
        dtype: Any = object if quantity.optional else _DTYPES[quantity.type]
        out = np.full(n, missing(quantity), dtype=dtype)
    if values is None:
        return out
    if quantity.type == "float":
        out[at] = np.asarray(values, dtype=np.float64)
    elif not quantity.optional:
        out[at] = values
    else:
        given = np.asarray(values, dtype=object)
        known = np.array([v is not None and (v == v) is True for v in given], dtype=bool)  # nor NaN, nor NA
        kind = _PLAIN[quantity.type]  # whole numbers with gaps may come as floats
        out[np.arange(n)[at][known]] = np.array([kind(value) for value in given[known]], dtype=object)
    return out


def as_mask(truths: NDArray[Any]) -> NDArray[Any]:
    """Truths as an array of bool where all are known; as they are, with None, where not."""
    return truths.astype(np.bool_) if all(one is not None for one in truths.tolist()) else truths


def _entry(orbit: Orbit, name: str) -> Any:
    return orbit.params[name] if name in orbit.params else getattr(orbit, name)


def _cell(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else "" if value is None else str(value)
