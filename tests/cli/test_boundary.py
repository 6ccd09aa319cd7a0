"""``stridemap boundary``: the curves, the double points, the files and what is refused."""

import io
import json
import math

import numpy as np
import pandas as pd
import pytest

import stridemap
from stridemap.views.report.curves import read_curves

LINE = (
    "boundary --model goswami_compass --vary slope --range 0.05 0.1 --vary mu --range 1 4 --lines 1 --seeds 2"
)


@pytest.fixture(scope="module")
def found():
    return stridemap.boundaries("goswami_compass", ("slope", "mu"), ((0.05, 0.1), (1, 4)), lines=1, seeds=2)


def test_json_has_the_curve(run, found):
    status, out, err = run(*LINE.split(), "--json")
    assert (status, err) == (0, "")
    data = json.loads(out)
    assert (data["vary"], data["ranges"]) == (["slope", "mu"], [[0.05, 0.1], [1.0, 4.0]])
    (one,) = data["boundaries"]
    assert (one["type"], one["period_n"], one["ends"]) == ("pd", 1, ["range", "range"])
    assert one["curve"] == found[0].cycles[:, -2:].tolist()
    assert all(one["gait"]) and all(one["borders_stable"])
    assert {mu for _, mu in (one["curve"][0], one["curve"][-1])} == {1.0, 4.0}


def test_it_passes_the_doubling_that_is_known(found):
    """At mu = 2 the compass's period doubles at 4.390898249724 degrees."""
    (one,) = found
    slope, mu = one.cycles[:, -2:].T
    order = np.argsort(mu)
    near = np.interp(2.0, mu[order], slope[order])
    assert math.degrees(near) == pytest.approx(4.390898249724, abs=1e-3)
    # The curve's own point there, corrected along its plane, has all digits.
    point = one.points[int(np.abs(mu - 2.0).argmin())]
    from stridemap.solver.branches.arclength import at_value

    exact = at_value(one.curve, point.x, 2.0, point.tangent, 8)
    assert math.degrees(exact.x[-2]) == pytest.approx(4.390898249724, abs=1e-9)
    np.testing.assert_allclose(exact.multipliers[0], -1.0, atol=1e-10)


@pytest.mark.parametrize("mu", [1.5, 3.0])
def test_a_branch_crosses_it_where_it_says(found, mu):
    from stridemap.solver.branches.arclength import at_value

    (one,) = found
    point = one.points[int(np.abs(one.cycles[:, -1] - mu).argmin())]
    exact = at_value(one.curve, point.x, mu, point.tangent, 8)
    branch = stridemap.branches("goswami_compass", "slope", (0.05, 0.1), mu=mu, seeds=2)
    (doubling,) = [special for special in branch.special if special.type == "pd"]
    assert doubling.value == pytest.approx(exact.x[-2], abs=1e-11)


def test_tables_and_the_picture_are_written(run, tmp_path):
    status, out, _ = run(*LINE.split(), "--out", tmp_path / "b.csv", "--plot", tmp_path / "b.svg")
    assert status == 0
    assert "0: pd, " in out
    points = pd.read_csv(tmp_path / "b.csv")
    assert {"boundary", "type", "gait", "borders_stable", "slope", "mu", "theta1", "period"} <= set(points)
    assert (tmp_path / "b_points.csv").exists()
    assert "PD" in (tmp_path / "b.svg").read_text("utf-8")


@pytest.mark.quick
def test_refusals(refused):
    refused("boundary --model goswami_compass --vary slope --range 0.05 0.1", "two names")
    refused(LINE.replace("--range 1 4", "--range 4 1"), "mu", "ascending order")
    refused(LINE.replace("--vary mu", "--vary slope"), "slope", "twice")
    refused(LINE.replace("--vary mu", "--vary k"), "'k'", "mu")
    refused(LINE.replace("--range 1 4", "--range 1 x"), "1 x", "LOW HIGH")
    refused(LINE.replace("--range 1 4 ", ""), "two pairs")
    refused(f"{LINE} --mu 2", "mu = 2", "leave it out")
    refused(f"{LINE} --lines 0", "lines = 0")
    refused(f"{LINE} --out b.txt", "b.txt", ".parquet")


