"""Special points on the lines of a sweep: bifurcations, and where limit cycles begin and end.

Branches are followed as guesses. Where something happens between two points of one, both are solved for,
and what is between them is located by the systems of `solver.branches.special` and `solver.branches.ends`,
as on a branch over one parameter.
"""

from collections import defaultdict
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.arclength import CurvePoint
from stridemap.solver.branches.asking import Asking, together
from stridemap.solver.branches.bifurcation import Special, SpecialType
from stridemap.solver.branches.conditions import GaitConditions, GaitEnd
from stridemap.solver.branches.cubics import cubics, value
from stridemap.solver.branches.curve import Correction, Curve
from stridemap.solver.branches.ends import End, Search, conditions_along, searches
from stridemap.solver.branches.special import CHANGES, specials_between, tests
from stridemap.solver.branches.switching import doubled, supercritical
from stridemap.solver.cycles.chain import Chain
from stridemap.solver.kernels.catalogue import CYCLE_N_RK
from stridemap.solver.kernels.resolution import Resolution
from stridemap.solver.options import ContinuationOptions
from stridemap.sweeps import changes
from stridemap.sweeps.changes import Stretches, cycles, sides, sides_of_guesses

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Conditions = dict[GaitEnd, Floats]

CORRECTIONS = 10
"""Newton's corrections of a point of a branch at most."""

ON_BRANCH = 2e-3
"""Distance from a branch, in terms of the length of the piece, at which a special point is one of it."""

UNKNOWN = "unknown"
"""The type of a special point of which only the stretch is known on which it lies."""

NOT_SOLVED = "the branch was not solved for at both values between which it lies"
NOT_LOCATED = "Newton's method did not find it between the two values"


@dataclass(frozen=True)
class SpecialPoint:
    """A special point of a branch on a line of the grid.

    Parameters
    ----------
    cell : int
        A cell of its line.
    branch : int
        Number that the search gave the branch.
    type : str
        A `SpecialType`, a `GaitEnd` or `UNKNOWN`.
    lower, upper : float
        Values of the parameter between which it lies; both are its own where it was located.
    values : dict of str to value
        What the table has of it besides, by column; empty where it was not located.
    reason : str or None
        Why it was not located.
    """

    cell: int
    branch: int
    type: str
    lower: float
    upper: float
    values: dict[str, Any]
    reason: str | None = None


