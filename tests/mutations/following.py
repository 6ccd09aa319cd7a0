"""Changes of how sweeps follow many branches at a time."""

from tests.mutations.mutation import Mutation

CONTINUATION = "tests/solver/branches/test_continuation.py"
ALIKE = "tests/solver/branches/test_arcs.py::test_steps_in_lanes_are_those_one_by_one"

MUTATIONS = (
    Mutation(
        "solver/branches/continuation.py",
        "rising = end > start",
        "rising = end != start",
        "a branch that leads back around a fold is lost",
        (f"{CONTINUATION}::test_fold_leads_to_the_other_cycle_of_the_pair",),
    ),
    Mutation(
        "solver/branches/arcs.h",
        "matrix[nu + k * m] = arc.across[k];",
        "matrix[nu + k * m] = k == nu;",
        "corrections keep the parameter",
        (ALIKE,),
    ),
    Mutation(
        "solver/branches/arcs.h",
        "!(period > course.shortest && period <= course.longest) || s <= 0",
        "!(period > 0) || s <= 0",
        "branches are followed outside the range of periods",
        (f"{CONTINUATION}::test_hopeless_branches_end_nowhere",),
    ),
    Mutation(
        "solver/branches/arcs.h",
        "led_sideways(arc, x, tangent) < course.sideways",
        "led_sideways(arc, x, tangent) < INFINITY",
        "long steps stray to other curves",
        (f"{CONTINUATION}::test_steps_as_long_as_in_sweeps_do_not_stray_to_a_curve_beside",),
    ),
    Mutation(
        "solver/branches/arcs.h",
        "if (arcs[i].cosine < course.sharp) {",
        "if (arcs[i].cosine < -1) {",
        "tangents where branches turn sharply are those of the predicted points",
        (ALIKE,),
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
        "at = np.flatnonzero(begins[line] & ~came_along)",
        "at = np.arange(0)",
        "branches are followed one way only",
        (f"{CONTINUATION}::test_where_branches_are_given_up_does_not_depend_on_other_lines",),
    ),
    Mutation(
        "solver/branches/arcs.h",
        "arc.tries++ == tries",
        "arc.tries++ == n % tries + 1",
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
        "solver/branches/arcs.py",
        "matrix[:, :n, n] = along",
        "matrix[:, :n, n] = along * (1 + 1e-9)",
        "derivatives along lines are those of differences",
        (f"{CONTINUATION}::test_the_derivative_along_a_line_is_exact",),
    ),
    Mutation(
        "solver/branches/arcs.py",
        "if len(sharp):",
        "if False:",
        "without lanes, tangents where branches turn sharply are those of the predicted points",
        (ALIKE,),
    ),
    Mutation(
        "solver/branches/arcs.py",
        "ended[np.flatnonzero(good)[row]] = True",
        "pass",
        "without lanes, branches do not end where others begin",
        (ALIKE,),
    ),
    Mutation(
        "solver/branches/arcs.h",
        "arc.easy = arc.corrections < course.max_corrections;",
        "arc.easy = true;",
        "steps grow after a hard one",
        (ALIKE,),
    ),
    Mutation(
        "solver/branches/arcs.h",
        "bend[k] = (arc.turned[k] - tangent[k]) / length;",
        "bend[k] = 0;",
        "what is predicted lies on tangents",
        (ALIKE,),
    ),
    Mutation(
        "solver/branches/arcs.h",
        "if (!(sqrt(apart) < course.on_curve * length)) continue;",
        "if (!(sqrt(apart) < 10 * course.on_curve * length)) continue;",
        "in lanes, branches end at others that pass by",
        (ALIKE,),
    ),
    Mutation(
        "solver/branches/arcs.h",
        "heads.met_from_behind[number] = 1;",
        "heads.met_from_behind[number] = 0;",
        "each stretch of a branch is followed from all of its beginnings",
        (ALIKE,),
    ),
)
