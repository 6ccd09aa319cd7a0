"""The built-in walkers as SymPy's own mechanics sees them: frames, particles, rigid bodies and forces.

Nothing here comes from `derive`. What is built is handed to `LagrangesMethod` and `KanesMethod`.
"""

from dataclasses import dataclass, field
from functools import cache

import sympy as sp
from sympy.physics import mechanics as me

slope, foot_mass, u = sp.symbols("slope foot_mass u")


@dataclass
class Assembly:
    """What SymPy's methods need of a walker."""

    coordinates: list
    world: me.ReferenceFrame = field(default_factory=lambda: me.ReferenceFrame("N"))
    ground: me.Point = field(default_factory=lambda: me.Point("stance foot"))
    bodies: list = field(default_factory=list)
    forces: list = field(default_factory=list)

    def __post_init__(self):
        self.ground.set_vel(self.world, 0)

    def leg(self, name, angle, about=1):
        """A frame whose y-axis points up along a leg, which leans back by `angle`."""
        return self.world.orientnew(name, "Axis", (about * angle, self.world.z))

    def add(self, name, origin, offset, mass, downhill):
        """A point mass that hangs on `origin`, and its weight, which pulls along the ground on a slope."""
        point = origin.locatenew(name, offset)
        point.set_vel(self.world, point.pos_from(self.ground).dt(self.world))
        self.bodies.append(me.Particle(name, point, mass))
        self.forces.append((point, mass * self.gravity(downhill)))
        return point

    def gravity(self, downhill):
        return sp.sin(downhill) * self.world.x - sp.cos(downhill) * self.world.y


def two_legs(hip_mass, masses, downhill=sp.S.Zero):
    """Hip, stance leg and swing leg, with `masses` at these shares of a leg's length above its foot."""
    theta1, theta2 = me.dynamicsymbols("theta1 theta2")
    a = Assembly([theta1, theta2])
    stance, swing = a.leg("stance leg", theta1), a.leg("swing leg", theta1 - theta2)
    hip = a.add("hip", a.ground, stance.y, hip_mass, downhill)
    for i, (share, mass) in enumerate(masses):
        a.add(f"stance mass {i}", a.ground, share * stance.y, mass, downhill)
        a.add(f"swing mass {i}", hip, (share - 1) * swing.y, mass, downhill)
    # The hip's motor turns the swing leg one way and the stance leg the other.
    a.forces += [(swing, -u * a.world.z), (stance, u * a.world.z)]
    return a, hip


def compass():
    beta = sp.Symbol("beta")
    return two_legs(sp.Integer(1), [(0, beta)])[0]


def wobbling():
    x = me.dynamicsymbols("x")
    k, alpha, beta, c = sp.symbols("k alpha beta c")
    a, hip = two_legs(1 - alpha, [(0, beta)])
    a.coordinates.append(x)
    wobbler = a.add("wobbler", hip, x * a.world.x, alpha, sp.S.Zero)
    pull = (k * x + c * x.diff(me.dynamicsymbols._t)) * a.world.x
    a.forces += [(wobbler, -pull), (hip, pull)]
    return a


def goswami_compass():
    mu, beta = sp.symbols("mu beta")
    return two_legs(mu, [(1 / (1 + beta), sp.Integer(1))], slope)[0]


def simplest_walker():
    """With a foot mass that is small but not zero."""
    return two_legs(sp.Integer(1), [(0, foot_mass)], slope)[0]


def rimless_wheel():
    """Hub and spokes as one rigid body; its angle leans ahead."""
    theta, lambda2 = me.dynamicsymbols("theta"), sp.Symbol("lambda2")
    a = Assembly([theta])
    spoke = a.leg("spoke", theta, about=-1)
    hub = a.ground.locatenew("hub", spoke.y)
    hub.set_vel(a.world, hub.pos_from(a.ground).dt(a.world))
    inertia = me.inertia(spoke, 0, 0, 1 / lambda2 - 1)
    a.bodies.append(me.RigidBody("wheel", hub, spoke, sp.Integer(1), (inertia, hub)))
    a.forces.append((hub, a.gravity(slope)))
    return a


ASSEMBLIES = {
    f.__name__: cache(f) for f in (compass, wobbling, goswami_compass, simplest_walker, rimless_wheel)
}


def lagrange(name):
    """Mass matrix and forces of ``M a = f`` by Lagrange's equations; gravity and spring are forces."""
    a = ASSEMBLIES[name]()
    lagrangian = me.Lagrangian(a.world, *a.bodies)
    method = me.LagrangesMethod(lagrangian, a.coordinates, forcelist=a.forces, frame=a.world)
    method.form_lagranges_equations()
    return method.mass_matrix, method.forcing


def kane(name):
    """The same by Kane's equations: no energy is written down."""
    a = ASSEMBLIES[name]()
    rates = [me.dynamicsymbols(f"w{i}") for i in range(len(a.coordinates))]
    defined = [w - q.diff() for w, q in zip(rates, a.coordinates, strict=True)]
    method = me.KanesMethod(a.world, a.coordinates, rates, defined)
    method.kanes_equations(a.bodies, a.forces)
    back = dict(zip(rates, [q.diff() for q in a.coordinates], strict=True))
    return method.mass_matrix.xreplace(back), method.forcing.xreplace(back)


def equations(method, name, coordinates, parameters):
    """Function of coordinates, rates, parameters and the hip's torque that gives M and f.

    Parameters
    ----------
    method : callable
        `lagrange` or `kane`.
    name : str
    coordinates, parameters : sequence of str
        The model's names, in order.
    """
    matrices = method(name)
    dofs, speeds = [sp.Symbol(c) for c in coordinates], [sp.Symbol("d" + c) for c in coordinates]
    moving = ASSEMBLIES[name]().coordinates
    plain = dict(zip([c.diff() for c in moving], speeds, strict=True))
    plain |= dict(zip(moving, dofs, strict=True))
    expressions = [e.xreplace(plain) for e in matrices]
    return sp.lambdify([*dofs, *speeds, *map(sp.Symbol, parameters), u], expressions, cse=True)
