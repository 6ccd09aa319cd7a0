"""The report in a browser, opened as a file: no network, no complaints, right numbers, the walker moves."""

import time

import numpy as np
import pandas as pd
import pytest

import stridemap
from stridemap.solver.model.loading import load
from stridemap.solver.observables.motion import motions
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.run import sweep
from stridemap.sweeps.store import read_cells
from stridemap.views.report.write import write_report
from tests.oracles.states import states
from tests.oracles.sweeping import Inline
from tests.stridemap.views.conftest import at

CONFIG = {
    "wobbling": {"grid": {"k": [0.5, 6.0, 22.5, 30.0, 45.0], "alpha": [0.25, 0.3], "omega": [2.5, 3.0]}},
    "compass": {"grid": {"omega": [2.0, 2.5, 3.0]}},
    "goswami_compass": {"grid": {"slope": [0.03, 0.05], "mu": [2.0]}},
    "rimless_wheel": {"grid": {"slope": [0.2, 0.3]}},
    "simplest_walker": {"grid": {"slope": [0.004, 0.009]}},
}

BASE = {"search": {"starts": 24}, "special_points": False}


@pytest.fixture(scope="module", params=["wobbling"])
def report(request, tmp_path_factory):
    """A folder with a sweep in `out`, and its report in `page.html`."""
    folder = tmp_path_factory.mktemp(request.param)
    config = parse_config({"model": request.param, **CONFIG[request.param], **BASE})
    sweep(config, folder / "out", executor=Inline())
    write_report(folder / "out", folder / "page.html")
    return folder


def opened(browser, folder, width=1400, height=900, **options):
    """A report, opened by its file; whatever it asks for or complains of is in its `faults`."""
    context = browser.new_context(
        viewport={"width": width, "height": height}, **{"reduced_motion": "reduce", **options}
    )
    page, own = context.new_page(), (folder / "page.html").as_uri()
    page.faults = []
    page.on("console", lambda message: page.faults.append(message.text))
    page.on("pageerror", lambda error: page.faults.append(str(error)))
    page.on(
        "request",
        lambda asked: page.faults.append(asked.url) if asked.url not in (own, "data:,") else None,
    )
    page.goto(own)
    page.wait_for_selector("html[data-ready=yes]", state="attached")
    return page


@pytest.fixture
def open_page(browser):
    """Opens a report anew; a fault of it fails the test."""
    pages = []

    def own(*words, **options):
        pages.append(opened(browser, *words, **options))
        return pages[-1]

    yield own
    for page in pages:
        page.context.close()
    assert [page.faults for page in pages] == [[]] * len(pages)


@pytest.fixture(scope="module")
def kept(browser):
    """Reports that stay open from test to test, by their folders."""
    pages = {}
    yield pages
    for page in pages.values():
        page.context.close()


@pytest.fixture
def same_page(browser, kept):
    """Shows a report as it is at its start, which is faster than to open it anew; a fault fails the test."""
    seen = []

    def own(folder):
        if folder not in kept:
            kept[folder] = opened(browser, folder)
        seen.append(at(kept[folder], ""))
        return seen[-1]

    yield own
    assert [page.faults for page in seen] == [[]] * len(seen)


def number(text):
    """A number as it is shown, and half a unit of its last digit."""
    plain = text.replace("\u2212", "-")
    mantissa, _, exponent = plain.partition("e")
    decimals = len(mantissa.partition(".")[2])
    return float(plain), 0.5 * 10.0 ** (int(exponent or 0) - decimals)


def agrees(text, value):
    shown, half = number(text)
    return abs(shown - value) <= half * (1 + 1e-9)


def click_cell(page, cell):
    """Press in the middle of a cell of the map that is shown."""
    place = page.evaluate(
        """cell => { const { map, grid } = stridemap, at = grid.indices(cell);
        const { x, y, width, height } = map.box(at[map.across], map.up === null ? 0 : at[map.up]);
        return { x: x + width / 2, y: y + height / 2 }; }""",
        cell,
    )
    page.locator("#map").click(position=place)


