"""Equations of motion, impact and ground force of a declared walker, from one Lagrangian.

The stance foot has two coordinates of its own. Holding it (or making it roll) gives the swing phase, the
two rows of the held foot give the ground force, and releasing it gives the impact: nothing is derived twice.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import NoReturn

import sympy as sp

from stridemap.derive.declaration import Declaration
from stridemap.derive.parts import STANCE_FOOT, Coordinate
from stridemap.derive.simplify import simplified
from stridemap.derive.terms import terms_in
from stridemap.derive.turn import Turn, turn
from stridemap.errors import InputError

BASE = 2
"""Number of floating-base coordinates; they come first."""


@dataclass(frozen=True)
class Mechanics:
    """The floating-base mechanics of a walker; n is the number of its coordinates.

    Parameters
    ----------
    walker : Walker
    """

    walker: Declaration

    # -- the floating base -------------------------------------------------------------------------------

    @cached_property
    def floating_q(self) -> sp.Matrix:
        """Stance-foot position, then the coordinates, shape (2 + n, 1)."""
        return sp.Matrix([*STANCE_FOOT, *self.walker.q])

    @cached_property
    def floating_v(self) -> sp.Matrix:
        """Rates of `floating_q`."""
        base = sp.symbols("dstance_x dstance_y", real=True)
        return sp.Matrix([*base, *self.walker.v])

    def velocity(self, value: sp.Matrix | sp.Expr) -> sp.Matrix:
        """Time derivative of what depends on the floating coordinates, a column."""
        return sp.Matrix([value]).jacobian(self.floating_q) * self.floating_v

    @cached_property
    def floating_kinetic(self) -> sp.Expr:
        """Kinetic energy with the stance foot free."""
        total = sp.S.Zero
        for body in self.walker.bodies:
            velocity = self.velocity(body.position)
            total += body.mass * velocity.dot(velocity) / 2
            total += body.inertia * self.velocity(body.angle)[0] ** 2 / 2
        return total

    @cached_property
    def _inertial(self) -> sp.Expr:
        """What the mass matrix is made of: the kinetic energy.

        The phase of a clock has a row of its own in it, one that nothing else enters, so that it keeps its
        rate. It is not an energy, and does not appear in any other function.
        """
        phase = self.walker.phase
        return self.floating_kinetic + (phase.rate**2 / 2 if phase is not None else 0)

    @cached_property
    def potentials(self) -> dict[str, sp.Expr]:
        """Potential energy by name: gravity, and what is declared."""
        bodies = self.walker.bodies
        gravity = -sum(b.mass * self.walker.gravity.dot(b.position) for b in bodies)
        return {"gravity": gravity, **self.walker.potentials}

    @cached_property
    def floating_mass_matrix(self) -> sp.Matrix:
        """Mass matrix with the stance foot free, shape (2 + n, 2 + n)."""
        return sp.hessian(self._inertial, list(self.floating_v)).applyfunc(simplified)

    @cached_property
    def floating_velocity_terms(self) -> sp.Matrix:
        """Coriolis and centrifugal forces while the stance foot stands, shape (2 + n, 1).

        Those of the accelerations that a rolling foot has at constant rates are not among them.
        """
        momentum = sp.Matrix([self.floating_kinetic]).jacobian(self.floating_v).T
        terms = momentum.jacobian(self.floating_q) * self.floating_v
        terms -= sp.Matrix([self.floating_kinetic]).jacobian(self.floating_q).T
        return self.on_stance(terms).applyfunc(simplified)

    # -- the stance foot stands --------------------------------------------------------------------------

    @cached_property
    def stance_jacobian(self) -> sp.Matrix:
        """Velocity of the stance foot per unit of each rate, shape (2, n): zero for a point foot."""
        return self.walker.stance.jacobian(self.walker.q)

    @cached_property
    def stance_basis(self) -> sp.Matrix:
        """Floating-base velocities that the stance foot allows, per unit of each rate, shape (2 + n, n)."""
        return sp.Matrix.vstack(self.stance_jacobian, sp.eye(len(self.walker.coordinates)))

    @cached_property
    def _rolls(self) -> bool:
        return not self.stance_jacobian.is_zero_matrix

    def on_stance(self, expr: sp.Matrix | sp.Expr) -> sp.Matrix | sp.Expr:
        """`expr` with the stance foot where and as fast as it is in the swing phase."""
        velocity = self.stance_jacobian * self.walker.v
        places = dict(zip(STANCE_FOOT, self.walker.stance, strict=True))
        return expr.subs(dict(zip(self.floating_v[:BASE], velocity, strict=True))).subs(places)

    def _limit(self, rows: sp.Matrix) -> sp.Matrix:
        """Rows of equations, one for each coordinate, in the massless limit."""
        massless = self.walker.massless
        if massless is None:
            return rows
        result = rows.as_mutable()
        for i, coordinate in enumerate(self.walker.coordinates):
            for j in range(rows.cols):
                without, with_ = _orders(rows[i, j], massless.mass)
                result[i, j] = without
                if coordinate not in massless.coordinates:
                    continue
                if rest := sp.simplify(without):
                    self._refuse_limit(coordinate, rest)
                result[i, j] = with_
        return result

    def _refuse_limit(self, coordinate: Coordinate, rest: sp.Expr) -> NoReturn:
        """Raise an InputError for an equation that does not vanish with the mass."""
        mass = self.walker.massless.mass if self.walker.massless is not None else None
        raise InputError(
            f"model {self.walker.name}: the equation of {coordinate.name} does not vanish with {mass} (there "
            f"remains {rest}), so it has no massless limit; a torque or a spring on {coordinate.name} must "
            f"have {mass} as a factor"
        )

    def without_massless(self, expr: sp.Matrix | sp.Expr) -> sp.Matrix | sp.Expr:
        """`expr` with the mass that vanishes, where nothing is divided by it, set to zero."""
        massless = self.walker.massless
        return expr if massless is None else expr.subs(massless.mass, 0)

    @property
    def symmetric(self) -> bool:
        """Whether the mass matrix is symmetric, which dividing some rows by a mass ends."""
        return self.walker.massless is None

    @cached_property
    def mass_matrix(self) -> sp.Matrix:
        """Mass matrix of the swing phase, shape (n, n)."""
        if self._rolls:
            full = self.stance_basis.T * self.on_stance(self.floating_mass_matrix) * self.stance_basis
        else:
            full = self.floating_mass_matrix[BASE:, BASE:]
        return self._limit(full).applyfunc(simplified)

    @cached_property
    def velocity_terms(self) -> sp.Matrix:
        """Coriolis and centrifugal forces of the swing phase, shape (n, 1)."""
        if not self._rolls:
            return self._limit(self.floating_velocity_terms[BASE:, :]).applyfunc(simplified)
        kinetic = sp.Matrix([self.on_stance(self.floating_kinetic)])
        momentum = kinetic.jacobian(self.walker.v).T
        terms = momentum.jacobian(self.walker.q) * self.walker.v - kinetic.jacobian(self.walker.q).T
        return self._limit(terms).applyfunc(simplified)

    @cached_property
    def conservative_forces(self) -> dict[str, sp.Matrix]:
        """Gradient of each potential energy in the swing phase, shape (n, 1) each."""
        return {name: self._gradient(self.on_stance(v), self.walker.q) for name, v in self.potentials.items()}

    def _gradient(self, value: sp.Expr, wrt: sp.Matrix) -> sp.Matrix:
        return self._limit(sp.Matrix([value]).jacobian(wrt).T).applyfunc(simplified)

    @cached_property
    def dissipative_force(self) -> sp.Matrix:
        """Force of the dampers, on the left-hand side of the equation of motion, shape (n, 1)."""
        return self._gradient(self.walker.dissipation, self.walker.v)

    @cached_property
    def driven(self) -> sp.Matrix:
        """What each motor drives, an angle or a length, in the swing phase, shape (n_motors, 1)."""
        return sp.Matrix(
            len(self.walker.actuators), 1, [self.on_stance(m.drives) for m in self.walker.actuators]
        )

    @cached_property
    def motor_jacobian(self) -> sp.Matrix:
        """Rate of what each motor drives per unit of each rate, shape (n_motors, n)."""
        return self._derivatives(self.driven, self.walker.q)

    @cached_property
    def motor_rates(self) -> sp.Matrix:
        """Rate of what each motor drives, shape (n_motors, 1)."""
        return self.motor_jacobian * self.walker.v

    @cached_property
    def applied_torques(self) -> sp.Matrix:
        """Torques of the motors, shape (n_motors, 1)."""
        torques = [self.without_massless(motor.torque) for motor in self.walker.actuators]
        return sp.Matrix(len(torques), 1, torques)

    @cached_property
    def _control(self) -> tuple[sp.Matrix, sp.Matrix]:
        """Torques as the equation of motion needs them, and the map from them to generalised forces.

        Virtual work makes the map the transpose of `motor_jacobian`. A massless row is divided by its mass:
        there a torque acts with its part of first order in the mass, everywhere else with that of order zero.
        """
        jacobian, torques = self.motor_jacobian, self.applied_torques
        if self.walker.massless is None:
            return torques, jacobian.T
        mass, light = self.walker.massless.mass, self.walker.massless.coordinates
        columns = []
        for j, motor in enumerate(self.walker.actuators):
            first = motor.torque.diff(mass).subs(mass, 0)
            rows = jacobian[j, :].T
            divided = sp.Matrix(
                [e if c in light else 0 for e, c in zip(rows, self.walker.coordinates, strict=True)]
            )
            columns += [(torques[j], rows - divided), (first, divided)]
        for i, coordinate in enumerate(self.walker.coordinates):
            if coordinate in light and (rest := sp.simplify((jacobian[:, i].T * torques)[0])):
                self._refuse_limit(coordinate, rest)
        columns = [(u, column) for u, column in columns if u != 0 and not column.is_zero_matrix]
        if not columns:
            return sp.zeros(0, 1), sp.zeros(len(self.walker.coordinates), 0)
        return sp.Matrix([u for u, _ in columns]), sp.Matrix.hstack(*(column for _, column in columns))

    @property
    def controller(self) -> sp.Matrix:
        """Torques as they stand in the equation of motion, where a massless row is divided by its mass."""
        return self._control[0]

    def torque_vector(self, torques: Iterable[sp.Expr]) -> sp.Matrix:
        """Generalised force of the motors, for torques in the order of `controller`, shape (n, 1)."""
        torques = list(torques)
        return self._control[1] * sp.Matrix(len(torques), 1, torques)

    @cached_property
    def motor_base_jacobian(self) -> sp.Matrix:
        """Rate of what each motor drives per velocity of the stance foot alone, shape (n_motors, 2)."""
        drives = sp.Matrix(len(self.walker.actuators), 1, [m.drives for m in self.walker.actuators])
        return self.on_stance(self._derivatives(drives, STANCE_FOOT))

    @staticmethod
    def _derivatives(values: sp.Matrix, wrt: sp.Matrix) -> sp.Matrix:
        """Jacobian, also of no values."""
        return values.jacobian(wrt).applyfunc(simplified) if len(values) else sp.zeros(0, len(wrt))

    def passive_force(self) -> sp.Matrix:
        """Right-hand side of the equation of motion but for the actuators, shape (n, 1)."""
        return -(
            self.velocity_terms
            + self.dissipative_force
            + sum(self.conservative_forces.values(), sp.zeros(len(self.walker.coordinates), 1))
        )

    def ground_force(self, acceleration: sp.Matrix, torques: sp.Matrix) -> sp.Matrix:
        """Force on the stance foot, shape (2, 1).

        Parameters
        ----------
        acceleration : sympy.Matrix, shape (n, 1)
            Of the coordinates.
        torques : sympy.Matrix, shape (n_motors, 1)
            Of the motors. They and the springs count where they act between the walker and a place on the
            ground other than the foot.
        """
        inertia = self.on_stance(self.floating_mass_matrix[:BASE, BASE:]) * acceleration
        if self._rolls:
            rolling = self.stance_jacobian * acceleration
            rolling += (self.stance_jacobian * self.walker.v).jacobian(self.walker.q) * self.walker.v
            inertia += self.floating_mass_matrix[:BASE, :BASE] * rolling
        weight = -self.walker.gravity * sum(body.mass for body in self.walker.bodies)
        total = inertia + self.floating_velocity_terms[:BASE, :] + weight
        springs = sp.Matrix([sum(self.walker.potentials.values(), sp.S.Zero)]).jacobian(STANCE_FOOT).T
        total += self.on_stance(springs) - self.motor_base_jacobian.T * torques
        return self.without_massless(total).applyfunc(simplified)

    @cached_property
    def turn(self) -> Turn:
        """How the coordinates change when the whole walker turns; angular momentum belongs to that."""
        return turn(self.walker)

    def contact_moment(self, force: sp.Matrix, torques: sp.Matrix) -> sp.Expr:
        """Moment of the ground on the stance foot about the contact, straight below `STANCE_FOOT`.

        It is the balance of angular momentum about the contact: what torques, springs, dampers and the
        rolling foot's constraint do work with in a turn of the whole walker, gravity apart, comes from the
        ground. What acts at a place other than the foot (it depends on `STANCE_FOOT`) is not the foot's, and
        neither is the torque of a guide (`Turn.guided`).

        Parameters
        ----------
        force : sympy.Matrix, shape (2, 1)
            Ground force.
        torques : sympy.Matrix, shape (n_motors, 1)
            Of the motors.

        Returns
        -------
        sympy.Expr
            Positive from x to y.
        """
        rates, q, v, stance = self.turn.rates, self.walker.q, self.walker.v, set(STANCE_FOOT)
        total = sp.S.Zero
        for j, motor in enumerate(self.walker.actuators):
            if not motor.drives.free_symbols & stance:
                total += torques[j] * simplified((self.motor_jacobian[j, :] * rates)[0])
        for potential in self.walker.potentials.values():
            if not potential.free_symbols & stance:
                total -= simplified(self._along(potential, q, rates))
        total -= simplified(self._along(self.walker.dissipation, v, rates))
        carried = self.stance_jacobian * rates  # what rolls without slip moves so in the turn, too
        total -= force[0] * simplified(carried[0] + self.walker.stance[1]) + force[1] * simplified(carried[1])
        return total

    def _along(self, value: sp.Expr, symbols: sp.Matrix, direction: sp.Matrix) -> sp.Expr:
        """Derivative of a value in a direction of its symbols, without the mass that vanishes."""
        return self.without_massless((sp.Matrix([value]).jacobian(symbols) * direction)[0])

    # -- what is measured --------------------------------------------------------------------------------

    @cached_property
    def total_mass(self) -> sp.Expr:
        """Mass of the whole walker."""
        return self.without_massless(sp.expand(sum(body.mass for body in self.walker.bodies)))

    @cached_property
    def weight(self) -> sp.Expr:
        """Weight of the whole walker."""
        signed = [a.symbol for a in self.walker.parameters if a.lower is not None and a.lower >= 0]
        known = {symbol: sp.Symbol(symbol.name, nonnegative=True) for symbol in signed}
        gravity = self.walker.gravity.xreplace(known)
        size = sp.sqrt(sp.simplify(gravity.dot(gravity)))
        if unsigned := size.atoms(sp.Abs):
            which = min(str(a.args[0]) for a in unsigned)
            raise InputError(
                f"model {self.walker.name}: gravity can have either sign of {which}; give the parameter a "
                "lower limit of 0"
            )
        return simplified(self.total_mass * size.xreplace({d: s for s, d in known.items()}))

    @cached_property
    def tangential_weight(self) -> sp.Expr:
        """Component of the weight along the ground, in the direction of walking."""
        return simplified(self.total_mass * self.walker.gravity[0])

    @cached_property
    def normal_weight(self) -> sp.Expr:
        """Component of the weight into the ground."""
        return simplified(-self.total_mass * self.walker.gravity[1])

    @cached_property
    def centre_of_mass(self) -> sp.Matrix:
        """Centre of mass, shape (2, 1)."""
        total = sum((b.mass * b.position for b in self.walker.bodies), sp.zeros(2, 1))
        return (self.without_massless(self.on_stance(total)) / self.total_mass).applyfunc(simplified)

    @cached_property
    def swing_foot(self) -> sp.Matrix:
        """Swing foot, shape (2, 1)."""
        return self.on_stance(self.walker.swing_foot).applyfunc(simplified)

    @cached_property
    def kinetic_energy(self) -> sp.Expr:
        """Kinetic energy of the swing phase."""
        if self.symmetric and self.walker.phase is None:
            return (self.walker.v.T * self.mass_matrix * self.walker.v)[0] / 2
        return self.without_massless(sp.expand(self.on_stance(self.floating_kinetic)))

    @cached_property
    def potential_energy(self) -> sp.Expr:
        """Potential energy of the swing phase, of gravity and all the rest."""
        return self.without_massless(self.on_stance(sum(self.potentials.values())))

    # -- touchdown ---------------------------------------------------------------------------------------

    @cached_property
    def relabelled_q(self) -> sp.Matrix:
        """Coordinates after the legs swapped names, shape (n, 1)."""
        return sp.Matrix([self.walker.relabel[q] for q in self.walker.q])

    @cached_property
    def swap(self) -> sp.Matrix:
        """Linear map of the rates when the legs swap names, shape (n, n)."""
        return self.relabelled_q.jacobian(self.walker.q)

    @cached_property
    def before_touchdown(self) -> sp.Matrix:
        """Coordinates before the legs swapped names from those after, shape (n, 1)."""
        shift = self.relabelled_q - self.swap * self.walker.q
        return (self.swap.inv() * (self.walker.q - shift)).applyfunc(simplified)

    def _relabelled(self, expr: sp.Matrix) -> sp.Matrix:
        """`expr` of the coordinates after touchdown, in terms of those before."""
        return expr.subs(dict(zip(self.walker.q, self.relabelled_q, strict=True)), simultaneous=True)

    @cached_property
    def step_length(self) -> sp.Expr:
        """How far the step that ended with a touchdown led, in terms of the coordinates after it."""
        return simplified(sp.expand_trig(simplified(self._step[0])))

    @cached_property
    def step_rise(self) -> sp.Expr:
        """How much higher the step that ended with a touchdown led, in terms of the coordinates after it."""
        return simplified(self._step[1])

    @cached_property
    def _step(self) -> sp.Matrix:
        """From the old stance foot to the new, in terms of the coordinates after touchdown, shape (2, 1)."""
        before = dict(zip(self.walker.q, self.before_touchdown, strict=True))
        return self.swing_foot.subs(before, simultaneous=True) - self.walker.stance

    # The impact holds the swing foot as the stance foot was held, and releases the stance foot. Velocities
    # that the ground then allows are `after_release * w`, with any rates w in the new names; the impulse does
    # no work on them, so the momentum along them is kept:
    #     R^T Me R w = R^T Me v-,    R = after_release.
    # The matrix on the left is the mass matrix of the swing phase that begins.

    @cached_property
    def after_release(self) -> sp.Matrix:
        """Floating-base velocities with the swing foot held and the stance foot free, shape (2 + n, n).

        Per unit of each rate in the new names.
        """
        rates = self.swap.inv()
        foot = self.walker.swing_foot.jacobian(self.walker.q)
        return sp.Matrix.vstack(self._relabelled(self.stance_jacobian) - foot * rates, rates)

    @cached_property
    def impact_mass_matrix(self) -> sp.Matrix:
        """Mass matrix of the swing phase after touchdown, in the coordinates before, shape (n, n)."""
        return self._relabelled(self.mass_matrix).applyfunc(simplified)

    @cached_property
    def impact_momentum(self) -> sp.Matrix:
        """Generalised momentum in the new names, which the impact keeps, shape (n, 1)."""
        before = self.floating_mass_matrix * self.stance_basis * self.walker.v
        return self._limit(self.after_release.T * self.on_stance(before)).applyfunc(simplified)

    @cached_property
    def lock_jacobian(self) -> sp.Matrix:
        """Rates of what the impact locks, per unit of each rate in the new names, shape (n_locks, n)."""
        return sp.Matrix(self.walker.locks).jacobian(self.walker.q) * self.swap.inv()

    @cached_property
    def impact_equations(self) -> tuple[sp.Matrix, sp.Matrix]:
        """Matrix and right-hand side for the rates after touchdown, in the new names, and locks' forces."""
        locks = len(self.walker.locks)
        if not locks:
            return self.impact_mass_matrix, self.impact_momentum
        jacobian = self.lock_jacobian
        blocks = [[self.impact_mass_matrix, jacobian.T], [jacobian, sp.zeros(locks)]]
        return sp.Matrix(sp.BlockMatrix(blocks)), sp.Matrix.vstack(self.impact_momentum, sp.zeros(locks, 1))

    def impact_impulse(self, after: sp.Matrix) -> sp.Matrix:
        """Impulse on the swing foot for given rates after the impact, in the new names, shape (2, 1)."""
        change = self.after_release * after - self.stance_basis * self.walker.v
        rows = self.on_stance(self.floating_mass_matrix[:BASE, :])
        return self.without_massless(rows * change).applyfunc(simplified)

    # -- torques that are given --------------------------------------------------------------------------

    @property
    def takes_torques(self) -> bool:
        """Whether the motors' torques can be an input: no motor drives what has no mass."""
        light = self.walker.massless.coordinates if self.walker.massless is not None else ()
        indices = [i for i, c in enumerate(self.walker.coordinates) if c in light]
        return all(self.motor_jacobian[j, i] == 0 for j in range(self.motor_jacobian.rows) for i in indices)

    def force_of_given(self, torques: sp.Matrix) -> sp.Matrix:
        """Right-hand side of the equation of motion for given torques of all motors, shape (n, 1)."""
        return self.motor_jacobian.T * torques + self.passive_force()


def _orders(entry: sp.Expr, mass: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    """Coefficients of the zeroth and the first power of a mass, which enters equations as a polynomial."""
    if any(mass in term.free_symbols for term in terms_in([entry])):  # `coeff` does not see into terms
        return entry.subs(mass, 0), entry.diff(mass).subs(mass, 0)
    expanded = sp.expand(entry)
    return expanded.coeff(mass, 0), expanded.coeff(mass, 1)
