"""What the tests of the solver share: reference orbits, and orbits over a set of points."""

import json
from functools import cache
from pathlib import Path

import numpy as np
from scipy.stats import qmc

from stridemap.solver.cycles.search import continued, find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.cycles.status import Status
from stridemap.solver.model.loading import load

REFERENCE = json.loads((Path(__file__).parent / "reference_orbits.json").read_text(encoding="utf-8"))
for _entry in REFERENCE:
    if _entry["model"] == "wobbling":
        _entry["params"]["c"] = 0.0  # they were computed for springs without a damper
TYPICAL = ({"k": 0.5}, {"k": 6.0}, {"k": 22.5})
"""The three typical solutions of the paper, at the preset's alpha = 0.25 and omega = 3."""
TWO_CYCLES = {"k": 6.0, "alpha": 0.25, "omega": 3.0}


LIFTING = {
    "k": 12.921495112008396, "alpha": 0.18465529025031124, "omega": 1.9989408378885059,
    "beta": 0.2023208441403671, "Kp": 17.218894431102633, "Kd": 0.29700535368512676,
    "S": 0.1819095385428478, "gamma": 0.17008990423493633, "c": 0.0,
}  # fmt: skip
"""A point with a cycle that needs a ground that pulls."""


def reference_name(entry):
    p = entry["params"]
    return "-".join([entry["model"], *(f"{p[n]:g}" for n in ("k", "alpha", "omega") if n in p)])


def section_point(entry):
    """Section point of an orbit or of an entry of the reference file."""
    state = entry["state"] if isinstance(entry, dict) else entry.state
    return np.array(list(state.values()))


def parameters(orbit):
    return orbit.model.point(orbit.params)


def _points():
    """The typical points, and quasi-random ones over the models' parameters."""
    unit = qmc.Sobol(4, rng=5).random(16)
    wobbling = [
        {"k": 0.2 * 300**a, "alpha": 0.05 + 0.85 * b, "omega": 2 + 1.5 * c, "beta": 0.1 + 0.1 * d}
        for a, b, c, d in unit
    ]
    compass = [
        {"omega": 2 + 1.5 * a, "S": 0.1 + 0.15 * b, "gamma": 0.1 + 0.15 * b} for a, b, _, _ in unit[:6]
    ]
    # Right after touchdown the power of the hip crosses zero three times between two nodes of a trace.
    trembling = [
        {"k": 0.7805, "alpha": 0.2948, "omega": 3.231},
        {"k": 2.3484, "alpha": 0.099, "omega": 3.9803},
    ]
    return [("wobbling", p) for p in (*TYPICAL, *wobbling, *trembling, LIFTING)] + [
        ("compass", p) for p in compass
    ]


POINTS = _points()


def point_name(point):
    model, params = point
    return "-".join([model, *(f"{name}={value:.3g}" for name, value in params.items())])


@cache
def orbits_at(index):
    """Every cycle at one of `POINTS`."""
    name, params = POINTS[index]
    model = load(name)
    return tuple(find_all(Solver.for_model(model), model.point(params)[None])[1])


GUESSES = {
    # Status: (k, alpha, omega), guess of section point and period; found by search, digits cut
    Status.CONVERGED: ((6, 0.25, 3), (0.0942, -0.1455, -0.0026, 0.0029, 0.152, 1.1837)),
    Status.NOT_CONVERGED: ((6, 0.25, 3), (0.05, -0.62, 0.6, 0.05, -0.76, 1.69)),
    Status.NOT_A_STEP: ((6, 0.25, 3), (-0.077183, 0.325498, 0.00387, 0.000193, 0.007035, 0.484398)),
    Status.LATER_TOUCHDOWN: ((1, 0.75, 3.9), (0.08265, -0.22725, -0.0031, 0.00041, -0.19312, 2.62522)),
    Status.OUT_OF_RANGE: ((40, 0.25, 3), (0.095144, -0.106336, -0.001919, -4.6e-05, -0.003157, 3.276972)),
}
"""Each leads to its status; to `Status.UNRESOLVED` lead motions that take seconds, and to `Status.INACCURATE`
those, and folds where there are no residuals of twice the digits."""

NEXT_TO_A_FOLD = (
    (5.9593496422, 0.25, 3),  # 4e-11 beside it: rounding alone moves the cycle by 1e-9
    (0.0957657707, -0.1363583647, -0.0024934711, 0.0036866904, 0.2085739841, 1.1710630482),
)
"""As `GUESSES`."""


def continue_one(point, guess, acceptance=None, backend=None):
    """Model, parameter vector and the orbit that Newton's method gives from a guess."""
    model = load("wobbling")
    params = model.point(dict(zip(("k", "alpha", "omega"), point, strict=True)))
    solver = Solver.for_model(model, backend, acceptance)
    (orbit,) = continued(solver, params[None], np.array([guess]))
    return model, params, orbit
