"""The address of the report keeps what was chosen, in values; back and forward; copied links and commands."""

from urllib.parse import parse_qs

import pytest

import stridemap
from tests.stridemap.views.conftest import GRID, at


def words(page):
    return {key: value[0] for key, value in parse_qs(page.evaluate("location.hash")[1:]).items()}


def choose(page, k, alpha, omega):
    indices = [GRID["k"].index(k), GRID["alpha"].index(alpha), GRID["omega"].index(omega)]
    page.evaluate("at => stridemap.choose(stridemap.grid.cell(at))", indices)


def test_it_opens_on_the_papers_own_point(page):
    assert page.inner_text("#cell-name") == "k = 6, α = 0.25, ω = 3"
    found = words(page)
    assert (found["k"], found["alpha"], found["omega"]) == ("6", "0.25", "3")


def test_the_address_keeps_everything_in_values(page):
    address = (
        "#k=22.5&alpha=0.3&omega=2.5&cycle=1&colour=cot&cycles=stable&of=low&filter=cot+%3C+compass&about=compass"
        "&x=k&y=friction&z=cot&profiles=phase&range=0.2%2C0.4&brush=0%2C12%2C0.1%2C0.3&view=3.25%2C26.25%2C0.24%2C0.29&pin=6%2C0.25%2C3%2C1"
        "&si=0.8%2C40%2C9.81"
    )
    at(page, address)
    assert parse_qs(page.evaluate("location.hash")[1:]) == parse_qs(address[1:])
    state = page.evaluate("stridemap.state")
    assert [GRID["k"][state["indices"][0]], GRID["omega"][state["indices"][2]]] == [22.5, 2.5]
    assert (state["colour"], state["choice"], state["of"], state["range"]) == (
        "cot",
        "stable",
        "low",
        [0.2, 0.4],
    )
    assert page.input_value("#filter") == "cot < compass"
    assert page.is_checked("#si")
    first = page.evaluate("document.getElementById('map').toDataURL()")
    page.reload()
    page.wait_for_selector("html[data-ready=yes]", state="attached")
    assert parse_qs(page.evaluate("location.hash")[1:]) == parse_qs(address[1:])
    assert page.evaluate("document.getElementById('map').toDataURL()") == first
    assert page.faults == []


@pytest.mark.parametrize(
    "address",
    [
        "#k=1e9&alpha=-3&omega=x&cycle=77&colour=nothing&cycles=no&of=1&about=2&range=3,1&brush=1&view=a,b,c,d&pin=1",
        "#colour=constructor&group=Z&x=__proto__&across=k&up=k&si=0,0,0&pin=6,0.25,3,99&view=0,0,0,0&profiles=2",
        "#%E0%A4%A&=&&k", "#explore=",
    ],
)  # fmt: skip
def test_what_an_address_says_wrongly_is_left_out(page, address):
    at(page, address)
    assert page.evaluate("stridemap.state.colour") == "stability"
    assert (
        page.evaluate(
            "[stridemap.state.range, stridemap.state.brush, stridemap.state.view, stridemap.state.pin]"
        )
        == [None] * 4
    )
    assert page.locator("#cycle").is_visible()


def test_values_that_the_grid_does_not_have_are_said(page):
    at(page, "#k=6.1&alpha=0.25&omega=2.75")
    assert page.inner_text("#readout").startswith(
        "The grid has no k = 6.1 and no ω = 2.75; its nearest cell is shown. "
    )
    at(page, "#k=6&alpha=0.25&omega=3")
    assert "The grid has no" not in page.inner_text("#readout")


def test_back_and_forward(page):
    page.select_option("#colour", "cot")
    choose(page, 22.5, 0.25, 3.0)
    page.go_back()
    assert page.inner_text("#cell-name") == "k = 6, α = 0.25, ω = 3"
    assert page.input_value("#colour") == "cot"
    page.go_back()
    assert page.input_value("#colour") == "stability"
    page.go_forward()
    page.go_forward()
    assert page.inner_text("#cell-name") == "k = 22.5, α = 0.25, ω = 3"
    page.evaluate("location.hash = '#provenance'")  # a link within the page leaves the choice alone
    assert page.inner_text("#cell-name") == "k = 22.5, α = 0.25, ω = 3"


def test_a_slider_is_one_step_of_the_history(page):
    before = page.evaluate("history.length")
    slider = page.get_by_role("slider", name="ω")
    for index in ("0", "1", "0"):
        slider.evaluate(
            "(input, to) => { input.value = to; input.dispatchEvent(new Event('input')); }", index
        )
    slider.dispatch_event("change")
    assert page.evaluate("history.length") == before + 1
    assert words(page)["omega"] == "2.5"


def test_commands_have_the_numbers_that_one_would_type(page, compared):
    choose(page, 0.5, GRID["alpha"][1], 3.0)
    command = page.inner_text("#command")
    assert command.startswith(
        "stridemap orbit --model wobbling --set k=0.5 --set alpha=0.3 --set omega=3 --set beta=0.15 "
    )
    choose(page, 8.571428571428571, 0.25, 3.0)
    assert "--set k=8.571428571428571 " in page.inner_text("#command")
    assert words(page)["k"] == "8.571428571428571"


def test_the_command_finds_the_cycles_of_the_page(page):
    choose(page, 0.5, GRID["alpha"][1], 3.0)
    settings = dict(part.split("=") for part in page.inner_text("#command").split(" --set ")[1:])
    found = stridemap.find_orbits("wobbling", {name: float(value) for name, value in settings.items()})
    shown = page.evaluate("stridemap.orbits.numbers('period')[stridemap.state.row]")
    assert min(abs(orbit.period - shown) for orbit in found) < 1e-9


def test_links_and_commands_are_copied(page, looked):
    looked.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.select_option("#colour", "cot")
    page.click("#copy-link")
    page.wait_for_timeout(100)
    assert page.inner_text("#copy-link") == "copied"
    assert page.evaluate("navigator.clipboard.readText()") == page.own + page.evaluate("location.hash")
    page.click("#copy-command")
    page.wait_for_timeout(100)
    assert page.evaluate("navigator.clipboard.readText()") == page.inner_text("#command")
