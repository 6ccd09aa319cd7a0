"""A report of a sweep that is too large for a page, or of a part of one: what is shown, and what it says."""

import html
import re
import shlex

import numpy as np
import pytest

import stridemap
from stridemap.cli.options import box
from stridemap.errors import InputError
from stridemap.paper.points import KEPT
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.run import sweep
from stridemap.views.report.shown import read_shown
from stridemap.views.report.thinning import thinned
from stridemap.views.report.write import write_report
from tests.oracles.made_up_tiles import MadeUp
from tests.oracles.page_tables import Tables, data_of

GRID = {
    "k": {"start": 0.5, "stop": 60.0, "num": 120},
    "alpha": {"start": 0.05, "stop": 0.9, "num": 18},
    "omega": [2.0, 2.5, 3.0],
}
MOST = 2_000


# -- which values --------------------------------------------------------------------------------------------


def axes(*sizes):
    return {name: np.arange(float(n)) for name, n in zip("abcde", sizes, strict=False)}


@pytest.mark.quick
def test_small_grids_are_shown_whole():
    found = thinned(axes(3, 4), np.full(12, 2), {}, most=24)
    assert found.whole and not found.thin
    assert found.cells.tolist() == list(range(12))
    assert thinned(axes(3, 4), np.full(12, 2), {}, most=23).thin


@pytest.mark.quick
@pytest.mark.parametrize("sizes", [(1000,), (100, 100, 100), (120, 36, 4, 3), (2, 2, 2, 2, 2), (7, 1, 300)])
@pytest.mark.parametrize("most", [10, 50, 1000, 20_000])
def test_whole_lines_of_every_nth_value(sizes, most):
    counts = np.random.default_rng(1).integers(0, 6, int(np.prod(sizes)))
    found = thinned(axes(*sizes), counts, {}, most)
    shown = counts.reshape(sizes)[np.ix_(*found.places.values())]
    assert shown.sum() <= most
    assert (
        found.cells.tolist()
        == np.arange(counts.size).reshape(sizes)[np.ix_(*found.places.values())].ravel().tolist()
    )
    for name, places in found.places.items():
        assert (np.diff(places) == found.strides[name]).all()
    if most >= 1000 and counts.sum() > most:
        assert shown.sum() > most / 5  # no more is left out than has to be


def test_strides_are_alike_and_few_values_stay():
    found = thinned(axes(100, 100, 100), np.full(10**6, 3), {}, 100_000)
    assert max(found.strides.values()) <= 4
    assert 80_000 < 3 * len(found.cells) <= 100_000
    found = thinned(axes(400, 400, 2), np.full(320_000, 3), {}, 100_000)
    assert found.strides["c"] == 1


def test_of_cells_with_more_cycles_than_a_page_bears_one_is_shown():
    counts = np.array([0, 7, 9, 8])
    found = thinned({"k": np.arange(4.0)}, counts, {}, 5)
    assert (found.cells.tolist(), found.thin) == ([2], True)


@pytest.mark.parametrize(("start", "step"), [(0.5, 0.5), (0.25, 0.25)])
def test_values_that_are_spoken_of_are_kept(start, step):
    k = start + step * np.arange(round(60 / step))
    grid = {"k": k, "alpha": np.arange(2, 38) / 40, "omega": np.array([2.0, 2.5, 3.0, 3.5])}
    counts = np.full(k.size * 36 * 4, 3)
    for most in (20_000, 5_000):
        found = thinned(grid, counts, {}, most, KEPT)
        assert counts[found.cells].sum() <= most
        assert {0.5, 6.0, 22.5} <= set(found.grid["k"])
        assert {0.25, 0.5} <= set(found.grid["alpha"])
        assert {2.0, 3.0} <= set(found.grid["omega"])


def test_a_part_is_whole_lines_within_two_values():
    k = np.array([0.5, 0.1 + 0.2 + 0.4, 1.0, 2.0])
    grid = {"k": k, "alpha": np.arange(3.0)}
    found = thinned(grid, np.full(12, 1), {"k": (0.7, 1.0)}, 100)
    assert found.cells.tolist() == [3, 4, 5, 6, 7, 8]
    assert found.ends == {"k": (0.7000000000000001, 1.0)}
    with pytest.raises(InputError, match=r"no value of k on the grid is between 1\.1 and 1\.2; .* is 1"):
        thinned(grid, np.full(12, 1), {"k": (1.1, 1.2)}, 100)
    with pytest.raises(InputError, match="a part of beta cannot be shown: the axes of the grid are k, alpha"):
        thinned(grid, np.full(12, 1), {"beta": (1.1, 1.2)}, 100)


# -- the page ------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def swept(compared, tmp_path_factory):
    """A sweep of some 15,000 made-up cycles, all of which can be drawn."""
    orbits = stridemap.read_orbits(compared / "out")
    cycle = orbits[orbits.stable & (orbits.k == 6.0) & (orbits.omega == 3.0)].iloc[0].to_dict()
    folder = tmp_path_factory.mktemp("thinned") / "a sweep"
    config = parse_config({"model": "wobbling", "grid": GRID, "special_points": False})
    sweep(config, folder, executor=MadeUp(like=cycle), tile_cells=600)
    return folder


@pytest.fixture(scope="module")
def thin(swept):
    page = swept.parent / "thin.html"
    return page, write_report(swept, page, most_cycles=MOST, kept=KEPT)


