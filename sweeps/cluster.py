"""The workers of a Dask cluster, on this machine or on others, as the executor of a sweep.

Nothing of it is ours: Dask sends tiles to its workers, and those of a worker that died to another one.
"""

import contextlib
import json
import logging
import os
import re
import time
from collections.abc import Iterator, Mapping
from concurrent.futures import Executor
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from stridemap.errors import InputError, WorkerError, short
from stridemap.services import shown
from stridemap.solver.model.files import contents
from stridemap.sweeps.software import PACKAGES, other_software

if TYPE_CHECKING:
    from distributed import Client

TIMEOUT = 5.0
"""Seconds within which a scheduler must answer."""

ADDRESS = re.compile(r"((tcp|tls)://)?([\w.-]+|\[[\da-fA-F:.]+\]):(?P<port>\d{1,5})", re.ASCII)

REMEDY = (
    "give the address that `dask scheduler` prints, such as tcp://10.0.0.5:8786, or the path of its "
    "--scheduler-file"
)


def scheduler_address(given: str | Path) -> str:
    """The address of a scheduler, itself or from its scheduler file; nothing is asked there.

    Raises
    ------
    InputError
        When it is neither, or Dask is not installed.
    """
    if find_spec("distributed") is None:
        raise InputError(
            "a Dask cluster needs the package distributed, which is not installed here: run "
            "`pip install distributed`"
        )
    address = given
    if isinstance(given, str | os.PathLike) and os.path.isfile(given):
        try:
            address = json.loads(contents(given))["address"]
        except (OSError, ValueError, KeyError, TypeError, RecursionError):
            raise InputError(
                f"{short(os.fspath(given))} is not the scheduler file of a Dask cluster; {REMEDY}"
            ) from None
    found = ADDRESS.fullmatch(address) if isinstance(address, str) else None
    if found is None or not 0 < int(found["port"]) < 65536:
        raise InputError(f"{short(address)} is not the address of a Dask scheduler; {REMEDY}")
    return str(address)


@contextlib.contextmanager
def cluster(address: str) -> Iterator[Executor]:
    """The workers of a cluster, once there is one and all have our software.

    Parameters
    ----------
    address : str
        What `scheduler_address` returned.

    Raises
    ------
    InputError
        When no scheduler answers there.
    WorkerError
        When the scheduler or a worker has other versions than this process.
    """
    with _silenced(), _connected(address) as client:
        _wait_for_a_worker(client, address)
        _check_versions(client)
        # Not pure: its keys would be hashes of all that is in a task, and every task is submitted once.
        yield client.get_executor(pure=False)


@contextlib.contextmanager
def _connected(address: str) -> "Iterator[Client]":
    from distributed import Client

    try:
        with shown(f"connecting to {address}"):
            client = Client(address, timeout=TIMEOUT, set_as_default=False)
    except (OSError, ValueError, ImportError) as error:  # ImportError: its version of Dask is too different
        why = f"tried for {TIMEOUT:g} s" if isinstance(error, OSError) else short(str(error))
        raise InputError(f"no Dask scheduler answers at {address} ({why}); {REMEDY}") from None
    with client:
        yield client


def _wait_for_a_worker(client: "Client", address: str) -> None:
    """Wait until a first worker is there: in a queue, that may take hours."""
    with shown(f"waiting for a worker of {address}", announced=True):
        while not _asked(client.nthreads):
            time.sleep(0.2)


def _check_versions(client: "Client") -> None:
    """Refuse workers with other versions; each task looks again, because workers may come later."""
    found = _asked(client.get_versions, packages=PACKAGES)
    here = _versions(found["client"])
    theirs = {"the scheduler": found["scheduler"]}
    theirs |= {f"the worker {name}": worker for name, worker in sorted(found["workers"].items())}
    for who, what in theirs.items():
        if (there := _versions(what)) != here:
            raise WorkerError(other_software(who, there, here))


def _versions(process: Mapping[str, Any]) -> dict[str, str]:
    packages = process["packages"]
    python = ".".join(str(packages["python"]).split(".")[:3])
    return {"python": python, **{name: packages.get(name) or "" for name in PACKAGES}}


def _asked(question: Any, **words: Any) -> Any:
    """The scheduler's answer."""
    try:
        return question(**words)
    except OSError as error:
        raise WorkerError(
            f"the scheduler no longer answers ({short(str(error))}); continue with --resume"
        ) from None


@contextlib.contextmanager
def _silenced() -> Iterator[None]:
    """Leave it to our own sentence to say what fails; what Dask logs beside it has many lines."""
    import distributed  # it sets the levels of its loggers

    names = (distributed.__name__, "distributed.client", "distributed.core", "tornado", "tornado.application")
    loggers = [logging.getLogger(name) for name in names]
    levels = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL)
    try:
        yield
    finally:
        for logger, level in zip(loggers, levels, strict=True):
            logger.setLevel(level)
