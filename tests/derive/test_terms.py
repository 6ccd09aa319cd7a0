"""Long expressions in steps: values, derivatives and substitutions are those of the whole expression."""

import pickle
import random
import time

import mpmath
import pytest
import sympy as sp

from stridemap.derive import STANCE_FOOT, Term, solve
from stridemap.derive.emit import emit
from stridemap.derive.models import WALKERS
from stridemap.derive.models.compass import THETA1, THETA2
from stridemap.derive.normal_form import normal_form
from stridemap.derive.simplify import simplified
from stridemap.derive.steps import straight_line
from stridemap.derive.terms import opened, operations, terms_in
from stridemap.errors import InputError
from tests.oracles.remembered import remembered

X, Y, Z = sp.symbols("x y z", real=True)
COMPASS = WALKERS["goswami_compass"]
PLACE = {X: sp.Rational(3, 10), Y: sp.Rational(-7, 10), Z: sp.Rational(11, 10)}


def grown(seed, size=14):
    """A random expression with quotients, powers and functions."""
    rng = random.Random(seed)
    parts = [X, Y, Z, X + 2, Y * Z]
    for _ in range(size):
        a, b = rng.choice(parts[-3:]), rng.choice(parts[:7])
        parts.append(
            rng.choice([a + b, a * b / 3, a / (2 + b**2), sp.sin(a) * b, sp.tanh(a - b), sp.sqrt(1 + a**2)])
        )
    return parts[-1] + parts[-2] * parts[-3]


def value(expr, place=PLACE):
    return opened(expr).subs(place).evalf(30)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.quick
def test_derivatives_step_by_step_are_those_of_the_whole_at_high_precision(seed):
    expr = grown(seed)
    steps = straight_line(expr)
    assert sp.count_ops(expr) > 15
    assert any(True for _ in terms_in([steps]))
    assert abs(value(steps) - expr.subs(PLACE).evalf(30)) < 1e-25
    function = sp.lambdify((X, Y, Z), expr, "mpmath")
    with mpmath.workdps(40):
        point = [mpmath.mpf(v.p) / v.q for v in PLACE.values()]
        for orders, symbols in {(1, 0, 0): [X], (0, 1, 0): [Y], (1, 0, 1): [X, Z]}.items():
            wanted = mpmath.diff(function, point, orders)
            found = steps
            for symbol in symbols:
                found = found.diff(symbol)
            assert abs(value(found) - wanted) < 1e-12 * (1 + abs(wanted))


@pytest.mark.quick
def test_a_chain_of_steps_grows_by_its_length_when_it_is_differentiated():
    """Written out, 60 squarings would have more operations than there are atoms."""

    def chain(length):
        expr = X
        for _ in range(length):
            expr = Term("", (expr * expr + sp.sin(expr) + X) / 4)
        return expr

    for derivative in (lambda e: e.diff(X), lambda e: e.diff(X).diff(X)):
        assert operations(derivative(chain(60))) < 2.2 * operations(derivative(chain(30)))


@pytest.mark.quick
def test_terms_are_values():
    term = Term("a", sp.sin(X) * Y)
    assert pickle.loads(pickle.dumps(term * 2)) == term * 2
    assert term == Term("a", Y * sp.sin(X)) != Term("a", sp.cos(X) * Y)
    assert term != sp.Symbol("a", real=True)
    assert term.free_symbols == {X, Y}
    assert (term + Z).subs(X, Y).diff(Y) == (Term("a", sp.sin(Y) * Y) + Z).diff(Y)
    assert opened((term**2).xreplace({Y: X})) == (X * sp.sin(X)) ** 2
    assert Term("b", 3) == 3
    assert Term("b", term) is term


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.quick
def test_the_normal_form_is_equal_and_what_cancels_is_gone(seed):
    rng = random.Random(seed)
    waves = [sp.sin(X), sp.cos(X - Y), sp.sin(2 * Y + sp.pi / 3), sp.cos(Z), Z, sp.tanh(X), sp.Rational(2, 3)]
    expr = (
        sum(sp.Mul(*rng.choices(waves, k=3)) for _ in range(6)) * (rng.choice(waves) + rng.choice(waves)) ** 2
    )
    assert abs(value(normal_form(expr, 10**5) - expr)) < 1e-25
    assert normal_form(expr - sp.expand(expr), 10**5) == 0
    assert normal_form(Z * (sp.sin(X) ** 2 + sp.cos(X) ** 2), 100) == Z
    assert normal_form(expr**3, 10) is None


