"""A model file is run in a process of its own: whatever it does, the caller gets a folder or a sentence.

The file is Python that somebody wrote to be run, so nothing is kept from it; but it may compute for ever,
print for ever or end its process, and so may the derivation of what it declares.
"""

import contextlib
import json
import math
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NoReturn

from stridemap import errors
from stridemap.errors import InputError, StridemapError, WorkerError, short
from stridemap.services import provide, service, shown

VARIABLE = "STRIDEMAP_DERIVE_TIMEOUT"
"""The environment variable that holds the limit; the option ``--derive-timeout`` sets it for one command."""

SECONDS = 3600.0
"""Default limit: walkers of five links with motors take minutes, the slowest known a quarter of an hour."""

START_SECONDS = 120.0
"""At the latest after so long the limit begins to run: until then Python and SymPy may be loading."""

SAID_MAX = 1_000_000
"""Bytes that a model file may print: whoever prints more has a loop without an end."""

SHOWN_MAX = 50_000
"""Bytes of it that are passed on."""

SILENCE = 30.0
"""Seconds without a word after which it is said that the derivation is still at work."""

_CHILD = (
    "import json, sys; sys.path[:] = json.loads(sys.argv[1]); import stridemap; "
    "from stridemap.solver.model import derivation; derivation._child()"
)


def derive_timeout() -> float:
    """Seconds after which running and deriving a model file is ended.

    Raises
    ------
    InputError
        When the environment variable does not hold a number above 0.
    """
    text = os.environ.get(VARIABLE, "").strip()
    try:
        seconds = float(text) if text else SECONDS
    except ValueError:
        seconds = math.nan
    if not 0 < seconds <= threading.TIMEOUT_MAX:
        raise InputError(
            f"the time limit of a derivation, {short(text)}, is not allowed: a number of seconds above 0 is "
            "needed"
        )
    return seconds


def derive_file(path: Path, out: Path | None = None, keep: bool = True) -> Path:
    """Folder of the generated files of a model file, derived unless it is in the user's cache.

    Parameters
    ----------
    path : pathlib.Path
        The model file. It is run, in a process of its own.
    out : pathlib.Path, optional
        Where the generated files go; by default into the user's cache.
    keep : bool
        Whether files in the cache stay even if they were changed since; loading them then refuses.

    Returns
    -------
    pathlib.Path

    Raises
    ------
    InputError
        When the file cannot be read, run or derived, takes longer than `derive_timeout`, or prints without
        end.
    """
    if not os.path.isfile(path):
        raise InputError(f"cannot read the model file {path}; give the path of a Python file (.py)")
    seconds = derive_timeout()
    with tempfile.TemporaryDirectory() as scratch:
        report = Path(scratch) / "report.json"
        asked = [str(path), None if out is None else str(out), keep, str(report)]
        with _started(
            [sys.executable, "-P", "-c", _CHILD, json.dumps(sys.path), json.dumps(asked)]
        ) as process:
            with shown(f"reading the model file {path}", "functions", announced=True) as update:
                fault = _Watch(process, path, report, seconds, update).wait()
        found = _read(report)
    if fault is not None:
        raise InputError(fault)
    if "folder" in found:
        return Path(found["folder"])
    if "error" in found:
        kind = getattr(errors, str(found["kind"]), InputError)
        raise (kind if issubclass(kind, StridemapError) else InputError)(found["error"])
    raise InputError(_ended(path, process.returncode, found))


class _Watch:
    """Waits for the process, passes on what it prints, and ends it at its limits."""

    def __init__(
        self,
        process: "subprocess.Popen[bytes]",
        path: Path,
        report: Path,
        seconds: float,
        update: Callable[..., None],
    ) -> None:
        self.process, self.path, self.report, self.seconds = process, path, report, seconds
        self.update = update
        self.last: dict[str, Any] = {}
        self.said, self.heard = 0, time.monotonic()
        self.listener = threading.Thread(target=self._listen, daemon=True)

    def wait(self) -> str | None:
        """Wait for the end; returns what is wrong if it did not end by itself."""
        begun, loading = time.monotonic(), True
        self.listener.start()
        while self.process.poll() is None:
            now = time.monotonic()
            if loading and now - begun < START_SECONDS and "stage" not in _read(self.report):
                time.sleep(0.02)
                continue
            if loading:
                begun, self.heard, loading = now, now, False
            if now - begun > self.seconds:
                return (
                    f"{self.path}: {self._doing()} took longer than {self.seconds:g} s and was ended; "
                    "correct the file, or raise --derive-timeout"
                )
            if self.said > SAID_MAX:
                return (
                    f"{self.path} printed more than {SAID_MAX / 1e6:g} MB while it was run, and was ended; a "
                    "model file declares a walker and need not print anything"
                )
            if now - self.heard > SILENCE:
                self.heard = now
                _say(
                    f"{self.path}: {self._doing()} has taken {now - begun:.0f} s; it is ended after "
                    f"{self.seconds:g} s (--derive-timeout)\n"
                )
            self._show()
            with contextlib.suppress(subprocess.TimeoutExpired):
                self.process.wait(0.02 if now - begun < 2 else 0.2)
        self.listener.join(1.0)  # a process that it started may hold its output open
        return None

    def _show(self) -> None:
        """Show what the process shows of its work."""
        work = _read(self.report).get("work")
        if isinstance(work, dict) and work != self.last:
            self.last = work
            with contextlib.suppress(TypeError, ValueError):  # a model file may write anything
                self.update(**work)

    def _doing(self) -> str:
        return "deriving its equations" if _read(self.report).get("stage") == "deriving" else "running it"

    def _listen(self) -> None:
        """Pass on what is printed, as far as it goes."""
        output = self.process.stdout
        while output is not None and (chunk := output.read1(65536)):  # type: ignore[attr-defined]
            if self.said < SHOWN_MAX:
                shown = chunk[: SHOWN_MAX - self.said].decode("utf-8", "replace")
                cut = "" if shown.endswith("\n") or self.said + len(chunk) < SHOWN_MAX else "\n"
                _say(f"{shown}{cut}")
            self.said += len(chunk)
            self.heard = time.monotonic()


