"""One palette: what a colour stands for is the same in figures, plots, films and on the page."""

import re
from importlib.resources import files
from itertools import combinations
from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.colors import to_hex

import stridemap
from stridemap.views import palette, style
from stridemap.views.plots import plot

ROOT = Path(__file__).parents[3]


def names(theme):
    """Names and colours of the style sheet; the first block is the light page's."""
    blocks = re.findall(r":root[^{]* \{(.*?)\}", palette.style_sheet())
    return dict(re.findall(r"--([\w-]+): (#\w{6});", blocks[["light", "dark"].index(theme)]))


def luminance(colour):
    """Of WCAG 2.1."""
    channels = np.array([int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)])
    linear = np.where(channels <= 0.04045, channels / 12.92, ((channels + 0.055) / 1.055) ** 2.4)
    return float(linear @ [0.2126, 0.7152, 0.0722])


def test_things_on_the_page_have_the_colours_of_the_figures():
    for theme in ("light", "dark"):
        found = names(theme)
        assert found["force"] == palette.FORCE
        assert found["zmp"] == palette.ZMP
        assert found["mass"] == found["spring"] == palette.MASS
        assert found["map-stable"] == style.STABLE
        groups = {letter: found[f"group-{letter}"] for letter in palette.GROUPS}
        assert groups == palette.GROUPS
    assert names("light")["map-unstable"] == style.UNSTABLE
    assert [style.SOLUTIONS[solution]["color"] for solution in "abc"] == [palette.GROUPS[g] for g in "ABC"]


@pytest.mark.parametrize(("theme", "card"), [("light", "#ffffff"), ("dark", "#1d2125")])
def test_marks_stand_out_from_their_ground(theme, card):
    """Contrast of WCAG 2.1 for what is not text, at least 3."""
    found = names(theme)
    for name in (
        "force",
        "zmp",
        "mass",
        "open",
        "compass",
        "stance",
        "map-stable",
        "group-A",
        "group-B",
        "group-C",
    ):
        dark, bright = sorted([luminance(found[name]), luminance(card)])
        assert (bright + 0.05) / (dark + 0.05) >= 3, name


def test_what_is_seen_together_differs():
    things = [palette.FORCE, palette.ZMP, palette.MASS, palette.BODY, palette.STANCE, palette.SWING]
    assert all(one != other for one, other in combinations(things, 2))
    assert len(set(palette.GROUPS.values())) == len(palette.GROUPS)


def test_no_page_and_no_example_has_a_colour_of_its_own():
    """Colours of things are named in one module; a style sheet's own are those of ground, text and lines."""
    sheet = files("stridemap.views.report").joinpath("page.css").read_text("utf-8")
    own = set(re.findall(r"--([\w-]+):", sheet))
    assert not own & set(names("light"))
    colours = {v for k, v in vars(palette).items() if k.isupper() and isinstance(v, str)}
    for path in [
        *ROOT.glob("examples/*.py"),
        *ROOT.glob("stridemap/views/**/*.py"),
        *ROOT.glob("stridemap/views/**/*.js"),
    ]:
        if path.name != "palette.py":
            assert [colour for colour in colours if colour in path.read_text("utf-8").lower()] == [], path


def test_plots_draw_force_and_zero_moment_point_in_their_colours():
    (orbit,) = stridemap.find_orbits("compass", omega=3)
    mpl.rcdefaults()
    figure = plot(orbit)
    drawn = {line.get_label(): to_hex(line.get_color()) for axes in figure.axes for line in axes.lines}
    assert drawn["$F_y$"] == palette.FORCE
    assert drawn["paper's $d$"] == palette.ZMP
