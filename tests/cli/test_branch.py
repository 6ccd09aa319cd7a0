"""``stridemap branch``: the table, the JSON, the files and what is refused."""

import io
import json
import math

import numpy as np
import pandas as pd
import pytest

import stridemap

LINE = "branch --model simplest_walker --vary slope --range 0.014 0.016 --seeds 1"


@pytest.mark.quick
def test_json_has_branches_with_their_special_points(run):
    status, out, err = run(*LINE.split(), "--json")
    assert (status, err) == (0, "")
    data = json.loads(out)
    assert (data["model"], data["vary"], data["range"]) == ("simplest_walker", "slope", [0.014, 0.016])
    (special,) = [one for branch in data["branches"] for one in branch["special"]]
    assert special["type"] == "pd"
    assert special["params"]["slope"] == special["value"] == pytest.approx(0.015088437941, abs=1e-12)
    assert special["multipliers"][0] == pytest.approx([-1.0, 0.0], abs=1e-9)
    assert special["criticality"] == "supercritical"
    assert special["period_n"] == 1
    assert {branch["period_n"] for branch in data["branches"]} == {1}
    assert all(branch["ends"] == ["range", "range"] for branch in data["branches"])


def test_where_starts_lie_can_be_said(run):
    """With none near the cycles that are found otherwise nothing is found."""
    status, out, err = run(
        *LINE.split(), "--starts", 4, "--search-box", "theta=0.9:1", "--search-box", "dtheta=5:6"
    )
    assert (status, out, err) == (1, "", "no limit cycle found\n")


def test_tables_and_the_diagram_are_written(run, tmp_path):
    status, out, _ = run(*LINE.split(), "--out", tmp_path / "b.parquet", "--plot", tmp_path / "b.svg")
    assert status == 0
    assert "pd, supercritical" in out
    points, special = (pd.read_parquet(tmp_path / f"{name}.parquet") for name in ("b", "b_special"))
    assert {"branch", "arclength", "slope", "theta", "period", "cot", "tangent_slope"} <= set(points)
    assert special.type.tolist() == ["pd"]
    assert "PD" in (tmp_path / "b.svg").read_text("utf-8")


@pytest.mark.quick
def test_refusals(refused, tmp_path):
    refused("branch --model simplest_walker --vary k --range 0 1", "'k'", "slope")
    refused("branch --model simplest_walker --vary slope --range 1 0", "ascending order")
    refused("branch --model rimless_wheel --vary spokes --range 4 8", "spokes", "whole numbers", "sweep")
    refused(f"{LINE} --period-n 0", "period_n = 0")
    refused(f"{LINE} --out b.txt", "b.txt", ".parquet")
    refused(f"{LINE} --plot b.xyz", "b.xyz", "svg")
    refused(f"{LINE} --plot b.svg --show nothing", "nothing", "period")


# -- in SI units ---------------------------------------------------------------------------------------------

LENGTH, MASS, GRAVITY = 0.8, 40.0, 9.81
SIZE = ["--units", f"leg_length={LENGTH},mass={MASS},gravity={GRAVITY}"]
SECOND = math.sqrt(LENGTH / GRAVITY)
ROUND = [
    *"branch --model round_feet --vary radius --seeds 2 --starts 64 --slope 0.08 --hip_mass".split(),
    repr(1.1 * MASS), "--range", repr(0.05 * LENGTH), repr(0.3 * LENGTH),
]  # fmt: skip


@pytest.fixture(scope="module")
def both(tmp_path_factory):
    """The same branches in the model's units and in metres, as JSON and tables."""
    folder = tmp_path_factory.mktemp("si")
    own = stridemap.branches(
        "round_feet", "radius", (0.05, 0.3), slope=0.08, hip_mass=1.1, seeds=2,
        search=stridemap.SearchOptions(64),
    )  # fmt: skip
    return own, folder


