"""Plots of a limit cycle: the curves are the motion, axes bear the model's symbols and units, refusals."""

import subprocess
import sys

import numpy as np
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.views import optional
from stridemap.views.plots import plot

pytest.importorskip("matplotlib")


@pytest.fixture(scope="module")
def orbit():
    return min(stridemap.find_orbits("wobbling", k=6), key=lambda o: o.spectral_radius)


def test_profiles_are_the_motion(orbit):
    figure, seen = plot(orbit, samples=51), stridemap.motion(orbit, 51)
    panels = {axes.get_ylabel(): axes for axes in figure.axes}
    curves = {
        r"$\theta_{1}$": seen.q[:, 0], r"$\theta_{2}$": seen.q[:, 1], "$x$": seen.q[:, 2],
        r"$\dot{\theta}_{1}$": seen.v[:, 0], r"$\dot{\theta}_{2}$": seen.v[:, 1], r"$\dot{x}$": seen.v[:, 2],
        "ground force": seen.force[:, 1], "distance": seen.d,
    }  # fmt: skip
    assert len(panels) == len(curves)
    for start, values in curves.items():
        (axes,) = (axes for label, axes in panels.items() if label.startswith(f"{start}  ["))
        assert np.array_equal(axes.lines[0].get_xdata(), seen.t)
        assert np.array_equal(axes.lines[0].get_ydata(), values)
    assert {axes.get_xlabel() for axes in figure.axes[-2:]} == {r"time  $t$  [$\sqrt{L/g}$]"}
    assert r"$x$  [$L$]" in panels
    assert r"ground force  [$M\,g$]" in panels
    assert figure.get_suptitle() == "Compass walker with a horizontally wobbling mass, group B, stable"


def test_phase_portraits_are_the_motion(orbit):
    figure, seen = plot(orbit, "phase", samples=51), stridemap.motion(orbit, 51)
    for i, axes in enumerate(figure.axes):
        curve, jump, start = axes.lines
        assert np.array_equal(curve.get_xydata(), np.column_stack([seen.q[:, i], seen.v[:, i]]))
        assert np.array_equal(jump.get_xydata(), curve.get_xydata()[[-1, 0]])
        assert np.array_equal(start.get_xydata(), curve.get_xydata()[:1])


@pytest.mark.parametrize("kind", ["profiles", "phase"])
@pytest.mark.parametrize("model", ["goswami_compass", "rimless_wheel", "simplest_walker"])
def test_any_model(model, kind, tmp_path):
    (orbit, *_) = stridemap.find_orbits(model)
    plot(orbit, kind).savefig(tmp_path / "plot.png")
    assert (tmp_path / "plot.png").stat().st_size > 5000


@pytest.mark.parametrize("kind", ["profile", None, ["phase"]])
def test_an_unknown_kind(orbit, kind):
    with pytest.raises(InputError, match="is not a kind of plot; kinds are profiles, phase$"):
        plot(orbit, kind)


def test_without_matplotlib(orbit, monkeypatch):
    monkeypatch.setattr(optional, "find_spec", lambda name: None if name == "matplotlib" else name)
    with pytest.raises(InputError, match="drawing needs matplotlib, which is not installed here: run `pip"):
        plot(orbit)


def test_importing_needs_nothing_that_draws():
    code = "import sys, stridemap.views.plots; assert 'matplotlib' not in sys.modules"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