@pytest.mark.quick
def test_arguments_of_another_kind_are_refused():
    for vary, ranges in (("slope", ((0, 1), (0, 1))), (("slope", "mu"), 3), (("slope",), ((0, 1),))):
        with pytest.raises(stridemap.InputError, match="not allowed"):
            stridemap.boundaries("goswami_compass", vary, ranges)


# -- in SI units ---------------------------------------------------------------------------------------------

LENGTH, MASS, GRAVITY = 0.8, 40.0, 9.81
SECOND = math.sqrt(LENGTH / GRAVITY)
OWN = {"vary": ("radius", "hip_mass"), "ranges": ((0.05, 0.2), (0.9, 1.1))}
ROUND = ["boundary", *"--model round_feet --lines 1 --seeds 2 --starts 64 --slope 0.08".split()]
for name, (low, high), factor in zip(OWN["vary"], OWN["ranges"], (LENGTH, MASS), strict=True):
    ROUND += ["--vary", name, "--range", repr(low * factor), repr(high * factor)]
ROUND += ["--units", f"leg_length={LENGTH},mass={MASS},gravity={GRAVITY}"]


@pytest.fixture(scope="module")
def own():
    options = stridemap.SearchOptions(64)
    return stridemap.boundaries("round_feet", **OWN, slope=0.08, lines=1, seeds=2, search=options)


def test_boundaries_in_si_units(run, own, tmp_path):
    words = [*ROUND, "--json", "--out", tmp_path / "b.parquet", "--plot", tmp_path / "b.svg"]
    status, out, err = run(*words)
    assert (status, err) == (0, "")
    found, plain = json.loads(out), own.to_dict()
    assert found["units"] == {"leg_length": LENGTH, "mass": MASS, "gravity": GRAVITY}
    assert found["ranges"] == [[0.05 * LENGTH, 0.2 * LENGTH], [0.9 * MASS, 1.1 * MASS]]
    assert found["params"]["leg_mass"] == pytest.approx(plain["params"]["leg_mass"] * MASS, rel=1e-14)
    assert len(found["boundaries"]) == len(own) > 0
    for one, other in zip(found["boundaries"], plain["boundaries"], strict=True):
        np.testing.assert_allclose(one["curve"], np.array(other["curve"]) * [LENGTH, MASS], rtol=1e-6)
    table, frame = stridemap.read_table(tmp_path / "b.parquet"), own.to_frame()
    for name, factor in {"radius": LENGTH, "hip_mass": MASS, "period": SECOND, "arclength": 1}.items():
        np.testing.assert_allclose(table.frame[name], frame[name] * factor, rtol=1e-6, atol=1e-9)
    assert [table.columns[name].unit for name in ("radius", "hip_mass", "period")] == ["m", "kg", "s"]
    picture = (tmp_path / "b.svg").read_text("utf-8")
    assert "radius [m]" in picture and "hip_mass [kg]" in picture
    with pytest.raises(stridemap.InputError, match="in SI units, and the report's in the model's"):
        read_curves(tmp_path / "b.parquet")


def test_boundaries_as_comma_separated_values(run, own):
    status, out, _ = run(*ROUND)
    assert status == 0
    assert f"radius from {0.05 * LENGTH:g} to {0.2 * LENGTH:g} m and hip_mass from 36 to 44 kg" in out
    status, text, err = run(*ROUND, "--csv")
    assert (status, err) == (0, "")
    rows, frame = pd.read_csv(io.StringIO(text)), own.to_frame()
    assert list(rows) == list(frame)
    np.testing.assert_allclose(rows["hip_mass"], frame["hip_mass"] * MASS, rtol=1e-6)


def test_comma_separated_values_in_the_units_of_the_model(run, found):
    status, text, _ = run(*LINE.split(), "--csv")
    assert status == 0
    pd.testing.assert_frame_equal(pd.read_csv(io.StringIO(text)), found.to_frame(), check_dtype=False)


@pytest.mark.quick
def test_two_formats_are_refused(refused):
    refused(f"{LINE} --json --csv", "--json and --csv cannot be given together")
