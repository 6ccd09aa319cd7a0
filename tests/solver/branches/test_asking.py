"""Searches that ask: what is answered together, and that nobody finds anything else for it."""

import itertools
from dataclasses import dataclass

import numpy as np
import pytest

import stridemap
from stridemap.solver.branches.asking import Question, alone, asked, together
from stridemap.solver.branches.curve import Correction
from stridemap.solver.branches.special import specials_between
from stridemap.solver.options import ContinuationOptions

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
