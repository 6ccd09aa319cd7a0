"""All statements of the paper, evaluated."""

from collections.abc import Callable, Mapping
from concurrent.futures import Executor
from pathlib import Path
from typing import Any

from stridemap.errors import InputError
from stridemap.paper.claim import Claim, Statement
from stridemap.paper.cycle_tables import CycleTables, cycle_tables
from stridemap.paper.statements import efficiency, gaits, stability
from stridemap.paper.sweeps import paper_sweeps
from stridemap.services import shown
from stridemap.sweeps.run import Progress

STATEMENTS: dict[str, Statement] = {
    one.id: one
    for module in (gaits, stability, efficiency)
    for one in vars(module).values()
    if isinstance(one, Statement)
}
"""All statements of the paper by id."""


def evaluate(data: CycleTables) -> list[Claim]:
    """The verdict on each of the statements C1 to C20, in that order.

    Parameters
    ----------
    data : CycleTables
    """
    ordered = sorted(STATEMENTS.values(), key=lambda one: int(one.id[1:]))
    decided = []
    with shown("deciding the statements", "statements") as update:
        for number, one in enumerate(ordered):
            update(number, len(ordered), one.id)
            decided.append(one.drawn(data))
    return decided


def claims(
    sweeps: str | Path | None = None,
    *,
    params: Mapping[str, Any] | None = None,
    thin: int = 1,
    workers: int | None = None,
    executor: Executor | None = None,
    progress: Callable[[str, Progress], None] | None = None,
    out: str | Path | None = None,
) -> list[Claim]:
    """Decide the paper's statements C1 to C20 by computation.

    What the statements are about is swept the first time, which takes minutes, and read again afterwards;
    the paper's figures and report are made from the same sweeps.

    Parameters
    ----------
    sweeps : path, optional
        Folder of the sweeps; by default ``results/paper-sweeps``, with `params` and `thin` appended.
    params : mapping of str to float, optional
        Other values than the preset's for ``beta``, ``Kp``, ``Kd``, ``S`` and ``gamma``, which the paper
        does not print.
    thin : int
        Search only every `thin`-th value of k and alpha, which is faster and less certain.
    workers : int, optional
        Number of processes; by default one per core.
    executor : concurrent.futures.Executor, optional
        Runs the sweeps in place of processes that are started here.
    progress : callable, optional
        Called with the name of a sweep and a `Progress`.
    out : path, optional
        Former name of `sweeps`; refused.

    Returns
    -------
    list of Claim

    Raises
    ------
    InputError
        For unusable parameters, a folder with tables of another configuration, or when a sweep holds no
        physical gait.
    """
    if out is not None:
        raise InputError(f"the folder of the sweeps is given by `sweeps` now: write sweeps={str(out)!r}")
    return evaluate(
        cycle_tables(
            paper_sweeps(sweeps, params, thin, workers=workers, executor=executor, progress=progress)
        )
    )
