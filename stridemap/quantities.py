r"""The registry of everything that is measured on a limit cycle: one entry each.

Tables, JSON, `Orbit`, units, the report and the page of definitions read their columns, labels and meanings
here. To add a quantity, write its entry below and a function of its name in
`stridemap.solver.observables.measures`; nothing else needs an edit. Each of several motors has quantities of
its own, and a model file may declare more (`stridemap.derive.Measured`).
"""

from collections.abc import Iterator, Mapping, Sequence

from stridemap.spec import ModelSpec, Motor, Quantity

KINDS: Mapping[str, tuple[str, str]] = {
    "number": ("1", "1"),
    "angle": ("rad", "rad"),
    "mass": ("M", "kg"),
    "length": ("L", "m"),
    "time": ("sqrt(L/g)", "s"),
    "angular frequency": ("sqrt(g/L)", "rad/s"),
    "speed": ("sqrt(g L)", "m/s"),
    "acceleration": ("g", "m/s^2"),
    "force": ("M g", "N"),
    "impulse": ("M sqrt(g L)", "N s"),
    "stiffness": ("M g / L", "N/m"),
    "damping": ("M sqrt(g/L)", "N s/m"),
    "torque": ("M g L", "N m"),
    "rotational stiffness": ("M g L", "N m/rad"),
    "rotational damping": ("M g L sqrt(L/g)", "N m s/rad"),
    "moment of inertia": ("M L^2", "kg m^2"),
    "energy": ("M g L", "J"),
    "power": ("M g sqrt(g L)", "W"),
}
"""Kinds of quantities: for each its unit in the models, and its SI unit."""

