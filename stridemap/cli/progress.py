"""How a command shows that it moves: bars on a terminal, plain lines elsewhere, both on standard error.

What takes less than `QUIET` seconds is not mentioned. Whatever runs asks for it by name (`services.shown`),
so that the solver knows nothing of terminals.
"""

import sys
import threading
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    from stridemap.sweeps.run import Progress as SweepProgress

QUIET = 1.0
"""Seconds that a piece of work may take without a word."""

LINE_EVERY = 5.0
"""Seconds between plain lines."""

_silent = False


def be_quiet(quiet: bool = True) -> None:
    """Show nothing in this process, or show what there is again."""
    global _silent
    _silent = quiet


class _Shown(Protocol):
    """What shows a piece of work."""

    def update(
        self, done: int | None = None, total: int | None = None, detail: str = "", title: str | None = None
    ) -> None:
        """Show how many of how many pieces are done, what is being done, and under which title."""

    def end(self, well: bool) -> None:
        """Stop showing it."""


@contextmanager
def show_work(title: str, unit: str = "", ends: bool = False) -> "Iterator[Callable[..., None]]":
    """Show a piece of work for as long as the context lasts; yields `_Shown.update`.

    Parameters
    ----------
    title : str
        What it is, such as "compiling the kernels of compass".
    unit : str
        What its pieces are called, in the plural.
    ends : bool
        Whether plain lines also say when the last of some pieces is done, however little it took.
    """
    if _silent or sys.stderr is None:
        yield lambda *_args, **_words: None
        return
    shown: _Shown = _Bar(title, unit) if sys.stderr.isatty() else _Lines(title, unit, ends)
    well = False
    try:
        yield shown.update
        well = True
    finally:
        shown.end(well)


@contextmanager
def show(title: str = "") -> "Iterator[Callable[[SweepProgress], None]]":
    """Show a sweep; yields what to call with its `Progress`.

    Parameters
    ----------
    title : str
        Stands before the number of the round.
    """
    first: dict[int, tuple[float, int]] = {}
    with show_work(f"{title}preparing", "pieces", ends=True) as update:

        def seen(at: "SweepProgress") -> None:
            now = time.monotonic()
            since, before = first.setdefault(at.round, (now, at.done))
            rate = (at.done - before) / max(now - since, 1e-3)
            speed = f" ({rate:.2g} per second{_left(at, rate)})" if rate > 0 else ""
            update(at.done, at.total, f"{speed}, {at.orbits:,} limit cycles", f"{title}round {at.round}")

        yield seen


def _left(at: "SweepProgress", rate: float) -> str:
    return f", {(at.total - at.done) / rate:.0f} s left" if at.done < at.total else ""


class _Work(ABC):
    """A piece of work, and a clock that calls `_tick` while it lasts."""

    def __init__(self, title: str, unit: str) -> None:
        self.title, self.unit, self.detail = title, unit, ""
        self.done: int | None = None
        self.total: int | None = None
        self.begun = time.monotonic()
        self.lock = threading.RLock()
        self._over = threading.Event()
        self._clock = threading.Thread(target=self._run, daemon=True)
        self._clock.start()

    def _run(self) -> None:
        wait = max(QUIET - (time.monotonic() - self.begun), 0.01)
        while not self._over.wait(wait):
            with self.lock:
                if not self._over.is_set():
                    self._tick()
            wait = min(LINE_EVERY, 0.5)

    @abstractmethod
    def _tick(self) -> None:
        """The clock says that the work still goes on."""

    def update(
        self, done: int | None = None, total: int | None = None, detail: str = "", title: str | None = None
    ) -> None:
        with self.lock:
            self.done, self.total, self.detail = done, total, detail
            self.title = title or self.title
            self._changed()

    @abstractmethod
    def _changed(self) -> None:
        """More is done than before."""

    def end(self, well: bool) -> None:
        self._over.set()
        with self.lock:
            self._ended(well)

    @abstractmethod
    def _ended(self, well: bool) -> None:
        """The work is over."""

    @property
    def seconds(self) -> float:
        return time.monotonic() - self.begun

    def text(self, detail: str, counted: bool = True) -> str:
        """How far it is, in words; a detail that begins with a blank or a comma follows the count at once."""
        known = counted and self.done is not None
        count = f"{self.done:,} of {self.total:,} {self.unit}".rstrip() if known else ""
        parts = [count + detail] if detail.startswith((" ", ",")) else [count, detail]
        return ", ".join([*filter(None, parts), f"{self.seconds:.0f} s"])


