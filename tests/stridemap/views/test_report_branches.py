"""Branches in slices of the page: what is taken of their tables, what is refused, and what the page shows."""

import itertools

import numpy as np
import pandas as pd
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.solver.model.loading import load
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.run import sweep
from stridemap.views.report.branches import branches, read_branches
from stridemap.views.report.encoding import Encoder
from stridemap.views.report.write import write_report
from tests.oracles.sweeping import Inline
from tests.stridemap.views.conftest import at

MODEL = load("simplest_walker")
SLOPES = np.linspace(0.014, 0.017, 7).tolist()
GRID = {"grid": {"slope": SLOPES}, "params": {}}
DOUBLING = 0.015088437941


@pytest.fixture(scope="module")
def found():
    """The doubling of the simplest walker, with the branch of two steps that begins there."""
    return stridemap.branches("simplest_walker", "slope", (0.014, 0.017), seeds=1, cascade=1)


@pytest.fixture(scope="module")
def folder(tmp_path_factory, found):
    """A sweep over the slope, the files of the branches, and the page with both."""
    folder = tmp_path_factory.mktemp("branches")
    config = {"model": "simplest_walker", "grid": {"slope": SLOPES}, "search": {"starts": 32}}
    sweep(parse_config(config), folder / "out", executor=Inline())
    found.save(folder / "b.parquet")
    write_report(folder / "out", folder / "page.html", branches=[folder / "b.parquet"])
    return folder


def lines_of(given):
    """The table of lines that the page is given."""
    orbits = pd.DataFrame({name: [0.0] for name in ("slope", "period", "cot", "spectral_radius", "theta")})
    tables = []

    class Kept(Encoder):
        def table(self, frame, states=()):
            tables.append(frame)
            return super().table(frame, states)

    encoded = branches(MODEL, GRID, orbits, [given], Kept())
    return encoded[0], tables[0]


def test_special_points_stand_among_the_points_with_their_own_values(found):
    head, lines = lines_of(found)
    assert (head["varies"], head["at"]) == ("slope", {})
    points = found.to_frame()
    assert len(lines) == len(points) + len(found.special)
    one = lines[(lines["type"] == "pd") & (lines["period_n"] == 1)]
    assert one["slope"].tolist() == pytest.approx([DOUBLING], abs=1e-12)
    assert one["spectral_radius"].tolist() == pytest.approx([1.0], abs=1e-9)
    assert one["words"].tolist() == ["supercritical"]
    # Each piece is stable up to the doubling, and unstable from it on.
    single = lines[lines["branch"] == one["branch"].iloc[0]]
    ends = np.sort([single["slope"].iloc[:-1], single["slope"].iloc[1:]], axis=0)
    assert (single["look"].iloc[:-1] == np.where(ends[1] < DOUBLING + 1e-9, 2, 1)).all()
    assert (ends[0] >= DOUBLING - 1e-9)[ends[1] > DOUBLING + 1e-9].all()
    # The branch of two steps begins at the doubling, and is stable there.
    double = lines[lines["period_n"] == 2]
    assert double["slope"].min() == pytest.approx(DOUBLING, abs=1e-6)
    assert double["look"].iloc[0] == 2


def test_measures_at_special_points_are_measured_there(found):
    """Gravity supplies the slope per unit of weight and length, which is no value between others."""
    special = found.special_frame()
    gaits = special[special["gait"]]
    assert np.allclose(gaits["cot"], np.sin(gaits["slope"]), rtol=1e-9)
    assert np.allclose(gaits["spectral_radius"][gaits["type"] == "pd"], 1.0, atol=1e-9)


def test_files_give_the_same_as_the_branches_themselves(found, tmp_path):
    own = lines_of(found)[1]
    for name in ("b.parquet", "b.csv"):
        found.save(tmp_path / name)
        read = lines_of(tmp_path / name)[1]
        assert list(read) == list(own)
        for column in read:
            if column in ("type", "words"):
                assert read[column].fillna("").tolist() == own[column].fillna("").tolist()
            else:
                np.testing.assert_allclose(read[column], own[column], rtol=1e-14)


