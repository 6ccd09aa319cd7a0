"""Sweep configurations: TOML files read into frozen, fully resolved records.

A file names a model, may fix parameters in ``[params]`` (the model's preset fills the rest), varies
others in ``[grid]`` and may tune the search for limit cycles in ``[search]``. What is read is resolved
down to the last grid value, so that two files which mean the same have the same `config_hash`.
"""

import contextlib
import hashlib
import itertools
import json
import math
import os
import tomllib
from collections.abc import Mapping
from dataclasses import asdict
from decimal import Context, Decimal, localcontext
from pathlib import Path
from typing import Annotated, Any, Literal, TypeVar

from pydantic import BaseModel, ConfigDict, Field, PrivateAttr, ValidationError, model_validator

from stridemap.errors import InputError
from stridemap.solver.model.files import contents
from stridemap.solver.model.loading import available, load
from stridemap.solver.model.model import Model
from stridemap.solver.options import (
    IN_SWEEPS,
    IN_SWEEPS_OF_CYCLES,
    STARTS_MAX,
    AcceptanceOptions,
    ContinuationOptions,
    Options,
    SearchOptions,
)
from stridemap.spec import Parameter
from stridemap.sweeps.si import Given
from stridemap.words import hint

MAX_COUNT = 1_000_000_000
"""Largest count that any whole-number setting may take."""

LARGEST_FILE = 10_000_000
"""Bytes of a configuration; the longest lists of values that are swept have some thousand."""

CELLS_PER_SECOND = 50.0
CYCLES_PER_CELL = 3
"""Assumed speed of a sweep on two cores and yield of a cell, used only to say what a huge grid would cost."""

_STRICT = ConfigDict(frozen=True, extra="forbid", strict=True, allow_inf_nan=False)
_Model = TypeVar("_Model", bound=BaseModel)
_Options = TypeVar("_Options", bound=Options)


# A field's description completes the sentence "<key> = <value> must be ...": see `_sentence`.
class Range(BaseModel):
    """Evenly spaced values of one grid parameter, both ends included.

    Attributes
    ----------
    start, stop : float
        The ends, in either order.
    num : int
        Number of values.
    spacing : {"linear", "log"}
        Equal differences or equal ratios.
    """

    model_config = _STRICT

    start: float = Field(description="a finite number")
    stop: float = Field(description="a finite number")
    num: int = Field(ge=1, le=MAX_COUNT, description=f"a whole number from 1 to {MAX_COUNT:,}")
    spacing: Literal["linear", "log"] = Field("linear", description='"linear" or "log"')

    def values(self) -> list[float]:
        """Return the `num` values from `start` to `stop`, each rounded once.

        The arithmetic is decimal and starts from the numbers as written. So the values are those that a
        person would write (0.05 to 0.9 in 18 contains exactly 0.15), and they, and the hash that they
        enter, do not depend on the mathematical library of the machine.
        """
        if self.num == 1:
            return [self.start]
        with localcontext(Context(prec=40)):
            start, stop, last = Decimal(repr(self.start)), Decimal(repr(self.stop)), self.num - 1
            if self.spacing == "linear":
                exact = [start + (stop - start) * i / last for i in range(self.num)]
            else:
                rate = (stop / start).ln()
                exact = [start * (rate * i / last).exp() for i in range(self.num)]
            return [float(value) for value in exact]


