"""The largest power of two motors together, of powers that are known functions of time."""

from types import SimpleNamespace

import numpy as np
import pytest

from stridemap.solver.backends.base import Advanced
from stridemap.solver.kernels.observation import OBSERVABLES
from stridemap.solver.observables.events import Trace
from stridemap.solver.observables.peak_power import peak_power

pytestmark = pytest.mark.quick

NODES = 25


def trace_of(*functions):
    """A trace of a walker whose motors have these powers, each given with its derivative."""
    names = tuple("abc"[: len(functions)])
    model = SimpleNamespace(actuated=names, spec=SimpleNamespace(quantities=()))
    first, rows = len(OBSERVABLES), len(OBSERVABLES) + 2 * len(functions)

    def seen(t):
        g, dg = np.zeros((2, *t.shape, rows))
        for i, (f, df) in enumerate(functions):
            g[..., first + i], dg[..., first + i] = f(t), df(t)
        return g, dg

    def advance(t, w, tau, params):
        return Advanced((t + tau)[:, None], *seen(t + tau))

    t = np.linspace(0, 1, NODES)[None]
    g, dg = seen(t)
    kernels = SimpleNamespace(model=model, advance=advance)
    return Trace(kernels, np.zeros((1, 0)), np.ones(1), t[..., None], g, dg)


def wave(size, rate, phase):
    return (lambda t: size * np.sin(rate * t + phase), lambda t: size * rate * np.cos(rate * t + phase))


@pytest.mark.parametrize(
    "functions",
    [
        (wave(1.0, 5.0, 0.3),),
        (wave(1.0, 5.0, 0.3), wave(0.7, 5.0, 0.3 + np.pi)),  # one takes what the other gives
        (wave(1.0, 9.0, 0.0), wave(0.8, 13.0, 1.0)),
        (wave(1.0, 9.0, 0.0), wave(0.8, 13.0, 1.0), wave(0.5, 21.0, 2.0)),
    ],
)
def test_it_is_the_largest_sum_of_absolute_values(functions):
    t = np.linspace(0, 1, 1_000_001)
    exact = sum(np.abs(f(t)) for f, _ in functions).max()
    assert peak_power(trace_of(*functions))[0] == pytest.approx(exact, rel=1e-9)
