"""Plots, exports and SI units on the command line; models, completion, help and version."""

import csv
import io
import json
import math
import shutil
import subprocess

import pytest

import stridemap
from stridemap.cli.completion import SHELLS
from stridemap.solver.model.loading import available, load
from tests.oracles.states import need
from tests.oracles.sweeping import Inline

SIZE = ["--units", "leg_length=0.75,mass=32"]
STIFFNESS = 32 * 9.80665 / 0.75
SECOND = math.sqrt(0.75 / 9.80665)


# -- plot and export -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("kind", "begin"), [("svg", b"<?xml"), ("png", b"\x89PNG"), ("pdf", b"%PDF")], ids=["svg", "png", "pdf"]
)
def test_plot(run, done, kind, begin):
    pytest.importorskip("matplotlib")
    words = ["plot", done / "out", "--x", "omega", "--y", "cot", "--colour", "spectral_radius"]
    out = done / f"f.{kind}"
    assert run(*words, "--where", "stable", "--out", out) == (0, f"{out}\n", "")
    content = out.read_bytes()
    assert content.startswith(begin)
    run(*words, "--where", "stable", "--out", out)
    assert out.read_bytes() == content
    if kind == "svg":
        assert b"cost of transport" in content
        assert b"oscillator frequency" in content


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("--x omega --y cott", ["there is no column 'cott' (did you mean cot?); columns are"]),
        ("--x omega --y group", ["group holds no numbers, so that it cannot be an axis"]),
        ("--x omega --y cot --colour colour", ["there is no column 'colour'"]),
        ("--x omega --y cot --where stabel", ["there is no column stabel (did you mean stable?)"]),
        ("--x omega --y cot --where omega=3", ["equality is written =="]),
        ("--x omega --y cot --where omega>9", ["there is nothing to draw: of 2 rows none with omega>9"]),
        ("--x omega --y cot --units mass=3", ["--units: leg_length is missing"]),
        ("--x omega --y cot --units 3", ["--units '3' is not understood"]),
        ("--x omega --y cot --out f.xyz", ["f.xyz has no ending that names a kind of picture"]),
        ("--x omega", ["Missing option '--y'"]),
    ],
)
def test_plots_that_are_refused(refused, done, monkeypatch, line, words):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(done)
    refused(["plot", "out", *([] if "--out" in line else ["--out", "f.svg"]), *line.split()], *words)


def test_export_beside_the_table_and_elsewhere(run, refused, done):
    folder = done / "out"
    status, out, _ = run("export", folder, "--to", "csv")
    assert (status, out.split()) == (0, [str(folder / "orbits.csv"), str(folder / "orbits_columns.csv")])
    first = next(iter(csv.DictReader(io.StringIO((folder / "orbits.csv").read_text()))))
    assert float(first["omega"]) == 2.5
    assert run("export", folder, "--out", done / "si.csv", *SIZE)[0] == 0
    again = next(iter(csv.DictReader(io.StringIO((done / "si.csv").read_text()))))
    assert float(again["period"]) == pytest.approx(float(first["period"]) * SECOND, rel=1e-14)
    assert run("export", folder, "--to", "nc", "--where", "omega > 9")[0] == 1  # nothing left
    before = (folder / "orbits.parquet").read_bytes()
    refused(["export", folder, "--to", "parquet"], "name of a table that a sweep wrote")
    refused(["export", folder, "--to", "csv", "--out", "t.mat"], "--out t.mat does not end in .csv")
    refused(["export", folder, "--to", "xls"], "--to xls is not a kind of file; kinds are csv, mat, nc")
    refused(["export", folder], "say what to write: --to csv")
    assert (folder / "orbits.parquet").read_bytes() == before


# -- SI units ------------------------------------------------------------------------------------------------


def test_orbit_in_si_units(run):
    k = 6 * STIFFNESS
    words = ["orbit", "--k", repr(k)]
    plain = json.loads(run("orbit", "--k", repr(k / STIFFNESS), "--json")[1])
    found = json.loads(run(*words, *SIZE, "--json")[1])
    assert list(found) == ["model", "units", "params", "orbits", "search"]
    assert found["units"] == {"leg_length": 0.75, "mass": 32.0, "gravity": 9.80665}
    assert found["params"]["k"] == k  # as it was given, to the bit
    for one, other in zip(found["orbits"], plain["orbits"], strict=True):
        assert one["period"] == pytest.approx(other["period"] * SECOND, rel=1e-12)
        assert one["state"]["dx"] == pytest.approx(other["state"]["dx"] * 0.75 / SECOND, rel=1e-9)
        assert one["work"] == pytest.approx(other["work"] * 32 * 9.80665 * 0.75, rel=1e-12)
        assert one["multipliers"] == other["multipliers"]
        assert one["cot"] == other["cot"]
    _, table, _ = run(*words, *SIZE)
    (row,) = [line for line in table.splitlines() if line.startswith("step_length")]
    assert row.split()[3] == "m"
    assert float(row.split()[1]) == pytest.approx(found["orbits"][0]["step_length"], abs=1e-9)
    status, text, err = run(*words, *SIZE, "--csv")
    rows = list(csv.DictReader(io.StringIO(text)))
    assert (status, err, len(rows)) == (0, "", 2)
    assert [float(row["speed"]) for row in rows] == [one["speed"] for one in found["orbits"]]


