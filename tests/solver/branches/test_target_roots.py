"""Solutions along a branch on which a quantity is a known function of the parameter."""

from types import SimpleNamespace

import numpy as np
import pytest

from stridemap.solver.branches.arclength import Window
from stridemap.solver.branches.targets import _may_reach, _on_branch
from tests.oracles.maps import curve, p, x

pytestmark = pytest.mark.quick


class Cycles:
    """Cycles of the map whose fixed point is p, in the place of limit cycles that were found."""

    model = SimpleNamespace(spec=SimpleNamespace(names=("p",)))

    def __init__(self, u, values):
        self.u, self.params = np.asarray(u, dtype=float), np.reshape(values, (-1, 1)).astype(float)
        self.found = np.ones(len(self.u), dtype=bool)

    def __len__(self):
        return len(self.u)

    def take(self, rows):
        return Cycles(self.u[rows], self.params[rows, 0])


class Target:
    """A quantity as a function of the fixed point, and its wanted value."""

    parameter = "p"

    def __init__(self, function, value):
        self.function, self.value = function, value

    def of(self, cycles):
        return np.array([self.function(z) for z in cycles.u[:, 0]])


def solutions(function, value, nodes):
    """Values of p at which the quantity has the value, from cycles at some nodes."""
    line = SimpleNamespace(
        curve=curve(x + x - p),
        window=Window((-1.0,), (2.0,), 0.5, 1.5),
        solver=SimpleNamespace(converge=lambda u, params, _: Cycles(u, params[:, 0])),
        params=lambda values: np.reshape(values, (-1, 1)),
    )
    orbits = Cycles([[node, 1.0] for node in nodes], nodes)
    found = [one.params[0, 0] for one in _on_branch(line, orbits, Target(function, value))]
    return sorted({round(one, 12): one for one in found}.values())


NODES = np.linspace(0.0, 1.0, 5)


def test_a_change_of_sign_is_solved():
    assert solutions(lambda z: z**3, 0.2, NODES) == pytest.approx([0.2 ** (1 / 3)], abs=1e-14)
    assert solutions(lambda z: z, 0.5, NODES) == [0.5]  # at a cycle that is there


@pytest.mark.parametrize("off", [1e-3, 1e-6])
def test_two_solutions_around_a_turning_point_are_found(off):
    """The largest value lies between two cycles, and the wanted one a little below."""
    found = solutions(lambda z: 1 - (z - 0.3) ** 2, 1 - off, NODES)
    assert found == pytest.approx([0.3 - off**0.5, 0.3 + off**0.5], abs=1e-9)


def test_a_value_beyond_the_turning_point_has_no_solution():
    assert solutions(lambda z: 1 - (z - 0.3) ** 2, 1 + 1e-6, NODES) == []


def test_a_jump_over_the_value_is_not_a_solution():
    assert solutions(lambda z: z + (z > 0.4), 1.0, NODES) == []
    assert solutions(lambda z: z + (z > 0.4), 1.6, NODES) == pytest.approx([0.6], abs=1e-14)


@pytest.mark.parametrize(
    ("away", "expected"),
    [
        ((1.0, 0.1, 0.15), True),  # the parabola reaches zero nearly
        ((-1.0, -0.1, -0.15), True),
        ((1.0, 1.0, 1.0), False),
        ((1.0, 0.5, 0.1), False),  # it goes on to fall
        ((0.3, 0.25, 0.3), False),  # it turns far away
        ((1.0, -0.1, 0.15), False),
        ((1.0, np.nan, 0.15), False),
    ],
)
def test_where_a_turning_point_is_looked_at(away, expected):
    assert _may_reach(np.array(away)) == expected
