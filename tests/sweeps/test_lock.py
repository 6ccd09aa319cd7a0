"""Two sweeps into one folder: the second is refused with who holds it; what the dead left is taken over."""

import json
import os
import signal
import socket
import subprocess
import sys
import threading

import pytest

from stridemap.errors import InputError, StorageError
from stridemap.sweeps import lock
from stridemap.sweeps.lock import held, refuse_if_held
from stridemap.sweeps.run import sweep
from tests.oracles.sweeping import CONFIG, STRIDEMAP, Inline, content, ended, start, tables, wait_for

HOLD = """
import sys, time
from stridemap.sweeps.lock import held
with held(sys.argv[1]):
    print("held", flush=True)
    time.sleep(1000)
"""


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "parts").mkdir()
    return tmp_path


@pytest.fixture
def holder(folder):
    """Another process that holds the folder."""
    process = subprocess.Popen([sys.executable, "-c", HOLD, folder], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "held\n"
    yield process
    process.kill()
    process.communicate()


def test_who_holds_it_is_named(folder, holder):
    for take in (refuse_if_held, lambda where: held(where).__enter__()):
        with pytest.raises(InputError) as error:
            take(folder)
        message = str(error.value)
        assert (
            f"another sweep is writing into {folder} (process {holder.pid} on {socket.gethostname()}"
            in message
        )
        assert "since 20" in message
        assert "wait for it, or give another folder" in message
        assert "\n" not in message


def test_a_sweep_is_refused_before_anything_is_touched(folder, holder):
    before = content(folder)
    for resume in (False, True):
        with pytest.raises(InputError, match=f"process {holder.pid} on "):
            sweep(CONFIG, folder, executor=Inline(), tile_cells=2, resume=resume)
    assert content(folder) == before


def test_what_a_killed_process_left_is_taken_over(folder, holder):
    os.kill(holder.pid, signal.SIGKILL)
    holder.wait()
    assert (folder / "parts" / "lock").exists()
    refuse_if_held(folder)
    with held(folder):
        assert json.loads((folder / "parts" / "lock").read_text())["pid"] == os.getpid()
    assert not (folder / "parts" / "lock").exists()


def test_a_lock_of_another_machine_is_not_broken(folder):
    left = {"pid": 1, "host": "far-away", "since": "2026-01-01 00:00 UTC"}
    (folder / "parts" / "lock").write_text(json.dumps(left))
    with pytest.raises(InputError) as error, held(folder):
        pass
    assert "process 1 on far-away, since 2026-01-01 00:00 UTC" in str(error.value)
    assert f"delete {folder / 'parts' / 'lock'}" in str(error.value)
    assert json.loads((folder / "parts" / "lock").read_text()) == left


@pytest.mark.parametrize("text", ["", "{", "[1]", "[" * 100_000, '{"pid": "x"}', '{"pid": -1}', "\0"])
def test_a_lock_that_says_nothing_of_use_is_taken_over(folder, text):
    own = json.dumps({"host": socket.gethostname()})
    (folder / "parts" / "lock").write_text(text if "pid" not in text else own[:-1] + ", " + text[1:])
    with held(folder):
        pass


def test_where_the_system_has_no_locks_the_process_is_looked_for(folder, monkeypatch):
    monkeypatch.setattr(lock, "fcntl", None)
    with held(folder):
        with pytest.raises(InputError, match=f"process {os.getpid()} on "):
            refuse_if_held(folder)
        found = json.loads((folder / "parts" / "lock").read_text())
        (folder / "parts" / "lock").write_text(json.dumps({**found, "begun": "1"}))
        refuse_if_held(folder)  # another process of that number
    ended_process = subprocess.Popen([sys.executable, "-c", ""])
    ended_process.wait()
    left = {"pid": ended_process.pid, "host": socket.gethostname(), "since": "then", "begun": ""}
    (folder / "parts" / "lock").write_text(json.dumps(left))
    refuse_if_held(folder)


def test_one_of_many_threads_gets_it(folder):
    got, refused, gate = [], [], threading.Barrier(8)

    def take():
        gate.wait()
        try:
            with held(folder):
                got.append(1)
                gate.wait(10)
        except InputError:
            refused.append(1)
            gate.wait(10)

    threads = [threading.Thread(target=take) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert (len(got), len(refused)) == (1, 7)


def test_a_lock_that_cannot_be_written(folder):
    (folder / "parts" / "lock").mkdir()
    with pytest.raises(StorageError, match="cannot write"), held(folder):
        pass


def test_two_commands_at_once(larger, tmp_path):
    config, wanted = larger
    out = tmp_path / "out"
    line = [*STRIDEMAP, "sweep", str(config), "--out", str(out), "--workers", "1"]
    first = start(line)
    wait_for(lambda: (out / "parts" / "lock").exists(), first)
    second = start([*line, "--resume"])
    status, _, err = ended(second)
    assert (status, err.count("\n")) == (2, 1)
    assert f"process {first.pid} on " in err
    assert ended(first)[0] == 0
    assert set(tables(out)) == set(wanted)  # the lock is gone
