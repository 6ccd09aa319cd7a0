"""Bad input on the command line: one sentence that names it, status 2, and nothing is lost."""

import sys
from pathlib import Path

import pandas as pd
import pytest

import stridemap
from stridemap.sweeps.config import load_config
from stridemap.sweeps.run import sweep
from tests.oracles.sweeping import SMALL, STRIDEMAP, Inline, content, ended, start

KNOWN = "compass, goswami_compass, rimless_wheel, round_feet, simplest_walker, wobbling"

# -- parameters and options ----------------------------------------------------------------------------------


@pytest.mark.quick
@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("--alpa 0.3", ["alpa", "did you mean alpha?", "k, alpha, omega, beta, Kp, Kd, S, gamma"]),
        ("--set omeg=3", ["omeg", "did you mean omega?"]),
        ("--K 6", ["'K'", "did you mean k?"]),
        ("--model compas", ["compas", "did you mean compass?", KNOWN]),
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
        ("--model wobbeling", ["'wobbeling'", KNOWN]),
        ("--model ../compass", ["'../compass'", KNOWN]),
        ("--model", ["--model"]),
    ],
)
@pytest.mark.parametrize("command", ["orbit", "simulate"])
def test_parameters(refused, command, line, words):
    refused(f"{command} {line}", *words)


@pytest.mark.quick
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
    ],
)  # fmt: skip
def test_options_and_commands(refused, line, words):
    refused(line, *words)


@pytest.mark.parametrize(("value", "shown"), [("nan", "nan"), ("-inf", "-inf"), ("left", "left")])
def test_a_state_is_finite_numbers(refused, value, shown):
    entries = [f"theta1={value}", "dtheta1=-0.1", "dtheta2=0", "x=0", "dx=0"]
    line = ["simulate", *(word for entry in entries for word in ("--state", entry))]
    refused(line, "theta1", shown, "not a finite number")


@pytest.mark.parametrize("name", ["k", "omega", "Kp", "Kd", "beta", "gamma", "S"])
def test_an_enormous_value_is_no_crash(run, name):
    status, out, err = run("orbit", f"--{name}=1e308", "--starts=4")
    assert (status, out) == (1, "")
    assert err.startswith("no limit cycle found\n4 starts ended: 4 nowhere")
    assert "look whether all values are in the units" in err


# -- configurations ------------------------------------------------------------------------------------------

HEAD = 'model = "wobbling"\n'


@pytest.mark.quick
@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[grid]\nomega = [3.0]\n", ["model is missing"]),
        ('model = "woble"\n[grid]\nomega = [3.0]\n', ["woble", KNOWN]),
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


@pytest.mark.quick
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
    said = "not one that a sweep wrote" if damage == "foreign" else "damaged or is not a Parquet file"
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