class Search(BaseModel):
    """How limit cycles are looked for in a sweep (the ``[search]`` table).

    Attributes
    ----------
    starts : int
        Quasi-random starts in each cell of the subgrid.
    seed : int
        Seed of the quasi-random starts.
    subgrid : int or dict of str to int
        Stride of the subgrid on which many starts are made: along every axis, or along each named
        axis (then 1 along the others). `SweepConfig.strides` resolves it.
    period_min, period_max : float
        Shortest and longest period looked for, in the model's unit of time.
    search_box : dict of str to list of two floats
        Least and greatest value of the starts, by entry of the section.
    widen : float
        Factor on the width of the model's search box.
    """

    model_config = _STRICT

    starts: int = Field(64, ge=1, le=STARTS_MAX, description=f"a whole number from 1 to {STARTS_MAX:,}")
    seed: int = Field(0, ge=0, lt=2**32, description="a whole number from 0 to 4,294,967,295")
    subgrid: Annotated[int, Field(ge=1)] | dict[str, Annotated[int, Field(ge=1)]] = Field(
        1, description="a whole number of at least 1, or a table of such numbers for grid parameters"
    )
    period_min: float = Field(gt=0, description="a finite number above 0")
    period_max: float = Field(gt=0, description="a finite number above 0")

    search_box: dict[str, list[float]] = Field(
        {}, description="a table of lists of two numbers, such as { theta1 = [0.3, 0.5] }"
    )
    widen: float = Field(1.0, gt=0, description="a finite number above 0")

    @model_validator(mode="after")
    def _periods_in_order(self) -> "Search":
        if self.period_min >= self.period_max:
            raise ValueError(f"period_min = {self.period_min} must be below period_max = {self.period_max}")
        return self

    @property
    def options(self) -> SearchOptions:
        """The options of the search at one point."""
        return SearchOptions(
            self.starts,
            self.seed,
            self.period_min,
            self.period_max,
            search_box=self.search_box,
            widen=self.widen,
        )


class _File(BaseModel):
    """The top level of a file, before the model is known and its tables are read."""

    model_config = _STRICT

    model: str = Field(description='the name or path of a model in quotes, such as "wobbling"')
    params: dict[str, Any] = Field({}, description="a table of numbers, [params]")
    grid: dict[str, Any] = Field({}, description="a table of lists or ranges, [grid]")
    search: dict[str, Any] = Field({}, description="a table, [search]")
    acceptance: dict[str, Any] = Field({}, description="a table, [acceptance]")
    continuation: dict[str, Any] = Field({}, description="a table, [continuation]")
    special_points: bool = Field(True, description="true or false")
    units: dict[str, Any] = Field({}, description="a table of numbers, [units]")
    max_cells: int = Field(
        2_000_000, ge=1, le=MAX_COUNT, description=f"a whole number from 1 to {MAX_COUNT:,}"
    )


class SweepConfig(BaseModel):
    """A sweep, resolved to the last value. Made by `load_config` or `parse_config`.

    Attributes
    ----------
    model : str
        What the model is loaded by: its name, or the path of its file.
    params : dict of str to float
        Every parameter held fixed, the preset's included, in the model's order.
    grid : dict of str to tuple of float
        The values of every parameter varied, ascending and without duplicates, in the model's order of
        parameters: the order of keys and values in a file does not affect how cells are numbered.
    search : Search
        Settings of the search for limit cycles.
    acceptance : AcceptanceOptions
        What a solution must satisfy to be accepted as a limit cycle.
    continuation : ContinuationOptions
        Step control with which branches are followed through the grid.
    special_points : bool
        Whether bifurcations and ends of gaits along the lines of the grid are located.
    units : dict of str to float
        Size of the robot whose SI units the file was written in; empty where it was in the model's units, as
        all numbers here are.
    """

    model_config = _STRICT
    _loaded: Model | None = PrivateAttr(None)

    model: str
    params: dict[str, float]
    grid: dict[str, tuple[float, ...]]
    search: Search
    acceptance: AcceptanceOptions = AcceptanceOptions()
    continuation: ContinuationOptions = IN_SWEEPS
    special_points: bool = True
    units: dict[str, float] = {}

    @property
    def loaded(self) -> Model:
        """The model, loaded once."""
        if self._loaded is None:
            self._loaded = load(self.model)
        return self._loaded

    @property
    def n_cells(self) -> int:
        """Number of grid cells."""
        return math.prod(map(len, self.grid.values()))

    @property
    def strides(self) -> dict[str, int]:
        """Stride of the search's subgrid along each grid parameter, no longer than the axis."""
        subgrid = self.search.subgrid
        given = subgrid if isinstance(subgrid, dict) else dict.fromkeys(self.grid, subgrid)
        return {name: min(given.get(name, 1), max(1, len(axis) - 1)) for name, axis in self.grid.items()}

    def canonical(self) -> str:
        """Return the configuration as canonical JSON (see `canonical_json`)."""
        data = self.model_dump()
        data["search"]["subgrid"] = self.strides
        if not self.units:
            del data["units"]
        data["model"] = self.loaded.name  # where a model file lies does not belong to the configuration
        return canonical_json(data)

    @property
    def config_hash(self) -> str:
        """SHA-256 of `canonical`, in hexadecimal: the name of this sweep."""
        return hashlib.sha256(self.canonical().encode()).hexdigest()


