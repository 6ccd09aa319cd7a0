"""The report's statements, its walker, and how it prints, in a browser: one page for all looks."""

import re

import numpy as np
import pytest

from stridemap.paper.evaluate import evaluate
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.run import sweep
from stridemap.views import palette
from stridemap.views.report.write import write_report
from tests.oracles.claim_tables import changed, made_up
from tests.oracles.sweeping import Inline
from tests.stridemap.views.test_report_browser import opened, until

GRID = {"k": [0.5, 6.0, 22.5], "alpha": [0.25, 0.5], "omega": [3.0]}
CHARTS = ("map", "slice", "stage")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A report with verdicts on made-up tables, of which one holds in part."""
    folder = tmp_path_factory.mktemp("claims")
    config = parse_config({"model": "wobbling", "grid": GRID, "search": {"starts": 8}})
    sweep(config, folder / "out", executor=Inline())
    claims = evaluate(changed(made_up(), "typical", wobble_amplitude=0.03))
    write_report(folder / "out", folder / "page.html", [claim.to_dict() for claim in claims])
    return folder


@pytest.fixture(scope="module")
def page(folder, browser):
    """The report in a browser on a desktop; whatever it asks for or complains about fails the module."""
    page = opened(browser, folder)
    yield page
    page.context.close()
    assert [fault for fault in page.faults if not fault.startswith("file:")] == []


@pytest.fixture(autouse=True)
def as_at_the_start(page):
    yield
    page.set_viewport_size({"width": 1400, "height": 900})
    page.emulate_media(media="null", color_scheme="light")


def coloured(page, selector, what="fill"):
    """The colour that an element is drawn in."""
    value = page.eval_on_selector(selector, "(node, what) => getComputedStyle(node)[what]", what)
    return "#" + "".join(f"{int(channel):02x}" for channel in re.findall(r"\d+", value)[:3])


# -- statements ----------------------------------------------------------------------------------------------


def test_each_statement_shows_verdict_section_and_figure(page):
    assert page.inner_text("#claims > p") == "20 statements: 19 hold, 1 holds in part, none differs."
    seen = page.eval_on_selector_all(
        ".claim",
        """all => all.map((one) =>
        [one.id, one.querySelectorAll('svg.small').length, one.querySelectorAll('svg a').length])""",
    )
    assert [name for name, *_ in seen] == [f"claim-C{i}" for i in range(1, 21)]
    assert all(panels for _, panels, _ in seen)
    assert [name for name, _, links in seen if not links] == []
    assert "Section III-B, Walking performances" in page.inner_text("#claim-C7")
    assert "Not so in 1 of 2 parts: rounds to 0.05" in page.inner_text("#claim-C20")
    assert page.locator("#claim-C20 svg .not-so:not(.under)").count() == 1
    assert page.locator("#claim-C7 svg .so").count() == 4


def test_four_numbers_say_where_they_are(page):
    heads = page.locator("#claim-C7 .listed dt").all_inner_texts()
    assert heads == ["α 0.25, ω 2", "α 0.5, ω 2", "α 0.25, ω 3", "α 0.5, ω 3"]
    assert page.locator("#claim-C7 .listed dd").all_inner_texts() == ["0.900 (compass 0.700)"] * 4


def test_a_mark_leads_to_its_cycles_on_the_map(page):
    link = page.locator("#claim-C1 svg a[href*='k=22.5']")
    assert link.get_attribute("href") == "#k=22.5&alpha=0.25&omega=3"
    link.focus()
    page.keyboard.press("Enter")
    until(page, "document.getElementById('cell-name').textContent.startsWith('k = 22.5')")
    assert page.inner_text("#cell-name") == "k = 22.5, α = 0.25, ω = 3"
    assert page.locator("#cell-name").bounding_box()["y"] < 900  # it is in sight
    page.click("#claims .chips a >> nth=6")  # a link within the page leaves the choice as it is
    page.wait_for_timeout(100)
    assert page.inner_text("#cell-name") == "k = 22.5, α = 0.25, ω = 3"
    assert page.locator("#claim-C7 h3").bounding_box()["y"] < 900


def test_colours_are_those_of_all_pictures(page):
    assert coloured(page, "#claims .dots.group-B", "stroke") == palette.GROUPS["B"]
    assert coloured(page, ".mark.force", "backgroundColor") == palette.FORCE
    assert coloured(page, ".mark.zmp", "backgroundColor") == palette.ZMP
    assert coloured(page, "#strip circle.mass") == palette.MASS
    assert coloured(page, "#profiles polyline.force", "stroke") == palette.FORCE
    assert coloured(page, "#profiles polyline.zmp", "stroke") == palette.ZMP
    assert coloured(page, ".swatch.stable", "backgroundColor") == palette.STABLE
    assert palette.MEANINGS["force"] in page.inner_text("#cycle-card .keys")
    page.emulate_media(color_scheme="dark")
    assert coloured(page, "#strip circle.mass") == palette.MASS
    assert coloured(page, "#claims .dots.group-B", "stroke") == palette.GROUPS["B"]


# -- the walker ----------------------------------------------------------------------------------------------


def test_the_walker_fills_its_stage(page):
    """From the ground to the hip it takes at least two thirds of the height; feet stay inside."""
    page.evaluate("stridemap.stage.seek(0)")
    box = page.locator("#stage").bounding_box()
    places = np.array(page.evaluate("stridemap.stage.seen.positions.map(stridemap.stage.toPixels)"))
    assert np.ptp(places[:, 1]) > 0.66 * box["height"] > 200
    assert places.min() > 0
    assert (places < [box["width"], box["height"]]).all()


def test_loops_are_those_of_the_motion(page):
    """Under the glass: the spring's ends less the mean speed. They are closed, and x apart."""
    loops = page.evaluate("stridemap.stage.loops.get('spring').loops")
    hip, mass = (np.array(loop) for loop in loops)
    assert np.abs(hip[-1] - hip[0]).max() < 1e-9
    assert np.abs(mass[-1] - mass[0]).max() < 1e-9
    x = np.array(page.evaluate("stridemap.stage.path.samples(97).map((s) => s.q[2])"))
    assert np.abs(mass[:, 0] - hip[:, 0] - x).max() < 1e-12
    assert np.abs(hip.mean(axis=0)).max() < 1e-12


