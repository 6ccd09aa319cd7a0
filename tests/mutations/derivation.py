"""Changes of the derivation: forces, impact, ground, motors, printing and what is refused."""

from tests.mutations.mutation import Mutation

HAND = "tests/derive/test_by_hand.py"
COMPASS = f"{HAND}::test_every_function_is_as_by_hand[compass]"
WHEEL = f"{HAND}::test_every_function_is_as_by_hand[rimless_wheel]"
ROLLING = f"{HAND}::test_a_rolling_foot_has_an_acceleration_of_its_own"
DIFFERENCES = f"{HAND}::test_derivatives_are_differences"
TETHER = "tests/derive/test_motors.py::test_a_force_from_outside_reaches_coordinates_and_ground"
PRESSURE = "tests/derive/test_centre_of_pressure.py"

MECHANICS = (
    Mutation(
        "derive/models/controller.py",
        "rate = -gamma * clock.rate",
        "rate = gamma * clock.rate",
        "the desired rate of the hip has the wrong sign",
        (f"{HAND}::test_a_hip_that_moves_as_desired_feels_no_torque",),
    ),
    Mutation(
        "derive/mechanics.py",
        "terms -= sp.Matrix([self.floating_kinetic]).jacobian(self.floating_q).T",
        "terms += sp.Matrix([self.floating_kinetic]).jacobian(self.floating_q).T",
        "the velocity terms have the wrong sign in Lagrange's equations",
        (COMPASS,),
    ),
    Mutation(
        "derive/mechanics.py",
        "self.walker.v - kinetic.jacobian(self.walker.q).T",
        "self.walker.v + kinetic.jacobian(self.walker.q).T",
        "the velocity terms of a walker whose feet roll have the wrong sign",
        (ROLLING,),
    ),
    Mutation(
        "derive/mechanics.py",
        "rolling += (self.stance_jacobian * self.walker.v)",
        "rolling += 0 * (self.stance_jacobian * self.walker.v)",
        "the ground force leaves out the acceleration that a rolling foot has at constant rates",
        (ROLLING,),
    ),
    Mutation(
        "derive/mechanics.py",
        "inertia += self.floating_mass_matrix[:BASE, :BASE] * rolling",
        "inertia -= self.floating_mass_matrix[:BASE, :BASE] * rolling",
        "the ground force takes the rolling foot's acceleration backwards",
        (ROLLING,),
    ),
    Mutation(
        "derive/mechanics.py",
        "gravity = -sum(b.mass",
        "gravity = sum(b.mass",
        "gravity pulls upwards in the equations of motion",
        (WHEEL,),
    ),
    Mutation(
        "derive/mechanics.py",
        "weight = -self.walker.gravity *",
        "weight = self.walker.gravity *",
        "gravity pulls upwards in the ground force",
        (WHEEL,),
    ),
    Mutation(
        "derive/mechanics.py",
        "            + self.dissipative_force\n",
        "            - self.dissipative_force\n",
        "dampers drive the walker",
        (ROLLING,),
    ),
    Mutation(
        "derive/mechanics.py",
        "return simplified(-self.total_mass * self.walker.gravity[1])",
        "return simplified(self.total_mass * self.walker.gravity[1])",
        "the weight presses out of the ground, so that stairs up are paid for by gravity",
        (WHEEL,),
    ),
    Mutation(
        "derive/mechanics.py",
        "total += body.inertia * self.velocity(body.angle)[0] ** 2 / 2",
        "total += body.inertia * self.velocity(body.angle)[0] ** 2",
        "moments of inertia count twice",
        (WHEEL,),
    ),
)

IMPACT = (
    Mutation(
        "derive/mechanics.py",
        "- foot * rates",
        "+ foot * rates",
        "the impact holds the wrong foot",
        (WHEEL,),
    ),
    Mutation(
        "derive/mechanics.py",
        "change = self.after_release * after - self.stance_basis * self.walker.v",
        "change = self.after_release * after + self.stance_basis * self.walker.v",
        "the impulse is not the change of momentum",
        (WHEEL,),
    ),
    Mutation(
        "derive/mechanics.py",
        "return (self.swap.inv() * (self.walker.q - shift))",
        "return (self.swap.inv() * (self.walker.q + shift))",
        "a wheel's angle before touchdown is off by two spokes",
        (WHEEL,),
    ),
    Mutation(
        "derive/mechanics.py",
        "self.swing_foot.subs(before, simultaneous=True) - self.walker.stance",
        "self.swing_foot.subs(before, simultaneous=True) + self.walker.stance",
        "the step of a round foot leaves out how far the foot rolls",
        (f"{HAND}::test_the_step_of_a_round_foot_is_that_of_its_contact",),
    ),
    Mutation(
        "derive/mechanics.py",
        "return sp.Matrix(self.walker.locks).jacobian(self.walker.q) * self.swap.inv()",
        "return sp.Matrix(self.walker.locks).jacobian(self.walker.q)",
        "the impact locks the wrong leg's knee",
        (f"{HAND}::test_a_lock_stops_what_it_names_before_the_legs_swap_names",),
    ),
    Mutation(
        "derive/functions.py",
        "right - equations * constant, wrt",
        "right + equations * constant, wrt",
        "derivatives of the impact have the wrong sign",
        (DIFFERENCES,),
    ),
    Mutation(
        "derive/functions.py",
        "residual = self._force(self.mechanics.controller) - self.mechanics.mass_matrix * constant",
        "residual = self._force(self.mechanics.controller) + self.mechanics.mass_matrix * constant",
        "derivatives of the accelerations have the wrong sign of the mass matrix's",
        (DIFFERENCES,),
    ),
    Mutation(
        "derive/functions.py",
        "residual = force - m.mass_matrix * constant",
        "residual = force + m.mass_matrix * constant",
        "the matrices of a linearisation with given torques are wrong",
        (DIFFERENCES,),
    ),
)

