"""The ground's frame: what is declared upright has the numbers of the same walker declared along the ground.

A declaration in a frame that is not said is refused: state, period and multipliers would be right, and the
cost of transport, the friction and the clearance not.
"""

import numpy as np
import pytest
import sympy as sp

from stridemap.derive import SI, STANCE_FOOT, Body, Coordinate, Parameter, Touchdown, Walker, rolling_arc
from stridemap.derive.ground import in_ground_frame
from stridemap.derive.models import WALKERS, rimless_wheel, round_feet
from stridemap.errors import InputError
from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.cycles.search import continued
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from tests.oracles.rewritten import light_model

A = Coordinate("stance", "rad", "stance leg from the vertical, positive leaning back")
B = Coordinate("swing", "rad", "swing leg from the vertical, positive leaning back")
G = Parameter("g", 9.81, "m/s^2", "gravity", 0.0, lower_open=True)
SLOPE = Parameter("slope", 0.05235987755982988, "rad", "slope", -1.0, 1.0)
a, b, s = A.symbol, B.symbol, SLOPE.symbol


def along(angle):
    return sp.Matrix([-sp.sin(angle), sp.cos(angle)])


def papers(**changes):
    """The compass gait of Goswami's papers: y is vertical, and the feet touch down at q1 + q2 = -2 slope."""
    hip = STANCE_FOOT + along(a)
    bodies = (
        Body("hip", sp.Integer(10), hip),
        Body("stance leg", sp.Integer(5), STANCE_FOOT + along(a) / 2),
        Body("swing leg", sp.Integer(5), hip - along(b) / 2),
    )
    fields = {
        "name": "upright",
        "title": "Compass gait, upright",
        "reference": "Goswami et al., as printed",
        "units": SI,
        "coordinates": (A, B),
        "parameters": (G, SLOPE),
        "bodies": bodies,
        "gravity": sp.Matrix([0, -G.symbol]),
        "swing_foot": hip - along(b),
        "touchdown": Touchdown(a + b + 2 * s, region=a + s, rising=False),
        "relabel": {a: b, b: a},
        "section": {b: -a - 2 * s},
        "stance_angle": A,
        "search_box": {"stance": (0.22, 0.3), "dstance": (-1.0, 1.6), "dswing": (0.0, 1.6)},
        "period_range": (0.25, 1.6),
    }
    return Walker(**{**fields, **changes})


def near(model, guess, **params):
    solver = Solver.for_model(model, Interpreter())
    (orbit,) = continued(solver, model.point(params)[None, :], np.array([guess]))
    assert orbit.status == "converged"
    return orbit


def test_the_papers_frame_has_the_right_numbers():
    orbit = near(light_model(papers(ground=s)), [0.218, -1.09, -0.377, 0.734])
    expected = {
        "cot": np.sin(SLOPE.default),
        "friction": 0.2741622556,
        "clearance": -0.0035935664,
        "step_length": 0.5354454154,
    }
    assert {name: getattr(orbit, name) for name in expected} == pytest.approx(expected, rel=0, abs=2e-10)


def upright_round_feet():
    """The walker on round feet, its leg's angle from the vertical."""
    base, slope = round_feet.WALKER, round_feet.SLOPE.symbol
    q1, q2 = round_feet.q1, round_feet.q2
    return base.with_(
        name="upright",
        gravity=sp.Matrix([0, -1]),
        ground=slope,
        touchdown=Touchdown(q2 - 2 * (q1 + slope), region=q1 + slope),
        relabel={q1: q1 - q2, q2: -q2},
        section={q2: 2 * (q1 + slope)},
    )


def test_round_feet_roll_along_the_ground():
    walker = upright_round_feet()
    slope = dict((x.name, x.default) for x in walker.parameters)["slope"]
    guess = [0.189438283253 - slope, -0.239010987813, -0.051397006345, 2.427955842629]
    orbit = near(light_model(walker), guess)
    assert orbit.state["q1"] == pytest.approx(0.189438283253 - slope, abs=1e-11)
    assert orbit.period == pytest.approx(2.427955842629, abs=1e-11)
    there = near(load("round_feet"), [guess[0] + slope, *guess[1:]])
    for name in ("cot", "friction", "clearance", "step_length", "d_max", "cop_max", "impact_friction"):
        assert getattr(orbit, name) == pytest.approx(getattr(there, name), rel=0, abs=1e-10), name
    assert orbit.cop_max == 0


def test_what_a_torque_may_use_is_the_same():
    """Mass matrix and bias forces do not depend on the axes."""
    upright, level = upright_round_feet(), round_feet.WALKER
    slope = sp.Symbol("slope", real=True)
    place = dict(zip((*level.q, *level.v), (0.21, 0.33, -0.4, 0.5), strict=True))
    values = {x.symbol: x.default for x in level.parameters}
    ahead = {**values, **place, round_feet.q1: place[round_feet.q1] - values[slope]}
    for name in ("M", "h", "kinetic_energy"):
        mine, theirs = (
            np.array(sp.Matrix([getattr(w, name)]).subs(at).evalf().tolist(), dtype=float)
            for w, at in ((upright, ahead), (level, {**values, **place}))
        )
        np.testing.assert_allclose(mine, theirs, rtol=0, atol=1e-13)