@contextlib.contextmanager
def _started(command: list[str]) -> "Iterator[subprocess.Popen[bytes]]":
    """A process that does not outlive the context, nor do those that it started."""
    own = os.name == "posix"
    try:
        process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            start_new_session=own,
        )
    except OSError as error:
        raise WorkerError(
            f"cannot start the process that runs the model file ({error.strerror or error}); close other "
            "programs or raise their limits (ulimit -n, ulimit -u)"
        ) from None
    try:
        yield process
    finally:
        if own:
            with contextlib.suppress(OSError):
                os.killpg(process.pid, signal.SIGKILL)
        process.kill()
        process.wait()
        if process.stdin:
            process.stdin.close()


def _say(text: str) -> None:
    """Write to standard error, where there is one."""
    with contextlib.suppress(OSError, ValueError, AttributeError):
        sys.stderr.write(text)
        sys.stderr.flush()


def _read(report: Path) -> dict[str, Any]:
    """What the process wrote of itself so far."""
    try:
        found = json.loads(report.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def _ended(path: Path, status: int, found: dict[str, Any]) -> str:
    """How a process ended that did not say what became of the model."""
    if status < 0:
        with contextlib.suppress(ValueError):
            name = signal.Signals(-status).name
            return (
                f"the process that ran {path} was ended by the signal {name}; it may have needed more memory "
                "than there is, or have ended itself"
            )
    when = "while its equations were derived" if found.get("stage") == "deriving" else "while it was run"
    return (
        f"{path} ended its process with status {status} {when}; a model file must not call os._exit, and "
        "declares WALKER = Walker(...)"
    )


# -- in the process of its own -------------------------------------------------------------------------------


def _child() -> NoReturn:
    """Run and derive the model file that the command line names, and report what became of it."""
    path, out, keep, report = json.loads(sys.argv[2])
    sys.argv[1:] = []
    _end_with_parent()
    _notes.append(note := _Note(Path(report)))
    provide(show_work="stridemap.solver.model.derivation:_handed_on")
    try:
        derive = service("derive_file")
        note.write(stage="running")
        folder = derive(
            Path(path), None if out is None else Path(out), keep, lambda: note.write(stage="deriving")
        )
        found = {"folder": str(folder)}
    except StridemapError as error:
        found = {"kind": type(error).__name__, "error": str(error)}
    except BaseException as error:
        said = " ".join(str(error).split())[:300]
        found = {"kind": "InputError", "error": f"{path} cannot be derived ({type(error).__name__}: {said})"}
    with contextlib.suppress(Exception):
        sys.stdout.flush()
        sys.stderr.flush()
    note.write(**found)
    os._exit(0)  # threads of the model file are not waited for


class _Note:
    """Writes to the report in one step, so that it is never read by halves."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.entries: dict[str, Any] = {}

    def write(self, **entries: Any) -> None:
        self.entries |= entries
        half = self.path.with_suffix(".half")
        half.write_text(json.dumps(self.entries), encoding="utf-8")
        half.replace(self.path)


_notes: list[_Note] = []
"""That of this process, where it is one that was started to run a model file."""


@contextlib.contextmanager
def _handed_on(title: str, _unit: str = "") -> Iterator[Callable[..., None]]:
    """Show a piece of work of this process where the one that waits for it shows its own."""

    def update(done: int | None = None, total: int | None = None, detail: str = "") -> None:
        _notes[-1].write(work={"title": title, "done": done, "total": total, "detail": detail})

    update()
    yield update


def _end_with_parent() -> None:
    """End when the parent does, which holds the other end of standard input; the file reads nothing."""
    line = os.dup(0)
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.close(nothing)

    def wait() -> None:
        with contextlib.suppress(OSError):
            os.read(line, 1)
        os._exit(1)

    threading.Thread(target=wait, daemon=True).start()
