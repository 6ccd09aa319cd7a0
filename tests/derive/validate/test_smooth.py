"""What generated code has no form for is refused when it is declared, with what to write in its place."""

import time

import pytest
import sympy as sp

from stridemap.derive import Body, Term
from stridemap.derive.models import WALKERS
from stridemap.derive.models.compass import THETA2
from stridemap.errors import InputError

COMPASS = WALKERS["goswami_compass"]
x, y = THETA2.symbol, THETA2.rate
pytestmark = pytest.mark.quick

REFUSED = {
    sp.Max(-1, sp.Min(1, x)): r"the function Max, which is not smooth; soften the limit, .*tanh\(x/u_max\)",
    sp.Min(x, y): "the function Min, which is not smooth; soften the limit",
    2 + sp.Abs(x): r"the function Abs, which is not smooth; .* sqrt\(x\^2 \+ eps\^2\)",
    sp.sqrt(x**2): "the function Abs, which is not smooth",
    sp.sign(y) * x: r"the function sign, which is not smooth; .* tanh\(s x\)",
    sp.Heaviside(x): r"the function Heaviside, .* \(1 \+ tanh\(s x\)\)/2",
    sp.Piecewise((x, y > 0), (0, True)): "the function Piecewise, .* in front of each piece",
    sp.floor(x): "the function floor, which is not smooth",
    sp.ceiling(sp.sin(x)): "the function ceiling, which is not smooth",
    sp.Mod(x, 2): "the function Mod, which is not smooth; .* repeat by themselves",
    sp.atan2(y, x): r"the function atan2, which is not smooth; write atan\(y/x\)",
    sp.sec(x): r"the function sec, which is not a function that generated code has; write 1/cos\(x\)",
    sp.erf(x): "the function erf, .* write it with",
    sp.Function("f")(x): "which is not made of numbers, symbols and functions alone",
    sp.Derivative(sp.Function("f")(x), x): "which is not made of numbers, symbols and functions alone",
    x**y: r"the power theta2\*\*dtheta2; exponents are integers or halves from -6 to 8",
    x ** sp.Rational(1, 3): "the power",
    x**9: "the power",
    x**-7: "the power",
    sp.E * x: "the number E; generated code has fractions and pi only",
    sp.I * x: "the number I",
    sp.oo * x: "which is not finite",
    sp.nan: "which is not finite",
    Term("friction", sp.sign(y) * x) * 2: "the function sign",
}


@pytest.mark.parametrize("torque", REFUSED, ids=str)
def test_the_sentence_names_function_place_and_remedy_within_a_second(torque):
    begun = time.process_time()
    with pytest.raises(InputError, match=f"model rough: the torque on theta2 .*{REFUSED[torque]}"):
        COMPASS.with_(name="rough", torques={THETA2: torque})
    assert time.process_time() - begun < 1


def test_every_field_is_looked_at():
    bad = sp.Abs(x)
    for changes, place in (
        ({"potentials": {"spring": bad}}, "the potential spring"),
        ({"dissipation": sp.Abs(y)}, "the dissipation"),
        ({"swing_foot": COMPASS.swing_foot + sp.Matrix([bad, 0])}, "swing_foot"),
        (
            {"bodies": (*COMPASS.bodies, Body("bag", sp.Abs(x), COMPASS.swing_foot))},
            "the mass of the body bag",
        ),
    ):
        with pytest.raises(InputError, match=f"{place} has the function Abs"):
            COMPASS.with_(name="rough", **changes)


def test_smooth_functions_are_let_through():
    smooth = (
        sp.tanh(50 * y) + sp.sqrt(x**2 + 1) + sp.atan(x) + sp.exp(-(x**2)) + sp.cosh(x) ** -3 + sp.pi * x**8
    )
    COMPASS.with_(name="smooth", torques={THETA2: smooth})