_ENTRIES = (
    Quantity("status", "number", "status", "How the search for the cycle ended.", type="str"),
    Quantity(
        "period",
        "time",
        "period",
        "Time from one touchdown to the next.",
        "T",
        differentiable=True,
        over_steps="sum",
    ),
    Quantity(
        "spectral_radius",
        "number",
        "largest multiplier",
        "Largest modulus of a Floquet multiplier; the cycle is stable below 1.",
        r"\max_i |\lambda_i|",
        over_steps="cycle",
    ),
    Quantity(
        "multiplier_error",
        "number",
        "error of the multipliers",
        "Largest error of a Floquet multiplier, estimated from twice the resolution.",
        over_steps="maximum",
    ),
    Quantity(
        "stable",
        "number",
        "stable",
        "Whether the largest multiplier is below 1; missing where its error does not tell.",
        type="bool",
        optional=True,
        over_steps="cycle",
    ),
    Quantity(
        "undecided",
        "number",
        "why not known",
        "Why it is not known whether the cycle is stable; empty where it is known.",
        type="str",
        over_steps="cycle",
    ),
    Quantity(
        "group",
        "number",
        "group",
        "Solution group: whole oscillations of the spring mode in one period; A is 0, B is 1, and so on.",
        r"\lfloor \omega_s T / 2 \pi \rfloor",
        type="str",
        optional=True,
    ),
    Quantity(
        "step_length",
        "length",
        "step length",
        "Distance from the stance foot to the next.",
        differentiable=True,
        over_steps="sum",
    ),
    Quantity(
        "speed", "speed", "speed", "Step length over period.", differentiable=True, over_steps="by_time"
    ),
    Quantity(
        "d_max",
        "length",
        "largest distance d",
        "Largest absolute value during the step of the paper's distance d, from the point "
        "x_g - (F_x / F_y) y_g to the stance foot; that leaves out the change of angular momentum, so it is "
        "not where the ground force acts (cop_max); missing where the contact is lost.",
        r"\max_t |d(t)|",
        over_steps="maximum",
    ),
    Quantity(
        "cop_max",
        "length",
        "largest distance of the centre of pressure",
        "Largest distance during the step of the centre of pressure, where the ground force acts, from the "
        "stance foot's contact: 0 for a point foot without a motor or a spring at the ankle, and what a foot "
        "must reach for those; missing where the contact is lost.",
        r"\max_t |p(t)|",
        over_steps="maximum",
    ),
    Quantity(
        "work",
        "energy",
        "work",
        "Absolute work of the motors over a step: the sum over motors of the integral of the absolute value "
        "of the power, which is the torque times the rate of what it drives.",
        r"\sum_j \int |P_j| dt",
        over_steps="sum",
    ),
    Quantity(
        "work_positive",
        "energy",
        "positive work",
        "Sum over motors of the integral of the positive part of the power over a step.",
        r"\sum_j \int \max(P_j, 0) dt",
        over_steps="sum",
    ),
    Quantity(
        "work_net",
        "energy",
        "net work",
        "Sum over motors of the integral of the power over a step.",
        r"\sum_j \int P_j dt",
        differentiable=True,
        over_steps="sum",
    ),
    Quantity(
        "peak_torque",
        "torque",
        "peak torque",
        "Largest absolute torque of any motor that drives an angle during the step; 0 without one.",
        r"\max_{j, t} |u_j(t)|",
        over_steps="maximum",
    ),
    Quantity(
        "peak_power",
        "power",
        "peak power",
        "Largest sum over motors of the absolute power at one instant of the step.",
        r"\max_t \sum_j |P_j(t)|",
        over_steps="maximum",
    ),
    Quantity(
        "cot",
        "number",
        "cost of transport",
        "Energy that the motors draw (positive work over the motor's efficiency, plus the absolute value of "
        "negative work), plus the energy that gravity supplies where the step leads down, per unit of weight "
        "and absolute step length.",
        over_steps="by_length",
    ),
    Quantity(
        "cot_per_speed",
        "time",
        "cost per speed",
        "The same energy per unit of weight and absolute mean speed: the formula that the paper prints.",
        over_steps="per_speed",
    ),
    Quantity(
        "min_vertical_force",
        "force",
        "least ground force",
        "Smallest vertical ground force during the step; where it is negative the foot would lift.",
        r"\min_t F_y(t)",
        over_steps="minimum",
    ),
    Quantity(
        "friction",
        "number",
        "friction needed",
        "Largest ratio of horizontal to vertical ground force within the step, without the impulse of the "
        "impact; missing where the contact is lost.",
        r"\max_t |F_x / F_y|",
        over_steps="maximum",
    ),
    Quantity(
        "clearance",
        "length",
        "foot clearance",
        "Lowest height of the swing foot; negative where it scuffs, which compass models ignore.",
        over_steps="minimum",
    ),
    Quantity(
        "peaks",
        "number",
        "peaks",
        "Local minima within the step of the speed at which the stance leg turns over: local maxima of the "
        "stance angle's rate, where the angle is counted positive leaning back.",
        type="int",
        over_steps="sum",
    ),
    Quantity(
        "x_zero_crossings",
        "number",
        "zero crossings of the wobbling mass",
        "Sign changes of the wobbling mass's position within the step.",
        type="int",
        optional=True,
        over_steps="sum",
    ),
    Quantity(
        "wobble_amplitude",
        "length",
        "wobble amplitude",
        "Largest absolute excursion of the wobbling coordinate over the step.",
        r"\max_t |x(t)|",
        optional=True,
        over_steps="maximum",
    ),
    Quantity(
        "touchdown_speed",
        "speed",
        "touchdown speed",
        "Speed of the swing foot just before touchdown; for a rolling foot, that of the centre of its arc.",
        differentiable=True,
        over_steps="maximum",
    ),
    Quantity(
        "impact_friction",
        "number",
        "friction needed at the impact",
        "Ratio of the horizontal to the vertical impulse on the foot that touches down; missing where the "
        "ground would have to pull.",
        r"|\Lambda_x| / \Lambda_y",
        differentiable=True,
        over_steps="maximum",
    ),
    Quantity(
        "lift_off_speed",
        "speed",
        "lift-off speed",
        "Speed, away from the ground, of the foot that the impact releases, just after it.",
        differentiable=True,
        over_steps="minimum",
    ),
    Quantity(
        "trailing_lifts_off",
        "number",
        "trailing foot lifts off",
        "Whether the foot that the impact releases moves away from the ground; if not, both feet would stay "
        "on the ground, and the impact would be another one.",
        type="bool",
        over_steps="minimum",
    ),
    Quantity(
        "residual", "number", "closing error", "Largest entry of the closing error.", over_steps="maximum"
    ),
    Quantity(
        "state_error",
        "number",
        "error of the state",
        "Largest error of an entry of the section point or of the period, estimated from twice the "
        "resolution; in rad, and in terms of the model's own length and time.",
        over_steps="maximum",
    ),
    Quantity(
        "integration_error",
        "number",
        "integration error",
        "Largest change of the closing error at twice the resolution.",
        over_steps="maximum",
    ),
)

