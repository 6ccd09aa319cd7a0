"""Scales of the report: they span what is shown, are moved by hand, and diverge about references."""

import re

import numpy as np
import pytest

import stridemap
from tests.stridemap.views.conftest import at


def numbers(texts):
    return [float(text.replace("\u2212", "-")) for text in texts]


def ends(page):
    """The values of the two handles."""
    return [float(handle.get_attribute("aria-valuenow")) for handle in page.locator("#scale .handle").all()]


@pytest.fixture
def orbits(compared):
    return stridemap.read_orbits(compared / "out")


def standing(orbits, omega, stable=None):
    """The most stable cycle of each cell at one frequency."""
    here = orbits[orbits.omega == omega]
    here = here if stable is None else here[here.stable == stable]
    return here.sort_values("spectral_radius").drop_duplicates("cell")


def test_the_colours_span_the_cells_that_are_shown(page, orbits):
    for omega in (3.0, 2.5):
        at(page, f"#omega={omega}&colour=cot&cycles=stable")
        wanted = standing(orbits, omega, True).cot
        assert ends(page) == pytest.approx([wanted.min(), wanted.max()], abs=1e-9)
        first = page.locator("#scale .ticks span").all_inner_texts()
        assert len(first) >= 3
        assert min(numbers(first)) >= wanted.min() - 0.5 * np.ptp(wanted)
    assert page.faults == []


def test_of_many_values_two_per_cent_lie_beyond_either_end(page):
    low, high, own = page.evaluate(
        """(() => { const { scaleOf } = stridemap;
        const values = Array.from({ length: 1001 }, (_, i) => i ** 3);
        const scale = scaleOf(values, {}); return [scale.low, scale.high, [scale.below, scale.above]]; })()"""
    )
    assert (low, high, own) == (20**3, 980**3, [True, True])


def test_the_handles_move_by_mouse_and_keyboard_and_go_back(page):
    at(page, "#omega=3&colour=cot&cycles=stable")
    before, picture = ends(page), page.evaluate("document.getElementById('map').toDataURL()")
    upper = page.locator("#scale .handle[data-end=upper]")
    upper.focus()
    for key in ("PageDown", "PageDown", *["ArrowLeft"] * 10):
        page.keyboard.press(key)
    moved = ends(page)
    assert moved[0] == before[0]
    assert moved[1] == pytest.approx(before[1] - 0.3 * (before[1] - before[0]), rel=1e-6)
    assert page.evaluate("document.getElementById('map').toDataURL()") != picture
    assert "values above have the colour of the end" in page.inner_text("#legend")
    assert "range=" in page.evaluate("location.hash")
    lower, bar = page.locator("#scale .handle[data-end=lower]"), page.locator("#scale .bar").bounding_box()
    box = lower.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(bar["x"] + 0.4 * bar["width"], box["y"] + 5, steps=3)
    page.mouse.up()
    dragged = ends(page)
    assert dragged[0] == pytest.approx(before[0] + 0.4 * (before[1] - before[0]), rel=0.02)
    for _ in range(12):  # it does not pass the other one
        page.keyboard.press("PageUp")
    assert ends(page)[0] < ends(page)[1]
    page.click("#range-reset")
    assert ends(page) == before
    assert page.is_hidden("#range-reset")
    assert page.faults == []


def test_multipliers_diverge_about_one(page):
    at(page, "#omega=3&colour=spectral_radius")
    colours = page.evaluate(
        """(() => { const s = stridemap.bar.scale;
        return [s.centre, ...[0.999999, 1.000001, s.low, 1.9].map(v => s.colour(v))]; })()"""
    )
    assert colours[0] == 1
    middle, blue, brown = colours[1], channels(colours[3]), channels(colours[4])
    assert max(abs(a - b) for a, b in zip(channels(middle), channels(colours[2]), strict=True)) < 12
    assert min(channels(middle)) > 200
    assert blue[2] > blue[0]
    assert brown[0] > brown[2]
    page.select_option("#about", "plain")
    assert page.evaluate("stridemap.bar.scale.centre") is None


def channels(colour):
    return [int(part) for part in colour.removeprefix("rgb(").removesuffix(")").split()]


