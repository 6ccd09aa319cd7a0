"""Mass matrix and bias forces of a planar tree of links by the recursive Newton-Euler equations.

It reads the table of links of `benchmarks.chain` and numbers, and nothing of `derive`. From the stance foot
outwards it works out accelerations, and from the outermost links back to the foot the forces in the joints
(L. Y. S. Luh, M. W. Walker, R. P. C. Paul, J. Dyn. Syst. Meas. Control 102 (1980) 69-76). The bias forces are
what it gives without acceleration, and each column of the mass matrix what it gives for one unit of
acceleration, at rest and without gravity.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from benchmarks.chain import Link, from_joint


def mass_matrix_and_bias(
    chain: Sequence[Link],
    coordinates: str,
    q: Sequence[Any],
    v: Sequence[Any],
    p: Mapping[str, Any],
    functions: Any = np,
) -> tuple[list[list[Any]], list[Any]]:
    """Columns of the mass matrix, and velocity terms with gravity, on the left-hand side.

    Parameters
    ----------
    chain : sequence of Link
    coordinates : {"absolute", "relative"}
    q, v : sequence
        Angles and their rates: numbers, arrays, or whatever else can be added and multiplied.
    p : mapping of str to number
        Parameters, called as in the declaration.
    functions : module, optional
        Where `sin` and `cos` come from.
    """
    n = len(chain)
    angles, rates = _absolute(chain, coordinates, q), _absolute(chain, coordinates, v)
    upright = [(-functions.sin(a), functions.cos(a)) for a in angles]
    columns = []
    for j in range(n):
        unit = [int(i == j) for i in range(n)]
        at_rest = _forces(chain, coordinates, upright, [0] * n, _absolute(chain, coordinates, unit), p, 0)
        columns.append(at_rest)
    return columns, _forces(chain, coordinates, upright, rates, [0] * n, p, p["g"])


def _absolute(chain: Sequence[Link], coordinates: str, values: Sequence[Any]) -> list[Any]:
    """Angles from the vertical, or their rates."""
    found: list[Any] = []
    for link, value in zip(chain, values, strict=True):
        relative = coordinates == "relative" and link.carrier >= 0
        found.append(found[link.carrier] + value if relative else value)
    return found


def _forces(
    chain: Sequence[Link],
    coordinates: str,
    upright: Sequence[tuple[Any, Any]],
    rates: Sequence[Any],
    accelerations: Sequence[Any],
    p: Mapping[str, Any],
    gravity: Any,
) -> list[Any]:
    """Generalised force for each coordinate that makes the links move as given."""
    n = len(chain)
    moved: list[tuple[Any, Any]] = []  # acceleration of each link's far end; the ground's is upwards
    own: list[tuple[Any, Any]] = []  # force that each link's own mass needs
    arms: list[tuple[Any, Any]] = []  # from its joint to its far end
    moments: list[Any] = []  # about its joint
    for link, (ux, uy), w, a in zip(chain, upright, rates, accelerations, strict=True):
        sign, square = 1 if link.up else -1, w * w
        mass, inertia, length = p[f"m_{link.part}"], p[f"i_{link.part}"], p.get(f"l_{link.part}", 0)
        centre = from_joint(link, length, p[f"c_{link.part}"])
        # Per unit of length from the joint: along the link inwards, and across it.
        x, y = sign * (a * -uy - square * ux), sign * (a * ux - square * uy)
        jx, jy = moved[link.carrier] if link.carrier >= 0 else (0, gravity)
        fx, fy = mass * (jx + centre * x), mass * (jy + centre * y)
        moments.append(inertia * a + sign * centre * (ux * fy - uy * fx))
        own.append((fx, fy))
        moved.append((jx + length * x, jy + length * y))
        arms.append((sign * length * ux, sign * length * uy))
    torques = list(moments)
    total = list(own)
    for i in reversed(range(n)):
        j = chain[i].carrier
        if j >= 0:
            (fx, fy), (rx, ry) = total[i], arms[j]
            total[j] = (total[j][0] + fx, total[j][1] + fy)
            moment = rx * fy - ry * fx
            # A joint's torque carries all links beyond it; an angle from the vertical turns one link alone.
            torques[j] = torques[j] + moment + (torques[i] if coordinates == "relative" else 0)
    return torques


class Counted:
    """A number of a straight-line program that counts its operations, each different one once.

    Zeros and ones cost nothing, and neither does a change of sign.
    """

    def __init__(self, steps: dict[Any, "Counted"], key: Any) -> None:
        self.steps, self.key = steps, key

    def _step(self, operation: str, *of: Any) -> "Counted":
        names = [x.key if isinstance(x, Counted) else x for x in of]
        if operation in "+*":
            names.sort(key=repr)
        key = (operation, *names)
        if key not in self.steps:
            self.steps[key] = Counted(self.steps, f"s{len(self.steps)}")
        return self.steps[key]

    def __neg__(self) -> "Counted":
        return Negative(self)

    def __add__(self, other: Any) -> Any:
        if _is(other, 0):
            return self
        return self - other.of if isinstance(other, Negative) else self._step("+", self, other)

    def __sub__(self, other: Any) -> Any:
        if _is(other, 0):
            return self
        return self + other.of if isinstance(other, Negative) else self._step("-", self, other)

    def __rsub__(self, other: Any) -> Any:
        return -self if _is(other, 0) else self._step("-", other, self)

    def __mul__(self, other: Any) -> Any:
        if _is(other, 0):
            return 0
        if _is(other, 1):
            return self
        if _is(other, -1):
            return -self
        return -(self * other.of) if isinstance(other, Negative) else self._step("*", self, other)

    __radd__, __rmul__ = __add__, __mul__


class Negative(Counted):
    """The negative of a number."""

    def __init__(self, of: Counted) -> None:
        super().__init__(of.steps, f"-{of.key}")
        self.of = of

    def __neg__(self) -> Counted:
        return self.of

    def __add__(self, other: Any) -> Any:
        return self if _is(other, 0) else other - self.of

    def __sub__(self, other: Any) -> Any:
        return self if _is(other, 0) else -(self.of + other)

    def __rsub__(self, other: Any) -> Any:
        return other + self.of

    def __mul__(self, other: Any) -> Any:
        if _is(other, 0):
            return 0
        return -(self.of * other)

    __radd__, __rmul__ = __add__, __mul__


def _is(value: Any, number: int) -> bool:
    return isinstance(value, int) and value == number


class _Calls:
    """Sines and cosines that are counted."""

    @staticmethod
    def sin(x: Counted) -> Counted:
        return x._step("sin", x)

    @staticmethod
    def cos(x: Counted) -> Counted:
        return x._step("cos", x)


def operations(chain: Sequence[Link], coordinates: str, names: Sequence[str]) -> int:
    """Multiplications, additions, sines and cosines of `mass_matrix_and_bias`, equal ones counted once.

    Parameters
    ----------
    chain : sequence of Link
    coordinates : {"absolute", "relative"}
    names : sequence of str
        Names of the parameters.
    """
    steps: dict[Any, Counted] = {}
    n = len(chain)
    q, v = ([Counted(steps, f"{letter}{i}") for i in range(n)] for letter in "qv")
    mass_matrix_and_bias(chain, coordinates, q, v, {k: Counted(steps, k) for k in names}, _Calls)
    return len(steps)
