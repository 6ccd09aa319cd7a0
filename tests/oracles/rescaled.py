"""A declaration in other units: the same walker, whose numbers are other ones.

Every expression of the old walker is written in terms of the new coordinates, rates and time, and its value
is brought to the new units. Parameters stay the numbers that they are.
"""

from dataclasses import dataclass, replace

import sympy as sp

from stridemap.derive.parts import STANCE_FOOT, TIME, Clock
from stridemap.quantities import KINDS
from stridemap.spec import UnitNames

DIMENSIONS = {
    # powers of mass, length and time
    "number": (0, 0, 0), "angle": (0, 0, 0), "mass": (1, 0, 0), "length": (0, 1, 0), "time": (0, 0, 1),
    "angular frequency": (0, 0, -1), "speed": (0, 1, -1), "acceleration": (0, 1, -2), "force": (1, 1, -2),
    "impulse": (1, 1, -1), "stiffness": (1, 0, -2), "damping": (1, 0, -1), "torque": (1, 2, -2),
    "rotational stiffness": (1, 2, -2), "rotational damping": (1, 2, -1), "moment of inertia": (1, 2, 0),
    "energy": (1, 2, -2), "power": (1, 2, -3),
}  # fmt: skip
"""Of each kind of quantity."""


@dataclass(frozen=True)
class Scale:
    """How many of the new units are one of the old ones.

    Parameters
    ----------
    mass, length, time : sympy.Rational
    """

    mass: sp.Rational
    length: sp.Rational
    time: sp.Rational

    def of(self, kind):
        """Factor from old numbers to new ones for a kind of quantity."""
        m, length, t = DIMENSIONS[kind]
        return self.mass**m * self.length**length * self.time**t


def kind_of(coordinate):
    """Whether a coordinate is an angle or a length."""
    return "angle" if coordinate.unit == "rad" else "length"


def factors(walker, scale):
    """Factor of every coordinate and rate, by symbol."""
    out = {}
    for c in walker.coordinates:
        out[c.symbol] = scale.of(kind_of(c))
        out[c.rate] = out[c.symbol] / scale.time
    return out


def rescaled(walker, name, scale):
    """`walker` in other units, under another name; units bear names of their own."""
    assert set(DIMENSIONS) >= set(KINDS)
    of = factors(walker, scale)
    known = {symbol: symbol / factor for symbol, factor in of.items()}
    known |= {x: x / scale.length for x in STANCE_FOOT}
    known[TIME] = TIME / scale.time

    def new(value, kind="number"):
        if isinstance(value, sp.MatrixBase):
            return value.applyfunc(lambda entry: new(entry, kind))
        return sp.sympify(value).subs(known, simultaneous=True) * scale.of(kind)

    def names(mapping):
        symbols = {str(s): f for s, f in of.items()}
        return {key: tuple(float(symbols[key] * x) for x in box) for key, box in mapping.items()}

    def substituted(mapping):
        return {key: new(value) * of[key] for key, value in mapping.items()}

    clock = walker.clock
    low, high = walker.period_range
    return replace(
        walker,
        name=name,
        bodies=tuple(
            replace(
                body,
                mass=new(body.mass, "mass"),
                position=new(body.position, "length"),
                inertia=new(body.inertia, "moment of inertia"),
                angle=new(body.angle),
            )
            for body in walker.bodies
        ),
        swing_foot=new(walker.swing_foot, "length"),
        touchdown=replace(
            walker.touchdown,
            condition=new(walker.touchdown.condition, "length"),
            region=new(walker.touchdown.region),
        ),
        relabel=substituted(walker.relabel),
        section=substituted(walker.section),
        gravity=new(walker.gravity, "acceleration"),
        potentials={key: new(value, "energy") for key, value in walker.potentials.items()},
        dissipation=new(walker.dissipation, "power"),
        torques={
            c: new(value, "torque" if kind_of(c) == "angle" else "force")
            for c, value in walker.torques.items()
        },
        clock=clock and Clock(new(clock.rate, "angular frequency"), clock.resets, clock.turn),
        stance=new(walker.stance, "length"),
        locks=tuple(new(lock) for lock in walker.locks),
        spring_mode=walker.spring_mode and new(walker.spring_mode, "angular frequency"),
        drawing=tuple(
            replace(line, points=tuple(new(point, "length") for point in line.points))
            for line in walker.drawing
        ),
        quantities=tuple(replace(one, expression=new(one.expression, one.kind)) for one in walker.quantities),
        search_box=names(walker.search_box),
        period_range=(float(low * scale.time), float(high * scale.time)),
        units=UnitNames("u_m", walker.units.length, "u_t", "u_e"),
    )