@pytest.mark.quick
def test_simplification_is_bounded_whatever_it_is_given():
    begun = time.process_time()
    for seed in range(3):
        expr = sum(grown(seed + i) for i in range(4))
        assert abs(value(simplified(expr) - expr)) < 1e-20 * abs(1 + value(expr))
    assert time.process_time() - begun < 20


# -- derived quantities ----------------------------------------------------------------------------------


def at_random(walker, seed=3):
    rng = random.Random(seed)
    place = {s: rng.uniform(-0.6, 0.6) for s in (*walker.q, *walker.v)}
    return place | {a.symbol: a.default * rng.uniform(0.9, 1.1) for a in walker.parameters}


@pytest.mark.parametrize("name", ["wobbling", "goswami_compass", "rimless_wheel"])
@pytest.mark.quick
def test_derived_quantities_are_those_of_the_generated_equations(name):
    from importlib import import_module

    walker = WALKERS[name]
    generated = import_module(f"stridemap.generated.{name}.{name}")
    place = at_random(walker)
    q, v = ([place[s] for s in group] for group in (walker.q, walker.v))
    p = [place[a.symbol] for a in walker.parameters]

    def call(function):
        f = getattr(generated, function)
        names = f.__code__.co_varnames[1 : f.__code__.co_argcount]
        return f(mpmath, *({"q": q, "v": v, "p": p}[n] for n in names))

    def close(expr, wanted):
        assert abs(opened(expr).subs(place).evalf(20) - wanted) < 1e-12 * (1 + abs(wanted))

    matrix, forces = call("mass_matrix")["M"], call("bias_forces")
    for i in range(len(q)):
        close(walker.h[i], sum(part[i] for part in forces.values()))
        for j in range(len(q)):
            close(walker.M[i, j], matrix[i][j])
    close(walker.kinetic_energy, call("kinetic_energy")["kinetic"])
    close(walker.potential_energy, call("potential_energy")["potential"])
    close(walker.energy, call("kinetic_energy")["kinetic"] + call("potential_energy")["potential"])
    com, foot = call("centre_of_mass"), call("swing_foot")
    for i in range(2):
        close(walker.centre_of_mass[i], com["com"][i])
        close(walker.rate(walker.centre_of_mass)[i], com["dcom"][i])
        close(walker.rate(walker.swing_foot)[i], foot["dfoot"][i])


@pytest.mark.quick
def test_rates_of_rates_are_what_no_acceleration_brings():
    """Along a motion of constant rates, the second derivative in time by mpmath."""
    y = sp.sin(THETA1.symbol) * THETA2.symbol**2
    place = at_random(COMPASS)
    found = opened(COMPASS.rate(COMPASS.rate(y))).subs(place)

    def along(t):
        a = place[THETA1.symbol] + t * place[THETA1.rate]
        return mpmath.sin(a) * (place[THETA2.symbol] + t * place[THETA2.rate]) ** 2

    assert abs(found - mpmath.diff(along, 0, 2)) < 1e-9


@pytest.mark.quick
def test_equations_are_solved_step_by_step():
    matrix = sp.Matrix([[0, X, 1], [Y, X * Y, Z], [1, X, X + Z]])
    right = sp.Matrix([[X, 1], [Z, 2], [3, Y]])
    found = opened(solve(matrix, right, "a")).subs(PLACE)
    wanted = (matrix.inv() * right).subs(PLACE)
    assert (found - wanted).applyfunc(sp.simplify).is_zero_matrix
    assert solve(matrix, right, "a")[0, 1].name == "a_12"
    with pytest.raises(InputError, match="column 2 is zero"):
        solve(sp.Matrix([[1, 0], [X, 0]]), sp.Matrix([1, 1]))
    with pytest.raises(InputError, match="must be square"):
        solve(sp.Matrix([[1, 0]]), sp.Matrix([1]))


