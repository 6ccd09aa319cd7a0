"""How a walker's coordinates change when all of it turns about a point, as one rigid body.

Angular momentum is the momentum of this motion. Internal forces do no work in it, so what torques, springs
and dampers do work with here acts between the walker and the ground.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from stridemap.derive.declaration import Declaration
from stridemap.derive.derived import solve
from stridemap.derive.parts import STANCE_FOOT
from stridemap.derive.simplify import simplified
from stridemap.derive.trials import in_numbers, trial_points

Array = NDArray[np.float64]

TRIALS = 5
"""Positions at which the turn is computed in numbers, to see what form it has."""

TOLERANCE = 1e-9


@dataclass(frozen=True)
class Turn:
    """A turn of the whole walker by one radian, from x to y, about any point.

    Parameters
    ----------
    rates : sympy.Matrix, shape (n, 1)
        Change of each coordinate.
    guided : tuple of str
        Bodies that cannot turn along, because a guide holds their direction: a mass on a rail that stays
        horizontal. The torque of a guide comes from outside the walker.
    """

    rates: sp.Matrix
    guided: tuple[str, ...]


@dataclass(frozen=True)
class _Condition:
    """Rows that the turn fulfils: a point's or an angle's change, and what it is to be; also in numbers."""

    rows: sp.Matrix
    wanted: sp.Matrix
    body: str
    numbers: tuple[tuple[Array, Array], ...]

    @classmethod
    def at(
        cls, rows: sp.Matrix, wanted: sp.Matrix, places: Sequence[Mapping[sp.Symbol, float]], body: str = ""
    ) -> "_Condition":
        """A condition with its numbers at each of some positions; none where they are not real."""
        return cls(rows, wanted, body, tuple(_numbers(rows, wanted, place) for place in places))


def _numbers(rows: sp.Matrix, wanted: sp.Matrix, place: Mapping[sp.Symbol, float]) -> tuple[Array, Array]:
    try:
        a = np.array(in_numbers(rows, place).evalf().tolist(), dtype=np.float64)
        b = np.array(list(in_numbers(wanted, place).evalf()), dtype=np.float64)
    except TypeError:
        return np.zeros((0, rows.cols)), np.zeros(0)
    real = np.isfinite(a).all(axis=1) & np.isfinite(b)
    return a[real], b[real]


def _joined(conditions: list[_Condition], place: int, columns: int) -> tuple[Array, Array]:
    """All rows at a position, and what they are to be."""
    parts = [one.numbers[place] for one in conditions]
    rows = np.concatenate([np.zeros((0, columns)), *(a for a, _ in parts)])
    return rows, np.concatenate([np.zeros(0), *(b for _, b in parts)])


def turn(walker: Declaration) -> Turn:
    """The turn of a walker, from the positions and angles of its bodies.

    A body whose position does not show in which sense its angle is counted (a wheel about the hip) is taken
    to count it in the sense of the others.

    Parameters
    ----------
    walker : Walker
    """
    q, places = walker.q, list(_places(walker))
    turning: list[_Condition] = []
    guided: list[_Condition] = []
    for name, point in [("", walker.swing_foot), *((b.name, b.position) for b in walker.bodies)]:
        arm = point - STANCE_FOOT
        one = _Condition.at(point.jacobian(q), sp.Matrix([-arm[1], arm[0]]), places, name)
        (turning if _fulfilled([*turning, one], len(q)) else guided).append(one)
    turning += _of_angles(walker, turning, places)
    found = [_solved(turning, guided, i, len(q)) for i in range(len(places))]
    names = tuple(one.body for one in guided)
    halves = np.round(2 * found[0])
    if all(np.abs(2 * x - halves).max() < TOLERANCE for x in found):
        return Turn(sp.Matrix([sp.Rational(int(x), 2) for x in halves]), names)
    return Turn(_in_symbols(turning, q, places[0]), names)


def _of_angles(
    walker: Declaration, turning: list[_Condition], places: Sequence[Mapping[sp.Symbol, float]]
) -> list[_Condition]:
    """Angles of bodies that the positions do not determine, in the sense of those that they do."""
    q, senses, free = walker.q, 0, []
    for body in walker.bodies:
        rows = sp.Matrix([body.angle]).jacobian(q)
        if rows.is_zero_matrix:
            continue
        ways = [_Condition.at(rows, sp.Matrix([sense]), places) for sense in (1, -1)]
        either = [_fulfilled([*turning, way], len(q)) for way in ways]
        if all(either):
            free.append(ways)
        elif any(either):
            senses += 1 if either[0] else -1
    return [ways[senses < 0] for ways in free]


def _places(walker: Declaration) -> Iterator[dict[sp.Symbol, float]]:
    """Parameters and positions, the parameters not always at their defaults."""
    values = {a.symbol: a.default for a in walker.parameters}
    for i, position in enumerate(trial_points(walker, values)):
        if i == TRIALS:
            return
        moved = {s: x * (1 + 0.01 * i * math.cos(j + 1.0)) for j, (s, x) in enumerate(values.items())}
        yield {**dict.fromkeys(STANCE_FOOT, 0.0), **moved, **position}


def _fulfilled(conditions: list[_Condition], columns: int) -> bool:
    """Whether one change of the coordinates fulfils all conditions, at every position."""
    for place in range(len(conditions[0].numbers)):
        a, b = _joined(conditions, place, columns)
        x = np.linalg.lstsq(a, b, rcond=1e-10)[0]
        if np.abs(a @ x - b).max(initial=0.0) > TOLERANCE * (1 + np.abs(b).max(initial=0.0)):
            return False
    return True


def _solved(turning: list[_Condition], guided: list[_Condition], place: int, columns: int) -> Array:
    """The turn at a position; what is guided turns along as far as its guide lets it."""
    a, b = _joined(turning, place, columns)
    x: Array = np.asarray(np.linalg.lstsq(a, b, rcond=1e-10)[0], dtype=np.float64)
    if guided:
        _, sizes, directions = np.linalg.svd(a, full_matrices=True)
        free = directions[int((sizes > 1e-10 * sizes.max(initial=1.0)).sum()) :].T
        g, w = _joined(guided, place, columns)
        x = x + free @ np.linalg.lstsq(g @ free, w - g @ x, rcond=1e-10)[0]
    return x


def _in_symbols(turning: list[_Condition], q: sp.Matrix, place: Mapping[sp.Symbol, float]) -> sp.Matrix:
    """The turn as expressions, from as many of the rows as there are coordinates.

    A coordinate that no row determines stays as it is.
    """
    rows = sp.Matrix.vstack(*(one.rows for one in turning), sp.eye(len(q)))
    wanted = sp.Matrix.vstack(*(one.wanted for one in turning), sp.zeros(len(q), 1))
    numbers = _numbers(rows, wanted, place)[0]
    chosen: list[int] = []
    for i in range(len(numbers)):
        if np.linalg.matrix_rank(numbers[[*chosen, i]], tol=1e-8) > len(chosen):
            chosen.append(i)
    chosen = _with_pivots(numbers, chosen)
    matrix = rows.extract(chosen, range(len(q))).applyfunc(simplified)
    return solve(matrix, wanted.extract(chosen, [0]).applyfunc(simplified))


def _with_pivots(numbers: Array, chosen: list[int]) -> list[int]:
    """Rows in an order in which they can be eliminated from the top."""
    left, order = {i: numbers[i].copy() for i in chosen}, []
    for j in range(len(chosen)):
        best = max(left, key=lambda i: (abs(left[i][j]), -i))
        pivot = left.pop(best)
        order.append(best)
        for row in left.values():
            row -= row[j] / pivot[j] * pivot
    return order
