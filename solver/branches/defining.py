"""Systems of equations of which bifurcations are regular solutions, and Newton's method on them.

With M(lambda) and g as in `bordered`, ``R = 0, g = 0`` is a regular system for a fold (lambda = 1), a period
doubling (-1), and, with the angle as one more unknown and g complex, a torus (exp(i theta)). At a branch
point the augmented system of H. D. Mittelmann and H. Weber (1980) is regular: ``R + mu psi = 0,
DR' psi = 0, |psi| = 1``.
"""

from abc import ABC, abstractmethod
from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.arclength import CurvePoint
from stridemap.solver.branches.asking import Question
from stridemap.solver.branches.bifurcation import Border, Special, SpecialType
from stridemap.solver.branches.bordered import Bordered, wrap
from stridemap.solver.branches.curve import Curve
from stridemap.solver.branches.equations import CycleEquations, linearised, second
from stridemap.solver.kernels.catalogue import CYCLE_N_RK
from stridemap.solver.linear import solved

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Mask = NDArray[np.bool_]


def finer(n_rk: int) -> int:
    """Twice a resolution, or the finest that there is."""
    return min(2 * n_rk, CYCLE_N_RK[-1])


@dataclass(frozen=True)
class Attempt(Question[Special | None]):
    """Asks for the special point of a type near a point of a curve; None where Newton's method fails.

    It is computed at twice the resolution of that point, or at the finest that there is.

    Parameters
    ----------
    type : SpecialType
    curve : Curve
    guess : CurvePoint
    reach : float
        It is not looked for farther away, in terms of the scale.
    before : Special, optional
        The same at a coarser resolution. It moves so little that, of a bordered system, its slope and the
        gradient of g stay.
    """

    type: SpecialType
    curve: Curve
    guess: CurvePoint
    reach: float = np.inf
    before: Special | None = None

    @property
    def kind(self) -> Hashable:
        """Newton's method on one kind of system goes on in step for curves of one family."""
        return self.type, self.curve.family, self.before is None

    @classmethod
    def answers(cls, questions: Sequence[Self]) -> list[Special | None]:
        """Special points."""
        return _SYSTEMS[questions[0].type](questions).solutions()


@dataclass(frozen=True)
class _Linear:
    """The linear systems of a Newton step at k points.

    Parameters
    ----------
    rows : ndarray, shape (k, L, L)
    right : ndarray, shape (k, L)
        What is to become zero.
    size : ndarray, shape (k,)
        Modulus of its largest entry.
    """

    rows: Array
    right: Array
    size: Array


class _System(ABC):
    """Newton's method on systems of one kind from m guesses, on curves of one family."""

    type: SpecialType

    def __init__(self, attempts: Sequence[Attempt]) -> None:
        self.curves = [one.curve for one in attempts]
        self.guesses = [one.guess for one in attempts]
        self.before = [one.before for one in attempts]
        self.x = np.array([guess.x for guess in self.guesses])
        self.begin, self.reach = self.x.copy(), np.array([one.reach for one in attempts])
        self.n_rk = np.array([finer(guess.n_rk) for guess in self.guesses])
        self.scale, self.weave = self.curves[0].scale, wrap(self.curves[0].equations)

    def solutions(self) -> list[Special | None]:
        """The special points."""
        found: list[Special | None] = [None] * len(self.curves)
        open_, last = self._begun(), np.full(len(self.curves), np.inf)
        for _ in range(ITERATIONS):
            open_, matrix, residual = self._linearised(open_)
            if not len(open_):
                break
            linear = self._linear(open_, matrix, residual)
            change = solved(linear.rows, -linear.right)
            good, length = np.isfinite(change).all(axis=1), self._norm(change[:, : self.x.shape[1]])
            near = (linear.size < SPECIAL_RESIDUAL) & self._settled(open_, length)
            self._stepped(open_, length, last[open_])
            last[open_] = length
            self._move(open_[good], change[good])
            good &= self._norm(self.x[open_] - self.begin[open_]) <= self.reach[open_]
            at = np.flatnonzero(good & near)
            if len(at):
                specials = self._specials(open_[at], matrix[at], linear.size[at])
                for i, special in zip(open_[at].tolist(), specials, strict=True):
                    found[i] = special
            open_ = open_[good & ~near]
        return found

    def _begun(self) -> Index:
        """The guesses from which a system can be solved."""
        return np.arange(len(self.curves))

    def _settled(self, open_: Index, length: Array) -> Mask:
        """Whether steps are so short, in terms of the scale, that the next ones would be lost in rounding."""
        return np.asarray(length < SETTLED)

    def _stepped(self, open_: Index, length: Array, last: Array) -> None:  # noqa: B027
        """Take note of the lengths of steps, and of the steps before."""

    def _linearised(self, open_: Index) -> tuple[Index, Array, Array]:
        """Those of some points at which there are derivatives, with these and the residuals."""
        if not len(open_):
            return open_, np.empty(0), np.empty(0)
        matrix, residual = linearised(self._equations(open_), self.x[open_], self.n_rk[open_])
        finite = np.isfinite(matrix).all(axis=(1, 2)) & np.isfinite(residual).all(axis=1)
        return open_[finite], matrix[finite], residual[finite]

    @abstractmethod
    def _linear(self, open_: Index, matrix: Array, residual: Array) -> _Linear:
        """The linear systems at some of the points, where the curves' equations have these derivatives."""

    def _move(self, open_: Index, change: Array) -> None:
        """Change the unknowns of some of the points."""
        self.x[open_] += change[:, : self.x.shape[1]]

    @abstractmethod
    def _specials(self, open_: Index, matrix: Array, size: Array) -> list[Special | None]:
        """Special points where Newton's method has ended, with their residuals' sizes."""

    def _equations(self, open_: Index) -> list[CycleEquations]:
        return [self.curves[i].equations for i in open_.tolist()]

    def _norm(self, x: Array) -> Array:
        length: Array = np.sqrt(((x / self.scale) ** 2).sum(axis=1))
        return length


