"""The margin of an early touchdown where the swing foot hardly comes above the ground, in closed form."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.optimize import brentq

from stridemap.solver.branches.conditions import _inner_touchdown_margin
from stridemap.solver.observables import events
from stridemap.solver.observables.events import Trace

pytestmark = pytest.mark.quick

PERIOD = 3.0
K = np.pi / PERIOD * np.arange(1, 4)


class Swing:
    """The foot is below the ground but for a while about the middle; after t = 1 it is ahead."""

    model = SimpleNamespace(
        coordinates=("t",), evaluate=lambda name, q, v, p: {"side": 0.4 * (1 - q[..., 0])}
    )

    def advance(self, t, w, tau, p):
        g, dg = condition(t + tau, p[:, 0])
        return np.stack([t + tau, 0 * t], axis=-1), g[:, None], dg[:, None]


def condition(t, size):
    """The touchdown condition, which is positive below the ground, and its rate."""
    parts = np.stack([0.5 + 0 * t, 0.2 + 0 * t, size + 0 * t], axis=-1)
    angle = K * np.asarray(t)[..., None]
    return (parts * np.sin(angle)).sum(axis=-1), (parts * K * np.cos(angle)).sum(axis=-1)


def with_height(height):
    """The size with which the foot comes so much above the ground."""

    def lowest(size):
        return condition(brentq(lambda t: condition(t, size)[1], 1.2, 2.0, xtol=1e-15), size)[0]

    return brentq(lambda size: lowest(size) + height, 0.3, 1.0, xtol=1e-16, rtol=1e-15)


@pytest.mark.parametrize("nodes", [12, 31, 48])
@pytest.mark.parametrize("height", [1e-3, 1e-5, 1e-7, 1e-9, -1e-9, -1e-7, -1e-5, -1e-3])
def test_it_is_how_much_the_foot_comes_up(monkeypatch, nodes, height):
    monkeypatch.setattr(events, "observables", lambda model: ["touchdown"])
    size = with_height(height)
    t = np.linspace(0, PERIOD, nodes + 1)[None]
    g, dg = condition(t, size)
    g[:, [0, -1]] = 0.0
    w = np.stack([t, 0 * t], axis=-1)
    trace = Trace(Swing(), np.array([[size]]), np.array([PERIOD]), w, g[..., None], dg[..., None])
    assert _inner_touchdown_margin(trace)[0] == pytest.approx(-height, rel=1e-6, abs=1e-12)