def test_a_strip_of_stick_figures_over_one_step(page):
    """Each at its own time, with legs as long as they are; pressing one goes there."""
    figures = page.eval_on_selector_all(
        "#strip .stick",
        """all => all.map((one) => [Number(one.dataset.time),
        one.querySelector('polyline.stance').getAttribute('points'),
        one.querySelector('polyline.swing').getAttribute('points')])""",
    )
    period = page.evaluate("stridemap.stage.path.period")
    assert [time for time, *_ in figures] == pytest.approx(np.linspace(0, period, 9))
    lengths = []
    for time, *legs in figures:
        ends = [np.array([[float(v) for v in p.split(",")] for p in leg.split()]) for leg in legs]
        lengths += [np.hypot(*(end[-1] - end[0])) for end in ends]
        angle = page.evaluate("t => stridemap.stage.path.seen(t).q[0]", time)
        foot, hip = ends[0]
        assert np.arctan2(foot[0] - hip[0], foot[1] - hip[1]) == pytest.approx(
            angle, abs=2e-3
        )  # leaning back
    assert np.ptp(lengths) < 0.05
    assert lengths[0] > 100
    page.click("#strip .stick >> nth=3")
    assert page.evaluate("stridemap.stage.time") == pytest.approx(3 * period / 8)
    shown = "all => all.map((one) => one.classList.contains('shown'))"
    assert page.eval_on_selector_all("#strip .stick", shown) == [i == 3 for i in range(9)]


# -- paper and telephone -------------------------------------------------------------------------------------


def test_on_a_telephone_statements_fit(page):
    page.set_viewport_size({"width": 360, "height": 740})
    page.evaluate("document.querySelectorAll('#claims details').forEach((one) => { one.open = true; })")
    assert page.evaluate("document.documentElement.scrollWidth") <= 360
    beyond = "all => all.filter((one) => one.getBoundingClientRect().right > 360).map((one) => one.outerHTML)"
    assert page.eval_on_selector_all("#claims *, #cycle-card *", beyond) == []
    scrolls = "all => all.filter((one) => one.scrollWidth > one.clientWidth + 1).length"
    assert page.eval_on_selector_all("#claims, #claims div, #claims dl", scrolls) == 0
    panel = page.locator("#claim-C7 svg.small").first.bounding_box()
    assert panel["width"] > 280  # texts are as large as drawn


def test_on_paper_charts_are_vectors_and_controls_are_left_out(page):
    page.emulate_media(color_scheme="dark")
    pdf = page.pdf(format="A4")
    assert pdf.count(b"/Subtype /Image") == 0  # nothing was printed as pixels
    assert page.locator(".printed").count() == 0  # and the page is as it was
    assert page.is_visible("#map")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print", color_scheme="dark")
    assert page.locator("canvas:visible").count() == 0
    assert page.locator("select:visible, button:visible, input:visible, nav:visible").count() == 0
    for chart in CHARTS:
        drawn = page.locator(f".printed[data-of={chart}] svg")
        assert drawn.bounding_box()["width"] > 300
        assert drawn.locator("path, rect").count() > 10
    assert palette.STABLE in page.locator(".printed[data-of=map]").inner_html().lower()
    assert "colour stable or unstable" in page.inner_text("#map-card")
    assert coloured(page, "body", "backgroundColor") == "#ffffff"  # paper is light
    assert coloured(page, ".swatch.stable", "backgroundColor") == palette.STABLE
    assert (
        page.eval_on_selector(".swatch.stable", "node => getComputedStyle(node).printColorAdjust") == "exact"
    )
    kept = "all => all.map((one) => getComputedStyle(one).breakAfter).filter((value) => value !== 'avoid')"
    assert page.eval_on_selector_all("h2, h3, caption", kept) == []
    assert page.eval_on_selector_all(".claim, .profile", kept.replace("breakAfter", "breakInside")) == []
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    page.emulate_media(media="null", color_scheme="light")
    assert page.locator(".printed").count() == 0
    assert page.is_visible("#map")