def test_the_compass_is_what_costs_are_compared_with(page, orbits):
    for omega, value in ((3.0, 0.308), (2.5, 0.25)):
        at(page, f"#omega={omega}&colour=cot&cycles=stable&about=compass")
        assert page.evaluate("stridemap.bar.scale.centre") == value
        assert f"compass's value: {value:g}" in page.inner_text("#legend")
        below = standing(orbits, omega, True)
        fills = page.evaluate(
            """stridemap.map.looks.flatMap((line, r) =>
            line.map((look, c) => [stridemap.map.cellAt(c, r), look.fill ?? null]))"""
        )
        for cell, fill in fills:
            row = below[below.cell == cell]
            assert (fill is None) == row.empty
            if fill:
                red, _, blue = channels(fill)
                assert abs(row.cot.iloc[0] - value) < 0.002 or (blue > red) == (row.cot.iloc[0] < value)
    page.select_option("#colour", "friction")  # nothing is known of the compass's
    assert page.is_hidden("#about")


def test_cells_are_compared_with_the_compass_at_their_own_frequency(page, orbits):
    at(page, "#k=6&alpha=0.25&omega=3&colour=cot&cycles=stable")
    page.select_option("#up", label="ω (omega)")
    assert page.is_visible("#about")
    page.select_option("#about", "compass")
    assert page.evaluate("stridemap.bar.scale.centre") == 0
    assert "compass's value in each cell" in page.inner_text("#legend")
    assert "cost of transport, less the compass's" in page.inner_text("#scale .name")
    fills = page.evaluate(
        """stridemap.map.looks.flatMap((line, r) =>
        line.map((look, c) => [stridemap.map.cellAt(c, r), look.fill ?? null]))"""
    )
    compass, sides = {3.0: 0.308, 2.5: 0.25}, set()
    for cell, fill in fills:
        rows = orbits[(orbits.cell == cell) & orbits.stable]
        assert (fill is None) == rows.empty
        if fill:
            row = rows.loc[rows.spectral_radius.idxmin()]
            more = row.cot - compass[row.omega]
            red, _, blue = channels(fill)
            assert abs(more) < 0.002 or (blue > red) == (more < 0)
            sides.add((row.omega, more < 0))
    assert len(sides) > 2
    # Both ends are ends of differences; on other axes they are those of costs again.
    low, high = page.evaluate("[stridemap.bar.scale.low, stridemap.bar.scale.high]")
    assert low < 0.1 and high < 0.5
    page.select_option("#up", label="α (alpha)")
    assert page.evaluate("stridemap.bar.scale.centre") in compass.values()
    at(page, "#colour=friction")
    assert page.is_hidden("#about")


def test_one_cell_is_one_cell(page):
    at(page, "#omega=3&colour=stability&filter=k=0.5+and+alpha=0.25")
    assert re.search(r": 1 cell\n|: 1 cell ", page.inner_text("#legend") + "\n")
    assert ": 1 cells" not in page.inner_text("#legend")


def test_the_compass_is_a_line_of_the_slice(page):
    at(page, "#omega=3&colour=cot&cycles=stable")
    assert page.evaluate("stridemap.slice.compared") == [[i, 0.308] for i in range(5)]
    plain = page.evaluate("document.getElementById('slice').toDataURL()")
    svg = page.evaluate("stridemap.redrawn(stridemap.slice).text")
    assert ">compass 0.308</text>" in svg
    page.evaluate("stridemap.slice.compared = [], stridemap.slice.draw()")
    assert page.evaluate("document.getElementById('slice').toDataURL()") != plain
    at(page, "#omega=3&colour=friction&cycles=stable")
    assert page.evaluate("stridemap.slice.compared") == []


def test_the_slice_spans_what_it_shows_and_names_its_axis(page, orbits):
    at(page, "#k=6&alpha=0.25&omega=3&colour=spectral_radius&cycles=stable")
    here = orbits[(orbits.omega == 3.0) & (orbits.alpha == 0.25) & orbits.stable].spectral_radius
    low, high = page.evaluate("[stridemap.slice.scale.low, stridemap.slice.scale.high]")
    assert low <= here.min() < here.max() <= high
    assert high - low < 1.2 * np.ptp(here)
    assert ">k [M g / L]</text>" in page.evaluate("stridemap.redrawn(stridemap.slice).text")


def test_whole_numbers_have_whole_ticks(page):
    at(page, "#omega=3&colour=peaks")
    for ticks in (
        page.locator("#scale .ticks span").all_inner_texts(),
        page.evaluate("stridemap.slice.scale.ticks(5).map(([, text]) => text)"),
    ):
        assert ticks
        assert all(float(text).is_integer() for text in ticks)
