"""Changes of what is measured along a step: zeros and extrema, works, costs, motions."""

from tests.mutations.mutation import Mutation

EVENTS = "tests/solver/observables/test_events.py"
MEASURES = "tests/solver/observables/test_measures.py"
LIFTING = "wobbling-k=12.9-alpha=0.185-omega=2-beta=0.202-Kp=17.2-Kd=0.297-S=0.182-gamma=0.17-c=0"
ERRORS = "tests/solver/cycles/test_errors.py"

ZEROS = (
    Mutation(
        "solver/observables/events.py",
        "back |= ~(np.abs(g[:, :-1]) > reach[:, None])",
        "back |= ~(np.abs(g[:, :-1]) > 0 * reach[:, None])",
        "three zeros between two nodes are seen only where the function ends lower, or higher, than it began",
        (f"{EVENTS}::test_every_zero_is_found",),
    ),
    Mutation(
        "solver/observables/reductions.py",
        "reach = best - trace.h * np.abs(slope).max(axis=1)",
        "reach = best - 0 * trace.h",
        "extrema are looked for beside the best node only",
        (f"{EVENTS}::test_a_turning_point_beside_low_nodes_may_be_the_highest",),
    ),
    Mutation(
        "solver/observables/events.py",
        "turn = (left * s_left < 0) & (right * s_right > 0)",
        "turn = (left != left) & (right * s_right > 0)",
        "two zeros between two nodes are not seen",
        (f"{EVENTS}::test_every_zero_is_found",),
    ),
    Mutation(
        "solver/observables/events.py",
        "chosen = np.isfinite(tau).all(axis=1) & crosses",
        "chosen = np.zeros(len(tau), dtype=bool)",
        "three zeros between two nodes are taken for one",
        (f"{EVENTS}::test_every_zero_is_found",),
    ),
    Mutation(
        "solver/observables/events.py",
        "        change[orbit, node] = False\n",
        "",
        "three zeros between two nodes are counted as four",
        (f"{EVENTS}::test_every_zero_is_found",),
    ),
    Mutation(
        "solver/observables/events.py",
        "f = dg if derivative else g\n    k, part",
        "f = g\n    k, part",
        "two turning points between two nodes are not seen",
        (f"{EVENTS}::test_every_turning_point_is_found",),
    ),
    Mutation(
        "solver/observables/events.py",
        "change = below[:, :-1] != below[:, 1:]",
        "change = below[:, :-1] & ~below[:, 1:]",
        "falling zeros are not seen",
        (f"{EVENTS}::test_every_zero_is_found",),
    ),
    Mutation(
        "solver/observables/events.py",
        "LOCATE_TOLERANCE = 1e-5",
        "LOCATE_TOLERANCE = 1e-2",
        "extrema are read off a hundredth of a step beside",
        (f"{EVENTS}::test_every_turning_point_is_found",),
    ),
    Mutation(
        "solver/observables/events.py",
        "order = np.lexsort((columns[0], node, orbit))",
        "order = np.lexsort((-columns[0], node, orbit))",
        "zeros between two nodes are not in the order of time",
        (f"{EVENTS}::test_every_zero_is_found",),
    ),
    Mutation(
        "solver/walks/events.py",
        "        if turns:\n",
        "        if False:\n",
        "the simulator overlooks a touchdown that begins and ends between two samples",
        ("tests/solver/walks/test_events.py",),
    ),
    Mutation(
        "solver/walks/events.py",
        "if rising and side < 0:",
        "if side < 0:",
        "a foot that leaves the ground is a touchdown",
        ("tests/solver/walks/test_events.py",),
    ),
)

