"""Derivation: a walker's declaration becomes equations, and equations become readable code.

Data flows one way through this package: a model (`models/`, or a file of your own) is a declaration
(`declaration`), which is checked (`checks`, `trials`); `mechanics` turns it into equations from the
floating base; `functions` names each quantity that is emitted, as a straight-line `program`; `print_c` and
`print_python` print that program; `emit` writes the files. Only SymPy is used here.

The names below are what a model file needs.
"""

from stridemap.derive.walker import (
    SI,
    STANCE_FOOT,
    TIME,
    Body,
    Clock,
    Coordinate,
    Line,
    Massless,
    Parameter,
    Touchdown,
    Units,
    Walker,
    rolling_arc,
)

__all__ = [
    "SI",
    "STANCE_FOOT",
    "TIME",
    "Body",
    "Clock",
    "Coordinate",
    "Line",
    "Massless",
    "Parameter",
    "Touchdown",
    "Units",
    "Walker",
    "rolling_arc",
]
