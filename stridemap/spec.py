"""What a generated walker is, as typed values: the contract between derivation and everything that runs.

`derive` writes a `ModelSpec` as ``manifest.json``; the solver reads it back. A leaf: only the standard
library is used here, so that every room can speak of parameters and quantities at no cost.
"""

import math
import numbers
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any, Literal

from stridemap.errors import InputError

FORMAT = 5
"""Of ``manifest.json``."""


@dataclass(frozen=True)
class Parameter:
    """A model parameter: its preset value, unit and allowed range.

    Parameters
    ----------
    name : str
    default : float
        The preset's value.
    unit, meaning : str
    lower, upper : float or None
        Ends of the allowed range; None is no limit (but finite).
    lower_open, upper_open : bool
        Whether that end itself is excluded.
    counts : bool
        Whether it counts something, so that it means nothing between whole numbers. It does not vary along a
        branch; a sweep may have it on an axis.
    """

    name: str
    default: float
    unit: str
    meaning: str
    lower: float | None = None
    upper: float | None = None
    lower_open: bool = False
    upper_open: bool = False
    counts: bool = False

    @property
    def allowed(self) -> str:
        """The allowed range in words."""
        below = None if self.lower is None else f"{'>' if self.lower_open else '>='} {self.lower:g}"
        above = None if self.upper is None else f"{'<' if self.upper_open else '<='} {self.upper:g}"
        return " and ".join(part for part in (below, above) if part) or "any finite number"

    def check(self, value: Any) -> float:
        """Return `value` as a float.

        Raises
        ------
        InputError
            When it is not a finite number in the allowed range.
        """
        if isinstance(value, bool) or not isinstance(value, numbers.Real):
            raise InputError(f"{self.name} = {value!r} is not a number; allowed: {self.allowed}")
        number = float(value)
        inside = math.isfinite(number)
        if inside and self.lower is not None:
            inside = number > self.lower or (number == self.lower and not self.lower_open)
        if inside and self.upper is not None:
            inside = number < self.upper or (number == self.upper and not self.upper_open)
        if not inside:
            raise InputError(f"{self.name} = {number:g} is outside the allowed range ({self.allowed})")
        return number


@dataclass(frozen=True)
class Coordinate:
    """One generalised coordinate of the swing phase; its rate is called ``d<name>``.

    Parameters
    ----------
    name, unit, meaning : str
    rate_unit : str
        Unit of its time derivative.
    """

    name: str
    unit: str
    meaning: str
    rate_unit: str = ""


@dataclass(frozen=True)
class Entry:
    """One scalar of a vector argument of a generated function.

    Parameters
    ----------
    name, unit, meaning : str
    """

    name: str
    unit: str
    meaning: str


SIGNATURE = ("t", "q", "v", "u", "p")
"""Arguments of every generated function: time, coordinates, rates, torques of the motors, parameters."""

SECTION_SIGNATURE = ("z", "p")
"""Arguments of the function of a point on the section, which no state is known for yet."""


@dataclass(frozen=True)
class Input:
    """An argument of a generated function.

    Parameters
    ----------
    name : {"t", "q", "v", "u", "p", "z"}
        Time, coordinates, rates, torques of the motors, parameters, section point; `ModelSpec.entries` says
        what each holds.
    reads : tuple of str
        The entries that the function reads; it never touches the others.
    """

    name: str
    reads: tuple[str, ...]


@dataclass(frozen=True)
class Output:
    """A result of a generated function.

    Parameters
    ----------
    name : str
    shape : tuple of int
        () for a scalar, (n,) for a vector, (n, m) for a matrix, row by row.
    meaning : str
    """

    name: str
    shape: tuple[int, ...]
    meaning: str


@dataclass(frozen=True)
class Function:
    """A generated function.

    Parameters
    ----------
    summary, source : str
        What it computes, and the equation it comes from.
    operations : int
        Arithmetic operations and function calls.
    inputs : tuple of Input
        What it reads, in the order of `signature`.
    outputs : tuple of Output
    """

    summary: str
    source: str
    operations: int
    inputs: tuple[Input, ...]
    outputs: tuple[Output, ...]

    @property
    def arguments(self) -> tuple[str, ...]:
        """Names of the arguments that it reads, in order."""
        return tuple(one.name for one in self.inputs)

    @property
    def signature(self) -> tuple[str, ...]:
        """Names of all arguments in C and of a model's functions, whether it reads them or not."""
        return SECTION_SIGNATURE if "z" in self.arguments else SIGNATURE