LIMIT_USE = Quantity(
    "limit_use",
    "number",
    "use of the limits",
    "Largest ratio of a motor's absolute torque or force to its declared limit during the step; above 1 "
    "the gait asks a motor for more than it can give.",
    r"\max_{j, t} |u_j(t)| / u_{j,\max}",
    over_steps="maximum",
)
"""Measured where a motor has a limit."""

QUANTITIES: Mapping[str, Quantity] = {one.name: one for one in _ENTRIES}
"""Every quantity by name, in the order of columns and keys."""

SOLVED = ("status", "period")
"""Those that come with the solution itself; every other one has a function that measures it."""

MEASURED: tuple[str, ...] = tuple(name for name in QUANTITIES if name not in SOLVED)
"""Names of the quantities that are measured on every model, in order."""


def motor_quantities(motors: Sequence[Motor]) -> tuple[Quantity, ...]:
    """What is measured of a model's motors beside the registry's quantities.

    That is the use of limits, where there are any, and what is measured on each of several motors; of one
    alone the registry says it.

    Parameters
    ----------
    motors : sequence of Motor
    """
    limits = (LIMIT_USE,) if any(motor.limit is not None for motor in motors) else ()
    return limits + tuple(quantity for motor in motors for quantity in of_motor(motor, len(motors) > 1))


def of_motor(motor: Motor, several: bool) -> Iterator[Quantity]:
    """What is measured on one motor of a model.

    Parameters
    ----------
    motor : Motor
    several : bool
        Whether the model has others.
    """
    name = motor.name
    if several:
        power = f"the power of the motor {name}"
        yield Quantity(
            f"work_{name}",
            "energy",
            f"work of {name}",
            f"Integral of the absolute value of {power} over a step.",
        )
        yield Quantity(
            f"work_positive_{name}",
            "energy",
            f"positive work of {name}",
            f"Integral of the positive part of {power} over a step.",
        )
        yield Quantity(
            f"work_net_{name}",
            "energy",
            f"net work of {name}",
            f"Integral of {power} over a step.",
            differentiable=True,
        )
    if several or motor.kind == "force":  # of which the peak torque of all motors does not speak
        yield Quantity(
            f"peak_{motor.kind}_{name}",
            motor.kind,
            f"peak {motor.kind} of {name}",
            f"Largest absolute {motor.kind} of the motor {name} during the step.",
        )
    if several:
        yield Quantity(
            f"peak_power_{name}", "power", f"peak power of {name}", f"Largest absolute value of {power}."
        )


def measured_on(spec: ModelSpec) -> dict[str, Quantity]:
    """What is measured on a model by name: the registry's quantities, the motors' own, the model file's."""
    own = (*motor_quantities(spec.motors), *spec.quantities)
    return {name: QUANTITIES[name] for name in MEASURED} | {one.name: one for one in own}
