"""Small figures: what they hold, that they draw it where it is, and that nothing else is taken for one."""

import json
import re
from html import unescape
from urllib.parse import parse_qs

import numpy as np
import pytest

from stridemap.paper.evaluate import evaluate
from stridemap.views.report.claim_figures import LETTER, drawn, ticks
from stridemap.views.report.claims import enough_digits
from stridemap.views.small_figures import (
    Axis,
    Bar,
    Curve,
    Guide,
    Mark,
    Panel,
    SmallFigure,
    figure_from,
    rows_axis,
)
from tests.oracles.claim_tables import changed, made_up


@pytest.fixture(scope="module")
def claims():
    """The statements on made-up tables in which some of B and one of E are not as stated, by id."""
    data = changed(made_up(), "lines", lambda r: (r["group"] == "B") & (r["omega"] == 2.0), d_max=1.0)
    data = changed(data, "lines", lambda r: (r["group"] == "E") & (r["k"] == 46.0), spectral_radius=0.6)
    return {claim.id: claim for claim in evaluate(data)}


def marks(claim):
    return [mark for panel in claim.figure.panels for mark in panel.marks]


def test_each_statement_has_a_figure_that_travels_as_json(claims):
    for claim in claims.values():
        plain = json.loads(json.dumps(claim.figure.to_dict(), allow_nan=False))
        assert figure_from(plain).to_dict() == plain
        assert claim.figure.caption
        assert any(panel.marks for panel in claim.figure.panels), claim.id


def test_marks_are_as_stated_where_the_parts_are(claims):
    for claim in claims.values():
        if claim.verdict == "holds":
            assert all(mark.holds for mark in marks(claim)), claim.id
        if claim.verdict == "differs":
            assert not any(mark.holds for mark in marks(claim)), claim.id
    assert claims["C7"].verdict == "differs"
    assert claims["C13"].verdict == "in part"
    assert {mark.holds for mark in marks(claims["C13"])} == {True, False}


def test_the_least_multiplier_is_marked_where_the_evidence_has_it(claims):
    """E at k = 46 has 0.6 at each alpha and omega, below the compass's 0.7."""
    panels = claims["C7"].figure.panels
    assert [panel.title for panel in panels] == [f"α = {a:g}, ω = {w:g}" for w in (2, 3) for a in (0.25, 0.5)]
    for panel in panels:
        ((mark,), guides) = panel.marks, {guide.look: guide.value for guide in panel.guides}
        assert (mark.x, mark.y, mark.holds, mark.text) == (46.0, 0.6, False, "0.6")
        assert guides == {"compass": 0.7, "plain": 1.0}
        assert mark.at["k"] == 46.0
    assert [(m.at["alpha"], m.at["omega"]) for m in marks(claims["C7"])] == [
        (a, w) for w in (2, 3) for a in (0.25, 0.5)
    ]


def test_profiles_have_their_peaks_marked(claims):
    """The made-up rates are cosines of one, two and three periods."""
    for n, panel in enumerate(claims["C5"].figure.panels, 1):
        assert [mark.x for mark in panel.marks] == pytest.approx(
            [(i + 0.5) / n for i in range(n)], abs=1 / 400
        )
        assert [mark.y for mark in panel.marks] == pytest.approx([1.0] * n, abs=1e-3)


def test_ranges_are_drawn_in_the_colours_of_their_groups(claims):
    panel = claims["C2"].figure.panels[0]
    assert {bar.look for bar in panel.bars} == {f"group-{g}" for g in "ABCDE"}
    first = {bar.text: (bar.low, bar.high) for bar in panel.bars if bar.row == 0}
    assert first["B"] == (10.0, 18.0)  # of the made-up tables
    assert len(panel.marks) == 4 * 4  # a gap between each two letters


def test_a_figure_can_be_drawn_where_nothing_was_found():
    data = made_up()
    for table in ("typical", "lines", "map"):
        data = changed(data, table, stable=False)
    data = changed(data, "lines", main=False)
    for claim in evaluate(data):
        assert "<svg" in drawn(figure_from(json.loads(json.dumps(claim.figure.to_dict())))), claim.id


