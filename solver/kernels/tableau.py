"""The coefficients of the Runge-Kutta method with more digits than doubles have."""

from decimal import Decimal
from fractions import Fraction

from stridemap.solver.kernels.dormand_prince import digits
from stridemap.solver.kernels.step_map import BLOCK


def rests(n_rk: tuple[int, ...]) -> dict[float, float]:
    """What doubles leave out of the coefficients, and of the times at which blocks of RK steps begin.

    Parameters
    ----------
    n_rk : tuple of int
        Resolutions with such blocks.
    """
    exact = [abs(Fraction(Decimal(one))) for one in digits()]
    exact += [Fraction(i, n) for n in n_rk for i in range(BLOCK, n, BLOCK)]
    return {float(one): float(one - Fraction(float(one))) for one in exact}
