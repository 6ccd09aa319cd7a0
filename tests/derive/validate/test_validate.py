"""Declarations that contradict themselves: each is refused in one sentence that names what is wrong.

Every case is a small change of a valid declaration.
"""

import math

import pytest
import sympy as sp

from stridemap.derive import (
    STANCE_FOOT,
    TIME,
    Body,
    Clock,
    Coordinate,
    Line,
    Massless,
    Parameter,
    Touchdown,
    UnitNames,
)
from stridemap.derive.emit import emit
from stridemap.derive.mechanics import Mechanics
from stridemap.derive.models import WALKERS
from stridemap.derive.validate.section import validate_section_rates
from stridemap.errors import InputError

pytestmark = pytest.mark.quick

COMPASS, WOBBLING = WALKERS["compass"], WALKERS["wobbling"]
SIMPLEST, WHEEL = WALKERS["simplest_walker"], WALKERS["rimless_wheel"]
THETA1, THETA2 = COMPASS.coordinates
X = WOBBLING.coordinates[2]
THETA, PHI = SIMPLEST.coordinates
theta1, theta2, x, phi = THETA1.symbol, THETA2.symbol, X.symbol, PHI.symbol
beta = sp.Symbol("beta", real=True)
OTHER = Coordinate("other", "rad", "an angle that nothing has")
HIP, *FEET = COMPASS.bodies


def parameter(name, default=1.0, *limits):
    return Parameter(name, default, "1", "a meaning", *limits)


def more(*parameters, **changes):
    """The compass with further parameters."""
    return {"parameters": (*COMPASS.parameters, *parameters), **changes}


def body(position, mass=beta, **more):
    return Body("cargo", mass, position, **more)


def with_cargo(position, mass=beta, **rotation):
    return {"bodies": (*COMPASS.bodies, body(position, mass, **rotation))}


def boxes(walker, **changes):
    return {"search_box": {**walker.search_box, **changes}}


# -- names, shapes, symbols ----------------------------------------------------------------------------------

NAMES = [
    ({"name": "my walker"}, "the model 'my walker' cannot be a name in generated code; use letters"),
    (more(parameter("2k")), "the parameter '2k' cannot be a name in generated code"),
    (more(parameter("_k")), "the parameter '_k' cannot be a name in generated code"),
    (more(parameter("größe")), "the parameter 'größe' cannot be a name in generated code"),
    (more(parameter(3)), "the name of the parameter is 3; it must be a text"),
    (
        {"drawing": (Line("two legs", (HIP.position, HIP.position)),)},
        "the line 'two legs' cannot be a name in generated code",
    ),
    (
        more(potentials={"my spring": theta1**2}),
        "the potential 'my spring' cannot be a name in generated code",
    ),
    (more(potentials={"gravity": theta1**2}), "the potential gravity is added automatically"),
    (
        more(parameter("lambda")),
        "the parameter lambda has a name that means something in Python; choose another",
    ),
    (more(parameter("double")), "the parameter double has a name that means something in C; choose another"),
    (
        more(parameter("friction")),
        "the parameter friction has the name of a column of the tables (friction needed)",
        "; choose another name, such as friction_coefficient",
    ),
    (more(parameter("cell")), "the name of a column of the tables (number of the grid cell); choose another"),
    (more(parameter("multiplier_0_re")), "the name of a column of the tables (a Floquet multiplier)"),
    (more(parameter("starts")), "the name of an option of stridemap's commands or an argument"),
    (more(parameter("p")), "the name of an argument of generated functions (the parameters)"),
    (more(parameter("stance_x")), "the name of an entry of STANCE_FOOT"),
    (more(parameter("function")), "a name that means something in JavaScript"),
    ({"drawing": (Line("class", (HIP.position,)),)}, "the line class has a name that means something in"),
    ({"name": "errno"}, "model errno: it has a name that means something in C; choose another name for the"),
    ({"name": "example"}, "it has the name of a generated file; choose another name for the model"),
    (more(parameter("theta1")), "the parameter theta1 shadows the coordinate theta1; rename one"),
    (more(parameter("dtheta1")), "a rate of a coordinate and a parameter called dtheta1; rename"),
    (more(parameter("beta")), "there is a parameter and a parameter called beta"),
    ({"coordinates": (THETA1, THETA2, THETA2)}, "a coordinate and a coordinate called theta2"),
    ({"drawing": COMPASS.drawing * 2}, "there is a line and a line called legs"),
    ({"coordinates": ()}, "it has no coordinates"),
    ({"bodies": ()}, "it has no bodies"),
    ({"bodies": HIP}, "bodies is not a tuple; write (Body(...),)"),
    ({"locks": theta1}, "locks is not a tuple"),
    ({"parameters": (beta,)}, "parameters holds beta, which is not a Parameter"),
    ({"coordinates": ("theta1", "theta2")}, "coordinates holds 'theta1', which is not a Coordinate"),
    ({"touchdown": theta2 - 2 * theta1}, "touchdown is -2*theta1 + theta2, which is not a Touchdown"),
    ({"touchdown": None}, "touchdown is None, which is not a Touchdown"),
    ({"clock": sp.Symbol("omega", real=True)}, "clock is omega, which is not a Clock"),
    ({"relabel": [theta1, theta2]}, "relabel is [theta1, theta2]; it must be a dict"),
    ({"torques": {theta2: beta}}, "torques names theta2, which is not a Coordinate"),
    ({"stance_angle": theta1}, "stance_angle is theta1, which is not a Coordinate"),
    ({"title": "two */ legs"}, "the text 'two */ legs' cannot stand in a comment"),
    ({"units": UnitNames(mass="k\ng")}, r"the text 'k\ng' cannot stand in a comment"),
]