def canonical_json(data: Mapping[str, Any]) -> str:
    """Return `data` as JSON in one fixed form: keys sorted, no blanks, floats by ``repr``, ASCII.

    Raises
    ------
    ValueError
        If `data` holds a NaN or an infinity.
    TypeError
        If `data` holds something that JSON has no form for.
    """
    return json.dumps(data, sort_keys=True, separators=(",", ":"), allow_nan=False)


def load_config(path: str | Path) -> SweepConfig:
    """Read a sweep configuration from a TOML file.

    Raises
    ------
    InputError
        If the file cannot be read or is not TOML, and whenever `parse_config` raises it.
    """
    try:
        text = contents(path, LARGEST_FILE).decode("utf-8")
    except UnicodeDecodeError as error:
        raise InputError(
            f"{path} is not UTF-8 text (byte 0x{error.object[error.start]:02x} at offset {error.start}); "
            "save the sweep configuration as UTF-8"
        ) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(
            f"cannot read the sweep configuration {path} ({reason}); give the path of a TOML file"
        ) from None
    try:
        data = tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        located = isinstance(error, tomllib.TOMLDecodeError)
        problem = error if located else "a number in it is too long or a nesting too deep"
        raise InputError(f"{path} is not valid TOML: {problem}; correct it there") from None
    return parse_config(data, str(path))


def parse_config(data: Mapping[str, Any], source: str = "configuration") -> SweepConfig:
    """Check and resolve a sweep configuration given as nested mappings.

    Parameters
    ----------
    data : mapping
        What a TOML file holds: ``model``, and optionally ``params``, ``grid``, ``search``, ``max_cells``,
        and ``units``, with which all numbers with a unit are in SI units.
    source : str
        Where `data` comes from, for messages.

    Raises
    ------
    InputError
        For the first thing that is wrong: an unknown key, model or parameter, a parameter both fixed and
        varied, a value that is not a finite number or is out of range, a grid that is empty, has duplicate
        values or has more than ``max_cells`` cells.
    """
    file = _validated(_File, data, source)
    try:
        model = load(_beside(source, file.model))
    except InputError as error:
        raise InputError(f"{source}: model = {_show(file.model)}: {error}") from None
    parameters = {parameter.name: parameter for parameter in model.parameters}
    _check_names(file, parameters, source)
    si = Given.of(model, file.units, source)
    params = {
        name: _fixed(file, parameter, si, source)
        for name, parameter in parameters.items()
        if name not in file.grid
    }
    axes = {
        name: _axis(file.grid[name], si.parameter(parameter), f"{source}: [grid] {name}")
        for name, parameter in parameters.items()
        if name in file.grid
    }
    _check_size(axes, file.max_cells, source)
    grid = {
        name: tuple(si.own(v, parameters[name]) for v in _axis_values(axis, f"{source}: [grid] {name}"))
        for name, axis in axes.items()
    }
    shortest, longest = model.period_range
    given = {"period_min": shortest, "period_max": longest, **si.search(file.search)}
    search = _validated(Search, given, source, "search")
    try:
        search.options.box_for(model)
    except InputError as error:
        raise InputError(f"{source}: [search] {error}") from None
    for name in search.subgrid if isinstance(search.subgrid, dict) else ():
        if name not in grid:
            raise InputError(
                f"{source}: [search] subgrid names {name}, which is not in [grid]{hint(name, grid)}; "
                f"the grid has {', '.join(grid)}"
            )
    config = SweepConfig(
        model=model.source,
        params=params,
        grid=grid,
        search=search,
        acceptance=_record(AcceptanceOptions, file.acceptance, f"{source}: [acceptance]"),
        continuation=_record(
            ContinuationOptions, file.continuation, f"{source}: [continuation]", _usual(file)
        ),
        special_points=file.special_points,
        units={} if si.units is None else asdict(si.units),
    )
    config._loaded = model
    return config


