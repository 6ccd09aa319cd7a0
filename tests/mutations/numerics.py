"""Changes of what is computed at one point: kernels, multipliers, errors, acceptance, walks, units."""

from tests.mutations.mutation import Mutation

LANES = "tests/solver/backends/test_lanes.py"
LOCKSTEP = "tests/solver/backends/test_lockstep.py"
RESOLUTION = "tests/solver/kernels/test_resolution.py"
JETS = "tests/solver/backends/test_jets.py"
ERRORS = "tests/solver/cycles/test_errors.py"
SOLVER = "tests/solver/cycles/test_solver.py"
STATUS = f"{SOLVER}::test_guess_leads_to_its_status"
OUTCOMES = "tests/solver/walks/test_outcomes.py"
ALONG = "tests/solver/kernels/test_step_map.py::test_derivative_in_the_parameters_is_that_of_the_residual"

KERNELS = (
    Mutation(
        "solver/kernels/step_map.py",
        "derivative[: self.nz, : self.nz] -= ca.DM.eye(self.nz)",
        "derivative[: self.nz, : self.nz] -= 0 * ca.DM.eye(self.nz)",
        "Newton's method has the derivative of the step map for that of the closing error",
        ("tests/solver/kernels/test_step_map.py::test_jacobian_agrees_with_complex_steps",),
    ),
    Mutation(
        "solver/kernels/step_map.py",
        "rate[:, -1] + given)",
        "rate[:, -1])",
        "the derivative in the parameters is that of the impact alone",
        (ALONG,),
    ),
    Mutation(
        "solver/kernels/step_map.py",
        "ca.horzcat(y, derivative, ca.jtimes(y, p, d))",
        "ca.horzcat(y, derivative, 0 * ca.jtimes(y, p, d))",
        "the state just after touchdown does not depend on the parameters",
        (ALONG,),
    ),
    Mutation(
        "solver/kernels/step_map.py",
        "(one, t + node * h) for one",
        "(one, t) for one",
        "the phase of a clock moves as at the beginning of each RK step",
        (ALONG,),
    ),
    Mutation(
        "solver/kernels/phase.py",
        "ca.vertcat(-phase[1], phase[0])",
        "ca.vertcat(phase[1], phase[0])",
        "the phase of a clock moves the wrong way with its frequency",
        (ALONG,),
    ),
    Mutation(
        "solver/kernels/phase.py",
        "one[0] * other[0] - one[1] * other[1], one",
        "one[0] * other[0] + one[1] * other[1], one",
        "the clock's phase is turned the wrong way within a step",
        ("tests/solver/kernels/test_step_map.py::test_residual_agrees_with_the_event_driven_simulator",),
    ),
    Mutation(
        "solver/kernels/resolution.py",
        "SEARCH_PHASE, BRANCH_PHASE, CYCLE_PHASE = 1.5, 0.75, 0.45",
        "SEARCH_PHASE, BRANCH_PHASE, CYCLE_PHASE = 1.5, 0.75, 45.0",
        "every cycle is first computed with the fewest steps",
        ("tests/solver/kernels/test_resolution.py",),
    ),
    Mutation(
        "solver/kernels/resolution.py",
        "SEARCH_PHASE, BRANCH_PHASE, CYCLE_PHASE = 1.5, 0.75, 0.45",
        "SEARCH_PHASE, BRANCH_PHASE, CYCLE_PHASE = 150.0, 0.75, 0.45",
        "a search takes the fewest steps whatever the spring",
        ("tests/solver/kernels/test_resolution.py",),
    ),
    Mutation(
        "solver/backends/base.py",
        "return matrices.transpose(0, 2, 1)",
        "return matrices",
        "rows and columns of derivatives change places",
        ("tests/solver/backends/test_base.py::test_results_are_named_and_matrices_are_row_by_row",),
    ),
    Mutation(
        "solver/backends/lanes.py",
        "near = np.flatnonzero((size > SEARCH_RESIDUAL) & (size < NEARLY))",
        "near = np.flatnonzero(size < 0)",
        "a search that single precision leaves open is not finished",
        (f"{LANES}::test_a_search_in_single_precision_is_finished_in_double_precision_where_it_came_near",),
    ),
    Mutation(
        "solver/backends/lanes.py",
        "iterations=steps or method.iterations",
        "iterations=method.iterations",
        "a search does not keep to its number of steps",
        (f"{LANES}::test_a_search_takes_no_more_steps_than_it_may",),
    ),
    Mutation(
        "solver/kernels/resolution.py",
        "> KEPT:",
        "> 10**9:",
        "what is kept of fastest modes grows without a bound",
        (f"{RESOLUTION}::test_fastest_modes_are_kept_up_to_a_bound",),
    ),
    Mutation(
        "solver/backends/lockstep.h",
        "point[lane] = points ? points[row] : row;",
        "point[lane] = row;",
        "points with resolutions of their own get those of others",
        (
            "tests/solver/backends/test_lanes.py::"
            "test_points_at_resolutions_of_their_own_are_as_they_are_alone[lanes]",
        ),
    ),
    Mutation(
        "solver/backends/lockstep.h",
        "int done = !(norm(r, rows, nu) > abstol);",
        "int done = norm(r, rows, nu) <= abstol;",
        "a residual that is no number does not end the lockstep Newton",
        (LOCKSTEP,),
    ),
    Mutation(
        "solver/backends/lockstep.h",
        "done = !(norm(r, unknowns, nu) > abstol_step) ||",
        "done = norm(r, unknowns, nu) <= abstol_step ||",
        "a step that is no number does not end the lockstep Newton",
        (LOCKSTEP,),
    ),
    Mutation(
        "solver/backends/lockstep.h",
        "        if (size != size) break;\n",
        "",
        "an entry that is no number is hidden by one after it",
        (LOCKSTEP,),
    ),
    Mutation(
        "solver/backends/lockstep.h",
        "fabs(a[r + c * n]) > fabs(a[pivot + c * n])",
        "fabs(a[r + c * n]) < fabs(a[pivot + c * n])",
        "elimination takes the smallest pivots",
        (LOCKSTEP,),
    ),
    Mutation(
        "solver/backends/lockstep.h",
        "const double size = fabs(x[k] / scale[k]);",
        "const double size = fabs(x[k]);",
        "tolerances have the model's units",
        (LOCKSTEP,),
    ),
    Mutation(
        "solver/backends/jets.h",
        "(u.ab * v.x + u.x * v.ab) + (u.a * v.b + u.b * v.a));",
        "(u.ab * v.x + u.x * v.ab) + (u.a * v.b - u.b * v.a));",
        "second derivatives of products are wrong",
        (JETS,),
    ),
    Mutation(
        "solver/backends/jets.h",
        "return composed(u, root, first, -0.5 * first / u.x);",
        "return composed(u, root, first, 0.5 * first / u.x);",
        "second derivatives of roots have the wrong sign",
        (JETS,),
    ),
    Mutation(
        "solver/backends/jets.h",
        "return composed(u, t, first, -2.0 * t * first);",
        "return composed(u, t, first, 2.0 * t * first);",
        "second derivatives of tanh, as in dry friction, have the wrong sign",
        (JETS,),
    ),
    Mutation(
        "solver/backends/jets.h",
        "return composed(u, acos(u.x), -first, -u.x * first * first * first);",
        "return composed(u, acos(u.x), -first, u.x * first * first * first);",
        "second derivatives of acos have the wrong sign",
        (JETS,),
    ),
    Mutation(
        "solver/backends/directional.h",
        "put(b + at * width, width, point, &Jet::b, lane);",
        "put(a + at * width, width, point, &Jet::b, lane);",
        "derivatives in two directions are in one",
        ("tests/solver/backends/test_directional.py::test_against_an_imaginary_step[simplest_walker]",),
    ),
)

