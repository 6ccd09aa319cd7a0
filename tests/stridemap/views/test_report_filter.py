"""Filters of the report: what an expression keeps, and the sentence for one that cannot be understood."""

import numpy as np
import pytest

import stridemap
from tests.stridemap.views.conftest import REFERENCES, at


@pytest.fixture(scope="module")
def orbits(compared):
    table = stridemap.read_orbits(compared / "out")
    at_omega = {one.parameters["omega"]: one.value for one in REFERENCES if one.quantity == "cot"}
    return table.assign(reference=table.omega.map(at_omega), known=table.stable.fillna(False).astype(bool))


def kept(page, expression):
    """Rows that an expression keeps."""
    return page.evaluate(
        """text => { const keep = stridemap.compileFilter(text);
        return Array.from({ length: stridemap.orbits.length }, (_, row) => row).filter(keep); }""",
        expression,
    )


@pytest.mark.parametrize(
    ("expression", "wanted"),
    [
        ("cot < 0.3", lambda o: o.cot < 0.3),
        ("cot < .3 and friction >= 0.16", lambda o: (o.cot < 0.3) & (o.friction >= 0.16)),
        ("stable", lambda o: o.known),
        ("not stable", lambda o: ~o.known),
        ("not (stable and cot < 0.3)", lambda o: ~(o.known & (o.cot < 0.3))),
        ("stable or k > 20 and omega = 3", lambda o: o.known | ((o.k > 20) & (o.omega == 3))),
        ("(stable or k > 20) and ω != 3", lambda o: (o.known | (o.k > 20)) & (o.omega != 3)),
        ("cot < compass", lambda o: o.cot < o.reference),
        ("compass > cot", lambda o: o.cot < o.reference),
        (
            "cot < 0.95 * compass and d_max < compass",
            lambda o: (o.cot < 0.95 * o.reference) & (o.d_max < 0.2),
        ),
        ("cot - compass < -1e-2", lambda o: o.cot - o.reference < -0.01),
        ("0.2 < cot <= 0.3", lambda o: (o.cot > 0.2) & (o.cot <= 0.3)),
        ("group = B", lambda o: o.group == "B"),
        ("group != 'B' AND mu < 1", lambda o: (o.group != "B") & (o.spectral_radius < 1)),
        ("-k^2 + 2*k >= -24.0", lambda o: -(o.k**2) + 2 * o.k >= -24),
        ("2 ^ 3 ^ 0 = 2 and k / 2 / 3 = 1", lambda o: o.k == 6),
        ("abs(clearance) < 1e-4", lambda o: o.clearance.abs() < 1e-4),
        ("peaks = 2", lambda o: o.peaks == 2),
        ("beta < 1", lambda o: o.k > 0),
        ("d_max < 1e9 or not d_max < 1e9", lambda o: o.d_max.notna()),
        ("  ", lambda o: o.k > 0),
    ],
)
def test_what_an_expression_keeps(page, orbits, expression, wanted):
    if not expression.strip():
        assert page.evaluate("stridemap.compileFilter('  ')") is None
        return
    assert kept(page, expression) == np.flatnonzero(wanted(orbits)).tolist()


@pytest.mark.parametrize(
    ("expression", "said"),
    [
        ("cott < 0.3", "“cott” is not a column of this sweep, a parameter, “compass” or “stable”;"),
        ("cott < 0.3", "; did you mean “cot”?"),
        ("cot", "must say what holds, but “cot” is a number; compare it, as in cot < 1."),
        ("cot <", "ends where a name or a number should be"),
        ("cot < 0.3 and", "ends where a name or a number should be"),
        ("cot < 0.3 friction < 1", "goes on with “friction” where “and”, “or” or its end should be"),
        ("(cot < 0.3", "has an opening bracket without a closing one; add “)”."),
        ("cot < 0.3)", "goes on with “)”"),
        ("cot < $5", "has “$”, which is not part of an expression"),
        ("stable < 1", "“stable” is a truth and “1” a number, which cannot be compared."),
        ("group + 1 > 2", "“group” is a word, and “+” needs numbers."),
        ("group < 'B'", "can be compared with = or != only."),
        ("compass", "“compass” stands for a value to compare with; write something like cot < compass."),
        ("friction < compass", "but “friction” does not have one"),
        ("cot < d_max * compass", "“cot” and “d_max” are compared at once"),
        ("cot and stable", "What stands before “and” must say what holds, but “cot” is a number"),
        ("constructor < 1", "“constructor” is not a column"),
        ("__proto__ = 1", "is not a column"),
        ("window.close()", "has “.”, which is not part"),
        ("(" * 300 + "cot" + ")" * 300 + " < 1", "more than 100 expressions within each other"),
    ],
)  # fmt: skip
def test_the_sentence_for_what_is_not_understood(page, expression, said):
    page.fill("#filter", expression)
    page.locator("#filter").dispatch_event("change")
    shown = page.inner_text("#filter-error")
    assert said in shown
    assert shown.count(". ") == 0  # one sentence
    assert shown.endswith((".", "?"))
    assert page.get_attribute("#filter", "aria-invalid") == "true"
    assert page.evaluate("stridemap.state.filter") == ""  # what was shown before stays


def test_the_map_shows_what_passes(page, orbits):
    at(page, "#omega=3")
    page.fill("#filter", "cot < compass and stable")
    page.keyboard.press("Enter")
    passing = orbits[(orbits.omega == 3) & orbits.known & (orbits.cot < orbits.reference)]
    cells = passing.cell.nunique()
    assert f"stable: {cells} cells" in page.inner_text("#legend")
    assert page.inner_text("#selection") == f"{len(passing)} cycles in {cells} cells shown"
    assert page.inner_text("#filter-error") == ""
    page.fill("#filter", "")
    assert f"{(orbits.omega == 3).sum()} cycles in" in page.inner_text("#selection")


def test_a_wrong_filter_in_an_address_is_explained(page):
    at(page, "#filter=cott+%3C+1&colour=cot")
    assert "did you mean “cot”?" in page.inner_text("#filter-error")
    assert page.input_value("#filter") == "cott < 1"
    assert page.evaluate("stridemap.state.colour") == "cot"


def test_the_names_are_listed(page):
    page.click(".filter summary")
    names = page.inner_text("#filter-names")
    for name in ("compass", "stable", "group", "cot", "friction", "omega", "k"):
        assert name in names.split()
