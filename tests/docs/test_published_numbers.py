"""Every row of the page of published numbers, computed again."""

import re
from pathlib import Path

import pytest

from tests.oracles.published import COMPUTED, agreeing

PAGE = Path(__file__).resolve().parents[2] / "docs" / "published-numbers.md"
ROWS = {
    int(cells[0]): cells
    for line in PAGE.read_text("utf-8").splitlines()
    if re.match(r"\| \d+ \|", line)
    for cells in [[cell.strip() for cell in line.strip("|").split("|")]]
}


def test_the_page_has_a_row_for_each_value():
    assert sorted(ROWS) == sorted(COMPUTED)
    assert len(ROWS) >= 15
    sources = set(re.findall(r"^- \[(\w)\]", PAGE.read_text("utf-8"), re.M))
    assert {cells[3].split()[1].strip("[]") for cells in ROWS.values()} == sources


@pytest.mark.parametrize("row", sorted(COMPUTED))
def test_a_row(row):
    printed, shown, digits = ROWS[row][3].split()[0], ROWS[row][4], int(ROWS[row][5])
    value = COMPUTED[row]()
    places = len(shown.partition(".")[2])
    assert value == pytest.approx(float(shown), rel=0, abs=max(2 * 10.0**-places, 5e-15))
    assert agreeing(printed, value) == digits


def test_digits_are_counted_by_rounding():
    assert agreeing("0.200310900563820", 0.200310900544247) == 9
    assert agreeing("-3.882", -3.88246) == 4
    assert agreeing("0.1", 0.2) == 0
