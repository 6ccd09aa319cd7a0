"""Changes of sweeps, their tables, the report and the paper's statements."""

from tests.mutations.mutation import Mutation

CLEAR = "tests/solver/cycles/test_clear_cases.py"
TILES = "tests/sweeps/test_tiles.py"
SPECIAL = "tests/sweeps/test_special.py"
REPORT = "tests/stridemap/views/test_report.py"
NOTATION = "tests/stridemap/views/test_notation.py"
CLAIMS = "tests/stridemap/paper/test_claims.py"

SWEEPS = (
    Mutation(
        "sweeps/tiles.py",
        "may_be_gaits=lambda u, params: self._clear_cases(u, params) == DOUBTFUL,",
        "may_be_gaits=lambda u, params: self._clear_cases(u, params) != DOUBTFUL,",
        "branches are followed where they are not gaits, and not where they are",
        (f"{TILES}::test_a_branch_is_followed_as_long_as_it_is_a_gait_however_little_patience_there_is",),
    ),
    Mutation(
        "solver/cycles/acceptance.py",
        "out[(passes & deep).any(axis=1)] = Status.LATER_TOUCHDOWN.code",
        "out[passes.any(axis=1)] = Status.LATER_TOUCHDOWN.code",
        "a foot that hardly touches the ground counts as down",
        (f"{CLEAR}::test_a_foot_that_just_passes_is_in_doubt",),
    ),
    Mutation(
        "solver/cycles/acceptance.py",
        "out[falls] = Status.NOT_A_STEP.code",
        "out[~falls] = Status.NOT_A_STEP.code",
        "steps are no steps",
        (f"{CLEAR}::test_gaits_are_in_doubt_and_clear_cases_are_what_acceptance_says",),
    ),
    Mutation(
        "solver/options.py",
        "return 0.85 * low, 1.15 * high",
        "return low, high",
        "branches end where they leave the range of periods for a while",
        (f"{TILES}::test_a_branch_is_followed_that_is_a_little_outside_the_range_of_periods",),
    ),
    Mutation(
        "sweeps/tiles.py",
        "        self._outgoing.append(guesses.take(~here & ~passed.beyond))\n",
        "",
        "branches end at the border of a tile",
        (f"{TILES}::test_what_leads_into_other_tiles_is_handed_on",),
    ),
    Mutation(
        "sweeps/tiles.py",
        "BEYOND = 0.1",
        "BEYOND = 0.0",
        "cells just beyond a fold are not looked at",
        (f"{TILES}::test_a_fold_just_beyond_a_cell_does_not_hide_its_two_cycles",),
    ),
    Mutation(
        "sweeps/tiles.py",
        "return self._entered(solutions.take(near & ~beyond))",
        "return self._entered(solutions.take(near))",
        "what lies just beyond a fold joins branches before it is followed",
        (f"{TILES}::test_a_fold_just_beyond_a_cell_does_not_hide_its_two_cycles",),
    ),
    Mutation(
        "sweeps/tiles.py",
        "        self._lost.append(guesses.take(~near & ~beyond))\n",
        "",
        "what is far from where a branch seems to pass is thrown away",
        (f"{TILES}::test_a_cycle_is_not_lost_that_is_far_from_where_its_branch_seems_to_pass",),
    ),
    Mutation(
        "sweeps/tiles.py",
        "u[across] = self.solver.predicted(",
        "_ = self.solver.predicted(",
        "searches do not set out on tangents",
        (f"{TILES}::test_a_gait_is_found_from_one_beside_it_to_which_only_its_tangent_leads",),
    ),
    Mutation(
        "sweeps/connections.py",
        "STEPS_ACROSS, DS_ACROSS, DS_MAX_ACROSS = 60, 0.1, 0.2",
        "STEPS_ACROSS, DS_ACROSS, DS_MAX_ACROSS = 60, 0.3, 1.0",
        "branches are followed to the next line in steps as long as the way",
        (f"{TILES}::test_a_branch_that_turns_back_on_the_way_to_the_next_cell_does_not_join_what_is_there",),
    ),
    Mutation(
        "sweeps/tiles.py",
        "(across, NEWTON_STEPS_ACROSS)",
        "(across, None)",
        "a search in a cell beside takes as many steps as one from anywhere",
        (f"{TILES}::test_a_search_from_another_cell_begins_where_the_tangent_leads_and_is_short",),
    ),
    Mutation(
        "sweeps/tiles.py",
        "        self._outgoing.append(guesses.take(~here))\n        return guesses.take(here)",
        "        return guesses.take(here)",
        "cells beside a branch that are in another tile are not tried",
        (f"{TILES}::test_from_a_branch_the_cells_beside_it_are_tried",),
    ),
    Mutation(
        "sweeps/tiles.py",
        "self._join(arrived.take(along & (away < SAME_BRANCH)))",
        "self._join(arrived)",
        "a search that ends far away joins two families",
        (f"{TILES}::test_families_are_one_only_where_following_leads_from_one_to_the_other",),
    ),
    Mutation(
        "sweeps/tiles.py",
        "BESIDE = 0.2",
        "BESIDE = 0.0",
        "searches begin beside what is known",
        (f"{TILES}::test_no_search_begins_beside_a_known_cycle_and_yet_the_branches_are_one",),
    ),
    Mutation(
        "sweeps/found.py",
        "at = open_links(links, self.joins)",
        "at = open_links(links, self.joins[:0])",
        "branches that are known to be one are followed to each other again",
        (
            "tests/sweeps/test_run.py::test_branches_are_followed_to_each_other_when_nothing_new_appears_and"
            "_if_they_are_not_one_yet",
        ),
    ),
    Mutation(
        "sweeps/families.py",
        "one, other = place[len(branch) :].reshape(-1, 2).T",
        "one, other = place[len(branch) :].reshape(2, -1)",
        "branches that have nothing in common are one",
        ("tests/sweeps/test_solutions.py::test_families_are_connected_and_numbered_as_they_appear",),
    ),
    Mutation(
        "sweeps/solutions.py",
        "near = (np.abs(self.u[open_] - other.u[candidate]) <= tolerance * scale).all(axis=1)",
        "near = (np.abs(self.u[open_] - other.u[candidate]) <= tolerance * scale).any(axis=1)",
        "solutions that agree in one entry are one",
        ("tests/sweeps/test_solutions.py",),
    ),
    Mutation(
        "sweeps/grid.py",
        "np.array([-1, 1])",
        "np.array([1, 1])",
        "cells have neighbours on one side only",
        ("tests/sweeps/test_grid.py::test_cells_beside_are_one_step_along_one_axis_that_is_not_the_longest",),
    ),
    Mutation(
        "sweeps/found.py",
        "return (period > shortest) & (period <= longest)",
        "return (period > 0) & (period <= 2 * longest)",
        "cycles outside the range of periods are rows",
        ("tests/sweeps/test_run.py::test_cells_without_a_cycle_say_so",),
    ),
    Mutation(
        "sweeps/store.py",
        "if same_software and found != own:",
        "if False:",
        "a sweep is continued with other software",
        ("tests/sweeps/test_store.py::test_resume_refuses_other_software",),
    ),
    Mutation(
        "sweeps/config.py",
        "for low, high in itertools.pairwise(values):",
        "for low, high in ():",
        "an axis may have a value twice",
        ("tests/sweeps/test_config.py::test_bad_file_is_told_in_one_sentence",),
    ),
    Mutation(
        "sweeps/found.py",
        "np.add.at(self.stable, cell[counts & stable], 1)",
        "np.add.at(self.stable, cell[counts], 1)",
        "all cycles of a cell are counted as stable",
        ("tests/sweeps/test_run.py::test_cells_count_the_orbits_and_summary_adds_up",),
    ),
)

