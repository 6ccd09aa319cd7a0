"""One fixed step of the explicit Runge-Kutta method of order 8 with 12 stages.

The tableau is Dormand and Prince's (`dormand_prince`). A fixed step keeps the flow a smooth, branch-free
function of state and step, which is what Newton's method and exact derivatives need.
"""

from collections.abc import Callable, Sequence
from typing import Any

import casadi as ca

from stridemap.solver.kernels.dormand_prince import STAGES, tableau

_A, _B = tableau()


def rk_step(rate: Callable[[Any, ca.SX], ca.SX], times: Sequence[Any], y: ca.SX, h: ca.SX) -> ca.SX:
    """Advance ``dy/dt = rate(t, y)`` by one step.

    Parameters
    ----------
    rate : callable
        Maps time and y to dy/dt, of y's shape.
    times : sequence, length STAGES
        Times of the stages, at ``t + NODES[i] h`` (`dormand_prince`), in whatever form `rate` takes them.
    h : casadi.SX, scalar
        Step size.
    y : casadi.SX
        State, of any shape.

    Returns
    -------
    casadi.SX
        State at ``t + h``.
    """
    slopes: list[ca.SX] = []
    for i in range(STAGES):
        stage = y + sum(
            (h * _A[i, j] * slopes[j] for j in range(i) if _A[i, j] != 0.0), ca.SX.zeros(*y.shape)
        )
        slopes.append(rate(times[i], stage))
    return y + sum((h * _B[i] * slopes[i] for i in range(STAGES) if _B[i] != 0.0), ca.SX.zeros(*y.shape))
