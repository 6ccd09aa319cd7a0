"""The margin of an early touchdown where the swing foot hardly comes above the ground, in closed form."""

from types import SimpleNamespace

import numpy as np
import pytest

from stridemap.solver.branches.conditions import _inner_touchdown_margin
from stridemap.solver.observables import events
from stridemap.solver.observables.events import Trace

pytestmark = pytest.mark.quick

PERIOD = 3.0


class Swing:
    """The foot is below the ground but about the middle, where its height is p; after t = 1 it is ahead."""

    model = SimpleNamespace(
        coordinates=("t",), evaluate=lambda name, q, v, p: {"side": 0.4 * (1 - q[..., 0])}
    )

    def advance(self, t, w, tau, p):
        g, dg = self.condition(t + tau, p[:, 0])
        return np.stack([t + tau, 0 * t], axis=-1), g[:, None], dg[:, None]

    @staticmethod
    def condition(t, height):
        """The touchdown condition, which is positive below the ground, and its rate."""
        k, b = np.pi / PERIOD, 0.5 + height
        g = 0.5 * np.sin(k * t) + b * np.sin(3 * k * t)
        return g, k * (0.5 * np.cos(k * t) + 3 * b * np.cos(3 * k * t))


@pytest.mark.parametrize("nodes", [12, 37, 48])
@pytest.mark.parametrize("height", [1e-3, 1e-6, 1e-9, -1e-9, -1e-6, -1e-3])
def test_it_is_how_much_the_foot_comes_up(monkeypatch, nodes, height):
    monkeypatch.setattr(events, "observables", lambda model: ["touchdown"])
    t = np.linspace(0, PERIOD, nodes + 1)[None]
    g, dg = Swing.condition(t, height)
    g[:, [0, -1]] = 0.0
    w = np.stack([t, 0 * t], axis=-1)
    trace = Trace(Swing(), np.array([[height]]), np.array([PERIOD]), w, g[..., None], dg[..., None])
    assert _inner_touchdown_margin(trace)[0] == pytest.approx(-height, rel=1e-6, abs=1e-14)