MEASURED = (
    Mutation(
        "solver/observables/reductions.py",
        "+ gain >= best[orbit]",
        "+ gain < best[orbit]",
        "extrema between nodes do not count",
        (f"{EVENTS}::test_extremes_over_continuous_time_and_at_the_ends",),
    ),
    Mutation(
        "solver/observables/reductions.py",
        "0.5 * (absolute + net)",
        "0.5 * (absolute - net)",
        "the positive work is that which is done on the motors",
        (f"{MEASURES}::test_work_agrees_with_quadrature[wobbling-k=6]",),
    ),
    Mutation(
        "solver/observables/reductions.py",
        "    kinks = brackets(trace, observable)\n",
        "    kinks = brackets(trace, observable).take(slice(0))\n",
        "the power's changes of sign do not part the work",
        (f"{MEASURES}::test_work_agrees_with_quadrature[wobbling-k=6]",),
    ),
    Mutation(
        "solver/observables/reductions.py",
        "return (found.node == last) & near_zero & (found.upper == trace.h[found.orbit])",
        "return found.node == last",
        "an early touchdown in the last interval is taken for the touchdown",
        (f"{EVENTS}::test_a_touchdown_before_the_end_of_the_step_is_early",),
    ),
    Mutation(
        "solver/observables/reductions.py",
        "rising = found.take(found.f_lower < found.f_upper)",
        "rising = found.take(found.f_lower > found.f_upper)",
        "early touchdowns are looked for where the foot leaves the ground",
        (f"{EVENTS}::test_a_touchdown_before_the_end_of_the_step_is_early",),
    ),
    Mutation(
        "solver/observables/measures.py",
        "out[known] = (radius < 1.0)[known].tolist()",
        "out[known] = (radius < 1.1)[known].tolist()",
        "cycles with multipliers up to 1.1 are called stable",
        (f"{ERRORS}::test_what_is_known_of_a_radius",),
    ),
    Mutation(
        "solver/observables/measures.py",
        "known = np.abs(radius - 1.0) > error",
        "known = np.abs(radius - 1.0) >= 0 * error",
        "stability is decided within the error",
        (f"{ERRORS}::test_what_is_known_of_a_radius",),
    ),
    Mutation(
        "solver/observables/measures.py",
        'step["length"] - self.weights["press"] * step["rise"]',
        'step["length"] + self.weights["press"] * step["rise"]',
        "stairs up cost nothing",
        ("tests/derive/test_motors.py::test_stairs_cost_the_rise",),
    ),
    Mutation(
        "solver/observables/measures.py",
        'cost: Array = cycles.energy / (cycles.weights["weight"] * np.abs(cycles["step_length"]))',
        'cost: Array = cycles.energy / (cycles.weights["weight"] * cycles["step_length"])',
        "a walker that goes the other way has a negative cost of transport",
        ("tests/derive/test_motors.py::test_a_wheel_costs_the_sine_of_the_slope_whichever_way_it_goes",),
    ),
    Mutation(
        "solver/observables/measures.py",
        "(positive / share + (self.works.absolute - positive))",
        "(positive * share + (self.works.absolute - positive))",
        "a motor with losses draws less than one without",
        ("tests/derive/test_motors.py::test_losses_limits_and_cost",),
    ),
    Mutation(
        "solver/observables/measures.py",
        "ratio = np.abs(impulse[:, 0]) / impulse[:, 1]",
        "ratio = np.abs(impulse[:, 1]) / impulse[:, 0]",
        "the friction at the impact is the inverse of what it is",
        ("tests/solver/observables/test_impact_measures.py::test_a_wheel_with_its_mass_at_the_hub",),
    ),
    Mutation(
        "solver/observables/measures.py",
        "speed: Array = -landed[:, 1]",
        "speed: Array = landed[:, 1]",
        "the trailing foot is reported to stay down where it lifts off",
        ("tests/solver/observables/test_impact_measures.py::test_a_wheel_with_its_mass_at_the_hub",),
    ),
    Mutation(
        "solver/observables/measures.py",
        'falls = cycles.end["q"][:, index] < cycles.start["q"][:, index]',
        'falls = cycles.end["q"][:, index] > cycles.start["q"][:, index]',
        "minima of the leg's speed are counted where it is fastest",
        (f"{MEASURES}::test_peaks_and_crossings_agree_with_brute_force[wobbling-k=6]",),
    ),
    Mutation(
        "solver/observables/measures.py",
        'np.where(self["min_vertical_force"] > 0, values, np.nan)',
        'np.where(self["min_vertical_force"] > -9, values, np.nan)',
        "friction is reported where the foot lifts",
        (f"{MEASURES}::test_extremes_agree_with_brute_force[{LIFTING}]",),
    ),
    Mutation(
        "solver/observables/peak_power.py",
        "-1.0 if sign != pattern[0] else 1.0",
        "1.0 if sign != pattern[0] else 1.0",
        "powers of motors that work against each other cancel in their peak",
        ("tests/solver/observables/test_peak_power.py",),
    ),
    Mutation(
        "solver/observables/over_steps.py",
        'weights = {"by_length": np.abs(lengths), "by_time": periods}',
        'weights = {"by_length": lengths, "by_time": periods}',
        "the cost of a cycle of two steps is less where one of them leads back",
        ("tests/solver/observables/test_over_steps.py",),
    ),
    Mutation(
        "solver/observables/motion.py",
        "tau = t[at].ravel() - node * trace.h[orbit]",
        "tau = t[at].ravel() - (node + 1) * trace.h[orbit]",
        "motions are sampled a node too late",
        ("tests/solver/observables/test_motion.py::test_states_are_those_of_another_integrator[compass]",),
    ),
    Mutation(
        "solver/observables/motion.py",
        "np.tile(np.linspace(0, 1, samples), len(at))",
        "np.repeat(np.linspace(0, 1, samples), len(at))",
        "motions of many cycles are sampled from wrong nodes",
        ("tests/solver/observables/test_motion.py::test_many_are_what_each_is_alone",),
    ),
    Mutation(
        "solver/observables/motion.py",
        "astype(np.int64), n - 1)",
        "astype(np.int64) // 4 * 4, n - 1)",
        "motions are sampled in steps four times as large as the integrator's",
        ("tests/solver/observables/test_motion.py::test_states_are_those_of_another_integrator[compass]",),
    ),
)

MUTATIONS = (*ZEROS, *MEASURED)
