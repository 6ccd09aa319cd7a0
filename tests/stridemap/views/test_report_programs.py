"""The report's programs without a browser: they start, draw by role, and show every quantity."""

import json
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

import stridemap
from stridemap.spec import Line, Mass
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.run import sweep
from stridemap.views import write_report
from tests.oracles.sweeping import Inline

PROGRAM = Path(__file__).parents[2] / "oracles" / "page_without_browser.js"
GRIDS = {
    "wobbling": {"k": [6.0, 22.5], "alpha": [0.25, 0.3]},
    "compass": {"omega": [2.5, 3.0]},
    "goswami_compass": {"slope": [0.03, 0.05]},
    "rimless_wheel": {"slope": [0.2, 0.3]},
    "simplest_walker": {"slope": [0.004, 0.009]},
}


@pytest.fixture(scope="module", params=list(GRIDS))
def swept(request, tmp_path_factory):
    """A model's name, a folder with a sweep of it in `out`, and what its page does."""
    folder = tmp_path_factory.mktemp(request.param)
    config = parse_config({"model": request.param, "grid": GRIDS[request.param], "search": {"starts": 32}})
    sweep(config, folder / "out", executor=Inline())
    return request.param, folder, shown(folder)


def node():
    """Node.js, from the path or with Playwright."""
    if found := shutil.which("node"):
        return found
    return pytest.importorskip("playwright._impl._driver").compute_driver_executable()[0]


def shown(folder):
    """What the page of the sweep does."""
    write_report(folder / "out", folder / "page.html")
    command = [node(), PROGRAM, folder / "page.html"]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def colours(seen):
    """Colours of the lines that are thicker than an outline, and of the discs, in order."""
    strokes = [entry[1] for entry in seen["walker"] if entry[0] == "stroke" and entry[2] != 1.5]
    return strokes, [entry[1] for entry in seen["walker"] if entry[0] == "fill"]


def test_the_page_starts_and_integrates(swept):
    _, _, seen = swept
    assert seen["ready"] == "yes"
    assert seen["closing"] < 1e-10
    assert seen["now"].startswith("t = 0.000")


def test_every_quantity_can_colour_the_map(swept):
    """Those that are equal in all cycles but for rounding, too."""
    texts = swept[2]["texts"]
    assert {"stability", "count", "period", "d_max", "cot"} <= set(texts)
    assert all(colour == now for colour, (now, _, cells) in texts.items())
    assert all(cells > 0 for _, _, cells in texts.values())


def test_the_walker_is_drawn_by_roles(swept, monkeypatch):
    name, folder, seen = swept
    legs = ["stance", "swing"]
    lines = {"wobbling": [*legs, "spring"], "rimless_wheel": ["stance"] * 3}.get(name, legs)
    # The heaviest first: the hip, which is drawn as the legs that meet there.
    discs = {
        "wobbling": ["stance", "mass", *legs],
        "goswami_compass": ["stance", "body", "body"],
        "rimless_wheel": ["body"],
    }.get(name, ["stance", *legs])
    assert colours(seen) == (lines, discs)
    model = stridemap.load(name)
    renamed = tuple(Mass(f"part {i}", mass.role) for i, mass in enumerate(model.spec.masses))
    monkeypatch.setattr(model, "spec", replace(model.spec, masses=renamed))
    assert colours(shown(folder)) == (lines, discs)
    bodies = tuple(Mass(mass.name, "body") for mass in model.spec.masses)
    parts = tuple(Line(line.name, "part") for line in model.spec.lines)
    monkeypatch.setattr(model, "spec", replace(model.spec, masses=bodies, lines=parts))
    assert colours(shown(folder)) == (["stance"] * len(lines), ["body"] * len(discs))
