"""A sweep that is stopped: what is finished stays, nobody shouts, and --resume gives the same bytes."""

import contextlib
import functools
import os
import shutil
import signal
import sys
import time
from concurrent.futures import BrokenExecutor, Future
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path

import pytest

import stridemap
from stridemap.sweeps import run
from stridemap.sweeps.executors import processes
from stridemap.sweeps.store import ORBITS
from tests.oracles.sweeping import (
    CONFIG,
    IN_PIECES,
    Remembering,
    content,
    ended,
    parts,
    piece,
    start,
    tables,
    wait_for,
)

sweep = functools.partial(run.sweep, tile_cells=2)

PROC = Path("/proc/self/task").exists()
posix = pytest.mark.skipif(os.name != "posix", reason="signals are POSIX")


# -- stopped within this process -----------------------------------------------------------------------------


class Enough(Exception):
    """Ends a sweep from its progress."""


class Breaks(Remembering):
    """Gives up at the third task: in computing it, or in taking it."""

    def __init__(self, error, taking=False):
        super().__init__()
        self.error, self.taking = error, taking

    def submit(self, fn, /, *args, **kwargs):
        if len(self.tasks) < 2:
            return super().submit(fn, *args, **kwargs)
        if self.taking:
            raise self.error
        future = Future()
        future.set_exception(self.error)
        return future


@pytest.mark.parametrize(
    ("error", "taking"),
    [
        (BrokenProcessPool("died"), False),
        (BrokenExecutor("died"), True),
        (KeyboardInterrupt(), False),
        (KeyboardInterrupt(), True),
    ],
)
def test_what_is_finished_stays_and_resume_does_the_rest(reference, tmp_path, error, taking):
    if isinstance(error, BrokenExecutor):
        with pytest.raises(stridemap.WorkerError, match="a worker process died.*--resume") as caught:
            sweep(CONFIG, tmp_path, executor=Breaks(error, taking))
        assert "\n" not in str(caught.value)
    else:
        with pytest.raises(KeyboardInterrupt):
            sweep(CONFIG, tmp_path, executor=Breaks(error, taking))
    finished = {piece(part) for part in parts(tmp_path)}
    assert len(finished) == (0 if taking else 2)
    before = content(tmp_path)
    executor = Remembering()

    def kept(_):
        now = content(tmp_path)
        assert {name: now[name] for name in before if name in now} == {
            n: before[n] for n in before if n in now
        }

    summary = sweep(CONFIG, tmp_path, executor=executor, resume=True, progress=kept)
    assert not finished & set(executor.pieces)
    assert finished | set(executor.pieces) == set(reference[3])
    assert len(executor.pieces) == len(set(executor.pieces))
    assert tables(tmp_path) == tables(reference[0])
    assert summary.orbits == reference[1].orbits


def test_resume_at_every_piece_gives_the_same_bytes(reference, tmp_path):
    """Stopped after one piece, again and again, from the first to the last."""
    turns = 0
    while True:
        turns += 1
        held = parts(tmp_path)
        last = max((piece(part)[0] for part in held), default=1)
        before = sum(piece(part)[0] == last for part in held)

        def one_more(seen, last=last, before=before):
            if (seen.round, seen.done) > (last, before) and seen.done:
                raise Enough

        try:
            sweep(CONFIG, tmp_path, executor=Remembering(), resume=True, progress=one_more)
            break
        except Enough:
            assert len(parts(tmp_path)) == len(held) + 1
    assert turns == len(reference[3]) + 1
    assert tables(tmp_path) == tables(reference[0])


@pytest.mark.quick
@pytest.mark.parametrize("resume", [True, False])
def test_a_finished_sweep_is_not_computed_again(reference, tmp_path, resume):
    shutil.copytree(reference[0], tmp_path, dirs_exist_ok=True)
    before, times = content(tmp_path), [path.stat().st_mtime_ns for path in tmp_path.iterdir()]
    executor = Remembering()
    summary = sweep(CONFIG, tmp_path, executor=executor, resume=resume)
    assert summary.already_finished
    assert (summary.cells, summary.orbits, summary.stable_orbits) == (
        8, reference[1].orbits, reference[1].stable_orbits,
    )  # fmt: skip
    assert executor.tasks == []
    assert content(tmp_path) == before
    assert [path.stat().st_mtime_ns for path in tmp_path.iterdir()] == times


def test_resume_where_there_is_nothing_begins(reference, tmp_path):
    sweep(CONFIG, tmp_path / "new", executor=Remembering(), resume=True)
    assert tables(tmp_path / "new") == tables(reference[0])


# -- stopped from outside ------------------------------------------------------------------------------------


def started(config, out, *more, rest=0.1):
    """The command line in a process group of its own, with two workers, resting after each piece."""
    words = ["sweep", str(config), "--out", str(out), "--workers", "2", *more]
    return start([sys.executable, "-c", IN_PIECES, *words], REST=str(rest))


def workers_of(process):
    """Process numbers of the workers."""
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    found = []
    for child in children:
        with contextlib.suppress(ProcessLookupError, FileNotFoundError):  # not a worker, and over already
            if b"spawn_main" in Path(f"/proc/{child}/cmdline").read_bytes():
                found.append(int(child))
    return found


