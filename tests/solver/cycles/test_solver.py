"""Limit cycles from guesses: how each failure is reported, and when a touchdown is the first."""

import math
from dataclasses import replace

import numpy as np
import pytest

from stridemap.solver.api.points import find_orbits
from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.cycles.acceptance import Candidates, depends_on_resolution
from stridemap.solver.cycles.search import continued
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.cycles.status import STATUSES, Status
from stridemap.solver.kernels.step_map import StepMap
from stridemap.solver.model.loading import load
from stridemap.solver.options import AcceptanceOptions
from stridemap.solver.walks.simulator import Outcome, swing, walk
from tests.oracles.reference import GUESSES, NEXT_TO_A_FOLD, continue_one, parameters, section_point


@pytest.mark.quick
def test_every_status_has_a_guess_that_leads_to_it():
    assert set(GUESSES) == set(Status) - {Status.UNRESOLVED, Status.INACCURATE}


@pytest.mark.quick
@pytest.mark.parametrize("status", GUESSES)
def test_guess_leads_to_its_status(status):
    _, params, orbit = continue_one(*GUESSES[status])
    assert orbit.status is status
    assert list(orbit.params.values()) == params.tolist()
    if status.found:
        assert orbit.residual < 1e-11
        assert (orbit.state_error < 1e-10) == (status is Status.CONVERGED)
    else:
        assert math.isnan(orbit.period)
        assert not orbit.stable
        assert orbit.state == {}


@pytest.mark.quick
def test_solution_with_a_negative_period_is_not_taken():
    solution = (-0.097164, -0.371414, -0.006991, -0.009462, 0.01325, -0.536338)
    model, params, orbit = continue_one((6, 0.25, 3), solution)
    closing = np.array(StepMap(model).residual(24)(solution, params))
    assert np.abs(closing).max() < 1e-5  # it closes, backwards in time
    assert orbit.status is Status.NOT_CONVERGED


@pytest.mark.quick
def test_simulator_confirms_that_the_touchdown_is_a_later_one():
    point, guess = GUESSES[Status.LATER_TOUCHDOWN]
    model = load("wobbling")
    params = model.point(dict(zip(("k", "alpha", "omega"), point, strict=True)))
    phase = swing(model, params, np.array(guess[:-1]))
    assert phase.outcome is Outcome.WALKED
    assert phase.duration < guess[-1] - 0.5


@pytest.mark.quick
@pytest.mark.parametrize(
    ("point", "guess", "status"),
    [
        # The feet meet at mid-stance with the stance leg a hair before the vertical: no touchdown.
        ((5.7, 0.89, 3.2), (0.10458, -0.01347, -0.00029, 0.00025, 0.12988, 2.97201), Status.CONVERGED),
        # And a hair beyond it, rocking back: the first touchdown.
        (
            (4.799112957962385, 0.782076682068945, 3.330902093314011),
            (0.105769, -0.027448, -0.000612, 0.000547, 0.133838, 2.862442),
            Status.LATER_TOUCHDOWN,
        ),
    ],
)
def test_side_of_the_vertical_is_judged_where_the_feet_meet(point, guess, status):
    model, params, orbit = continue_one(point, guess)
    phase = swing(model, params, np.array(guess[:-1]))
    assert (abs(phase.duration - guess[-1]) < 1e-2) == (status is Status.CONVERGED)
    assert orbit.status is status


@pytest.mark.quick
@pytest.mark.parametrize(("angle", "status"), [(1.5, Status.CONVERGED), (1.65, Status.NOT_A_STEP)])
def test_a_stance_leg_beyond_the_horizontal_is_not_a_step(angle, status):
    """A cycle whose stance leg is made to lean so far at one instant of it, on either side."""
    point, guess = GUESSES[Status.CONVERGED]
    model = load("wobbling")
    params = model.point(dict(zip(("k", "alpha", "omega"), point, strict=True)))[None]
    solver = Solver.for_model(model)
    found = Candidates.solve(solver.kernels, solver.acceptance, 48, np.array([guess]), params)
    for sign in (1, -1):
        w = found.trace.w.copy()
        w[0, 20, model.stance_index] = sign * angle
        leaning = replace(found, trace=replace(found.trace, w=w))
        assert STATUSES[leaning._verdict((0.3, 3.0))].tolist() == [status]


@pytest.mark.quick
def test_an_end_of_a_search_below_the_ground_is_not_a_step():
    """Just before touchdown the stance leg leans ahead by as much as it leans back after it."""
    solver = Solver.for_model(load("simplest_walker"))
    u = np.array([[angle, -0.2, 3.0] for angle in (0.2, 1.5, 1.65, -0.2)])
    possible = solver.can_be_a_step(u, np.repeat(solver.model.point({})[None], 4, axis=0))
    assert possible.tolist() == [True, True, False, False]


@pytest.mark.quick
@pytest.mark.filterwarnings("error")
def test_wild_guesses_neither_warn_nor_fail():
    model = load("wobbling")
    rng = np.random.default_rng(3)
    guesses = rng.uniform(-3, 3, (300, 6)) * 10.0 ** rng.integers(-2, 4, (300, 6))
    guesses[:4] = [[np.nan] * 6, [np.inf] * 6, [0.0] * 6, [1e300] * 6]
    orbits = continued(Solver.for_model(model), np.tile(model.point({}), (len(guesses), 1)), guesses)
    assert len(orbits) == len(guesses)
    assert set(orbits[:4].status) <= {Status.NOT_CONVERGED, Status.NOT_A_STEP}


