"""No tolerance has a unit: a model in other units gives the same table in those units."""

from functools import cache

import numpy as np
import pytest
import sympy as sp

from stridemap.codegen import derive_model
from stridemap.derive import UnitNames
from stridemap.derive.models import WALKERS
from stridemap.derive.models.rimless_wheel import WALKER as WHEEL
from stridemap.solver.api.points import find_orbits, simulate
from stridemap.solver.kernels.step_map import StepMap
from stridemap.solver.model.loading import load
from stridemap.solver.model.scales import Scales, rounded
from stridemap.solver.walks.simulator import Outcome
from tests.oracles.rescaled import Scale, factors, rescaled
from tests.oracles.rewritten import light_model

THOUSAND, THOUSANDTH = sp.Integer(1000), sp.Rational(1, 1000)
LARGE, SMALL = Scale(THOUSAND, THOUSAND, THOUSAND), Scale(THOUSANDTH, THOUSANDTH, THOUSANDTH)
MIXED = Scale(THOUSAND, THOUSANDTH, THOUSAND)
NAMES = {LARGE: "large", SMALL: "small", MIXED: "mixed"}

STARTS = 48
"""Enough for all cycles of these models at their presets."""

ROUNDING = ("residual", "integration_error", "state_error", "multiplier_error")
"""Errors, many of which are rounding: they are compared as such."""


@cache
def in_other_units(name, scale, derived=light_model):
    """A built-in model in other units."""
    return derived(rescaled(WALKERS[name], f"{name}_rescaled", scale))


@cache
def found(model, backend):
    """Its limit cycles in the units that it has."""
    return find_orbits(model, backend=backend, options={"starts": STARTS})


@pytest.mark.parametrize(
    ("name", "scale", "backend"),
    [
        ("rimless_wheel", LARGE, "interpreter"),
        ("rimless_wheel", SMALL, None),
        ("rimless_wheel", MIXED, "interpreter"),
        ("simplest_walker", LARGE, "interpreter"),
        ("simplest_walker", MIXED, "interpreter"),
        ("goswami_compass", LARGE, "interpreter"),
        ("compass", SMALL, "interpreter"),
        ("wobbling", SMALL, "interpreter"),
        ("wobbling", MIXED, "interpreter"),
    ],
    ids=lambda one: NAMES.get(one, one) or "compiled",
)
def test_tables_scale(name, scale, backend):
    """Each model in some units, and some models in each: a tolerance with a unit is wrong for all.

    The smallest is shortened and compiled as well, which takes longer than to run it.
    """
    walker, model = WALKERS[name], load(name)
    other = in_other_units(name, scale, light_model if backend else derive_model)
    orbits, scaled = found(model, backend), find_orbits(other, backend=backend, options={"starts": STARTS})
    assert len(scaled) == len(orbits) > 0
    of = {str(symbol): float(factor) for symbol, factor in factors(walker, scale).items()}
    unit = np.array([*(of[entry] for entry in model.section), float(scale.time)])
    np.testing.assert_allclose(scaled.u / unit, orbits.u, rtol=1e-12, atol=1e-13)
    np.testing.assert_allclose(scaled.multipliers, orbits.multipliers, rtol=1e-12, atol=1e-12)
    assert scaled.status.tolist() == orbits.status.tolist()
    for quantity in model.measured.values():
        old, new = orbits.measures[quantity.name], scaled.measures[quantity.name]
        if quantity.name in ROUNDING:
            np.testing.assert_allclose(new, old, rtol=0.3, atol=2e-13)
        elif quantity.type == "float":
            np.testing.assert_allclose(
                new / float(scale.of(quantity.kind)), old, rtol=1e-12, atol=1e-13, err_msg=quantity.name
            )
        else:
            assert new.tolist() == old.tolist(), quantity.name


@pytest.mark.parametrize("scale", [LARGE, SMALL], ids=["large", "small"])
def test_a_walk_waits_for_touchdown_in_any_unit(scale):
    """The period is 2310 or 0.00231: a limit in the model's unit of time would be too short or too long."""
    other = in_other_units("rimless_wheel", scale)
    (orbit,) = find_orbits(other, backend="interpreter", options={"starts": STARTS})
    walk = simulate(other, orbit.state, steps=3)
    assert walk.outcome is Outcome.WALKED
    assert [step.period for step in walk.steps] == pytest.approx([orbit.period] * 3, rel=1e-9)


@pytest.mark.quick
def test_the_scales_of_the_built_in_models_are_their_units():
    """Within a quarter: the centre of mass is a little lower than a leg is long."""
    for name in ("compass", "goswami_compass", "rimless_wheel", "simplest_walker", "wobbling"):
        scales = Scales.of(load(name))
        assert 0.75 <= scales.length <= 1.0
        assert scales.time == pytest.approx(np.sqrt(scales.length), rel=0.02)  # on a slope gravity is 1, too
        assert np.log2(rounded(scales.unknowns)).tolist() == [0] * len(scales.unknowns)
        of = dict(zip(load(name).section, scales.section, strict=True))
        assert all(of[entry] == 1 for entry in of if entry.startswith("theta"))
        assert all(of[entry] == 1 / scales.time for entry in of if entry.startswith("dtheta"))


@pytest.mark.quick
def test_the_scales_have_the_units_of_the_model():
    """A thousandth of the length, and a thousand times the time, which gravity then says."""
    scales = Scales.of(light_model(rescaled(WHEEL, "other_units", MIXED)))
    natural = Scales.of(load("rimless_wheel"))
    assert scales.length == pytest.approx(1e-3 * natural.length, rel=1e-12)
    assert scales.time == pytest.approx(1e3 * natural.time, rel=1e-12)
    assert scales.section == pytest.approx((1.0, 1e-3 / natural.time), rel=1e-12)


def test_the_periods_that_are_searched_by_default_are_the_models_own():
    """In units of one's own they follow from gravity and the centre of mass, here 9.81 m/s^2 at 1 m."""
    given = {"gravity": WHEEL.gravity * sp.Rational("9.81"), "period_range": None}
    natural = WHEEL.with_(period_range=None)
    assert natural.period_range == (0.3, 3.0)
    metres = WHEEL.with_(**given, units=UnitNames("kg", "m", "s", "J"))
    assert metres.period_range == pytest.approx(np.array([0.3, 3.0]) / np.sqrt(9.81))


@pytest.mark.quick
def test_newton_in_scaled_unknowns_has_the_same_solution():
    model = load("compass")
    step_map, point = StepMap(model), model.point({})
    guess = np.array([0.1, -0.15, 0.0, 1.22])
    one = step_map.rootfinder(24, 10, 1e-13, 1e-9)
    assert np.abs(np.array(step_map.residual(24)(one(guess, point), point))).max() < 1e-12