def test_branches_in_si_units(run, both):
    own, folder = both
    status, out, err = run(*ROUND, *SIZE, "--json", "--out", folder / "b.csv")
    assert (status, err) == (0, "")
    found = json.loads(out)
    assert found["units"] == {"leg_length": LENGTH, "mass": MASS, "gravity": GRAVITY}
    assert found["range"] == [0.05 * LENGTH, 0.3 * LENGTH]  # as they were given, to the bit
    assert found["params"]["hip_mass"] == 1.1 * MASS
    assert found["params"]["inertia"] == pytest.approx(own.params["inertia"] * MASS * LENGTH**2, rel=1e-14)
    assert found["params"]["slope"] == 0.08
    plain = own.to_dict()
    for one, other in zip(found["branches"], plain["branches"], strict=True):
        assert one["from"] == pytest.approx(other["from"] * LENGTH, rel=1e-9)
        assert one["to"] == pytest.approx(other["to"] * LENGTH, rel=1e-9)
        for special, same in zip(one["special"], other["special"], strict=True):
            assert special["value"] == pytest.approx(same["value"] * LENGTH, rel=1e-9)
            assert special["params"]["radius"] == special["value"]
            assert special["period"] == pytest.approx(same["period"] * SECOND, rel=1e-9)
            assert special["steps"][0][-1] == special["period"]
            for name, value in special["state"].items():
                factor = 1 / SECOND if name.startswith("d") else 1.0
                assert value == pytest.approx(same["state"][name] * factor, rel=1e-8)
                assert special["steps"][0][list(special["state"]).index(name)] == value
            assert special["null"].keys() == same["null"].keys() if same["null"] else True
    assert sum(len(one["special"]) for one in found["branches"]) == len(own.special) > 0
    table, frame = pd.read_csv(folder / "b.csv"), own.to_frame()
    factors = {
        "radius": LENGTH, "hip_mass": MASS, "period": SECOND, "speed": LENGTH / SECOND, "cot": 1.0,
        "work": MASS * GRAVITY * LENGTH, "min_vertical_force": MASS * GRAVITY, "arclength": 1.0,
        "multiplier_0_re": 1.0,
    }  # fmt: skip
    for name, factor in factors.items():
        np.testing.assert_allclose(table[name], frame[name] * factor, rtol=1e-6, atol=1e-9, err_msg=name)
    special = pd.read_csv(folder / "b_special.csv")
    np.testing.assert_allclose(special["value"], [one.value * LENGTH for one in own.special], rtol=1e-9)


def test_printed_and_drawn_in_si_units(run, both):
    own, folder = both
    status, out, _ = run(*ROUND, *SIZE, "--plot", folder / "b.svg", "--out", folder / "b.parquet")
    assert status == 0
    lines = out.splitlines()
    assert lines[0].endswith(f"over radius from {0.05 * LENGTH:g} to {0.3 * LENGTH:g} m")
    head = next(line for line in lines if line.startswith("type"))
    assert head.split()[1:5] == ["radius", "[m]", "period", "[s]"]
    first = lines[lines.index(head) + 1].split()
    assert float(first[-6]) == pytest.approx(own.special[0].value * LENGTH, rel=1e-9)
    assert "radius [m]" in (folder / "b.svg").read_text("utf-8")
    assert "step period [s]" in (folder / "b.svg").read_text("utf-8")
    read = stridemap.read_table(folder / "b.parquet")
    assert read.columns["radius"].unit == "m"
    status, text, err = run(*ROUND, *SIZE, "--csv")
    assert (status, err) == (0, "")
    assert text.splitlines()[0].split(",")[:3] == ["branch", "period_n", "gait"]
    np.testing.assert_allclose(pd.read_csv(io.StringIO(text))["radius"], read.frame["radius"], rtol=1e-12)


@pytest.mark.quick
def test_refusals_of_sizes(refused):
    refused(f"{LINE} --units mass=3", "--units: leg_length is missing")
    refused(f"{LINE} --json --csv", "--json and --csv cannot be given together")