RANGES = [
    (
        more(parameter("k", 2.0, 3.0)),
        "the default 2 of the parameter k is not in its own range [3, inf)",
    ),
    (more(parameter("k", 2.0, 0.0, 1.0)), "the default 2 of the parameter k is not in its own range [0, 1]"),
    (
        more(parameter("k", 0.0, 0.0, 1.0, True)),
        "the default 0 of the parameter k is not in its own range (0, 1]",
    ),
    (
        more(parameter("k", 1.0, 0.0, 1.0, False, True)),
        "the default 1 of the parameter k is not in its own range [0, 1)",
    ),
    (more(parameter("k", math.nan)), "the default nan of the parameter k is not a finite number"),
    (more(parameter("k", "1")), "the default '1' of the parameter k is not a finite number"),
]

REFERENCES = [
    (
        {"torques": {OTHER: beta}},
        "torques names other, which is not one of its coordinates; they are theta1",
    ),
    ({"stance_angle": OTHER}, "stance_angle names other, which is not one of its coordinates"),
    ({"wobbling": X}, "wobbling names x, which is not one of its coordinates"),
    (
        {"massless": Massless(sp.Symbol("m", positive=True), (X,))},
        "massless names x, which is not one of its coordinates",
    ),
    (
        {"relabel": {**COMPASS.relabel, x: x}},
        "relabel gives x a new value, but x is not one of its coordinates",
    ),
    (
        {"relabel": {**COMPASS.relabel, sp.Symbol("theta1"): theta1}},
        "relabel gives theta1 a new value, but theta1 is not one of its coordinates",
        "; take Coordinate(...).symbol",
    ),
    (
        {"relabel": {theta1: theta1}},
        "relabel does not say what becomes of theta2; write {theta2: theta2} if it stays",
    ),
    ({"section": {x: theta1}}, "section fixes x, which is neither one of its coordinates nor a rate"),
    ({"section": {sp.Symbol("theta2"): theta1}}, "section fixes theta2, which is neither", "take .symbol"),
    ({"section": {theta2: theta2}}, "section gives theta2 in terms of theta2, which it fixes too"),
]

