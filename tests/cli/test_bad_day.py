"""A bad day: closed streams, few file handles, names that are too long, no room, and huge numbers."""

import os
import subprocess
import time

import pytest

import stridemap
from stridemap.errors import InputError, StridemapError, bounded, short
from tests.oracles.sweeping import SMALL, STRIDEMAP

SHELL = ["bash", "-c"]


def in_shell(text, **environment):
    """Run a line of shell in which $S is the command line."""
    line = text.replace("$S", " ".join(STRIDEMAP))
    return subprocess.run(
        [*SHELL, line], capture_output=True, text=True, timeout=300, env={**os.environ, **environment}
    )


def one_sentence(err):
    assert err.count("\n") == 1, err
    assert err.startswith("error: ")
    assert "Traceback" not in err
    assert len(err) < 1000


# -- streams -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("command", ["version", "orbit --model compass --starts 4", "--help"])
def test_closed_standard_output(command):
    done = in_shell(f"$S {command} >&-")
    assert done.returncode == 2
    one_sentence(done.stderr)
    assert "standard output is closed" in done.stderr


def test_closed_standard_error_and_input():
    done = in_shell("$S version 2>&- <&-")
    assert (done.returncode, done.stdout) == (0, f"{stridemap.__version__}\n")
    assert in_shell("$S versoin 2>&-").returncode == 2
    assert in_shell("$S version <&- >&- 2>&-").returncode == 2


def test_what_is_opened_does_not_become_standard_error(tmp_path):
    """With the stream closed, the first file opened would get its number, and a warning would go into it."""
    (tmp_path / "small.toml").write_text(SMALL)
    line = f"cd {tmp_path} && $S sweep small.toml --out out --workers 1 2>&-"
    assert in_shell(line).returncode == 0
    assert len(stridemap.read_orbits(tmp_path / "out")) > 0


def test_a_full_standard_output():
    done = in_shell("$S orbit --model compass --starts 4 >/dev/full")
    assert done.returncode == 2
    one_sentence(done.stderr)
    assert "No space left on device" in done.stderr


# -- limits of the system ------------------------------------------------------------------------------------


@pytest.mark.parametrize("handles", [12, 16])
def test_few_file_handles(tmp_path, handles):
    (tmp_path / "small.toml").write_text(SMALL)
    line = f"cd {tmp_path} && ulimit -n {handles} && $S sweep small.toml --out out --workers 2"
    done = in_shell(line)
    assert done.returncode in (0, 2), done.stderr
    if done.returncode:
        one_sentence(done.stderr.splitlines(keepends=True)[-1])
        assert "Too many open files" in done.stderr
        assert "Traceback" not in done.stderr
        rest = in_shell(f"cd {tmp_path} && $S sweep small.toml --out out --workers 1 --resume")
        assert rest.returncode == 0, rest.stderr


@pytest.mark.parametrize(
    "words",
    [
        ("orbit", "--model", "LONG"),
        ("orbit", "--model", "LONG.py"),
        ("orbit", "--model", "compass", "--backend", "LONG"),
        ("orbit", "--model", "compass", "--set", "LONG=1"),
        ("orbit", "--model", "compass", "--omega", "LONG"),
        ("simulate", "--model", "compass", "--state", "LONG=1"),
        ("simulate", "--model", "compass", "--steps", "LONG"),
        ("sweep", "LONG", "--out", "x"),
        ("sweep", "small.toml", "--out", "LONG"),
        ("sweep", "small.toml", "--out", "LONG/LONG"),
        ("report", "LONG", "--out", "x.html"),
        ("report", "out", "--out", "LONG.html"),
        ("report", "out", "--out", "x.html", "--claims", "LONG"),
        ("report", "out", "--out", "x.html", "--model", "LONG.py"),
        ("animate", "--model", "compass", "--out", "LONG.gif", "--size", "80", "--fps", "5"),
        ("derive", "LONG.py"),
        ("derive", "LONG"),
        ("LONG",),
        ("orbit", "--LONG"),
        ("orbit", "LONG"),
    ],
    ids=" ".join,
)
@pytest.mark.parametrize("length", [300, 5000, 1_000_000])
def test_names_that_are_too_long(run, done, monkeypatch, words, length):
    monkeypatch.chdir(done)
    status, out, err = run(*(word.replace("LONG", "q" * length) for word in words))
    assert (status, out) == (2, "")
    one_sentence(err)
    assert err.count("q") <= 300


