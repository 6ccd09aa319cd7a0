"""Planar bipeds of two to seven links: a table of links, and the declaration of a walker made of them.

The same table is read by the derivation, through `walker`, and by whatever else computes the same mechanics.
"""

from dataclasses import dataclass

import sympy as sp

from stridemap.derive import (
    SI,
    STANCE_FOOT,
    Body,
    Coordinate,
    Line,
    Parameter,
    Touchdown,
    Walker,
)

GRAVITY = 9.81

COORDINATES = ("absolute", "relative")
"""Angles of the links from the vertical, or of each link from the one that carries it."""


@dataclass(frozen=True)
class Link:
    """One rigid link, which hangs on a joint at one of its ends.

    Parameters
    ----------
    name : str
    carrier : int
        Index of the link at whose far end the joint is; -1 for the stance foot.
    up : bool
        Whether the link points up from its joint when its angle is zero; else down.
    part : str
        What it is a part of; links of the same part have the same parameters.
    mirror : int
        Index of the link that has its place after a touchdown.
    """

    name: str
    carrier: int
    up: bool
    part: str
    mirror: int


PARTS = {
    "leg": {"m": 10.0, "i": 0.8, "l": 0.8, "c": 0.3},
    "shank": {"m": 3.2, "i": 0.05, "l": 0.4, "c": 0.13},
    "thigh": {"m": 6.8, "i": 0.11, "l": 0.4, "c": 0.16},
    "foot": {"m": 1.0, "i": 0.005, "l": 0.2, "c": 0.1},
    "torso": {"m": 20.0, "i": 2.2, "l": 0.6, "c": 0.2},
    "head": {"m": 5.0, "i": 0.03, "l": 0.25, "c": 0.12},
    "arm": {"m": 3.5, "i": 0.13, "l": 0.6, "c": 0.27},
}
"""Mass, moment of inertia about the centre of mass, length, and distance of that centre from the joint
(of the parts of a leg: from the end that is nearer to the hip), in SI units."""

LEGS = {"leg", "thigh", "shank", "foot"}
"""Parts of a leg."""

_MEANINGS = {"m": "mass", "i": "moment of inertia", "l": "length", "c": "place of the centre of mass"}
_UNITS = {"m": "kg", "i": "kg m^2", "l": "m", "c": "m"}


def links(count: int, feet: bool = False) -> tuple[Link, ...]:
    """The links of a biped: two legs; with knees from four on; then a torso, a head or two arms.

    Parameters
    ----------
    count : int
        2 to 7.
    feet : bool
        Whether a biped of seven links has feet, on whose toes it stands, in place of arms.
    """
    if feet:
        if count != 7:
            raise ValueError(f"a biped of {count} links has no feet here: 7")
        return (
            Link("stance foot", -1, True, "foot", 5),
            Link("stance shank", 0, True, "shank", 4),
            Link("stance thigh", 1, True, "thigh", 3),
            Link("swing thigh", 2, False, "thigh", 2),
            Link("swing shank", 3, False, "shank", 1),
            Link("swing foot", 4, False, "foot", 0),
            Link("torso", 2, True, "torso", 6),
        )
    if count < 4:
        found = [Link("stance leg", -1, True, "leg", 1), Link("swing leg", 0, False, "leg", 0)]
        hip = 0
    else:
        found = [
            Link("stance shank", -1, True, "shank", 3),
            Link("stance thigh", 0, True, "thigh", 2),
            Link("swing thigh", 1, False, "thigh", 1),
            Link("swing shank", 2, False, "shank", 0),
        ]
        hip = 1
    torso = len(found)
    if count in (3, 5, 6, 7):
        found.append(Link("torso", hip, True, "torso", torso))
    if count == 6:
        found.append(Link("head", torso, True, "head", torso + 1))
    if count == 7:
        found.append(Link("left arm", torso, False, "arm", torso + 2))
        found.append(Link("right arm", torso, False, "arm", torso + 1))
    if len(found) != count:
        raise ValueError(f"there is no biped of {count} links here: 2 to 7")
    return tuple(found)


