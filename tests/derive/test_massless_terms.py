"""A long torque on a coordinate that only the vanishing mass moves with: the limit sees into terms."""

import numpy as np
import pytest
import sympy as sp

from stridemap.derive.functions import Functions
from stridemap.derive.models.simplest_walker import PHI, THETA, WALKER
from stridemap.derive.steps import is_long
from stridemap.errors import InputError

MASS = WALKER.massless.mass


def long_torque():
    """A polynomial in sines that is too long to be simplified whole, as a function of the swing angle."""
    s = sp.sin(PHI.symbol - sp.Rational(1, 7))
    c = sp.cos(PHI.symbol + THETA.symbol)
    return sum((s + k * c) ** 3 * sp.tanh(s + c / k) / (2 + (k * s) ** 2) for k in range(1, 4))


def acceleration(walker, values):
    """Second component of dv at a state."""
    program = Functions(walker).state_derivative()
    known = dict(values)
    for symbol, expr in program.statements:
        known[symbol] = expr.subs(known).evalf(30)
    (dv,) = (one for one in program.outputs if one.name == "dv")
    return np.array([float(entry.subs(known).evalf(30)) for entry in dv.entries])


def test_the_limit_sees_into_terms():
    torque = long_torque()
    assert is_long(torque)
    driven = WALKER.with_(torques={PHI: MASS * torque})
    rng = np.random.default_rng(3)
    names = [*WALKER.q, *WALKER.v, *(a.symbol for a in WALKER.parameters)]
    values = {
        symbol: sp.Float(value, 30)
        for symbol, value in zip(names, rng.uniform(0.1, 0.4, len(names)), strict=True)
    }
    change = acceleration(driven, values) - acceleration(WALKER, values)
    # Divided by the mass, the equation of a unit length has 1 before ddphi.
    expected = float(torque.subs(values).evalf(30))
    np.testing.assert_allclose(change, [0.0, expected], rtol=1e-12, atol=1e-14)


def test_a_torque_without_the_mass_is_refused():
    with pytest.raises(InputError, match="does not vanish with"):
        Functions(WALKER.with_(torques={PHI: long_torque()})).state_derivative()