CYCLES = (
    Mutation(
        "solver/cycles/floquet.py",
        "p_z - p_t @ h_z / h_t",
        "p_z + p_t @ h_z / h_t",
        "multipliers take the period's change the wrong way",
        ("tests/solver/cycles/test_floquet.py::test_period_follows_the_section_point",),
    ),
    Mutation(
        "solver/cycles/errors.py",
        "change = -(inverse @ residual[:, :, None])[:, :, 0]",
        "change = (inverse @ residual[:, :, None])[:, :, 0]",
        "the correction of a cycle has the wrong sign",
        (f"{ERRORS}::test_a_correction_is_the_newton_step",),
    ),
    Mutation(
        "solver/cycles/errors.py",
        "level = ROUNDING * math.sqrt(n_rk / COARSE) * np.maximum(np.abs(u), scale)",
        "level = 1e3 * ROUNDING * math.sqrt(n_rk / COARSE) * np.maximum(np.abs(u), scale)",
        "rounding is taken for a thousand times what it is",
        (f"{ERRORS}::test_a_correction_is_the_newton_step",),
    ),
    Mutation(
        "solver/cycles/errors.py",
        "first_order = level * norm[:, None] * condition",
        "first_order = level * norm[:, None]",
        "the error of badly conditioned multipliers leaves out their condition",
        (f"{ERRORS}::test_a_badly_conditioned_multiplier_is_off_by_its_condition",),
    ),
    Mutation(
        "solver/cycles/sobol.py",
        "for k in range(1, degree):",
        "for k in range(2, degree):",
        "direction numbers leave out a term of their recurrence",
        ("tests/solver/cycles/test_sobol.py::test_points_are_those_of_scipy",),
    ),
    Mutation(
        "solver/cycles/degenerate.py",
        "np.abs(after - before - shift) > SAME",
        "np.abs(after - before) > SAME",
        "a coordinate that an impact leaves where it is counts as held",
        ("tests/solver/cycles/test_degenerate.py::test_what_vanishes_at_an_end_of_a_range_is_named",),
    ),
    Mutation(
        "solver/cycles/errors.py",
        "if not (own <= distance.min(axis=1)).all():",
        "if not (own <= distance.max(axis=1)).all():",
        "multipliers are taken for matched that are not",
        (f"{ERRORS}::test_sets_of_eigenvalues_are_matched_at_the_least_cost",),
    ),
    Mutation(
        "solver/cycles/errors.py",
        "apart[i] = min(apart[i], own.max())",
        "apart[i] = apart[i]",
        "multipliers of equal modulus that change places count as errors",
        (f"{ERRORS}::test_eigenvalues_are_matched_whatever_their_order",),
    ),
    Mutation(
        "solver/cycles/error_bars.py",
        "refined, residual = kernels.jacobian(finer(n_rk), moved, params)",
        "refined, residual = kernels.jacobian(n_rk, moved, params)",
        "errors are estimated without a finer resolution",
        (f"{ERRORS}::test_errors_are_true_within_a_factor_of_three",),
    ),
    Mutation(
        "solver/cycles/acceptance.py",
        "early = earlier_touchdown(trace, side)",
        "early = earlier_touchdown(trace, side) & False",
        "a cycle whose foot is down before the end of the step is accepted",
        (STATUS,),
    ),
    Mutation(
        "solver/cycles/acceptance.py",
        "step &= np.abs(stance).max(axis=1, initial=0.0) < np.pi / 2",
        "step &= np.abs(stance).max(axis=1, initial=0.0) < np.pi",
        "a cycle whose stance leg goes below the ground is accepted",
        (f"{SOLVER}::test_a_stance_leg_beyond_the_horizontal_is_not_a_step",),
    ),
    Mutation(
        "solver/cycles/solver.py",
        "can &= np.abs(before[:, self.model.stance_index]) < np.pi / 2",
        "can &= np.abs(before[:, self.model.stance_index]) < np.pi",
        "a search takes ends whose stance leg is below the ground for steps",
        (f"{SOLVER}::test_an_end_of_a_search_below_the_ground_is_not_a_step",),
    ),
    Mutation(
        "solver/cycles/acceptance.py",
        "codes[found[~(cycles.state_errors < self.options.max_state_error)]]",
        "codes[found[cycles.state_errors > 1e9]]",
        "cycles near folds are called converged whatever their error",
        (f"{SOLVER}::test_acceptance_decides_what_is_accurate",),
    ),
    Mutation(
        "solver/cycles/duplicates.py",
        ".max(axis=1) > tolerance",
        ".max(axis=1) > 1e5 * tolerance",
        "two cycles near each other are one",
        ("tests/solver/cycles/test_search.py::test_distinct_agrees_with_comparing_all_pairs",),
    ),
    Mutation(
        "solver/cycles/search.py",
        "TWICE = 2\n",
        "TWICE = 1\n",
        "a search ends though a cycle was reached from one start alone",
        ("tests/solver/cycles/test_lost_gaits.py::test_a_cycle_that_one_start_reached_is_a_reason_for_more",),
    ),
    Mutation(
        "solver/cycles/chain.py",
        "change = points - np.roll(points, -1, axis=1)",
        "change = points - np.roll(points, 1, axis=1)",
        "the steps of a cycle of several close in the wrong order",
        ("tests/solver/cycles/test_chain.py::test_each_step_leads_to_the_next_and_the_last_to_the_first",),
    ),
    Mutation(
        "solver/cycles/chain.py",
        "product = step_map_derivative(step) @ product",
        "product = step_map_derivative(step)",
        "the multipliers of a cycle of several steps are those of its last",
        ("tests/solver/cycles/test_chain.py::test_the_two_step_gait_of_the_simplest_walker",),
    ),
    Mutation(
        "solver/model/scales.py",
        "own[name[1:]] / time for name",
        "own[name[1:]] * time for name",
        "rates have a scale with the wrong unit",
        ("tests/solver/test_units.py::test_the_scales_of_the_built_in_models_are_their_units",),
    ),
    Mutation(
        "solver/model/scales.py",
        "return length, math.sqrt(length / gravity)",
        "return length, math.sqrt(gravity / length)",
        "the scale of time is a frequency",
        ("tests/solver/test_units.py::test_the_scales_have_the_units_of_the_model",),
    ),
    Mutation(
        "solver/walks/equations.py",
        "        return self.model.wrapped(z)\n",
        "        return z\n",
        "the phase of a clock that is not reset grows from step to step",
        ("tests/solver/walks/test_events.py",),
    ),
    Mutation(
        "solver/walks/swing.py",
        "TIME_LIMIT = 25.0",
        "TIME_LIMIT = 2.5",
        "slow steps are given up",
        (f"{OUTCOMES}::test_a_wheel_that_just_passes_takes_its_time",),
    ),
    Mutation(
        "solver/walks/events.py",
        "down = abs(y[stance]) > math.pi / 2",
        "down = abs(y[stance]) > math.pi",
        "a walker falls only when its leg points down",
        ("tests/solver/walks/test_events.py",),
    ),
    Mutation(
        "solver/walks/events.py",
        "return Outcome.GOES_UPHILL if pull > 0",
        "return Outcome.GOES_UPHILL if pull < 0",
        "uphill and downhill change places",
        (f"{OUTCOMES}::test_a_compass_without_energy_rocks_back",),
    ),
    Mutation(
        "solver/walks/events.py",
        "        y = walker.advance(t, y, t - h / dh, rtol, atol)\n        t -= h / dh\n",
        "        break\n",
        "a touchdown is where the interpolant has it",
        (
            "tests/solver/walks/test_simulator.py::test_a_coarse_integrator_comes_down_on_the_ground_all_the_same",
        ),
    ),
    Mutation(
        "stridemap/units.py",
        "return _finite(value, quantity) * self.unit(quantity)",
        "return _finite(value, quantity) / self.unit(quantity)",
        "numbers in SI units are converted backwards",
        ("tests/stridemap/test_units.py::test_round_trip",),
    ),
)

ALONG = "tests/solver/kernels/test_step_map.py::test_derivative_in_the_parameters_is_that_of_the_residual"

MUTATIONS = (*KERNELS, *CYCLES)
