"""Sweep configurations: resolution, hash, and every bad input."""

import hashlib
import json
import math
from dataclasses import asdict
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import stridemap.sweeps
from stridemap.errors import InputError
from stridemap.solver.model.loading import load
from stridemap.solver.options import IN_SWEEPS, IN_SWEEPS_OF_CYCLES, AcceptanceOptions
from stridemap.sweeps.config import Range, canonical_json, load_config, parse_config

pytestmark = pytest.mark.quick

PAPER = Path(stridemap.sweeps.__file__).parent / "paper.toml"
PRESET = {"beta": 0.15, "Kp": 10.0, "Kd": 0.6, "S": 0.18, "gamma": 0.18}
UNDAMPED = {**PRESET, "c": 0.0}
DEFAULTS = {parameter.name: parameter.default for parameter in load("wobbling").parameters}


def write(folder, text):
    path = folder / "sweep.toml"
    path.write_text(text, encoding="utf-8")
    return path


def config(**tables):
    return parse_config({"model": "wobbling", "grid": {"k": [1.0, 2.0]}, **tables})


# Reading and resolving


def test_default_file_is_the_papers_map():
    paper = load_config(PAPER)
    assert paper.model == "wobbling"
    assert paper.params == UNDAMPED
    assert list(paper.grid) == ["k", "alpha", "omega"]
    assert paper.grid["omega"] == (2.0, 2.5, 3.0, 3.5)
    assert paper.grid["k"] == tuple(i / 2 for i in range(1, 121))
    assert {0.5, 6.0, 22.5} <= set(paper.grid["k"])  # the paper's typical solutions
    assert {0.25, 0.5} <= set(paper.grid["alpha"])
    assert paper.n_cells == 16800
    assert not paper.special_points


def test_range_values_are_those_one_would_write():
    assert load_config(PAPER).grid["alpha"] == tuple(i / 1000 for i in range(50, 901, 25))
    assert Range(start=0.1, stop=1000, num=5, spacing="log").values() == [0.1, 1.0, 10.0, 100.0, 1000.0]
    assert Range(start=-0.3, stop=0.3, num=7).values() == [-0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3]
    assert Range(start=7, stop=7, num=1).values() == [7.0]


@settings(deadline=None)
@given(st.floats(1e-6, 1e6), st.floats(1e-6, 1e6), st.integers(2, 50), st.sampled_from(["linear", "log"]))
def test_range_agrees_with_numpy_and_keeps_its_ends(start, stop, num, spacing):
    values = Range(start=start, stop=stop, num=num, spacing=spacing).values()
    numpy_values = (np.linspace if spacing == "linear" else np.geomspace)(start, stop, num)
    np.testing.assert_allclose(values, numpy_values, rtol=1e-12)
    assert (values[0], values[-1]) == (start, stop)


def test_fixed_parameters_override_the_preset_and_grid_ones_leave_it():
    resolved = config(params={"beta": 0.2, "omega": 2}, grid={"k": [1]})
    assert resolved.params == {**UNDAMPED, "alpha": DEFAULTS["alpha"], "beta": 0.2, "omega": 2.0}
    assert resolved.grid == {"k": (1.0,)}
    assert list(resolved.params) == ["alpha", "omega", "beta", "Kp", "Kd", "S", "gamma", "c"]


def test_other_model():
    compass = parse_config({"model": "compass", "grid": {"omega": [2, 3]}})
    assert compass.params == PRESET


def test_values_are_stored_ascending():
    assert config(grid={"k": [3, 1, 2]}).grid["k"] == (1.0, 2.0, 3.0)
    assert config(grid={"k": {"start": 3, "stop": 1, "num": 3}}).grid["k"] == (1.0, 2.0, 3.0)


def test_config_cannot_be_changed():
    with pytest.raises(ValueError, match="frozen"):
        config().model = "compass"


def test_strides_are_resolved_for_every_axis():
    grid = {"k": list(range(1, 11)), "omega": [2, 2.5, 3], "alpha": [0.3]}
    assert config(grid=grid, search={"subgrid": 5}).strides == {"k": 5, "alpha": 1, "omega": 2}
    assert config(grid=grid, search={"subgrid": {"k": 3}}).strides == {"k": 3, "alpha": 1, "omega": 1}


