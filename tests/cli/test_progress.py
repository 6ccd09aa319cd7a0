"""How a command shows that it moves: what is said, when, and where."""

import sys
import time

import pytest

from stridemap import services
from stridemap.cli import progress
from stridemap.sweeps.run import Progress

pytestmark = pytest.mark.quick


@pytest.fixture
def quick(monkeypatch):
    """Lines come soon, and often."""
    monkeypatch.setattr(progress, "QUIET", 0.05)
    monkeypatch.setattr(progress, "LINE_EVERY", 0.05)


def lines(capsys):
    out, err = capsys.readouterr()
    assert out == ""
    return err.splitlines()


def wait_for(capsys, line):
    """All lines up to one that comes by itself, while whoever works is silent."""
    said, until = [], time.monotonic() + 20
    while line not in said:
        assert time.monotonic() < until
        time.sleep(0.02)
        said += lines(capsys)
    return said


def test_what_takes_no_second_is_not_mentioned(capsys):
    with progress.show_work("deriving mine", "functions") as update:
        update(1, 2, "mass_matrix done")
    assert lines(capsys) == []


def test_silent_work_shows_that_it_goes_on_and_that_it_is_over(quick, capsys):
    with progress.show_work("compiling"):
        wait_for(capsys, "compiling: 0 s")
        wait_for(capsys, "compiling: 0 s")
    assert lines(capsys)[-1].startswith("compiling: done, ")


def test_work_that_fails_is_not_called_done(quick, capsys):
    def fail():
        with progress.show_work("compiling"):
            wait_for(capsys, "compiling: 0 s")
            raise ValueError

    with pytest.raises(ValueError):
        fail()
    assert not [line for line in lines(capsys) if "done" in line]


def test_lines_say_how_many_of_how_many_and_what(quick, capsys):
    with progress.show_work("deriving mine", "functions") as update:
        update(2, 10, "mass_matrix done")
        wait_for(capsys, "deriving mine: 2 of 10 functions, mass_matrix done, 0 s")


def test_of_work_within_work_only_the_innermost_speaks(quick, capsys):
    with progress.show_work("outer"):
        with progress.show_work("inner"):
            wait_for(capsys, "inner: 0 s")
            assert set(wait_for(capsys, "inner: 0 s")) == {"inner: 0 s"}
        lines(capsys)
        wait = time.monotonic() + 20
        while not any(line.startswith("outer: ") for line in lines(capsys)):
            assert time.monotonic() < wait
            time.sleep(0.02)


def test_what_follows_the_last_piece_is_not_the_last_piece_again(quick, capsys):
    with progress.show_work("round 1", "tiles", ends=True) as update:
        update(3, 3, ", 5 limit cycles")
        said = wait_for(capsys, "round 1: finishing, 0 s")
    assert said.count("round 1: 3 of 3 tiles, 5 limit cycles, 0 s") == 1


def test_the_end_of_each_round_of_a_sweep_is_said_however_little_it_took(capsys):
    with progress.show("sweep map, ") as seen:
        seen(Progress(1, 0, 2, 0))
        seen(Progress(1, 1, 2, 3))
        seen(Progress(1, 2, 2, 1500))
    (line,) = lines(capsys)
    assert line.startswith("sweep map, round 1: 2 of 2 pieces (")
    assert line.endswith(" per second), 1,500 limit cycles, 0 s")


def test_quiet_means_nothing_at_all(quick, capsys, monkeypatch):
    monkeypatch.setattr(progress, "_silent", True)
    with progress.show("") as seen:
        seen(Progress(1, 2, 2, 3))
        time.sleep(0.15)
    assert lines(capsys) == []


class Terminal:
    """Something that says that it is a terminal, and keeps what is written."""

    encoding = "utf-8"

    def __init__(self):
        self.written = ""

    def write(self, text):
        self.written += text
        return len(text)

    def flush(self):
        """Everything is written at once."""

    def isatty(self):
        return True

    def fileno(self):
        raise OSError


def test_a_terminal_shows_rows_and_leaves_nothing_behind(quick, monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "150")
    with progress.show_work("outer", "tiles") as update, progress.show_work("inner"):
        update(3, 8, ", 5 limit cycles")
        until = time.monotonic() + 20
        while not ("inner" in terminal.written and "3 of 8 tiles, 5 limit cycles" in terminal.written):
            assert time.monotonic() < until
            time.sleep(0.02)
    assert progress._display.progress is None
    assert sys.stderr is terminal


@pytest.mark.parametrize(("announced", "said"), [(True, 1), (False, 0)])
def test_a_program_reads_in_its_log_why_a_first_call_is_slow(monkeypatch, caplog, announced, said):
    monkeypatch.setattr(services, "SAID_AFTER", 0.02)
    monkeypatch.setattr(services, "_HOMES", {})
    with services.shown("compiling the kernels", announced=announced):
        until = time.monotonic() + (20 if said else 0.1)
        while not caplog.messages and time.monotonic() < until:
            time.sleep(0.02)
    assert caplog.messages == ["compiling the kernels; this is done once, and may take a while"] * said


@pytest.mark.parametrize("command", ["orbit", "sweep", "claims", "derive", "boundary"])
def test_every_command_can_be_quiet(run, command):
    status, out, _ = run(command, "--help")
    assert status == 0
    assert "--quiet" in out