def whole_parts(out):
    """Bytes and times of the part files."""
    return {path.name: (path.read_bytes(), path.stat().st_mtime_ns) for path in parts(out)}


def unfinished(out):
    """The part files that a sweep stopped in the middle has left."""
    assert not (out / ORBITS).exists()
    return whole_parts(out)


def resumed(config, out, wanted, held):
    """Continue in this process, with the pieces held left alone."""
    executor = Remembering()

    def left_alone(_):
        assert held.items() <= whole_parts(out).items()

    sweep(config, out, executor=executor, resume=True, progress=left_alone)
    assert not {piece(Path(name)) for name in held} & set(executor.pieces)
    assert tables(out) == wanted


@posix
def test_kill_and_resume_on_the_command_line(larger, tmp_path):
    config, wanted = larger
    out = tmp_path / "out"
    process = started(config, out)
    wait_for(lambda: len(parts(out)) >= 3, process)
    os.killpg(process.pid, signal.SIGKILL)
    assert ended(process)[0] == -signal.SIGKILL
    held = unfinished(out)
    assert len(held) >= 3
    again = started(config, out, "--resume", rest=0.02)
    wait_for(lambda: len(parts(out)) > len(held), again)
    assert held.items() <= whole_parts(out).items()
    status, said, shown = ended(again)
    assert (status, said.split(":")[0]) == (0, "sweep finished")
    assert "Traceback" not in shown
    assert tables(out) == wanted


@posix
def test_workers_end_with_a_killed_parent(larger, tmp_path):
    config, wanted = larger
    out = tmp_path / "out"
    process = started(config, out)
    wait_for(lambda: len(parts(out)) >= 1, process)
    process.kill()
    # Standard output and error are closed only when the last worker that holds them has ended.
    assert ended(process, timeout=60)[0] == -signal.SIGKILL
    resumed(config, out, wanted, unfinished(out))


@posix
@pytest.mark.parametrize("when", ["workers start", "pieces come"])
def test_ctrl_c(larger, tmp_path, when):
    config, wanted = larger
    out = tmp_path / "out"
    process = started(config, out)
    enough = 0 if when == "workers start" else 2
    wait_for(lambda: len(parts(out)) >= enough and (workers_of(process) if PROC else out.is_dir()), process)
    if when == "workers start":
        time.sleep(0.4)  # into the imports of a worker, which by itself would print a traceback
    os.killpg(process.pid, signal.SIGINT)  # the terminal sends it to all of them
    status, said, shown = ended(process)
    lines = [line for line in shown.splitlines() if not line.startswith(("round ", "preparing: "))]
    assert lines == [f"interrupted: finished tiles are kept in {out}; continue with --resume"]
    assert (status, said) == (130, "")
    held = unfinished(out)
    assert len(held) >= enough
    resumed(config, out, wanted, held)


def test_an_interrupt_ends_what_workers_are_at():
    with pytest.raises(KeyboardInterrupt), processes(1) as pool:
        future = pool.submit(time.sleep, 30)
        while not future.running():
            time.sleep(0.01)
        raise KeyboardInterrupt
    assert isinstance(future.exception(), BrokenProcessPool)  # it did not sleep to its end


@posix
def test_ctrl_c_pressed_again(larger, tmp_path):
    """It ended when the workers had, or never: each waited for the other."""
    config, wanted = larger
    out = tmp_path / "out"
    process = started(config, out)
    wait_for(lambda: len(parts(out)) >= 1, process)
    workers = workers_of(process) if PROC else []
    for _ in range(2):
        os.killpg(process.pid, signal.SIGINT)
        time.sleep(0.05)
    status, said, shown = ended(process)
    assert (status in (130, -signal.SIGINT), said) == (True, "")
    assert "Traceback" not in shown
    assert not [one for one in workers if Path(f"/proc/{one}").exists()]
    resumed(config, out, wanted, unfinished(out))


@posix
def test_being_told_to_end_is_like_ctrl_c(larger, tmp_path):
    config, wanted = larger
    out = tmp_path / "out"
    process = started(config, out)
    wait_for(lambda: len(parts(out)) >= 1, process)
    process.terminate()
    status, said, shown = ended(process)
    assert (status, said) == (130, "")
    assert shown.splitlines()[-1].startswith(f"interrupted: finished tiles are kept in {out}")
    assert "Traceback" not in shown
    resumed(config, out, wanted, unfinished(out))


@pytest.mark.skipif(not PROC, reason="no /proc")
def test_a_worker_that_dies(larger, tmp_path):
    config, wanted = larger
    out = tmp_path / "out"
    process = started(config, out)
    wait_for(lambda: len(parts(out)) >= 2, process)
    os.kill(workers_of(process)[0], signal.SIGKILL)
    status, said, shown = ended(process)
    lines = [line for line in shown.splitlines() if not line.startswith(("round ", "preparing: "))]
    assert (status, said, len(lines)) == (2, "", 1)
    assert lines[0].startswith("error: a worker process died")
    assert "--resume" in lines[0]
    resumed(config, out, wanted, unfinished(out))