def test_find_in_si_units(run):
    target = 0.16 * 0.75 / SECOND
    words = ["find", "--vary", "k", "--range", repr(5 * STIFFNESS), repr(7 * STIFFNESS), "--starts", "64"]
    found = json.loads(run(*words, "--target", f"speed = {target!r}", *SIZE, "--json")[1])
    own = stridemap.find(
        "wobbling", "speed = 0.16", vary="k", range=(5, 7), options=stridemap.SearchOptions(64)
    )
    assert found["target"]["value"] == pytest.approx(target)
    assert len(found["orbits"]) == len(own.values) > 0
    for one, k in zip(found["orbits"], own.values, strict=True):
        assert one["params"]["k"] == pytest.approx(k * STIFFNESS, rel=1e-9)
        assert one["speed"] == pytest.approx(target, rel=1e-9)


def test_what_cannot_be_given_together(refused):
    refused("orbit --json --csv", "--json and --csv cannot be given together")
    refused("orbit --units leg_length=1,mass=2,mass=3", "mass is given twice")
    refused("orbit --k -1 --units leg_length=1,mass=2", "outside the allowed range")


# -- models, completion, help --------------------------------------------------------------------------------


def test_models(run, refused):
    status, out, err = run("models")
    assert (status, err) == (0, "")
    for name in available():
        spec = load(name).spec
        assert f"{name}: {spec.title}\n" in out
        assert all(a.meaning in out for a in spec.parameters)
    found = json.loads(run("models", "--json")[1])["models"]
    assert [one["name"] for one in found] == list(available())
    (wheel,) = json.loads(run("models", "rimless_wheel", "--json")[1])["models"]
    assert wheel in found
    assert {a["name"]: a["preset"] for a in wheel["parameters"]} == load("rimless_wheel").preset
    assert [a["counts"] for a in wheel["parameters"]] == [False, True, False]
    refused("models nix", "there is no model 'nix'")


def test_help_is_printed_by_default_and_whole(run):
    status, out, err = run()
    assert (status, err) == (0, "")
    assert run("--help") == (0, out, "")
    assert "..." not in out.partition("\n")[2]
    assert "Find the value of a parameter for which a limit cycle has a wanted speed" in " ".join(out.split())


def test_version(run):
    assert run("--version") == run("version") == (0, f"{stridemap.__version__}\n", "")


def completed(script, line):
    """What bash completes at the end of a line: the script is read and its function called as bash does."""
    words = line.split(" ")
    program = f"""{script}
COMP_WORDS=({" ".join(f"'{word}'" for word in words)}); COMP_CWORD={len(words) - 1}
_stridemap; printf '%s\\n' "${{COMPREPLY[@]}}" """
    bash = [need("bash"), "--norc", "-c", program]
    return subprocess.run(bash, capture_output=True, text=True, check=True).stdout.split()


def test_completion_in_bash(run, tmp_path, monkeypatch):
    status, script, err = run("completion", "bash")
    assert (status, err) == (0, "")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "my.py").touch()
    assert completed(script, "stridemap orb") == ["orbit"]
    assert completed(script, "stridemap orbit --search") == ["--search", "--search-box"]
    assert completed(script, "stridemap orbit --model rim") == ["rimless_wheel"]
    assert completed(script, "stridemap orbit --model my") == ["my.py"]
    assert completed(script, "stridemap orbit --al") == ["--alpha"]
    assert completed(script, "stridemap orbit --model rimless_wheel --sp") == ["--spokes"]
    assert completed(script, "stridemap orbit --model = rimless_wheel --sp") == ["--spokes"]
    assert completed(script, "stridemap branch --vary Kp") == ["Kp"]
    assert completed(script, "stridemap export --t") == ["--to"]
    assert completed(script, "stridemap report m") == ["my.py"]
    assert completed(script, "stridemap models simp") == ["simplest_walker"]
    assert completed(script, "stridemap completion z") == ["zsh"]
    assert completed(script, "stridemap --ver") == ["--version"]