def sentence(page):
    (found,) = re.findall("<p id=part-shown class=warning>(.*?)</p>", page.read_text("utf-8"))
    return html.unescape(re.sub("<.*?>", "", found))


def test_the_page_has_the_rows_of_the_table(swept, thin):
    page, summary = thin
    orbits, cells = stridemap.read_orbits(swept), stridemap.read_cells(swept)
    assert (summary.all_orbits, summary.all_cells) == (len(orbits), len(cells)) == (len(orbits), 6480)
    data = data_of(page.read_text("utf-8"))
    grid = {axis["name"]: axis["values"] for axis in data["axes"]}
    assert {0.5, 6.0, 22.5} <= set(grid["k"]) < set(orbits.k)
    kept = orbits
    for name, values in grid.items():
        assert len(set(np.diff(np.searchsorted(np.unique(orbits[name]), values)))) == 1
        kept = kept[kept[name].isin(values)]
    assert data["orbits"]["rows"] == len(kept) == summary.orbits <= MOST
    assert data["cells"]["rows"] == summary.cells == np.prod([len(values) for values in grid.values()])
    packed = Tables(data["bytes"])
    number = np.array(packed.column(data["orbits"], "cell"))
    indices = np.unravel_index(number, [len(values) for values in grid.values()])
    for (name, values), at in zip(grid.items(), indices, strict=True):
        assert np.array(values)[at].tolist() == kept[name].tolist()
    cot = np.array(packed.column(data["orbits"], "cot"))
    np.testing.assert_allclose(cot, kept["cot"], atol=1e-10)


def test_the_page_says_what_it_shows_and_how_to_see_the_rest(swept, thin, tmp_path):
    page, summary = thin
    said = sentence(page)
    orbits = len(stridemap.read_orbits(swept))
    assert said.startswith("This page shows a thinned-out view of the sweep, every ")
    assert f"{summary.orbits:,} of {orbits:,} limit cycles in {summary.cells:,} of 6,480 cells; " in said
    words = shlex.split(re.search("(stridemap report .*?) shows a part in full", said)[1])
    assert words[:3] == ["stridemap", "report", "SWEEP_DIR"]
    assert str(swept) not in page.read_text("utf-8")
    # What it names is shown in full.
    part = box([words[i + 1] for i, word in enumerate(words) if word == "--part"])
    shown = read_shown(swept, part=part, most=MOST)
    assert not shown.thinned.thin
    rows = stridemap.read_orbits(swept)
    for name, (low, high) in part.items():
        rows = rows[(rows[name] >= low) & (rows[name] <= high)]
    assert len(rows) == len(shown.orbits) > MOST / 2


def test_a_part_says_that_it_is_one(swept, tmp_path):
    summary = write_report(swept, tmp_path / "p.html", part={"omega": (3, 3), "k": (0.5, 10)})
    assert summary.cells == 20 * 18
    said = sentence(tmp_path / "p.html")
    assert "shows a part of the sweep, k from 0.5 to 10, ω from 3 to 3: " in said
    assert said.endswith("--out whole.html shows what else there is.")
    write_report(swept, tmp_path / "w.html")
    page = (tmp_path / "w.html").read_text("utf-8")
    assert "part-shown" not in page
    assert "<p>All limit cycles found in a sweep over" in page


def test_the_page_in_a_browser(thin, browser, swept):
    page = browser.new_page(viewport={"width": 1400, "height": 900}, reduced_motion="reduce")
    faults = []
    page.on("pageerror", lambda error: faults.append(str(error)))
    page.goto(thin[0].as_uri() + "#k=6&alpha=0.25&omega=3")
    page.wait_for_selector("html[data-ready=yes]", state="attached", timeout=60_000)
    assert page.locator("#part-shown").is_visible()
    assert "thinned-out view" in page.inner_text("#part-shown")
    # The cell that the address names is that cell of the table.
    orbits = stridemap.read_orbits(swept)
    here = orbits[(orbits.k == 6) & np.isclose(orbits.alpha, 0.25) & (orbits.omega == 3)]
    shown = page.evaluate(
        "Array.from(stridemap.orbits.numbers('cot').slice(stridemap.state.row, stridemap.state.row + 1))"
    )
    assert np.abs(here["cot"] - shown[0]).min() < 1e-9
    assert faults == []


# -- the command ---------------------------------------------------------------------------------------------


def test_the_command_shows_a_part(run, refused, swept, tmp_path):
    out = tmp_path / "p.html"
    words = ["report", swept, "--out", out, "--part", "k=0.5:30", "--most-cycles", "500"]
    status, printed, err = run(*words)
    assert (status, err) == (0, "")
    found = re.fullmatch(
        r"report of ([\d,]+) of ([\d,]+) limit cycles in ([\d,]+) of 6,480 cells: (.*) \(.* MB\)\n", printed
    )
    assert found[4] == str(out)
    assert int(found[1].replace(",", "")) <= 500
    assert int(found[2].replace(",", "")) == len(stridemap.read_orbits(swept))
    refused(["report", swept, "--out", out, "--part", "k=3"], "--part 'k=3'", "NAME=LOW:HIGH")
    refused(["report", swept, "--out", out, "--part", "k=100:200"], "no value of k on the grid", "60")
    refused(["report", swept, "--out", out, "--most-cycles", "0"], "most_cycles = 0 is not allowed")
    refused(["report", "--out", out, "--part", "k=1:2"], "--part is for the sweep in SWEEP_DIR")
