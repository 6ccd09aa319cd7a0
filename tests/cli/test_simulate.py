"""`stridemap simulate`: starts within a step, time series as files, and outcomes in words."""

import json

import numpy as np
import pandas as pd
import pyarrow.parquet as pq
import pytest

import stridemap

SIMPLEST = ("--model", "simplest_walker", "--slope", 0.009, "--state", "theta=0.2", "--state", "dtheta=-0.2")
SEVEN = (
    "--model", "rimless_wheel", "--spokes", 7, "--lambda2", 0.925925925925926, "--slope", 0.0523598775598,
    "--state", "theta=0", "--state", "dtheta=0.3193",
)  # fmt: skip


@pytest.fixture(scope="module")
def walk():
    return stridemap.simulate("simplest_walker", {"theta": 0.2, "dtheta": -0.2}, steps=3, slope=0.009)


@pytest.mark.parametrize("ending", ["parquet", "csv"])
def test_the_time_series_as_a_file(run, tmp_path, walk, ending):
    path = tmp_path / "new" / f"walk.{ending}"
    status, _, err = run("simulate", *SIMPLEST, "--steps", 3, "--trajectory", path, "--rate", 50)
    assert (status, err) == (0, "")
    frame = pd.read_parquet(path) if ending == "parquet" else pd.read_csv(path)
    wanted = walk.trajectory(1 / 50).to_frame()
    assert list(frame.columns) == list(wanted.columns)
    pd.testing.assert_frame_equal(frame, wanted, check_dtype=False, check_exact=ending == "parquet")
    again = tmp_path / f"again.{ending}"
    run("simulate", *SIMPLEST, "--steps", 3, "--trajectory", again, "--rate", 50)
    assert again.read_bytes() == path.read_bytes()
    if ending == "parquet":
        about = json.loads(pq.read_schema(path).metadata[b"stridemap"])
        assert about["model"] == "simplest_walker"
        assert about["params"] == {"slope": 0.009}
        assert (about["rate"], about["outcome"]) == (50.0, "walked")


def test_a_hundred_rows_per_unit_of_time_unless_it_is_said(run, tmp_path):
    run("simulate", *SIMPLEST, "--steps", 1, "--trajectory", tmp_path / "w.csv")
    frame = pd.read_csv(tmp_path / "w.csv")
    assert np.allclose(np.diff(frame.time[frame.event == "sample"]), 0.01)


def test_a_wheel_that_rocks_back_says_so(run):
    status, out, err = run("simulate", *SEVEN)
    assert (status, err) == (1, "")
    assert out.splitlines()[-1] == "rocks back after 1 of 10 steps"
    assert "lacked the energy" in out
    status, out, _ = run("simulate", *SEVEN, "--json")
    assert json.loads(out)["outcome"] == "rocks_back"


def test_from_within_a_step(run):
    words = ("theta1=0", "theta2=0", "dtheta1=-0.1277", "dtheta2=0.5108")
    start = [word for entry in words for word in ("--from", entry)]
    status, out, err = run("simulate", "--model", "goswami_compass", "--slope", 0.0525, *start, "--json")
    assert err == ""
    assert json.loads(out)["start"] == {
        "t": 0.0, "theta1": 0.0, "theta2": 0.0, "dtheta1": -0.1277, "dtheta2": 0.5108,
    }  # fmt: skip
    status, _, err = run("simulate", "--model", "goswami_compass", *start[2:])
    assert status == 2
    assert "missing: theta1" in err


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--trajectory", "walk.txt"), "its ending must be .parquet or .csv"),
        (("--trajectory", "walk.csv", "--rate", 0), "--rate 0 is not allowed"),
        (("--trajectory", "walk.csv", "--rate", "inf"), "--rate inf is not allowed"),
        (("--trajectory", "walk.csv", "--rate", "nan"), "--rate nan is not allowed"),
        (("--rate", 10), "--rate 10 has no effect without --trajectory"),
        (("--trajectory", "walk.csv", "--rate", 1e9), "more than 10,000,000 rows"),
        (("--from", "theta=0.1"), "two ways to say where a walk begins"),
        (("--from", "0.1"), "write --from NAME=VALUE"),
    ],
)
def test_what_cannot_be_done_is_refused(run, tmp_path, monkeypatch, words, sentence):
    monkeypatch.chdir(tmp_path)
    status, out, err = run("simulate", *SIMPLEST, "--steps", 2, *words)
    assert (status, out) == (2, "")
    assert sentence in err
    assert list(tmp_path.iterdir()) == []


def test_a_file_that_cannot_be_written(run, tmp_path):
    (tmp_path / "file").write_text("")
    status, _, err = run("simulate", *SIMPLEST, "--steps", 1, "--trajectory", tmp_path / "file" / "w.csv")
    assert status == 2
    assert "cannot write" in err