# -- drawing -------------------------------------------------------------------------------------------------


def place_of(text, tag):
    """Attributes of the elements of a kind, as numbers where they are some."""
    found = []
    for attributes in re.findall(rf"<{tag} ([^>]*?)/?>", text):
        pairs = dict(re.findall(r'([\w-]+)="([^"]*)"', attributes))
        found.append(pairs)
    return found


def test_things_lie_where_the_axes_say():
    panel = Panel(
        "a panel", Axis("across", 0.0, 10.0), Axis("up", -1.0, 1.0),
        [Curve("stable", [0.0, 10.0], [-1.0, 1.0])],
        marks=[Mark(5.0, 0.0, holds=True, text="middle", at={"k": 5.0, "alpha": 0.25})],
        guides=[Guide("y", 0.5, "half")],
    )  # fmt: skip
    text = drawn(SmallFigure("what it shows", [panel]))
    (frame,) = (box for box in place_of(text, "rect") if box["class"] == "frame")
    x0, y0, w, h = (float(frame[key]) for key in ("x", "y", "width", "height"))
    (path,) = (one for one in place_of(text, "path") if one["class"] == "line stable")
    ends = np.array([[float(v) for v in point.split()] for point in path["d"][1:].split("L")])
    assert ends == pytest.approx(np.array([[x0, y0 + h], [x0 + w, y0]]), abs=0.06)
    (disc,) = (one for one in place_of(text, "circle") if one["class"] == "so")
    assert [float(disc["cx"]), float(disc["cy"])] == pytest.approx([x0 + w / 2, y0 + h / 2], abs=0.06)
    (guide,) = (one for one in place_of(text, "line") if "guide" in one["class"])
    assert float(guide["y1"]) == float(guide["y2"]) == pytest.approx(y0 + h / 4, abs=0.06)
    (link,) = place_of(text, "a")
    assert parse_qs(unescape(link["href"])[1:]) == {"k": ["5"], "alpha": ["0.25"]}
    assert "middle" in link["aria-label"]
    assert "what it shows" in text


@pytest.mark.parametrize("apart", [0.0, 0.01, 0.03, 0.1])
def test_texts_of_marks_beside_each_other_are_a_line_apart(apart):
    """As in C15, where d changes its sign in all typical solutions at nearly one time."""
    marks = [Mark(0.5 + i * apart, 0.0, holds=True, text=f"{g} 0.5{i}") for i, g in enumerate("ABC")]
    panel = Panel("", Axis("", 0.0, 1.0), Axis("", -1.0, 1.0), marks=marks)
    text = drawn(SmallFigure("", [panel]))
    places = [
        (float(one["x"]), float(one["y"])) for one in place_of(text, "text") if one.get("class") == "halo"
    ]
    assert len(places) == 3
    for i, (x, y) in enumerate(places):
        for u, v in places[:i]:
            assert abs(x - u) >= LETTER * 6 or abs(y - v) >= 13


def test_what_lies_outside_is_left_out():
    panel = Panel(
        "",
        Axis("", 0.0, 1.0),
        Axis("", 0.0, 1.0),
        [Curve("plain", [0.1, 0.2, 0.3, 0.4], [0.5, 7.0, 0.5, 0.6])],
    )
    (path,) = (one for one in place_of(drawn(SmallFigure("", [panel])), "path"))
    assert path["d"].count("M") == 2
    assert path["d"].count("L") == 1


def test_rows_are_one_below_the_other():
    bars = [Bar("group-A", 0, 0.0, 0.5, "first"), Bar("group-B", 2, 0.5, 1.0, "third")]
    text = drawn(SmallFigure("", [Panel("", Axis("", 0.0, 1.0), rows_axis(["a", "b", "c"]), bars=bars)]))
    first, third = (box for box in place_of(text, "rect") if box["class"].startswith("bar"))
    assert float(third["y"]) - float(first["y"]) == pytest.approx(2 * 17, abs=0.2)
    assert float(third["x"]) == pytest.approx(float(first["x"]) + float(first["width"]), abs=0.2)


