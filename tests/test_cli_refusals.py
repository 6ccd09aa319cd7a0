"""Bad input on the command line: one sentence that names it, status 2, and nothing is lost."""

import shutil
import sys
import warnings
from pathlib import Path

import pandas as pd
import pytest
from sweep_support import STRIDEMAP, Inline, content, ended, start

import stridemap
from stridemap.cli import main
from stridemap.solver import library
from stridemap.solver.model import GENERATED, load
from stridemap.sweeps.config import load_config
from stridemap.sweeps.run import sweep

SMALL = 'model = "compass"\n[grid]\nomega = [2.5, 3.0]\n[search]\nstarts = 16\n'


@pytest.fixture
def refused(monkeypatch, capsys):
    """Run the command line in this process; it must refuse in one sentence that contains `words`."""

    def command(line, *words):
        line = line.split() if isinstance(line, str) else list(map(str, line))
        monkeypatch.setattr(sys, "argv", ["stridemap", *line])
        monkeypatch.setattr(warnings, "showwarning", warnings.showwarning)  # main() sets its own
        with pytest.raises(SystemExit) as exit_:
            main()
        out, err = capsys.readouterr()
        assert (exit_.value.code, out) == (2, "")
        assert err.startswith("error: ")
        assert err.count("\n") == 1
        assert err.endswith("\n")
        assert "Traceback" not in err
        assert [word for word in map(str, words) if word not in err] == []
        return err

    return command


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """A configuration and a finished sweep of it, to be copied."""
    folder = tmp_path_factory.mktemp("finished")
    (folder / "small.toml").write_text(SMALL)
    sweep(folder / "small.toml", folder / "out", executor=Inline())
    return folder


@pytest.fixture
def done(finished, tmp_path):
    """A copy of the finished sweep."""
    shutil.copytree(finished, tmp_path, dirs_exist_ok=True)
    return tmp_path


# -- parameters and options ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("--alpa 0.3", ["alpa", "did you mean alpha?", "k, alpha, omega, beta, Kp, Kd, S, gamma"]),
        ("--set omeg=3", ["omeg", "did you mean omega?"]),
        ("--set zeta=1", ["zeta", "its parameters are k, alpha"]),
        ("--model compass --k 3", ["compass", "'k'", "omega, beta, Kp, Kd, S, gamma"]),
        ("--alpha 0", ["alpha = 0 ", "> 0 and < 1"]),
        ("--alpha 1", ["alpha = 1 ", "> 0 and < 1"]),
        ("--set alpha=-0.25", ["alpha = -0.25 ", "> 0 and < 1"]),
        ("--beta -0.15", ["beta = -0.15 ", "> 0"]),
        ("--beta=0", ["beta = 0 ", "> 0"]),
        ("--k -6", ["k = -6 ", ">= 0"]),
        ("--Kp=-1", ["Kp = -1 ", ">= 0"]),
        ("--Kd -0.5", ["Kd = -0.5 ", ">= 0"]),
        ("--omega 0", ["omega = 0 ", "> 0"]),
        ("--omega -3", ["omega = -3 ", "> 0"]),
        ("--k nan", ["k = nan ", ">= 0"]),
        ("--gamma nan", ["gamma = nan ", "any finite number"]),
        ("--S inf", ["S = inf ", "any finite number"]),
        ("--set k=-inf", ["k = -inf ", ">= 0"]),
        ("--k 1e999", ["k = inf ", ">= 0"]),
        ("--k six", ["k = 'six'", "not a number", ">= 0"]),
        ("--alpha 0,25", ["alpha = '0,25'", "not a number", "> 0 and < 1"]),
        ("--k=", ["k = ''", "not a number"]),
        ("--set k", ["'k'", "--set NAME=VALUE"]),
        ("--set =3", ["'=3'", "--set NAME=VALUE"]),
        ("--k", ["--k needs a value"]),
        ("--k --alpha 0.3", ["--k needs a value"]),
        ("--k 3 --k 3", ["k is given twice"]),
        ("--k 3 --set k=4", ["k is given twice"]),
        ("--set k=3 --set k=4", ["k is given twice"]),
        ("k=3", ["'k=3'", "--NAME VALUE"]),
        ("-k 3", ["'-k'", "--NAME VALUE"]),
        ("--model wobbeling", ["'wobbeling'", "compass, wobbling"]),
        ("--model ../compass", ["'../compass'", "compass, wobbling"]),
        ("--model", ["--model"]),
    ],
)
@pytest.mark.parametrize("command", ["orbit", "simulate"])
def test_parameters(refused, command, line, words):
    refused(f"{command} {line}", *words)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("orbit --starts 0", ["starts = 0", "at least 1"]),
        ("orbit --starts many", ["--starts", "'many'", "at least 1"]),
        ("simulate --steps 1.5", ["--steps", "'1.5'", "at least 1"]),
        ("orbit --json=yes", ["--json"]),
        ("simulate --steps 0", ["steps = 0", "at least 1"]),
        ("simulate --set steps=3", ["'steps'", "its parameters are"]),
        ("simulate --set model=3", ["'model'", "its parameters are"]),
        ("simulate --state theta1=0.1", ["theta1, dtheta1, dtheta2, x, dx", "missing: dtheta1, dtheta2, dx"]),
        ("simulate --state theta=0.1", ["unknown: theta"]),
        ("simulate --state theta1=1 --state theta1=1", ["theta1 is given twice"]),
        ("simulate --state 0.1", ["'0.1'", "--state NAME=VALUE"]),
        ("simulate --omega 3 --Kp 0 --Kd 0", ["no limit cycle", "give a state"]),
        ("sweep", ["config", "stridemap sweep --help"]),
        ("sweep a.toml", ["--out", "stridemap sweep --help"]),
        ("sweep a.toml --out b --workers two", ["--workers", "'two'", "at least 1"]),
        ("sweep a.toml --out b --workes 2", ["--workes", "--workers"]),
        ("derive --chek", ["--chek", "--check"]),
        ("swep a.toml", ["'swep'"]),
        ("", ["command"]),
    ],
)  # fmt: skip
def test_options_and_commands(refused, line, words):
    refused(line, *words)


