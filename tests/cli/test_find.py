"""`stridemap find`."""

import json

import pytest

WHEEL = ("--model", "rimless_wheel", "--spokes", 10.471975511965978, "--set", "lambda2=1", "--vary", "slope")
RANGE = ("--range", 0, 0.3)


def test_what_counts_something_is_not_solved_for(refused):
    refused(
        "find --model rimless_wheel --target speed=0.45 --vary spokes --range 4 8", "spokes", "whole numbers"
    )


def test_as_a_table(run):
    status, out, err = run("find", "--target", "speed = 0.45", *WHEEL, *RANGE)
    assert (status, err) == (0, "")
    (row,) = [line.split() for line in out.splitlines() if line.startswith("slope ")]
    assert float(row[1]) == pytest.approx(0.08764356491945, abs=1e-13)


def test_as_json(run):
    status, out, err = run("find", "--target", "speed=0.45", *WHEEL, *RANGE, "--json")
    assert (status, err) == (0, "")
    told = json.loads(out)
    assert told["target"] == {"quantity": "speed", "value": 0.45}
    assert (told["vary"], told["range"]) == ("slope", [0.0, 0.3])
    (orbit,) = told["orbits"]
    assert orbit["params"]["slope"] == pytest.approx(0.08764356491945, abs=1e-13)
    assert orbit["speed"] == pytest.approx(0.45, abs=1e-14)


def test_none_is_status_1(run):
    status, out, err = run("find", "--target", "speed = 4.5", *WHEEL, *RANGE)
    assert (status, out) == (1, "")
    assert err.startswith("no limit cycle with speed = 4.5 was found for slope from 0 to 0.3: on the ")
    status, out, _ = run("find", "--target", "speed = 4.5", *WHEEL, *RANGE, "--json")
    assert (status, json.loads(out)["orbits"]) == (1, [])


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--target", "speed"), "write it as 'speed = 0.45'"),
        (("--target", "speed = 1", "--range", "a", "b"), "two finite numbers"),
        (("--target", "speed = 1", "--set", "slop=1"), "did you mean slope"),
    ],
)
def test_what_cannot_be_done_is_refused(run, words, sentence):
    status, out, err = run("find", *WHEEL, *words)
    assert (status, out) == (2, "")
    assert sentence in err
