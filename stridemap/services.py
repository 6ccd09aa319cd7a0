"""What a lower room may ask of an upper one without importing it.

An orbit offers `Orbit.plot`, and the path of a model file can be given wherever a model's name can; but
drawing and deriving live above the solver, and imports go one way only. So the top of the package, which
knows every room, says here where such a service lives, and whoever needs it asks for it by name when it is
used.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module
from typing import Any

_HOMES: dict[str, str] = {}


def provide(**homes: str) -> None:
    """State where services live, each as ``name="module:function"``."""
    _HOMES.update(homes)


def offered(name: str) -> bool:
    """Whether a service has been stated: some, such as showing progress, only a command offers."""
    return name in _HOMES


def service(name: str) -> Callable[..., Any]:
    """The function behind a service; its module is imported when it is first asked for."""
    module, _, function = _HOMES[name].partition(":")
    found: Callable[..., Any] = getattr(import_module(module), function)
    return found


SAID_AFTER = 1.0
"""Seconds after which something that is done once, and is announced, is mentioned to who is not shown it."""


@contextmanager
def shown(title: str, unit: str = "", announced: bool = False) -> Iterator[Callable[..., None]]:
    """Show how far a piece of work is, for as long as the context lasts, where a command offers to.

    Yields a function ``update(done, total, detail)``: how many of how many pieces are done, and what is being
    done, each of which may be left out.

    Parameters
    ----------
    title : str
        What it is, such as "compiling the kernels of compass".
    unit : str
        What its pieces are called, in the plural.
    announced : bool
        Whether a program that is shown nothing gets a line in its log, ``stridemap``, when it takes a second:
        for what is done once, so that a first call that is slow says why.
    """
    if offered("show_work"):
        with service("show_work")(title, unit) as update:
            yield update
        return
    import logging
    import threading

    log = logging.getLogger("stridemap").warning
    timer = threading.Timer(SAID_AFTER, log, [f"{title}; this is done once, and may take a while"])
    timer.daemon = True
    if announced:
        timer.start()
    try:
        yield _nothing
    finally:
        timer.cancel()


@contextmanager
def told(title: str, say: Callable[[str], None] | None) -> Iterator[Callable[[str], None]]:
    """Show a piece of work of which now and then a line says what is being done; yields what takes the line.

    Parameters
    ----------
    title : str
    say : callable or None
        Takes each line as well.
    """
    with shown(title) as update:

        def both(line: str) -> None:
            update(detail=line)
            if say is not None:
                say(line)

        yield both


def _nothing(*_args: Any, **_words: Any) -> None:
    """Show nothing."""