def until(page, condition, seconds=20):
    """Wait until something is so in the page, whose policy lets Playwright evaluate no text of its own."""
    limit = time.monotonic() + seconds
    while not page.evaluate(condition):
        assert time.monotonic() < limit, condition
        page.wait_for_timeout(20)


def pixels(page, canvas):
    return page.evaluate("id => document.getElementById(id).toDataURL()", canvas)


# -- what the page computes ----------------------------------------------------------------------------------


@pytest.mark.parametrize("report", list(CONFIG), indirect=True)
def test_equations_are_those_of_the_model(report, same_page):
    page, model = same_page(report), load(report.name.rstrip("0123456789"))
    inputs = states(model.name, 200)
    names = page.evaluate("Object.keys(stridemap.equations)")
    assert {"state_derivative", "impact_map", "drawing", "zmp", "ground_force"} <= set(names)
    plain = {key: np.asarray(inputs[key]).tolist() for key in "tqvupz"}
    for name in names:
        wanted = model.evaluate(name, **inputs)
        found = page.evaluate(
            """([name, inputs]) => inputs.t.map((_, i) => stridemap.evaluate(name,
            Object.fromEntries(Object.entries(inputs).map(([key, values]) => [key, values[i]]))))""",
            [name, plain],
        )
        for key, values in wanted.items():
            seen = np.array([row[key] for row in found])
            scale = 1 + np.abs(values).max(axis=tuple(range(1, values.ndim)), keepdims=True)
            assert np.median(np.abs(seen - values) / scale) < 1e-15, (name, key)
            assert (np.abs(seen - values) / scale).max() < 1e-9, (name, key)  # near singular states


@pytest.mark.parametrize("report", list(CONFIG), indirect=True)
def test_motions_are_those_of_the_solver(report, same_page):
    """At times between the nodes of either integration, for every cycle of the sweep."""
    page, orbits = same_page(report), stridemap.read_orbits(report / "out")
    model, samples = load(report.name.rstrip("0123456789")), 57
    seen = motions(
        model, orbits[[*model.section, "period"]].to_numpy(), orbits[list(model.preset)].to_numpy(), samples
    )
    found = page.evaluate(
        """samples => Array.from({ length: stridemap.orbits.length }, (_, row) => {
        const path = stridemap.Path.ofRow(row);
        return { closing: path.closing, seen: path.samples(samples) }; })""",
        samples,
    )
    for i, one in enumerate(found):
        assert one["closing"] < 1e-9
        growth = 1e-10 * max(1, orbits.spectral_radius[i])
        for name in ("t", "q", "v", "com", "positions"):
            got = np.array([s[name] for s in one["seen"]])
            assert np.abs(got - getattr(seen, name)[i]).max() < growth, (i, name)
        for name in ("d", "force", "torque") if model.actuated else ("d", "force"):
            got, wanted = np.array([s[name] for s in one["seen"]]), getattr(seen, name)[i]
            assert np.abs(got - wanted).max() < 100 * growth * max(1, np.abs(wanted).max()), (i, name)
        for name, line in seen.lines.items():
            got = np.array([s["lines"][name] for s in one["seen"]])
            assert np.abs(got - line[i]).max() < growth, (i, name)


# -- what the reader does ------------------------------------------------------------------------------------


def test_it_paints_at_once(report, open_page):
    page = open_page(report)
    paints = page.evaluate("performance.getEntriesByType('paint').map(entry => entry.startTime)")
    assert paints
    assert max(paints) < 5000  # a loaded machine; 0.1 to 0.2 s on a quiet one