@dataclass(frozen=True)
class Locator:
    """Locates special points of branches on lines along one parameter.

    Parameters
    ----------
    conditions : GaitConditions
        With the range of periods that count.
    parameter : str
        What varies along the lines.
    low, high : float
        Ends of the lines.
    """

    conditions: GaitConditions
    parameter: str
    low: float
    high: float

    def special_points(self, stretches: Stretches) -> list[SpecialPoint]:
        """Special points of stretches, in order along them. What two stretches share is there twice."""
        points, held = self._solved(stretches, sides_of_guesses(stretches, self.conditions))
        out: dict[int, list[SpecialPoint]] = {}
        pieces: dict[int, _Piece] = {}
        for number in sorted(i for i in points if i + 1 in points and stretches.joined[i]):
            one, other = points[number], points[number + 1]
            if one is None or other is None:
                out[number] = [self._not_solved(stretches, number)]
                continue
            piece = self._piece(stretches, number, one, other, held)
            if changes.changes(piece.side[None], piece.other_side[None])[0]:
                pieces[number] = piece
        lines = [(int(stretches.cell[number]), piece) for number, piece in pieces.items()]
        self._find_bifurcations(lines)
        self._find_ends(lines)
        for number, piece in pieces.items():
            out[number] = piece.rows(int(stretches.cell[number]), int(stretches.branch[number]))
        return [point for number in sorted(out) for point in out[number]]

    def _find_bifurcations(self, waiting: list[tuple[int, "_Piece"]]) -> None:
        """Locate bifurcations on pieces of lines."""
        met: dict[int, list[Special]] = defaultdict(list)
        located: list[tuple[_Piece, Special]] = []

        def due(line: int, piece: "_Piece") -> bool:
            return piece.has_bifurcations() and not piece.bifurcations_are_among(met[line])

        for now in _in_turn(waiting, due):
            for (line, piece), found in zip(now, together(one.bifurcations() for _, one in now), strict=True):
                met[line] += found
                located += ((piece, special) for special in found)
        if not located:
            return
        params = np.array([piece.curve.equations.point(special.x[-1:]) for piece, special in located])
        n_rk = [min(2 * max(piece.one.n_rk, piece.other.n_rk), 2 * CYCLE_N_RK[-1]) for piece, _ in located]
        u = np.array([special.x[:-1] for _, special in located])
        holds = self.conditions.of_cycles(n_rk, u, params, 1)
        of_cycles, contact = cycles(holds), holds[GaitEnd.CONTACT] > 0
        located = [one for one, cycle in zip(located, of_cycles.tolist(), strict=True) if cycle]
        kinds = together(piece.criticality(special) for piece, special in located)
        for (piece, special), kind, gait in zip(located, kinds, contact[of_cycles].tolist(), strict=True):
            piece.enter(special, kind, gait)

    def _find_ends(self, waiting: list[tuple[int, "_Piece"]]) -> None:
        """Locate ends on pieces of lines."""
        met: dict[int, list[_MetEnd]] = defaultdict(list)

        def due(line: int, piece: "_Piece") -> bool:
            return piece.has_ends() and not piece.ends_are_among(met[line])

        for now in _in_turn(waiting, due):
            found = [(line, piece, search) for line, piece in now for search in piece.end_searches()]
            ends = together(search for _, _, search in found)
            for (line, piece, _), end in zip(found, ends, strict=True):
                met[line] += piece.take_end(end)

    def _not_solved(self, stretches: Stretches, i: int) -> SpecialPoint:
        """That something happens between two points of a branch of which one was not solved for."""
        column = self.conditions.kernels.model.spec.names.index(self.parameter)
        lower, upper = sorted(stretches.params[[i, i + 1], column].tolist())
        place = int(stretches.cell[i]), int(stretches.branch[i])
        return SpecialPoint(*place, UNKNOWN, lower, upper, {}, NOT_SOLVED)

    def _piece(
        self,
        stretches: Stretches,
        i: int,
        one: CurvePoint,
        other: CurvePoint,
        held: dict[int, dict[GaitEnd, float]],
    ) -> "_Piece":
        beside = {name: np.array([held[i][name], held[i + 1][name]]) for name in held[i]}
        sides_ = self._side(one, held[i]), self._side(other, held[i + 1])
        return _Piece(self, self._curve(stretches.params[i]), one, other, *sides_, beside)

    def _curve(self, params: Floats) -> Curve:
        chain = Chain(self.conditions.kernels, 1)
        return Curve.over(chain, params, self.parameter, self.high - self.low)

    def _solved(
        self, stretches: Stretches, guessed: Ints
    ) -> tuple[dict[int, CurvePoint | None], dict[int, dict[GaitEnd, float]]]:
        """The ends of all pieces on which something happens, and the conditions of a gait there.

        A guess may be on another side than the point for which it stands: then the piece beside it counts.
        """
        known = (guessed[:, changes.CYCLE] != changes.UNKNOWN) if len(guessed) else np.zeros(0, dtype=bool)
        looked = stretches.joined & known[:-1] & known[1:]
        pieces = set(np.flatnonzero(looked & changes.changes(guessed[:-1], guessed[1:])).tolist())
        points: dict[int, CurvePoint | None] = {}
        held: dict[int, dict[GaitEnd, float]] = {}
        while new := sorted({i for piece in pieces for i in (piece, piece + 1)} - points.keys()):
            points |= self._points(stretches, new)
            held |= self._held([(i, point) for i in new if (point := points[i]) is not None], stretches)
            for i in new:
                point = points[i]
                if point is not None and (self._side(point, held[i]) != guessed[i]).any():
                    pieces |= {
                        beside for beside in (i - 1, i) if 0 <= beside < len(looked) and looked[beside]
                    }
        return points, held

    def _points(self, stretches: Stretches, numbers: list[int]) -> dict[int, CurvePoint | None]:
        """The points of branches for which guesses stand; None where Newton's method does not find one."""
        resolution = Resolution(self.conditions.kernels.model)
        n_rk = resolution.cycle_n_rk(stretches.u[numbers, -1], stretches.params[numbers]).tolist()
        asked = []
        for i, n in zip(numbers, n_rk, strict=True):
            curve = self._curve(stretches.params[i])
            x = np.append(stretches.u[i], stretches.params[i, curve.equations.columns[0]])
            tangent = stretches.tangent[i] / curve.norm(stretches.tangent[i])
            asked.append(Correction(curve, x, tangent, n, CORRECTIONS))
        found = zip(numbers, asked, Correction.answers(asked), strict=True)
        return {
            i: CurvePoint.at(one.curve, there, one.across, one.n_rk) if there.converged else None
            for i, one, there in found
        }

    def _held(
        self, points: list[tuple[int, CurvePoint]], stretches: Stretches
    ) -> dict[int, dict[GaitEnd, float]]:
        """Conditions of a gait at points."""
        if not points:
            return {}
        params = np.array([self._curve(stretches.params[i]).equations.point(p.x[-1]) for i, p in points])
        n_rk = [min(2 * point.n_rk, 2 * CYCLE_N_RK[-1]) for _, point in points]
        values = self.conditions.of_cycles(n_rk, np.array([p.x[:-1] for _, p in points]), params, 1)
        return {
            i: {name: float(value[row]) for name, value in values.items()}
            for row, (i, _) in enumerate(points)
        }

    def _side(self, point: CurvePoint, held: dict[GaitEnd, float]) -> Ints:
        """On which side a point is of what can happen, shape (5,)."""
        holds = {name: np.array([value]) for name, value in held.items()}
        jacobian, multipliers = point.matrix[None, :, :-1], point.multipliers[None]
        return np.asarray(sides(point.tangent[-1:], jacobian, multipliers, holds)[0])