def test_settings_at_their_limits_are_accepted():
    least = {"starts": 1, "seed": 0, "subgrid": 1, "period_min": 0.01, "period_max": 0.02}
    assert config(search=least).search.model_dump() == {**least, "search_box": {}, "widen": 1.0}
    assert config(search={"seed": 2**32 - 1}).search.seed == 4294967295
    assert config(grid={"k": {"start": 7, "stop": 7, "num": 1}}, max_cells=1).grid == {"k": (7.0,)}


def test_a_first_step_is_not_longer_than_the_longest_that_is_given():
    assert config(continuation={"ds_max": 0.01}).continuation.ds == 0.01
    assert config(continuation={"ds_max": 0.3}).continuation.ds == IN_SWEEPS.ds
    assert config(special_points=False).continuation == IN_SWEEPS_OF_CYCLES
    assert config(continuation={"ds_max": 0.3, "ds": 0.2}).continuation.ds == 0.2
    for refused in ({"ds_max": 0.01, "ds": 0.2}, {"ds_max": 0.0}, {"ds_max": "long"}, {"ds_max": True}):
        with pytest.raises(InputError, match="continuation"):
            config(continuation=refused)


# The hash


def test_hash_is_sha256_of_canonical_json():
    resolved = config(search={"starts": 7, "subgrid": 3})
    assert json.loads(resolved.canonical()) == {
        "model": "wobbling",
        "params": {name: value for name, value in DEFAULTS.items() if name != "k"},
        "grid": {"k": [1.0, 2.0]},
        "search": {
            "starts": 7,
            "seed": 0,
            "subgrid": {"k": 1},
            "period_min": 0.3,
            "period_max": 3.0,
            "search_box": {},
            "widen": 1.0,
        },
        "acceptance": asdict(AcceptanceOptions()),
        "continuation": asdict(IN_SWEEPS),
        "special_points": True,
    }
    assert resolved.canonical() == canonical_json(json.loads(resolved.canonical()))
    assert resolved.config_hash == hashlib.sha256(resolved.canonical().encode()).hexdigest()


def test_canonical_json_is_sorted_compact_and_refuses_nan():
    assert canonical_json({"b": 0.1, "a": [1, None, "é"]}) == '{"a":[1,null,"\\u00e9"],"b":0.1}'
    with pytest.raises(ValueError, match="JSON"):
        canonical_json({"a": math.nan})


@settings(deadline=None)
@given(st.randoms(use_true_random=False))
def test_hash_does_not_depend_on_any_order(random):
    def shuffled(items):
        return random.sample(list(items), len(items))

    def table(entries):
        return dict(shuffled(entries.items()))

    tables = {
        "model": "wobbling",
        "params": {"beta": 0.1, "Kp": 9.0, "gamma": 0.17},
        "grid": {"k": [0.5, 6.0, 22.5], "omega": [2.0, 3.0], "alpha": [0.25, 0.5]},
        "search": {"starts": 10, "seed": 3, "subgrid": {"k": 2, "omega": 1, "alpha": 1}},
    }
    reordered = table(
        {name: table(part) if isinstance(part, dict) else part for name, part in tables.items()}
    )
    reordered["grid"] = {name: shuffled(values) for name, values in reordered["grid"].items()}
    assert parse_config(reordered).config_hash == parse_config(tables).config_hash
    assert list(parse_config(reordered).grid) == ["k", "alpha", "omega"]


@pytest.mark.parametrize(
    "tables",
    [
        {"params": {"beta": 0.15}},  # the preset, spelt out
        {"grid": {"k": [1, 2]}},  # integers
        {"grid": {"k": {"start": 1, "stop": 2, "num": 2}}},
        {"grid": {"k": {"start": 2, "stop": 1, "num": 2, "spacing": "log"}}},
        {"search": {"starts": 64}},  # a default, spelt out
        {"search": {"subgrid": {"k": 9}}},  # longer than the axis
        {"max_cells": 5},  # a guard, no part of the sweep
    ],
)
def test_same_meaning_same_hash(tables):
    assert config(**tables).config_hash == config().config_hash


def test_minus_zero_is_zero():
    assert config(params={"Kd": -0.0}).config_hash == config(params={"Kd": 0}).config_hash
    zero = config(grid={"Kd": [0, 1]}).config_hash
    assert config(grid={"Kd": [-0.0, 1]}).config_hash == zero
    assert config(grid={"Kd": {"start": -0.0, "stop": 1, "num": 2}}).config_hash == zero