class _BorderedSystem(_System):
    """``R = 0, g = 0``.

    The second derivatives in the gradient of g cost far more than all the rest. It serves for several steps,
    as long as these become shorter fast.
    """

    def __init__(self, attempts: Sequence[Attempt]) -> None:
        super().__init__(attempts)
        # Borders b and c, the gradient of g, and the null vectors w and psi of M(lambda).
        self._borders: list[NDArray[Any]] | None = None
        self._null: list[NDArray[Any]] = []
        given = [one.border for one in self.before if one is not None and one.border is not None]
        if given:
            parts = zip(*((one.b, one.c, one.gradient) for one in given), strict=True)
            self._borders = [np.array(part) for part in parts]
        # Whether the gradient is that of an earlier point.
        self._kept = np.full(len(self.curves), bool(given))

    def _settled(self, open_: Index, length: Array) -> Mask:
        return np.asarray(length < np.where(self._kept[open_], SETTLED_NEARLY, SETTLED))

    def _stepped(self, open_: Index, length: Array, last: Array) -> None:
        """The gradient stays where steps become shorter fast."""
        self._kept[open_] = length < SHORTER * last

    def _bordered(self, open_: Index, singular: NDArray[Any]) -> tuple[Bordered, NDArray[Any]]:
        """The bordered systems, with the same borders in each Newton step, and gradients of g."""
        if self._borders is None:
            # Singular vectors of the smallest singular value make them best conditioned.
            u, _, vh = np.linalg.svd(singular)
            count, size = len(self.curves), singular.shape[1]
            self._borders = [np.zeros((count, n), dtype=singular.dtype) for n in (size, size, size + 1)]
            self._borders[0][open_], self._borders[1][open_] = u[:, :, -1], vh[:, -1]
        b, c, gradient = self._borders
        bordered = Bordered.of(singular, b[open_], c[open_])
        self._null = self._null or [np.zeros_like(b), np.zeros_like(b)]
        self._null[0][open_], self._null[1][open_] = bordered.w * self.scale[:-1], bordered.psi
        new = np.flatnonzero(~self._kept[open_])
        if len(new):
            gradient[open_[new]] = self._gradient(open_[new])
        return bordered, gradient[open_]

    def _gradient(self, open_: Index) -> NDArray[Any]:
        """Gradients of g."""
        w, psi = (one[open_] for one in self._null)
        return -_product(psi, self._second(open_, w))

    def _second(self, open_: Index, w: NDArray[Any]) -> NDArray[Any]:
        """Derivatives of ``DR[w]``, for directions w of the unknowns that are not parameters."""
        v = np.concatenate([w, np.zeros((len(w), 1))], axis=1)
        return second(self._equations(open_), self.x[open_], v, self.n_rk[open_])

    def _specials(self, open_: Index, matrix: Array, size: Array) -> list[Special | None]:
        assert self._borders is not None
        each = zip(open_.tolist(), matrix, strict=True)
        tangents = np.array([self.curves[i].tangent(one, self.guesses[i].tangent) for i, one in each])
        before = [one for i in open_.tolist() if (one := self.before[i]) is not None]
        if before:
            slopes = [one.slope for one in before]
        else:
            slopes = self._slopes(open_, tangents).tolist()
        out: list[Special | None] = []
        for row, i in enumerate(open_.tolist()):
            if not self._counts(i):
                out.append(None)
                continue
            border = Border(*(one[i].copy() for one in self._borders))
            multipliers, null = (
                self.curves[i].multipliers(matrix[row]),
                _signed(self._null[0][i], self.scale[:-1]),
            )
            here = self.x[i].copy(), multipliers, null, float(size[row])
            multiplier, direction = self._multiplier(i), float(tangents[row, -1])
            out.append(Special(self.type, *here, slopes[row], multiplier, direction, border))
        return out

    def _counts(self, i: int) -> bool:
        """Whether a solution is a special point."""
        return True

    @abstractmethod
    def _multiplier(self, i: int) -> complex:
        """The multiplier that crosses the unit circle."""

    @abstractmethod
    def _slopes(self, open_: Index, tangents: Array) -> Array:
        """Changes along the curves, per unit of arclength, of what passes through a value."""

    def _changes(self, open_: Index, tangents: Array) -> NDArray[Any]:
        """Change of the multiplier along the curve: since M w = 0 there, psi' dM w / psi' W w."""
        w, psi = (one[open_] for one in self._null)
        changes: NDArray[Any] = -(self._gradient(open_) * tangents).sum(axis=1)
        return changes / (psi * (w @ self.weave.T)).sum(axis=1)


