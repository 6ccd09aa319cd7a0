"""Random states at which hand-written mechanics and generated functions are compared, and rounding bounds."""

import os
import shutil
from decimal import Decimal, localcontext
from functools import cache, lru_cache

import numpy as np
import pytest

from stridemap.solver.model.loading import load

MODELS = ("wobbling", "compass", "simplest_walker", "goswami_compass", "rimless_wheel")
COUNT = 1000

DIGITS = 50
"""Of what is called exact here."""

PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803")


def fifty_digits():
    """A context in which decimal numbers are rounded to 50 digits: ``with fifty_digits():``."""
    return localcontext(prec=DIGITS)


@lru_cache(200_000)  # most entries stay where they are while one is moved
def _turned(x, quarters):
    """The sine of a decimal number and so many quarter turns: the series about the nearest of these."""
    with localcontext(prec=DIGITS + 20):
        turns = (2 * x / PI).to_integral_value()
        x -= turns * PI / 2
        quarters = (quarters + int(turns)) % 4
        first = quarters % 2  # 0 begins the sine's series, 1 the cosine's
        term = total = Decimal(1) if first else x
        for i in range(3 - first, 200, 2):
            term *= -x * x / (i * (i - 1))
            total += term
            if abs(term) < Decimal("1e-70"):
                break
    return -total if quarters > 1 else +total


class MP:
    """A namespace like NumPy, for arrays of decimal numbers."""

    sin = np.frompyfunc(lambda x: _turned(x, 0), 1, 1)
    cos = np.frompyfunc(lambda x: _turned(x, 1), 1, 1)
    sqrt = np.frompyfunc(Decimal.sqrt, 1, 1)
    pi = PI


class Exact(np.ndarray):
    """An array of decimal numbers, which takes floats for what they are: 1/2 in generated code is one."""

    def __array_ufunc__(self, ufunc, method, *inputs, **more):
        plain = [_decimal(x) for x in inputs]
        result = getattr(ufunc, method)(*plain, **more)
        return result.view(Exact) if isinstance(result, np.ndarray) and result.dtype == object else result


_converted = np.frompyfunc(Decimal, 1, 1)


def _decimal(x):
    if isinstance(x, Exact):
        return x.view(np.ndarray)
    return _converted(x) if np.asarray(x).dtype == float else x


def exact(values):
    """Floats as decimal numbers of the same value."""
    found = _converted(values)
    return found.view(Exact) if isinstance(found, np.ndarray) else found


RANGES = {
    "k": (0, 60), "alpha": (0.02, 0.98), "omega": (0.5, 6), "beta": (0.02, 2), "Kp": (0, 30), "Kd": (0, 3),
    "S": (-0.5, 0.5), "gamma": (-0.5, 0.5), "theta1": (-1.2, 1.2), "theta2": (-2.4, 2.4), "x": (-1, 1),
    "dtheta1": (-3, 3), "dtheta2": (-3, 3), "dx": (-3, 3), "theta": (-1.2, 1.2), "phi": (-2.4, 2.4),
    "dtheta": (-3, 3), "dphi": (-3, 3), "slope": (-1.2, 1.2), "mu": (0, 10), "spokes": (3, 24),
    "lambda2": (0.02, 1), "c": (0, 3),
}  # fmt: skip


BROWSERS = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
"""Commands of browsers, the one that takes the least of the processor first: it has no window to draw."""


def need(*commands):
    """The first of these commands that is on the path; without one the test is skipped, and fails in CI."""
    found = next((command for command in commands if shutil.which(command)), None)
    return found or lacking(f"there is no {' or '.join(commands)} on the path")


def lacking(reason):
    if os.environ.get("CI"):
        pytest.fail(f"{reason}, and CI must have it")
    pytest.skip(reason)


@cache
def states(name, count=COUNT, seed=7):
    """Random inputs of a model's functions: t (count,), and q, v, u, p, z with an axis more."""
    rng = np.random.default_rng(seed)
    model = load(name)

    def draw(names):
        return np.stack([rng.uniform(*RANGES[n], count) for n in names], axis=-1)

    return {
        "t": rng.uniform(0, 3, count),
        "q": draw(model.coordinates),
        "v": draw(["d" + c for c in model.coordinates]),
        "p": draw([a.name for a in model.parameters]),
        "z": draw(model.section),
        "u": rng.uniform(-2, 2, (count, len(model.actuated))),
    }