@dataclass(frozen=True)
class Mass:
    """A body of the walker, by what it is to whoever draws it.

    Parameters
    ----------
    name : str
    role : {"stance_foot", "swing_foot", "wobbling", "body"}
    """

    name: str
    role: Literal["stance_foot", "swing_foot", "wobbling", "body"]


@dataclass(frozen=True)
class Line:
    """A line by which the walker is drawn.

    Parameters
    ----------
    name : str
        Of the output of the generated function ``drawing``.
    role : {"legs", "spring", "part"}
        ``legs`` lead from the stance foot to the swing foot; the first half of their points is the stance
        leg.
    """

    name: str
    role: Literal["legs", "spring", "part"]


@dataclass(frozen=True)
class Motor:
    """A motor: a torque and the angle that it drives, or a force and the length.

    Parameters
    ----------
    name : str
        Of its columns, where the model has several motors.
    kind : {"torque", "force"}
    unit : str
        Of its torque or force.
    meaning : str
    drives : str
        What it drives, in terms of coordinates and parameters.
    limit : float or None
        The largest absolute torque that it can give; None where none is declared.
    efficiency : float
        Mechanical work that it gives per unit of energy drawn.
    """

    name: str
    kind: Literal["torque", "force"]
    unit: str
    meaning: str
    drives: str
    limit: float | None = None
    efficiency: float = 1.0


@dataclass(frozen=True)
class UnitNames:
    """Names of the units that a model is written in.

    Parameters
    ----------
    mass, length, time, energy : str
    """

    mass: str = "M"
    length: str = "L"
    time: str = "sqrt(L/g)"
    energy: str = "M g L"

    def rate(self, unit: str) -> str:
        """Unit of a coordinate's rate."""
        return f"{unit} sqrt(g/L)" if self.time == "sqrt(L/g)" else f"{unit}/{self.time}"

    def of_motor(self, kind: str) -> str:
        """Unit of a torque or a force.

        Parameters
        ----------
        kind : {"torque", "force"}
        """
        if self.energy == "J":
            return {"torque": "N m", "force": "N"}[kind]
        if kind == "torque":
            return self.energy
        per_length = self.energy.removesuffix(f" {self.length}")
        return per_length if per_length != self.energy else f"{self.energy}/{self.length}"


REDUCTIONS = ("maximum", "minimum", "amplitude", "final")
"""How an expression along a step becomes one number: its largest, smallest or largest absolute value, or its
value just before touchdown."""


@dataclass(frozen=True)
class Quantity:
    """A measured quantity of a limit cycle: one entry of the registry (see `stridemap.quantities`).

    Parameters
    ----------
    name : str
        The attribute of an orbit, the column of a table, the key in JSON.
    kind : str
        What it is a quantity of: "length", "energy", "number", ...; a key of `stridemap.quantities.KINDS`.
    label : str
        A few words for axes and tables.
    definition : str
        One sentence.
    formula : str
        The definition as a formula, in LaTeX; empty where the sentence says it all.
    type : {"float", "int", "bool", "str"}
    optional : bool
        Whether a model can lack it; it is None there.
    differentiable : bool
        Whether it varies smoothly with state and parameters (between events that change the gait's kind).
    reduction : str
        One of `REDUCTIONS`, for a quantity that a model file declares. Empty for those of the registry, which
        have functions of their own.
    over_steps : str
        How the values of n walking steps become that of a cycle of n steps: "sum", "maximum", "minimum",
        their mean weighted "by_length" or "by_time", "per_speed" (a sum divided by a speed), or "cycle" for
        what belongs to the whole cycle. Where it is empty, a cycle of several steps lacks the quantity.
    """

    name: str
    kind: str
    label: str
    definition: str
    formula: str = ""
    type: Literal["float", "int", "bool", "str"] = "float"
    optional: bool = False
    differentiable: bool = False
    reduction: str = ""
    over_steps: str = ""


