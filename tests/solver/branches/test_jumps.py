"""A step onto a curve that runs beside is noticed, a step along a bend is not."""

import numpy as np
import pytest

from stridemap.solver.branches.arclength import CurvePoint, _jumps

DS = 0.05


class Plane:
    """What is needed of a curve: its norm."""

    @staticmethod
    def norm(x):
        return float(np.linalg.norm(x))


def point(x, tangent):
    return CurvePoint(np.array(x), np.array(tangent), np.empty((0, 0)), np.empty(0, complex), 24)


@pytest.mark.parametrize("degrees", [0.5, 3.0, 7.0, 14.0])
def test_along_a_circle_nothing_is_noticed(degrees):
    turn = np.deg2rad(degrees)
    radius = DS / turn
    there = radius * np.sin(turn), radius * (1 - np.cos(turn))
    assert not _jumps(Plane(), point((0.0, 0.0), (1.0, 0.0)), point(there, (np.cos(turn), np.sin(turn))))


@pytest.mark.parametrize("beside", [0.0005, -0.0016, 0.003])
def test_onto_a_parallel_line_it_is(beside):
    """The doublings at k = 33.3, alpha = 0.28 of the wobbling walker are 0.0029 apart."""
    assert _jumps(Plane(), point((0.0, 0.0), (1.0, 0.0)), point((DS, beside), (1.0, 0.0)))
    assert not _jumps(Plane(), point((0.0, 0.0), (1.0, 0.0)), point((DS, 0.0), (1.0, 0.0)))
