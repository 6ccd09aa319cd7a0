"""The functions and powers that generated code has a form for; a leaf, for what checks and what prints."""

import sympy as sp

CALLS = {
    f: f.__name__
    for f in (sp.sin, sp.cos, sp.tan, sp.asin, sp.acos, sp.atan, sp.sinh, sp.cosh, sp.tanh, sp.exp, sp.log)
}
"""Functions that C's math library, NumPy, CasADi and mpmath all have under the same name."""

HIGHEST_POWER = 8
"""Powers are written as products up to this one."""
