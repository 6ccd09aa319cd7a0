"""Cubics between points of curves, against the curve and NumPy's roots."""

import numpy as np
import pytest

from stridemap.solver.branches import cubics
from stridemap.solver.branches.stops import Stops

pytestmark = pytest.mark.quick


def circle(angle):
    """Points of the unit circle and their unit tangents, in a space with scales 1 and 2."""
    x = np.column_stack([np.cos(angle), 2 * np.sin(angle)])
    return x, np.column_stack([-np.sin(angle), 2 * np.cos(angle)])


def test_cubics_lie_on_a_circle_to_fourth_order():
    worst = []
    for step in (0.4, 0.2):
        (x0, t0), (x1, t1) = circle(np.array([0.3])), circle(np.array([0.3 + step]))
        curve = cubics.cubics(x0, x1, t0, t1, np.array([1.0, 2.0]))
        tau = np.linspace(0, 1, 21)
        there = np.array([cubics.value(curve, np.array([[one]]))[0] for one in tau])
        worst.append(np.abs(np.hypot(there[:, 0], there[:, 1] / 2) - 1).max())
        np.testing.assert_allclose(there[[0, -1]], [x0[0], x1[0]], atol=1e-15)
    assert worst[0] < 0.01 * 0.4**4
    assert 12 < worst[0] / worst[1] < 20


def test_pieces_and_roots_are_those_of_numpy():
    rng = np.random.default_rng(3)
    curve = rng.normal(size=(200, 4))
    number, low, high = cubics.monotonic(curve)
    for i in range(len(curve)):
        turns = np.roots(np.polyder(curve[i]))
        inside = sorted(t.real for t in turns if abs(t.imag) < 1e-12 and 0 < t.real < 1)
        np.testing.assert_allclose(low[number == i], [0.0, *inside], atol=1e-12)
        np.testing.assert_allclose(high[number == i], [*inside, 1.0], atol=1e-12)
    level = 0.5 * (cubics.value(curve[number], low) + cubics.value(curve[number], high))
    tau = cubics.root(curve[number], level, low, high)
    np.testing.assert_allclose(cubics.value(curve[number], tau), level, atol=1e-11)
    assert ((tau > low) & (tau < high)).all()


def test_a_stop_is_met_on_the_curve_and_not_beside_it_or_on_another_line():
    angle = np.array([0.5, 0.55, 0.9])
    on, _ = circle(angle)
    beside = on[[1]] * 1.001  # a hundredth of the distance of the two points
    stops = Stops(np.concatenate([on, beside, on[[1]]]), np.array([0, 0, 0, 0, 1]), np.array([1.0, 2.0]))
    (x, tangent), (y, new) = circle(np.array([0.5])), circle(np.array([0.6]))
    row, stop = stops.between(np.array([0]), x, y, tangent, new)
    assert (row.tolist(), stop.tolist()) == ([0], [1])  # not where it begins, nor far ahead
    assert stops.between(np.array([1]), x, y, tangent, new)[1].tolist() == [4]