def test_a_cell_of_each_group_shows_the_numbers_of_the_table(report, same_page):
    page, orbits = same_page(report), stridemap.read_orbits(report / "out")
    model = load("wobbling")
    at_three = orbits[orbits.omega == 3.0]
    assert {"A", "B", "C", "D"} <= set(at_three.group)
    for group, rows in at_three.groupby("group"):
        wanted = rows.iloc[0]
        click_cell(page, int(wanted.cell))
        page.locator(f"#cycles input[value='{rows.index[0]}']").check()
        assert f"k = {wanted.k:g}, α = {wanted.alpha:g}, ω = 3" in page.inner_text("#cell-name")
        measures = dict(
            page.eval_on_selector_all(
                "#measures tr", "rows => rows.map(r => [r.dataset.name, r.cells[1].textContent])"
            )
        )
        assert measures["group"] == group
        assert measures["stable"] == ("yes" if wanted.stable else "no")
        assert measures["trailing_lifts_off"] == ("yes" if wanted.trailing_lifts_off else "no")
        numeric = set(measures) - {"group", "stable", "status", "undecided", "trailing_lifts_off"}
        assert {"period", "d_max", "cot", "spectral_radius", "min_vertical_force", "peaks"} <= numeric
        assert [name for name in numeric if not agrees(measures[name], wanted[name])] == []
        state = dict(
            page.eval_on_selector_all(
                "#state tr", "rows => rows.map(r => [r.dataset.name, r.cells[1].textContent])"
            )
        )
        assert set(state) == set(model.section)
        assert [name for name in state if not agrees(state[name], wanted[name])] == []
        check_multipliers(page, wanted)


def check_multipliers(page, wanted):
    shown = page.eval_on_selector_all("#multipliers tr", "rows => rows.map(r => r.cells[0].textContent)")
    for i, text in enumerate(shown):
        real, _, imaginary = text.removesuffix(" i").partition(" ")
        assert agrees(real, wanted[f"multiplier_{i}_re"])
        assert bool(imaginary) == (wanted[f"multiplier_{i}_im"] != 0)
        if imaginary:
            assert agrees(imaginary.replace(" ", ""), wanted[f"multiplier_{i}_im"])
    outside = sum(
        np.hypot(wanted[f"multiplier_{i}_re"], wanted[f"multiplier_{i}_im"]) >= 1 for i in range(len(shown))
    )
    assert page.locator("#circle .outside").count() == outside
    assert page.locator("#circle .inside").count() == len(shown) - outside


def test_the_slider_moves_the_map_and_the_cycle(report, same_page):
    page, orbits = same_page(report), stridemap.read_orbits(report / "out")
    click_cell(page, int(orbits[(orbits.omega == 3.0) & (orbits.group == "B")].cell.iloc[0]))
    before, cell = pixels(page, "map"), page.evaluate("stridemap.state.cell")
    slider = page.get_by_role("slider", name="ω")
    slider.focus()
    page.keyboard.press("ArrowLeft")
    assert "ω = 2.5" in page.inner_text("#cell-name")
    assert page.evaluate("stridemap.state.cell") == cell - 1  # the last axis runs fastest
    assert pixels(page, "map") != before


def test_the_colour_and_the_choice_of_cycles(report, same_page):
    page, orbits = same_page(report), stridemap.read_orbits(report / "out")
    here = orbits[(orbits.omega == 3.0) & orbits.stable]
    assert f"stable: {here.cell.nunique()} cells" in page.inner_text("#legend")
    for colour in page.eval_on_selector_all("#colour option", "found => found.map(o => o.value)"):
        before = pixels(page, "map")
        page.select_option("#colour", colour)
        if colour not in ("stability",):
            assert pixels(page, "map") != before, colour
            assert page.inner_text("#legend").strip()
    page.select_option("#colour", "stability")
    page.select_option("#choice", "unstable")
    assert "stable: 0 cells" in page.inner_text("#legend")


def test_the_walker_walks(report, open_page):
    page = open_page(report)
    still = pixels(page, "stage")
    page.wait_for_timeout(150)
    assert pixels(page, "stage") == still  # asked for less motion
    page.click("#play")
    until(page, "stridemap.stage.time > 0.05")
    assert pixels(page, "stage") != still
    assert page.inner_text("#play") == "Pause"
    page.click("#play")
    stopped = page.evaluate("stridemap.stage.time + 10 * stridemap.stage.step")
    page.wait_for_timeout(150)
    assert page.evaluate("stridemap.stage.time + 10 * stridemap.stage.step") == stopped