def _fixed(file: _File, parameter: Parameter, si: Given, source: str) -> float:
    """The value of a parameter that does not vary: the file's, or else the preset's."""
    name = parameter.name
    if name not in file.params:
        return parameter.default
    value = _checked(file.params[name], si.parameter(parameter), f"{source}: [params] {name}")
    return si.own(value, parameter)


def _record(
    cls: type[_Options], values: Mapping[str, Any], where: str, usual: Mapping[str, Any] | None = None
) -> _Options:
    """A record of options from its table; what that leaves out is as usual."""
    try:
        return cls.from_mapping({**(usual or {}), **values})
    except InputError as error:
        raise InputError(f"{where} {error}") from None


def _usual(file: _File) -> dict[str, Any]:
    """What the table of continuation leaves out; a first step is not longer than the longest in it."""
    usual = asdict(IN_SWEEPS if file.special_points else IN_SWEEPS_OF_CYCLES)
    longest = file.continuation.get("ds_max")
    if isinstance(longest, int | float) and longest > 0:
        usual["ds"] = min(usual["ds"], longest)
    return usual


def _beside(source: str, model: str) -> str:
    """Where a model that is not built in lies: its path is meant from the folder of the configuration."""
    path = Path(source).parent / model
    if model in available():
        return model
    return str(path) if model.endswith(".py") or os.path.exists(path / "manifest.json") else model


def _check_names(file: _File, parameters: Mapping[str, Parameter], source: str) -> None:
    """Refuse names that are not parameters, names that are both fixed and varied, and an empty grid."""
    for table, entries in (("params", file.params), ("grid", file.grid)):
        for name in entries:
            if name not in parameters:
                raise InputError(
                    f"{source}: [{table}] {name} is not a parameter of the model {file.model}"
                    f"{hint(name, parameters)}; its parameters are {', '.join(parameters)}"
                )
    for name in file.params:
        if name in file.grid:
            raise InputError(f"{source}: {name} stands both in [params] and in [grid]; take it out of one")
    if not file.grid:
        raise InputError(
            f"{source}: [grid] is empty; list the values of at least one parameter, such as k = [0.5, 6.0]"
        )


def _axis(value: Any, parameter: Parameter, where: str) -> Range | list[float]:
    """Return a ``[grid]`` entry as a `Range` that is in order, or as a list, all in the parameter's range."""
    if isinstance(value, Mapping):
        spec = _validated(Range, value, where)
        for end in ("start", "stop"):  # a parameter's range is an interval, so the ends speak for all
            _checked(value[end], parameter, f"{where}: {end}")
        if spec.num == 1 and spec.start != spec.stop:
            raise InputError(
                f"{where}: num = 1 cannot hold both start = {spec.start} and stop = {spec.stop}; "
                "raise num to at least 2"
            )
        if spec.num > 1 and spec.start == spec.stop:
            raise InputError(
                f"{where}: start and stop are both {spec.start}, so num = {spec.num} values would be equal; "
                f"write [{spec.start}] or set them apart"
            )
        if spec.spacing == "log" and min(spec.start, spec.stop) <= 0:
            raise InputError(
                f'{where}: spacing = "log" needs start and stop above 0, not {spec.start} and {spec.stop}; '
                'change them or use "linear"'
            )
        return spec
    if not isinstance(value, list | tuple):
        raise InputError(
            f"{where} = {_show(value)} must be a list of numbers or a range such as "
            "{ start = 1, stop = 2, num = 11 }; a single fixed value belongs in [params]"
        )
    if not value:
        raise InputError(f"{where} is an empty list; give at least one value")
    return [_checked(item, parameter, f"{where}[{i}]") for i, item in enumerate(value)]


