"""A robot's size on the command line: parameters and results in SI units."""

from typing import TYPE_CHECKING, Annotated, Any

import typer

from stridemap.cli.options import assign, split

if TYPE_CHECKING:
    from stridemap.units import Units

TableUnitsOption = Annotated[
    list[str] | None,
    typer.Option(
        "--units",
        metavar="NAME=VALUE,...",
        help="Size of a robot, leg_length=0.75,mass=32 in m and kg, to convert to its SI units; by default those "
        "of a sweep with [units], and 'model' for the model's own.",
    ),
]

UnitsOption = Annotated[
    list[str] | None,
    typer.Option(
        "--units",
        metavar="NAME=VALUE,...",
        help="Size of a robot, leg_length=0.75,mass=32 in m and kg (and gravity in m/s^2): all numbers that are "
        "given and printed are then in SI units.",
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
