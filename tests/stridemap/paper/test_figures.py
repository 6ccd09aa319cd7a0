"""The figures show what the tables hold: artists against rows, classes against cells, text as text."""

import re

import numpy as np
import pandas as pd
import pytest

import stridemap
from stridemap.paper.sweeps import PaperSweeps, configurations
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.store import read_orbits
from tests.oracles.sweeping import Inline

pytest.importorskip("matplotlib")
pytest.importorskip("PIL")

from matplotlib.colors import to_rgb

from stridemap.paper import map_boundaries
from stridemap.paper.drawings import curves, sketch
from stridemap.paper.drawings import map as maps
from stridemap.paper.drawings import time_profiles as profiles
from stridemap.paper.drawings.material import Material
from stridemap.solver.branches.plane import NONE, STABLE, UNSTABLE
from stridemap.solver.cycles.gait import is_physical_gait
from stridemap.solver.model.loading import load
from stridemap.views import style

K = [float(k) for k in np.round(np.linspace(4.5, 12.0, 16), 3)]
ALPHA = [0.2, 0.25, 0.3]


@pytest.fixture(scope="module")
def configs():
    """A small map, and one line of springs, across the gap between groups A and B."""
    base = {"model": "wobbling", "search": {"starts": 24}, "special_points": False}  # as the paper's
    small_map = {**base, "grid": {"k": K, "alpha": ALPHA, "omega": [2.0, 3.0]}}
    line = {**base, "grid": {"k": K, "alpha": [0.25], "omega": [3.0]}}
    small = {"map": parse_config(small_map), "lines": parse_config(line)}
    return {**configurations(), **small}


@pytest.fixture(scope="module")
def data(configs, tmp_path_factory):
    return Material(PaperSweeps(tmp_path_factory.mktemp("sweeps"), configs, executor=Inline()))


def class_at(axes, k, alpha):
    """The class whose region a point of the map lies in."""
    inside = [
        int(collection.get_gid().removeprefix("class-"))
        for collection in axes.collections
        if any(path.contains_point((k, alpha)) for path in collection.get_paths())
    ]
    assert len(inside) <= 1
    return inside[0] if inside else None


def test_the_map_is_the_table(data):
    orbits = read_orbits(data.sweeps.run("map"))
    orbits = orbits[is_physical_gait(orbits) & (orbits["omega"] == 3.0)]
    with style.styled():
        axes = maps.draw(data).axes[0]
    image = axes.images[0]
    cells = np.asarray(image.get_array())
    assert cells.shape == (len(ALPHA), len(K))
    for i, alpha in enumerate(ALPHA):
        for j, k in enumerate(K):
            here = orbits[(orbits["alpha"] == alpha) & (orbits["k"] == k)]
            wanted = NONE if here.empty else STABLE if here["stable"].any() else UNSTABLE
            assert cells[i, j] == class_at(axes, k, alpha) == wanted, (k, alpha)
    assert {STABLE, UNSTABLE} <= set(cells.ravel().tolist())
    left, right, bottom, top = image.get_extent()
    assert (left + right) / 2 == pytest.approx((K[0] + K[-1]) / 2)
    assert (bottom + top) / 2 == pytest.approx(0.25)
    marks = {line.get_gid(): line.get_xydata()[0].tolist() for line in axes.lines if line.get_gid()}
    assert marks == {"a": [0.5, 0.25], "b": [6.0, 0.25], "c": [22.5, 0.25]}


def test_edges_run_where_a_search_finds_them(data):
    """Between rows of cells, a thousandth of the map's width to either side of each edge of a region."""
    alpha, beside = 0.2627, 0.001 * (K[-1] - K[0])
    with style.styled():
        axes = maps.draw(data).axes[0]
    edges = []
    for collection in axes.collections:
        for path in collection.get_paths():
            x, y = path.vertices.T
            for i in np.flatnonzero((y[1:] > alpha) != (y[:-1] > alpha)):
                edges.append(np.interp(alpha, sorted(y[i : i + 2]), x[i : i + 2][np.argsort(y[i : i + 2])]))
    left, right = axes.get_xlim()
    inner = {round(float(edge), 6) for edge in edges if left + beside < edge < right - beside}
    assert len(inner) >= 2
    for k in sorted({edge + side for edge in inner for side in (-beside, beside)}):
        found = stridemap.find_orbits("wobbling", k=k, alpha=alpha, omega=3.0)
        found = found[is_physical_gait(found)]
        wanted = NONE if not len(found) else STABLE if found.stable.any() else UNSTABLE
        assert class_at(axes, k, alpha) == wanted, k


def test_boundaries_are_computed_once(data, monkeypatch):
    """They lie beside the sweep, and are those of that sweep only."""
    first = data.boundaries
    monkeypatch.setattr(map_boundaries.CellSurvey, "boundaries", lambda survey: pytest.fail("computed again"))
    again = map_boundaries.map_boundaries(data.sweeps)
    pd.testing.assert_frame_equal(again, first)
    assert {"boundary", "type", "gait", "borders_stable", *load("wobbling").preset} <= set(first)
    monkeypatch.setattr(map_boundaries, "FORMAT", map_boundaries.FORMAT + 1)
    with pytest.raises(pytest.fail.Exception, match="computed again"):
        map_boundaries.map_boundaries(data.sweeps)


