"""Changes of how branches are followed: curves, bifurcations, ends of gaits, joining, targets."""

from tests.mutations.mutation import Mutation

MAPS = "tests/solver/branches/test_known_maps.py"
FOLD = f"{MAPS}::test_a_fold_is_passed_and_found"
LOGISTIC = f"{MAPS}::test_the_doublings_of_the_logistic_map"
TORUS = f"{MAPS}::test_the_torus_of_the_delayed_logistic_map"
PITCHFORK = f"{MAPS}::test_a_pitchfork_is_a_branch_point_from_which_both_sides_are_reached"
TWO = f"{MAPS}::test_two_doublings_between_two_points_are_both_found"
ENDS = "tests/solver/branches/test_ends.py"
DEFINING = "tests/solver/branches/test_defining.py"

CURVES = (
    Mutation(
        "solver/branches/dips.py",
        "if value * before < 0:",
        "if value * before > 0:",
        "points are added where nothing changes, and not where two doublings are",
        (f"{MAPS}::test_a_multiplier_that_goes_beyond_minus_one_and_back_within_a_step_is_seen",),
    ),
    Mutation(
        "solver/branches/arclength.py",
        "return bool((one * other).sum() < 0)",
        "return False",
        "a doubled branch goes on through the same cycles with their halves exchanged",
        (f"{MAPS}::test_a_doubled_branch_ends_where_its_halves_are_one_cycle_again",),
    ),
    Mutation(
        "solver/branches/equations.py",
        "out[:, step, :, size:] = rows[:, :, width:]",
        "out[:, step, :, size:] = 0 * rows[:, :, width:]",
        "second derivatives leave out the parameter",
        (LOGISTIC,),
    ),
    Mutation(
        "solver/branches/equations.py",
        "given[:, :, [width + column for column in one.columns]] = v[:, None, size:]",
        "given[:, :, [width + column for column in one.columns]] = 0 * v[:, None, size:]",
        "second derivatives leave out the direction along the parameter",
        (f"{MAPS}::test_second_derivatives_are_differences_of_the_first",),
    ),
    Mutation(
        "solver/branches/equations.py",
        "return parts[:m] + 1j * parts[m:]",
        "return parts[:m]",
        "second derivatives along a complex direction are those along its real part",
        (TORUS,),
    ),
    Mutation(
        "solver/branches/curve.py",
        "tangent = solved(np.vstack([matrix, ahead / self.scale**2]), right)",
        "tangent = -solved(np.vstack([matrix, ahead / self.scale**2]), right)",
        "branches are followed backwards",
        (FOLD,),
    ),
    Mutation(
        "solver/branches/curve.py",
        "CORRECTED = 1e-8",
        "CORRECTED = 1e-1",
        "a point is taken after its first correction",
        (f"{MAPS}::test_every_point_of_a_branch_closes_to_rounding",),
    ),
    Mutation(
        "solver/branches/arclength.py",
        "STANDING = 1e-4",
        "STANDING = 1e-1",
        "small gaits are walkers that stand",
        (f"{MAPS}::test_a_walker_that_stands_ends_a_branch_and_a_small_gait_does_not",),
    ),
    Mutation(
        "solver/options.py",
        "FARTHEST = 8.0",
        "FARTHEST = 0.8",
        "branches end a little outside the search box",
        ("tests/solver/cycles/test_lost_gaits.py::test_the_search_box_can_be_given_and_widened",),
    ),
    Mutation(
        "solver/branches/arclength.py",
        "MAX_CORRECTION = 0.3",
        "MAX_CORRECTION = 30.0",
        "a correction may lead onto another branch",
        (f"{MAPS}::test_a_correction_that_leads_far_is_not_taken",),
    ),
    Mutation(
        "solver/branches/arclength.py",
        "or astray or turn < options.min_tangent_cosine:",
        "or astray or turn < -2:",
        "the tangent may turn by any angle in one step",
        (f"{MAPS}::test_the_tangent_turns_little_from_point_to_point",),
    ),
    Mutation(
        "solver/branches/arclength.py",
        "if before < 0 <= ahead and near:",
        "if False:",
        "a closed branch is gone round for ever",
        (f"{MAPS}::test_a_closed_curve_is_gone_round_once",),
    ),
    Mutation(
        "solver/branches/arclength.py",
        "end = high if there[i] > high else low",
        "end = low if there[i] > high else high",
        "a branch is not followed to the end of the range",
        (FOLD,),
    ),
    Mutation(
        "solver/branches/arclength.py",
        "(steps[:, -1] > window.shortest) & (steps[:, -1] <= window.longest)",
        "(steps[:, -1] > window.shortest) & (steps[:, -1] <= 9 * window.longest)",
        "branches are followed to steps of any length",
        (f"{MAPS}::test_a_branch_ends_where_a_step_becomes_too_long_or_too_short",),
    ),
)

