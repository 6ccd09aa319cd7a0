"""Models of the user's own: a file that declares a walker, from the command line, in sweeps and from Python.

The model is McGeer's rimless wheel, whose limit cycle is known in closed form.
"""

import json
import math
import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import stridemap
from stridemap.codegen import declared
from tests.oracles.sweeping import STRIDEMAP, Inline, content

pytestmark = pytest.mark.usefixtures("in_this_process")

WHEEL = """
import sympy as sp

from stridemap.derive import STANCE_FOOT, Body, Coordinate, Parameter, Touchdown, Walker

THETA = Coordinate("theta", "rad", "angle of the stance spoke, positive leaning ahead")
SLOPE = Parameter("slope", 0.2, "rad", "angle by which the ground falls", 0.0, 1.5)
INERTIA = Parameter("inertia", 0.5, "m l^2", "moment of inertia about the hub", 0.0)
theta, slope = THETA.symbol, SLOPE.symbol


def spoke(angle):
    return sp.Matrix([sp.sin(angle), sp.cos(angle)])


hub = STANCE_FOOT + spoke(theta)

WALKER = Walker(
    name="wheel",
    title="Rimless wheel",
    reference="T. McGeer, Int. J. Robotics Research 9 (1990) 62-82",
    coordinates=(THETA,),
    parameters=(SLOPE, INERTIA),
    bodies=(Body("hub", sp.Integer(1), hub, inertia=INERTIA.symbol, angle=theta),),
    gravity=sp.Matrix([sp.sin(slope), -sp.cos(slope)]),
    swing_foot=hub - spoke(theta - sp.pi / 3),
    touchdown=Touchdown(sp.cos(sp.pi / 6) - sp.cos(theta), region=-theta),
    relabel={theta: theta - sp.pi / 3},
    stance_angle=THETA,
    search_box={"theta": (-0.5, 0.5), "dtheta": (0.5, 1.0)},
    period_range=(0.1, 8.0),
)
"""
SWEEP = 'model = "models/wheel.py"\n[grid]\nslope = [0.15, 0.2, 0.25]\n[search]\nstarts = 16\n'


def closed_form(slope, inertia=0.5, spokes=6):
    """Rate just after impact, and the multiplier (M. J. Coleman, Dynamical Systems 25 (2010) 215-238)."""
    lambda2 = 1 / (1 + inertia)
    mu = 1 + lambda2 * (math.cos(2 * math.pi / spokes) - 1)
    return mu * math.sqrt(4 * lambda2 * math.sin(math.pi / spokes) * math.sin(slope) / (1 - mu**2)), mu**2


@pytest.fixture(scope="module", autouse=True)
def cache(tmp_path_factory):
    """A cache of our own, shared by the tests of this file."""
    folder = tmp_path_factory.mktemp("cache")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("STRIDEMAP_CACHE", str(folder))
        yield folder


@pytest.fixture
def home(tmp_path, monkeypatch):
    """A folder to work in, with the model in models/wheel.py and a sweep of it in sweep.toml."""
    (tmp_path / "models").mkdir()
    (tmp_path / "models" / "wheel.py").write_text(WHEEL)
    (tmp_path / "sweep.toml").write_text(SWEEP)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def declare(folder, text, name="wheel.py"):
    (folder / "models" / name).write_text(text)
    return f"models/{name}"


# -- from the file to limit cycles ---------------------------------------------------------------------------


def test_orbit_of_a_model_file(run, home):
    status, out, err = run(
        "orbit", "--model", "models/wheel.py", "--set", "slope=0.3", "--inertia", "0.2", "--json"
    )
    assert (status, err) == (0, "")
    found = json.loads(out)
    assert found["model"] == "models/wheel.py"
    assert found["params"] == {"slope": 0.3, "inertia": 0.2}
    (orbit,) = found["orbits"]
    rate, multiplier = closed_form(0.3, 0.2)
    assert orbit["state"]["dtheta"] == pytest.approx(rate, abs=1e-12)
    assert orbit["state"]["theta"] == pytest.approx(-math.pi / 6, abs=1e-12)
    assert orbit["multipliers"][0][0] == pytest.approx(multiplier, abs=1e-11)