@pytest.mark.parametrize(
    ("axis", "wanted"),
    [
        (Axis("", 0.0, 61.0), [0, 20, 40, 60]),
        (Axis("", 0.95, 1.04), [0.96, 0.98, 1.0, 1.02, 1.04]),
        (Axis("", -3.0, 1.0), [-3, -2, -1, 0, 1]),
        (Axis("", 1e-6, 3e-6), [1e-6, 1.5e-6, 2e-6, 2.5e-6, 3e-6]),
    ],
)
def test_ticks_are_round(axis, wanted):
    assert ticks(axis, 5) == pytest.approx(wanted)


# -- numbers -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("values", "digits"),
    [
        ({"least": 0.845835729, "compass": 0.748418627}, 3),
        ({"least": 0.754431, "compass": 0.754409}, 5),
        ({"same": [0.1, 0.1], "word": "A", "whole": 123456}, 3),
        ({"nested": {"a": [1.0000001, 1.0]}}, 8),
        ({}, 3),
    ],
)
def test_numbers_have_as_many_digits_as_tell_them_apart(values, digits):
    assert enough_digits(values) == digits


# -- what is not a figure ------------------------------------------------------------------------------------

AXIS = {"label": "", "low": 0, "high": 1, "rows": []}
PLAIN = {
    "caption": "",
    "panels": [
        {
            "title": "",
            "x": AXIS,
            "y": AXIS,
            "curves": [{"look": "plain", "x": [0.5], "y": [0.5], "dots": True, "text": ""}],
            "bars": [{"look": "plain", "row": 0, "low": 0, "high": 1, "text": "", "at": None}],
            "marks": [{"x": 0.5, "y": 0.5, "holds": True, "text": "", "at": {"k": 1}}],
            "guides": [{"axis": "x", "value": 0.5, "label": "", "look": "plain"}],
            "bands": [{"axis": "x", "low": 0, "high": 1, "label": ""}],
        }
    ],
}


def without(path, value):
    """The plain figure with one entry changed."""
    figure = json.loads(json.dumps(PLAIN))
    here = figure["panels"][0]
    for key in path[:-1]:
        here = here[key]
    here[path[-1]] = value
    return figure


def test_the_plain_figure_is_one():
    assert figure_from(PLAIN).panels[0].marks[0].at == {"k": 1.0}


@pytest.mark.parametrize(
    "figure",
    [
        3, [], {"caption": "", "panels": 7}, {"caption": 1, "panels": []},
        {"panels": []},
        without(["title"], None), without(["x"], None), without(["x", "high"], 0),
        without(["x", "high"], 1e-320),
        without(["y", "low"], float("nan")), without(["y", "high"], 10**400), without(["x", "rows"], [3]),
        without(["curves", 0, "look"], "url(x)"), without(["curves", 0, "look"], ["plain"]),
        without(["curves", 0, "x"], [0.1, 0.2]), without(["curves", 0, "y"], [True]),
        without(["bars", 0, "row"], 0.5), without(["bars", 0, "text"], 3), without(["marks", 0, "at"], 3),
        without(["marks", 0, "at"], {"k": "1"}), without(["marks", 0, "x"], "1"),
        without(["guides", 0, "axis"], "z"), without(["bands", 0, "low"], float("inf")),
        without(["marks"], {}),
    ],
)  # fmt: skip
def test_anything_else_is_refused(figure):
    with pytest.raises(ValueError, match="."):
        figure_from(figure)


def test_a_file_with_a_figure_of_another_form_is_refused(tmp_path, done, refused):
    claims = [{"id": "C1", "verdict": "holds", "figure": without(["x", "high"], "wide")}]
    (tmp_path / "c.json").write_text(json.dumps({"claims": claims}))
    refused(
        f"report {done}/out --out {done}/a.html --claims {tmp_path}/c.json",
        "the figure of C1", "is not one that can be drawn", "wide", "stridemap claims --json",
    )  # fmt: skip
