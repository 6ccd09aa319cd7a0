"""The walker that a model file declares.

A model file states bodies as SymPy expressions of the walker's coordinates and of the position of its
stance foot, what holds that foot, when the swing foot strikes and how the legs then swap names. Everything
else (mass matrix, impact, ground force, ...) follows in `mechanics`.
"""

import math
from dataclasses import dataclass, fields, replace
from typing import Any

import sympy as sp

from stridemap.derive.derived import Derived
from stridemap.derive.ground import in_ground_frame
from stridemap.derive.parts import DIMENSIONLESS, STANCE_FOOT, Clock, exact
from stridemap.derive.validate.ground import validate_gravity, validate_ground
from stridemap.derive.validate.mechanics import validate_mechanics
from stridemap.derive.validate.model_name import validate_model_name
from stridemap.derive.validate.motors import validate_motors
from stridemap.derive.validate.names import validate_names
from stridemap.derive.validate.refusal import refuse
from stridemap.derive.validate.types import validate_types
from stridemap.errors import InputError, short

USUAL_PERIODS = (0.3, 3.0)
"""Shortest and longest period that is searched for by default, in sqrt(L/g)."""


@dataclass(frozen=True, kw_only=True)
class Walker(Derived):
    """A planar walker that steps from one foot to the other, over flat or sloping ground.

    The x-axis lies along the ground, in the direction of walking, and the y-axis points away from it; with
    `ground`, points and gravity are those of somebody who stands upright, and are turned.

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
    ground : sympy.Expr
        Angle by which the ground falls in the walking direction, for a walker that is declared with a
        vertical y-axis: points as somebody sees them who stands upright, and gravity ``(0, -g)``. `stance` is
        along the ground all the same.
    rise : sympy.Expr
        How much higher each foothold is than the one before, on stairs; negative where they lead down.
    potentials : dict of str to sympy.Expr
        Potential energy in addition to gravity (springs), by name.
    dissipation : sympy.Expr
        Rayleigh's dissipation function (half the power that dampers take), in terms of coordinates and
        rates.
    motors : tuple of Motor
        Each a torque with the angle, or a force with the length, that it drives.
    torques : dict of Coordinate to sympy.Expr
        Short for motors that drive one coordinate each, and bear its name: the torque on each of these
        coordinates, in terms of coordinates, rates, parameters and the clock's phase (or `TIME`).
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
    quantities : tuple of Measured
        What is measured on every limit cycle in addition to the quantities of all models.
    period_range : (float, float), optional
        Shortest and longest period that is searched for by default. Where it is left out, 0.3 to 3
        sqrt(L/g); in units of one's own, L is the distance of the centre of mass from the stance foot, with
        all coordinates zero and the preset's parameters.
    units : UnitNames
    sources : dict of str to str
        Where an equation is found in the literature, by generated function.

    Its torques may use what is derived from the rest: the mass matrix `M` and bias forces `h`
    (``M ddq + h = Q``), `energy`, `kinetic_energy`, `potential_energy`, `centre_of_mass`, and `jacobian` and
    `rate` of any point. Declare it without torques first, and add them by `with_`.

    Raises
    ------
    InputError
        For a declaration that contradicts itself; see `validate`.
    """

    def __post_init__(self) -> None:
        try:
            self._validate()
        except RecursionError:
            refuse(self, "an expression in it is nested too deeply; write it flat, or with fewer terms")
        except InputError:
            raise
        except Exception as error:  # of SymPy, about an expression that it has no way to handle
            said = f"{type(error).__name__}: {short(str(error))}"
            raise InputError(
                f"model {self.name}: an expression in it cannot be used ({said}); write it with sums, "
                "products, powers and smooth functions"
            ) from error

    def _validate(self) -> None:
        validate_types(self)
        for name, value in list(vars(self).items()):
            object.__setattr__(self, name, exact(value))
        if isinstance(self.clock, Clock) and not self.clock.resets:
            self._add_clock(self.clock)
        usual = self.period_range is None
        if usual:
            object.__setattr__(self, "period_range", USUAL_PERIODS)
        validate_names(self)
        validate_model_name(self)
        validate_motors(self)
        validate_gravity(self)
        seen = in_ground_frame(self)
        validate_mechanics(seen)
        validate_ground(seen, self)
        if usual and self.units.time != DIMENSIONLESS.time:
            object.__setattr__(self, "period_range", self._usual_periods())

    def _usual_periods(self) -> tuple[float, float]:
        """The range of periods that is searched for in units of one's own, where none is declared."""
        rest: dict[sp.Symbol, Any] = {a.symbol: a.default for a in self.parameters}
        rest |= {symbol: 0 for c in self.coordinates for symbol in (c.symbol, c.rate)}
        total = sum((body.mass for body in self.bodies), sp.S.Zero)
        moment = sum((body.mass * body.position for body in self.bodies), sp.zeros(2, 1))
        com = (moment / total).subs(dict(zip(STANCE_FOOT, self.standing, strict=True))).subs(rest)
        gravity = self.gravity.subs(rest)
        try:
            unit = math.sqrt(float(sp.sqrt(com.dot(com) / gravity.dot(gravity))))
        except (TypeError, ValueError):
            unit = math.nan
        if not (math.isfinite(unit) and unit > 0):
            raise InputError(
                f"{self.name}: which periods to search for does not follow from gravity and the bodies; "
                "give period_range = (shortest, longest)"
            )
        low, high = USUAL_PERIODS
        return low * unit, high * unit

    def _add_clock(self, clock: Clock) -> None:
        """Make the phase of a clock that is not reset a coordinate.

        `Mechanics.floating_mass_matrix` has a row for it.
        """
        phase = clock.coordinate
        if phase in self.coordinates:
            return  # a declaration that was copied with changes
        object.__setattr__(self, "coordinates", (*self.coordinates, phase))
        object.__setattr__(self, "relabel", {**self.relabel, phase.symbol: phase.symbol - clock.turn})
        object.__setattr__(self, "section", {**self.section, phase.rate: clock.rate})
        box = {phase.name: (float(sp.pi), float(sp.pi)), **self.search_box}
        object.__setattr__(self, "search_box", box)

    def with_(self, **changes: Any) -> "Walker":
        """A copy with some fields changed, checked like any other declaration."""
        unknown = sorted(changes.keys() - {field.name for field in fields(self)})
        if unknown:
            refuse(
                self, f"with_ was given {unknown[0]}, which a Walker does not have; see the fields of Walker"
            )
        return replace(self, **changes)
