"""The same torque on two coordinates is that of a motor between bodies, and is refused as two motors.

Power and work are those of what a motor drives. Where one torque stands on two coordinates, as in
``{a: u, b: -u}``, the products of torque and rate of each coordinate are nobody's power. Seen are the same
terms, torques that depend on each other at trial states, and parameters by which two torques change alike.
Torques may be long, so they are evaluated, and never expanded.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations

import sympy as sp

from stridemap.derive.declaration import Declaration
from stridemap.derive.parts import TIME, Coordinate
from stridemap.derive.validate.refusal import refuse

SMALL = 1e-9
"""Of relative deviations between numbers that are equal but for rounding."""

Row = list[float]


def validate_torques(walker: Declaration) -> None:
    """Refuse `torques` in which one motor acts on several coordinates.

    Parameters
    ----------
    walker : Walker

    Raises
    ------
    InputError
        With the motor to declare instead.
    """
    acting = {c: u for c, u in walker.torques.items() if u != 0}
    for (one, u), (other, w) in combinations(acting.items(), 2):
        factor = _same_term(walker, u, w)
        if factor is not None:
            _refuse(walker, one, other, factor)
    if len(acting) > 1:
        _same_values(walker, acting)


def _refuse(walker: Declaration, one: Coordinate, other: Coordinate, factor: sp.Expr) -> None:
    drives = one.symbol + factor * other.symbol
    refuse(
        walker,
        f"the same torque acts on {one.name} and, times {factor}, on {other.name}: it is the torque of one "
        "motor, whose power is not the sum over the coordinates; declare it as a motor, "
        f'motors=(Motor("{one.name}_motor", torque, drives={drives}),), and leave it out of torques',
    )


# -- by their terms --------------------------------------------------------------------------------------


def _same_term(walker: Declaration, u: sp.Expr, w: sp.Expr) -> sp.Expr | None:
    """The factor that takes a term of `u`, or all of it, to one of `w`; None if they have none in common."""
    state = {*walker.q, *walker.v}
    moving = {*state, TIME}
    whole = ((u, w),)
    parts = ((x, y) for x in sp.Add.make_args(u) for y in sp.Add.make_args(w))
    for i, (x, y) in enumerate([*whole, *parts]):
        (a, rest), (b, other) = _split(x, moving), _split(y, moving)
        if rest != other or (i > 0 and rest == 1):
            continue
        factor = b / a
        # Two gains in front of the same function may belong to two motors; a common gain belongs to one.
        if factor.is_number or (rest.free_symbols & state and a.free_symbols & b.free_symbols):
            return factor
    return None


def _split(term: sp.Expr, moving: set[sp.Symbol]) -> tuple[sp.Expr, sp.Expr]:
    """The factors of a term that stay the same during a step, and those that do not."""
    factors = [x for factor in sp.Mul.make_args(term) for x in _with_sign(factor)]
    still = [f for f in factors if not f.free_symbols & moving]
    rest = [f for f in factors if f.free_symbols & moving]
    return sp.Mul(*still), sp.Mul(*rest)


def _with_sign(factor: sp.Expr) -> list[sp.Expr]:
    """A difference with its sign in front, so that it is the same whichever way round it is written."""
    return [sp.S.NegativeOne, -factor] if factor.is_Add and factor.could_extract_minus_sign() else [factor]


# -- by their values -------------------------------------------------------------------------------------


def _same_values(walker: Declaration, acting: Mapping[Coordinate, sp.Expr]) -> None:
    coordinates, trials = list(acting), _Trials(walker, list(acting.values()))
    table = trials.values()
    if not table:
        return
    for i, j in combinations(range(len(coordinates)), 2):
        for columns in (table, *trials.changes()):
            factor = _proportion([row[i] for row in columns], [row[j] for row in columns])
            if factor is not None:
                exact = sp.nsimplify(factor, rational=True, tolerance=1e-7)
                _refuse(walker, coordinates[i], coordinates[j], exact)
    if names := _dependent(table, [c.name for c in coordinates]):
        refuse(
            walker,
            f"the torques on {', '.join(names)} depend on each other, so fewer motors act than coordinates "
            "have torques, and power and work are those of what each motor drives; declare them as motors, "
            "motors=(Motor(name, torque, drives=...), ...), and leave them out of torques",
        )


class _Trials:
    """Values of torques at states and parameters that are the same each time, and like no others.

    Parameters
    ----------
    walker : Walker
    torques : list of sympy.Expr
    """

    def __init__(self, walker: Declaration, torques: list[sp.Expr]) -> None:
        self.state = [TIME, *walker.q, *walker.v]
        light = [] if walker.massless is None else [walker.massless.mass]
        self.constants = [*(a.symbol for a in walker.parameters), *light]
        self.defaults = [*(a.default for a in walker.parameters), *(0.1 for _ in light)]
        self.used = set().union(*(u.free_symbols for u in torques))
        self.count = 2 * len(torques) + 8
        try:
            self.call: Callable[..., Sequence[float]] | None = sp.lambdify(
                [*self.state, *self.constants], torques, "math", cse=True
            )
        except (TypeError, ValueError, NotImplementedError):
            self.call = None  # what cannot be printed is refused elsewhere

    def _point(self, i: int) -> tuple[Row, Row]:
        """State and constants of a trial."""
        state = [0.4 * math.cos(1.7 * i * i + 2.3 * j + 0.4) for j in range(len(self.state))]
        constants = [
            (x or 0.5) * (1 + 0.3 * math.cos(2.9 * i * i + 1.3 * j * j + 0.2))
            for j, x in enumerate(self.defaults)
        ]
        return state, constants

    def _row(self, state: Row, constants: Row) -> Row | None:
        try:
            row = [float(x) for x in self.call(*state, *constants)] if self.call else None
        except (ArithmeticError, ValueError, TypeError, NameError):
            return None
        return row if row is not None and all(map(math.isfinite, row)) else None

    def values(self) -> list[Row]:
        """Rows of the torques' values."""
        rows = (self._row(*self._point(i)) for i in range(self.count))
        return [row for row in rows if row is not None]

    def changes(self) -> Iterator[list[Row]]:
        """Rows of the torques' changes with each parameter, except for those that only time decides."""
        for k, symbol in enumerate(self.constants):
            if symbol not in self.used:
                continue
            rows, constant = [], True
            for i in range(self.count):
                state, constants = self._point(i)
                change = self._change(state, constants, k)
                moved = [state[0], *(x + 0.1 / (j + 1) for j, x in enumerate(state[1:]))]
                elsewhere = self._change(moved, constants, k)
                if change is None or elsewhere is None:
                    continue
                constant &= all(_equal(a, b) for a, b in zip(change, elsewhere, strict=True))
                rows.append(change)
            if rows and not constant:
                yield rows

    def _change(self, state: Row, constants: Row, k: int) -> Row | None:
        changed = [x * (1.25 if j == k else 1) for j, x in enumerate(constants)]
        before, after = self._row(state, constants), self._row(state, changed)
        if before is None or after is None:
            return None
        return [a - b if not _equal(a, b) else 0.0 for a, b in zip(after, before, strict=True)]