BIFURCATIONS = (
    Mutation(
        "solver/branches/special.py",
        "np.prod(multipliers[i] * multipliers[j] - 1.0).real",
        "np.prod(multipliers[i] * multipliers[j] + 1.0).real",
        "tori are looked for where multipliers' product is -1",
        (TORUS,),
    ),
    Mutation(
        "solver/branches/special.py",
        "float(np.prod(1.0 + multipliers).real)",
        "float(np.prod(1.0 - multipliers).real)",
        "doublings are looked for where a multiplier is 1",
        (LOGISTIC,),
    ),
    Mutation(
        "solver/branches/special.py",
        "change <= explained and (explained - change) % 2 == 0",
        "change <= explained + 9",
        "two doublings between two points are overlooked",
        (TWO,),
    ),
    Mutation(
        "solver/branches/special.py",
        "BISECTIONS, SUBDIVISIONS = 24, 8",
        "BISECTIONS, SUBDIVISIONS = 24, 1",
        "two doublings close to each other are overlooked",
        (TWO,),
    ),
    Mutation(
        "solver/branches/defining.py",
        "-(gradient * self._tangents(open_, matrix)).sum(axis=1)",
        "(gradient * self._tangents(open_, matrix)).sum(axis=1)",
        "a multiplier is said to cross the unit circle the other way",
        (LOGISTIC,),
    ),
    Mutation(
        "solver/branches/defining.py",
        "slopes: Array = -(psi * bend)",
        "slopes: Array = (psi * bend)",
        "a fold is said to open to the other side",
        (FOLD,),
    ),
    Mutation(
        "solver/branches/defining.py",
        "self._changes(open_, matrix, linear) / np.exp(1j * self.theta[open_])",
        "self._changes(open_, matrix, linear) * np.exp(1j * self.theta[open_])",
        "a torus is said to be born at another angle",
        (TORUS,),
    ),
    Mutation(
        "solver/branches/defining.py",
        "across = np.array([-along[1], along[0]]) @ kernel",
        "across = along @ kernel",
        "the branch that crosses another one is that one itself",
        (PITCHFORK,),
    ),
    Mutation(
        "solver/branches/special.py",
        "    while n_rk < CYCLE_N_RK[-1]:\n",
        "    while False:\n",
        "special points are those of the first resolution",
        (f"{MAPS}::test_special_points_are_refined_until_the_resolution_does_not_move_them",),
    ),
    Mutation(
        "solver/branches/defining.py",
        "SPECIAL_RESIDUAL, SETTLED, SETTLED_NEARLY = 1e-11, 1e-7, 1e-12",
        "SPECIAL_RESIDUAL, SETTLED, SETTLED_NEARLY = 1e-3, 1e-1, 1e-1",
        "special points are where Newton's method has hardly begun",
        (DEFINING,),
    ),
    Mutation(
        "solver/branches/defining.py",
        "SHORTER = 0.2",
        "SHORTER = 0.0",
        "every Newton step to a special point takes second derivatives",
        (DEFINING,),
    ),
    Mutation(
        "solver/branches/defining.py",
        "self._kept = np.full(len(self.curves), bool(given))",
        "self._kept = np.full(len(self.curves), False)",
        "what was found at a coarser resolution is solved for as if it had not been",
        (DEFINING,),
    ),
    Mutation(
        "solver/branches/defining.py",
        "<= self.reach[open_]",
        "<= np.inf",
        "special points are taken from far beyond the bracket",
        (DEFINING,),
    ),
    Mutation(
        "solver/branches/asking.py",
        "asking.setdefault((type(question), question.kind), [])",
        "asking.setdefault((type(question), number), [])",
        "what searches ask is answered one by one",
        ("tests/solver/branches/test_asking.py::test_questions_of_one_kind_are_answered_in_one_call",),
    ),
    Mutation(
        "solver/branches/ends.py",
        "        return here is not None and (yield from self._tried(here, name)) > 0",
        "        return False and (yield from self._tried(here, name)) > 0",
        "an early touchdown that appears where the foot grazes is searched for by bisection",
        (f"{ENDS}::test_an_early_touchdown_that_appears_where_the_foot_grazes_is_not_searched_for",),
    ),
    Mutation(
        "solver/branches/ends.py",
        "sorted(known, key=lambda one: one == GaitEnd.EARLY_TOUCHDOWN)",
        "sorted(known, key=lambda one: one != GaitEnd.EARLY_TOUCHDOWN)",
        "an early touchdown is searched for before it is known where the foot grazes",
        (f"{ENDS}::test_an_early_touchdown_that_appears_where_the_foot_grazes_is_not_searched_for",),
    ),
    Mutation(
        "solver/branches/switching.py",
        "np.concatenate([w, -w, [0.0]])",
        "np.concatenate([w, w, [0.0]])",
        "the doubled branch is looked for on the single one",
        (LOGISTIC,),
    ),
    Mutation(
        "solver/branches/switching.py",
        "special.x, side * np.real(special.null)",
        "special.x, np.real(special.null)",
        "a branch that crosses is followed to one side only",
        (PITCHFORK,),
    ),
    Mutation(
        "solver/branches/switching.py",
        "return bool(offset * special.slope * special.direction < 0)",
        "return bool(offset * special.slope * special.direction > 0)",
        "supercritical and subcritical change places",
        (LOGISTIC,),
    ),
    Mutation(
        "solver/branches/switching.py",
        "return bool(offset * special.slope * special.direction < 0)",
        "return bool(offset * special.slope < 0)",
        "whether a doubling is supercritical depends on the way along the branch",
        (f"{MAPS}::test_a_doubling_is_supercritical_where_the_single_cycle_is_unstable",),
    ),
)