@dataclass(frozen=True)
class ModelSpec:
    """Everything that is known of a generated walker without its equations.

    Parameters
    ----------
    name, title, reference : str
    hash : str
        SHA-256 of its equations.
    generator, sympy : str
        What derived it.
    coordinates : tuple of Coordinate
    parameters : tuple of Parameter
    section : tuple of str
        Free coordinates and rates on the Poincare section, in order.
    search_box : dict of str to (float, float)
        Middle and half-width of the starts of a search, by entry of the section.
    period_range : (float, float)
        Shortest and longest period that is searched for by default.
    units : UnitNames
    masses : tuple of Mass
        The bodies.
    lines : tuple of Line
    motors : tuple of Motor
        In the order of their torques in ``controller_torque``.
    stance_angle, wobbling, phase : str or None
        Coordinates of these roles, where the model has them.
    functions : dict of str to Function
    quantities : tuple of Quantity
        What the model file declares to be measured in addition to the registry; their expressions over a step
        are the outputs of the generated function ``quantities``.
    files : dict of str to str
        SHA-256 of every generated file.
    """

    name: str
    title: str
    reference: str
    hash: str
    generator: str
    sympy: str
    coordinates: tuple[Coordinate, ...]
    parameters: tuple[Parameter, ...]
    section: tuple[str, ...]
    search_box: Mapping[str, tuple[float, float]]
    period_range: tuple[float, float]
    units: UnitNames
    masses: tuple[Mass, ...]
    lines: tuple[Line, ...]
    motors: tuple[Motor, ...]
    stance_angle: str | None
    wobbling: str | None
    phase: str | None
    functions: Mapping[str, Function]
    quantities: tuple[Quantity, ...] = ()
    files: Mapping[str, str] = field(default_factory=dict)

    def entries(self, argument: str) -> tuple[Entry, ...]:
        """What an argument of the generated functions holds, in order.

        Parameters
        ----------
        argument : {"t", "q", "v", "u", "p", "z"}
        """
        if argument == "t":
            return (Entry("t", self.units.time, "time since touchdown"),)
        if argument == "q":
            return tuple(Entry(c.name, c.unit, c.meaning) for c in self.coordinates)
        if argument == "v":
            return tuple(Entry(f"d{c.name}", c.rate_unit, f"rate of {c.name}") for c in self.coordinates)
        if argument == "u":
            return tuple(Entry(m.name, m.unit, m.meaning) for m in self.motors)
        if argument == "p":
            return tuple(Entry(a.name, a.unit, a.meaning) for a in self.parameters)
        known = {e.name: e for e in (*self.entries("q"), *self.entries("v"))}
        return tuple(known[name] for name in self.section)

    def size(self, argument: str) -> int:
        """Number of entries of an argument."""
        return len(self.entries(argument))

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the parameters, in order."""
        return tuple(a.name for a in self.parameters)

    @property
    def actuated(self) -> tuple[str, ...]:
        """Names of the motors, in order."""
        return tuple(motor.name for motor in self.motors)

    @property
    def scales(self) -> tuple[float, ...]:
        """Half-width of the search box along each entry of the section: what counts as far in a state."""
        return tuple(self.search_box[name][1] for name in self.section)

    def to_manifest(self) -> dict[str, Any]:
        """Plain values for ``manifest.json``."""
        return {"format": FORMAT, **asdict(self)}

    @classmethod
    def from_manifest(cls, data: Mapping[str, Any]) -> "ModelSpec":
        """The specification that ``manifest.json`` holds.

        Raises
        ------
        InputError
            When it is of another format.
        KeyError, TypeError
            When something is missing, or of another shape.
        """
        if data["format"] != FORMAT:
            raise InputError(
                f"was written by another version of stridemap (format {data['format']}, not {FORMAT})"
            )
        plain = {name: data[name] for name in cls.__dataclass_fields__}
        return cls(
            **plain
            | {
                "coordinates": tuple(Coordinate(**one) for one in data["coordinates"]),
                "parameters": tuple(Parameter(**one) for one in data["parameters"]),
                "section": tuple(data["section"]),
                "search_box": {name: (box[0], box[1]) for name, box in data["search_box"].items()},
                "period_range": (data["period_range"][0], data["period_range"][1]),
                "units": UnitNames(**data["units"]),
                "masses": tuple(Mass(**one) for one in data["masses"]),
                "lines": tuple(Line(**one) for one in data["lines"]),
                "motors": tuple(Motor(**one) for one in data["motors"]),
                "functions": {name: _function(one) for name, one in data["functions"].items()},
                "quantities": tuple(Quantity(**one) for one in data["quantities"]),
            }
        )


def _function(data: Mapping[str, Any]) -> Function:
    return Function(
        data["summary"],
        data["source"],
        data["operations"],
        tuple(Input(one["name"], tuple(one["reads"])) for one in data["inputs"]),
        tuple(Output(one["name"], tuple(one["shape"]), one["meaning"]) for one in data["outputs"]),
    )