def test_derive_out_and_the_folder_as_a_model(run, home):
    status, out, err = run("derive", "models/wheel.py", "--out", "mine")
    assert (status, err) == (0, "")
    names = "README.md example.c manifest.json wheel.c wheel.h wheel.js wheel.py wheel_kernels.c".split()
    names += ["wheel_step.c", "wheel_step.h"]
    assert out.split() == [f"mine/{name}" for name in names]
    assert sorted(p.name for p in (home / "mine").iterdir()) == names
    shutil.rmtree(home / "models")  # the folder is all that is needed
    status, out, _ = run("orbit", "--model", "mine", "--json")
    (orbit,) = json.loads(out)["orbits"]
    assert orbit["state"]["dtheta"] == pytest.approx(closed_form(0.2)[0], abs=1e-12)
    status, out, _ = run("simulate", "--model", "mine", "--steps", "3", "--json")
    walked = json.loads(out)
    assert (status, walked["outcome"], len(walked["steps"])) == (0, "walked", 3)
    assert walked["steps"][-1]["state"] == pytest.approx(orbit["state"], abs=1e-8)


def test_the_generated_c_of_an_own_model_compiles_and_runs(run, home):
    run("derive", "models/wheel.py", "--out", "mine")
    warnings = "-std=c99 -pedantic -Wall -Wextra -Werror".split()
    subprocess.run(["cc", *warnings, "mine/example.c", "mine/wheel.c", "-o", "example", "-lm"], check=True)
    assert subprocess.run([home / "example"], capture_output=True, check=True).stdout


def test_derive_into_the_cache_happens_once(run, home, cache):
    _, first, _ = run("derive", "models/wheel.py")
    manifest = next(line for line in first.split() if line.endswith("manifest.json"))
    assert manifest.startswith(str(cache))
    made = os.stat(manifest).st_mtime_ns
    assert run("derive", "models/wheel.py")[1] == first
    assert os.stat(manifest).st_mtime_ns == made


def test_a_changed_file_is_derived_anew(home):
    before = stridemap.find_orbits("models/wheel.py")
    declare(home, WHEEL.replace('"slope", 0.2', '"slope", 0.3'))
    (after,) = stridemap.find_orbits("models/wheel.py")
    assert before[0].params["slope"] == 0.2
    assert after.state["dtheta"] == pytest.approx(closed_form(0.3)[0], abs=1e-12)


def test_a_changed_neighbour_is_derived_anew(home):
    declare(home, "DEFAULT = 0.2\n", "numbers_of_mine.py")
    path = declare(home, WHEEL.replace('"slope", 0.2', '"slope", numbers_of_mine.DEFAULT').replace(
        "import sympy as sp", "import sympy as sp\nimport numbers_of_mine"))  # fmt: skip
    assert stridemap.load(path).preset["slope"] == 0.2
    declare(home, "DEFAULT = 0.3\n", "numbers_of_mine.py")
    assert stridemap.load(path).preset["slope"] == 0.3
    assert declared(home / path).parameters[0].default == 0.3  # in this process, too
    declare(home, "DEFAULT = 0.4\n", "numbers_of_mine.py")
    assert declared(home / path).parameters[0].default == 0.4


def test_help_lists_the_parameters_of_the_model_file(run, home):
    _, out, _ = run("orbit", "--model", "models/wheel.py", "--help")
    assert "moment of inertia about the hub [m l^2]" in " ".join(out.split())
    assert "--Kp" not in out


# -- from Python ---------------------------------------------------------------------------------------------


def test_a_walker_made_in_python(home, cache):
    walker = declared(home / "models" / "wheel.py")
    model = stridemap.derive_model(walker)
    assert Path(model.files.shown).is_relative_to(cache)
    (orbit,) = stridemap.find_orbits(model, slope=0.25)
    assert orbit.state["dtheta"] == pytest.approx(closed_form(0.25)[0], abs=1e-12)
    motion = stridemap.motion(orbit)
    assert motion.coordinate("theta")[-1] == pytest.approx(math.pi / 6, abs=1e-10)
    assert stridemap.load(model) is model
    assert stridemap.simulate(model, steps=2, slope=0.25).steps[-1].period == pytest.approx(orbit.period)