def _equal(a: float, b: float) -> bool:
    return abs(a - b) <= SMALL * (abs(a) + abs(b))


def _proportion(one: Row, other: Row) -> float | None:
    """The constant by which `other` is a multiple of `one`; None if there is none, or one of them is zero."""
    largest = max(range(len(one)), key=lambda i: abs(one[i]))
    if not any(one) or not any(other) or len(one) < 3:
        return None
    factor = other[largest] / one[largest]
    scale = max(map(abs, other))
    alike = all(abs(b - factor * a) <= 10 * SMALL * scale for a, b in zip(one, other, strict=True))
    return factor if factor and alike else None


def _dependent(table: list[Row], names: list[str]) -> list[str]:
    """The names of columns of which one is a sum of multiples of the others; empty if there are none."""
    columns = [[row[j] for row in table] for j in range(len(names))]
    basis: list[tuple[Row, dict[str, float]]] = []
    for name, column in zip(names, columns, strict=True):
        size = math.sqrt(sum(x * x for x in column))
        rest, made_of = [x / (size or 1.0) for x in column], {name: 1.0}
        for _ in range(2):  # twice, for the digits that the first pass loses
            for vector, parts in basis:
                along = sum(a * b for a, b in zip(rest, vector, strict=True))
                rest = [a - along * b for a, b in zip(rest, vector, strict=True)]
                for part, share in parts.items():
                    made_of[part] = made_of.get(part, 0.0) - along * share
        left = math.sqrt(sum(x * x for x in rest))
        if left < SMALL and size:
            return [part for part in names if abs(made_of.get(part, 0.0)) > SMALL]
        if size:
            basis.append(([x / left for x in rest], {k: x / left for k, x in made_of.items()}))
    return []
