"""The model files in examples/models: limits in which each becomes a walker that is known."""

import importlib.util
import math
from functools import cache

import numpy as np
import pytest

import stridemap
from stridemap.derive import Body
from stridemap.derive.models.compass import WALKER as COMPASS
from stridemap.derive.models.compass import theta1, theta2
from stridemap.solver.model.loading import available
from stridemap.solver.model.model import Model
from tests.oracles.rewritten import light_model
from tests.oracles.walkers import EXAMPLES, example

pytestmark = pytest.mark.usefixtures("in_this_process")

TORSO, ROLLING, VERTICAL = "swinging_torso", "rolling_feet", "vertical_wobbling"


@cache
def loaded(name):
    return stridemap.load(name if name in available() else example(name))


COMPILED = {*available(), TORSO}
"""Models whose kernels in C are tried, as are those of the built-in ones: to compile those of a walker takes
twenty seconds, and to find its cycles in CasADi's virtual machine takes one."""


def stable(model, **params):
    """The one stable limit cycle of a point, of a walker that is given or of one by name."""
    model = model if isinstance(model, Model) else loaded(model)
    backend, starts = (None, 512) if model.name in COMPILED else ("interpreter", 128)
    found = stridemap.find_orbits(model, params, backend=backend, options={"starts": starts})
    (orbit,) = [o for o in found if o.stable]
    return orbit


def apart(orbit, other, names=("theta1", "dtheta1", "dtheta2")):
    """Largest difference of two cycles in the period and some coordinates."""
    return max(abs(orbit.period - other.period), *(abs(orbit.state[n] - other.state[n]) for n in names))


POSITION = ("theta1",)
"""What a stiff spring leaves alone: it takes up the impact a moment later, so rates just after it differ."""


def halvings(differences):
    """How often each difference halves to the next."""
    return np.log2(np.divide(differences[:-1], differences[1:]))


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.py")), ids=lambda path: path.stem)
def test_short_and_with_a_stable_gait(path):
    assert len(path.read_text().splitlines()) < 60
    assert path == example(path.stem)
    orbit = stable(path.stem)
    assert orbit.status == "converged"
    assert orbit.min_vertical_force > 0
    walk = stridemap.simulate(path, orbit.state, steps=3)
    assert walk.steps[-1].period == pytest.approx(orbit.period, abs=1e-9)


def test_a_torso_without_mass_leaves_the_compass_walker():
    compass = stable("compass")
    masses = (4e-3, 2e-3, 1e-3)
    found = [apart(stable(TORSO, alpha=m, k=20 * m, c=m), compass) for m in masses]
    assert found[-1] < 1e-3
    np.testing.assert_allclose(halvings(found), 1, atol=0.05)  # first order in the mass


def test_a_stiff_damped_torso_is_one_body_with_the_line_between_the_legs():
    spec = importlib.util.spec_from_file_location("swinging_torso", example(TORSO))
    torso = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(torso)
    rigid = COMPASS.with_(
        name="rigid_torso",
        parameters=(torso.ALPHA, torso.R, *COMPASS.parameters),
        bodies=(
            Body("hip", 1 - torso.alpha, torso.hip),
            Body("torso", torso.alpha, torso.mass.subs(torso.psi, theta2 / 2 - theta1)),
            *torso.feet,
        ),
    )
    limit = stable(light_model(rigid))
    found = []
    for k in (100, 400, 1600):
        orbit = stable(TORSO, k=k, c=math.sqrt(k * 0.25 * 0.75 * 0.5**2))  # half of critical, hip free
        found.append(apart(orbit, limit, POSITION))
        assert abs(orbit.multipliers[0] - limit.multipliers[0]) < 0.05 / k
    assert found[-1] < 5e-4
    np.testing.assert_allclose(halvings(found), 2, atol=0.15)  # first order in 1/k


def test_feet_of_radius_zero_are_points():
    compass, orbit = stable("compass"), stable(ROLLING, radius=0)
    assert apart(orbit, compass) < 1e-11
    np.testing.assert_allclose(orbit.multipliers, compass.multipliers, rtol=0, atol=1e-10)
    for name in ("d_max", "work", "cot", "min_vertical_force", "friction", "clearance", "step_length"):
        assert getattr(orbit, name) == pytest.approx(getattr(compass, name), abs=1e-9), name


def test_a_stiff_damped_vertical_spring_leaves_the_compass_walker():
    compass = stable("compass")
    found = [
        apart(stable(VERTICAL, k=k, c=math.sqrt(k * 0.25 * 0.75)), compass, POSITION)
        for k in (100, 400, 1600)
    ]
    assert found[-1] < 1e-3
    np.testing.assert_allclose(halvings(found), 2, atol=0.2)