POINTS = (
    Mutation(
        "sweeps/changes.py",
        "return np.asarray(cycle & differ.any(axis=1))",
        "return np.asarray(cycle & differ.all(axis=1))",
        "something happens only where everything happens",
        (f"{SPECIAL}::test_the_first_doubling_of_the_simplest_walker",),
    ),
    Mutation(
        "sweeps/special_tables.py",
        "SAME_POINT = 1e-6",
        "SAME_POINT = 1e-14",
        "what two tiles have found stands twice",
        (f"{SPECIAL}::test_the_order_and_what_is_one_point",),
    ),
    Mutation(
        "sweeps/special_columns.py",
        'lower, "right") - 1, 0)',
        'lower, "left") - 1, 0)',
        "a special point in a cell belongs to the cell before",
        (f"{SPECIAL}::test_the_order_and_what_is_one_point",),
    ),
    Mutation(
        "sweeps/special_tables.py",
        "return overlap and known",
        "return known",
        "a point that was located excuses every other of its family that was not",
        (f"{SPECIAL}::test_the_order_and_what_is_one_point",),
    ),
    Mutation(
        "sweeps/special.py",
        "zip(located, of_cycles.tolist(), strict=True) if cycle]",
        "zip(located, of_cycles.tolist(), strict=True) if not cycle]",
        "bifurcations are those of solutions that are no limit cycles",
        (f"{SPECIAL}::test_the_first_doubling_of_the_simplest_walker",),
    ),
    Mutation(
        "sweeps/special.py",
        "contact[of_cycles].tolist()",
        "contact.tolist()[: len(located)]",
        "whether a bifurcation is a gait's is said of another one",
        (f"{SPECIAL}::test_each_bifurcation_of_a_cycle_is_entered_where_it_was_found",),
    ),
    Mutation(
        "sweeps/special.py",
        "            met[line] += found\n",
        "            met[line] += ()\n",
        "bifurcations that two stretches share are located on both",
        (f"{SPECIAL}::test_what_two_stretches_share_is_looked_for_on_one_of_them",),
    ),
    Mutation(
        "sweeps/special.py",
        "(later if shared else now).append((line, piece))",
        "now.append((line, piece))",
        "no piece waits for what is found on another one that is near",
        (f"{SPECIAL}::test_what_two_stretches_share_is_looked_for_on_one_of_them",),
    ),
    Mutation(
        "sweeps/special.py",
        "del others[GaitEnd.CONTACT]",
        "others.pop(GaitEnd.GRAZING)",
        "limit cycles end where the foot loses contact, and not where it grazes the ground",
        (f"{SPECIAL}::test_a_line_has_the_special_points_of_the_branches_over_its_parameter",),
    ),
    Mutation(
        "sweeps/found.py",
        "_numbered(special, numbers[len(met) :])",
        "_numbered(special, numbers[: len(special)])",
        "special points have the families of other cycles",
        (f"{SPECIAL}::test_no_cycle_vanishes_along_a_line_without_a_special_point",),
    ),
)

