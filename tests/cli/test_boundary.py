"""``stridemap boundary``: the curves, the double points, the files and what is refused."""

import json
import math

import numpy as np
import pandas as pd
import pytest

import stridemap

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
