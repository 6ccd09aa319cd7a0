"""Changes of boundaries in two parameters, and of gaits of several steps."""

from tests.mutations.mutation import Mutation

ENDS = "tests/solver/branches/test_ends.py"
CODIM2 = "tests/solver/boundaries/test_codim2.py"

MUTATIONS = (
    Mutation(
        "solver/boundaries/systems.py",
        "-float(values[-1]), -psi @ equations.second(x, along, n_rk)",
        "-float(values[-1]), psi @ equations.second(x, along, n_rk)",
        "a multiplier is led away from the unit circle",
        (f"{CODIM2}::test_the_folds_of_henon",),
    ),
    Mutation(
        "solver/boundaries/systems.py",
        "turn = null.psi @ (1j * root * wrap(self.equations)) @ null.w",
        "turn = -null.psi @ (1j * root * wrap(self.equations)) @ null.w",
        "the angle of a torus is corrected the wrong way",
        (f"{CODIM2}::test_angles_of_resonances",),
    ),
    Mutation(
        "solver/boundaries/codim2.py",
        "flip = float(np.prod(others + curve.multiplier).real)",
        "flip = float(np.prod(others - curve.multiplier).real)",
        "a fold-flip is looked for where a multiplier is double",
        (f"{CODIM2}::test_a_fold_flip",),
    ),
    Mutation(
        "solver/boundaries/codim2.py",
        "return float(null.psi @ (third / 6 + mixed))",
        "return float(null.psi @ (third / 6 - mixed))",
        "quadratic terms count the wrong way for a doubling's side",
        (f"{CODIM2}::test_a_generalised_doubling",),
    ),
    Mutation(
        "solver/boundaries/codim2.py",
        "limit = np.pi if theta >= np.pi else 0.0",
        "limit = 0.0 if theta >= np.pi else np.pi",
        "a torus is said to end at the other resonance",
        (f"{CODIM2}::test_a_torus_ends_at_resonances",),
    ),
    Mutation(
        "solver/branches/conditions.py",
        "each[below[~just]] = np.inf",
        "each[below[~just]] *= 1.0",
        "a foot that is below the ground from the beginning counts as one that touches down early",
        (f"{ENDS}::test_early_touchdowns_are_those_that_the_acceptance_sees",),
    ),
    Mutation(
        "solver/cycles/several_steps.py",
        "np.append(steps[0, :-1], steps[:, -1].sum())",
        "np.append(steps[0, :-1], steps[0, -1])",
        "the period of a gait of several steps is that of its first",
        ("tests/solver/cycles/test_orbits_of_several_steps.py::test_the_stable_gait_of_three_steps",),
    ),
)