def test_classes_differ_in_grey():
    luminance = [0.2126, 0.7152, 0.0722]
    grey = sorted(np.dot(to_rgb(c), luminance) for c in (style.STABLE, style.UNSTABLE, style.NONE))
    assert np.diff(grey).min() > 0.25


def test_lines_differ_without_colour():
    stable, unstable, compass = style.STABLE_LINE, style.UNSTABLE_LINE, style.COMPASS_LINE
    assert stable["linewidth"] > 2 * unstable["linewidth"]
    assert compass["linestyle"] != stable["linestyle"] == unstable["linestyle"]
    dashes = [str(look["linestyle"]) for look in style.SOLUTIONS.values()]
    assert len(set(dashes)) == len(dashes)


def test_curves_hold_every_cycle_of_the_table(data):
    table = data.sweeps.orbits("lines")
    (of,) = data.branch_sets.values()
    joined = pd.concat(of)
    columns = ["k", "period", "spectral_radius"]
    on_grid = joined[joined["on_grid"]].sort_values(["k", "period"])[columns]
    assert np.array_equal(on_grid.to_numpy(), table.sort_values(["k", "period"])[columns].to_numpy())
    with style.styled():
        axes = curves.draw_multipliers(data).axes[0]
    compass = data.compass(3.0).row["spectral_radius"]
    dashed = [line for line in axes.lines if line.is_dashed()]
    assert [set(line.get_ydata()) for line in dashed] == [{compass}]
    drawn = {
        (float(x), float(y), line.get_linewidth())
        for line in axes.lines
        for x, y in zip(line.get_xdata(), line.get_ydata(), strict=True)
    }
    physical = table[table["min_vertical_force"] > 0]
    for k, radius, stable in physical[["k", "spectral_radius", "stable"]].itertuples(index=False):
        width = (style.STABLE_LINE if stable else style.UNSTABLE_LINE)["linewidth"]
        assert (k, radius, width) in drawn


def test_a_branch_is_cut_where_its_stability_changes():
    rows = pd.DataFrame(
        {
            "k": [1.0, 2.0, 3.0],
            "spectral_radius": [0.8, 0.9, 1.1],
            "stable": [True, True, False],
            "cot": [1.0, 2.0, 4.0],
            "min_vertical_force": [1.0, 1.0, 1.0],
        }
    )
    (first, x1, y1), (second, x2, _) = curves.pieces(rows, "cot")
    assert (first, second) == (True, False)
    assert x1.tolist() == pytest.approx([1.0, 2.0, 2.5])  # the multiplier is 1 half way
    assert y1.tolist() == pytest.approx([1.0, 2.0, 3.0])
    assert x2.tolist() == pytest.approx([2.5, 3.0])


def test_profiles_are_the_motions(data):
    with style.styled():
        axes = profiles.draw_distance(data).axes[0]
    lines = {line.get_label(): line for line in axes.lines}
    for letter, (group, k) in {"a": ("A", 0.5), "b": ("B", 6.0), "c": ("C", 22.5)}.items():
        line = next(line for label, line in lines.items() if label.startswith(f"{letter}:"))
        cycle = data.typical[letter]
        assert (cycle.row["k"], cycle.row["alpha"], cycle.row["omega"]) == (k, 0.25, 3.0)
        found = stridemap.find_orbits("wobbling", k=k, alpha=0.25, omega=3.0)
        orbit = min((o for o in found if o.group == group), key=lambda o: o.spectral_radius)
        seen = stridemap.motion(orbit, len(line.get_xdata()))
        assert line.get_ydata() == pytest.approx(seen.d, abs=1e-9)


def test_text_stays_text_and_bytes_stay_the_same(tmp_path):
    written = []
    for name in ("one", "two"):
        with style.styled():
            written += style.write(sketch.draw(), tmp_path / name, "model")
    assert written[0].read_bytes() == written[2].read_bytes()
    svg = written[0].read_text()
    assert len(re.findall(r"<text", svg)) > 8
    assert "theta" in svg or "θ" in svg


def test_the_command_draws_from_finished_sweeps(data, run, refused, tmp_path):
    data.sweeps.run("compass")
    words = ("figures", "--only", "profiles-compass", "--sweeps", data.sweeps.folder)
    status, out, err = run(*words, "--out", tmp_path)
    assert (status, err) == (0, "")  # nothing is swept again
    assert out.splitlines() == [f"{tmp_path}/profiles-compass.{kind}" for kind in ("svg", "png")]
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "profiles-compass.png",
        "profiles-compass.svg",
    ]
    refused([*words, "--out", tmp_path, "--set", "beta=0.2"], "output of another configuration", "beta")


def test_refusals(run, tmp_path, monkeypatch):
    status, out, err = run("figures", "--only", "mapp", "--out", tmp_path)
    assert (status, out) == (2, "")
    assert "there is no figure 'mapp'; figures are model, map" in err
    from stridemap.views import optional

    monkeypatch.setattr(optional, "find_spec", lambda name: None)
    status, out, err = run("figures", "--only", "model", "--out", tmp_path)
    assert (status, out) == (2, "")
    assert "matplotlib and Pillow, which are not installed here: run `pip install matplotlib Pillow`" in err
    monkeypatch.setattr(optional, "find_spec", lambda name: None if name == "PIL" else name)
    status, out, err = run("figures", "--only", "model", "--out", tmp_path)
    assert "drawing needs Pillow, which is not installed here: run `pip install Pillow`" in err
    assert not list(tmp_path.iterdir())
