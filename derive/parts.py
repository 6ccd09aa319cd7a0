"""The parts that a declaration consists of: coordinates, parameters, bodies, motors, touchdown, lines."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

import sympy as sp

from stridemap import spec
from stridemap.derive import given
from stridemap.derive.terms import mapped
from stridemap.errors import InputError
from stridemap.errors import short as shown
from stridemap.spec import UnitNames

STANCE_FOOT = sp.Matrix(sp.symbols("stance_x stance_y", real=True))
"""Position of the stance foot, shape (2, 1): the two coordinates of the floating base.

Of a point foot it is the point; of a rolling foot, the centre of its arc.
"""

DOWN = sp.ImmutableMatrix([0, -1])
ORIGIN = sp.ImmutableMatrix([0, 0])

TIME = sp.Symbol("t", real=True)
"""Time since the last touchdown."""

PHASE = "phase"
"""Name of the coordinate that a clock which is not reset adds."""


class Coordinate(spec.Coordinate):
    """One generalised coordinate of the swing phase.

    Parameters
    ----------
    name : str
        Name in generated code; its rate is called ``d<name>``.
    unit : str
    meaning : str
        One line for the documentation of generated functions.
    rate_unit : str
        Left empty: it follows from `unit` and the walker's units.
    """

    @property
    def symbol(self) -> sp.Symbol:
        """The coordinate in expressions."""
        return sp.Symbol(self.name, real=True)

    @property
    def rate(self) -> sp.Symbol:
        """Its time derivative in expressions."""
        return sp.Symbol(f"d{self.name}", real=True)


class Parameter(spec.Parameter):
    """One parameter: its preset value, unit and allowed range.

    Parameters
    ----------
    name : str
    default : float
        The preset's value.
    unit : str
    meaning : str
    lower, upper : float or None
        Ends of the allowed range; None means that there is none (but values must be finite).
    lower_open, upper_open : bool
        Whether that end itself is excluded.
    counts : bool
        Whether it counts something, such as spokes, so that it does not vary along a branch.
    """

    @property
    def symbol(self) -> sp.Symbol:
        """The parameter in expressions."""
        return sp.Symbol(self.name, real=True)


@dataclass(frozen=True)
class Body:
    """A rigid body, or a point mass where it has no moment of inertia.

    Parameters
    ----------
    name : str
    mass : sympy.Expr
    position : sympy.Matrix, shape (2, 1)
        Its centre of mass, in terms of `STANCE_FOOT` and the coordinates.
    inertia : sympy.Expr
        Moment of inertia about the centre of mass.
    angle : sympy.Expr
        Its orientation, in terms of the coordinates; only its rate matters. The bodies of one motor
        (`Motor.between`) count their angles in the same sense.
    """

    name: str
    mass: sp.Expr
    position: sp.Matrix
    inertia: sp.Expr = sp.S.Zero
    angle: sp.Expr = sp.S.Zero


@dataclass(frozen=True)
class Motor:
    """A motor: a torque, and the angle that it drives; or a force, and the length that it drives.

    Its power is the torque times the rate of what it drives, and the generalised forces follow from virtual
    work, so that they are right in any coordinates.

    Parameters
    ----------
    name : str
        Of its columns (``work_<name>``), where a walker has several motors.
    torque : sympy.Expr
        In terms of coordinates, rates, parameters and the clock's phase (or `TIME`). A positive one makes
        what it drives grow.
    drives : sympy.Expr
        The angle or length that it drives, in terms of coordinates, parameters and `STANCE_FOOT`: between two
        bodies of the walker (see `between`), or between one and the ground. Only its rate matters.
    meaning : str
        One line for the documentation of generated functions.
    limit : float or None
        The largest absolute torque that it can give, which the column ``limit_use`` compares with.
    efficiency : float
        Mechanical work that it gives per unit of energy drawn, above 0 and up to 1. Work that is done on
        it is counted at its absolute value: nothing is recovered.
    kind : {"torque", "force"} or None
        Whether it drives an angle or a length; None finds it out from units and form of `drives`.
    bodies : tuple of Body
        The bodies that it acts between, where `between` made it.
    """

    name: str
    torque: sp.Expr
    drives: sp.Expr
    meaning: str = ""
    limit: float | None = None
    efficiency: float = 1.0
    kind: Literal["torque", "force"] | None = None
    bodies: tuple[Body, ...] = ()

    @classmethod
    def between(
        cls, name: str, torque: sp.Expr, body: Body, other: Body | None = None, **options: Any
    ) -> "Motor":
        """A motor between two bodies of the walker, or between one and the ground.

        It drives the angle of `body` minus that of `other`: a positive torque turns `body` towards a larger
        angle, and `other` the other way.

        Parameters
        ----------
        name : str
        torque : sympy.Expr
        body : Body
        other : Body or None
            None is the ground.
        **options
            `meaning`, `limit` and `efficiency`.

        Raises
        ------
        InputError
            When one of them is not a Body.
        """
        bodies = (body,) if other is None else (body, other)
        for one in bodies:
            if not isinstance(one, Body):
                raise InputError(
                    f"motor {name}: {shown(one)} is not a Body; "
                    "give the bodies themselves, or an angle as drives"
                )
        angles = [given.expression(one.angle, f"the angle of the body {one.name}") for one in bodies]
        drives = angles[0] - (sp.S.Zero if other is None else angles[1])
        return cls(name, torque, drives, bodies=bodies, kind="torque", **options)


@dataclass(frozen=True)
class Touchdown:
    """When the swing foot strikes the ground.

    Parameters
    ----------
    condition : sympy.Expr
        Zero with the swing foot on the ground, in terms of coordinates and parameters. It must be zero just
        after touchdown too, where the foot that has become the swing foot is still on the ground.
    region : sympy.Expr
        Negative at an admissible touchdown; it excludes the scuff of straight legs at mid-stance.
    rising : bool
        Whether the condition rises through zero at a touchdown; else it falls.
    """

    condition: sp.Expr
    region: sp.Expr
    rising: bool = True


@dataclass(frozen=True)
class Clock:
    """The controller's oscillator: a phase that grows at a constant rate.

    Parameters
    ----------
    rate : sympy.Expr
        In terms of parameters.
    resets : bool
        Whether the phase is set to zero at every touchdown. If not, the phase at touchdown is one more
        coordinate, called ``phase``, and a limit cycle is locked to the clock.
    turn : sympy.Expr
        By how much the phase of a clock that is not reset advances in one step of a limit cycle.
    """

    rate: sp.Expr
    resets: bool = True
    turn: sp.Expr = 2 * sp.pi

    @property
    def phase(self) -> sp.Expr:
        """The phase in expressions."""
        return self.rate * TIME if self.resets else self.coordinate.symbol

    @property
    def coordinate(self) -> Coordinate:
        """The coordinate of a clock that is not reset."""
        return Coordinate(PHASE, "rad", "phase of the clock")


@dataclass(frozen=True)
class Massless:
    """The limit in which a mass goes to zero, and the coordinates that only this mass moves with.

    The equations of those coordinates are divided by the mass before it is let go to zero.

    Parameters
    ----------
    mass : sympy.Symbol
        The mass in the bodies' expressions; it is not a parameter of the model.
    coordinates : tuple of Coordinate
    """

    mass: sp.Symbol
    coordinates: tuple[Coordinate, ...]


@dataclass(frozen=True)
class Measured:
    """A quantity of one's own that is measured on every limit cycle: it becomes a column like the others.

    Parameters
    ----------
    name : str
        Of the attribute and of the column.
    expression : sympy.Expr
        In terms of coordinates, rates, parameters and `TIME`; smooth along the step.
    reduction : {"maximum", "minimum", "amplitude", "final"}
        Which number of a step it is: the largest, the smallest, the largest absolute value (each in
        continuous time, ends included), or the value just before touchdown.
    label, definition : str
        A few words for axes, and one sentence.
    kind : str
        What it is a quantity of, for its unit: ``"length"``, ``"torque"``, ``"number"``, ...
    """

    name: str
    expression: sp.Expr
    reduction: str
    label: str
    definition: str
    kind: str = "number"


@dataclass(frozen=True)
class Line:
    """A line through points of the walker, by which it is drawn.

    Parameters
    ----------
    name : str
        Name of the output in generated code.
    points : tuple of sympy.Matrix, shape (2, 1) each
        In terms of `STANCE_FOOT` and the coordinates.
    spring : bool
        Whether it is drawn as a spring.
    legs : bool
        Whether it is the legs, from the stance foot to the swing foot: the first half of its points is the
        stance leg, and each leg is drawn in a colour of its own.
    """

    name: str
    points: tuple[sp.Matrix, ...]
    spring: bool = False
    legs: bool = False


DIMENSIONLESS = UnitNames()
SI = UnitNames("kg", "m", "s", "J")
"""Units of a model that is written with a parameter for gravity."""


def rolling_arc(radius: sp.Expr, angle: sp.Expr) -> sp.Matrix:
    """Where the centre of a circular foot is while it rolls without slip, for `Walker.stance`.

    Parameters
    ----------
    radius : sympy.Expr
    angle : sympy.Expr
        Of the stance leg from the vertical, positive leaning back.

    Returns
    -------
    sympy.Matrix, shape (2, 1)

    Raises
    ------
    InputError
        When one of them is not a single expression.
    """
    radius = given.expression(radius, "the radius of rolling_arc")
    angle = given.expression(angle, "the angle of rolling_arc")
    return sp.Matrix([-radius * angle, radius])


def exact(value: Any) -> Any:
    """`value` with decimal numbers in its expressions as fractions: generated code has no rounded ones."""
    if isinstance(value, sp.MatrixBase):
        return sp.ImmutableMatrix(value.applyfunc(exact))
    if isinstance(value, sp.Basic):
        return mapped(value, _rational)
    if isinstance(value, Motor):  # limit and efficiency stay numbers
        parts = {name: _exact_number(name, getattr(value, name)) for name in ("torque", "drives", "bodies")}
        return replace(value, **parts)
    if isinstance(value, Body | Touchdown | Clock | Line | Measured):
        return replace(value, **{name: _exact_number(name, v) for name, v in vars(value).items()})
    if isinstance(value, tuple):
        return tuple(exact(v) for v in value)
    if isinstance(value, Mapping):
        return {key: exact(v) for key, v in value.items()}
    return value


def _rational(value: sp.Basic) -> sp.Basic:
    return sp.nsimplify(value, rational=True) if value.has(sp.Float) else value


def _exact_number(name: str, value: Any) -> Any:
    """Plain numbers where an expression is meant, as expressions."""
    if isinstance(value, bool | str):
        return value
    return exact(sp.sympify(value)) if isinstance(value, int | float) else exact(value)