@pytest.mark.parametrize(
    ("columns", "special", "said"),
    [
        ({"slope": 0.015}, {}, "along the branches 0 parameters change (none)"),
        ({"slope": "a"}, {}, "the column slope of the branches must hold finite numbers"),
        ({"arclength": np.nan}, {}, "the column arclength of the branches must hold finite numbers"),
        ({"spectral_radius": "a"}, {}, "the column spectral_radius of the branches must hold numbers"),
        ({}, {"type": "</script>"}, "have the special point '</script>', not one of fold, pd,"),
        ({}, {"gait": None}, "the column gait of the branches must hold finite numbers"),
    ],
)
def test_what_does_not_belong_is_refused_in_one_sentence(found, monkeypatch, columns, special, said):
    tables = (found.to_frame().assign(**columns), found.special_frame().assign(**special), "the branches")
    monkeypatch.setattr("stridemap.views.report.branches.read_branches", lambda _: tables)
    with pytest.raises(InputError) as refused:
        lines_of(found)
    assert said in str(refused.value)
    assert "\n" not in str(refused.value)


def test_branches_over_what_the_sweep_does_not_vary_or_at_other_values_are_refused(found):
    head = {"grid": {"mass_ratio": [0.1]}, "params": {}}
    with pytest.raises(InputError, match="are over slope, which the sweep does not vary"):
        branches(MODEL, head, pd.DataFrame({"cot": [0.1]}), [found], Encoder())


def test_a_file_that_cannot_be_read_is_named(tmp_path, found):
    with pytest.raises(InputError, match="cannot read branches from .*b.parquet"):
        read_branches(tmp_path / "b.parquet")
    found.save(tmp_path / "b.parquet")
    (tmp_path / "b_special.parquet").unlink()
    with pytest.raises(InputError, match="with the file b_special.parquet beside it"):
        read_branches(tmp_path / "b.parquet")


def test_branches_without_special_points_are_lines(tmp_path, found):
    without = stridemap.branches("simplest_walker", "slope", (0.010, 0.0105), seeds=1, search={"starts": 32})
    assert without.special == ()
    assert list(without.special_frame()) == list(found.special_frame())
    for name in ("b.parquet", "b.csv"):
        without.save(tmp_path / name)
        lines = lines_of(tmp_path / name)[1]
        assert set(lines["look"]) == {0, 1, 2}
        assert lines["type"].isna().all()


def test_branches_in_other_units_are_refused(run, tmp_path):
    line = "branch --model goswami_compass --vary slope --range 0.05 0.06 --seeds 1 --starts 32"
    status, _, _ = run(*line.split(), "--units", "leg_length=0.75,mass=32", "--out", tmp_path / "b.parquet")
    assert status == 0
    with pytest.raises(InputError, match="are in SI units"):
        read_branches(tmp_path / "b.parquet")


@pytest.fixture(scope="module")
def looked(browser, folder):
    page = browser.new_page(viewport={"width": 1400, "height": 900})
    page.faults = []
    page.on("console", lambda message: page.faults.append(message.text))
    page.on("pageerror", lambda error: page.faults.append(str(error)))
    page.goto((folder / "page.html").as_uri())
    page.wait_for_selector("html[data-ready=yes]", state="attached")
    yield page
    page.close()


def test_the_slice_shows_them_with_what_they_mean(looked):
    page = at(looked, "#colour=spectral_radius")
    legend = page.locator("#branch-legend").inner_text()
    assert "branch of stable cycles" in legend
    assert "cycles of several steps" in legend
    assert "period doubling" in legend
    page.locator("#branch-legend summary").click()
    listed = page.locator("#branch-legend li").all_inner_texts()
    assert any("period doubling (PD), supercritical at" in one and "0.0150884379" in one for one in listed)
    page.locator("#branch-legend summary").click()


def test_a_special_point_that_is_pointed_at_says_what_it_is(looked):
    page = at(looked, "#colour=spectral_radius")
    box = page.locator("#slice").bounding_box()
    said = set()
    for x, y in itertools.product(np.arange(0.25, 0.55, 0.018), np.arange(0.05, 0.9, 0.055)):
        page.mouse.move(box["x"] + x * box["width"], box["y"] + y * box["height"])
        said.add(page.locator("#tip").inner_text())
    (doubling,) = {one for one in said if "doubling" in one}
    assert doubling.startswith("period doubling (PD), supercritical at")
    assert "= 0.0150884379, cycles of one step" in doubling
