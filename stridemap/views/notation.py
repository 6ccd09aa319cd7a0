"""Symbols, units and meanings of what the report shows."""

import re
from collections.abc import Mapping
from dataclasses import dataclass

_NAMES = "alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi rho sigma tau phi chi psi omega"
_GREEK = dict(zip(_NAMES.split(), "αβγδεζηθκλμνξρστφχψω", strict=True))
_SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_DOT = "\u0307"


@dataclass(frozen=True)
class Quantity:
    """A column of the table of orbits as it is shown.

    Parameters
    ----------
    label : str
        What it is, in a few words.
    kind : str
        A name of `units`; empty for a pure number.
    meaning : str
        The definition in one sentence.
    """

    label: str
    kind: str = ""
    meaning: str = ""


MEASURES = {
    "spectral_radius": Quantity(
        "largest multiplier", "", "Largest modulus of a Floquet multiplier; the cycle is stable below 1."
    ),
    "period": Quantity("period T", "time", "Time from one touchdown to the next."),
    "step_length": Quantity("step length", "length", "Distance from the stance foot to the next."),
    "speed": Quantity("speed", "speed", "Step length over period."),
    "d_max": Quantity(
        "d_max", "length", "Largest distance between stance foot and zero moment point during the step."
    ),
    "work": Quantity("work", "energy", "Integral of the absolute power of the motors over a step."),
    "work_positive": Quantity(
        "positive work", "energy", "Integral of the positive part of the motors' power."
    ),
    "work_net": Quantity("net work", "energy", "Integral of the motors' power over a step."),
    "cot": Quantity("cost of transport", "", "Work per weight and step length."),
    "cot_per_speed": Quantity(
        "cost per speed", "time", "Work per weight and mean speed, the formula that the paper prints."
    ),
    "min_vertical_force": Quantity(
        "least ground force",
        "force",
        "Smallest vertical ground force; where it is negative the foot would lift.",
    ),
    "friction": Quantity("friction needed", "", "Largest ratio of horizontal to vertical ground force."),
    "clearance": Quantity(
        "foot clearance", "length", "Lowest height of the swing foot; negative where it scuffs."
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


def units(names: Mapping[str, str]) -> dict[str, str]:
    """Return the units of all kinds of quantities, as they are printed.

    Parameters
    ----------
    names : mapping
        What a model calls its units of mass, length, time and energy.
    """
    time = printed(names["time"])
    scaled = time == "√(L/g)"  # in units of gravity and leg length, or in units of their own
    per_length = f"{names['energy']}/{names['length']}"
    return {
        "": "",
        "mass": names["mass"],
        "length": names["length"],
        "time": time,
        "energy": names["energy"],
        "speed": "√(g L)" if scaled else f"{names['length']}/{time}",
        "force": f"{names['mass']} g" if scaled else "N" if per_length == "J/m" else per_length,
    }


def printed(unit: str) -> str:
    """Return a unit of a manifest as it is printed: with a root sign, and empty for a pure number."""
    return "" if unit == "1" else unit.replace("sqrt(", "√(")


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
