"""Rough solutions that are clearly not gaits, against the acceptance of what they converge to."""

import numpy as np
import pytest

from stridemap.solver.cycles import acceptance
from stridemap.solver.cycles.acceptance import DEEP, DOUBTFUL, clearly_no_gaits
from stridemap.solver.cycles.search import find_all, starts
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.cycles.status import FOUND, Status
from stridemap.solver.model.loading import load
from stridemap.solver.model.scales import Scales
from stridemap.solver.observables.events import Trace
from stridemap.solver.options import SearchOptions
from tests.oracles.kernels import needs_compiler

pytestmark = needs_compiler


@pytest.fixture(scope="module", params=["wobbling", "compass", "rimless_wheel"])
def solutions(request):
    """A solver, solutions of rough searches at many points, and their parameters."""
    model = load(request.param)
    solver, rng = Solver.for_model(model), np.random.default_rng(7)
    options = SearchOptions(starts=64).resolved_for(model)
    p = np.repeat(model.point({})[None] * rng.uniform(0.8, 1.25, (24, len(model.spec.names))), 64, axis=0)
    if "spokes" in model.spec.names:
        p[:, model.spec.names.index("spokes")] = model.point({})[model.spec.names.index("spokes")]
    u, closed = solver.search(np.tile(starts(model, options), (24, 1)), p)
    u, moved = solver.polished(u[closed], p[closed])
    return solver, u[moved < np.inf], p[closed][moved < np.inf]


def test_gaits_are_in_doubt_and_clear_cases_are_what_acceptance_says(solutions):
    solver, u, p = solutions
    codes = clearly_no_gaits(solver.kernels, 48, u, p)
    orbits = solver.converge(u, p, (1e-3, 1e3))
    # A gait may not be thrown away; that is what this is for.
    assert (codes[orbits.found] == DOUBTFUL).all()
    assert orbits.found.any()
    clear = (codes != DOUBTFUL) & (orbits.codes != Status.NOT_CONVERGED.code)
    assert not np.isin(orbits.codes[clear], FOUND).any()
    if solver.model.name == "wobbling":  # most of what is no gait is a clear case
        lost = ~orbits.found
        assert clear.sum() > 0.7 * lost.sum() > 0
        assert {Status.NOT_A_STEP.code, Status.LATER_TOUCHDOWN.code} <= set(codes.tolist())


def test_gaits_with_a_stiff_spring_are_in_doubt():
    """The mass oscillates ten times in a step, of which the look at it has 48 RK steps."""
    model = load("wobbling")
    solver = Solver.for_model(model)
    corners = [{"k": 60.0, "alpha": 0.05, "omega": omega} for omega in (2.0, 3.5)]
    points = np.array([model.point(corner) for corner in corners])
    _, orbits = find_all(solver, points, SearchOptions(starts=64, max_starts=64))
    assert orbits.period.max() > 2
    codes = clearly_no_gaits(solver.kernels, 48, orbits.u, orbits.params)
    assert (codes == DOUBTFUL).all()


def test_a_foot_that_just_passes_is_in_doubt(solutions, monkeypatch):
    """What counts as clear is set to a little more than how far the foot is below the ground."""
    solver, u, p = solutions
    if solver.model.name != "wobbling":
        pytest.skip("the foot of this walker does not come down early")
    early = np.flatnonzero(clearly_no_gaits(solver.kernels, 48, u, p) == Status.LATER_TOUCHDOWN.code)
    assert len(early) >= 10
    trace = Trace.of(solver.kernels, u[early], p[early], solver.kernels.trace(48, u[early], p[early]))
    depth = trace.observable("touchdown")[0][:, :-1].max(axis=1) / Scales.of(solver.model).touchdown
    assert (depth > DEEP).all()
    for row, deepest in zip(early[:, None], depth, strict=True):
        monkeypatch.setattr(acceptance, "DEEP", 1.01 * deepest)
        assert clearly_no_gaits(solver.kernels, 48, u[row], p[row]) != Status.LATER_TOUCHDOWN.code
