"""Whole tables in SI units, by products written by hand; sweeps whose files are in SI units."""

import math

import numpy as np
import pandas as pd
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.run import sweep
from stridemap.tables.table import table_of
from tests.oracles.sweeping import Inline

M, L, G = 32.0, 0.75, 9.80665
ROBOT = stridemap.Units(L, M)
SECOND = math.sqrt(L / G)
FACTORS = {
    "k": M * G / L, "alpha": 1, "omega": 1 / SECOND, "beta": M, "Kp": M * G * L, "Kd": M * G * L * SECOND,
    "S": 1, "theta1": 1, "dtheta1": 1 / SECOND, "x": L, "dx": L / SECOND, "period": SECOND,
    "speed": L / SECOND, "work": M * G * L, "peak_power": M * G * L / SECOND, "min_vertical_force": M * G,
    "cot": 1, "cot_per_speed": SECOND, "multiplier_0_re": 1,
}  # fmt: skip


def check(converted, original):
    for name, factor in FACTORS.items():
        np.testing.assert_allclose(converted[name], original[name] * factor, rtol=1e-14, err_msg=name)


@pytest.mark.quick
def test_tables_of_any_kind(orbits):
    frame = orbits.to_frame()
    for given in (orbits, frame, table_of(orbits)):
        converted = ROBOT.table_si(given)
        check(converted if isinstance(converted, pd.DataFrame) else converted.frame, frame)
    plain = frame.copy()
    plain.attrs = {}
    check(ROBOT.table_si(plain, "wobbling"), frame)
    assert frame["k"].tolist() == [6.0, 6.0]  # what was given stays


def test_datasets(orbits):
    pytest.importorskip("xarray")
    data = orbits.to_xarray()
    converted = ROBOT.table_si(data)
    check(converted, data)
    assert converted.k.attrs["units"] == "N/m"
    assert data.k.attrs["units"] == "M g / L"
    with pytest.raises(InputError, match="in SI units already: k is in N/m"):
        ROBOT.table_si(converted)


def test_columns_stay_columns(table):
    xr = pytest.importorskip("xarray")
    column = table.frame["period"]
    seconds = ROBOT.to_si(column, "time")
    assert isinstance(seconds, pd.Series)
    np.testing.assert_allclose(seconds, column * SECOND, rtol=1e-15)
    gaps = pd.Series([1.0, np.nan])
    assert ROBOT.to_si(gaps, "time").isna().tolist() == [False, True]
    assert isinstance(ROBOT.from_si(xr.DataArray([SECOND]), "time"), xr.DataArray)
    with pytest.raises(InputError, match="the values of group are not all finite numbers"):
        ROBOT.to_si(table.frame["group"], "time")


def test_refusals(orbits):
    with pytest.raises(InputError, match="in SI units already"):
        ROBOT.table_si(ROBOT.table_si(orbits))
    with pytest.raises(InputError, match="is not a table"):
        ROBOT.table_si([1.0, 2.0])
    with pytest.raises(InputError, match="does not say what its columns hold; name its model"):
        ROBOT.table_si(pd.DataFrame({"k": [1.0]}))


@pytest.mark.quick
@pytest.mark.parametrize(
    ("units", "sentence"),
    [
        ({"leg_length": 0.75}, r"my.toml: \[units\]: mass is missing; give leg_length in m and mass in kg"),
        ({"leg_lenght": 1, "mass": 1}, r"leg_lenght is unknown \(did you mean leg_length\?\)"),
        ({"leg_length": 750, "mass": 32}, "leg_length = 750 m is outside the allowed range"),
        ({"leg_length": "0.75", "mass": 32}, "leg_length = '0.75' is not a number"),
    ],
)
def test_sizes_that_are_refused(units, sentence):
    with pytest.raises(InputError, match=sentence):
        parse_config({"model": "compass", "units": units, "grid": {"Kp": [1000]}}, "my.toml")


@pytest.mark.quick
def test_a_file_in_si_units_means_the_same_as_one_in_the_models_units():
    si = {
        "model": "wobbling",
        "units": {"leg_length": L, "mass": M},
        "params": {"Kp": 10 * M * G * L, "alpha": 0.25},
        "grid": {"k": {"start": 1000, "stop": 3000, "num": 5}, "beta": [4.8]},
        "search": {"period_max": 0.5, "search_box": {"x": [-0.1, 0.1]}},
    }
    config = parse_config(si)
    assert config.params["Kp"] == pytest.approx(10, rel=1e-15)
    assert config.params["Kd"] == 0.6  # the preset, to the bit
    np.testing.assert_allclose(config.grid["k"], np.linspace(1000, 3000, 5) / (M * G / L), rtol=1e-15)
    assert config.grid["beta"] == pytest.approx([0.15], rel=1e-15)
    assert config.search.period_max == pytest.approx(0.5 / SECOND)
    assert config.search.search_box["x"] == pytest.approx([-0.1 / L, 0.1 / L])
    plain = parse_config({"model": "wobbling", "grid": {"k": [1.0]}})
    assert "units" not in plain.canonical()  # what was swept before keeps its hash
    with pytest.raises(InputError, match=r"\[params\] Kp = -5 is outside the allowed range \(>= 0\)"):
        parse_config({**si, "params": {"Kp": -5}})


def test_a_sweep_in_si_units_is_read_back_as_it_was_given(tmp_path):
    given = [1234.5, 2000.0, 2350.1]
    config = {
        "model": "compass",
        "units": {"leg_length": L, "mass": M},
        "grid": {"Kp": given},
        "search": {"starts": 8},
    }
    sweep(parse_config(config), tmp_path / "out", executor=Inline())
    stored = stridemap.read_orbits(tmp_path / "out")
    table = stridemap.read_table(tmp_path / "out")
    assert sorted(set(table.frame["Kp"])) == given
    assert table.grid["Kp"] == tuple(given)
    assert table.cells["Kp"].tolist() == given
    assert table.columns["Kp"].unit == "N m"
    np.testing.assert_allclose(table.frame["speed"], stored["speed"] * L / SECOND, rtol=1e-14)
    # Some of it is that part: conditions are on the numbers of the file, and columns need not have units.
    part = stridemap.read_table(tmp_path / "out", columns=["group", "Kp"], where="Kp == 2000")
    assert set(part.frame["Kp"]) == {2000.0}
    assert list(part.frame["group"]) == list(table.where("Kp == 2000").frame["group"])
    assert stridemap.read_table(tmp_path / "out", columns=["group"]).grid == table.grid
    assert [set(batch.frame["Kp"]) for batch in stridemap.read_batches(tmp_path / "out")] == [set(given)]
    own = stridemap.read_table(tmp_path / "out", units="model")
    pd.testing.assert_frame_equal(own.frame, stored)
    larger = stridemap.read_table(tmp_path / "out", units=stridemap.Units(1.0, 50.0))
    np.testing.assert_allclose(larger.frame["Kp"], stored["Kp"] * 50 * G, rtol=1e-14)
    with pytest.raises(InputError, match="units = 3 is not allowed; give stridemap.Units or 'model'"):
        stridemap.read_table(tmp_path / "out", units=3)