@pytest.mark.parametrize(("value", "shown"), [("nan", "nan"), ("-inf", "-inf"), ("left", "left")])
def test_a_state_is_finite_numbers(refused, value, shown):
    entries = [f"theta1={value}", "dtheta1=-0.1", "dtheta2=0", "x=0", "dx=0"]
    line = ["simulate", *(word for entry in entries for word in ("--state", entry))]
    refused(line, "theta1", shown, "no finite number")


@pytest.mark.parametrize("name", ["k", "omega", "Kp", "Kd", "beta", "gamma", "S"])
def test_an_enormous_value_is_no_crash(monkeypatch, capsys, name):
    monkeypatch.setattr(sys, "argv", ["stridemap", "orbit", f"--{name}=1e308", "--starts=4"])
    with pytest.raises(SystemExit) as exit_:
        main()
    assert exit_.value.code == 1
    assert capsys.readouterr() == ("", "no limit cycle found\n")


# -- configurations ------------------------------------------------------------------------------------------

HEAD = 'model = "wobbling"\n'


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[grid]\nomega = [3.0]\n", ["model is missing"]),
        ('model = "woble"\n[grid]\nomega = [3.0]\n', ["woble", "compass, wobbling"]),
        (HEAD + "[gird]\nk = [1.0]\n", ["gird", "did you mean grid?"]),
        (HEAD + "[grid]\nalhpa = [0.3]\n", ["alhpa", "did you mean alpha?"]),
        (HEAD + "[params]\nBeta = 0.2\n[grid]\nk = [1.0]\n", ["Beta", "did you mean beta?"]),
        (HEAD + "[search]\nstart = 3\n[grid]\nk = [1.0]\n", ["start", "did you mean starts?"]),
        (HEAD + "[grid]\nalpha = [0.5, 1.0]\n", ["alpha[1] = 1.0", "> 0 and < 1"]),
        (HEAD + "[params]\nbeta = -0.15\n[grid]\nk = [1.0]\n", ["beta = -0.15", "> 0"]),
        (HEAD + "[grid]\nk = {start = -1.0, stop = 2.0, num = 3}\n", ["start = -1.0", ">= 0"]),
        (HEAD + "[grid]\nomega = [0.0]\n", ["omega[0] = 0.0", "> 0"]),
        (HEAD + "[grid]\nk = [nan]\n", ["k[0] = nan", ">= 0"]),
        (HEAD + "[params]\nS = inf\n[grid]\nk = [1.0]\n", ["S = inf", "any finite number"]),
        (HEAD + '[grid]\nk = ["six"]\n', ["'six'", "finite number"]),
        (HEAD + "[grid]\n", ["[grid] is empty"]),
        (HEAD + "[grid]\nk = []\n", ["k is an empty list"]),
        (HEAD + "[grid]\nk = [1.0, 1.0]\n", ["1.0 more than once"]),
        (
            HEAD + "[grid]\nk = {start = 1, stop = 2, num = 5000}\nS = {start = 0.1, stop = 0.9, num = 5000}",
            ["25,000,000 cells", "5,000 k x 5,000 S", "hours", "max_cells"],
        ),
        (HEAD + "[grid\nk = [1.0]\n", ["not valid TOML", "line 2"]),
        (HEAD + '[grid]\n"k\\nx" = [1.0]\n', ["k x"]),
    ],
)  # fmt: skip
def test_configurations(refused, tmp_path, text, words):
    config = tmp_path / "mine.toml"
    config.write_text(text)
    refused(["sweep", config, "--out", tmp_path / "out"], config, *words)
    assert content(tmp_path).keys() == {"mine.toml"}