def _in_turn(
    waiting: list[tuple[int, "_Piece"]], due: Callable[[int, "_Piece"], bool]
) -> Iterator[list[tuple[int, "_Piece"]]]:
    """Pieces of lines on which something is due, many at a time.

    Of pieces that may share a part of a branch, one comes first; the others come later, when it is known what
    was found on that one.
    """
    while waiting:
        now: list[tuple[int, _Piece]] = []
        later: list[tuple[int, _Piece]] = []
        for line, piece in waiting:
            if due(line, piece):
                shared = any(line == other and piece.is_near(one) for other, one in now)
                (later if shared else now).append((line, piece))
        yield now
        waiting = later


@dataclass(frozen=True)
class _MetEnd:
    """The end of a limit cycle, or of its contact, that was located; and whether it keeps contact there."""

    type: GaitEnd
    x: Floats
    gait: bool


class _Piece:
    """A part of a branch between two of its points, on which something happens, and what that is."""

    def __init__(
        self,
        locator: Locator,
        curve: Curve,
        one: CurvePoint,
        other: CurvePoint,
        side: Ints,
        other_side: Ints,
        held: Conditions,
    ) -> None:
        self.locator, self.curve, self.one, self.other = locator, curve, one, other
        self.side, self.other_side, self.held = side, other_side, held
        self.differ = side != other_side
        self._found: list[tuple[float, str, Floats, dict[str, Any]]] = []
        self._lost: list[str] = []

    def has_bifurcations(self) -> bool:
        """Whether the branch turns back, crosses another one, or has other multipliers outside the circle."""
        return bool(self.differ[[changes.FOLD, changes.BP, changes.UNSTABLE]].any())

    def bifurcations(self) -> Asking[list[Special]]:
        """A search for bifurcations, in order along the branch."""
        found = yield from specials_between(self.curve, self.one, self.other, ContinuationOptions())
        self._lost += self._missing({special.type for special in found})
        return found

    def end_searches(self) -> Iterator[Search]:
        """Searches for where limit cycles end or begin, and for where a foot leaves the ground."""
        options, points = ContinuationOptions(), [self.one, self.other]
        conditions = self.locator.conditions
        if self.differ[changes.CYCLE]:
            others = dict(self.held)
            del others[GaitEnd.CONTACT]
            yield from (search for _, search in searches(self.curve, points, others, conditions, options))
        # Where the foot keeps contact on both sides, contact is lost with the cycle.
        if self.differ[changes.CONTACT] and not (
            self.differ[changes.CYCLE] and (self.held[GaitEnd.CONTACT] > 0).all()
        ):
            yield from (search for _, search in searches(self.curve, points, self.held, conditions, options))

    def take_end(self, end: End | None) -> list[_MetEnd]:
        """Enter what a search for an end has found, and return it."""
        if end is None:
            self._lost += self._broken()
            return []
        kind, x, values = self._end(end)
        self._found.append((self._along(x), kind, x, values))
        return [_MetEnd(end.type, x, values["gait"])]

    def has_ends(self) -> bool:
        """Whether a limit cycle ends here, or keeps contact no longer."""
        return bool(self.differ[[changes.CYCLE, changes.CONTACT]].any())

    def is_near(self, other: "_Piece") -> bool:
        """Whether another piece is so near that both may be of one part of a branch."""
        middles = [0.5 * (piece.one.x + piece.other.x) for piece in (self, other)]
        lengths = [self.curve.norm(piece.other.x - piece.one.x) for piece in (self, other)]
        return self.curve.norm(middles[0] - middles[1]) < sum(lengths)

    def ends_are_among(self, met: list[_MetEnd]) -> bool:
        """Whether the ends here were located on another stretch, which shares this part of the branch."""
        here = [end for end in met if self._passes(end.x)]
        ends = [end for end in here if end.type != GaitEnd.CONTACT]
        contacts = (len(here) - len(ends)) % 2
        if not self.differ[changes.CYCLE]:
            return not ends and contacts == 1
        keeps = self.side[changes.CONTACT] or self.other_side[changes.CONTACT]
        return len(ends) == 1 and (bool(keeps) != ends[0].gait) == bool(contacts)

    def rows(self, cell: int, branch: int) -> list[SpecialPoint]:
        """Special points, in order along the branch, on the line of a cell."""
        out = []
        for _, kind, x, values in sorted(self._found, key=lambda row: row[0]):
            at = float(x[-1])
            if self.locator.low <= at <= self.locator.high:
                out.append(SpecialPoint(cell, branch, kind, at, at, values))
        lower, upper = sorted([float(self.one.x[-1]), float(self.other.x[-1])])
        lost = dict.fromkeys(self._lost)
        return [*out, *(SpecialPoint(cell, branch, kind, lower, upper, {}, NOT_LOCATED) for kind in lost)]

    def _along(self, x: Floats) -> float:
        return self.curve.dot(x - self.one.x, self.one.tangent)

    def bifurcations_are_among(self, met: list[Special]) -> bool:
        """Whether those here were located on another stretch, which shares this part of the branch."""
        here = [point for point in met if self._passes(point.x)]
        peak = self.other_side[changes.FOLD] == 0  # the parameter is largest at the fold
        folds = sum(point.type == SpecialType.FOLD and (point.slope < 0) == peak for point in here)
        points = sum(point.type == SpecialType.BP for point in here)
        change = abs(int(self.side[changes.UNSTABLE] - self.other_side[changes.UNSTABLE]))
        explained = sum(CHANGES[point.type] for point in here)
        return (
            (folds % 2 == 1) == bool(self.differ[changes.FOLD])
            and (points % 2 == 1) == bool(self.differ[changes.BP])
            and change <= explained
            and (explained - change) % 2 == 0
        )

    def _passes(self, x: Floats) -> bool:
        """Whether a point is on this part of the branch: on the cubic through its ends and their tangents."""
        one, other, scale = self.one, self.other, self.curve.scale
        length = self.curve.norm(other.x - one.x)
        part = self.curve.dot(x - one.x, other.x - one.x) / length**2
        if not -1e-9 < part < 1 + 1e-9 or self.curve.norm(x - one.x) > 1.5 * length:
            return False
        ends = one.x[None], other.x[None], one.tangent[None], other.tangent[None]
        fine = np.linspace(0, 1, 101)[:, None]
        path = value(np.repeat(cubics(*ends, scale), len(fine), axis=0), fine)
        return bool(self._distance(path, x) < ON_BRANCH * length)

    def _distance(self, path: Floats, x: Floats) -> float:
        """Distance of a point from a polygon, in terms of the scale."""
        path, x = path / self.curve.scale, x / self.curve.scale
        along, away = np.diff(path, axis=0), x - path[:-1]
        part = np.clip((along * away).sum(axis=1) / np.fmax((along**2).sum(axis=1), 1e-300), 0, 1)
        return float(np.sqrt(((away - part[:, None] * along) ** 2).sum(axis=1).min()))

    # -- bifurcations ----------------------------------------------------------------------------------------

    def _missing(self, found: set[SpecialType]) -> list[str]:
        """Types of bifurcations that there must be among limit cycles, and that were not located."""
        if not (self.side[changes.CYCLE] and self.other_side[changes.CYCLE]):
            return []  # it may lie where there is no limit cycle
        before, after = tests(self.curve, self.one), tests(self.curve, self.other)
        crossed = [kind for kind in SpecialType if before[kind] * after[kind] < 0 and kind not in found]
        more = abs(int(self.side[changes.UNSTABLE] - self.other_side[changes.UNSTABLE]))
        must = [SpecialType.FOLD, SpecialType.BP]
        if more and not found:
            must += [SpecialType.PD] if more == 1 else [SpecialType.NS]
        return [str(kind) for kind in must if kind in crossed]

    def enter(self, special: Special, criticality: str | None, gait: bool) -> None:
        """Enter a bifurcation of a limit cycle, which may be a gait."""
        width = self.curve.chain.width - 1
        first = np.asarray(special.null, dtype=np.complex128)[:width]
        largest = first[np.abs(first).argmax()]
        null = first / largest if largest else first
        # Towards larger values of the parameter; at a fold, where the curve turns, both ways are one.
        turned = special.direction < 0 and special.type in (SpecialType.PD, SpecialType.NS)
        names = self.curve.equations.model.section
        values = {
            **self._common(special.x, special.multipliers, special.residual),
            "gait": gait,
            "criticality": criticality,
            "multiplier_re": special.multiplier.real,
            "multiplier_im": special.multiplier.imag,
            "crossing_slope": -special.slope if turned else special.slope,
            **{f"null_{name}_re": one.real for name, one in zip(names, null.tolist(), strict=True)},
            **{f"null_{name}_im": one.imag for name, one in zip(names, null.tolist(), strict=True)},
        }
        self._found.append((self._along(special.x), str(special.type), special.x, values))

    def criticality(self, special: Special) -> Asking[str | None]:
        """A search that returns whether a doubling is super- or subcritical.

        It returns None for other bifurcations, and where the doubled branch is not found.
        """
        if special.type != SpecialType.PD:
            return None
        switched = yield from doubled(self.curve, special, ContinuationOptions())
        if switched is None:
            return None
        return "supercritical" if supercritical(special, switched) else "subcritical"

    # -- ends ------------------------------------------------------------------------------------------------

    def _end(self, end: End) -> tuple[str, Floats, dict[str, Any]]:
        point, keeps = end.point, self.held[GaitEnd.CONTACT] > 0
        gait = bool(keeps[0])
        if end.type == GaitEnd.CONTACT:
            gait = True
        elif keeps[0] != keeps[1]:
            conditions, names = self.locator.conditions, [GaitEnd.CONTACT]
            gait = bool(conditions_along(self.curve, [point], conditions, names)[GaitEnd.CONTACT][0] > 0)
        return (
            str(end.type),
            point.x,
            {**self._common(point.x, point.multipliers, end.residual), "gait": gait},
        )

    def _broken(self) -> list[str]:
        """The type of an end that was not located: the condition that is broken on one side."""
        broken = [name for name, value in self.held.items() if (value > 0)[0] != (value > 0)[1]]
        return [str(name) for name in broken[:1]]

    def _common(self, x: Floats, multipliers: Any, residual: float) -> dict[str, Any]:
        return {"u": x[:-1], "multipliers": multipliers, "residual": residual}
