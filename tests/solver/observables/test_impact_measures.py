"""What the impact asks of the ground, and whether it lets the other foot go."""

import math

import numpy as np
import pytest

import stridemap
from stridemap.quantities import QUANTITIES


def at_the_impact(orbit):
    """State just before and just after the impact, with the generated functions of the model."""
    model, p = orbit.model, orbit.model.point(orbit.params)
    seen = stridemap.motion(orbit, 3)
    return model, p, {"t": seen.t[-1], "q": seen.q[-1], "v": seen.v[-1]}, {"q": seen.q[0], "v": seen.v[0]}


@pytest.mark.quick
def test_the_compass_gait():
    """Independent values at slope 0.0525: impulse ratios, and the velocity of the trailing foot."""
    short, long = stridemap.find_orbits("goswami_compass", slope=0.0525)
    assert short.impact_friction == pytest.approx(0.384, abs=5e-4)
    assert long.impact_friction == pytest.approx(0.246, abs=5e-4)
    assert long.lift_off_speed == pytest.approx(0.126, abs=5e-4)
    model, p, _, after = at_the_impact(long)
    foot = model.evaluate("swing_foot", **after, p=p)["dfoot"]
    assert foot == pytest.approx([0.220, 0.126], abs=5e-4)
    assert foot[1] == pytest.approx(long.lift_off_speed, abs=1e-9)
    assert short.trailing_lifts_off
    assert long.trailing_lifts_off
    # The step alone asks for less than the impact of the short gait does.
    assert short.friction < short.impact_friction


@pytest.mark.parametrize("spokes", [6, 8, 13])
def test_a_wheel_with_its_mass_at_the_hub(spokes):
    """The impulse is along the new spoke; the hub turns about its tip, and so does the tip behind."""
    (orbit,) = stridemap.find_orbits("rimless_wheel", spokes=spokes, lambda2=1.0, slope=0.2)
    assert orbit.impact_friction == pytest.approx(math.tan(math.pi / spokes), rel=1e-11)
    leaves = orbit.state["dtheta"] * 2 * math.sin(math.pi / spokes)
    assert orbit.lift_off_speed == pytest.approx(leaves, rel=1e-12)
    assert orbit.trailing_lifts_off


def test_the_impulse_is_the_change_of_momentum():
    """On two legs with point masses: the masses' momentum after the impact less that before it."""
    for orbit in stridemap.find_orbits("goswami_compass", slope=0.0525):
        model, p, before, after = at_the_impact(orbit)
        mass = model.evaluate("total_mass", p=p)["mass"]
        came, goes = (
            model.evaluate("centre_of_mass", **{k: s[k] for k in "qv"}, p=p)["dcom"] for s in (before, after)
        )
        impulse = mass * (goes - came)
        assert orbit.impact_friction == pytest.approx(abs(impulse[0]) / impulse[1], rel=1e-8)


def test_a_round_foot_leaves_the_ground_with_the_centre_of_its_arc():
    for orbit in stridemap.find_orbits("round_feet"):
        model, p, _, after = at_the_impact(orbit)
        foot = model.evaluate("swing_foot", **after, p=p)["dfoot"]
        assert orbit.lift_off_speed == pytest.approx(foot[1], abs=1e-9)
        assert orbit.trailing_lifts_off


def test_a_foot_that_stays_down_is_reported():
    """A wheel with a large moment of inertia would have to reverse: here, the multiplier mu is below 0."""
    orbits = stridemap.find_orbits("rimless_wheel", spokes=3, lambda2=0.9, slope=1.2)
    assert (orbits.trailing_lifts_off == (orbits.lift_off_speed > 0)).all()
    every = stridemap.find_orbits("wobbling", k=6)
    assert every.trailing_lifts_off.dtype == np.bool_


def test_friction_says_what_it_leaves_out():
    assert "without the impulse of the impact" in QUANTITIES["friction"].definition
