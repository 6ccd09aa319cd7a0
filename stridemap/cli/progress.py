"""How a sweep or a derivation shows that it moves: a bar on a terminal, plain lines elsewhere."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

if TYPE_CHECKING:
    from stridemap.sweeps.run import Progress as SweepProgress

LINE_EVERY = 10.0
"""Seconds between plain lines."""


@contextmanager
def show() -> "Iterator[Callable[[SweepProgress], None]]":
    """Show progress on standard error for as long as the context lasts; yields what to call."""
    console = Console(stderr=True)
    if not console.is_terminal:
        yield _lines()
        return
    columns = (
        TextColumn("round {task.fields[round]}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("tiles, {task.fields[rate]:.1f} tiles/s, {task.fields[orbits]:,} limit cycles, left"),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task("", total=None, round=1, orbits=0, rate=0.0)
        current, begun, before = 0, 0.0, 0

        def update(seen: "SweepProgress") -> None:
            nonlocal current, begun, before
            if seen.round != current:
                current, begun, before = seen.round, time.monotonic(), seen.done
                bar.reset(task, total=seen.total)
            rate = (seen.done - before) / max(time.monotonic() - begun, 1e-3)
            bar.update(
                task, completed=seen.done, total=seen.total, round=seen.round, orbits=seen.orbits, rate=rate
            )

        yield update


def _lines() -> "Callable[[SweepProgress], None]":
    """Plain lines, one at the end of each round and every `LINE_EVERY` seconds."""
    begun = last = time.monotonic()
    first: dict[int, tuple[float, int]] = {}

    def update(seen: "SweepProgress") -> None:
        nonlocal last
        now = time.monotonic()
        since, before = first.setdefault(seen.round, (now, seen.done))
        if seen.done < seen.total and now - last < LINE_EVERY:
            return
        last = now
        rate = (seen.done - before) / max(now - since, 1e-3)
        left = (
            f", {(seen.total - seen.done) / rate:.0f} s left" if rate > 0 and seen.done < seen.total else ""
        )
        print(
            f"round {seen.round}: {seen.done} of {seen.total} tiles ({rate:.1f} per second{left}), "
            f"{seen.orbits:,} limit cycles, {now - begun:.0f} s",
            file=sys.stderr,
            flush=True,
        )

    return update


def boundary_lines() -> Callable[[str], None]:
    """What prints how far boundaries are, on standard error: a line every `LINE_EVERY` seconds."""
    begun = time.monotonic()
    last = -LINE_EVERY

    def say(what: str) -> None:
        nonlocal last
        now = time.monotonic()
        if now - last >= LINE_EVERY:
            last = now
            print(f"boundaries: {what}, {now - begun:.0f} s", file=sys.stderr, flush=True)

    return say


QUIET = 1.0
"""Seconds that a derivation may take without a word."""

DERIVING_LINE_EVERY = 2.0
"""Seconds between plain lines of a derivation."""


@contextmanager
def show_deriving(model: str) -> "Iterator[Callable[[int, int, str], None]]":
    """Show on standard error how far the derivation of a model is, once it has taken a second.

    Parameters
    ----------
    model : str
        Its name.
    """
    console = Console(stderr=True)
    begun = last = time.monotonic()
    said = False

    def lines(done: int, total: int, name: str) -> None:
        nonlocal last, said
        now = time.monotonic()
        if now - begun < QUIET or (said and now - last < DERIVING_LINE_EVERY and done < total):
            return
        last, said = now, True
        what = f"{name} done" if done < total else "writing the kernels"
        print(
            f"deriving {model}: {done} of {total} functions, {what}, {now - begun:.0f} s",
            file=sys.stderr,
            flush=True,
        )

    if not console.is_terminal:
        yield lines
        return
    columns = (
        TextColumn(f"deriving {model}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.fields[what]}"),
    )
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task("", total=None, what="")

        def update(done: int, total: int, name: str) -> None:
            what = f"functions, {name} done" if done < total else "functions, writing the kernels"
            bar.update(task, completed=done, total=total, what=what)

        yield update
