"""What notebooks show: tables with units, pictures where matplotlib is, and text that is escaped."""

import re
from xml.etree import ElementTree

import pytest

import stridemap
from stridemap.solver.cycles.orbits import Orbits
from stridemap.views import optional
from stridemap.views.notebook import multiplier_plane

pytest.importorskip("matplotlib")


@pytest.fixture(scope="module")
def orbits():
    return stridemap.find_orbits("wobbling", k=6)


def pictures(text):
    return [ElementTree.fromstring(one) for one in re.findall(r"<svg.*?</svg>", text, re.DOTALL)]


def test_one_limit_cycle(orbits):
    text = orbits[1]._repr_html_()
    rows = re.findall(r"<tr><th>([^<]*)</th><td>([^<]*)</td><td>([^<]*)</td><td>([^<]*)</td></tr>", text)
    known = {name: (value, unit, meaning) for name, value, unit, meaning in rows}
    assert known["k"] == ("6", "M g / L", "stiffness of the wobbling mass&#x27;s spring")
    assert known["period"] == (f"{orbits[1].period:.8g}", "sqrt(L/g)", "period")
    assert set(orbits[1].measures) | set(orbits[1].state) <= set(known)
    assert len(pictures(text)) == 1
    assert text.count("<details>") == 1


def test_a_list_of_them(orbits):
    text = orbits._repr_html_()
    assert "<td>sqrt(L/g)</td>" in text
    (picture,) = pictures(text)
    words = " ".join("".join(one.itertext()) for one in picture.iter() if one.tag.endswith("text"))
    assert "1: stable" in words
    curves = multiplier_plane(orbits).axes[0].lines[1:]
    assert [complex(*one.get_xydata()[0]) for one in curves] == [orbit.multipliers[0] for orbit in orbits]
    several = orbits + stridemap.find_orbits("wobbling", k=7)
    assert "<th>k</th>" in several._repr_html_()
    assert "stiffness of the wobbling mass" in several._repr_html_()
    assert pictures(Orbits.empty(orbits.model)._repr_html_()) == []


def test_without_matplotlib_there_are_tables_alone(orbits, monkeypatch):
    monkeypatch.setattr(optional, "find_spec", lambda name: None)
    for shown in (orbits, orbits[0]):
        text = shown._repr_html_()
        assert "<svg" not in text
        assert "<table>" in text


def test_figures_show_themselves(orbits):
    assert len(pictures(orbits[1].plot()._repr_html_())) == 1