def test_a_model_of_a_configuration_whose_name_is_too_long(refused, tmp_path):
    (tmp_path / "long.toml").write_text(f'model = "{"m" * 5000}"\n[grid]\nk = [1.0]\n')
    refused(["sweep", tmp_path / "long.toml", "--out", tmp_path / "out"], "there is no model")


@pytest.mark.parametrize("name", ["/dev/zero", "pipe"])
def test_a_configuration_that_has_no_end(refused, tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    os.mkfifo("pipe")
    refused(f"sweep {name} --out out", name)
    refused(f"report out --out {name}", "out")


@pytest.mark.parametrize("name", ["pipe", "device"])
def test_pictures_and_pages_replace_no_pipe_and_no_device(refused, done, monkeypatch, name):
    monkeypatch.chdir(done)
    os.mkfifo("pipe")
    os.symlink("/dev/full", "device")
    os.symlink(name, "a.gif")
    refused(f"report out --out {name}", name, "is not a file")
    refused("animate --model compass --out a.gif --size 80 --fps 5", "a.gif", "is not a file")


# -- huge numbers --------------------------------------------------------------------------------------------


def test_a_torque_that_turns_billions_of_times_is_given_up(run):
    state = ("theta1=0.1", "dtheta1=-0.1", "dtheta2=0", "x=0", "dx=0")
    words = [word for entry in state for word in ("--state", entry)]
    begun = time.monotonic()
    status, out, err = run("simulate", "--omega", "6e10", *words)
    assert (status, err) == (1, "")
    assert "after 0 of 10 steps" in out
    assert time.monotonic() - begun < 120


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("simulate --model compass --steps 1000001", ["steps = 1000001", "1,000,000"]),
        ("orbit --model compass --starts 1000001", ["starts = 1,000,001", "1,000,000"]),
        ("animate --model compass --out a.gif --fps 51", ["fps = 51", "2 to 50"]),
        ("animate --model compass --out a.gif --size 1601", ["size = 1601", "80 to 1600"]),
        ("animate --model compass --out a.gif --steps 102", ["steps = 102", "100"]),
        ("sweep small.toml --out new --workers 1025", ["workers = 1025", "1 to 1,024"]),
        ("sweep small.toml --out new --workers 0", ["workers = 0", "at least 1"]),
    ],
)  # fmt: skip
def test_numbers_that_would_take_for_ever(refused, done, monkeypatch, line, words):
    monkeypatch.chdir(done)
    refused(line, *words)


# -- what is quoted ------------------------------------------------------------------------------------------


def test_messages_quote_little():
    assert len(str(StridemapError("x" * 1_000_000))) <= 300
    assert len(str(InputError("word " * 1_000_000))) <= 800
    quoted = str(InputError(f"--set {'word ' * 100_000!r} is not understood; write --set NAME=VALUE"))
    assert len(quoted) <= 300
    assert quoted.endswith("d ' is not understood; write --set NAME=VALUE")
    two = f"a walker's spring, {'x ' * 40}, and another walker's spring, {'y ' * 90}"
    assert str(InputError(two)) == two  # no quotation begins within a word
    assert str(InputError("a short sentence, as it is")) == "a short sentence, as it is"
    assert bounded("a" * 250) == "a" * 250
    assert short("a\nb\x1b") == "'a\\nb\\x1b'"
    assert len(short(10**5000)) <= 100


def test_characters_that_steer_terminals_are_not_printed(run):
    status, _, err = run("orbit", "--model", "\x1b[2J\x07\u202e\nx")
    assert status == 2
    one_sentence(err)
    assert err.rstrip("\n").isprintable()


@pytest.mark.parametrize("digits", [17, 400, 4000])
def test_starts_of_many_digits(refused, digits):
    refused(["orbit", "--model", "compass", "--starts", "9" * digits], "starts", "at most 1,000,000")


def test_options_that_cannot_even_be_printed():
    for name in ("starts", "seed", "max_starts"):
        with pytest.raises(InputError, match=name):
            stridemap.SearchOptions(**{name: 10**5000})


def test_a_state_whose_other_entries_are_too_large(refused):
    state = ["theta1=-1e308", "dtheta1=-0.2", "dtheta2=0"]
    words = [word for entry in state for word in ("--state", entry)]
    refused(["simulate", "--model", "compass", *words, "--steps", "1"], "too large to be numbers")