def on_section(name):
    """The random states with the swing foot on the ground, where impacts happen."""
    values = dict(states(name))
    values["q"] = values["q"].copy()
    if name == "rimless_wheel":
        spokes = values["p"][:, [a.name for a in load(name).parameters].index("spokes")]
        values["q"][:, 0] = np.pi / spokes
    else:
        values["q"][:, 1] = 2 * values["q"][:, 0]
    return values


def call(function, xp, values):
    """Call a namespace-neutral function on arrays; the results have the states on the first axis."""
    names = function.__code__.co_varnames[1 : function.__code__.co_argcount]
    result = function(xp, *[values[n] if n == "t" else list(values[n].T) for n in names])
    return {key: stacked(value, len(values["t"])) for key, value in result.items()}


def differences(function, values, output, which):
    """Derivative of `output` with respect to ``q`` or ``v`` by central differences at 50 digits.

    With steps of 1e-16 their error is about 1e-32.
    """
    columns = []
    for j in range(values[which].shape[1]):
        step = np.zeros(values[which].shape[1])
        step[j] = 1e-16
        moved = [{**values, which: values[which] + exact(sign * step)} for sign in (1, -1)]
        ahead, behind = (call(function, MP, m)[output] for m in moved)
        columns.append((ahead - behind) / exact(2e-16))
    return np.stack(columns, axis=-1)


def stacked(value, count):
    if isinstance(value, list):
        return np.stack([stacked(v, count) for v in value], axis=1)
    return np.broadcast_to(np.asarray(value), (count,))


class Rounded:
    """A float with a bound of its rounding error (running error analysis), over arrays of states.

    A generated function called with these gives, with every result, how far it may be from the truth.
    """

    UNIT = 2.0**-53

    def __init__(self, value, error=0.0):
        self.value, self.error = value, error

    @classmethod
    def _of(cls, x):
        return x if isinstance(x, cls) else cls(x)

    @classmethod
    def _rounded(cls, value, error):
        return cls(value, error + cls.UNIT * np.abs(value))

    def __add__(self, other):
        other = self._of(other)
        return self._rounded(self.value + other.value, self.error + other.error)

    def __sub__(self, other):
        return self + -self._of(other)

    def __rsub__(self, other):
        return -self + other

    def __neg__(self):
        return Rounded(-self.value, self.error)

    def __mul__(self, other):
        other = self._of(other)
        error = np.abs(self.value) * other.error + (np.abs(other.value) + other.error) * self.error
        return self._rounded(self.value * other.value, error)

    def __truediv__(self, other):
        other = self._of(other)
        value = self.value / other.value
        error = (self.error + np.abs(value) * other.error) / (np.abs(other.value) - other.error)
        return self._rounded(value, error)

    def __rtruediv__(self, other):
        return self._of(other) / self

    __radd__, __rmul__ = __add__, __mul__

    # NumPy's sine and cosine are good to 4 units in the last place.

    @classmethod
    def sin(cls, x):
        return cls(np.sin(x.value), x.error + 8 * cls.UNIT * np.abs(np.sin(x.value)))

    @classmethod
    def cos(cls, x):
        return cls(np.cos(x.value), x.error + 8 * cls.UNIT * np.abs(np.cos(x.value)))

    @classmethod
    def sqrt(cls, x):
        root = np.sqrt(x.value)
        return cls._rounded(root, x.error / root)


Rounded.pi = Rounded(np.pi, 1.3e-16)  # a double misses pi by 1.22e-16


def error_bounds(function, values):
    """Bounds of the rounding errors of a generated function's results, shaped like these."""
    names = function.__code__.co_varnames[1 : function.__code__.co_argcount]
    arguments = [Rounded(values[n]) if n == "t" else [Rounded(x) for x in values[n].T] for n in names]

    def bound(value):
        if isinstance(value, list):
            return [bound(v) for v in value]
        return value.error + 0.0 if isinstance(value, Rounded) else 0.0

    return {k: stacked(bound(v), len(values["t"])) for k, v in function(Rounded, *arguments).items()}
