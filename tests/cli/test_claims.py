"""``stridemap claims`` on made-up tables: one line per statement, the rest on demand, plain English."""

import json
import re

import pytest

from stridemap.cli.claims import _ordinal
from stridemap.paper.evaluate import STATEMENTS, evaluate
from stridemap.views.report.verdicts import tally
from stridemap.views.small_figures import figure_from
from tests.oracles.claim_tables import changed, made_up


@pytest.fixture(scope="module")
def made():
    """The verdicts on made-up tables, in which one statement is not so."""
    return evaluate(changed(made_up(), "typical", wobble_amplitude=0.03))


@pytest.fixture
def decided(monkeypatch, made):
    """What the command decides."""
    monkeypatch.setattr("stridemap.paper.claims", lambda *_, **__: made)
    return made


def test_one_line_for_each_statement(decided, run):
    status, out, err = run("claims")
    assert (status, err) == (0, "")
    lines = out.splitlines()
    assert [line[:4].strip() for line in lines[:20]] == [claim.id for claim in decided]
    assert [line[5:13].strip() for line in lines[:20]] == [str(claim.verdict) for claim in decided]
    assert lines[19] == "C20  in part  the mass moves by about 0.05 L (1 of 2)"
    assert lines[20] == "19 hold, 1 holds in part, none differs"
    assert max(map(len, lines[:21])) < 80
    assert len(lines) == 22  # and where the numbers come from


def test_the_rest_on_demand(decided, run):
    _, out, _ = run("claims", "--verbose")
    text = re.sub(r"\s+", " ", out)
    for claim in decided:
        assert claim.statement in text
        assert f"(Section {claim.where})" in text
    assert "not so: rounds to 0.05" in text
    # Four numbers in a row: each says where it is.
    (c7,) = (claim for claim in decided if claim.id == "C7")
    block = out[out.index("C7 ") : out.index("C8 ")]
    for name, value in c7.listed.items():
        assert re.search(rf"^ +{name} +{re.escape(value)}$", block, re.MULTILINE)
    assert list(c7.listed) == [f"alpha {a:g}, omega {w:g}" for w in (2, 3) for a in (0.25, 0.5)]


def test_json_has_full_digits_and_what_is_drawn(decided, run):
    status, out, _ = run("claims", "--json")
    assert status == 0
    answer = json.loads(out)["claims"]
    assert answer == [json.loads(json.dumps(claim.to_dict())) for claim in decided]
    for claim in answer:
        assert figure_from(claim["figure"]).to_dict() == claim["figure"]
        assert claim["where"].startswith(("III-", "IV-"))
    assert max(len(line) for line in out.splitlines() if '"figure"' not in line) < 1000


@pytest.mark.parametrize(
    ("counts", "words"),
    [
        ((14, 6, 0), "14 hold, 6 hold in part, none differs"),
        ((1, 1, 1), "1 holds, 1 holds in part, 1 differs"),
        ((0, 2, 18), "none holds, 2 hold in part, 18 differ"),
    ],
)
def test_counts_agree_with_their_verbs(counts, words):
    verdicts = zip(("holds", "in part", "differs"), counts, strict=True)
    assert tally(verdict for verdict, n in verdicts for _ in range(n)) == words


def test_places_in_a_row():
    assert [_ordinal(n) for n in (1, 2, 3, 4, 11, 12, 13, 21, 22, 112)] == [
        "1st", "2nd", "3rd", "4th", "11th", "12th", "13th", "21st", "22nd", "112th",
    ]  # fmt: skip


def test_short_forms_are_short_and_sections_are_the_papers():
    for one in STATEMENTS.values():
        assert len(one.short) <= 51
        assert one.where.partition(",")[0] in ("III-A", "III-B", "IV-A", "IV-C")
        assert one.figure is not None