@pytest.mark.quick
def test_points_are_turned_and_nothing_else():
    walker = papers(ground=s)
    seen = in_ground_frame(walker)
    at = {a: 0.2, b: -0.3, s: 0.1, G.symbol: 9.81, **dict.fromkeys(STANCE_FOOT, 0.0)}
    for mine, theirs in zip(seen.bodies, walker.bodies, strict=True):
        x, y = (float(e) for e in theirs.position.subs(at))
        turned = [x * np.cos(0.1) - y * np.sin(0.1), x * np.sin(0.1) + y * np.cos(0.1)]
        np.testing.assert_allclose([float(e) for e in mine.position.subs(at)], turned, atol=1e-15)
    pull = [float(e) for e in seen.gravity.subs(at)]
    np.testing.assert_allclose(pull, [9.81 * np.sin(0.1), -9.81 * np.cos(0.1)], rtol=1e-14)
    assert in_ground_frame(seen) is seen
    assert walker.with_(name="copied").ground == s  # a copy is not turned twice
    assert WALKERS["compass"].ground == 0


# -- what is refused ---------------------------------------------------------------------------------------

theta, lean, between = rimless_wheel.theta, rimless_wheel.SLOPE.symbol, rimless_wheel.between


def wheel(**changes):
    """The wheel seen by somebody who stands upright; on a slope or on stairs, it does not say."""
    return rimless_wheel.WALKER.with_(
        name="upright",
        gravity=sp.Matrix([0, -1]),
        touchdown=Touchdown(sp.cos(between / 2) - sp.cos(theta - lean), region=lean - theta),
        **changes,
    )


def with_stairs(**changes):
    """The compass on stairs: a condition that is zero with one foot a step above the other, either one."""
    rise = Parameter("step", 0.0, "m", "rise of a step")
    height = papers(ground=s).swing_foot[1] - STANCE_FOOT[1]
    rising = {
        "parameters": (G, SLOPE, rise),
        "touchdown": Touchdown(height**2 - rise.symbol**2 - sp.Rational(1, 400), region=a - b, rising=False),
        "section": {},
        "search_box": {"stance": (0.2, 0.1), "swing": (-0.2, 0.1), "dstance": (-1, 1), "dswing": (0, 1)},
    }
    return papers(**{**rising, **changes})


DOWNHILL = G.symbol * sp.Matrix([sp.sin(s), -sp.cos(s)])
LEVEL = Parameter("slope", 0.0, "rad", "slope", -1.0, 1.0)


@pytest.mark.quick
@pytest.mark.parametrize(
    ("make", "words"),
    [
        (papers, ["-0.0345045", "falls by 0.0523599 rad", "give ground"]),
        (lambda: papers(gravity=DOWNHILL), ["falls by 0.0523599 rad", "give ground"]),
        # Where the default slope is zero, others are tried.
        (lambda: papers(parameters=(G, LEVEL)), ["slope = 0.0", "give ground"]),
        (lambda: papers(ground=s, gravity=DOWNHILL), ["gravity", "upright", "leave ground out"]),
        (lambda: papers(ground=-s), ["correct ground = -slope"]),
        (lambda: papers(ground=2 * s), ["correct ground = 2*slope"]),
        (lambda: papers(ground=a), ["the ground's angle has the symbol stance"]),
        (lambda: papers(rise=b), ["the rise has the symbol swing"]),
        (lambda: papers(ground="steep"), ["the ground is 'steep'", "SymPy expression"]),
        (wheel, ["falls by 0.2 rad", "give ground", "for stairs give rise"]),
        (lambda: wheel(rise=2 * sp.sin(between / 2) * sp.sin(lean)), ["must be at 0.198669, the rise"]),
        (lambda: wheel(rise=-sp.sin(lean) / 2), ["must be at -0.0993347, the rise"]),
        (with_stairs, ["for stairs give rise"]),
    ],
)
def test_another_frame_is_refused(make, words):
    with pytest.raises(InputError) as refused:
        make()
    for word in words:
        assert word in str(refused.value)


@pytest.mark.quick
@pytest.mark.parametrize(
    "make",
    [
        lambda: papers(ground=s),
        lambda: papers(ground=s, parameters=(G, LEVEL)),
        lambda: wheel(ground=lean),
        lambda: wheel(rise=-2 * sp.sin(between / 2) * sp.sin(lean)),
        lambda: with_stairs(rise=sp.sqrt(sp.Symbol("step", real=True) ** 2 + sp.Rational(1, 400))),
        lambda: round_feet.WALKER.with_(stance=rolling_arc(round_feet.RADIUS.symbol, round_feet.q1)),
    ],
)
def test_a_frame_that_is_said_is_accepted(make):
    make()