@pytest.mark.quick
def test_a_massless_limit_has_no_mass_matrix_to_offer():
    with pytest.raises(InputError, match="massless limit"):
        _ = WALKERS["simplest_walker"].M


@pytest.mark.quick
def test_decimal_numbers_inside_terms_are_fractions():
    walker = COMPASS.with_(name="decimals", torques={THETA2: Term("a", 0.1 * sp.sin(THETA1.symbol)) * 0.5})
    assert opened(walker.torques[THETA2]) == sp.sin(THETA1.symbol) / 20
    assert not COMPASS.rate(STANCE_FOOT)[0].free_symbols


# -- derived from long torques ---------------------------------------------------------------------------


def linearising(base):
    """The torque that makes theta2 - 2 theta1 - (theta1^2 - .27^2)/2 behave like a damped spring."""
    a, b = THETA1.symbol, THETA2.symbol
    y = b - 2 * a - (a**2 - sp.Rational(27, 100) ** 2) / 2
    slope, dy = base.jacobian(y), base.rate(y)
    decoupling = (slope * solve(base.M, sp.Matrix([0, 1])))[0]
    rest = base.rate(dy) - (slope * solve(base.M, base.h))[0]
    return y, dy, (-25 * y - 10 * dy - rest) / decoupling


def test_a_controller_that_uses_the_model_does_what_it_was_written_for():
    """The output's second derivative, from the derived accelerations, is the one that was asked for.

    And the accelerations' derivatives agree with differences of the accelerations at 40 digits.
    """
    y, dy, u = linearising(COMPASS)
    begun = time.process_time()
    with remembered():
        files, _ = emit(COMPASS.with_(name="linearised", torques={THETA2: u}), "test")
    assert time.process_time() - begun < 60
    scope = {}
    exec(files["linearised.py"], scope)
    place = {s: sp.nsimplify(x, rational=True) for s, x in at_random(COMPASS).items()}
    q, v, p = (
        [mpmath.mpf(place[s].p) / place[s].q for s in group]
        for group in (COMPASS.q, COMPASS.v, [a.symbol for a in COMPASS.parameters])
    )
    with mpmath.workdps(40):
        q, v, p = ([mpmath.mpf(x) for x in group] for group in (q, v, p))
        values = dict(zip([*COMPASS.q, *COMPASS.v], [*q, *v], strict=True))
        acceleration = scope["state_derivative"](mpmath, q, v, p)["dv"]
        bend = opened(COMPASS.rate(dy)).subs(values)
        slope = opened(COMPASS.jacobian(y)).subs(values)
        found = bend + sum(s * a for s, a in zip(slope, acceleration, strict=True))
        wanted = (-25 * y - 10 * opened(dy)).subs(values)
        # Fractions of the generated Python are rounded to double precision before mpmath sees them.
        assert abs(found - wanted) < 1e-16 * abs(wanted)
        for name, group in (("q", q), ("v", v)):
            exact = scope[f"state_derivative_d{name}"](mpmath, q, v, p)[f"dv_d{name}"]
            for j in range(2):
                ends = []
                for step in (mpmath.mpf("1e-15"), -mpmath.mpf("1e-15")):
                    moved = [x + (i == j) * step for i, x in enumerate(group)]
                    state = (moved, v) if name == "q" else (q, moved)
                    ends.append(scope["state_derivative"](mpmath, *state, p)["dv"])
                for i in range(2):
                    assert abs((ends[0][i] - ends[1][i]) / mpmath.mpf("2e-15") - exact[i][j]) < 1e-18