def test_different_meaning_different_hash():
    different = [
        {"params": {"beta": math.nextafter(0.15, 1)}},
        {"grid": {"k": [1.0, math.nextafter(2.0, 3)]}},
        {"grid": {"k": [1.0]}},
        {"grid": {"omega": [1.0, 2.0]}},
        {"search": {"starts": 257}},
        {"search": {"seed": 1}},
        {"search": {"period_max": 2.5}},
        {"grid": {"k": [1, 2, 3]}, "search": {"subgrid": 2}},
    ]
    hashes = [config(**tables).config_hash for tables in different]
    assert len({*hashes, config().config_hash}) == len(different) + 1


# Bad input: (the file, what its one sentence must name)

K = "[grid]\nk = "
BAD = {
    "no model": ("[grid]\nk = [1]", ["model is missing"]),
    "misspelt model key": ("modle = 'wobbling'", ["unknown key modle (did you mean model?)", "max_cells"]),
    "model is a number": ("model = 3", ["model = 3", "name or path of a model"]),
    "unknown model": ("model = 'wobling'\n" + K + "[1]", ["'wobling'", "wobbling", "compass"]),
    "unknown key": (K + "[1]\n[serach]\nstarts = 1", ["unknown key serach (did you mean search?)"]),
    "params no table": ("params = 3\n" + K + "[1]", ["params = 3", "table"]),
    "grid no table": ("grid = [1, 2]", ["grid = [1, 2]", "table"]),
    "unknown parameter": (
        "[params]\nalhpa = 0.3\n" + K + "[1]",
        ["[params] alhpa", "did you mean alpha?", "Kp"],
    ),
    "wrong case": ("[params]\nkp = 1\n" + K + "[1]", ["[params] kp", "did you mean Kp?"]),
    "unknown grid parameter": ("[grid]\nspring = [1]", ["[grid] spring", "k, alpha, omega"]),
    "both": ("[params]\nk = 1\n" + K + "[1, 2]", ["k stands both in [params] and in [grid]"]),
    "no grid": ("", ["[grid] is empty"]),
    "empty grid": ("[grid]", ["[grid] is empty"]),
    "param text": (
        "[params]\nbeta = 'x'\n" + K + "[1]",
        ["[params] beta = 'x'", "not a finite number", "> 0"],
    ),
    "param bool": (
        "[params]\nbeta = true\n" + K + "[1]",
        ["[params] beta = true", "not a finite number", "> 0"],
    ),
    "param nan": (
        "[params]\nbeta = nan\n" + K + "[1]",
        ["[params] beta = nan", "not a finite number", "> 0"],
    ),
    "param inf": (
        "[params]\nbeta = -inf\n" + K + "[1]",
        ["[params] beta = -inf", "not a finite number", "> 0"],
    ),
    "param list": (
        "[params]\nbeta = [1]\n" + K + "[1]",
        ["[params] beta = [1]", "not a finite number", "> 0"],
    ),
    "param date": (
        "[params]\nbeta = 2020-01-01\n" + K + "[1]",
        ["[params] beta", "not a finite number", "> 0"],
    ),
    "param enormous": (
        f"[params]\nbeta = 1{'0' * 400}\n" + K + "[1]",
        ["[params] beta = 1000", "not a finite number", "> 0"],
    ),
    "param hexadecimal": (
        f"[params]\nbeta = 0x{'f' * 5000}\n" + K + "[1]",
        ["an integer of more than 4,300 digits", "not a finite number", "> 0"],
    ),
    "alpha 0": ("[params]\nalpha = 0\n" + K + "[1]", ["[params] alpha = 0 is outside", "> 0 and < 1"]),
    "alpha 1": ("[params]\nalpha = 1.0\n" + K + "[1]", ["[params] alpha = 1.0 is outside", "> 0 and < 1"]),
    "mass negative": ("[params]\nbeta = -0.5\n" + K + "[1]", ["[params] beta = -0.5 is outside", "> 0"]),
    "omega 0": ("[params]\nomega = 0\n" + K + "[1]", ["[params] omega = 0 is outside", "> 0"]),
    "spring negative": (K + "[-2.5, 1]", ["[grid] k[0] = -2.5 is outside", ">= 0"]),
    "alpha above in range": (
        "[grid]\nalpha = {start = 0.5, stop = 1.5, num = 3}",
        ["[grid] alpha: stop = 1.5 is outside", "> 0 and < 1"],
    ),
    "scalar in grid": (K + "3", ["[grid] k = 3", "list of numbers", "[params]"]),
    "text in grid": (K + "'3'", ["[grid] k = '3'", "list of numbers"]),
    "empty list": (K + "[]", ["[grid] k is an empty list"]),
    "item text": (K + "[1, 'a']", ["[grid] k[1] = 'a'", "not a finite number", ">= 0"]),
    "item bool": (K + "[1, false]", ["[grid] k[1] = false", "not a finite number", ">= 0"]),
    "item nan": (K + "[nan]", ["[grid] k[0] = nan", "not a finite number", ">= 0"]),
    "item inf": (K + "[1, 2, inf]", ["[grid] k[2] = inf", "not a finite number", ">= 0"]),
    "nested list": (K + "[[1, 2]]", ["[grid] k[0] = [1, 2]", "not a finite number", ">= 0"]),
    "duplicates": (K + "[1, 3, 2, 3.0]", ["[grid] k", "3.0 more than once"]),
    "zero twice": (K + "[0.0, -0.0]", ["[grid] k", "0.0 more than once"]),
    "range without num": (K + "{start = 1, stop = 2}", ["[grid] k: num is missing", "whole number"]),
    "range misspelt": (
        K + "{start = 1, stpo = 2, num = 3}",
        ["[grid] k: unknown key stpo (did you mean stop?)"],
    ),
    "range empty": (K + "{}", ["[grid] k: start is missing"]),
    "start nan": (K + "{start = nan, stop = 2, num = 3}", ["[grid] k: start = nan", "finite number"]),
    "stop inf": (K + "{start = 1, stop = inf, num = 3}", ["[grid] k: stop = inf", "finite number"]),
    "start text": (K + "{start = '1', stop = 2, num = 3}", ["[grid] k: start = '1'", "finite number"]),
    "start bool": (K + "{start = true, stop = 2, num = 3}", ["[grid] k: start = true", "finite number"]),
    "num 0": (K + "{start = 1, stop = 2, num = 0}", ["[grid] k: num = 0", "from 1 to"]),
    "num fraction": (K + "{start = 1, stop = 2, num = 3.0}", ["[grid] k: num = 3.0", "whole number"]),
    "num bool": (K + "{start = 1, stop = 2, num = true}", ["[grid] k: num = true", "whole number"]),
    "num enormous": (K + f"{{start = 1, stop = 2, num = 1{'0' * 30}}}", ["num = 1000", "to 1,000,000,000"]),
    "num 1 for two ends": (
        K + "{start = 1, stop = 2, num = 1}",
        ["[grid] k: num = 1", "start = 1.0", "stop = 2.0"],
    ),
    "two equal ends": (K + "{start = 2, stop = 2, num = 2}", ["start and stop are both 2.0", "num = 2"]),
    "equal ends": (
        K + "{start = 2, stop = 2, num = 3}",
        ["[grid] k: start and stop are both 2.0", "num = 3"],
    ),
    "ends too near": (K + "{start = 1, stop = 1.0000000000000002, num = 3}", ["[grid] k", "more than once"]),
    "log zero": (
        "[grid]\nKd = {start = 0, stop = 2, num = 3, spacing = 'log'}",
        ["[grid] Kd: spacing", "above 0", "0.0"],
    ),
    "log negative": (
        "[grid]\nS = {start = 1, stop = -2, num = 3, spacing = 'log'}",
        ["[grid] S: spacing", "-2.0"],
    ),
    "spacing": (
        K + "{start = 1, stop = 2, num = 3, spacing = 'lin'}",
        ["spacing = 'lin'", '"linear" or "log"'],
    ),
    "huge range": (
        K + "{start = 1, stop = 60, num = 30000}\nomega = {start = 1, stop = 4, num = 1000}",
        [
            "30,000,000 cells (30,000 k x 1,000 omega)",
            "166.7 hours",
            "90,000,000 rows",
            "2,000,000",
            "max_cells",
        ],
    ),
    "above own limit": ("max_cells = 2\n" + K + "[1, 2, 3]", ["3 cells (3 k)", "limit is 2", "max_cells"]),
    "max_cells 0": ("max_cells = 0\n" + K + "[1]", ["max_cells = 0", "from 1 to"]),
    "max_cells text": ("max_cells = 'all'\n" + K + "[1]", ["max_cells = 'all'", "whole number"]),
    "search key": (
        K + "[1]\n[search]\nstart = 3",
        ["[search] unknown key start (did you mean starts?)", "seed"],
    ),
    "starts 0": (K + "[1]\n[search]\nstarts = 0", ["[search] starts = 0", "from 1"]),
    "starts fraction": (K + "[1]\n[search]\nstarts = 1.5", ["[search] starts = 1.5", "whole number"]),
    "seed negative": (K + "[1]\n[search]\nseed = -1", ["[search] seed = -1", "from 0"]),
    "stride 0": (K + "[1]\n[search]\nsubgrid = 0", ["[search] subgrid = 0", "at least 1"]),
    "stride of axis 0": (
        K + "[1]\n[search]\nsubgrid = {k = 0}",
        ["[search] subgrid = {'k': 0}", "at least 1"],
    ),
    "stride off grid": (
        K + "[1]\n[search]\nsubgrid = {alpha = 2}",
        ["subgrid names alpha", "the grid has k"],
    ),
    "period 0": (K + "[1]\n[search]\nperiod_min = 0", ["[search] period_min = 0", "above 0"]),
    "period nan": (K + "[1]\n[search]\nperiod_max = nan", ["[search] period_max = nan", "above 0"]),
    "period inf": (K + "[1]\n[search]\nperiod_max = inf", ["[search] period_max = inf", "finite"]),
    "periods equal": (K + "[1]\n[search]\nperiod_min = 3", ["period_min = 3.0", "below period_max = 3.0"]),
    "seed too large": (K + "[1]\n[search]\nseed = 4294967296", ["seed = 4294967296", "to 4,294,967,295"]),
    "periods crossed": (K + "[1]\n[search]\nperiod_min = 4", ["period_min = 4", "below period_max = 3.0"]),
    "not TOML": ("model = wobbling", ["not valid TOML", "line 1", "column"]),
    "duplicate key": (K + "[1]\nk = [2]", ["not valid TOML", "overwrite"]),
    "too deep": (K + "[" * 20000, ["not valid TOML", "too deep"]),
    "too many digits": (K + f"[1{'0' * 5000}]", ["not valid TOML", "too long"]),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_file_is_told_in_one_sentence(case, tmp_path):
    text, names = BAD[case]
    if "wobbling" not in text and "wobling" not in text and case not in ("no model", "model is a number"):
        text = "model = 'wobbling'\n" + text
    path = write(tmp_path, text)
    with pytest.raises(InputError) as caught:
        load_config(path)
    message = str(caught.value)
    assert str(path) in message
    assert "\n" not in message
    assert len(message) < 400 + len(str(path))
    assert "pydantic" not in message
    assert "Input should" not in message
    for name in names:
        assert name in message
    assert caught.value.__cause__ is None
    assert caught.value.__suppress_context__ or caught.value.__context__ is None


def test_unreadable_files(tmp_path):
    with pytest.raises(InputError, match=r"cannot read .*nothing\.toml \(No such file or directory\)"):
        load_config(tmp_path / "nothing.toml")
    with pytest.raises(InputError, match=r"cannot read .* \(Is a directory\)"):
        load_config(tmp_path)
    with pytest.raises(InputError, match=r"cannot read .* \(Not a directory\)"):
        load_config(write(tmp_path, "") / "below")
    binary = tmp_path / "binary.toml"
    binary.write_bytes(b"model = '\xff\xfe'")
    with pytest.raises(InputError, match=r"binary\.toml is not UTF-8 text \(byte 0xff at offset 9\)"):
        load_config(binary)


def test_a_file_without_permission(tmp_path, monkeypatch):
    def refuse(path, _most):
        raise PermissionError(13, "Permission denied", str(path))

    # Root may read everything, so chmod would not do.
    monkeypatch.setattr("stridemap.sweeps.config.contents", refuse)
    with pytest.raises(InputError, match=r"cannot read .* \(Permission denied\)"):
        load_config(PAPER)


def test_a_grid_at_its_limit_is_accepted_and_the_limit_can_be_raised():
    grid = {"k": {"start": 1, "stop": 60, "num": 2000}, "omega": {"start": 1, "stop": 4, "num": 1001}}
    with pytest.raises(InputError, match="2,002,000 cells"):
        config(grid=grid)
    assert config(grid=grid, max_cells=2_002_000).n_cells == 2_002_000
