"""``stridemap branch``: the table, the JSON, the files and what is refused."""

import json

import pandas as pd
import pytest

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
