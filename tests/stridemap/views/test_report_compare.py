"""Comparison in the report: pinned cycles, phase portraits, SI units on the whole page, borders of groups."""

import re

import numpy as np
import pytest

import stridemap
from stridemap.solver.model.loading import load
from stridemap.solver.observables.motion import motions
from tests.stridemap.views.conftest import at


def table(page, name):
    """Texts of a table by the name of the row: this cycle's, and the others' columns."""
    found = page.eval_on_selector_all(
        f"#{name} tr[data-name]",
        "rows => rows.map(r => [r.dataset.name, ...[...r.cells].slice(1).map(c => c.textContent)])",
    )
    return {row[0]: row[1:] for row in found}


def number(text):
    return float(text.replace("\u2212", "-"))


@pytest.fixture
def orbits(compared):
    return stridemap.read_orbits(compared / "out")


def test_a_pinned_cycle_stands_beside_another(page, orbits):
    at(page, "#k=6&alpha=0.25&omega=3&cycle=2")
    pinned = orbits.iloc[page.evaluate("stridemap.state.row")]
    page.click("#pin")
    assert "pin=6%2C0.25%2C3%2C2" in page.evaluate("location.hash")
    page.evaluate("stridemap.choose(stridemap.grid.cell([0, 0, 1]))")
    chosen = orbits.iloc[page.evaluate("stridemap.state.row")]
    measures = table(page, "measures")
    for name in ("cot", "period", "spectral_radius", "friction"):
        decimals = 12 if name == "period" else 10
        assert measures[name][:2] == [f"{chosen[name]:.{decimals}f}", f"{pinned[name]:.{decimals}f}"]
    assert page.locator("#stage-pinned").is_visible()
    assert page.inner_text("#pinned-name") == "pinned: k = 6, α = 0.25, ω = 3, cycle 2"
    first = page.locator("#profiles figure").first
    assert first.locator("polyline").count() == 2 * first.locator("polyline:not(.pinned)").count()
    # Both walkers are at the same part of their steps.
    page.evaluate("document.getElementById('time').value = 500")
    page.dispatch_event("#time", "input")
    halves = page.evaluate("[stridemap.stage, stridemap.pinnedStage].map(s => s.time / s.path.period)")
    assert halves == pytest.approx([0.5, 0.5])
    page.click("#pinned-go")
    assert page.inner_text("#cell-name") == "k = 6, α = 0.25, ω = 3"
    assert page.inner_text("#pin") == "Unpin"
    page.click("#pin")
    assert page.is_hidden("#pinned")
    assert len(table(page, "measures")["cot"]) == 2  # the value and its unit
    assert page.faults == []


def test_phase_portraits_are_the_rates_over_the_coordinates(page, orbits):
    at(page, "#k=6&alpha=0.25&omega=3&cycle=2&profiles=phase")
    model = load("wobbling")
    orbit = orbits.iloc[[page.evaluate("stridemap.state.row")]]
    moved = motions(
        model, orbit[[*model.section, "period"]].to_numpy(), orbit[list(model.preset)].to_numpy(), 121
    )
    figures = page.locator("#profiles figure")
    assert figures.count() == len(model.coordinates)
    for i in range(figures.count()):
        label = figures.nth(i).locator("svg").get_attribute("aria-label")
        low, high = re.search(r"from (\S+) to (\S+)", label).groups()
        assert number(low) == pytest.approx(moved.v[0, :, i].min(), rel=2e-3, abs=1e-3)
        assert number(high) == pytest.approx(moved.v[0, :, i].max(), rel=2e-3, abs=1e-3)
        points = np.array([
            [float(part) for part in pair.split(",")]
            for pair in figures.nth(i).locator("polyline").get_attribute("points").split(" ")
        ])  # fmt: skip
        # Pixels are an affine image of the coordinate and of its rate.
        for pixels, values in ((points[:, 0], moved.q[0, :, i]), (points[:, 1], moved.v[0, :, i])):
            slope, offset = np.polyfit(values, pixels, 1)
            assert np.abs(slope * values + offset - pixels).max() < 0.02
    dot = figures.first.locator(".now-dot")
    before = dot.get_attribute("cx")
    page.focus("#profiles")
    page.keyboard.press("End")
    assert dot.get_attribute("cx") != before


ROBOT = {"length": 0.8, "mass": 40.0, "gravity": 9.81}


