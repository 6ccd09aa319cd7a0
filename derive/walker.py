"""What a planar walking model consists of, as a declaration without any mechanics.

A model file states bodies as SymPy expressions of the walker's coordinates and of the position of its
stance foot, what holds that foot, when the swing foot strikes and how the legs then swap names. Everything
else (mass matrix, impact, ground force, ...) follows in `mechanics`.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import sympy as sp

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


@dataclass(frozen=True)
class Coordinate:
    """One generalised coordinate of the swing phase.

    Parameters
    ----------
    name : str
        Name in generated code; its rate is called ``d<name>``.
    unit : str
    meaning : str
        One line for the documentation of generated functions.
    """

    name: str
    unit: str
    meaning: str

    @property
    def symbol(self) -> sp.Symbol:
        """The coordinate."""
        return sp.Symbol(self.name, real=True)

    @property
    def rate(self) -> sp.Symbol:
        """Its time derivative."""
        return sp.Symbol(f"d{self.name}", real=True)


@dataclass(frozen=True)
class Parameter:
    """One parameter: its preset value, unit and allowed range.

    Parameters
    ----------
    name : str
    default : float
        The preset's value.
    unit : str
    meaning : str
    lower, upper : float or None
        Ends of the allowed range; None is no limit (but finite).
    lower_open, upper_open : bool
        Whether that end itself is excluded.
    """

    name: str
    default: float
    unit: str
    meaning: str
    lower: float | None = None
    upper: float | None = None
    lower_open: bool = False
    upper_open: bool = False

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
        Its orientation, in terms of the coordinates; only its rate matters.
    """

    name: str
    mass: sp.Expr
    position: sp.Matrix
    inertia: sp.Expr = sp.S.Zero
    angle: sp.Expr = sp.S.Zero


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
        The mass in the bodies' expressions; it is no parameter of the model.
    coordinates : tuple of Coordinate
    """

    mass: sp.Symbol
    coordinates: tuple[Coordinate, ...]


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


@dataclass(frozen=True)
class Units:
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


DIMENSIONLESS = Units()
SI = Units("kg", "m", "s", "J")
"""Units of a model that is written with a parameter for gravity."""


@dataclass(frozen=True, kw_only=True)
class Walker:
    """A planar walker that steps from one foot to the other, over flat or sloping ground.

    The x-axis lies along the ground, in the direction of walking, and the y-axis points away from it.

    Parameters
    ----------
    name : str
        Prefix of every generated function.
    title, reference : str
        One line for readers, and the source of the model.
    coordinates : tuple of Coordinate
    parameters : tuple of Parameter
        Every parameter can be swept.
    bodies : tuple of Body
    swing_foot : sympy.Matrix, shape (2, 1)
        What `STANCE_FOOT` is of the stance leg, of the swing leg: the impact brings it to rest, or to roll.
    touchdown : Touchdown
    relabel : dict of Symbol to sympy.Expr
        Each coordinate after the legs swap names, in terms of the coordinates before.
    search_box : dict of str to (float, float)
        Middle and half-width of the starts for each section coordinate and rate; starts crowd around the
        middle.
    gravity : sympy.Matrix, shape (2, 1)
        Acceleration of gravity; ``(sin(slope), -cos(slope))`` on ground that falls in the walking direction.
    potentials : dict of str to sympy.Expr
        Potential energy beside gravity (springs), by name.
    dissipation : sympy.Expr
        Rayleigh's dissipation function (half the power that dampers take), in terms of coordinates and
        rates.
    torques : dict of Coordinate to sympy.Expr
        Generalised force of each actuator, in terms of coordinates, rates, parameters and the clock's phase
        (or `TIME`).
    clock : Clock or None
    stance : sympy.Matrix, shape (2, 1)
        Where `STANCE_FOOT` is during the swing phase: the origin for a point foot, `rolling_arc` for a foot
        that rolls. The contact with the ground is straight below it.
    locks : tuple of sympy.Expr
        Expressions of the coordinates whose rates the impact stops as well, such as the angle of a knee.
    massless : Massless or None
    section : dict of Symbol to sympy.Expr
        Coordinates and rates that follow from the others just after touchdown. The rest, each coordinate
        with its rate in order, are the free coordinates on the Poincare section.
    stance_angle : Coordinate or None
        The stance leg's angle from the upright: the peaks of its rate are counted, and a walker has fallen
        when it is beyond a quarter turn.
    spring_mode : sympy.Expr or None
        Natural frequency whose whole oscillations in a period name the solution groups A, B, C, ...
    wobbling : Coordinate or None
        The coordinate whose zero crossings are counted.
    drawing : tuple of Line
        The lines by which the walker is drawn; the bodies are drawn as discs.
    period_range : (float, float)
        Shortest and longest period that is searched for by default.
    units : Units
    sources : dict of str to str
        Where an equation is found in the literature, by generated function.

    Raises
    ------
    InputError
        For a declaration that contradicts itself; see `checks` and `trials`.
    """

    name: str
    title: str
    reference: str
    coordinates: tuple[Coordinate, ...]
    parameters: tuple[Parameter, ...]
    bodies: tuple[Body, ...]
    swing_foot: sp.Matrix
    touchdown: Touchdown
    relabel: Mapping[sp.Symbol, sp.Expr]
    search_box: Mapping[str, tuple[float, float]]
    gravity: sp.Matrix = DOWN
    potentials: Mapping[str, sp.Expr] = field(default_factory=dict)
    dissipation: sp.Expr = sp.S.Zero
    torques: Mapping[Coordinate, sp.Expr] = field(default_factory=dict)
    clock: Clock | None = None
    stance: sp.Matrix = ORIGIN
    locks: tuple[sp.Expr, ...] = ()
    massless: Massless | None = None
    section: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    stance_angle: Coordinate | None = None
    spring_mode: sp.Expr | None = None
    wobbling: Coordinate | None = None
    drawing: tuple[Line, ...] = ()
    period_range: tuple[float, float] = (0.3, 3.0)
    units: Units = DIMENSIONLESS
    sources: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        from stridemap.derive.validate.mechanics import try_out
        from stridemap.derive.validate.names import check

        for name, value in vars(self).items():
            object.__setattr__(self, name, exact(value))
        if isinstance(self.clock, Clock) and not self.clock.resets:
            self._add_clock(self.clock)
        check(self)
        try_out(self)

    def _add_clock(self, clock: Clock) -> None:
        """Make the phase of a clock that is not reset a coordinate; see `Mechanics.inertia` for its row."""
        phase = clock.coordinate
        if phase in self.coordinates:
            return  # a declaration that was copied with changes
        object.__setattr__(self, "coordinates", (*self.coordinates, phase))
        object.__setattr__(self, "relabel", {**self.relabel, phase.symbol: phase.symbol - clock.turn})
        object.__setattr__(self, "section", {**self.section, phase.rate: clock.rate})
        box = {phase.name: (float(sp.pi), float(sp.pi)), **self.search_box}
        object.__setattr__(self, "search_box", box)

    @property
    def q(self) -> sp.Matrix:
        """Coordinates, shape (n, 1)."""
        return sp.Matrix([c.symbol for c in self.coordinates])

    @property
    def v(self) -> sp.Matrix:
        """Rates of the coordinates, shape (n, 1)."""
        return sp.Matrix([c.rate for c in self.coordinates])

    @property
    def phase(self) -> Coordinate | None:
        """The coordinate that is no motion but the phase of a clock that is not reset."""
        return self.clock.coordinate if self.clock is not None and not self.clock.resets else None

    @property
    def section_names(self) -> tuple[str, ...]:
        """Names of the free coordinates on the Poincare section: each coordinate with its rate, in order."""
        pairs = [(c.symbol, c.rate) for c in self.coordinates]
        return tuple(s.name for pair in pairs for s in pair if s not in self.section)

    @property
    def strike(self) -> sp.Expr:
        """The touchdown condition, with the sign that makes it rise through zero."""
        return self.touchdown.condition if self.touchdown.rising else -self.touchdown.condition

    def with_(self, **changes: Any) -> "Walker":
        """A copy with some fields changed, checked like any other declaration."""
        return replace(self, **changes)


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
    """
    return sp.Matrix([-radius * angle, radius])


def exact(value: Any) -> Any:
    """`value` with decimal numbers in its expressions as fractions: generated code has no rounded ones."""
    if isinstance(value, sp.MatrixBase):
        return sp.ImmutableMatrix(value.applyfunc(exact))
    if isinstance(value, sp.Basic):
        return sp.nsimplify(value, rational=True) if value.has(sp.Float) else value
    if isinstance(value, Body | Touchdown | Clock | Line):
        return replace(value, **{name: _exact_number(name, v) for name, v in vars(value).items()})
    if isinstance(value, tuple):
        return tuple(exact(v) for v in value)
    if isinstance(value, Mapping):
        return {key: exact(v) for key, v in value.items()}
    return value


def _exact_number(name: str, value: Any) -> Any:
    """Plain numbers where an expression is meant, as expressions."""
    if isinstance(value, bool | str):
        return value
    return exact(sp.sympify(value)) if isinstance(value, int | float) else exact(value)
