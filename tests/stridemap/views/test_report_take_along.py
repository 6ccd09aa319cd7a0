"""What a reader takes along from the report, tables and charts as files, and how it looks nearer."""

import csv
import io
import json
import struct
from xml.etree import ElementTree

import pytest

import stridemap
from tests.stridemap.views.conftest import GRID, at

SVG = "{http://www.w3.org/2000/svg}"


def saved(page, press):
    """The bytes and the name of the file that a press saves."""
    with page.expect_download() as waited:
        press()
    with open(waited.value.path(), "rb") as file:
        return file.read(), waited.value.suggested_filename


@pytest.fixture
def selected(page, compared):
    """The page with a filter, and the rows of the table that pass it."""
    at(page, "#omega=3&filter=cot+%3C+0.31")
    orbits = stridemap.read_orbits(compared / "out")
    return page, orbits[(orbits.omega == 3) & (orbits.cot < 0.31)]


def test_the_selection_as_csv(selected):
    page, wanted = selected
    data, name = saved(page, lambda: page.click("#save-csv"))
    assert name == "wobbling-cycles.csv"
    rows = list(csv.DictReader(io.StringIO(data.decode())))
    check(rows, wanted)
    assert [row["stable"] for row in rows] == [
        "true" if stable else "false" for stable in sorted_like(rows, wanted).stable
    ]


def sorted_like(rows, wanted):
    """The rows of the table in the order of the file: by alpha, then k, then the cycle's number."""
    return wanted.sort_values(["alpha", "k"], kind="stable")


def check(rows, wanted):
    wanted = sorted_like(rows, wanted)
    assert len(rows) == len(wanted) > 3
    for row, (_, orbit) in zip(rows, wanted.iterrows(), strict=True):
        assert (float(row["k"]), float(row["omega"])) == (orbit.k, orbit.omega)
        assert row["group"] == orbit.group
        assert f"{float(row['period']):.12f}" == f"{orbit.period:.12f}"
        for name in ("cot", "spectral_radius", "multiplier_2_re"):
            assert f"{float(row[name]):.10f}" == f"{orbit[name]:.10f}"


def test_the_selection_as_json(selected):
    page, wanted = selected
    data, name = saved(page, lambda: page.click("#save-json"))
    assert name == "wobbling-cycles.json"
    found = json.loads(data)
    check(found["cycles"], wanted)
    assert found["model"] == "wobbling"
    assert found["chosen"]["filter"] == "cot < 0.31"
    assert found["fixed"]["beta"] == 0.15
    assert found["units"]["time"] == "√(L/g)"


def test_a_brush_picks_out_cycles(page, compared):
    at(page, "#omega=3&cycles=stable&x=d_max&y=cot")
    page.locator("#scatter").scroll_into_view_if_needed()
    page.wait_for_timeout(100)
    orbits = stridemap.read_orbits(compared / "out")
    stable = orbits[(orbits.omega == 3) & orbits.stable]
    page.locator("#scatter").scroll_into_view_if_needed()
    box, frame = page.locator("#scatter").bounding_box(), page.evaluate("stridemap.scatter.frame()")
    low = stable.cot.median()
    top = page.evaluate("value => stridemap.scatter.scales[1].unit(value)", low)
    page.mouse.move(box["x"] + frame["x"], box["y"] + frame["y"] + frame["height"])
    page.mouse.down()
    page.mouse.move(
        box["x"] + frame["x"] + frame["width"],
        box["y"] + frame["y"] + (1 - top) * frame["height"] - 2,
        steps=4,
    )
    page.mouse.up()
    inside = stable[stable.cot <= low]
    assert page.inner_text("#selection") == f"{len(inside)} cycles in {inside.cell.nunique()} cells shown"
    dim = page.evaluate(
        """stridemap.map.looks.flatMap((line, r) =>
        line.map((look, c) => [stridemap.map.cellAt(c, r), look.dim]))"""
    )
    assert {cell for cell, faded in dim if faded is False} == set(inside.cell)
    assert {cell for cell, faded in dim if faded} == set(stable.cell) - set(inside.cell)
    page.click("#brush-filter")
    assert page.evaluate("stridemap.state.brush") is None
    assert "cot <= " in page.input_value("#filter")
    assert page.inner_text("#selection") == f"{len(inside)} cycles in {inside.cell.nunique()} cells shown"
    assert page.faults == []