MOTORS = (
    Mutation(
        "derive/mechanics.py",
        "return torques, jacobian.T",
        "return torques, -jacobian.T",
        "motors push the other way",
        (TETHER,),
    ),
    Mutation(
        "derive/mechanics.py",
        "- self.motor_base_jacobian.T * torques",
        "+ self.motor_base_jacobian.T * torques",
        "a cable from outside pulls at the ground's side of the balance",
        (TETHER,),
    ),
    Mutation(
        "derive/mechanics.py",
        "self.on_stance(springs) -",
        "-self.on_stance(springs) -",
        "a spring to a wall pushes the foot the other way",
        (TETHER,),
    ),
    Mutation(
        "derive/mechanics.py",
        "columns += [(torques[j], rows - divided), (first, divided)]",
        "columns += [(torques[j], rows - divided), (2 * first, divided)]",
        "a torque on a massless leg counts twice",
        ("tests/derive/test_motors.py::test_a_torque_on_a_massless_leg_is_divided_by_its_mass",),
    ),
    Mutation(
        "derive/mechanics.py",
        "simplified(carried[0] + self.walker.stance[1])",
        "simplified(carried[0])",
        "the moment about the contact leaves out how high a round foot's centre is",
        (f"{PRESSURE}::test_the_contact_of_a_built_in_walker_bears_no_moment[round_feet]",),
    ),
    Mutation(
        "derive/mechanics.py",
        "if not potential.free_symbols & stance:",
        "if True:",
        "a spring to a wall counts as a spring at the ankle",
        (f"{PRESSURE}::test_a_spring_to_a_wall_does_not_push_on_the_foot",),
    ),
    Mutation(
        "derive/turn.py",
        "senses += 1 if either[0] else -1",
        "senses += 1",
        "the sense of a wheel about the hip is not that of the other bodies",
        (f"{PRESSURE}::test_a_wheel_about_a_hip_whose_bodies_count_backwards",),
    ),
    Mutation(
        "derive/functions.py",
        "com_x - fx / fy * com_y",
        "com_x + fx / fy * com_y",
        "the paper's zero moment point is on the wrong side",
        (WHEEL,),
    ),
    Mutation(
        "derive/derived.py",
        "moving -= v.T * matrix.diff(symbol) * v / 2",
        "moving -= v.T * matrix.diff(symbol) * v",
        "the bias forces that a controller uses are not those of the equations",
        (
            "tests/derive/test_terms.py::test_derived_quantities_are_those_of_the_generated_equations[goswami_compass]",
        ),
    ),
    Mutation(
        "derive/ground.py",
        '"gravity": (level.T * walker.gravity)',
        '"gravity": (level * walker.gravity)',
        "an upright declaration walks on the opposite slope",
        ("tests/derive/test_ground.py::test_points_are_turned_and_nothing_else",),
    ),
)

TEXT = (
    Mutation(
        "derive/printers/expression.py",
        '(" - " if negative else " + ")',
        '(" + " if negative else " + ")',
        "generated code adds what it must subtract",
        (WHEEL,),
    ),
    Mutation(
        "derive/normal_form.py",
        "self._put(total, _sum(a, b), a_sine != b_sine, -product if both else product)",
        "self._put(total, _sum(a, b), a_sine != b_sine, product)",
        "the product of two sines is simplified wrongly",
        ("tests/derive/test_terms.py::test_the_normal_form_is_equal_and_what_cancels_is_gone",),
    ),
    Mutation(
        "derive/validate/names.py",
        "        _refuse_taken(walker, kind, name)\n",
        "",
        "a parameter may have the name of a column",
        ("tests/derive/validate/test_validate.py",),
    ),
    Mutation(
        "derive/validate/mechanics.py",
        "    _after_touchdown(walker, values)\n",
        "",
        "a touchdown that does not hold after it is accepted",
        ("tests/derive/validate/test_validate.py",),
    ),
    Mutation(
        "derive/validate/ground.py",
        "        if not feet:\n",
        "        if feet:\n",
        "a declaration in another frame is accepted",
        ("tests/derive/test_ground.py::test_another_frame_is_refused",),
    ),
)

STEP = "tests/derive/printers/test_c_step.py::test_what_is_generated_is_what_the_printer_writes[wobbling]"

CONTROLLER = (
    Mutation(
        "derive/printers/c_step_source.py",
        "if (rising && side < REAL(0.0))",
        "if (rising)",
        "the step in C takes the scuff at mid-stance for a touchdown",
        (STEP,),
    ),
    Mutation(
        "derive/printers/c_step_source.py",
        "static const stridemap_real WEIGHT[STAGES] = {\n    REAL(35.0)/384",
        "static const stridemap_real WEIGHT[STAGES] = {\n    REAL(36.0)/384",
        "the integrator in C has a wrong weight",
        (STEP,),
    ),
    Mutation(
        "stridemap/controller.py",
        "(rate[:, :-2:2] - rate[:, 2::2]) / 8",
        "(rate[:, :-2:2] - rate[:, 2::2]) / 4",
        "the header of a cycle states a wrong error of interpolation",
        ("tests/stridemap/test_controller.py::test_the_header_holds_the_cycle_and_the_c_walks_on_it",),
    ),
    Mutation(
        "stridemap/cli/derive.py",
        "return best if best.stable else None",
        "return best",
        "an unstable cycle is written where a stable one was asked for",
        ("tests/stridemap/test_controller.py::test_derive_writes_a_cycle",),
    ),
)

MUTATIONS = (*MECHANICS, *IMPACT, *MOTORS, *TEXT, *CONTROLLER)
