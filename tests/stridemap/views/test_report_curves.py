"""Boundaries on the page: what is taken of a table, and what is refused."""

import base64
import json
import re

import numpy as np
import pandas as pd
import pytest

from stridemap.errors import InputError
from stridemap.solver.model.loading import load
from stridemap.views import palette
from stridemap.views.markers import BOUNDARY_LINES, BOUNDARY_NAMES, MARKERS
from stridemap.views.report.curves import curves, looks, read_curves
from stridemap.views.report.write import write_report

MODEL = load("wobbling")
GRID = {"grid": {"k": [1.0, 2.0], "alpha": [0.2, 0.3], "omega": [2.0, 3.0]}, "params": {"beta": 2.0}}


def table(**columns):
    """Five points of one boundary."""
    preset = {**MODEL.preset, "beta": 2.0}
    known = {
        "boundary": 4, "type": "fold", "gait": [False, True, True, True, True],
        "borders_stable": [True, True, True, False, False], "k": np.linspace(1, 2, 5),
        "alpha": np.linspace(0.2, 0.3, 5), "omega": 3.0,
    }  # fmt: skip
    return pd.DataFrame(preset | known | columns, index=range(5))


def points(one):
    return np.frombuffer(base64.b64decode(one["points"]), "<f8").reshape(-1, 2)


def test_parts_that_are_no_gaits_are_left_out_and_stable_ones_are_marked():
    thick, thin = curves(MODEL, GRID, table())
    wanted = table()[["k", "alpha"]].to_numpy()
    assert np.array_equal(points(thick), wanted[1:3])
    assert np.array_equal(points(thin), wanted[2:])
    assert (thick["stable"], thin["stable"]) == (True, False)
    assert thick["names"] == ["k", "alpha"]
    assert thick["at"] == {"omega": 3.0}
    assert looks([thick, thin]) == {"fold": {"name": "fold", "colour": palette.DARK, "dashes": []}}


def test_every_type_has_a_name_and_a_line_of_its_own():
    assert set(BOUNDARY_NAMES) == set(BOUNDARY_LINES) == {*MARKERS, "period_limit"} - {"bp"}
    assert len({*BOUNDARY_LINES.values()}) == len(BOUNDARY_LINES)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (table().drop(columns="gait"), "lack the column gait"),
        (
            table(alpha=[0.2, np.nan, 0.3, 0.3, 0.3]),
            "the column alpha of the boundaries must hold finite numbers",
        ),
        (table(k=["a"] * 5), "the column k of the boundaries must hold finite numbers"),
        (table(type="</script>"), "have the type '</script>', not one of fold, pd,"),
        (table(omega=np.linspace(2, 3, 5)), "3 parameters change (k, alpha, omega)"),
        (table(alpha=0.2), "1 parameters change (k)"),
        (table(beta=np.linspace(2, 3, 5), alpha=0.2), "the sweep does not vary beta"),
        (table(beta=3.0), "are at beta = 3, the sweep is at 2"),
        (table(Kp=MODEL.preset["Kp"] + 1), "are at Kp ="),
    ],
)
def test_what_does_not_belong_is_refused_in_one_sentence(given, said):
    with pytest.raises(InputError) as refused:
        curves(MODEL, GRID, given)
    assert said in str(refused.value)
    assert "\n" not in str(refused.value)


def test_too_many_points_are_refused(monkeypatch):
    monkeypatch.setattr("stridemap.views.report.curves.MOST_POINTS", 4)
    with pytest.raises(InputError, match="5 points, more than the 4"):
        curves(MODEL, GRID, table())


@pytest.mark.parametrize("name", ["curves.parquet", "curves.csv"])
def test_a_file_is_read_and_one_that_is_none_is_refused(tmp_path, name):
    path = tmp_path / name
    with pytest.raises(InputError, match="cannot read boundaries from"):
        read_curves(path)
    path.write_bytes(b"\x00PAR1" * 9)
    with pytest.raises(InputError):
        curves(MODEL, GRID, read_curves(path))
    (table().to_csv if name.endswith("csv") else table().to_parquet)(path, index=False)
    assert curves(MODEL, GRID, read_curves(path)) == curves(MODEL, GRID, table())


def test_a_page_without_boundaries_has_none(done):
    write_report(done / "out", done / "page.html")
    page = (done / "page.html").read_text(encoding="utf-8")
    data = json.loads(
        re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)[1]
    )
    assert data["curves"] == []
    assert data["looks"] == {}


def test_the_command_takes_boundaries_of_a_sweep_only(run, tmp_path):
    code, _, error = run("report", "--curves", tmp_path / "none.parquet", "--out", tmp_path / "page.html")
    assert code == 2
    assert "--curves is for the sweep in SWEEP_DIR" in error
