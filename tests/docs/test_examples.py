"""The examples run without a screen, and what they conclude is so."""

import re
import runpy
from pathlib import Path

import numpy as np
import pytest

import stridemap
from tests.oracles.states import need

matplotlib = pytest.importorskip("matplotlib")

FOLDER = Path(__file__).resolve().parents[2] / "examples"
SCRIPTS = sorted(FOLDER.glob("*.py"))


@pytest.fixture
def example(monkeypatch, tmp_path, capsys):
    """Run an example; returns its names and what it printed."""
    monkeypatch.setenv("MPLBACKEND", "Agg")
    monkeypatch.chdir(tmp_path)  # they must leave nothing behind
    pyplot = pytest.importorskip("matplotlib.pyplot")
    pyplot.switch_backend("Agg")

    def run(number):
        (script,) = FOLDER.glob(f"{number}_*.py")
        names = runpy.run_path(str(script), run_name="__main__")
        shown = pyplot.get_fignums() or isinstance(names.get("figure"), matplotlib.figure.Figure)
        assert shown, "an example shows a figure"
        assert list(tmp_path.iterdir()) == []
        return names, capsys.readouterr().out

    yield run
    pyplot.close("all")


def test_find_a_limit_cycle(example):
    names, out = example(1)
    assert re.findall(r"group B, (\w+): period ([\d.]+)", out) == [
        ("unstable", "1.154473"),
        ("stable", "1.183740"),
    ]
    # The slope of the walk is the multiplier, though no code is shared. At the first of the last thirty steps
    # (0.9007/0.9694)^60 = 1.2 % of the pair is left, which is 4e-4 a step.
    assert names["rate"] == pytest.approx(names["stable"].spectral_radius, abs=4e-4)


def test_sweep_a_spring(example):
    names, _ = example(2)
    orbits = names["orbits"]
    assert [panel.get_ylabel() for panel in names["axes"]] == list(names["measures"].values())
    assert set("ABCD") <= set(orbits.group.dropna())
    in_b = names["in_b"]
    # The sentences about the ends of group B: a real multiplier near 1, a pair near -1.
    soft, stiff = in_b.iloc[0], in_b.iloc[-1]
    assert soft.multiplier_0_im == 0
    assert soft.multiplier_0_re > 0.9
    assert abs(complex(stiff.multiplier_0_re, stiff.multiplier_0_im) + 1) < 0.1
    few = stridemap.find_orbits("wobbling", k=float(soft.k), alpha=0.25, omega=3)
    assert any(abs(orbit.period - soft.period) < 1e-9 for orbit in few)


def test_read_the_generated_c(example):
    names, out = example(3)
    assert names["worst"] < 1e-14
    assert "M[8] = alpha;" in out
    assert (
        "-0.2487510413195064415" in out
    )  # -0.25 cos 0.1 = -0.25 x 0.99500416527802576610 (Abramowitz & Stegun)


def test_use_the_c_in_your_own_program(example):
    need("cc", "gcc", "clang")
    names, _ = example(4)
    assert names["difference"].max() < 2e-9
    assert names["closing"] < 1e-9


def test_is_my_spring_in_group_b(example):
    names, out = example(5)
    robot, gait = names["robot"], names["gait_in_b"]
    assert robot.unit("stiffness") == pytest.approx(40 * 9.80665 / 0.8)
    softest, stiffest = names["softest"], names["stiffest"]
    assert 2900 < softest < 3500 < stiffest < 5500
    # A fold at the soft edge: a multiplier at 1, a second cycle that merges with it, and nothing beyond.
    edge = gait(softest)
    assert edge.multipliers[0] == pytest.approx(1, abs=2e-3)
    point = robot.parameters("wobbling", **(names["si"] | {"k": softest + 0.5}))
    near = [orbit for orbit in stridemap.find_orbits("wobbling", **point) if orbit.group == "B"]
    assert sorted(orbit.stable for orbit in near) == [False, True]
    beyond = robot.parameters("wobbling", **(names["si"] | {"k": softest - 0.5}))
    assert len(stridemap.find_orbits("wobbling", beyond)) == 0
    # A period doubling at the stiff edge: the gait goes on with a real multiplier below -1.
    point = robot.parameters("wobbling", **(names["si"] | {"k": stiffest + 5}))
    (orbit,) = [orbit for orbit in stridemap.find_orbits("wobbling", **point) if orbit.group == "B"]
    assert orbit.multipliers[0].imag == 0
    assert orbit.multipliers[0].real < -1
    # The event-driven simulator agrees on which side is which: a small push dies out, or does not.
    grown = [push(names, stiffest + offset) for offset in (-100, 20)]
    assert grown[0] < 0.9 < 1.1 < grown[1]
    assert "-16.5 % and +54.8 %" in out  # "softer by a sixth or stiffer by half"


