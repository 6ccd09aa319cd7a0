"""What counts as one length, one time and one rate in a model, whatever its units: no tolerance has a unit.

The length is the distance of the centre of mass from the stance foot with all coordinates zero, the time the
square root of that length over gravity, both at the preset. A tolerance of 1e-6 means 1e-6 of these: a model
in millimetres and milliseconds is solved as the same model in metres and seconds.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.model.model import Model

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Scales:
    """The scales of a model.

    Parameters
    ----------
    length, time : float
    section : tuple of float
        One per entry of the section: 1 for angles, `length` for lengths, both over `time` for rates, and the
        half-width of the search box for what is neither.
    """

    length: float
    time: float
    section: tuple[float, ...]

    @classmethod
    def of(cls, model: Model) -> "Scales":
        """The scales of a model, computed once."""
        known = model.__dict__.get("_scales")
        if known is None:
            known = model.__dict__["_scales"] = cls._computed(model)
        return known

    @classmethod
    def _computed(cls, model: Model) -> "Scales":
        length, time = _length_and_time(model)
        units = {c.name: c.unit for c in model.spec.coordinates}
        of_unit = {"rad": 1.0, model.spec.units.length: length}
        section = []
        for name, half_width in zip(model.section, model.spec.scales, strict=True):
            rate = name not in units
            one = of_unit.get(units[name[1:] if rate else name])
            own = half_width if half_width > 0 else 1.0
            section.append(own if one is None else one / time if rate else one)
        return cls(length, time, tuple(section))

    @property
    def unknowns(self) -> Array:
        """Scales of the section point and the period, shape (nz + 1,)."""
        return np.array([*self.section, self.time])

    def residual(self, jacobian: Array) -> Array:
        """Scales of the residual's entries, shape (n, nz + 1).

        Those of the section's entries, and for the touchdown condition, which may be a length, an angle or
        anything else, its change within the scale of time.

        Parameters
        ----------
        jacobian : ndarray, shape (n, nz + 1, nz + 1)
            Derivative of the residual with respect to the unknowns.
        """
        scale = np.tile(self.unknowns, (len(jacobian), 1))
        with np.errstate(invalid="ignore"):
            pace = np.abs(jacobian[:, -1, -1]) * self.time
        scale[:, -1] = np.where(np.isfinite(pace) & (pace > 0), pace, 1.0)
        return scale


def _length_and_time(model: Model) -> tuple[float, float]:
    """The scales of length and time; where there is no gravity, from the range of periods."""
    rest, p = np.zeros(len(model.coordinates)), model.point({})
    com = model.evaluate("centre_of_mass", t=0.0, q=rest, v=rest, p=p)["com"]
    weights = model.evaluate("total_mass", p=p)
    length = float(np.hypot(*com))
    with np.errstate(all="ignore"):
        gravity = float(np.hypot(weights["weight"], weights["pull"]) / weights["mass"])
    usual = math.sqrt(model.period_range[0] * model.period_range[1])
    if not (math.isfinite(length) and length > 0):
        return 1.0, usual
    if not (math.isfinite(gravity) and gravity > 0):
        return length, usual
    return length, math.sqrt(length / gravity)