def test_out_is_written_anew_and_loaded_anew(home):
    walker = declared(home / "models" / "wheel.py")
    first = stridemap.derive_model(walker, "mine")
    slope, inertia = walker.parameters
    second = stridemap.derive_model(walker.with_(parameters=(inertia, slope)), home / "mine")
    assert [p.name for p in first.parameters] == ["slope", "inertia"]
    assert [p.name for p in second.parameters] == ["inertia", "slope"]
    (orbit,) = stridemap.find_orbits("mine", slope=0.3)
    assert orbit.state["dtheta"] == pytest.approx(closed_form(0.3)[0], abs=1e-12)
    with pytest.raises(stridemap.InputError, match="is not the file that manifest.json names"):
        stridemap.find_orbits(first)  # its files are gone


# -- sweeps --------------------------------------------------------------------------------------------------


def test_sweep_with_two_workers_finds_the_closed_form_and_tells_no_paths(run, home, tmp_path_factory):
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    os.chdir(elsewhere)  # the model's path is meant from the folder of the TOML file
    status, out, err = run("sweep", home / "sweep.toml", "--out", home / "out", "--workers", "2")
    assert (status, "3 limit cycles (3 stable) in 3 cells" in out) == (0, True), err
    table = stridemap.read_orbits(home / "out")
    np.testing.assert_allclose(table.dtheta, [closed_form(s)[0] for s in table.slope], rtol=0, atol=1e-12)
    told = (home / "out" / "orbits.parquet").read_bytes() + (home / "out" / "cells.parquet").read_bytes()
    for word in (str(home), str(elsewhere), "wheel.py", os.environ["STRIDEMAP_CACHE"]):
        assert word.encode() not in told, word
    os.chdir(home)
    one = stridemap.sweep("sweep.toml", "again", executor=Inline())
    assert one.orbits == 3
    assert content(home / "again") == content(home / "out")
    assert run("sweep", "sweep.toml", "--out", "out", "--resume")[0] == 0


def test_to_resume_with_a_changed_model_is_refused(run, refused, home):
    stridemap.sweep("sweep.toml", "out", executor=Inline())
    before = content(home / "out")
    declare(home, WHEEL.replace("sp.pi / 3", "2 * sp.pi / 7").replace("sp.pi / 6", "sp.pi / 7"))
    refused("sweep sweep.toml --out out --resume", "out", "different software", "model_hash")
    assert content(home / "out") == before


def test_a_folder_as_the_model_of_a_sweep(run, home):
    run("derive", "models/wheel.py", "--out", "models/mine")
    (home / "sweep.toml").write_text(SWEEP.replace("wheel.py", "mine"))
    assert stridemap.sweep("sweep.toml", "out", executor=Inline()).orbits == 3


# -- what cannot be used -------------------------------------------------------------------------------------


COMMANDS = ("orbit --model models/wheel.py", "derive models/wheel.py", "sweep sweep.toml --out out")
"""All of them run the file in the same way: one sentence is tried with each, the others with one of them."""


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("x = 1\n", ["has no WALKER", "WALKER = Walker(...)"]),
        ("WALKER = 'wheel'\n", ["WALKER that is a str"]),
        ("import sympy\nWALKER = (\n", ["line 2", "SyntaxError", "never closed"]),
        ("import sympy\n\nsympy.no_such_thing\n", ["line 3", "AttributeError", "no_such_thing"]),
        ("import not_there\n", ["line 1", "ModuleNotFoundError", "not_there"]),
        ("def f():\n    return 1 / 0\n\nf()\n", ["line 2", "ZeroDivisionError"]),
        ("import sys\nsys.exit(3)\n", ["line 2", "SystemExit"]),
        ("assert False\n", ["line 1", "AssertionError"]),
        ("\x00", ["SyntaxError"]),
        (WHEEL.replace("1), hub, inertia", "2) * sp.Symbol('m'), hub, inertia"), ["symbol m", "Parameter("]),
        (
            WHEEL.replace("relabel={theta: theta", "relabel={theta: 2 * theta"),
            ["not its own inverse", "theta"],
        ),
        (WHEEL.replace("    relabel={theta: theta - sp.pi / 3},\n", ""), ["TypeError", "'relabel'"]),
    ],
)
def test_a_file_that_declares_no_walker(refused, home, text, words):
    declare(home, text)
    for command in COMMANDS if text == "x = 1\n" else [COMMANDS[len(text) % len(COMMANDS)]]:
        refused(command, "wheel", *words)
    assert not (home / "out").exists()