def test_it_walks_by_itself_where_motion_is_welcome(report, open_page):
    page = open_page(report, reduced_motion="no-preference")
    until(page, "stridemap.stage.time > 0.02")
    page.select_option("#speed", "1")
    until(page, "stridemap.stage.step >= 1")


def test_the_walker_stands_where_the_solver_has_it(report, open_page):
    page, orbits = open_page(report), stridemap.read_orbits(report / "out")
    model = load("wobbling")
    row = page.evaluate("stridemap.state.row")
    page.evaluate("document.getElementById('time').value = 600")
    page.dispatch_event("#time", "input")
    seen = page.evaluate("stridemap.stage.seen")
    orbit = orbits.iloc[[row]]
    moved = motions(
        model, orbit[[*model.section, "period"]].to_numpy(), orbit[list(model.preset)].to_numpy(), 6
    )
    assert seen["t"] == pytest.approx(moved.t[0, 3], rel=1e-12)
    assert np.abs(np.array(seen["positions"]) - moved.positions[0, 3]).max() < 1e-10
    # The drawing: pixels lie as the positions do, at one scale.
    placed = np.array(page.evaluate("stridemap.stage.seen.positions.map(stridemap.stage.toPixels)"))
    span, drawn = moved.positions[0, 3] - moved.positions[0, 3, 0], placed - placed[0]
    scale = -drawn[2, 1] / span[2, 1]
    assert scale > 50
    assert np.abs(drawn - scale * span * [1, -1]).max() < 1e-6
    d = moved.d[0, 3]
    assert f"d = {d:.3f}".replace("-", "\u2212") in page.inner_text("#now")


def test_by_keyboard_alone(report, open_page):
    page = open_page(report)
    for _ in range(30):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.id") == "map":
            break
    assert page.evaluate("document.activeElement.id") == "map"
    page.keyboard.press("Home")
    page.keyboard.press("ArrowUp")
    page.keyboard.press("ArrowUp")  # the end of the axis
    assert "k = 0.5, α = 0.3" in page.inner_text("#readout")
    assert page.text_content("#spoken") == page.inner_text("#readout")
    page.keyboard.press("Enter")
    assert "k = 0.5, α = 0.3, ω = 3" in page.inner_text("#cell-name")
    reached = set()
    for _ in range(60):
        page.keyboard.press("Tab")
        reached.add(page.evaluate("document.activeElement.id || document.activeElement.name"))
    assert {"slice", "scatter-x", "profiles", "pin", "play", "time", "speed"} <= reached


@pytest.mark.parametrize(("width", "height"), [(1400, 900), (420, 800)])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_it_fits(report, open_page, tmp_path, width, height, scheme):
    page = open_page(report, width, height, color_scheme=scheme)
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    for canvas in ("map", "stage", "slice"):
        box = page.locator(f"#{canvas}").bounding_box()
        assert 0 <= box["x"] < box["x"] + box["width"] <= width
        assert box["width"] > 300
    page.screenshot(path=tmp_path / "page.png", full_page=True)
    assert (tmp_path / "page.png").stat().st_size > 20_000


@pytest.mark.parametrize("report", ["compass"], indirect=True)
def test_one_axis_is_a_strip_and_a_curve(report, same_page):
    page, orbits = same_page(report), stridemap.read_orbits(report / "out")
    assert page.locator("#sliders input").count() == 0
    assert page.is_hidden("#axes")
    last = orbits.iloc[-1]
    click_cell(page, int(last.cell))
    assert page.inner_text("#cell-name") == f"ω = {last.omega:g}"
    assert page.locator("#slice").bounding_box()["height"] > 100