SHAPES = [
    (with_cargo(theta1), "the position of the body cargo is theta1; it must be a point"),
    (with_cargo(STANCE_FOOT.T), "the position of the body cargo has shape (1, 2)"),
    ({"swing_foot": sp.Matrix([0, 0, 0])}, "swing_foot has shape (3, 1)"),
    ({"gravity": -1}, "gravity is -1; it must be a point of SymPy expressions"),
    ({"stance": sp.Matrix([[0, 0]])}, "stance has shape (1, 2)"),
    (
        {"drawing": (Line("legs", ((0, 0), HIP.position)),)},
        "entry 1 of the points of the line legs is (0, 0); it must be a point",
    ),
    (
        with_cargo(HIP.position, "beta"),
        "the mass of the body cargo is 'beta'; it must be a single SymPy expression",
    ),
    (with_cargo(HIP.position, inertia=HIP.position), "the inertia of the body cargo is Matrix"),
    ({"torques": {THETA2: [beta]}}, "the torque on theta2 is [beta]; it must be a single SymPy expression"),
    ({"dissipation": "beta"}, "the dissipation is 'beta'"),
    ({"potentials": {"spring": None}}, "the potential spring is None"),
    ({"spring_mode": HIP.position}, "spring_mode is Matrix"),
    ({"clock": Clock("omega")}, "the rate of the clock is 'omega'"),
]

SYMBOLS = [
    (
        with_cargo(HIP.position, sp.Symbol("m")),
        "the mass of the body cargo has the symbol m, which is not a parameter",
        'declare Parameter("m", ...)',
    ),
    (
        with_cargo(HIP.position, sp.Symbol("beta")),
        "the mass of the body cargo has the symbol beta",
        "it is not the declared beta: take Parameter(...).symbol",
    ),
    (
        with_cargo(STANCE_FOOT + sp.Matrix([sp.Symbol("theta1"), 0])),
        "the position of the body cargo has the symbol theta1",
        "Coordinate(...).symbol",
    ),
    (
        with_cargo(HIP.position, theta1),
        "the mass of the body cargo has the symbol theta1",
        "may not stand there",
    ),
    ({"gravity": sp.Matrix([0, -theta1])}, "gravity has the symbol theta1", "may not stand there"),
    (
        {"touchdown": Touchdown(theta2 - 2 * theta1 + THETA1.rate, theta1)},
        "the touchdown's condition has the symbol dtheta1",
        "may not stand there",
    ),
    (
        {"touchdown": Touchdown(theta2 - 2 * theta1, TIME)},
        "the touchdown's region has the symbol t",
        "may not stand",
    ),
    (
        {"potentials": {"spring": TIME * theta1}},
        "the potential spring has the symbol t",
        "may not stand there",
    ),
    ({"stance": STANCE_FOOT}, "stance has the symbol stance_x", "may not stand there"),
    ({"clock": Clock(theta1)}, "the rate of the clock has the symbol theta1"),
    ({"locks": (THETA1.rate,)}, "lock 1 has the symbol dtheta1"),
    ({"spring_mode": theta1}, "spring_mode has the symbol theta1"),
    ({"dissipation": sp.Symbol("c") * THETA1.rate**2}, "the dissipation has the symbol c"),
    ({"dissipation": THETA1.symbol**2}, "the dissipation theta1**2 has no rate in it, so it damps nothing"),
    (
        {"clock": Clock(COMPASS.clock.rate, resets=False, turn=sp.Symbol("turn"))},
        "the symbol turn, which is not a parameter",
    ),
    (
        with_cargo(sp.Matrix([sp.sin(theta1), 1])),
        "the position of the body cargo does not move along with the",
    ),
    ({"swing_foot": 2 * STANCE_FOOT}, "swing_foot does not move along with the stance foot"),
]

SEARCH = [
    (
        {"search_box": {"theta1": (0, 1), "dtheta1": (0, 1)}},
        "search_box lacks dtheta2; give dtheta2 a middle and a half-width",
    ),
    (boxes(COMPASS, x=(0, 1)), "search_box names x, which is neither one of its coordinates nor a rate"),
    (boxes(COMPASS, theta1=(0, -1)), "search_box gives theta1 (0, -1); a middle and a half-width"),
    (boxes(COMPASS, theta1=(0, math.inf)), "search_box gives theta1 (0, inf)"),
    (boxes(COMPASS, theta1=(0, 1, 2)), "search_box gives theta1 (0, 1, 2)"),
    (boxes(COMPASS, theta1=0.1), "search_box gives theta1 0.1"),
    ({"period_range": (3.0, 0.3)}, "period_range = (3.0, 0.3) is not allowed; give (shortest, longest)"),
    ({"period_range": (0.0, 3.0)}, "period_range = (0.0, 3.0) is not allowed"),
    ({"period_range": 3.0}, "period_range = 3.0 is not allowed"),
]

