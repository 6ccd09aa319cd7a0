r"""The registry of everything that is measured on a limit cycle: one entry each.

Tables, JSON, `Orbit`, units, the report and the page of definitions read their columns, labels and meanings
here. To add a quantity, write its entry below and a function of its name in
`stridemap.solver.observables.measures`; nothing else needs an edit. A model file may declare quantities of
its own (`stridemap.derive.Measured`).
"""

from collections.abc import Mapping

from stridemap.spec import ModelSpec, Quantity

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
    Quantity("period", "time", "period", "Time from one touchdown to the next.", "T", differentiable=True),
    Quantity(
        "spectral_radius",
        "number",
        "largest multiplier",
        "Largest modulus of a Floquet multiplier; the cycle is stable below 1.",
        r"\max_i |\lambda_i|",
    ),
    Quantity(
        "multiplier_error",
        "number",
        "error of the multipliers",
        "Largest error of a Floquet multiplier, estimated from twice the resolution.",
    ),
    Quantity(
        "stable",
        "number",
        "stable",
        "Whether the largest multiplier is below 1; missing where its error does not tell.",
        type="bool",
        optional=True,
    ),
    Quantity(
        "undecided",
        "number",
        "why not known",
        "Why it is not known whether the cycle is stable; empty where it is known.",
        type="str",
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
    ),
    Quantity("speed", "speed", "speed", "Step length over period.", differentiable=True),
    Quantity(
        "d_max",
        "length",
        "largest distance d",
        "Largest distance between stance foot and zero moment point during the step; "
        "missing where the contact is lost.",
        r"\max_t |d(t)|",
    ),
    Quantity(
        "work", "energy", "work", "Integral of the absolute power of the motors over a step.", r"\int |P| dt"
    ),
    Quantity(
        "work_positive",
        "energy",
        "positive work",
        "Integral of the positive part of the motors' power over a step.",
        r"\int \max(P, 0) dt",
    ),
    Quantity(
        "work_net",
        "energy",
        "net work",
        "Integral of the motors' power over a step.",
        r"\int P dt",
        differentiable=True,
    ),
    Quantity(
        "cot",
        "number",
        "cost of transport",
        "Work, plus the energy that gravity supplies downhill, per unit of weight and step length.",
    ),
    Quantity(
        "cot_per_speed",
        "time",
        "cost per speed",
        "Work per weight and mean speed: the formula that the paper prints.",
    ),
    Quantity(
        "min_vertical_force",
        "force",
        "least ground force",
        "Smallest vertical ground force during the step; where it is negative the foot would lift.",
        r"\min_t F_y(t)",
    ),
    Quantity(
        "friction",
        "number",
        "friction needed",
        "Largest ratio of horizontal to vertical ground force; missing where the contact is lost.",
        r"\max_t |F_x / F_y|",
    ),
    Quantity(
        "clearance",
        "length",
        "foot clearance",
        "Lowest height of the swing foot; negative where it scuffs, which compass models ignore.",
    ),
    Quantity(
        "peaks", "number", "peaks", "Local maxima of the stance angle's rate within the step.", type="int"
    ),
    Quantity(
        "x_zero_crossings",
        "number",
        "zero crossings of the wobbling mass",
        "Sign changes of the wobbling mass's position within the step.",
        type="int",
        optional=True,
    ),
    Quantity(
        "wobble_amplitude",
        "length",
        "wobble amplitude",
        "Largest absolute excursion of the wobbling coordinate over the step.",
        r"\max_t |x(t)|",
        optional=True,
    ),
    Quantity(
        "touchdown_speed",
        "speed",
        "touchdown speed",
        "Speed of the swing foot just before touchdown; for a rolling foot, that of the centre of its arc.",
        differentiable=True,
    ),
    Quantity("residual", "number", "closing error", "Largest entry of the closing error."),
    Quantity(
        "state_error",
        "number",
        "error of the state",
        "Largest error of an entry of the section point or of the period, estimated from twice the "
        "resolution; in rad, and in terms of the model's own length and time.",
    ),
    Quantity(
        "integration_error",
        "number",
        "integration error",
        "Largest change of the closing error at twice the resolution.",
    ),
)

QUANTITIES: Mapping[str, Quantity] = {one.name: one for one in _ENTRIES}
"""Every quantity by name, in the order of columns and keys."""

SOLVED = ("status", "period")
"""Those that come with the solution itself; every other one has a function that measures it."""

MEASURED: tuple[str, ...] = tuple(name for name in QUANTITIES if name not in SOLVED)
"""Names of the quantities that are measured on every model, in order."""


def measured_on(spec: ModelSpec) -> dict[str, Quantity]:
    """What is measured on a model by name: the registry's quantities, then those that its file declares."""
    return {name: QUANTITIES[name] for name in MEASURED} | {one.name: one for one in spec.quantities}