def test_the_address_keeps_the_choice(report, open_page):
    page = open_page(report)
    page.select_option("#colour", "cot")
    click_cell(page, 1)
    kept = page.evaluate("location.hash")
    page.goto((report / "page.html").as_uri() + kept)
    page.reload()
    page.wait_for_selector("html[data-ready=yes]", state="attached")
    assert page.evaluate("[stridemap.state.cell, stridemap.state.colour]") == [1, "cot"]


def test_a_cell_without_a_cycle_says_why(report, same_page):
    page = same_page(report)
    empty = read_cells(report / "out").query("status == 'empty' and omega == 3.0").cell
    click_cell(page, int(empty.iloc[0]))
    assert "was found, from the starts or from neighbouring cells" in page.inner_text("#empty")
    assert page.is_hidden("#numbers")


# -- boundaries and branches ---------------------------------------------------------------------------------

FINE = {"k": [float(k) for k in np.round(np.linspace(4.5, 12.0, 16), 3)], "alpha": [0.2, 0.25, 0.3]}


def ellipse(boundary, kind, gait, n=60):
    """A closed curve in the plane of FINE, around its middle."""
    angle = np.linspace(0, 2 * np.pi, n)
    preset = load("wobbling").preset
    table = pd.DataFrame({"k": 8.25 + 2 * np.cos(angle), "alpha": 0.25 + 0.04 * np.sin(angle)})
    known = {"boundary": boundary, "type": kind, "gait": gait, "borders_stable": angle < np.pi}
    return table.assign(
        **known, **{name: v for name, v in preset.items() if name not in table} | {"omega": 3.0}
    )


@pytest.fixture(scope="module")
def lined(tmp_path_factory):
    """A sweep along lines, with two boundaries that are made up, of which one has no gaits."""
    folder = tmp_path_factory.mktemp("lined")
    config = parse_config({"model": "wobbling", "grid": {**FINE, "omega": [2.5, 3.0]}, **BASE})
    sweep(config, folder / "out", executor=Inline())
    table = pd.concat([ellipse(0, "pd", True), ellipse(1, "fold", False)])
    write_report(folder / "out", folder / "page.html", curves=table)
    return folder


def at_omega(page, index):
    page.evaluate(
        "i => { const { grid, choose, state } = stridemap; const at = grid.indices(state.cell);"
        "at[2] = i; choose(grid.cell(at)); }",
        index,
    )


def test_boundaries_lie_where_their_cells_are(lined, same_page):
    page = same_page(lined)
    at_omega(page, 1)
    paths = page.eval_on_selector_all(
        "#curves path:not(.halo)", "all => all.map((p) => [p.dataset.type, p.getAttribute('d')])"
    )
    assert [kind for kind, _ in paths] == ["pd", "pd"]  # thin, and thick where stable gaits end
    table, inside = ellipse(0, "pd", True), 0
    wanted = [
        page.evaluate(
            """([k, alpha]) => { const { map, grid } = stridemap;
            const column = grid.axes[0].values.indexOf(k), row = grid.axes[1].values.indexOf(alpha);
            const box = map.box(column, row); return [box.x + box.width / 2, box.y + box.height / 2]; }""",
            [k, alpha],
        )
        for k, alpha in ((4.5, 0.2), (12.0, 0.3))
    ]
    (x0, y0), (x1, y1) = wanted
    for _, d in paths:
        for point in d[1:].split("L"):
            x, y = map(float, point.split())
            k, alpha = 4.5 + (x - x0) / (x1 - x0) * 7.5, 0.2 + (y - y0) / (y1 - y0) * 0.1
            assert ((table["k"] - k).abs() / 7.5 + (table["alpha"] - alpha).abs() / 0.1).min() < 1e-3
            inside += 1
    assert inside >= len(table)


