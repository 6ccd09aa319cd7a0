"""Bipeds of several links: equal to the recursive Newton-Euler equations, and hardly longer than these."""

import numpy as np
import pytest

from benchmarks import chain
from stridemap.derive.functions import Functions
from stridemap.derive.printers.printer import Equations
from stridemap.derive.printers.python import Python
from tests.oracles import recursive

STATES = 1000

LONGER = 3
"""At most that many times the operations of the recursive equations."""


def written(walker, *names):
    """Functions of a walker by name, and the sum of their operations; nothing else is derived."""
    functions = Functions(walker)
    programs = [getattr(functions, name)() for name in names]
    scope = {}
    exec(Python().text(Equations(walker, tuple(programs), "test", "")), scope)
    return {p.name: (scope[p.name], p) for p in programs}


def called(function, program, values):
    """A generated function at many states at once."""
    return function(np, *(values[a.name] for a in program.arguments))


def at_random(walker, seed=5):
    """States and parameters, one row for each coordinate or parameter."""
    rng, n = np.random.default_rng(seed), len(walker.coordinates)
    defaults = np.array([[p.default] for p in walker.parameters])
    return {
        "t": np.zeros(STATES),
        "q": rng.uniform(-np.pi, np.pi, (n, STATES)),
        "v": rng.uniform(-5, 5, (n, STATES)),
        "p": defaults * rng.uniform(0.5, 1.5, (len(defaults), STATES)),
    }


def filled(entries, *shape):
    """Entries of a result as one array, states last."""
    flat = [entry for row in entries for entry in row] if len(shape) == 2 else entries
    return np.stack([np.broadcast_to(e, STATES).astype(float) for e in flat]).reshape(*shape, STATES)


def assert_equal(one, other):
    """Equal to 1e-12 of the largest entry of each state."""
    size = np.abs(other).reshape(-1, STATES).max(axis=0)
    off = np.abs(one - other).reshape(-1, STATES).max(axis=0)
    assert (off <= 1e-12 * size).all(), (off / size).max()


# Seven links in relative angles take 20 s more: `python -m benchmarks.links` measures them.
@pytest.mark.parametrize(
    ("count", "feet", "coordinates"),
    [
        *((count, False, coordinates) for count in (2, 3) for coordinates in chain.COORDINATES),
        (5, False, chain.COORDINATES[1]),
        (7, True, chain.COORDINATES[0]),
    ],
)
def test_mass_matrix_and_forces_are_the_recursive_ones(count, feet, coordinates):
    walker, links = chain.walker(count, coordinates, feet), chain.links(count, feet)
    functions = written(walker, "mass_matrix", "bias_forces")
    values = at_random(walker)
    names = [p.name for p in walker.parameters]
    columns, bias = recursive.mass_matrix_and_bias(
        links, coordinates, values["q"], values["v"], dict(zip(names, values["p"], strict=True))
    )
    matrix = called(*functions["mass_matrix"], values)["M"]
    assert_equal(filled(matrix, count, count), np.swapaxes(filled(columns, count, count), 0, 1))
    forces = called(*functions["bias_forces"], values)
    found = filled(forces["h"], count) + filled(forces["v_gravity"], count)
    assert_equal(found, filled(bias, count))
    operations = sum(program.operations for _, program in functions.values())
    assert operations <= LONGER * recursive.operations(links, coordinates, names)


@pytest.mark.quick
def test_equal_operations_are_counted_once_and_those_with_zero_and_one_are_not():
    steps = {}
    x, y = (recursive.Counted(steps, name) for name in "xy")
    x * y + (-y) * x  # a product, and a difference of it and itself
    assert len(steps) == 2
    (x + 0) * 1 - 0 * y, -x * y, 0 - x, x + y, y - (-x)  # the product again, and one sum
    assert len(steps) == 3


@pytest.mark.quick
def test_a_single_pendulum_by_hand():
    """The matrix is I + m c^2, the gravity torque of an upright leg -m g c sin(q)."""
    leg = (chain.Link("swing leg", -1, True, "leg", 0),)
    p = {"g": 9.0, "m_leg": 2.0, "i_leg": 0.5, "l_leg": 1.0, "c_leg": 0.5}
    matrix, bias = recursive.mass_matrix_and_bias(leg, "absolute", [0.3], [1.7], p)
    assert matrix[0][0] == pytest.approx(1.0, rel=1e-15)
    assert bias[0] == pytest.approx(-9.0 * np.sin(0.3), rel=1e-15)
