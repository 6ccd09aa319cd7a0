"""How the measures of two steps are those of a cycle, from what they are: energies, lengths and times."""

import numpy as np
import pytest

from stridemap.quantities import QUANTITIES
from stridemap.solver.observables.over_steps import over_steps

pytestmark = pytest.mark.quick

LENGTH, TIME, ENERGY, WEIGHT = np.array([0.2, 0.5]), np.array([1.0, 1.6]), np.array([0.03, 0.01]), 1.3
"""Of a short and a long step of one cycle."""


def of_cycle(**steps):
    """Measures of the cycle of both steps."""
    columns = {"step_length": LENGTH, **steps}
    found = over_steps(QUANTITIES, columns, TIME[None, :], 2)
    return {name: None if value is None else value[0] for name, value in found.items()}


def test_costs_and_speed_are_those_of_the_whole_way():
    found = of_cycle(
        speed=LENGTH / TIME,
        cot=ENERGY / (WEIGHT * LENGTH),
        cot_per_speed=ENERGY * TIME / (WEIGHT * LENGTH),
        work=ENERGY,
    )
    assert found["step_length"] == pytest.approx(LENGTH.sum())
    assert found["speed"] == pytest.approx(LENGTH.sum() / TIME.sum())
    assert found["work"] == pytest.approx(ENERGY.sum())
    assert found["cot"] == pytest.approx(ENERGY.sum() / (WEIGHT * LENGTH.sum()))
    assert found["cot_per_speed"] == pytest.approx(ENERGY.sum() * TIME.sum() / (WEIGHT * LENGTH.sum()))


def test_extremes_are_those_of_the_worst_step():
    found = of_cycle(d_max=np.array([0.1, 0.4]), min_vertical_force=np.array([0.7, -0.2]))
    assert (found["d_max"], found["min_vertical_force"]) == (0.4, -0.2)
    assert of_cycle(clearance=np.array([-0.1, -0.3]))["clearance"] == -0.3


def test_what_a_model_lacks_it_lacks_over_two_steps():
    assert of_cycle(group=None)["group"] is None
