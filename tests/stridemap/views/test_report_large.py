"""A page of a hundred thousand cycles: its size, and what a press on its map shows and draws."""

import pytest

import stridemap
from stridemap.views.report import write
from tests.oracles.large_sweep import large_sweep

LARGEST_PAGE = 20e6
"""Bytes. How long a press takes is measured by ``python -m benchmarks.press``."""

PLACE = """i => { const { left, top } = document.getElementById("map").getBoundingClientRect();
    const { x, y, width, height } = stridemap.map.box(20 + 13 * i, 5 + 4 * i);
    return [left + x + width / 2, top + y + height / 2]; }"""

FRAME = "new Promise(done => requestAnimationFrame(() => setTimeout(done)))"


@pytest.fixture(scope="module")
def large(compared, tmp_path_factory):
    orbits = stridemap.read_orbits(compared / "out")
    made = large_sweep(orbits[orbits.stable & (orbits.k == 6.0) & (orbits.omega == 3.0)].iloc[0])
    path = tmp_path_factory.mktemp("large") / "page.html"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(write, "read_shown", lambda *_: made)
        summary = write.write_report("made up", path)
    assert summary.orbits == 100_000
    return path, made.orbits


def test_a_press_on_a_large_page_shows_that_cycle_and_draws_the_map_no_second_time(large, browser):
    path, orbits = large
    assert path.stat().st_size < LARGEST_PAGE
    page = browser.new_page(viewport={"width": 1400, "height": 900}, reduced_motion="reduce")
    faults = []
    page.on("pageerror", lambda error: faults.append(str(error)))
    page.goto(path.as_uri())
    page.wait_for_selector("html[data-ready=yes]", state="attached", timeout=60_000)
    page.evaluate("window.drawn = stridemap.map.looks")
    for i in range(9):
        page.mouse.click(*page.evaluate(PLACE, i))
        page.evaluate(FRAME)
        row = orbits.iloc[page.evaluate("stridemap.state.row")]
        assert page.evaluate("stridemap.state.cell") == row.cell
        shown = page.inner_text('#measures [data-name="cot"] .number')
        assert shown == f"{row.cot:.10f}"
    assert page.evaluate("stridemap.map.looks === window.drawn")
    page.select_option("#colour", "cot")  # unstable cycles cost ten times as much
    assert page.evaluate("stridemap.bar.scale.high") <= orbits.cot[orbits.stable].max()
    assert page.evaluate("stridemap.slice.scale.high") < 1.1 * orbits.cot[orbits.stable].max()
    assert "have the colour of the end" in page.inner_text("#legend")
    page.select_option("#choice", "stable")
    assert not page.evaluate("stridemap.map.looks === window.drawn")  # as after another choice
    assert faults == []
