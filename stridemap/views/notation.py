"""How names and units are written: as symbols, in plain text and in LaTeX."""

import re

from stridemap.columns import SCALED, unit_of
from stridemap.quantities import KINDS
from stridemap.spec import ModelSpec, UnitNames

_NAMES = "alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi rho sigma tau phi chi psi omega"
_GREEK = dict(zip(_NAMES.split(), "αβγδεζηθκλμνξρστφχψω", strict=True))
_SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_DOT = "\u0307"


# -- units ---------------------------------------------------------------------------------------------------


def units(names: UnitNames) -> dict[str, str]:
    """Units of all kinds of quantities as they are printed, by kind; see `printed`."""
    return {kind: printed(unit_of(kind, names)) for kind in KINDS}


def printed(unit: str) -> str:
    """A unit of a specification as it is printed: with a root sign, and empty for a pure number."""
    return "" if unit == "1" else unit.replace("sqrt(", "√(")


def latex_unit(unit: str, names: UnitNames) -> str:
    """A unit of a specification in LaTeX: quantities that serve as units in italics, names of units upright.

    Parameters
    ----------
    unit : str
    names : UnitNames
        Of the model.
    """
    if unit == "1":
        return "–"
    italic = {names.mass, names.length, "g"} if names.time == SCALED else set()
    words = re.sub(r"\bsqrt\(([^)]*)\)", r"\\sqrt{\1}", unit)
    words = re.sub(r"\s*/\s*", "/", words)
    words = re.sub(r"\s*\*\s*|\s+", r"\\,", words)
    words = re.sub(r"\^(-?\d{2,}|-\d)", r"^{\1}", words)
    words = re.sub(
        r"(?<![\\A-Za-z])[A-Za-z]+", lambda m: m[0] if m[0] in italic else rf"\mathrm{{{m[0]}}}", words
    )
    return f"${words}$"


def latex_axis(label: str, unit: str, names: UnitNames) -> str:
    """Text of an axis: a label and its unit in brackets."""
    return f"{label}  [{latex_unit(unit, names)}]"


# -- symbols -------------------------------------------------------------------------------------------------


def symbol(name: str) -> str:
    """A name as it is written in formulas: ``theta1`` as the Greek letter with a subscript.

    Parameters
    ----------
    name : str
        Of a parameter or a coordinate.
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
    """The symbol of a coordinate's rate."""
    shown = symbol(name)
    return shown[0] + _DOT + shown[1:] if shown != name or len(name) == 1 else f"d{name}"


def latex_symbol(name: str, rate: bool = False) -> str:
    r"""A name in LaTeX: ``theta1`` is ``\theta_{1}``, and its rate ``\dot{\theta}_{1}``.

    Parameters
    ----------
    name : str
        Of a parameter or a coordinate.
    rate : bool
        Whether its time derivative is meant.
    """
    match = re.fullmatch(r"([A-Za-z]+?)(\d*)", name)
    word, digits = match.groups() if match else (name, "")
    if word in _GREEK:
        word = rf"\{word}"
    elif len(word) > 1:
        word = rf"\mathrm{{{word}}}".replace("_", r"\_")
    return (rf"\dot{{{word}}}" if rate else word) + (f"_{{{digits}}}" if digits else "")


def state_labels(spec: ModelSpec) -> dict[str, tuple[str, str]]:
    """Symbol, and unit in brackets, of each coordinate and then of each rate, by name, in LaTeX."""
    out = {}
    for coordinate in spec.coordinates:
        unit = latex_unit(coordinate.unit, spec.units)
        out[coordinate.name] = (f"${latex_symbol(coordinate.name)}$", f"[{unit}]")
    for coordinate in spec.coordinates:
        unit = latex_unit(coordinate.rate_unit, spec.units)
        out[f"d{coordinate.name}"] = (f"${latex_symbol(coordinate.name, rate=True)}$", f"[{unit}]")
    return out


def time_label(spec: ModelSpec) -> str:
    """Text of an axis of time."""
    return latex_axis("time  $t$", spec.units.time, spec.units)
