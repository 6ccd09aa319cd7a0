"""A browser, and one page of the report that many tests look at."""

import shutil

import pytest

from stridemap.sweeps.config import parse_config
from stridemap.sweeps.run import sweep
from stridemap.views.report.references import Reference
from stridemap.views.report.write import write_report
from tests.oracles.shared import once
from tests.oracles.states import BROWSERS, need
from tests.oracles.sweeping import Inline

ARGUMENTS = [
    "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync",
]  # fmt: skip

GRID = {"k": [0.5, 6.0, 8.571428571428571, 22.5, 30.0], "alpha": [0.25, 0.1 + 0.2], "omega": [2.5, 3.0]}
"""Two of the values have no short decimals: one by rounding alone."""

REFERENCES = [
    Reference("cot", 0.308, "compass", {"omega": 3.0}),
    Reference("cot", 0.25, "compass", {"omega": 2.5}),
    Reference("d_max", 0.2, "compass"),
]


@pytest.fixture(scope="package")
def browser():
    """One for all pages: to start it takes longer than most tests."""
    path = need(*BROWSERS)
    api = pytest.importorskip("playwright.sync_api")
    with api.sync_playwright() as playwright:
        started = playwright.chromium.launch(executable_path=shutil.which(path), args=ARGUMENTS)
        yield started
        started.close()


@pytest.fixture(scope="session")
def compared(common):
    """A folder with a small sweep of the walker in `out`, and its report with references in `page.html`."""

    def make(folder):
        config = parse_config({"model": "wobbling", "grid": GRID, "search": {"starts": 24}})
        sweep(config, folder / "out", executor=Inline())
        write_report(folder / "out", folder / "page.html", references=REFERENCES)

    once(common / "compared", make)
    return common / "compared"


@pytest.fixture(scope="module")
def looked(browser, compared):
    """The page of `compared`, open for all tests of a module; what it complains of is in its `faults`."""
    context = browser.new_context(
        viewport={"width": 1400, "height": 900}, reduced_motion="reduce", accept_downloads=True
    )
    page = context.new_page()
    page.faults = []
    page.on("console", lambda message: page.faults.append(message.text))
    page.on("pageerror", lambda error: page.faults.append(str(error)))
    page.own = (compared / "page.html").as_uri()
    page.on(
        "request",
        lambda asked: (
            page.faults.append(asked.url) if not asked.url.startswith((page.own, "data:", "blob:")) else None
        ),
    )
    page.goto(page.own)
    page.wait_for_selector("html[data-ready=yes]", state="attached")
    yield page
    context.close()


@pytest.fixture
def page(looked):
    """The page as it is at its start; whatever it asks for or complains of fails the test."""
    return at(looked, "")


def at(page, hash_):
    """Go to an address of the page, as a link or the history would."""
    page.evaluate(
        "hash => { history.pushState(null, '', hash); dispatchEvent(new PopStateEvent('popstate')); }",
        hash_ or "#",
    )
    assert page.faults == []
    return page