GAITS = (
    Mutation(
        "solver/branches/conditions.py",
        "return 0.5 * np.pi - fallen",
        "return np.pi - fallen",
        "a gait falls only when its leg points down",
        (f"{ENDS}::test_conditions_are_what_is_measured",),
    ),
    Mutation(
        "solver/branches/conditions.py",
        'return -extreme(trace, "vertical_force", np.negative)',
        'return extreme(trace, "vertical_force")',
        "contact is judged where the ground pushes most",
        (f"{ENDS}::test_conditions_are_what_is_measured",),
    ),
    Mutation(
        "solver/branches/conditions.py",
        "values.reshape(len(at), n_steps).min(axis=1)",
        "values.reshape(len(at), n_steps).max(axis=1)",
        "a cycle of two steps is as good as its better step",
        (f"{ENDS}::test_a_cycle_of_several_steps_is_as_good_as_its_worst_step",),
    ),
    Mutation(
        "solver/branches/conditions.py",
        "found = found.take(found.f_lower > found.f_upper)  # maxima only",
        "found = found.take(found.f_lower < found.f_upper)",
        "an early touchdown is looked for where the foot is highest",
        (f"{ENDS}::test_a_gait_ends_where_the_foot_touches_down_early",),
    ),
    Mutation(
        "solver/branches/conditions.py",
        'return trace.dg[:, -1, trace.row("touchdown")]',
        'return trace.dg[:, 0, trace.row("touchdown")]',
        "grazing is judged at the beginning of the step",
        (f"{ENDS}::test_conditions_are_what_is_measured",),
    ),
    Mutation(
        "solver/branches/ends.py",
        "        return here is not None and (yield from self._tried(here, name)) > 0",
        "        return here is not None or (yield from self._tried(here, name)) > 0",
        "of two conditions the one that is met last ends a gait",
        (f"{MAPS}::test_a_gait_ends_at_the_condition_that_is_met_first",),
    ),
    Mutation(
        "solver/branches/ends.py",
        "while n_rk < CYCLE_N_RK[-1]:",
        "while n_rk < 0:",
        "the ends of gaits are those at the resolution with which the branch was followed",
        (f"{ENDS}::test_an_end_is_one_at_the_finest_resolution_too",),
    ),
    Mutation(
        "solver/branches/ends.py",
        "if noise and abs(f) < LOCATED and left < UNCHANGED:",
        "if noise and abs(f) < LOCATED and left < SETTLED:",
        "an end that rounding blurs is searched for again at the finest resolution",
        (f"{ENDS}::test_where_rounding_blurs_a_condition_secants_stop",),
    ),
    Mutation(
        "solver/branches/ends.py",
        "gait = np.all(list(holds.values()), axis=0)",
        "gait = np.any(list(holds.values()), axis=0)",
        "a gait goes on while one of its conditions holds",
        (f"{MAPS}::test_a_condition_that_is_broken_on_both_sides_hides_others",),
    ),
    Mutation(
        "solver/branches/ends.py",
        "LOCATED, ROUNDING = 1e-11, 1e-14",
        "LOCATED, ROUNDING = 1e3, 1e-14",
        "a condition that jumps ends a gait where it is not zero",
        (f"{MAPS}::test_a_condition_that_jumps_has_no_end_on_the_branch",),
    ),
    Mutation(
        "solver/branches/survey.py",
        "        return False\n    steps = x[:-1]",
        "        return False\n    return False\n    steps = x[:-1]",
        "a branch is followed anew from every cycle on it",
        ("tests/solver/branches/test_survey.py",),
    ),
    Mutation(
        "solver/branches/survey.py",
        "for k in range(branch.period_n))",
        "for k in range(1))",
        "a cycle of two steps that begins with its other step is a new branch",
        ("tests/solver/branches/test_survey.py",),
    ),
    Mutation(
        "solver/branches/arclength.py",
        "SAME = 1e-5",
        "SAME = 1e-1",
        "a branch beside another one is taken for it",
        ("tests/solver/branches/test_survey.py",),
    ),
    Mutation(
        "solver/branches/survey.py",
        "doublings=self.cascade > turn)",
        "doublings=True)",
        "doublings are followed that were not asked for",
        ("tests/solver/branches/test_survey.py",),
    ),
)