def test_si_units_for_the_whole_page(page, orbits):
    at(page, "#k=6&alpha=0.25&omega=3&cycle=2&colour=d_max")
    for name, value in ROBOT.items():
        page.fill(f"#sizes [data-size={name}]", str(value))
        page.locator(f"#sizes [data-size={name}]").dispatch_event("change")
    page.check("#si")
    orbit = orbits.iloc[page.evaluate("stridemap.state.row")]
    robot = stridemap.Units(leg_length=0.8, mass=40.0, gravity=9.81)
    shown = table(page, "measures")
    wanted = {
        "period": ("time", "s"), "speed": ("speed", "m/s"), "d_max": ("length", "m"), "work": ("energy", "J"),
        "peak_torque": ("torque", "N m"), "peak_power": ("power", "W"), "min_vertical_force": ("force", "N"),
        "cot": ("number", ""), "cot_per_speed": ("time", "s"),
    }  # fmt: skip
    for name, (kind, unit) in wanted.items():
        text, shown_unit = shown[name]
        decimals = len(text.partition(".")[2])
        value = robot.to_si(float(orbit[name]), kind) if kind != "number" else orbit[name]
        assert text == f"{value:.{decimals}f}", name
        assert decimals >= 6
        assert shown_unit == unit
    state = table(page, "state")
    assert number(state["dx"][0]) == pytest.approx(robot.to_si(float(orbit.dx), "speed"), rel=1e-9)
    assert state["dx"][1] == "m/s"
    assert page.inner_text("#cell-name") == "k = 2943, α = 0.25, ω = 10.5054"
    assert "rad/s" in page.inner_text("#sliders")
    assert "largest distance d [m]" in page.inner_text("#scale")
    ticks = [float(text) for text in page.locator("#scale .ticks span").all_inner_texts()]
    low, high = page.evaluate("[stridemap.bar.low, stridemap.bar.high]")
    assert 0.8 * low - 1e-9 <= min(ticks) <= max(ticks) <= 0.8 * high + 1e-9
    captions = " ".join(page.locator("#profiles figcaption").all_inner_texts())
    assert "[rad/s]" in captions
    assert "[N]" in captions
    assert "√" not in captions
    svg = page.evaluate("stridemap.redrawn(stridemap.map).text")
    assert ">k [N/m]</text>" in svg
    assert "--set k=6 " in page.inner_text("#command")  # commands stay in the model's units
    assert "si=0.8%2C40%2C9.81" in page.evaluate("location.hash")
    page.uncheck("#si")
    assert table(page, "measures")["period"] == [f"{orbit.period:.12f}", "√(L/g)"]
    assert page.faults == []


def test_moduli_have_the_decimals_that_are_certain(page, orbits):
    at(page, "#k=6&alpha=0.25&omega=3&cycle=2")
    orbit = orbits.iloc[page.evaluate("stridemap.state.row")]
    rows = page.eval_on_selector_all("#multipliers tr", "rows => rows.map(r => r.cells[1].textContent)")
    for i, text in enumerate(rows):
        value = np.hypot(orbit[f"multiplier_{i}_re"], orbit[f"multiplier_{i}_im"])
        if value >= 1e-3:
            assert text == f"{value:.{len(text.partition('.')[2])}f}"
            assert len(text) >= 10


def test_letters_stand_within_their_groups_and_borders_between_them(page):
    """Made-up groups: a ring of A around B has its letter on the ring, and not in its middle."""
    found = page.evaluate(
        """(() => { const { patchesOf, depthsOf, deepest, bordersOf } = stridemap.patches;
        const letters = Array.from({ length: 9 }, (_, r) =>
            Array.from({ length: 12 }, (_, c) => (r > 2 && r < 6 && c > 2 && c < 9 ? "B" : "A")));
        letters[0][0] = null;
        const depths = depthsOf(letters);
        const patches = patchesOf(letters);
        return [patches.map(([letter, patch]) => [letter, patch.length, deepest(patch, depths)]),
            bordersOf(letters).length]; })()"""
    )
    patches, borders = found
    assert [(letter, size) for letter, size, _ in patches] == [("A", 9 * 12 - 18 - 1), ("B", 18)]
    (ring, (column, row)), (inner, middle) = [(p[0], p[2]) for p in patches]
    assert (ring, inner) == ("A", "B")
    assert not (3 <= row <= 5 and 3 <= column <= 8)
    assert middle[1] == 4
    assert borders == 2 * (3 + 6)
