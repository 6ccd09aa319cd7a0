"""How the page converts a model's units into metres, kilograms and seconds for a walker of a given size."""

import math

from stridemap.quantities import KINDS
from stridemap.spec import ModelSpec
from stridemap.units import Units
from stridemap.views.notation import printed, unit_of

_SCALED = "sqrt(L/g)"


def si_powers(spec: ModelSpec) -> dict[str, list[int]]:
    """By printed unit, twice the powers of mass, length and gravity that one of it is in SI units.

    Pure numbers are left out; of a model that is not written in units of a mass, a length and gravity
    nothing is known.
    """
    if spec.units.time != _SCALED:
        return {}
    kinds = {printed(unit_of(kind, spec.units)): kind for kind in KINDS}
    return {unit: _halves(kind) for unit, kind in kinds.items() if unit}


def si_names(spec: ModelSpec) -> dict[str, str]:
    """By printed unit, the name of the SI unit; the first of several kinds of quantities with one unit."""
    names: dict[str, str] = {}
    for kind, (_, si) in KINDS.items():
        names.setdefault(printed(unit_of(kind, spec.units)), si)
    return names if spec.units.time == _SCALED else {}


def _halves(kind: str) -> list[int]:
    """Powers of a kind's unit in halves: each of mass, length and gravity is doubled once."""
    sizes = [(2.0, 1.0, 1.0), (1.0, 2.0, 1.0), (1.0, 1.0, 2.0)]
    return [round(2 * math.log2(Units(length, mass, gravity).unit(kind))) for mass, length, gravity in sizes]
