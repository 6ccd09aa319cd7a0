"""What a planar walking model consists of, without any mechanics and before anything is checked.

`Walker` is what a model file writes: this declaration, checked. The two are apart so that what checks a
declaration can be imported by what is checked.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field

import sympy as sp

from stridemap.derive.parts import (
    DIMENSIONLESS,
    DOWN,
    ORIGIN,
    Body,
    Clock,
    Coordinate,
    Line,
    Massless,
    Measured,
    Motor,
    Parameter,
    Touchdown,
)
from stridemap.spec import UnitNames


@dataclass(frozen=True, kw_only=True)
class Declaration:
    """The fields of a `Walker`, which says what each of them means."""

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
    ground: sp.Expr = sp.S.Zero
    rise: sp.Expr = sp.S.Zero
    potentials: Mapping[str, sp.Expr] = field(default_factory=dict)
    dissipation: sp.Expr = sp.S.Zero
    motors: tuple[Motor, ...] = ()
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
    quantities: tuple[Measured, ...] = ()
    period_range: tuple[float, float] | None = None
    units: UnitNames = DIMENSIONLESS
    sources: Mapping[str, str] = field(default_factory=dict)

    @property
    def q(self) -> sp.Matrix:
        """Coordinates, shape (n, 1)."""
        return sp.Matrix([c.symbol for c in self.coordinates])

    @property
    def v(self) -> sp.Matrix:
        """Rates of the coordinates, shape (n, 1)."""
        return sp.Matrix([c.rate for c in self.coordinates])

    @property
    def to_level(self) -> sp.Matrix:
        """From vectors in the ground's axes, along it and away from it, to those in the declared axes."""
        c, s = sp.cos(self.ground), sp.sin(self.ground)
        return sp.ImmutableMatrix([[c, s], [-s, c]])

    @property
    def standing(self) -> sp.Matrix:
        """Where the stance foot is in the swing phase, in the axes of the declaration, shape (2, 1)."""
        return self.stance if self.ground == 0 else self.to_level * self.stance

    @property
    def phase(self) -> Coordinate | None:
        """The phase of a clock that is not reset: the one coordinate that describes no motion."""
        return self.clock.coordinate if self.clock is not None and not self.clock.resets else None

    @property
    def actuators(self) -> tuple[Motor, ...]:
        """Every motor: one per entry of `torques`, which bears its coordinate's name, then `motors`."""
        plain = (Motor(c.name, torque, c.symbol, c.meaning) for c, torque in self.torques.items())
        return (*plain, *self.motors)

    @property
    def section_names(self) -> tuple[str, ...]:
        """Names of the free coordinates on the Poincare section: each coordinate with its rate, in order."""
        pairs = [(c.symbol, c.rate) for c in self.coordinates]
        return tuple(s.name for pair in pairs for s in pair if s not in self.section)

    @property
    def guard(self) -> sp.Expr:
        """The touchdown condition, with the sign that makes it rise through zero at a touchdown."""
        return self.touchdown.condition if self.touchdown.rising else -self.touchdown.condition
