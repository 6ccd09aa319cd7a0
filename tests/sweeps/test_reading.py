"""A finished sweep is read whatever its configuration was."""

from dataclasses import fields

import pytest

import stridemap
from stridemap.solver.options import IN_SWEEPS, AcceptanceOptions
from stridemap.sweeps.config import Search
from tests.oracles.sweeping import Inline

SEARCH = {
    "starts": 12, "seed": 7, "subgrid": {"omega": 2}, "period_min": 0.4, "period_max": 2.5,
    "search_box": {"theta1": [0.02, 0.3]}, "widen": 1.5,
}  # fmt: skip
ACCEPTANCE = {one.name: 0.9 * getattr(AcceptanceOptions(), one.name) for one in fields(AcceptanceOptions)}
CONTINUATION = {
    one.name: type(value := getattr(IN_SWEEPS, one.name))(0.99 * value) for one in fields(IN_SWEEPS)
} | {"step_growth": 1.9}


def test_every_option_may_be_other_than_by_default(tmp_path, run):
    assert SEARCH.keys() == Search.model_fields.keys()
    data = {
        "model": "compass", "grid": {"omega": [2.9, 3.0, 3.1]}, "params": {"beta": 0.02},
        "search": SEARCH, "acceptance": ACCEPTANCE, "continuation": CONTINUATION, "special_points": False,
    }  # fmt: skip
    stridemap.sweep(data, tmp_path / "out", executor=Inline())
    assert len(stridemap.read_table(tmp_path / "out")) > 0
    configuration = stridemap.read_provenance(tmp_path / "out")["configuration"]
    assert configuration["search"] == SEARCH
    assert configuration["acceptance"] == pytest.approx(ACCEPTANCE)
    assert configuration["continuation"] == pytest.approx(CONTINUATION)
    status, _, err = run("report", tmp_path / "out", "--out", tmp_path / "page.html")
    assert (status, err) == (0, "")
    assert "search_box = {&quot;theta1&quot;: [0.02, 0.3]}" in (tmp_path / "page.html").read_text()
