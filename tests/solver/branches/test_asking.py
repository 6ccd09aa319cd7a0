"""Searches that ask: what is answered together, and that nobody finds anything else for it."""

import itertools
from dataclasses import dataclass

import numpy as np
import pytest
import sympy as sp

import stridemap
from stridemap.solver.branches.arclength import CurvePoint
from stridemap.solver.branches.asking import Question, alone, asked, together
from stridemap.solver.branches.bifurcation import SpecialType
from stridemap.solver.branches.conditions import GaitEnd
from stridemap.solver.branches.curve import Correction
from stridemap.solver.branches.defining import Attempt
from stridemap.solver.branches.ends import Trial
from stridemap.solver.branches.equations import linearised
from stridemap.solver.branches.special import specials_between
from stridemap.solver.options import ContinuationOptions
from tests.oracles.maps import curve, p, x, y

CALLS = []


@dataclass(frozen=True)
class Square(Question):
    """Asks for the square of a number; even and odd ones are of two kinds."""

    number: int

    @property
    def kind(self):
        return self.number % 2

    @classmethod
    def answers(cls, questions):
        CALLS.append([one.number for one in questions])
        return [one.number**2 for one in questions]


def squares(*numbers):
    found = []
    for number in numbers:
        found.append((yield from asked(Square(number))))
    return found


@pytest.mark.quick
def test_questions_of_one_kind_are_answered_in_one_call():
    CALLS.clear()
    assert together([squares(2, 3), squares(), squares(4), squares(5, 7, 9)]) == [
        [4, 9],
        [],
        [16],
        [25, 49, 81],
    ]
    assert CALLS == [[2, 4], [5], [3, 7], [9]]
    assert alone(squares(6)) == [36]
    assert together([]) == []


def test_what_a_search_finds_does_not_depend_on_others():
    """To the bit: bifurcations of branches with coarse steps, several of them between two points."""
    coarse = ContinuationOptions(ds_max=0.3)
    found = stridemap.branches(
        "wobbling", "k", (5, 20), {"alpha": 0.25, "omega": 3.0}, seeds=3, options=coarse
    )
    pairs = [(branch.curve, *pair, coarse) for branch in found for pair in itertools.pairwise(branch.points)]
    each = [alone(specials_between(*pair)) for pair in pairs]
    assert sum(map(len, each)) > 5
    assert {str(special.type) for some in each for special in some} >= {"fold", "pd"}
    for some, others in zip(each, together(specials_between(*pair) for pair in pairs), strict=True):
        for one, other in zip(some, others, strict=True):
            assert one.type is other.type
            assert one.x.tobytes() == other.x.tobytes()
            assert (one.slope, one.residual, one.multiplier) == (
                other.slope,
                other.residual,
                other.multiplier,
            )
            assert np.asarray(one.null).tobytes() == np.asarray(other.null).tobytes()


def point_at(on, *place):
    """A point of no curve: a guess."""
    at = np.array(place, dtype=float)
    matrix, _ = on.linearised(at, 24)
    return CurvePoint(at, on.tangent(matrix, np.eye(len(at))[-1]), matrix, on.multipliers(matrix), 24)


u = x - sp.Rational(1, 2)
FOLD = curve(x + p - x**2 + x**3, y / 2 + x * p)
LOGISTIC = curve(p * x * (1 - x))
DELAYED = curve(p * x * (1 - y), x)
PITCHFORK = curve(sp.Rational(1, 2) + u + p * u - u**3 + y * u, y / 2 + p * u + u**2)
ATTEMPTS = {
    "fold": (
        SpecialType.FOLD,
        FOLD,
        [(0, 0, 1, 0), (0.1, 0.02, 1, 0.02), (0.02, 0, 1, 0.1), (0.2, 0.1, 1, 0.1)],
    ),
    "doubling": (SpecialType.PD, LOGISTIC, [(0.66, 1, 3), (0.7, 1, 2.8), (0.6, 1, 3.2), (2 / 3, 1, 3)]),
    "doubling of two steps": (
        SpecialType.PD,
        LOGISTIC.with_steps(2),
        [(0.84, 1, 0.44, 1, 3.44), (0.85, 1, 0.43, 1, 3.45), (0.8, 1, 0.5, 1, 3.3)],
    ),
    "torus": (
        SpecialType.NS,
        DELAYED,
        [(0.5, 0.5, 1, 2), (0.4, 0.45, 1, 1.8), (0.51, 0.5, 1, 2.1), (0.45, 0.45, 1, 1.9)],
    ),
    "branch point": (
        SpecialType.BP,
        PITCHFORK,
        [(0.5, 0, 1, 0), (0.52, 0.01, 1, 0.03), (0.5, 0.05, 1, -0.05), (0.55, 0, 1, 0.1)],
    ),
}