def test_swinging_torso(example):
    names, out = example(6)
    undamped, damped, compass = names["undamped"], names["damped"], names["compass"]
    # The sentences: stable only with a spring ten times what holds the torso up; cheaper than the compass.
    assert min(undamped[undamped.stable].k.min(), damped[damped.stable].k.min()) > 10 * 0.125
    assert names["gait"].stable
    assert names["gait"].cot < compass.cot
    assert "cost of transport 0.294, compass 0.308" in out


def push(names, spring):
    """By what factor 40 steps change a small distance from the cycle; the spring in N/m."""
    point = names["robot"].parameters("wobbling", **(names["si"] | {"k": spring}))
    (orbit,) = [o for o in stridemap.find_orbits("wobbling", **point) if o.group == "B"]
    cycle = np.array(list(orbit.state.values()))
    state = dict(zip(orbit.state, cycle + np.array([0, 0, 0, 1e-5, 0]), strict=True))
    walk = stridemap.simulate("wobbling", state, steps=80, **point)
    away = [np.linalg.norm(np.array(list(step.state.values())) - cycle) for step in walk.steps]
    return max(away[70:80]) / max(away[30:40])


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda path: path.stem)
def test_each_example_is_a_page(script):
    """A title first, text between the code, and no line that hides in the gallery's build."""
    text = script.read_text("utf-8")
    number = script.stem.split("_")[0]
    assert re.match(rf'"""\n{number}\. .+\n=+\n', text)
    assert text.count("# %%") >= 3


def test_every_example_has_a_test():
    tested = re.findall(r"example\((\d)\)", Path(__file__).read_text("utf-8"))
    assert tested == [script.stem[0] for script in SCRIPTS]


def test_walk_with_the_c(example):
    names, out = example(7)
    assert len(names["simulated"]) == 20
    assert names["off_double"].max() < 1e-9
    assert 1e-9 < names["off_float"].max() < 1e-4
    # The push is felt: the walk does not merely stand on the cycle.
    assert np.abs(names["simulated"][0] - names["fixed_point"]).max() > 1e-3
    room = names["room"]  # code of the step and of the equations, and stack
    assert all(500 < size < 20_000 for sizes in room.values() for size in sizes)
    assert room["float"][2] < 0.8 * room["double"][2]
    assert len(re.findall(r"[\d,]+ bytes of code in the step function, [\d,]+ in the equations", out)) == 2


def test_how_much_damping(example):
    names, out = example(8)
    best, compass = names["best"], names["compass"]
    # The sentences: where the gain is gone with the paper's springs, in per cent of critical damping ...
    shares = re.findall(r"group (\w): (\w+) is the compass's at ([\d.]+) %", out)
    assert [(group, name, round(float(share), 1)) for group, name, share in shares] == [
        ("B", "cot", 1.5), ("B", "d_max", 2.0), ("C", "cot", 1.6), ("C", "d_max", 1.8),
    ]  # fmt: skip
    # ... with the best spring for each damper, and in group A nowhere, with or without a damper.
    lost = {g: np.interp(compass.cot, rows.cot, rows.share) for g, rows in best.groupby("group") if g != "A"}
    assert lost == pytest.approx({"B": 2.6, "C": 1.9}, abs=0.05)
    assert best[best.group == "A"].cot.min() > compass.cot
    # Every group gets more stable.
    ends = best.sort_values("c").groupby("group").spectral_radius.agg(["first", "last"])
    assert (ends["last"] < ends["first"] - 0.05).all()


def test_limit_cycles_in_a_notebook(example):
    names, _ = example(9)
    stable, si, lowest = names["stable"], names["si"], names["lowest"]
    # What the page shows: tables and pictures, as elements of a page.
    for shown in (names["orbits"], stable, names["figure"]):
        assert "<svg" in shown._repr_html_()
    assert "<td>1.1837395</td><td>sqrt(L/g)</td>" in stable._repr_html_()
    assert names["cheapest"]["cot"].is_monotonic_increasing
    assert float(lowest.sel(k=6)) == pytest.approx(stable.cot, rel=1e-9)
    assert names["figure"].axes[0].get_xlabel().endswith(r"$\mathrm{N}/\mathrm{m}$]")
    # 32 kg, 9.80665 m/s^2 and 0.75 m: a k of 6 is 2,510.5 N/m.
    assert np.abs(si.frame["k"] - 6 * 32 * 9.80665 / 0.75).min() < 1e-6
