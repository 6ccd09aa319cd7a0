"""Symbols, units and meanings of what the report shows, in the units M, L and sqrt(L/g)."""

import re
from dataclasses import dataclass

_GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η", "theta": "θ",
    "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "rho": "ρ", "sigma": "σ", "tau": "τ", "phi": "φ",
    "chi": "χ", "psi": "ψ", "omega": "ω",
}  # fmt: skip
_SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_DOT = "\u0307"


@dataclass(frozen=True)
class Quantity:
    """A column of the table of orbits as it is shown.

    Parameters
    ----------
    label : str
        What it is, in a few words.
    unit : str
        Empty for a pure number.
    meaning : str
        The definition in one sentence.
    """

    label: str
    unit: str = ""
    meaning: str = ""


MEASURES = {
    "spectral_radius": Quantity(
        "largest multiplier", "", "Largest modulus of a Floquet multiplier; the cycle is stable below 1."
    ),
    "period": Quantity("period T", "√(L/g)", "Time from one touchdown to the next."),
    "step_length": Quantity("step length", "L", "Distance from the stance foot to the next."),
    "speed": Quantity("speed", "√(g L)", "Step length over period."),
    "d_max": Quantity(
        "d_max", "L", "Largest distance between stance foot and zero moment point during the step."
    ),
    "work": Quantity("work", "M g L", "Integral of the absolute power of the hip over a step."),
    "work_positive": Quantity("positive work", "M g L", "Integral of the positive part of the hip's power."),
    "work_net": Quantity("net work", "M g L", "Integral of the hip's power; what the impact takes."),
    "cot": Quantity("cost of transport", "", "Work per weight and step length."),
    "cot_per_speed": Quantity(
        "cost per speed", "√(L/g)", "Work per weight and mean speed, the formula that the paper prints."
    ),
    "min_vertical_force": Quantity(
        "least ground force",
        "M g",
        "Smallest vertical ground force; where it is negative the foot would lift.",
    ),
    "friction": Quantity("friction needed", "", "Largest ratio of horizontal to vertical ground force."),
    "clearance": Quantity(
        "foot clearance", "L", "Lowest height of the swing foot; negative where it scuffs."
    ),
    "peaks": Quantity("peaks", "", "Local maxima of the stance angle's rate within the step."),
    "x_zero_crossings": Quantity(
        "crossings of x", "", "Sign changes of the wobbling mass's position within the step."
    ),
    "residual": Quantity("closing error", "", "Largest entry of the closing error when the cycle was found."),
    "integration_error": Quantity(
        "integration error", "", "Change of the closing error at twice the resolution."
    ),
    "status": Quantity("status", "", "How the search for the cycle ended."),
    "stable": Quantity("stable", "", "Whether the largest multiplier is below 1."),
    "group": Quantity(
        "group", "", "Whole oscillations of the spring mode in one period: A is 0, B is 1, ..."
    ),
}
"""Known columns; a column that is not here is shown under its own name."""


def symbol(name: str) -> str:
    """Return a name as it is written in formulas: ``dtheta1`` as the dotted theta with a subscript.

    Parameters
    ----------
    name : str
        Of a parameter, a coordinate, or with a leading ``d`` of a coordinate's rate.
    """
    match = re.fullmatch(r"([A-Za-z]+?)(\d*)", name)
    if match is None:
        return name
    word, digits = match.groups()
    if word in _GREEK:
        return _GREEK[word] + digits.translate(_SUBSCRIPTS)
    if len(word) == 1:
        return word + digits.translate(_SUBSCRIPTS)
    return name


def rate_symbol(name: str) -> str:
    """Return the symbol of a coordinate's rate."""
    shown = symbol(name)
    return shown[0] + _DOT + shown[1:] if shown != name or len(name) == 1 else f"d{name}"