_speakers: "list[_Lines]" = []
"""Work that goes on and speaks in plain lines, the innermost last."""


class _Lines(_Work):
    """Plain lines: after `QUIET` seconds, every `LINE_EVERY` seconds, and at the end of what was mentioned.

    Of work within work only the innermost speaks.
    """

    def __init__(self, title: str, unit: str, ends: bool) -> None:
        self.said: float | None = None
        self.ended: tuple[str, int | None] | None = None  # of which pieces it was said that all are done
        self.ends = ends
        _speakers.append(self)
        super().__init__(title, unit)

    def _tick(self) -> None:
        now = self.seconds
        due = now >= QUIET if self.said is None else now - self.said >= LINE_EVERY
        if due and _speakers[-1] is self:
            over = self.ended == (self.title, self.total)  # and what follows it has no name of its own
            self._say("finishing" if over else self.detail, counted=not over)

    def _changed(self) -> None:
        if self.ends and self.done is not None and self.done == self.total:
            self.ended = (self.title, self.total)
            self._say(self.detail)
        else:
            self._tick()

    def _ended(self, well: bool) -> None:
        _speakers.remove(self)
        if well and self.said is not None and not self.ends:
            self._say("done", counted=False)

    def _say(self, detail: str, counted: bool = True) -> None:
        self.said = self.seconds
        try:
            print(f"{self.title}: {self.text(detail, counted)}", file=sys.stderr, flush=True)
        except (OSError, ValueError):  # nobody listens any more; the work goes on
            self.said = float("inf")


class _Bar(_Work):
    """A row of a display on the terminal, which all work that goes on at a time shares."""

    def __init__(self, title: str, unit: str) -> None:
        self.row: Any = None
        super().__init__(title, unit)

    def _tick(self) -> None:
        if self.row is None and self.seconds >= QUIET:
            self.row = _display.add(self.title)
        self._changed()

    def _changed(self) -> None:
        if self.row is not None:
            _display.update(
                self.row,
                description=self.title,
                completed=self.done or 0,
                total=self.total,
                text=self.text(self.detail),
            )

    def _ended(self, well: bool) -> None:
        if self.row is not None:
            _display.remove(self.row)


class _Display:
    """The rows that are on the terminal."""

    def __init__(self) -> None:
        self.lock = threading.RLock()
        self.progress: Any = None
        self.rows = 0

    def add(self, title: str) -> Any:
        """A new row; the display begins with the first one."""
        from rich.console import Console
        from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn

        with self.lock:
            if self.progress is None:
                plain = {"markup": False}
                columns = (
                    SpinnerColumn(),
                    TextColumn("{task.description}", **plain),  # type: ignore[arg-type]
                    BarColumn(bar_width=24),
                    TextColumn("{task.fields[text]}", **plain),  # type: ignore[arg-type]
                )
                console = Console(stderr=True)
                self.progress = Progress(*columns, console=console, transient=True, redirect_stdout=False)
                self.progress.start()
            self.rows += 1
            return self.progress.add_task(title, total=None, text="")

    def update(self, row: Any, **values: Any) -> None:
        """Change a row."""
        with self.lock:
            self.progress.update(row, **values)

    def remove(self, row: Any) -> None:
        """Remove a row; the display ends with the last one."""
        with self.lock:
            self.progress.remove_task(row)
            self.rows -= 1
            if not self.rows:
                self.progress.stop()
                self.progress = None


_display = _Display()


@contextmanager
def show_lines(title: str) -> "Iterator[Callable[[str], None]]":
    """Show what says in a line now and then what is being done; yields what takes such a line."""
    with show_work(title) as update:
        yield lambda line: update(detail=line)
