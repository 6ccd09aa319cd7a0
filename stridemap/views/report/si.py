"""How the page converts a model's units into metres, kilograms and seconds for a walker of a given size."""

import math
import re

from stridemap.columns import unit_of
from stridemap.errors import InputError
from stridemap.quantities import KINDS
from stridemap.spec import ModelSpec
from stridemap.units import Units
from stridemap.views.notation import printed

_SCALED = "sqrt(L/g)"


def si_powers(spec: ModelSpec) -> dict[str, list[int]]:
    """By printed unit, twice the powers of mass, length and gravity that one of it is in SI units.

    Pure numbers are left out; of a model that is not written in units of a mass, a length and gravity
    nothing is known.
    """
    return {unit: halves for unit, (halves, _) in _units(spec).items() if unit}


def si_names(spec: ModelSpec) -> dict[str, str]:
    """By printed unit, the name of the SI unit; the first of several kinds of quantities with one unit."""
    return {unit: name for unit, (_, name) in _units(spec).items()}


def _units(spec: ModelSpec) -> dict[str, tuple[list[int], str]]:
    """Powers and SI name by printed unit: of all kinds of quantities, then of parameters and coordinates."""
    if spec.units.time != _SCALED:
        return {}
    found: dict[str, tuple[list[int], str]] = {}
    for kind, (_, name) in KINDS.items():
        found.setdefault(printed(unit_of(kind, spec.units)), (_halves(kind), name))
    others = [p.unit for p in spec.parameters]
    others += [unit for c in spec.coordinates for unit in (c.unit, c.rate_unit)]
    own = {spec.units.mass: "M", spec.units.length: "L"}
    for unit in others:
        scaled = re.sub(r"[A-Za-z]+", lambda match: own.get(match[0], match[0]), unit)
        try:
            halves = _halves(scaled)
        except InputError:  # a unit of the model's own, such as a number of something
            continue
        found.setdefault(printed(unit), (halves, _name(halves, "rad" in unit)))
    return found


def _halves(unit: str) -> list[int]:
    """Powers of a unit in halves: each of mass, length and gravity is doubled once."""
    sizes = [(2.0, 1.0, 1.0), (1.0, 2.0, 1.0), (1.0, 1.0, 2.0)]
    return [round(2 * math.log2(Units(length, mass, gravity).unit(unit))) for mass, length, gravity in sizes]


def _name(halves: list[int], angle: bool) -> str:
    """A product of powers of kilogram, metre and second; gravity is a length over a time squared."""
    mass, length, gravity = halves
    powers = {"kg": mass, "m": length + gravity, "s": -2 * gravity}
    above = ["rad"] if angle else []
    above += [_power(unit, twice) for unit, twice in powers.items() if twice > 0]
    below = [_power(unit, -twice) for unit, twice in powers.items() if twice < 0]
    return "/".join([" ".join(above) or "1", *below]) if below else " ".join(above) or "1"


def _power(unit: str, twice: int) -> str:
    if twice == 2:
        return unit
    return f"{unit}^{twice // 2}" if twice % 2 == 0 else f"{unit}^({twice}/2)"
