"""Derivation: a walker's declaration becomes equations, and equations become readable code.

Data flows one way through this package: a model (`models/`) is a declaration (`declaration`);
`mechanics` turns it into equations from the floating base; `functions` names each quantity that is
emitted, as a straight-line `program`; `print_c` and `print_python` print that program; `emit` writes
the files. Only SymPy is used here.
"""