JOINED = (
    Mutation(
        "solver/branches/joining.py",
        "SAME_CYCLE = 1e-5",
        "SAME_CYCLE = 1e-15",
        "pieces of one branch are not joined over a value without a cycle",
        ("tests/solver/branches/test_joining.py",),
    ),
    Mutation(
        "solver/branches/joining.py",
        "distance[(index[:, None] == index[None]) | (owner",
        "distance[(owner",
        "two ends that do not meet in a fold are joined",
        ("tests/solver/branches/test_joining.py",),
    ),
    Mutation(
        "solver/branches/edges.py",
        "good = is_physical_gait(found) & found.known_stable & (found.group == orbits.group)",
        "good = is_physical_gait(found)",
        "the edge of stable cycles is that of all cycles",
        ("tests/solver/branches/test_edges.py",),
    ),
    Mutation(
        "solver/branches/main_branch.py",
        "np.sign(np.prod(1 - multipliers.T, axis=0).real)",
        "np.sign(np.prod(1 + multipliers.T, axis=0).real)",
        "the index changes at doublings and not at folds",
        ("tests/solver/branches/test_main_branch.py",),
    ),
    Mutation(
        "solver/branches/minima.py",
        "better = amount[n, least] < _amounts(best, measures)[measure, n]",
        "better = amount[n, least] > _amounts(best, measures)[measure, n]",
        "smallest values are looked for where they are larger",
        ("tests/solver/branches/test_minima.py",),
    ),
    Mutation(
        "solver/branches/targets.py",
        "ACCEPTED = 1e-11",
        "ACCEPTED = 1e9",
        "a jump over the wanted value is a solution",
        ("tests/solver/branches/test_target_roots.py",),
    ),
    Mutation(
        "solver/branches/targets.py",
        "changes = away[:-1] * away[1:] < 0",
        "changes = away[:-1] * away[1:] > 0",
        "solutions are looked for where there is none",
        ("tests/solver/branches/test_targets.py::test_any_quantity_of_the_closed_form",),
    ),
    Mutation(
        "solver/branches/targets.py",
        "if not (middle <= left and middle <= right and middle < max(left, right)):",
        "if True:",
        "two solutions on the two sides of a turning point are overlooked",
        ("tests/solver/branches/test_target_roots.py",),
    ),
    Mutation(
        "solver/branches/target_range.py",
        "around = current * 2.0 ** np.arange(-OCTAVES, OCTAVES + 1)",
        "around = current + 2.0 ** np.arange(-OCTAVES, OCTAVES + 1)",
        "values around the point's own are not searched",
        ("tests/solver/branches/test_targets.py::test_values_are_spread_evenly_and_around_the_point_s_own",),
    ),
)

SPECIAL = (
    Mutation(
        "solver/branches/arclength.py",
        "if there is None or _jumps(curve, point, there):",
        "if there is None:",
        "a curve that runs beside another one is taken for it",
        ("tests/solver/branches/test_passes_through.py",),
    ),
    Mutation(
        "solver/branches/special.py",
        "if not change and crossed in ([], [SpecialType.PD]):",
        "if crossed in ([], [SpecialType.PD]):",
        "two doublings between two points count as none",
        (TWO,),
    ),
    Mutation(
        "solver/branches/conditions.py",
        "within: Array = np.minimum(u[:, -1] - shortest, longest - u[:, -1])",
        "within: Array = np.maximum(u[:, -1] - shortest, longest - u[:, -1])",
        "one limit of the period is enough",
        ("tests/sweeps/test_special.py::test_where_the_period_leaves_its_range_it_has_the_limit",),
    ),
)

MUTATIONS = (*SPECIAL, *CURVES, *BIFURCATIONS, *GAITS, *JOINED)
