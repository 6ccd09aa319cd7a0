"""Values that the literature prints, each with how it is computed here; the page of them is checked by it."""

import math
from functools import cache

import stridemap

CASE_1 = {"hip_mass": 1000, "leg_mass": 1, "inertia": 0, "com_distance": 1, "radius": 0, "slope": 0.009}
COURSE = {"hip_mass": 0, "leg_mass": 1, "inertia": 0.05, "radius": 0, "slope": 0.02}


@cache
def gaits(model, **params):
    """All gaits at a point whose period is less than four, by rising period."""
    return [orbit for orbit in stridemap.find_orbits(model, params) if orbit.period < 4]


def state(which, entry, model, **params):
    """An entry of the section point of the short gait (0) or the long one (1)."""
    return lambda: gaits(model, **params)[which].state[entry]


def period(which, model, **params):
    return lambda: gaits(model, **params)[which].period


def doubling(model, low, high, scale=1.0, **params):
    """Slope at which the largest multiplier of the long gait passes -1."""

    def compute():
        found = stridemap.find(model, "spectral_radius = 1", "slope", range=(low, high), params=params)
        (value,) = [v for v, o in zip(found.values, found.orbits, strict=True) if o.multipliers[0].real < 0]
        return scale * value

    return compute


SIMPLEST = {"model": "simplest_walker", "slope": 0.009}

COMPUTED = {
    1: state(1, "theta", **SIMPLEST),
    2: state(1, "dtheta", **SIMPLEST),
    3: period(1, **SIMPLEST),
    4: state(0, "theta", **SIMPLEST),
    5: state(0, "dtheta", **SIMPLEST),
    6: period(0, **SIMPLEST),
    7: doubling("simplest_walker", 0.012, 0.017),
    8: state(0, "dtheta", "rimless_wheel", slope=0.2, spokes=6, lambda2=2 / 3),
    9: doubling("goswami_compass", math.radians(4.2), math.radians(4.6), math.degrees(1), mu=2, beta=1),
    10: state(1, "q1", "round_feet", **CASE_1),
    11: state(1, "dq1", "round_feet", **CASE_1),
    12: state(1, "dq2", "round_feet", **CASE_1),
    13: state(1, "q1", "round_feet"),
    14: state(1, "dq1", "round_feet"),
    15: state(1, "dq2", "round_feet"),
    16: state(1, "q1", "round_feet", **COURSE),
    17: state(1, "dq1", "round_feet", **COURSE),
}
"""By the number of the row on the page."""


def agreeing(printed, computed):
    """Largest number of significant digits to which both round to the same, at most those printed."""
    digits = len(printed.lstrip("-0.").replace(".", ""))
    same = [n for n in range(1, digits + 1) if f"{float(printed):.{n - 1}e}" == f"{computed:.{n - 1}e}"]
    return max(same, default=0)
