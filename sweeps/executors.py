"""Worker processes of a sweep, and how interrupts reach them: not at all."""

import contextlib
import multiprocessing
import os
import signal
import threading
import warnings
from collections.abc import Iterator
from concurrent.futures import Executor, ProcessPoolExecutor


@contextlib.contextmanager
def processes(workers: int) -> Iterator[Executor]:
    """Worker processes that leave an interrupt to the parent, which ends them: what they work at is lost."""
    context = multiprocessing.get_context("spawn")
    others = set(multiprocessing.active_children())
    pool = ProcessPoolExecutor(workers, mp_context=context, initializer=_follow_parent)
    try:
        yield pool
    except KeyboardInterrupt:
        with interrupts_held():  # who presses twice need not wait, nor leave workers behind
            for worker in set(multiprocessing.active_children()) - others:
                worker.terminate()
            pool.shutdown(wait=True, cancel_futures=True)
        raise
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


@contextlib.contextmanager
def interrupts_held() -> Iterator[None]:
    """Hold interrupts back; a process started in here never gets one, not even while it starts."""
    came: list[int] = []
    mask = getattr(signal, "pthread_sigmask", None)  # what a process inherits; not on Windows
    blocked = mask(signal.SIG_BLOCK, {signal.SIGINT}) if mask else None
    # Another thread may take a blocked signal, and Python then interrupts the main thread all the same.
    held = (signal.SIGINT, signal.SIGTERM) if threading.current_thread() is threading.main_thread() else ()
    handlers = {number: signal.signal(number, lambda got, _: came.append(got)) for number in held}
    try:
        yield
    finally:
        for signum, handler in handlers.items():
            signal.signal(signum, handler)
        if mask:
            mask(signal.SIG_SETMASK, blocked)
    for number in came[:1]:
        signal.raise_signal(number)


def _follow_parent() -> None:
    """Leave interrupts and warnings to the parent, and end when it is killed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    warnings.simplefilter("ignore")
    parent = multiprocessing.parent_process()
    if parent is not None:

        def wait() -> None:
            parent.join()
            os._exit(1)

        threading.Thread(target=wait, daemon=True).start()
