"""Equations of motion, impact and ground force of a declared walker, from one Lagrangian.

The stance foot has two coordinates of its own. Holding it gives the swing phase, the two held rows
give the ground force, and releasing it gives the impact: nothing is derived twice.
"""

from dataclasses import dataclass
from functools import cache, cached_property

import sympy as sp

from stridemap.derive.declaration import STANCE_FOOT, Walker

BASE = 2
"""Number of floating-base coordinates; they come first."""


@cache
def simplified(expr: sp.Expr) -> sp.Expr:
    """The shortest of a few equivalent forms, so that equations stay checkable by eye."""
    expanded = sp.expand(expr)
    reduced = sp.trigsimp(expanded)
    candidates = [expr, expanded, reduced, sp.factor(reduced)]
    for symbol in sorted(reduced.free_symbols, key=lambda s: s.name):
        candidates += [sp.collect(expanded, symbol), sp.collect(reduced, symbol)]
    candidates += [sp.factor_terms(c) for c in candidates]
    return min(candidates, key=lambda e: (sp.count_ops(e), sp.default_sort_key(e)))


@dataclass(frozen=True)
class Mechanics:
    """The floating-base mechanics of a walker; n is the number of its coordinates.

    Parameters
    ----------
    walker : Walker
    """

    walker: Walker

    @cached_property
    def floating_q(self) -> sp.Matrix:
        """Stance-foot position, then the coordinates, shape (2 + n, 1)."""
        return sp.Matrix([*STANCE_FOOT, *self.walker.q])

    @cached_property
    def floating_v(self) -> sp.Matrix:
        """Rates of `floating_q`."""
        base = sp.symbols("dstance_x dstance_y", real=True)
        return sp.Matrix([*base, *self.walker.v])

    def velocity(self, position: sp.Matrix) -> sp.Matrix:
        """Velocity of a point whose `position` depends on the floating coordinates, shape (2, 1)."""
        return position.jacobian(self.floating_q) * self.floating_v

    @cached_property
    def floating_kinetic(self) -> sp.Expr:
        """Kinetic energy with the stance foot free."""
        return sum(
            m.mass * self.velocity(m.position).dot(self.velocity(m.position)) / 2 for m in self.walker.masses
        )

    @cached_property
    def potentials(self) -> dict[str, sp.Expr]:
        """Potential energy by name: gravity (unit weight per unit mass) and the springs."""
        gravity = sum(m.mass * m.position[1] for m in self.walker.masses)
        return {"gravity": gravity, **self.walker.springs}

    @cached_property
    def floating_mass_matrix(self) -> sp.Matrix:
        """Mass matrix with the stance foot free, shape (2 + n, 2 + n)."""
        return sp.hessian(self.floating_kinetic, list(self.floating_v)).applyfunc(simplified)

    @cached_property
    def floating_velocity_terms(self) -> sp.Matrix:
        """Coriolis and centrifugal forces while the stance foot is held, shape (2 + n, 1)."""
        momentum = sp.Matrix([self.floating_kinetic]).jacobian(self.floating_v).T
        terms = momentum.jacobian(self.floating_q) * self.floating_v
        terms -= sp.Matrix([self.floating_kinetic]).jacobian(self.floating_q).T
        return self.held(terms).applyfunc(simplified)

    def floating_gradient(self, potential: sp.Expr) -> sp.Matrix:
        """Gradient of a potential energy, shape (2 + n, 1)."""
        return sp.Matrix([potential]).jacobian(self.floating_q).T.applyfunc(simplified)

    def held(self, expr: sp.Matrix | sp.Expr) -> sp.Matrix | sp.Expr:
        """`expr` with the stance foot at rest in the origin."""
        return expr.subs(dict.fromkeys([*STANCE_FOOT, *self.floating_v[:BASE]], 0))

    @cached_property
    def mass_matrix(self) -> sp.Matrix:
        """Mass matrix of the swing phase, shape (n, n)."""
        return self.floating_mass_matrix[BASE:, BASE:]

    @cached_property
    def velocity_terms(self) -> sp.Matrix:
        """Coriolis and centrifugal forces of the swing phase, shape (n, 1)."""
        return self.floating_velocity_terms[BASE:, :]

    @cached_property
    def conservative_forces(self) -> dict[str, sp.Matrix]:
        """Gradient of each potential energy in the swing phase, shape (n, 1) each."""
        return {name: self.floating_gradient(v)[BASE:, :] for name, v in self.potentials.items()}

    def torque_vector(self, u: sp.Expr) -> sp.Matrix:
        """Generalised force of the controller's torque `u`, shape (n, 1)."""
        return sp.Matrix([u if c == self.walker.actuated else 0 for c in self.walker.coordinates])

    def ground_force(self, acceleration: sp.Matrix) -> sp.Matrix:
        """Force on the stance foot for given accelerations of the coordinates, shape (2, 1)."""
        inertia = self.floating_mass_matrix[:BASE, BASE:] * acceleration
        weight = self.floating_gradient(self.potentials["gravity"])[:BASE, :]
        return (inertia + self.floating_velocity_terms[:BASE, :] + weight).applyfunc(simplified)

    @cached_property
    def total_mass(self) -> sp.Expr:
        """Mass of the whole walker."""
        return sp.expand(sum(m.mass for m in self.walker.masses))

    @cached_property
    def centre_of_mass(self) -> sp.Matrix:
        """Centre of mass from the stance foot, shape (2, 1)."""
        total = sum((m.mass * m.position for m in self.walker.masses), sp.zeros(2, 1))
        return (self.held(total) / self.total_mass).applyfunc(simplified)

    @cached_property
    def swing_foot(self) -> sp.Matrix:
        """Swing foot from the stance foot, shape (2, 1)."""
        return self.held(self.walker.swing_foot).applyfunc(simplified)

    @cached_property
    def kinetic_energy(self) -> sp.Expr:
        """Kinetic energy of the swing phase."""
        return (self.walker.v.T * self.mass_matrix * self.walker.v)[0] / 2

    # The impact pins the swing foot and releases the stance foot. Velocities that keep the swing foot
    # at rest are `released * w` with any rates w; the impulse does no work on them, so the momentum
    # along them is kept: released^T Me released w+ = released^T Me v-.

    @cached_property
    def released(self) -> sp.Matrix:
        """Floating-base velocities with the swing foot at rest, per rate, shape (2 + n, n)."""
        n = len(self.walker.coordinates)
        return sp.Matrix.vstack(-self.swing_foot.jacobian(self.walker.q), sp.eye(n))

    @cached_property
    def impact_mass_matrix(self) -> sp.Matrix:
        """Mass matrix about the pinned swing foot, shape (n, n)."""
        return (self.released.T * self.floating_mass_matrix * self.released).applyfunc(simplified)

    @cached_property
    def impact_momentum(self) -> sp.Matrix:
        """Generalised momentum that the impact keeps, shape (n, 1)."""
        before = self.floating_mass_matrix[:, BASE:] * self.walker.v
        return (self.released.T * before).applyfunc(simplified)

    def impact_impulse(self, after: sp.Matrix) -> sp.Matrix:
        """Impulse on the swing foot for given rates after the impact (legs not swapped), shape (2, 1)."""
        change = self.released * after - sp.Matrix([0] * BASE + list(self.walker.v))
        return (self.floating_mass_matrix[:BASE, :] * change).applyfunc(simplified)

    @cached_property
    def swap(self) -> sp.Matrix:
        """Linear map of the rates when the legs swap names, shape (n, n)."""
        return self.relabelled_q.jacobian(self.walker.q)

    @cached_property
    def relabelled_q(self) -> sp.Matrix:
        """Coordinates after the legs swapped names, shape (n, 1)."""
        return sp.Matrix([self.walker.relabel[q] for q in self.walker.q])
