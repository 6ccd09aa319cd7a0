"""Derivation: a walker's declaration becomes equations, and equations become readable code.

Data flows one way through this package. A model (`models/`, or a file of your own) is a `Walker` (`walker`):
a `declaration` made of `parts` that `validate` has found sound. `mechanics` turns it into equations from the
floating base; `functions` names each quantity that is emitted, as a straight-line `program`; `printers` print
that program, one language each; `emit` puts the files together. Only SymPy is used here.

The names below are what a model file needs.
"""

from typing import Any

from stridemap.derive.derived import solve
from stridemap.derive.parts import (
    SI,
    STANCE_FOOT,
    TIME,
    Body,
    Clock,
    Coordinate,
    Line,
    Massless,
    Measured,
    Motor,
    Parameter,
    Touchdown,
    rolling_arc,
)
from stridemap.derive.terms import Term
from stridemap.derive.walker import Walker
from stridemap.spec import UnitNames

__all__ = [
    "SI",
    "STANCE_FOOT",
    "TIME",
    "Body",
    "Clock",
    "Coordinate",
    "Line",
    "Massless",
    "Measured",
    "Motor",
    "Parameter",
    "Term",
    "Touchdown",
    "UnitNames",
    "Walker",
    "rolling_arc",
    "solve",
]


def __getattr__(name: str) -> Any:
    if name == "Units":
        raise ImportError("stridemap.derive.Units is called UnitNames now")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
