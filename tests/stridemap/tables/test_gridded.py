"""Arrays over a sweep's grid hold its table, in xarray and in netCDF; attributes; what is refused."""

import numpy as np
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.tables import gridded as module

xr = pytest.importorskip("xarray")


@pytest.fixture(scope="module")
def data(table):
    return table.to_xarray()


def test_every_row_is_where_its_parameters_say(table, data):
    assert dict(data.sizes) == {"k": 3, "alpha": 2, "cycle": table.frame.groupby("cell").size().max()}
    assert int(data.cot.notnull().sum()) == len(table)
    for (k, alpha), cell in table.frame.groupby(["k", "alpha"]):
        here, ordered = data.sel(k=k, alpha=alpha), cell.sort_values("period")
        n = len(cell)
        for name in ("period", "cot", "theta1", "multiplier_0_re"):
            np.testing.assert_array_equal(here[name][:n], ordered[name])
            assert np.isnan(here[name][n:]).all()
        assert here.group.values.tolist() == ordered.group.tolist() + [""] * (data.sizes["cycle"] - n)
        np.testing.assert_array_equal(here.stable[:n], ordered.stable.astype(float))
    cells = table.cells.set_index(["k", "alpha"])
    for key, row in cells.iterrows():
        here = data.sel(k=key[0], alpha=key[1])
        assert (int(here.orbits), str(here.cell_status.values)) == (row.orbits, row.status)


def test_attributes(data):
    assert data.k.attrs["units"] == "M g / L"
    assert data.k.attrs["long_name"] == "stiffness of the wobbling mass's spring"
    assert (data.cot.attrs["units"], data.speed.attrs["units"]) == ("1", "sqrt(g L)")
    assert data.dx.attrs["si_units"] == "m/s"
    assert data.attrs["model"] == "wobbling"


def test_by_branch_holds_the_same_cycles(table, data):
    by = table.to_xarray(by="branch")
    assert by.cot.dims == ("k", "alpha", "branch", "passage")
    one, other = by.cot.values, data.cot.values
    np.testing.assert_array_equal(np.sort(one[~np.isnan(one)]), np.sort(other[~np.isnan(other)]))
    row = table.frame.iloc[-1]
    here = by.cot.sel(k=row.k, alpha=row.alpha, branch=row.branch)
    assert row.cot in here.values


def test_netcdf_is_the_same_dataset(table, data, tmp_path):
    table.export(tmp_path / "t.nc")
    with xr.open_dataset(tmp_path / "t.nc") as read:
        xr.testing.assert_equal(read.load(), data)
        assert read.k.attrs["long_name"] == data.k.attrs["long_name"]
        assert read.dx.attrs["units"] == "L sqrt(g/L)"
    again = (tmp_path / "t.nc").read_bytes()
    table.export(tmp_path / "t.nc")
    assert (tmp_path / "t.nc").read_bytes() == again


def test_limit_cycles_of_one_point(orbits):
    data = orbits.to_xarray()
    assert data.cot.dims == ("cycle",)
    np.testing.assert_array_equal(data.cot, orbits.cot)
    assert data.stable.values.tolist() == [False, True]


def test_cells_alone(swept):
    data = stridemap.read_table(swept / "cells.parquet").to_xarray()
    assert data.orbits.dims == ("k", "alpha")


def test_refusals(table, orbits, monkeypatch):
    with pytest.raises(InputError, match="by = 'gait' is not allowed; it is cycle or branch"):
        table.to_xarray(by="gait")
    monkeypatch.setattr(module, "LARGEST", 10)
    with pytest.raises(InputError, match="the arrays would have .* entries each .*3 k x 2 alpha x"):
        table.to_xarray()
    monkeypatch.setattr(module, "find_spec", lambda name: None)
    with pytest.raises(InputError, match="needs xarray, which is not installed here: run `pip"):
        orbits.to_xarray()
