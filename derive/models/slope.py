"""What the walkers that go down a slope have in common."""

import sympy as sp

from stridemap.derive.parts import Parameter

SLOPE = Parameter(
    "slope", 0.009, "rad", "angle by which the ground falls in the walking direction", -1.5, 1.5
)


def downhill(slope: sp.Expr) -> sp.Matrix:
    """Acceleration of gravity with the x-axis along ground that falls by the angle `slope`."""
    return sp.Matrix([sp.sin(slope), -sp.cos(slope)])