def test_the_line_is_that_of_the_file_itself(refused, home):
    declare(home, "(\n", "broken.py")
    declare(home, "import sympy\n\nimport broken\n")
    refused("derive models/wheel.py", "models/wheel.py, line 3", "SyntaxError", "broken.py, line 1")


def test_a_file_that_is_missing(refused, home):
    for command in (
        "orbit --model nowhere.py",
        "derive nowhere.py",
        "derive models",
        "simulate --model models.py",
    ):
        refused(command, command.split()[-1].removesuffix(".py"), "cannot read the model file")
    (home / "sweep.toml").write_text(SWEEP.replace("wheel.py", "nowhere.py"))
    refused("sweep sweep.toml --out out", "nowhere.py", "cannot read the model file")


def test_parameters_of_the_model_file_are_checked(refused, home):
    refused("orbit --model models/wheel.py --k 6", "wheel has no parameter 'k'", "slope, inertia")
    refused("orbit --model models/wheel.py --slope 2", "slope = 2", ">= 0 and <= 1.5")
    (home / "sweep.toml").write_text(SWEEP.replace("slope =", "slop ="))
    refused("sweep sweep.toml --out out", "slop", "did you mean slope?")


def test_an_edited_file_of_an_own_model_is_refused_until_it_is_derived_again(run, refused, home):
    run("derive", "models/wheel.py", "--out", "mine")
    kernels = home / "mine" / "wheel_kernels.c"
    kernels.write_text(kernels.read_text().replace("1.", "2.", 1))
    refused("orbit --model mine", kernels.name, "is not the file", f"--out {home / 'mine'}")
    run("derive", "models/wheel.py", "--out", "mine")
    assert run("orbit", "--model", "mine")[0] == 0


@pytest.mark.parametrize(("name", "end"), [("edited", ".py"), ("changed", "_kernels.c")])
def test_an_edited_file_in_the_cache_is_refused_until_it_is_derived_again(run, refused, home, name, end):
    declare(home, WHEEL.replace('"wheel"', f'"{name}"'))
    path = next(path for path in run("derive", "models/wheel.py")[1].split() if path.endswith(name + end))
    with open(path, "a") as file:
        file.write("\n")
    refused("orbit --model models/wheel.py", path, "run `stridemap derive models/wheel.py`")
    assert run("derive", "models/wheel.py")[0] == 0
    assert run("orbit", "--model", "models/wheel.py", "--backend", "interpreter")[0] == 0


def test_derive_overwrites_nothing_of_somebody_else(refused, home):
    (home / "README.md").write_text("mine")
    refused("derive models/wheel.py --out .", "README.md", "would be overwritten", "another folder")
    assert (home / "README.md").read_text() == "mine"


def test_folders_that_cannot_be_written(refused, home, monkeypatch):
    refused("derive models/wheel.py --out sweep.toml/x", "cannot write sweep.toml/x")
    monkeypatch.setenv("STRIDEMAP_CACHE", str(home / "sweep.toml"))
    refused("orbit --model models/wheel.py", "cannot write", "STRIDEMAP_CACHE")


def test_without_a_compiler(home, tmp_path):
    tools = tmp_path / "tools"
    tools.mkdir()
    command = [*STRIDEMAP, "orbit", "--model", "models/wheel.py", "--starts", "8", "--json"]
    environment = {**os.environ, "PATH": str(tools)}
    environment.pop("CC", None)
    run = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert "no C compiler" in run.stderr
    (orbit,) = json.loads(run.stdout)["orbits"]
    assert orbit["state"]["dtheta"] == pytest.approx(closed_form(0.2)[0], abs=1e-12)


def test_two_processes_that_derive_the_same_at_once(home, tmp_path):
    environment = {**os.environ, "STRIDEMAP_CACHE": str(tmp_path / "fresh")}
    command = [*STRIDEMAP, "orbit", "--model", "models/wheel.py", "--backend", "interpreter", "--json"]
    both = [subprocess.Popen(command, env=environment, stdout=subprocess.PIPE) for _ in range(2)]
    said = [process.communicate()[0] for process in both]
    assert [process.returncode for process in both] == [0, 0]
    assert said[0] == said[1]
    assert len(list((tmp_path / "fresh" / "models").iterdir())) == 1