def png_size(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", data[16:24])


@pytest.mark.parametrize(
    "chart", ["#map-save", "#slice-save", "#scatter-save", "#circle-save", "#profiles figure:nth-child(1)"]
)
def test_every_chart_is_saved_as_svg_and_png(page, chart):
    at(page, "#omega=3&colour=cot&pin=0.5,0.25,3,1")
    page.locator("#scatter").scroll_into_view_if_needed()
    page.wait_for_timeout(50)
    data, name = saved(page, lambda: page.click(f"{chart} [data-save=SVG]"))
    root = ElementTree.fromstring(data)
    assert root.tag == f"{SVG}svg"
    assert name.endswith(".svg")
    width, height = float(root.get("width")), float(root.get("height"))
    texts = [text.text for text in root.iter(f"{SVG}text")]
    expected = {
        "#map-save": ["k [M g / L]", "α"],
        "#slice-save": ["k [M g / L]", "compass 0.308"],
        "#scatter-save": ["largest distance d [L]", "cost of transport"],
        "#circle-save": ["Re", "Im"],
    }
    for text in expected.get(chart, ["t [√(L/g)]"]):
        assert text in texts
    assert b"var(--" not in data
    data, name = saved(page, lambda: page.click(f"{chart} [data-save=PNG]"))
    assert name.endswith(".png")
    assert png_size(data) == (int(3 * width), int(3 * height))
    assert len(data) > 3000
    assert page.faults == []


def test_the_saved_map_has_the_cells_of_the_screen(page):
    at(page, "#omega=3&colour=cot")
    root = ElementTree.fromstring(page.evaluate("stridemap.redrawn(stridemap.map).text"))
    fills = {rect.get("fill") for rect in root.iter(f"{SVG}rect")}
    shown = {
        fill for fill in page.evaluate("stridemap.map.looks.flat().map(look => look.fill ?? null)") if fill
    }
    assert shown
    assert shown <= fills


def test_zoom_and_pan(page):
    at(page, "#omega=3")
    whole = page.evaluate("[0, 1].map(i => stridemap.map.box(i, 0).width)")
    page.click("#zoom-in")
    assert page.evaluate("stridemap.map.box(0, 0).width") == pytest.approx(1.6 * whole[0], rel=1e-6)
    assert "view=" in page.evaluate("location.hash")
    page.focus("#map")
    for _ in range(3):
        page.keyboard.press("+")
    box = page.locator("#map").bounding_box()
    before = page.evaluate("stridemap.state.view")
    cell = page.evaluate("stridemap.state.cell")
    page.mouse.move(box["x"] + 300, box["y"] + 200)
    page.mouse.down()
    page.mouse.move(box["x"] + 240, box["y"] + 200, steps=4)
    page.mouse.up()
    after = page.evaluate("stridemap.state.view")
    assert after[0] > before[0]
    assert after[1] - after[0] == pytest.approx(before[1] - before[0])
    assert page.evaluate("stridemap.state.cell") == cell  # a drag is not a press
    page.keyboard.press("0")
    assert page.evaluate("stridemap.state.view") is None
    page.keyboard.down("Control")
    page.mouse.wheel(0, -200)
    page.keyboard.up("Control")
    assert page.evaluate("stridemap.state.view") is not None
    page.click("#whole")
    assert page.evaluate("stridemap.map.box(0, 0).width") == pytest.approx(whole[0])


def test_what_is_pointed_at_is_read_out_beside_the_pointer(page):
    at(page, "#omega=3&colour=cot")
    place = page.evaluate(
        """(() => { const { x, y, width, height } = stridemap.map.box(1, 0);
        return [x + width / 2, y + height / 2]; })()"""
    )
    box = page.locator("#map").bounding_box()
    page.mouse.move(box["x"] + place[0], box["y"] + place[1])
    tip = page.locator("#tip")
    assert tip.is_visible()
    assert tip.inner_text() == page.inner_text("#readout")
    assert tip.inner_text().startswith("k = 6, α = 0.25: ")
    assert "cost of transport 0." in tip.inner_text()
    away = tip.bounding_box()
    assert abs(away["x"] - box["x"] - place[0]) < 40
    page.mouse.move(5, 5)
    assert tip.is_hidden()


def test_definitions_open_by_keyboard_and_finger(page):
    row = page.locator('#measures tr[data-name="cot"]')
    assert row.locator("p").is_hidden()
    row.locator("summary").focus()
    page.keyboard.press("Enter")
    assert "Energy that the motors draw" in row.locator("p").inner_text()
    other = page.locator('#measures tr[data-name="friction"]')
    other.locator("summary").click()
    assert "without the impulse of the impact" in other.locator("p").inner_text()


def test_slices_and_profiles_by_keyboard(page, compared):
    at(page, "#k=6&alpha=0.25&omega=3")
    orbits = stridemap.read_orbits(compared / "out")
    page.focus("#slice")
    start = orbits.iloc[page.evaluate("stridemap.state.row")]
    page.keyboard.press("ArrowRight")
    moved = orbits.iloc[page.evaluate("stridemap.state.row")]
    assert moved.k == GRID["k"][2]
    assert moved.branch == start.branch
    page.keyboard.press("ArrowUp")
    higher = orbits.iloc[page.evaluate("stridemap.state.row")]
    assert higher.k == moved.k
    assert higher.spectral_radius >= moved.spectral_radius
    page.keyboard.press("Home")
    assert orbits.iloc[page.evaluate("stridemap.state.row")].k == 0.5
    page.focus("#profiles")
    page.keyboard.press("Home")
    for _ in range(5):
        page.keyboard.press("ArrowRight")
    time, period = page.evaluate("[stridemap.stage.time, stridemap.stage.path.period]")
    assert time == pytest.approx(0.05 * period)
    assert page.get_attribute("#profiles", "aria-valuenow") == "5"
