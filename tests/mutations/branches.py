"""Changes of how branches are followed: curves, joining, targets."""

from tests.mutations.mutation import Mutation

MAPS = "tests/solver/branches/test_known_maps.py"
ON_MAPS = "tests/solver/branches/test_ends_on_maps.py"
FOLD = f"{MAPS}::test_a_fold_is_passed_and_found"
LOGISTIC = f"{MAPS}::test_the_doublings_of_the_logistic_map"
TORUS = f"{MAPS}::test_the_torus_of_the_delayed_logistic_map"
TWO = f"{MAPS}::test_two_doublings_between_two_points_are_both_found"

CURVES = (
    Mutation(
        "solver/branches/dips.py",
        "if value * before < 0:",
        "if value * before > 0:",
        "points are added where nothing changes, and not where two doublings are",
        (f"{ON_MAPS}::test_a_multiplier_that_goes_beyond_minus_one_and_back_within_a_step_is_seen",),
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

MUTATIONS = (*SPECIAL, *CURVES, *JOINED)