def _axis_values(axis: Range | list[float], where: str) -> tuple[float, ...]:
    """Return the values of one grid axis, ascending and all different."""
    values = sorted(value + 0.0 for value in (axis.values() if isinstance(axis, Range) else axis))
    for low, high in itertools.pairwise(values):
        if low == high:
            raise InputError(f"{where} holds the value {low} more than once; every value must be different")
    return tuple(values)


def _check_size(axes: Mapping[str, Range | list[float]], limit: int, source: str) -> None:
    """Refuse a grid of more than `limit` cells, before any of its values are made."""
    sizes = {name: axis.num if isinstance(axis, Range) else len(axis) for name, axis in axes.items()}
    cells = math.prod(sizes.values())
    if cells > limit:
        factors = " x ".join(f"{size:,} {name}" for name, size in sizes.items())
        raise InputError(
            f"{source}: [grid] has {cells:,} cells ({factors}), which would take about "
            f"{cells / CELLS_PER_SECOND / 3600:,.1f} hours on two cores and give about "
            f"{cells * CYCLES_PER_CELL:,} rows; the limit is {limit:,}: thin the grid out, or raise "
            "max_cells at the top of the file"
        )


def _checked(value: Any, parameter: Parameter, where: str) -> float:
    """Return `value` as a float in the parameter's range; `where` names it in the message if it is not."""
    number = math.nan
    if isinstance(value, int | float) and not isinstance(value, bool):
        with contextlib.suppress(OverflowError):
            number = float(value)
    if not math.isfinite(number):
        raise InputError(f"{where} = {_show(value)} is not a finite number; allowed: {parameter.allowed}")
    try:
        return parameter.check(number + 0.0)  # -0.0 and 0.0 are one value, and have one hash
    except InputError:
        raise InputError(
            f"{where} = {_show(value)} is outside the allowed range ({parameter.allowed})"
        ) from None


def _validated(cls: type[_Model], data: Mapping[str, Any], source: str, table: str = "") -> _Model:
    """Make a `cls` from `data`, or raise an InputError that reports the first thing wrong in one sentence."""
    try:
        return cls.model_validate(dict(data))
    except ValidationError as error:
        where = f"{source}: [{table}]" if table else f"{source}:"
        raise InputError(_sentence(error, cls, data, where)) from None


def _sentence(error: ValidationError, cls: type[BaseModel], data: Mapping[str, Any], where: str) -> str:
    """Return the first error of `error` as one sentence of ours."""
    # A misspelt key often makes another one missing: report the misspelling, which can have a hint.
    first = min(error.errors(include_url=False), key=lambda item: item["type"] != "extra_forbidden")
    if not first["loc"]:
        return f"{where} {first['ctx']['error']}"
    key = str(first["loc"][0])
    if first["type"] == "extra_forbidden":
        keys = cls.model_fields
        return f"{where} unknown key {key}{hint(key, keys)}; the keys are {', '.join(keys)}"
    description = cls.model_fields[key].description
    if first["type"] == "missing":
        return f"{where} {key} is missing; it must be {description}"
    return f"{where} {key} = {_show(data[key])} must be {description}"


def _show(value: Any) -> str:
    """Return a value of a file as text of bounded length."""
    if isinstance(value, bool):
        return str(value).lower()
    try:
        text = repr(value)
    except ValueError:  # Python prints no integer of more than 4,300 digits
        return "an integer of more than 4,300 digits"
    return text if len(text) <= 60 else f"{text[:57]}..."