def test_unreadable_configurations(refused, tmp_path):
    out = ["--out", tmp_path / "out"]
    (tmp_path / "latin.toml").write_bytes(b'model = "w\xf6bbling"\n')
    refused(["sweep", tmp_path / "latin.toml", *out], "latin.toml", "not UTF-8", "0xf6")
    refused(["sweep", tmp_path / "none.toml", *out], "none.toml", "No such file")
    refused(["sweep", tmp_path, *out], tmp_path, "directory")
    refused(["sweep", tmp_path / "latin.toml" / "below.toml", *out], "below.toml", "cannot read")
    refused(["sweep", "line\nbreak.toml", *out], "line break.toml")
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("workers", [0, -1])
def test_workers(refused, done, workers):
    before = content(done)
    refused(
        ["sweep", done / "small.toml", "--out", done / "out", "--workers", workers],
        f"workers = {workers}",
        "at least 1",
    )
    assert content(done) == before


# -- the output folder ---------------------------------------------------------------------------------------


def test_out_cannot_be_written(refused, done):
    config = done / "small.toml"
    (done / "file").write_text("mine")
    before = content(done)
    places = [done / "file", done / "file" / "below"]
    if Path("/proc/self").exists():
        places.append(Path("/proc/nowhere/out"))
    for place in places:
        for more in ([], ["--resume"]):
            refused(["sweep", config, "--out", place, *more], place, "cannot write")
    assert content(done) == before


@pytest.mark.parametrize("more", [[], ["--resume"]])
def test_out_is_of_another_configuration(refused, done, more):
    (done / "other.toml").write_text(SMALL.replace("2.5", "2.6"))
    before = content(done)
    refused(
        ["sweep", done / "other.toml", "--out", done / "out", *more],
        done / "out",
        "another configuration",
        "grid.omega.0 is 2.5 there, 2.6 here",
    )
    assert content(done) == before


@pytest.mark.parametrize("more", [[], ["--resume"]])
@pytest.mark.parametrize("name", ["orbits.parquet", "cells.parquet"])
@pytest.mark.parametrize("damage", ["truncated", "empty", "text", "foreign"])
def test_out_holds_damaged_or_foreign_files(refused, done, more, name, damage):
    path = done / "out" / name
    if damage == "foreign":
        pd.DataFrame({"cell": [1]}).to_parquet(path)
    else:
        whole = path.read_bytes()
        path.write_bytes({"truncated": whole[:-100], "empty": b"", "text": b"cell,period\n"}[damage])
    before = content(done)
    said = "not one that a sweep wrote" if damage == "foreign" else "damaged or is no Parquet file"
    refused(["sweep", done / "small.toml", "--out", done / "out", *more], path, said)
    assert content(done) == before


def test_out_is_unfinished_and_resume_was_not_asked_for(refused, done):
    config, out = load_config(done / "small.toml"), done / "half"

    def enough(progress):
        if progress.done:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        sweep(config, out, executor=Inline(), progress=enough)
    before = content(out)
    assert before
    refused(["sweep", done / "small.toml", "--out", out], out, "unfinished", "--resume")
    assert content(out) == before


# -- generated files -----------------------------------------------------------------------------------------