@pytest.mark.parametrize("omega", [1.5, 2.0])
def test_stiff_spring_is_integrated_finely_enough(omega):
    """k = 60 at alpha = 0.05: a dozen oscillations of the spring in a step."""
    orbits = find_orbits("wobbling", {"k": 60.0, "alpha": 0.05, "omega": omega})
    assert (orbits.period > 2).any()
    for orbit in orbits:
        assert orbit.status is Status.CONVERGED
        assert orbit.integration_error < 1e-9
        z = section_point(orbit)
        (step,) = walk(load("wobbling"), parameters(orbit), z, 1).steps
        # The closing error of the simulator is no larger than the error that the orbit admits.
        assert np.abs(section_point(step) - z).max() < 2 * orbit.integration_error + 1e-10
        assert step.period == pytest.approx(orbit.period, abs=1e-9)


# -- what is accepted ------------------------------------------------------------------------------------


@pytest.mark.quick
def test_acceptance_decides_what_is_accurate():
    """The cycle whose state error stays above 1e-10 is accurate where more is allowed."""
    one = Interpreter()  # it has doubles only, which round too much there
    strict = continue_one(*NEXT_TO_A_FOLD, backend=one)[2]
    assert strict.status is Status.INACCURATE
    assert strict.state_error > 1e-10
    assert strict.integration_error < 1e-11
    loose = AcceptanceOptions(max_state_error=2 * strict.state_error)
    assert continue_one(*NEXT_TO_A_FOLD, loose, one)[2].status is Status.CONVERGED


@pytest.mark.quick
def test_a_coarser_target_is_reached_with_fewer_rk_steps():
    point, guess = GUESSES[Status.CONVERGED]
    fine = continue_one(point, guess)[2]
    coarse = continue_one(point, guess, AcceptanceOptions(target_integration_error=1e-9))[2]
    assert coarse.status is fine.status is Status.CONVERGED
    assert coarse.period == pytest.approx(fine.period, abs=1e-8)
    tight = AcceptanceOptions(max_residual=1e-20)
    assert continue_one(point, guess, tight)[2].status is Status.NOT_CONVERGED


def nearly_standing(k=52.0):
    """What a search ends at that is far from the solution: the gait takes 14 mm a step, and may be changed
    along one direction with hardly a residual."""
    model = load("wobbling")
    point = model.point({"k": k, "alpha": 0.05, "omega": 2.0})[None]
    return model, np.array([[0.0156, -0.224, -0.0001, -0.1016, -3.925, 2.279]]), point


@pytest.mark.quick
def test_a_long_way_from_where_a_search_ends_to_the_solution_is_gone():
    model, guess, point = nearly_standing()
    solver = Solver.for_model(model)
    u, closed = solver.search(guess, point)
    assert closed.all()
    polished, moved = solver.polished(u, point)
    assert 1 < moved[0] < np.inf
    orbit = solver.converge(polished, point, (0.3, 3.0))[0]
    assert orbit.status is Status.CONVERGED
    np.testing.assert_allclose([*orbit.state.values(), orbit.period], polished[0], atol=2e-3)
    step = swing(model, point[0], np.array([*orbit.state.values()]))
    assert step.duration == pytest.approx(orbit.period, abs=1e-7)


@pytest.mark.quick
def test_a_tangent_leads_to_the_solutions_at_other_parameters():
    """Half the way, a quarter of the error: it is the tangent. Where it leads far the solution stays."""
    solver = Solver.for_model(load("wobbling"))
    p = solver.model.point({"k": 22.5})
    u, _ = solver.polished(find_orbits("wobbling", k=22.5).u[:1], p[None])
    errors = []
    for way in (0.004, 0.002):
        target = solver.model.point({"k": 22.5 * (1 + way), "alpha": 0.25 * (1 - way)})
        there, _ = solver.polished(u, target[None])
        errors.append(np.abs(solver.predicted(u, p[None], target[None]) - there).max())
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.1)
    far = solver.model.point({"k": 600.0})
    np.testing.assert_array_equal(solver.predicted(u, p[None], far[None]), u)
    # Many targets at a time, on either side of a solution, or the solution's own parameters.
    targets = np.array([solver.model.point({"k": k}) for k in (22.4, 22.5, 22.6, 600.0, 22.4)])
    alone = np.concatenate([solver.predicted(u, p[None], target[None]) for target in targets])
    many = [np.tile(one, (len(targets), 1)) for one in (u, p[None])]
    np.testing.assert_allclose(solver.predicted(*many, targets), alone, rtol=0, atol=1e-14)
    np.testing.assert_array_equal(alone[1], u[0])
    np.testing.assert_allclose(alone[0] + alone[2], 2 * u[0], rtol=0, atol=1e-9)


@pytest.mark.quick
def test_what_rounding_makes_is_left_to_no_finer_resolution():
    """The derivative is 3e4 there: a residual of 1e-11 is the rounding of the solution itself."""
    model = load("wobbling")
    point = model.point({"k": 24.71177944862155, "alpha": 0.5, "omega": 3.0})[None]
    guess = [
        0.0159765248532,
        -4.96452138113,
        -0.00253416604954,
        0.0036956070411,
        -10.7630135659,
        2.68295912432,
    ]
    kernels, options = Solver.for_model(model).kernels, AcceptanceOptions(max_residual=1e-14)
    solution = Candidates.solve(kernels, options, 768, np.array([guess]), point)
    assert not solution.closed.any()
    assert 1e-14 < solution.residual[0] < solution.noise()[0] < 1e-10
    assert depends_on_resolution(kernels, 768, solution.u, point).all()
    assert not solution.unresolved().any()
    closed = Candidates.solve(kernels, AcceptanceOptions(max_residual=1e-9), 768, np.array([guess]), point)
    assert closed.integration_error[0] > closed.options.target_integration_error / 10
    assert closed.excess()[0] < 1