@pytest.mark.quick
@pytest.mark.parametrize("name", ATTEMPTS)
def test_newton_on_many_systems_ends_where_it_does_on_each(name):
    """From guesses so unequal that some end many steps before others."""
    kind, on, places = ATTEMPTS[name]
    attempts = [Attempt(kind, on, point_at(on, *place)) for place in places]
    each = [one for attempt in attempts for one in Attempt.answers([attempt])]
    assert all(each)
    for one, other in zip(each, Attempt.answers(attempts), strict=True):
        assert one.x.tobytes() == other.x.tobytes()
        assert (one.slope, one.residual, one.multiplier) == (other.slope, other.residual, other.multiplier)
        assert np.asarray(one.null).tobytes() == np.asarray(other.null).tobytes()


@pytest.mark.quick
def test_each_correction_has_a_derivative_and_a_resolution_of_its_own():
    """Some end after one step, and others after many."""
    on = curve(p * x * (1 - x), error=1e-6)
    across = np.array([0.0, 0.0, 1.0])
    asked_ = []
    for value, off, n_rk in ((2.5, 1e-2, 24), (2.7, 1e-10, 48), (2.9, 1e-5, 24), (3.1, 1e-3, 96)):
        near, _ = on.linearised(np.array([1 - 1 / value, 1.0, value + off]), 24)
        asked_.append(Correction(on, np.array([1 - 1 / value + off, 1.0, value]), across, n_rk, 30, near))
    each = [one for question in asked_ for one in Correction.answers([question])]
    assert all(one.converged for one in each)
    for one, other in zip(each, Correction.answers(asked_), strict=True):
        assert one.x.tobytes() == other.x.tobytes()


@pytest.mark.quick
def test_the_steps_of_a_chain_have_its_resolution():
    two = curve(p * x * (1 - x), error=1e-3).with_steps(2).equations
    place = np.array([0.8, 1.0, 0.5, 1.0, 3.2])
    _, together_ = linearised([two, two], np.array([place, place]), np.array([24, 48]))
    for n_rk, one in zip((24, 48), together_, strict=True):
        np.testing.assert_array_equal(one, two.linearised(place, n_rk)[1])


@pytest.mark.quick
def test_what_differs_is_not_answered_together():
    """Questions that differ in one thing only that their answers have in common."""

    class Both:
        def of_cycles(self, n_rk, u, params, n_steps, names):
            return {name: np.full(len(u), float(len(name))) for name in names}

    conditions, point = Both(), point_at(LOGISTIC, 0.5, 1, 3)
    names = [GaitEnd.CONTACT, GaitEnd.FRICTION, GaitEnd.CONTACT]
    trials = (asked(Trial(conditions, LOGISTIC, point, name)) for name in names)
    assert together(trials) == [7.0, 8.0, 7.0]
    two, other = LOGISTIC.with_steps(2), curve(p * x * (1 - x))
    corrections = [
        Correction(LOGISTIC, point.x, point.tangent, 24, 5),
        Correction(LOGISTIC, point.x, point.tangent, 24, 6),
        Correction(LOGISTIC, point.x, point.tangent, 24, 5, point.matrix),
        Correction(two, point.x, point.tangent, 24, 5),
        Correction(other, point.x, point.tangent, 24, 5),
        Correction(curve(p * x * (1 - x), width=2.0), point.x, point.tangent, 24, 5),
    ]
    assert len({one.kind for one in corrections}) == len(corrections)
    assert Correction(LOGISTIC, point.x + 1, point.tangent, 48, 5).kind == corrections[0].kind


def test_corrections_on_curves_with_other_parameters_are_answered_together():
    """Each with a resolution of its own, one of which does not converge."""
    both = [
        stridemap.branches("wobbling", "k", (10, 12), {"alpha": alpha, "omega": 3.0}, seeds=3)[0]
        for alpha in (0.25, 0.3)
    ]
    asked_ = []
    for branch, n_rk in zip(both, (48, 96), strict=True):
        point = branch.points[1]
        asked_.append(Correction(branch.curve, point.x + 1e-3, point.tangent, n_rk, 8))
        asked_.append(Correction(branch.curve, point.x + 10.0, point.tangent, n_rk, 8))
    assert len({one.kind for one in asked_}) == 1
    found = Correction.answers(asked_)
    for one, whole in zip(asked_, found, strict=True):
        (single,) = Correction.answers([one])
        assert whole.x.tobytes() == single.x.tobytes()
        assert whole.matrix.tobytes() == single.matrix.tobytes()
        assert whole.residual == single.residual
    assert [one.converged for one in found] == [True, False] * 2
