"""Model files that do not do what they should: each ends in a sentence, and nobody waits for ever."""

import os
import subprocess
import sys
import textwrap
import time

import pytest

import stridemap
from stridemap.errors import InputError, WorkerError
from stridemap.solver.model import derivation
from tests.oracles.sweeping import STRIDEMAP, start


@pytest.fixture
def model(tmp_path, monkeypatch):
    """Writes a model file; the time limit is two seconds, or half of one where the file has no end."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv(derivation.VARIABLE, "2")

    def write(text, endless=False):
        if endless:
            monkeypatch.setenv(derivation.VARIABLE, "0.5")
        (tmp_path / "mine.py").write_text(textwrap.dedent(text))
        return "mine.py"

    return write


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("import os\nos._exit(0)", "mine.py ended its process with status 0 while it was run"),
        ("import os\nos._exit(77)", "mine.py ended its process with status 77"),
        ("import os\nos.kill(os.getpid(), 9)", "was ended by the signal SIGKILL"),
        ("import os\nos.abort()", "was ended by the signal SIGABRT"),
        ("while True:\n    pass", "mine.py: running it took longer than 0.5 s and was ended"),
        ("import time\ntime.sleep(1000)", "took longer than 0.5 s"),
        ("while True:\n    print('x' * 1000)", "mine.py printed more than 1 MB while it was run"),
        ("import os\nwhile True:\n    os.write(2, b'x' * 1000)", "printed more than 1 MB"),
        ("input()", "line 1: EOFError"),
        ("raise KeyboardInterrupt", "mine.py cannot be derived (KeyboardInterrupt"),
        ("def f(n):\n    return f(n + 1)\nf(0)", "RecursionError"),
        ("import sys\nsys.stdout.close()\nsys.stderr.close()\n1 / 0", "ZeroDivisionError"),
        ("import os\nif not os.fork():\n    while True:\n        pass\nos._exit(5)", "with status 5"),
        (
            "import signal\nsignal.signal(signal.SIGTERM, signal.SIG_IGN)\nwhile True:\n    pass",
            "longer than 0.5 s",
        ),
        ("raise ValueError('x' * 1_000_000)", "ValueError: xxx"),
    ],
)
def test_a_file_that_misbehaves(model, capsys, text, words):
    begun = time.monotonic()
    with pytest.raises(InputError) as error:
        stridemap.load(model(text, endless="longer than" in words))
    assert words in str(error.value)
    assert "\n" not in str(error.value)
    assert len(str(error.value)) < 1000
    assert time.monotonic() - begun < 100
    out, err = capsys.readouterr()
    assert out == ""
    assert len(err) <= derivation.SAID_MAX


def test_a_process_that_it_left_behind_is_ended(model, tmp_path):
    text = f"""
        import os, time
        if not os.fork():
            time.sleep(30)
            open({str(tmp_path / "late")!r}, "w").close()
        os._exit(3)
    """
    with pytest.raises(InputError, match="with status 3"):
        stridemap.load(model(text))
    time.sleep(0.5)
    ps = subprocess.run(["ps", "-eo", "args"], capture_output=True, text=True, check=True).stdout
    assert str(tmp_path / "mine.py") not in ps
    assert not (tmp_path / "late").exists()


def test_a_derivation_that_takes_too_long_says_that_it_was_deriving(model):
    text = """
        import time
        import stridemap.codegen
        from stridemap.derive.models.rimless_wheel import WALKER
        WALKER = WALKER.with_(name="slow_wheel")
        stridemap.codegen.into_cache = lambda *_: time.sleep(1000)
    """
    with pytest.raises(InputError, match="deriving its equations took longer than 2 s"):
        stridemap.load(model(text))


def test_it_says_that_it_is_still_at_work(model, capsys, monkeypatch):
    monkeypatch.setattr(derivation, "SILENCE", 0.5)
    with pytest.raises(InputError):
        stridemap.load(model("import time\ntime.sleep(1000)"))
    assert "mine.py: running it has taken " in capsys.readouterr().err


@pytest.mark.parametrize("command", ["orbit --model mine.py", "derive mine.py", "simulate --model mine.py"])
def test_the_option_sets_the_limit(model, refused, monkeypatch, command):
    monkeypatch.setenv(derivation.VARIABLE, "50")
    model("import time\ntime.sleep(1000)")
    refused(f"{command} --derive-timeout 1", "took longer than 1 s", "--derive-timeout")


@pytest.mark.parametrize("value", ["0", "-1", "nan", "inf", "1e300"])
def test_limits_that_make_no_sense(model, refused, monkeypatch, value):
    monkeypatch.setenv(derivation.VARIABLE, "5")
    refused(f"orbit --model compass --derive-timeout {value}", "a number of seconds above 0 is needed")
    monkeypatch.setenv(derivation.VARIABLE, "soon")
    with pytest.raises(InputError, match="'soon'"):
        stridemap.load(model("x = 1"))


def test_the_caller_is_not_what_the_file_runs_in(model, monkeypatch):
    with pytest.raises(InputError, match="has no WALKER"):
        stridemap.load(model("import os, sys\nos.environ['SEEN'] = 'yes'\nsys.modules['json'] = None"))
    assert "SEEN" not in os.environ


def test_a_module_of_that_name_in_the_working_folder_is_not_run(model, tmp_path):
    for name in ("json", "sympy", "stridemap", "sitecustomize", "usercustomize", "typing"):
        (tmp_path / f"{name}.py").write_text(f"open({str(tmp_path / 'ran')!r}, 'w')")
    (tmp_path / "below").mkdir()
    (tmp_path / "below" / "mine.py").write_text("x = 1")
    with pytest.raises(InputError, match="has no WALKER"):
        stridemap.load("below/mine.py")
    assert not (tmp_path / "ran").exists()


def test_it_ends_with_its_parent(model, tmp_path):
    model("import os\nopen('pid', 'w').write(str(os.getpid()))\nwhile True:\n    pass")
    process = start([*STRIDEMAP, "orbit", "--model", "mine.py", "--derive-timeout", "1000"])
    limit = time.monotonic() + 100
    while not (tmp_path / "pid").exists() or not (tmp_path / "pid").read_text():
        assert time.monotonic() < limit
        time.sleep(0.05)
    pid = int((tmp_path / "pid").read_text())
    process.kill()
    process.communicate()
    while os.path.exists(f"/proc/{pid}") and "State:\tZ" not in open(f"/proc/{pid}/status").read():
        assert time.monotonic() < limit
        time.sleep(0.05)


def test_where_no_process_can_be_started(model, monkeypatch):
    def none(*_args, **_keywords):
        raise OSError(24, "Too many open files")

    path = model("x = 1")
    monkeypatch.setattr(subprocess, "Popen", none)
    with pytest.raises(WorkerError, match="Too many open files"):
        stridemap.load(path)
    assert sys.executable