PAGES = (
    Mutation(
        "stridemap/views/report/encoding.py",
        '{"type": "word", "words": words,',
        '{"type": "word", "words": words[::-1],',
        "words in the report are in the wrong order: each cell has another's",
        (
            "tests/stridemap/views/test_report_encoding.py::test_words_and_truth_stand_where_they_stand_in_the_table",
        ),
    ),
    Mutation(
        "stridemap/views/report/payload.py",
        '"unit": unit[q.kind],',
        '"unit": unit["number"],',
        "quantities in the report have no units",
        (f"{REPORT}::test_measures_are_those_of_the_registry",),
    ),
    Mutation(
        "stridemap/views/report/encoding.py",
        "np.where(values.isna(), 2, ",
        "np.where(values.isna(), 0, ",
        "what is not known to be stable is unstable in the report",
        (
            "tests/stridemap/views/test_report_encoding.py::test_words_and_truth_stand_where_they_stand_in_the_table",
        ),
    ),
    Mutation(
        "stridemap/quantities.py",
        '"power": ("M g sqrt(g L)", "W")',
        '"power": ("M g L", "W")',
        "powers have the unit of energies",
        ("tests/stridemap/test_units.py::test_every_quantity_has_the_dimension_of_its_si_unit",),
    ),
    Mutation(
        "stridemap/columns.py",
        "names.length: length + gravity",
        "names.length: length - gravity",
        "units of a model in units of its own are wrong",
        (NOTATION,),
    ),
    Mutation(
        "stridemap/tables/where.py",
        "return found.fillna(False).astype(bool)",
        "return found.fillna(True).astype(bool)",
        "rows of which it is not known are selected",
        ("tests/stridemap/tables/test_where.py::test_conditions",),
    ),
    Mutation(
        "stridemap/tables/gridded.py",
        'order = frame["period"].to_numpy().argsort(kind="stable")',
        'order = (-frame["period"].to_numpy()).argsort(kind="stable")',
        "the cycles of a cell are numbered by falling period",
        ("tests/stridemap/tables/test_gridded.py::test_every_row_is_where_its_parameters_say",),
    ),
    Mutation(
        "stridemap/tables/conversion.py",
        "name: frame[name] * factor",
        "name: frame[name] / factor",
        "tables are converted backwards",
        ("tests/stridemap/tables/test_si.py::test_tables_of_any_kind",),
    ),
    Mutation(
        "sweeps/si.py",
        "scaled = value / factor",
        "scaled = value * factor",
        "parameters of a sweep in SI units are converted backwards",
        (
            "tests/stridemap/tables/test_si.py"
            "::test_a_file_in_si_units_means_the_same_as_one_in_the_models_units",
        ),
    ),
)

STATEMENTS = (
    Mutation(
        "stridemap/paper/statements/stability.py",
        "parts.add(name, least > reference, compass=reference, cycles_not_above=below, **found)",
        "parts.add(name, least > 0.9 * reference, compass=reference, cycles_not_above=below, **found)",
        "C7 compares with 0.9 of the compass",
        (f"{CLAIMS}::test_comparisons_with_the_compass_are_with_its_own_number",),
    ),
    Mutation(
        "stridemap/paper/statements/efficiency.py",
        'parts.add(name, found.get("least", np.nan) > reference,',
        'parts.add(name, found.get("least", np.nan) > 0.9 * reference,',
        "C12 and C17 compare with 0.9 of the compass",
        (f"{CLAIMS}::test_comparisons_with_the_compass_are_with_its_own_number",),
    ),
    Mutation(
        "stridemap/paper/statements/efficiency.py",
        "below = rows[rows[column] < reference]",
        "below = rows[rows[column] < 1.1 * reference]",
        "C13 and C18 compare with 1.1 of the compass",
        (f"{CLAIMS}::test_comparisons_with_the_compass_are_with_its_own_number",),
    ),
    Mutation(
        "stridemap/paper/statements/stability.py",
        "length += max(0.0, run.closes - max(run.opens, reached))",
        "length += max(0.0, run.closes - run.opens)",
        "ranges of two groups that overlap count twice",
        (f"{CLAIMS}::test_ranges_that_overlap_count_once",),
    ),
    Mutation(
        "solver/cycles/gait.py",
        "(orbit.min_vertical_force > 0)",
        "(orbit.min_vertical_force > -1)",
        "gaits whose foot is pulled are physical",
        (f"{CLAIMS}::test_only_cycles_that_walk_count",),
    ),
)

MUTATIONS = (*SWEEPS, *POINTS, *PAGES, *STATEMENTS)