def from_joint(link: Link, length: float, centre: float) -> float:
    """Distance of the centre of mass from the link's joint; a stance leg's joint is at its lower end."""
    return length - centre if link.name.startswith("stance") else centre


def carried(chain: tuple[Link, ...]) -> list[list[int]]:
    """For each link those whose relative angles add up to its own: its carriers and itself."""
    paths: list[list[int]] = []
    for i, link in enumerate(chain):
        paths.append([*(paths[link.carrier] if link.carrier >= 0 else []), i])
    return paths


def walker(count: int, coordinates: str = "absolute", feet: bool = False) -> Walker:
    """A passive biped as a declaration.

    Parameters
    ----------
    count : int
        Number of links, 2 to 7.
    coordinates : {"absolute", "relative"}
    feet : bool
        Whether a biped of seven links has feet instead of arms.
    """
    chain = links(count, feet)
    declared = tuple(
        Coordinate(f"q{i}", "rad", f"angle of the {link.name}") for i, link in enumerate(chain, 1)
    )
    q = sp.Matrix([c.symbol for c in declared])
    sums = sp.eye(count)
    if coordinates == "relative":
        sums = sp.Matrix(count, count, lambda i, j: int(j in carried(chain)[i]))
    angles = sums * q
    swap = sums.inv() * sp.Matrix(count, count, lambda i, j: int(chain[i].mirror == j)) * sums
    parts = dict.fromkeys(link.part for link in chain)
    parameters = [Parameter("g", GRAVITY, "m/s^2", "gravity", 0.0, lower_open=True)]
    parameters += [
        Parameter(f"{k}_{part}", PARTS[part][k], _UNITS[k], f"{_MEANINGS[k]}, {part}", 0.0, lower_open=True)
        for part in parts
        for k in "milc"
        if k != "l" or part in _carrying(chain)
    ]
    symbols = {p.name: p.symbol for p in parameters}
    bodies, ends = [], []
    for link, angle in zip(chain, angles, strict=True):
        mass, inertia, centre = (symbols[f"{k}_{link.part}"] for k in "mic")
        length = symbols.get(f"l_{link.part}", sp.S.Zero)
        away = sp.Matrix([-sp.sin(angle), sp.cos(angle)]) * (1 if link.up else -1)
        joint = ends[link.carrier] if link.carrier >= 0 else STANCE_FOOT
        ends.append(joint + length * away)
        place = joint + from_joint(link, length, centre) * away
        bodies.append(Body(link.name, mass, place, inertia=inertia, angle=angle))
    leg_ends = [e for e, link in zip(ends, chain, strict=True) if link.part in LEGS]
    foot = leg_ends[-1]
    box = {c.name: (0.0, 0.3) for c in declared} | {f"d{c.name}": (0.0, 1.0) for c in declared}
    return Walker(
        name=f"links_{count}",
        title=f"Planar biped of {count} links",
        reference="made up for measuring",
        units=SI,
        coordinates=declared,
        parameters=tuple(parameters),
        bodies=tuple(bodies),
        gravity=sp.Matrix([0, -symbols["g"]]),
        swing_foot=foot,
        touchdown=Touchdown(foot[1] - STANCE_FOOT[1], region=STANCE_FOOT[0] - foot[0], rising=False),
        relabel=dict(zip(q, swap * q, strict=True)),
        stance_angle=declared[0],
        drawing=(Line("legs", (STANCE_FOOT, *leg_ends)),),
        search_box=box,
        period_range=(0.2, 1.5),
    )


def _carrying(chain: tuple[Link, ...]) -> set[str]:
    """Parts whose length matters: those that carry another link, and those of legs."""
    return {chain[link.carrier].part for link in chain if link.carrier >= 0} | LEGS
