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
    touchdown, side : float
        Of the touchdown condition and of what is negative where a touchdown counts, which may be lengths,
        angles or anything else: the largest change that one coordinate makes by its own scale.
    """

    length: float
    time: float
    section: tuple[float, ...]
    touchdown: float
    side: float

    @classmethod
    def of(cls, model: Model) -> "Scales":
        """The scales of a model, computed once."""
        known: Scales | None = model.__dict__.get("_scales")
        if known is None:
            known = model.__dict__["_scales"] = cls._computed(model)
        return known

    @classmethod
    def _computed(cls, model: Model) -> "Scales":
        length, time = _length_and_time(model)
        of_unit = {"rad": 1.0, model.spec.units.length: length}
        boxes = dict(zip(model.section, model.spec.scales, strict=True))
        own = {c.name: of_unit.get(c.unit, boxes.get(c.name, 1.0) or 1.0) for c in model.spec.coordinates}
        section = tuple(own[name] if name in own else own[name[1:]] / time for name in model.section)
        touchdown, side = _of_touchdown(model, np.array([own[name] for name in model.coordinates]))
        return cls(length, time, section, touchdown, side)

    @property
    def unknowns(self) -> Array:
        """Scales of the section point and the period, shape (nz + 1,)."""
        return np.array([*self.section, self.time])

    @property
    def residual(self) -> Array:
        """Scales of the residual's entries, shape (nz + 1,)."""
        return np.array([*self.section, self.touchdown])


def rounded(scale: Array) -> Array:
    """The powers of two next to scales: what is divided by them keeps its digits."""
    exact: Array = np.exp2(np.round(np.log2(scale)))
    return exact


def _of_touchdown(model: Model, scale: Array) -> tuple[float, float]:
    """Scales of the touchdown condition and of the side, from states of the search box."""
    middle, half = np.array([model.spec.search_box[name] for name in model.section]).reshape(-1, 2).T
    z = np.concatenate([middle[None], middle + np.diag(half), middle - np.diag(half)])
    p = model.point({})
    q = model.evaluate("section_state", z=z, p=p)["q"]
    q = model.evaluate("before_touchdown", q=q, p=p)["q_minus"]
    rest = np.zeros_like(q)
    largest = [0.0, 0.0]
    for j, one in enumerate(scale.tolist()):
        step = np.zeros(len(scale))
        step[j] = 1e-4 * one
        ends = [model.evaluate("touchdown_condition", q=q + sign * step, v=rest, p=p) for sign in (1, -1)]
        for i, name in enumerate(("h", "side")):
            change = np.abs(ends[0][name] - ends[1][name]) / 2e-4
            largest[i] = max(largest[i], np.nanmax(np.where(np.isfinite(change), change, 0.0)).item())
    return largest[0] or 1.0, largest[1] or 1.0


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
