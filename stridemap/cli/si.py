"""A robot's size on the command line: what is given and printed is in SI units then."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stridemap.cli.options import assign, box, option_values, split
from stridemap.columns import Column, columns_of

if TYPE_CHECKING:
    from stridemap.solver.model.model import Model
    from stridemap.units import Units

_METAVAR = "NAME=VALUE,..."
UnitsOption = Annotated[
    list[str] | None,
    typer.Option(
        "--units",
        metavar=_METAVAR,
        help="Size of a robot, leg_length=0.75,mass=32 in m and kg (and gravity in m/s^2): all numbers "
        "with a unit that are given and printed are then in SI units.",
    ),
]
GivenUnitsOption = Annotated[
    list[str] | None,
    typer.Option(
        "--units",
        metavar=_METAVAR,
        help="Size of a robot, leg_length=0.75,mass=32 in m and kg: parameters are then in SI units.",
    ),
]
TableUnitsOption = Annotated[
    list[str] | None,
    typer.Option(
        "--units",
        metavar=_METAVAR,
        help="Size of a robot, leg_length=0.75,mass=32 in m and kg, to convert to its SI units; by default "
        "those of a sweep with [units], and 'model' for the model's own.",
    ),
]


def table_units(words: list[str] | None) -> "Units | str | None":
    """The units of a table that is read: a robot's, ``model``, or None as it was written.

    Raises
    ------
    InputError
        As `units_of`.
    """
    return "model" if words == ["model"] else units_of(words)


def units_of(words: list[str] | None) -> "Units | None":
    """The size of a robot from words ``leg_length=0.75,mass=32``; None where it is not given.

    Raises
    ------
    InputError
        When an entry is unknown, missing or outside its range.
    """
    if not words:
        return None
    from stridemap.units import Units

    given: dict[str, Any] = {}
    for word in ",".join(words).split(","):
        assign(given, *split(word.strip(), "--units"))
    return Units.from_mapping(given, "--units")


@dataclass(frozen=True)
class Size:
    """The units in which a command takes and prints numbers.

    Parameters
    ----------
    columns : mapping of str to Column
        What is known of each number by name, in the model's units.
    units : Units or None
        Of a robot; None for the model's own.
    """

    columns: Mapping[str, Column]
    units: "Units | None" = None

    @classmethod
    def of(cls, model: "Model", words: list[str] | None) -> "Size":
        """By the option ``--units``.

        Raises
        ------
        InputError
            When it is not understood, or the model is not written in units that a size converts.
        """
        units = units_of(words)
        if units is not None:
            from stridemap.units import check_scaled

            check_scaled(model.spec)
        return cls(columns_of(model.spec), units)

    def factor(self, name: str) -> float:
        """What 1 of the model's unit of a number is in the unit in which it is given and printed."""
        scale = self.columns[name].scale if name in self.columns else ""
        return self.units.unit(scale) if self.units and scale not in ("", "1", "rad") else 1.0

    def column(self, name: str) -> Column:
        """What a number is, in the unit in which it is printed."""
        known = self.columns.get(name, Column(name, ""))
        return known if self.units is None else known.in_si

    def own(self, name: str, value: Any) -> Any:
        """A number as the model has it; what is not a number stays, and is refused by others."""
        factor = self.factor(name)
        return value / factor if isinstance(value, float | int) and factor != 1.0 else value

    def all_own(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Numbers, or pairs of them, by name as the model has them."""
        return {
            name: tuple(self.own(name, end) for end in value)
            if isinstance(value, tuple)
            else self.own(name, value)
            for name, value in values.items()
        }

    def search(
        self, starts: int, options: list[str] | None, ranges: list[str] | None = None
    ) -> dict[str, Any]:
        """Options of a search as the model has them, from the words of ``--search`` and ``--search-box``."""
        given, periods = option_values("--search", options), ("period_min", "period_max")
        own = {name: self.own("period", v) if name in periods else v for name, v in given.items()}
        return {"starts": starts, **own, "search_box": self.all_own(box(ranges))}

    def shown(self, name: str, value: Any) -> Any:
        """A number of the model as it is printed."""
        factor = self.factor(name)
        number = isinstance(value, float) or getattr(getattr(value, "dtype", None), "kind", "") == "f"
        return value * factor if number and factor != 1.0 else value

    def all_shown(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Numbers of the model by name as they are printed, also within mappings and lists of them."""
        out: dict[str, Any] = {}
        for name, value in values.items():
            if isinstance(value, Mapping):
                out[name] = self.all_shown(value)
            elif isinstance(value, list) and value and all(isinstance(one, Mapping) for one in value):
                out[name] = [self.all_shown(one) for one in value]
            else:
                out[name] = self.shown(name, value)
        return out

    def ends(self, name: str, ends: Any) -> Any:
        """Lowest and highest value of a parameter as the model has them."""
        return tuple(self.own(name, end) for end in ends)

    def unit(self, name: str) -> str:
        """The SI unit of a number; empty for a pure number, and where no size is given."""
        unit = "" if self.units is None else self.column(name).unit
        return "" if unit == "1" else unit

    def titled(self, name: str) -> str:
        """The name of a number, with its unit where that is an SI unit."""
        return f"{name} [{unit}]" if (unit := self.unit(name)) else name

    def frame(self, frame: Any) -> Any:
        """A data frame of the model's as it is printed and written."""
        return frame if self.units is None or not len(frame.columns) else self.units.table_si(frame)

    @property
    def said(self) -> dict[str, Any]:
        """What JSON says of its units: nothing where they are the model's."""
        return {} if self.units is None else {"units": asdict(self.units)}
