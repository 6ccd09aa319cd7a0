"""What is known of a bifurcation of cycles on a curve."""

from dataclasses import dataclass
from enum import StrEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


class SpecialType(StrEnum):
    """What happens at a special point."""

    FOLD = "fold"
    PD = "pd"
    NS = "ns"
    BP = "bp"


@dataclass(frozen=True)
class Special:
    """A special point.

    Parameters
    ----------
    type : SpecialType
    x : ndarray, shape (N + 1,)
        Unknowns of the chain, and the parameter.
    multipliers : ndarray of complex, shape (nz,)
    null : ndarray, shape (N,) or (N + 1,)
        The direction that neither grows nor shrinks, in the unknowns of all steps; of a branch point, the
        second tangent, with that of the parameter.
    residual : float
        Largest entry of its defining system.
    slope : float
        Change along the branch, per unit of arclength, of what passes through a value there: of a doubling's
        multiplier, of the modulus of a torus's; of a fold, of the parameter's share in the tangent. A special
        point whose slope is not zero is truly crossed.
    multiplier : complex
        The one that crosses the unit circle.
    direction : float
        Change of the parameter per unit of arclength.
    border : Border or None
        Of its system, if that is bordered.
    """

    type: SpecialType
    x: Array
    multipliers: Complex
    null: NDArray[np.complex128] | Array
    residual: float
    slope: float
    multiplier: complex
    direction: float
    border: "Border | None" = None


@dataclass(frozen=True)
class Border:
    """What Newton's method on a bordered system can begin with anew, at another resolution.

    Parameters
    ----------
    b, c : ndarray, shape (N,)
    gradient : ndarray, shape (N + 1,)
        Of g.
    """

    b: NDArray[Any]
    c: NDArray[Any]
    gradient: NDArray[Any]