# -- mechanics -----------------------------------------------------------------------------------------------

MECHANICS = [
    (
        {"relabel": {theta1: theta1 - theta2, theta2: sp.sin(theta2)}},
        "relabel is not linear in the coordinates",
    ),
    (
        {"relabel": {theta1: theta1 - theta2, theta2: theta2}},
        "relabel is not its own inverse: swapping the legs twice must give theta1 back",
        ", and gives theta1 - 2*theta2",
        "correct the new values of the coordinates in relabel",
    ),
    (
        {"relabel": {theta1: beta * theta1, theta2: theta2}},
        "relabel is not its own inverse",
        "and gives beta**2*theta1",
    ),
    (
        {
            "coordinates": (THETA1, THETA2, OTHER),
            "relabel": {**COMPASS.relabel, OTHER.symbol: OTHER.symbol},
            **boxes(COMPASS, other=(0, 1), dother=(0, 1)),
        },
        "the coordinate other has no inertia: no body moves with it; give a body that does a mass",
    ),
    (
        {
            "coordinates": (THETA1, THETA2, X),
            "relabel": {**COMPASS.relabel, x: x},
            "bodies": (
                *(Body(b.name, b.mass, b.position.subs(theta1, theta1 + x)) for b in COMPASS.bodies[:2]),
                Body("swing foot", beta, COMPASS.bodies[2].position.subs(theta1, theta1 + x)),
            ),
            **boxes(COMPASS, x=(0, 1), dx=(0, 1)),
        },
        "the mass matrix has no inverse: some coordinates move all bodies alike; take one of theta1, theta2",
    ),
    (with_cargo(HIP.position, beta - 1), "the mass of the body cargo is -0.85", "must not be negative"),
    (with_cargo(HIP.position, 1 / (beta - sp.Rational(3, 20))), "the mass of the body cargo is zoo"),
    (with_cargo(HIP.position, inertia=-beta, angle=theta1), "the inertia of the body cargo is -0.15"),
    ({"locks": (theta1, 2 * theta1)}, "of the 2 locks only 1 are independent"),
    ({"locks": (beta,)}, "of the 1 locks only 0 are independent"),
    ({"locks": (theta1, theta2)}, "the locks leave no coordinate free to move"),
    (
        {"touchdown": Touchdown(theta2 - theta1, theta1), "section": {}, **boxes(COMPASS, theta2=(0, 1))},
        "the touchdown's condition is ",
        "just after touchdown and must be zero, because the old stance foot",
        "write a condition that is zero with both feet on the ground, whichever is in front",
    ),
    (
        {"touchdown": Touchdown(theta2 - 2 * theta1, sp.Integer(1))},
        "no touchdown was found near the search box: where the touchdown's condition is zero, its region",
        "correct the region (perhaps its sign), relabel or search_box",
    ),
    (
        {"touchdown": Touchdown(theta1**2 + 1, theta1)},
        "no touchdown was found near the search box: the touchdown's condition is not zero anywhere there",
    ),
    (
        {"relabel": {theta1: theta1, theta2: -theta2}},
        "the touchdown's condition is ",
        "old stance foot is still on the ground; correct relabel",
    ),
    (
        {"touchdown": Touchdown(sp.sqrt(-1 - theta1**2), theta1)},
        "no touchdown was found near the search box",
    ),
    ({"touchdown": Touchdown(beta, theta1)}, "no touchdown was found near the search box"),
    (
        {"section": {theta2: 3 * theta1}},
        "section fixes theta2 = 3*theta1, but just after touchdown theta2 can be",
    ),
]

REFUSALS = [*NAMES, *RANGES, *REFERENCES, *SHAPES, *SYMBOLS, *SEARCH, *MECHANICS]


def refusal(make):
    with pytest.raises(InputError) as caught:
        make()
    sentence = str(caught.value)
    assert "\n" not in sentence
    assert sentence.startswith("model ")
    return sentence


@pytest.mark.parametrize(
    ("changes", "words"), [(c, w) for c, *w in REFUSALS], ids=[c[1][:60] for c in REFUSALS]
)
def test_a_bad_declaration_is_refused_in_one_sentence(changes, words):
    sentence = refusal(lambda: COMPASS.with_(**changes))
    for word in words:
        assert word in sentence


