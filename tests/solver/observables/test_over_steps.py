"""How the measures of two steps are those of a cycle, from what they are: energies, lengths and times."""

import numpy as np
import pytest

from stridemap.quantities import QUANTITIES
from stridemap.solver.observables.over_steps import over_steps

pytestmark = pytest.mark.quick

LENGTH, TIME, ENERGY, WEIGHT = np.array([0.2, 0.5]), np.array([1.0, 1.6]), np.array([0.03, 0.01]), 1.3
"""Of a short and a long step of one cycle."""


def of_cycle(length=LENGTH, **steps):
    """Measures of the cycle of both steps."""
    columns = {"step_length": length, **steps}
    found = over_steps(QUANTITIES, columns, TIME[None, :], 2)
    return {name: None if value is None else value[0] for name, value in found.items()}


@pytest.mark.parametrize("length", [LENGTH, LENGTH * [-1, 1], LENGTH * [1, -1], LENGTH * [-1e-14, 1]])
def test_costs_and_speed_are_those_of_the_whole_way(length):
    """Also where a step leads back, or hardly leads anywhere: its cost by itself is then enormous."""
    found = of_cycle(
        length,
        speed=length / TIME,
        cot=ENERGY / (WEIGHT * np.abs(length)),
        cot_per_speed=ENERGY * TIME / (WEIGHT * np.abs(length)),
        work=ENERGY,
    )
    way = np.abs(length.sum())
    assert found["step_length"] == pytest.approx(length.sum())
    assert found["speed"] == pytest.approx(length.sum() / TIME.sum())
    assert found["work"] == pytest.approx(ENERGY.sum())
    assert found["cot"] == pytest.approx(ENERGY.sum() / (WEIGHT * way))
    assert found["cot_per_speed"] == pytest.approx(ENERGY.sum() * TIME.sum() / (WEIGHT * way))


def test_extremes_are_those_of_the_worst_step():
    found = of_cycle(d_max=np.array([0.1, 0.4]), min_vertical_force=np.array([0.7, -0.2]))
    assert (found["d_max"], found["min_vertical_force"]) == (0.4, -0.2)
    assert of_cycle(clearance=np.array([-0.1, -0.3]))["clearance"] == -0.3


def test_what_a_model_lacks_it_lacks_over_two_steps():
    assert of_cycle(group=None)["group"] is None