class _RealMultiplier(_BorderedSystem):
    """The same for a fixed real multiplier."""

    multiplier: float

    def _linear(self, open_: Index, matrix: Array, residual: Array) -> _Linear:
        turned = (1.0 - self.multiplier) * self.weave
        bordered, gradient = self._bordered(open_, (matrix[:, :, :-1] + turned) * self.scale[:-1])
        right = np.column_stack([residual, bordered.g])
        rows = np.concatenate([matrix, gradient[:, None]], axis=1)
        return _Linear(rows, right, np.abs(right).max(axis=1))

    def _multiplier(self, i: int) -> complex:
        return complex(self.multiplier)


class _Fold(_RealMultiplier):
    """The multiplier 1."""

    type, multiplier = SpecialType.FOLD, 1.0

    def _slopes(self, open_: Index, tangents: Array) -> Array:
        """Change of the tangent's parameter: not zero where the curve turns back."""
        w, psi = (one[open_] for one in self._null)
        v = w / self._norm(np.concatenate([w, np.zeros((len(open_), 1))], axis=1))[:, None]
        along = linearised(self._equations(open_), self.x[open_], self.n_rk[open_])[0][:, :, -1]
        bend = (self._second(open_, v)[:, :, :-1] @ v[:, :, None])[:, :, 0]
        slopes: Array = -(psi * bend).sum(axis=1) / (psi * along).sum(axis=1) / self.scale[-1]
        return slopes


class _Doubling(_RealMultiplier):
    """The multiplier -1."""

    type, multiplier = SpecialType.PD, -1.0

    def _slopes(self, open_: Index, tangents: Array) -> Array:
        """Changes of the multipliers."""
        return self._changes(open_, tangents)


class _Torus(_BorderedSystem):
    """The same with the angle theta of the multiplier as one more unknown, and complex g."""

    type = SpecialType.NS

    def _begun(self) -> Index:
        """Where there is a pair of complex multipliers: two real ones may have the product 1, too."""
        self.theta = np.full(len(self.curves), np.nan)
        for i, guess in enumerate(self.guesses):
            pairs = guess.multipliers[guess.multipliers.imag > 0]
            if len(pairs):
                self.theta[i] = np.angle(pairs[np.abs(np.abs(pairs) - 1.0).argmin()])
        return np.flatnonzero(np.isfinite(self.theta))

    def _linear(self, open_: Index, matrix: Array, residual: Array) -> _Linear:
        root = np.exp(1j * self.theta[open_])
        turned = (1.0 - root)[:, None, None] * self.weave
        bordered, gradient = self._bordered(open_, (matrix[:, :, :-1] + turned) * self.scale[:-1])
        turn = 1j * root * (bordered.psi * (bordered.w * self.scale[:-1] @ self.weave.T)).sum(axis=1)
        count, size = residual.shape
        rows = np.zeros((count, size + 2, size + 2))
        rows[:, :size, :-1], rows[:, size, :-1], rows[:, size + 1, :-1] = matrix, gradient.real, gradient.imag
        rows[:, size, -1], rows[:, size + 1, -1] = turn.real, turn.imag
        right = np.column_stack([residual, bordered.g.real, bordered.g.imag])
        error = np.maximum(np.abs(residual).max(axis=1), np.abs(bordered.g))
        return _Linear(rows, right, error)

    def _move(self, open_: Index, change: Array) -> None:
        super()._move(open_, change)
        self.theta[open_] += change[:, -1]

    def _counts(self, i: int) -> bool:
        return bool(1e-6 < self.theta[i] < np.pi - 1e-6)

    def _multiplier(self, i: int) -> complex:
        return complex(np.exp(1j * self.theta[i]))

    def _slopes(self, open_: Index, tangents: Array) -> Array:
        """Changes of the moduli: the components of the multipliers' changes along these."""
        slopes: Array = (self._changes(open_, tangents) / np.exp(1j * self.theta[open_])).real
        return slopes


