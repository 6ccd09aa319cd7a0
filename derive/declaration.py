"""What a planar walking model consists of, as a declaration without any mechanics.

A model file states points and masses as SymPy expressions of its coordinates and of the position of
its stance foot; everything else (mass matrix, impact, ground force, ...) follows in `mechanics`.
"""

from dataclasses import dataclass

import sympy as sp

STANCE_FOOT = sp.Matrix(sp.symbols("stance_x stance_y", real=True))
"""Position of the stance foot, shape (2, 1): the two coordinates of the floating base."""

TIME = sp.Symbol("t", real=True)
"""Time since the last touchdown; the oscillator's phase is reset there."""


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
        Unit; ``M``, ``L``, ``g`` are upper-body mass, leg length and gravity.
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
class PointMass:
    """A point mass.

    Parameters
    ----------
    name : str
    mass : sympy.Expr
    position : sympy.Matrix, shape (2, 1)
        In terms of `STANCE_FOOT` and the coordinates.
    """

    name: str
    mass: sp.Expr
    position: sp.Matrix


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
    """

    name: str
    points: tuple[sp.Matrix, ...]
    spring: bool = False


@dataclass(frozen=True)
class Walker:
    """A planar walker that steps from one point foot to the other.

    Parameters
    ----------
    name : str
        Prefix of every generated function.
    title, reference : str
        One line for readers, and the source of the model.
    coordinates : tuple of Coordinate
    parameters : tuple of Parameter
    masses : tuple of PointMass
    springs : dict of str to sympy.Expr
        Potential energy beside gravity, by name.
    actuated : Coordinate
        The coordinate on which the controller's torque does work.
    torque : sympy.Expr
        The controller, in terms of coordinates, rates, parameters and `TIME`.
    swing_foot : sympy.Matrix, shape (2, 1)
    touchdown : sympy.Expr
        Zero when the swing foot is on the ground; it rises through zero at a touchdown.
    touchdown_side : sympy.Expr
        Negative at an admissible touchdown (it excludes the scuff at mid-stance).
    relabel : dict of Symbol to sympy.Expr
        Each coordinate after the legs swap names, in terms of the coordinates before.
    section_solves : tuple of (Symbol, sympy.Expr)
        The coordinate that the touchdown condition fixes on the section, and its value there.
    stance_angle : Coordinate
        The stance leg's angle; the peaks of its rate are counted.
    spring_mode : sympy.Expr or None
        Natural frequency that names the solution groups A, B, C, ...; None where there is none.
    wobbling : Coordinate or None
        The coordinate whose zero crossings are counted.
    drawing : tuple of Line
        The lines by which the walker is drawn; the masses are drawn as discs.
    search_box : dict of str to (float, float)
        Middle and half-width of the starts for each section coordinate and rate; starts crowd around the
        middle.
    """

    name: str
    title: str
    reference: str
    coordinates: tuple[Coordinate, ...]
    parameters: tuple[Parameter, ...]
    masses: tuple[PointMass, ...]
    springs: dict[str, sp.Expr]
    actuated: Coordinate
    torque: sp.Expr
    swing_foot: sp.Matrix
    touchdown: sp.Expr
    touchdown_side: sp.Expr
    relabel: dict[sp.Symbol, sp.Expr]
    section_solves: tuple[sp.Symbol, sp.Expr]
    stance_angle: Coordinate
    spring_mode: sp.Expr | None
    wobbling: Coordinate | None
    drawing: tuple[Line, ...]
    search_box: dict[str, tuple[float, float]]

    @property
    def q(self) -> sp.Matrix:
        """Coordinates, shape (n, 1)."""
        return sp.Matrix([c.symbol for c in self.coordinates])

    @property
    def v(self) -> sp.Matrix:
        """Rates of the coordinates, shape (n, 1)."""
        return sp.Matrix([c.rate for c in self.coordinates])

    @property
    def section(self) -> tuple[str, ...]:
        """Names of the free coordinates on the Poincare section: each coordinate with its rate, in order."""
        solved, _ = self.section_solves
        names: list[str] = []
        for c in self.coordinates:
            names += [c.rate.name] if c.symbol == solved else [c.name, c.rate.name]
        return tuple(names)