@pytest.fixture
def copy(tmp_path, monkeypatch):
    """A copy of the generated folder in place of the package's own."""
    folder = tmp_path / "generated"
    shutil.copytree(GENERATED, folder, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr("stridemap.solver.model.GENERATED", folder)
    load.cache_clear()
    yield folder
    load.cache_clear()


@pytest.mark.parametrize("name", ["compass_kernels.c", "compass.py"])
def test_an_edited_generated_file(refused, done, copy, name):
    path = copy / "compass" / name
    path.write_text(path.read_text() + "\n")
    before = content(done)
    for line in (["orbit", "--model", "compass"], ["sweep", done / "small.toml", "--out", done / "out"]):
        refused(line, path, "not the file that manifest.json names", "stridemap derive")
    assert content(done) == before


def test_a_missing_generated_file(refused, copy):
    (copy / "compass" / "compass_kernels.c").unlink()
    refused("orbit --model compass", "compass_kernels.c", "stridemap derive")


@pytest.mark.parametrize("text", ["{", '{"model": "compass"}', "[]", "\xff"])
def test_a_damaged_manifest(refused, copy, text):
    path = copy / "compass" / "manifest.json"
    path.write_bytes(text.encode("latin-1"))
    refused("orbit --model compass", path.parent, "manifest.json", "stridemap derive")


def test_derive_cannot_write(refused, tmp_path, monkeypatch):
    (tmp_path / "file").write_text("mine")
    monkeypatch.setattr("stridemap.build.generated_folder", lambda: tmp_path / "file")
    monkeypatch.setattr("stridemap.build.emit", lambda walker, by: ({}, {}))
    refused("derive", tmp_path / "file", "cannot write")
    assert (tmp_path / "file").read_text() == "mine"


# -- compilers -----------------------------------------------------------------------------------------------

SCRIPTS = {
    "fails": ("#!/bin/sh\necho 'out of ideas' >&2\nexit 1\n", ["failed", "out of ideas"]),
    "says-nothing": ("#!/bin/sh\nexit 3\n", ["failed", "said nothing"]),
    "writes-nothing": ("#!/bin/sh\nexit 0\n", ["writes-nothing"]),
    "writes-junk": ('#!/bin/sh\nfor word; do case "$word" in *.so) echo junk > "$word";; esac; done\n', []),
    "is-no-program": ("just text\n", ["is-no-program"]),
}


@pytest.fixture
def no_kernels(tmp_path, monkeypatch):
    """An empty cache of compiled kernels, on disk and in memory."""
    monkeypatch.setenv("STRIDEMAP_CACHE", str(tmp_path / "cache"))
    library.load_kernels.cache_clear()
    yield tmp_path / "cache"
    library.load_kernels.cache_clear()


@pytest.mark.skipif(sys.platform == "win32", reason="shell scripts")
@pytest.mark.parametrize("kind", SCRIPTS)
def test_a_compiler_that_fails(refused, done, no_kernels, monkeypatch, kind):
    text, words = SCRIPTS[kind]
    script = done / kind
    script.write_text(text)
    script.chmod(0o755)
    monkeypatch.setenv("CC", str(script))
    before = content(done / "out")
    refused("orbit --model compass", script, "CC", *words)
    refused(["sweep", done / "small.toml", "--out", done / "out"], script)
    refused(["sweep", done / "small.toml", "--out", done / "new"], script)
    assert content(done / "out") == before
    assert not (done / "new").exists()
    assert [path for path in no_kernels.rglob("*") if path.is_file()] == []


@pytest.mark.parametrize("name", ["no-such-compiler -O2", "/nowhere/gcc", "'gcc"])
def test_cc_names_nothing(refused, no_kernels, monkeypatch, name):
    monkeypatch.setenv("CC", name)
    refused("orbit --model compass", "CC", name)


def test_the_cache_cannot_be_written(refused, no_kernels):
    no_kernels.write_text("mine")
    refused("orbit --model compass", no_kernels, "STRIDEMAP_CACHE")
    assert no_kernels.read_text() == "mine"


@pytest.mark.parametrize("size", [0, 1000, -1000])
def test_a_damaged_cache_is_made_anew(no_kernels, size):
    """Half a library would end the process without a word: hence another process."""
    words = ["orbit", "--model", "compass", "--starts", "16", "--json"]
    status, whole, err = ended(start([*STRIDEMAP, *words]))
    assert (status, err) == (0, "")
    (compiled,) = no_kernels.glob("*.so")
    compiled.write_bytes(compiled.read_bytes()[:size])
    assert ended(start([*STRIDEMAP, *words])) == (0, whole, "")


# -- as others see it ----------------------------------------------------------------------------------------


def test_a_refusal_from_outside():
    command = [str(Path(sys.executable).with_name("stridemap")), "orbit", "--alpha", "1.5"]
    assert ended(start(command)) == (
        2,
        "",
        "error: alpha = 1.5 is outside the allowed range (> 0 and < 1)\n",
    )


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full")
def test_a_full_disk_under_standard_output():
    for buffering in ("", "1"):
        shell = ["sh", "-c", '"$@" > /dev/full', "sh", *STRIDEMAP, "version"]
        status, _, err = ended(start(shell, PYTHONUNBUFFERED=buffering))
        assert (status, err.count("\n")) == (2, 1), err
        assert err.startswith("error: cannot write to standard output (No space left on device)")


def test_a_reader_that_leaves_is_no_error():
    shell = ["sh", "-c", '"$@" | true', "sh", *STRIDEMAP, "version"]
    assert ended(start(shell, PYTHONUNBUFFERED="")) == (0, "", "")


def test_bad_input_in_python_is_an_input_error():
    assert issubclass(stridemap.InputError, ValueError)
    with pytest.raises(stridemap.InputError, match="alpha = 1.5 is outside"):
        stridemap.find_orbits("wobbling", alpha=1.5)
    with pytest.raises(stridemap.InputError, match="there is no model 'none'"):
        stridemap.load("none")