class _BranchPoint(_System):
    """``R + mu psi = 0, DR' psi = 0, |psi| = 1``."""

    type = SpecialType.BP

    def _begun(self) -> Index:
        size = self.x.shape[1] - 1
        self.psi, self.mu = np.full((len(self.curves), size), np.nan), np.zeros(len(self.curves))
        return super()._begun()

    def _linear(self, open_: Index, matrix: Array, residual: Array) -> _Linear:
        count, size = residual.shape
        if np.isnan(self.psi[open_]).any():
            self.psi[open_] = np.linalg.svd(matrix * self.scale)[0][:, :, -1]
        psi, mu = self.psi[open_], self.mu[open_]
        units = np.tile(np.eye(size + 1), (count, 1))
        each = np.repeat(open_, size + 1)
        twice = second(self._equations(each), self.x[each], units, self.n_rk[each])
        contracted = _product(np.repeat(psi, size + 1, axis=0), twice)
        rows = np.zeros((count, 2 * size + 2, 2 * size + 2))
        rows[:, :size, : size + 1], rows[:, :size, size + 1] = matrix, psi
        rows[:, :size, size + 2 :] = mu[:, None, None] * np.eye(size)
        rows[:, size : 2 * size + 1, : size + 1] = contracted.reshape(count, size + 1, size + 1)
        rows[:, size : 2 * size + 1, size + 2 :] = matrix.transpose(0, 2, 1)
        rows[:, -1, size + 2 :] = 2 * psi
        unit = (psi**2).sum(axis=1) - 1.0
        right = np.column_stack([residual + mu[:, None] * psi, _product(psi, matrix), unit])
        error = np.maximum(np.abs(right).max(axis=1), np.abs(mu))
        return _Linear(rows, right, error)

    def _move(self, open_: Index, change: Array) -> None:
        super()._move(open_, change)
        size = self.x.shape[1]
        self.mu[open_] += change[:, size]
        self.psi[open_] += change[:, size + 1 :]

    def _specials(self, open_: Index, matrix: Array, size: Array) -> list[Special | None]:
        """Branch points with the direction across the curve in the plane of its two tangents."""
        out: list[Special | None] = []
        for row, i in enumerate(open_.tolist()):
            curve, guess = self.curves[i], self.guesses[i]
            _, singular, vh = np.linalg.svd(matrix[row] * self.scale)
            kernel = vh[-2:]
            along = kernel @ (guess.tangent / self.scale)
            across = np.array([-along[1], along[0]]) @ kernel
            slope = float(singular[-2]) if len(singular) > 1 else 1.0
            multipliers = curve.multipliers(matrix[row])
            here = self.x[i].copy(), multipliers, across * self.scale, float(size[row]), slope
            out.append(Special(self.type, *here, 1.0 + 0.0j, float(guess.tangent[-1])))
        return out


def _signed(w: NDArray[Any], scale: Array) -> NDArray[Any]:
    """A null vector with its largest entry, in terms of the scale, positive: real ones have two signs."""
    if np.iscomplexobj(w):
        return w.copy()
    signed: Array = w if w[np.abs(w / scale).argmax()] > 0 else -w
    return signed.copy()


def _product(vectors: NDArray[Any], matrices: NDArray[Any]) -> NDArray[Any]:
    """Vectors times matrices, shapes (k, n) and (k, n, m)."""
    out: NDArray[Any] = (vectors[:, None, :] @ matrices)[:, 0]
    return out


_SYSTEMS: dict[SpecialType, type[_System]] = {
    one.type: one for one in (_Fold, _Doubling, _Torus, _BranchPoint)
}

ITERATIONS = 20
"""Newton iterations of one attempt."""

SPECIAL_RESIDUAL, SETTLED, SETTLED_NEARLY = 1e-11, 1e-7, 1e-12
"""Residual of a special point, and sizes of a Newton step after which the next one would be lost in rounding,
in terms of the scale: with the gradient of g there, and with that of an earlier point."""

SHORTER = 0.2
"""Part of the step before that a Newton step may be, for the gradient of g to serve for another one."""