def test_boundaries_are_those_of_the_values_that_are_chosen(lined, open_page):
    page = open_page(lined)
    at_omega(page, 0)
    assert page.locator("#curves path").count() == 0
    assert "boundaries are shown over k and α at ω = 3" in page.inner_text("#curves-legend")
    at_omega(page, 1)
    assert page.locator("#curves path").count() == 4
    assert page.locator("#curves-legend [data-type]").all_inner_texts() == ["period doubling"]
    page.uncheck("#curves-shown")
    assert page.locator("#curves path").count() == 0
    assert page.is_hidden("#curves-legend")
    page.check("#curves-shown")
    page.select_option("#across", "1")  # the axes change places
    first = page.locator("#curves path").first.bounding_box()
    frame = page.locator("#map").bounding_box()
    assert frame["x"] < first["x"] < first["x"] + first["width"] < frame["x"] + frame["width"]
    page.select_option("#across", "2")
    assert page.locator("#curves path").count() == 0


def test_the_slice_is_crossed_where_the_ellipse_is(lined, open_page):
    page = open_page(lined)
    found = page.evaluate("(stridemap.curves.show(0, 1, [0, 1, 1]), stridemap.curves.crossings(0.25))")
    assert sorted(k for k, _ in found) == pytest.approx([6.25, 10.25], abs=0.02)


def test_lines_join_cycles_of_one_branch(lined, same_page):
    """Each pair is in neighbouring columns of one branch; single cycles on either side are joined."""
    page, orbits = same_page(lined), stridemap.read_orbits(lined / "out")
    joined = 0
    for row, alpha in enumerate(FINE["alpha"]):
        page.evaluate(f"stridemap.choose(stridemap.grid.cell([8, {row}, 1]))")
        pairs = page.evaluate("stridemap.slice.joined")
        taken = [one for one, _ in pairs], [other for _, other in pairs]
        assert all(len(set(side)) == len(side) for side in taken)  # no cycle has two ways on
        for one, other in pairs:
            here, there = orbits.iloc[one], orbits.iloc[other]
            assert here.branch == there.branch
            assert FINE["k"].index(there.k) == FINE["k"].index(here.k) + 1
            assert here.alpha == there.alpha == alpha
            assert here.omega == there.omega == 3.0
        line = orbits[(orbits.alpha == alpha) & (orbits.omega == 3.0)]
        for number, branch in line.groupby("branch"):
            alone = {k: rows.index[0] for k, rows in branch.groupby("k") if len(rows) == 1}
            for k, after in zip(FINE["k"][:-1], FINE["k"][1:], strict=True):
                if (
                    k in alone
                    and after in alone
                    and abs(branch.period[alone[k]] - branch.period[alone[after]]) < 0.02
                ):
                    assert [int(alone[k]), int(alone[after])] in pairs, (number, k)
                    joined += 1
    assert joined > 10


def test_both_sides_of_a_fold_are_two_lines(lined, same_page):
    """Made-up states: two sheets that come near each other at a fold, a gap, and one sheet beyond."""
    page = same_page(lined)
    script = """(() => { const { orbits } = stridemap; const columns = [];
        for (let c = 0; c < 6; c++) columns.push(c);
        const s = (c) => Math.sqrt(6 - c) / 3;
        const rows = []; const state = [];
        const add = (c, value) => { rows.push([c, state.length]); state.push(value); };
        for (const c of columns) for (const side of [1, -1]) add(c, side * s(c));
        add(8, 0.1);
        add(9, 0.12);
        const fake = { distance: (a, b) => Math.abs(state[a] - state[b]) };
        return stridemap.joinedBy(rows, () => 0, fake); })()"""
    pairs = page.evaluate(script)
    upper = [[2 * c, 2 * c + 2] for c in range(5)]
    lower = [[2 * c + 1, 2 * c + 3] for c in range(5)]
    assert sorted(pairs) == sorted([*upper, *lower, [12, 13]])


def test_without_boundaries_there_is_no_switch(report, open_page):
    page = open_page(report)
    assert page.is_hidden("#curves-toggle")
    assert page.is_hidden("#curves-legend")
    assert page.locator("#curves path").count() == 0