def test_what_vanishes_is_no_parameter_and_stands_in_masses_and_forces_only():
    foot = SIMPLEST.massless.mass
    with_foot = (*SIMPLEST.parameters, Parameter("foot_mass", 0.1, "1", "a mass"))
    same_symbol = Massless(with_foot[-1].symbol, (PHI,))
    bodies = tuple(Body(b.name, b.mass.subs(foot, same_symbol.mass), b.position) for b in SIMPLEST.bodies)
    changes = {"parameters": with_foot, "massless": same_symbol, "bodies": bodies}
    assert "foot_mass goes to zero, so it cannot be a parameter" in refusal(lambda: SIMPLEST.with_(**changes))
    longer = SIMPLEST.swing_foot + sp.Matrix([foot, 0])
    assert "may not stand there" in refusal(lambda: SIMPLEST.with_(swing_foot=longer))


@pytest.mark.parametrize("changes", [{"potentials": {"spring": phi**2}}, {"torques": {PHI: -phi}}])
def test_a_force_on_what_has_no_mass_has_no_limit(changes):
    walker = SIMPLEST.with_(**changes)
    sentence = refusal(lambda: emit(walker, "test"))
    assert "the equation of phi does not vanish with foot_mass (there remains " in sentence
    assert "must have foot_mass as a factor" in sentence


def test_a_rate_that_the_section_fixes_wrongly_is_refused():
    section = {**SIMPLEST.section, PHI.rate: (1 - sp.cos(THETA.symbol)) * THETA.rate}
    wrong = SIMPLEST.with_(section=section)
    sentence = refusal(lambda: emit(wrong, "test"))
    assert "section fixes dphi = " in sentence and "but the impact can make it" in sentence
    validate_section_rates(Mechanics(SIMPLEST))
    for walker in (COMPASS, WOBBLING, WHEEL):  # which fix none
        validate_section_rates(Mechanics(walker))


UNPRINTABLE = {
    "Abs": sp.Abs(WHEEL.q[0]),
    "sign": sp.sign(WHEEL.q[0]),
    "Piecewise": sp.Piecewise((WHEEL.q[0], WHEEL.q[0] > 0), (0, True)),
    "atan2": sp.atan2(sp.sin(WHEEL.q[0]), sp.cos(WHEEL.q[0])),
    "Max": sp.Max(WHEEL.q[0], 0),
    "power": (1 + WHEEL.q[0] ** 2) ** sp.Rational(1, 3),
    "Heaviside": sp.Heaviside(WHEEL.q[0]),
    "I": sp.I * WHEEL.q[0],
}


@pytest.mark.parametrize("name", UNPRINTABLE)
def test_functions_that_generated_code_has_no_form_for_are_refused(name):
    sentence = refusal(lambda: WHEEL.with_(torques={WHEEL.coordinates[0]: UNPRINTABLE[name]}))
    assert "the torque on theta has the" in sentence and name in sentence


def test_the_acceleration_of_gravity_is_not_negative():
    def weight(*limits):
        g = parameter("g", 9.81, *limits)
        downwards = g.symbol * WHEEL.gravity
        return Mechanics(WHEEL.with_(parameters=(*WHEEL.parameters, g), gravity=downwards)).weight

    assert weight(0.0) == sp.Symbol("g", real=True)
    assert "gravity can have either sign of g; give the parameter a lower limit of 0" in refusal(weight)


def test_what_is_allowed_passes():
    """Each of these is next to something that is refused."""
    COMPASS.with_(potentials={"spring": beta * theta2**2})
    COMPASS.with_(locks=(theta2,))
    COMPASS.with_(**boxes(COMPASS, theta2=(0.1, 0.3)), section={})
    COMPASS.with_(touchdown=Touchdown(2 * theta1 - theta2, theta1, rising=False))
    COMPASS.with_(**more(parameter("k", 0.0, 0.0, 1.0)))
    COMPASS.with_(torques={THETA2: sp.sin(TIME)}, clock=None)
    SIMPLEST.with_(potentials={"spring": SIMPLEST.massless.mass * phi**2})
