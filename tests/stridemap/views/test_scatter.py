"""One column over another: the marks are the rows, axes say what they are, colours what is drawn."""

import numpy as np
import pandas as pd
import pytest

import stridemap
from stridemap.columns import Column
from stridemap.errors import InputError
from stridemap.tables.table import Table
from stridemap.views import optional, palette, scatter

pytest.importorskip("matplotlib")

FRAME = pd.DataFrame(
    {
        "k": np.arange(8.0),
        "cot": [0.3, 0.2, 0.5, np.nan, 0.4, 0.35, 0.25, 0.9],
        "spectral_radius": [0.9, 0.95, 1.2, 0.8, 1.05, 0.97, 0.99, 60.0],
        "stable": pd.array([True, True, False, True, False, True, None, False], dtype="boolean"),
        "group": ["A", "A", "B", "B", None, "C", "C", "C"],
    }
)
TABLE = Table.of_frame(FRAME)


def marks(figure):
    """Points that are drawn, by the look of their marks: filled, hollow or cross."""
    out = {}
    for one in figure.axes[0].collections:
        faces = one.get_facecolor()
        hollow = len(faces) and np.allclose(faces, [1, 1, 1, 1])
        cross = len(one.get_paths()[0].vertices) == 4
        look = "cross" if cross else "hollow" if hollow else "filled"
        out.setdefault(look, []).extend(map(tuple, np.asarray(one.get_offsets())))
    return {look: sorted(points) for look, points in out.items()}


def legend(figure):
    return [text.get_text() for one in figure.legends for text in one.get_texts()]


def test_marks_are_the_rows_and_show_stability():
    figure = TABLE.plot("k", "cot")
    wanted = {
        "filled": [(0.0, 0.3), (1.0, 0.2), (5.0, 0.35)],
        "hollow": [(2.0, 0.5), (4.0, 0.4), (7.0, 0.9)],
        "cross": [(6.0, 0.25)],
    }
    assert marks(figure) == wanted
    assert legend(figure) == ["stable", "unstable", "stability not known"]
    assert figure.axes[0].get_ylabel() == "cost of transport, cot"


def test_a_condition_selects_rows():
    figure = TABLE.plot("k", "cot", where="stable and k < 5")
    assert marks(figure) == {"filled": [(0.0, 0.3), (1.0, 0.2)]}
    assert "stable and k < 5" in figure.axes[0].get_title()


def test_the_scale_of_colours_is_that_of_what_is_drawn():
    bar = TABLE.plot("k", "spectral_radius", colour="cot", where="k < 3").axes[1]
    low, high = np.quantile([0.3, 0.2, 0.5], scatter.QUANTILES)
    assert bar.get_ylim() == pytest.approx((low, high))
    assert bar.get_ylabel() == "cost of transport, cot"
    about = TABLE.plot("k", "cot", colour="spectral_radius").axes[1]
    assert sum(about.get_ylim()) == pytest.approx(2)  # about 1, however large the largest is


def test_colours_of_texts_and_truths():
    assert legend(TABLE.plot("k", "cot", colour="group"))[:4] == [
        "group A",
        "group B",
        "group C",
        "group none",
    ]
    entries = TABLE.plot("k", "cot", colour="group").legends[0].legend_handles
    assert [one.get_color() for one in entries[:3]] == [palette.GROUPS[letter] for letter in "ABC"]
    assert "stable yes" in legend(TABLE.plot("k", "cot", colour="stable"))
    many = Table.of_frame(pd.DataFrame({"x": np.arange(40.0), "word": [f"w{i // 2}" for i in range(40)]}))
    words = legend(many.plot("x", "x", colour="word"))
    assert len(words) == scatter.MOST_CLASSES
    assert "word other" in words


def test_axes_bear_units():
    one = Column("k", "stiffness", "M g / L", "M g / L", "N/m")
    assert scatter.axis_text(one) == "stiffness, k  [$M\\,g/L$]"
    assert scatter.axis_text(one.in_si) == "stiffness, k  [$\\mathrm{N}/\\mathrm{m}$]"
    assert scatter.axis_text(Column("x", "x")) == "x"


def test_branches_are_joined():
    frame = pd.DataFrame(
        {"branch": [0, 0, 0, 1, 1], "arclength": [0, 1, 2, 0, 1.0], "k": [1, 2, 1.5, 4, 5.0]}
    )
    lines = Table.of_frame(frame).plot("k", "arclength", where="k != 2").axes[0].lines
    assert [line.get_xdata()[~np.isnan(line.get_xdata())].tolist() for line in lines] == [[1, 1.5], [4, 5]]
    assert np.isnan(lines[0].get_xdata()[1])  # a gap where a row is left out


def test_orbits(monkeypatch):
    orbits = stridemap.find_orbits("wobbling", k=6)
    figure = orbits.plot("period", "cot")
    assert marks(figure)["filled"] == [(orbits[1].period, orbits[1].cot)]
    assert figure.axes[0].get_xlabel() == r"period  [$\sqrt{L/g}$]"
    monkeypatch.setattr(optional, "find_spec", lambda name: None if name == "matplotlib" else name)
    with pytest.raises(InputError, match="drawing needs matplotlib, which is not installed here"):
        orbits.plot("period", "cot")


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("k", "cots"), r"there is no column 'cots' \(did you mean cot\?\)"),
        (
            ("group", "cot"),
            "group holds no numbers, so that it cannot be an axis; columns of numbers are k, cot",
        ),
        ((3, "cot"), "there is no column 3"),
    ],
)
def test_refusals(words, sentence):
    with pytest.raises(InputError, match=sentence):
        TABLE.plot(*words)


def test_many_marks_are_pixels():
    many = Table.of_frame(pd.DataFrame({"x": np.arange(5000.0), "y": np.arange(5000.0)}))
    assert len(many.plot("x", "y")._repr_html_()) < 100_000
