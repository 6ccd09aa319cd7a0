"""Zeros and extrema between the nodes of a trace, of functions whose zeros are known.

A made-up trace has one observable, a polynomial or a sine; its "integrator" gives the function itself. Nodes
are 0.1 apart, so that pairs and triples of zeros lie between two of them.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from numpy.polynomial import Polynomial

from stridemap.solver.backends.base import Advanced
from stridemap.solver.observables.events import (
    LOCATE_TOLERANCE,
    Trace,
    brackets,
    locate,
    turning_brackets,
)
from stridemap.solver.observables.reductions import count_zeros, earlier_touchdown, extreme

pytestmark = pytest.mark.quick

NODES = 11


@dataclass(frozen=True)
class Drawn(Trace):
    """A trace of functions that are known, one for each orbit; the state is the time."""

    functions: tuple[Any, ...] = ()

    @classmethod
    def of_functions(cls, *functions):
        t = np.linspace(0, 1, NODES)
        g, dg = (
            np.array([f(t) for f in which])[..., None]
            for which in (functions, [f.deriv() for f in functions])
        )
        w = np.repeat(t[None, :, None], len(functions), axis=0)
        n = len(functions)
        return cls(None, np.zeros((n, 0)), np.ones(n), w, g, dg, functions)

    def row(self, name):
        return 0

    def advance(self, orbit, node, tau):
        t = node * self.h[orbit] + tau
        g, dg = (
            np.array([f(x) for f, x in zip(which, t, strict=True)])[:, None]
            for which in (
                [self.functions[i] for i in orbit],
                [self.functions[i].deriv() for i in orbit],
            )
        )
        return Advanced(t[:, None], g, dg)


class Sine:
    """``sin(rate t + phase)``, or its derivative."""

    def __init__(self, rate, phase=0.0, factor=1.0):
        self.rate, self.phase, self.factor = rate, phase, factor

    def __call__(self, t):
        return self.factor * np.sin(self.rate * t + self.phase)

    def deriv(self):
        return Sine(self.rate, self.phase + np.pi / 2, self.factor * self.rate)


ZEROS = {
    "one in an interval": (0.31,),
    "two in an interval": (0.31, 0.33),
    "two in an interval, falling": (0.31, 0.33, 0.52),
    "two in an interval that rises on the whole": (0.31, 0.33, 0.405),
    "three in an interval": (0.31, 0.34, 0.38),
    "three in one, and one further on": (0.31, 0.34, 0.38, 0.73),
    "in the first and the last interval": (0.02, 0.07, 0.93, 0.96),
    "at a node": (0.3, 0.62),
}


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("zeros", ZEROS.values(), ids=ZEROS)
def test_every_zero_is_found(zeros, sign):
    trace = Drawn.of_functions(sign * Polynomial.fromroots(zeros))
    found = brackets(trace, "drawn")
    t, w, g = locate(trace, found)
    assert len(t) == len(zeros)
    np.testing.assert_allclose(t, zeros, rtol=0, atol=2 * LOCATE_TOLERANCE * 0.1)
    np.testing.assert_array_equal(w[:, 0], t)
    assert np.abs(g).max() < 1e-6
    rises = found.f_lower < found.f_upper
    assert (rises[:-1] != rises[1:]).all()
    assert (count_zeros(trace, "drawn") == len(zeros)).all()
    for falling in (True, False):
        assert count_zeros(trace, "drawn", np.array([falling])) == np.count_nonzero(rises != falling)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("turns", [(0.55,), (0.31, 0.33), (0.22, 0.64, 0.67)])
def test_every_turning_point_is_found(turns, sign):
    function = sign * Polynomial.fromroots(turns).integ()
    trace = Drawn.of_functions(function)
    found = turning_brackets(trace, "drawn")
    t, _, g = locate(trace, found)
    assert len(t) == len(turns)
    np.testing.assert_allclose(t, turns, rtol=0, atol=2 * LOCATE_TOLERANCE * 0.1)
    # What is read off is stationary there: the error left is the square.
    np.testing.assert_allclose(g[:, 0], [function(x) for x in turns], rtol=0, atol=1e-13)


def test_turning_points_are_found_where_they_are_looked_for():
    turns = np.array([0.22, 0.64, 0.67])
    trace = Drawn.of_functions(Polynomial.fromroots(turns).integ())
    for interval, found in ((2, turns[:1]), (6, turns[1:]), (4, [])):
        within = np.array([0]), np.array([interval])
        t, _, _ = locate(trace, turning_brackets(trace, "drawn", within))
        np.testing.assert_allclose(t, found, rtol=0, atol=2 * LOCATE_TOLERANCE * 0.1)


def test_zeros_of_many_orbits_are_in_order():
    functions = [Sine(rate, 0.4) for rate in (3.0, 9.0, 25.0)]
    trace = Drawn.of_functions(*functions)
    found = brackets(trace, "drawn")
    t, _, _ = locate(trace, found)
    for i, f in enumerate(functions):
        mine = t[found.orbit == i]
        exact = (np.pi * np.arange(1, 10) - f.phase) / f.rate
        np.testing.assert_allclose(mine, exact[exact < 1], rtol=0, atol=2 * LOCATE_TOLERANCE * 0.1)
        assert (np.diff(mine) > 0).all()
    assert (np.diff(found.orbit) >= 0).all()


@pytest.mark.parametrize(
    ("zeros", "early"),
    [
        ((1.0,), False),
        ((0.92, 0.96, 1.0), True),  # in the interval that ends with the touchdown
        ((0.31, 0.38, 1.0), True),
        ((0.35, 1.0), False),  # the foot leaves the ground and comes down
        ((-0.5, 0.42, 1.0), False),
    ],
)
def test_a_touchdown_before_the_end_of_the_step_is_early(zeros, early):
    """The condition rises through zero at the end, whatever it did before."""
    function = Polynomial.fromroots(zeros)
    trace = Drawn.of_functions(function if function.deriv()(1.0) > 0 else -function)
    ahead = np.full((1, NODES), -1.0)
    assert earlier_touchdown(trace, ahead).tolist() == [early]
    assert earlier_touchdown(trace, -ahead).tolist() == [False]  # none counts behind


@pytest.mark.parametrize(
    ("function", "largest", "smallest", "modulus"),
    [
        (Sine(7.0, 0.1), 1.0, -1.0, 1.0),
        (Sine(1.0, -0.2), np.sin(0.8), -np.sin(0.2), np.sin(0.8)),  # at the ends
        (Sine(2.0, 0.0, -1.0), 0.0, -1.0, 1.0),
        (Polynomial([0.2, 0.0, -1.0]) + Polynomial([0.0, 0.9]), 0.4025, 0.1, 0.4025),
    ],
)
def test_extremes_over_continuous_time_and_at_the_ends(function, largest, smallest, modulus):
    trace = Drawn.of_functions(function)
    found = [extreme(trace, "drawn")[0], -extreme(trace, "drawn", np.negative)[0]]
    found.append(extreme(trace, "drawn", np.absolute)[0])
    # Half the curvature times the square of what the time may be off by.
    off = 0.5 * 50 * (LOCATE_TOLERANCE * 0.1) ** 2
    assert found == pytest.approx([largest, smallest, modulus], rel=0, abs=off)


def test_a_turning_point_beside_low_nodes_may_be_the_highest():
    """The highest node is at the end; between two lower ones a narrow peak is higher than that."""
    bump = Sine(10 * np.pi)  # zero at all nodes
    hidden = Polynomial([0.0, 0.5])
    trace = Drawn.of_functions(Both(bump, hidden))
    t = np.linspace(0, 1, 2_000_001)
    exact = Both(bump, hidden)(t).max()
    assert exact > 1.4
    assert extreme(trace, "drawn")[0] == pytest.approx(exact, abs=1e-9)


class Both:
    """The sum of two functions."""

    def __init__(self, one, other):
        self.one, self.other = one, other

    def __call__(self, t):
        return self.one(t) + self.other(t)

    def deriv(self):
        return Both(self.one.deriv(), self.other.deriv())