@pytest.mark.parametrize("shell", SHELLS)
def test_completion_has_every_command_and_balanced_quotes(run, refused, shell):
    _, script, _ = run("completion", shell)
    _, help_, _ = run()
    commands = [line.split()[0] for line in help_.partition("Commands:")[2].splitlines() if line[2:3].strip()]
    assert all(command in script for command in commands)
    assert all(line.count("'") % 2 == 0 for line in script.splitlines())
    refused("completion tcsh", "'tcsh' is not a shell that can be completed for; shells are bash, zsh, fish")
    if shutil.which(shell):
        subprocess.run([shell, "-n"], input=script, text=True, check=True)


# -- walks and branches --------------------------------------------------------------------------------------


def test_a_walk_in_si_units(run, done):
    words = ["simulate", "--steps", "1", "--k", repr(6 * STIFFNESS)]
    file = done / "walk.parquet"
    walk = json.loads(run(*words, *SIZE, "--trajectory", file, "--rate", "200", "--json")[1])
    (own,) = stridemap.simulate("wobbling", steps=1, k=6).steps
    (step,) = walk["steps"]
    assert step["period"] == pytest.approx(own.period * SECOND, rel=1e-9)
    assert step["state"]["dx"] == pytest.approx(own.state["dx"] * 0.75 / SECOND, rel=1e-9)
    assert walk["params"]["k"] == pytest.approx(6 * STIFFNESS)
    table = stridemap.read_table(file)
    assert table.columns["x"].unit == "m"
    assert table.frame["time"][:3].tolist() == pytest.approx([0, 0.005, 0.01])
    state = [word for name, value in step["state"].items() for word in ("--state", f"{name}={value!r}")]
    again = json.loads(run(*words, *SIZE, *state, "--json")[1])["steps"][0]
    assert again["period"] == pytest.approx(step["period"], rel=1e-8)


def test_points_of_branches_as_comma_separated_values(run, refused):
    words = [
        "branch",
        "--model",
        "rimless_wheel",
        "--vary",
        "slope",
        "--range",
        "0.18",
        "0.2",
        "--seeds",
        "2",
    ]
    status, text, err = run(*words, "--csv")
    rows = list(csv.DictReader(io.StringIO(text)))
    assert (status, err) == (0, "")
    assert {"branch", "arclength", "slope", "period", "gait"} <= set(rows[0])
    assert all(0.18 <= float(row["slope"]) <= 0.2 for row in rows)
    refused(
        ["derive", "compass", "--out", "c", "--cycle", "stable", *SIZE],
        "--units is not an option of this command", "stridemap orbit --units",
    )  # fmt: skip


def test_exports_stream_what_a_whole_table_would_write(run, done, tmp_path, monkeypatch):
    """Batch by batch the files are the same, also of a part and in SI units."""
    from stridemap.sweeps import files

    monkeypatch.setattr(files, "GROUP_ROWS", 1)
    folder = tmp_path / "pieces"
    stridemap.sweep(done / "small.toml", folder, executor=Inline())
    assert len(list(stridemap.read_batches(folder))) == 2
    table = stridemap.read_table(folder)
    table.export(tmp_path / "whole.csv")
    assert run("export", folder, "--out", tmp_path / "streamed.csv")[0] == 0
    for ending in (".csv", "_columns.csv"):
        assert (tmp_path / f"streamed{ending}").read_bytes() == (tmp_path / f"whole{ending}").read_bytes()
    words = ["--columns", "omega,cot,group", "--where", "stable", *SIZE]
    assert run("export", folder, *words, "--out", tmp_path / "part.parquet")[0] == 0
    part = stridemap.read_table(tmp_path / "part.parquet")
    wanted = stridemap.read_table(folder, units=stridemap.Units(0.75, 32.0)).where("stable")
    assert list(part.columns) == ["omega", "cot", "group"]
    assert part.columns["omega"].unit == "rad/s"
    assert part.model == table.model
    for name in part.columns:
        assert part.frame[name].tolist() == wanted.frame[name].tolist()
    assert run("export", folder, "--where", "omega > 9", "--out", tmp_path / "none.csv")[0] == 1
    assert (tmp_path / "none.csv").read_text().splitlines() == [",".join(table.columns)]


def test_an_export_that_fails_leaves_what_was_there(refused, done, tmp_path):
    elsewhere = tmp_path / "elsewhere"
    (elsewhere / "folder.csv").mkdir(parents=True)
    (elsewhere / "o.csv").write_text("mine")
    refused(["export", done / "out", "--out", elsewhere / "o.csv", "--columns", "cott"], "did you mean cot?")
    assert (elsewhere / "o.csv").read_text() == "mine"
    refused(["export", done / "out", "--out", elsewhere / "folder.csv"], "cannot write", "it is not a file")
    assert sorted(path.name for path in elsewhere.iterdir()) == ["folder.csv", "o.csv"]
