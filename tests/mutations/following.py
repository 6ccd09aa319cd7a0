"""Changes of how sweeps follow many branches at a time."""

from tests.mutations.mutation import Mutation

TILES = "tests/sweeps/test_tiles.py"
CONTINUATION = "tests/solver/branches/test_continuation.py"

MUTATIONS = (
    Mutation(
        "solver/branches/continuation.py",
        "rising = end > start",
        "rising = end != start",
        "a branch that leads back around a fold is lost",
        (f"{CONTINUATION}::test_fold_leads_to_the_other_cycle_of_the_pair",),
    ),
    Mutation(
        "solver/branches/continuation.py",
        "matrix[:, -1, :] = across\n        change",
        "matrix[:, -1, :] = np.eye(x.shape[1])[-1]\n        change",
        "corrections keep the parameter, so that no fold is passed",
        (f"{CONTINUATION}::test_fold_leads_to_the_other_cycle_of_the_pair",),
    ),
    Mutation(
        "solver/branches/continuation.py",
        "ended = ~((period > shortest) & (period <= longest)) | (s <= 0) | (s >= 1)",
        "ended = ~(period > 0) | (s <= 0) | (s >= 1)",
        "branches are followed outside the range of periods",
        (f"{CONTINUATION}::test_hopeless_branches_end_nowhere",),
    ),
    Mutation(
        "solver/branches/continuation.py",
        "(self._sideways(x, y, tangent, new) < SIDEWAYS)",
        "(self._sideways(x, y, tangent, new) < np.inf)",
        "long steps stray to other curves",
        (f"{CONTINUATION}::test_steps_as_long_as_in_sweeps_do_not_stray_to_a_curve_beside",),
    ),
    Mutation(
        "solver/branches/continuation.py",
        "if len(sharp):",
        "if False:",
        "tangents where branches turn sharply are those of the predicted points",
        (f"{TILES}::test_two_cycles_next_to_a_fold_are_one_branch",),
    ),
    Mutation(
        "solver/branches/continuation.py",
        "np.linalg.det(matrix)[:, None] < 0",
        "np.linalg.det(matrix)[:, None] < -np.inf",
        "what lies around a fold is followed from both sides of it",
        (f"{CONTINUATION}::test_a_branch_ends_where_another_one_begins_that_it_leads_to",),
    ),
    Mutation(
        "solver/branches/continuation.py",
        "at = np.flatnonzero(begins[self.line] & ~came_along)",
        "at = np.arange(0)",
        "branches are followed one way only",
        (f"{CONTINUATION}::test_where_branches_are_given_up_does_not_depend_on_other_lines",),
    ),
    Mutation(
        "solver/branches/continuation.py",
        "look = np.flatnonzero(heads.steps % LOOK == 0)",
        "look = np.flatnonzero(heads.steps % LOOK == heads.steps.max() % LOOK)",
        "where a branch is given up depends on others",
        (f"{CONTINUATION}::test_where_branches_are_given_up_does_not_depend_on_other_lines",),
    ),
    Mutation(
        "solver/branches/stops.py",
        "good = distance < ON_CURVE * length[row]",
        "good = distance < 10 * ON_CURVE * length[row]",
        "branches end at others that pass by",
        ("tests/solver/branches/test_cubics.py",),
    ),
    Mutation(
        "solver/branches/following.py",
        "good = found.found & near & (fixed_point_index(found.multipliers) == index[active])",
        "good = found.found & near",
        "a branch is followed across a fold onto the other cycle",
        (
            "tests/solver/branches/test_following.py"
            "::test_the_other_cycle_beside_a_fold_is_not_a_step_along_the_branch",
        ),
    ),
    Mutation(
        "solver/branches/following.py",
        "MAX_HALVINGS = 14",
        "MAX_HALVINGS = 2",
        "branches end long before their fold",
        ("tests/solver/branches/test_following.py::test_branches_end_at_a_fold_where_they_meet",),
    ),
    Mutation(
        "solver/branches/continuation.py",
        "matrix[:, :n, n] = along",
        "matrix[:, :n, n] = along * (1 + 1e-9)",
        "derivatives along lines are those of differences",
        (f"{CONTINUATION}::test_the_derivative_along_a_line_is_exact",),
    ),
)
