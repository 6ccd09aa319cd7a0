"""All statements of the paper, evaluated."""

from collections.abc import Callable, Mapping
from concurrent.futures import Executor
from pathlib import Path
from typing import Any

from stridemap.paper.claim import Claim, Statement
from stridemap.paper.data import PaperData, collect
from stridemap.paper.statements import efficiency as measures
from stridemap.paper.statements import gaits, stability
from stridemap.sweeps.run import Progress

STATEMENTS: dict[str, Statement] = {
    one.id: one
    for module in (gaits, stability, measures)
    for one in vars(module).values()
    if isinstance(one, Statement)
}
"""All statements of the paper by id."""


def default_folder(params: Mapping[str, Any] | None = None, thin: int = 1) -> Path:
    """Folder of the sweeps below the current one: another one for each choice of parameters."""
    words = ["paper-claims", *(f"{name}={value}" for name, value in sorted((params or {}).items()))]
    return Path("results") / "-".join([*words, f"thin={thin}"] if thin != 1 else words)


def evaluate(data: PaperData) -> list[Claim]:
    """The verdict on each of the statements C1 to C20, in that order.

    Parameters
    ----------
    data : PaperData
    """
    ordered = sorted(STATEMENTS.values(), key=lambda one: int(one.id[1:]))
    return [one(data) for one in ordered]


def claims(
    out: str | Path | None = None,
    *,
    params: Mapping[str, Any] | None = None,
    thin: int = 1,
    workers: int | None = None,
    executor: Executor | None = None,
    progress: Callable[[str, Progress], None] | None = None,
) -> list[Claim]:
    """Decide the paper's statements C1 to C20 by computation.

    Sweeps what the statements are about (the first time it takes minutes), or takes up what an earlier call
    left in the folder.

    Parameters
    ----------
    out : path, optional
        Folder of the sweeps; ``results/paper-claims`` if it is left out.
    params : mapping of str to float, optional
        Other values than the preset's for ``beta``, ``Kp``, ``Kd``, ``S`` and ``gamma``, which the paper
        does not print.
    thin : int
        Search only every so-manieth value of k and alpha: faster, and less sure.
    workers : int, optional
        Number of processes; by default one a core.
    executor : concurrent.futures.Executor, optional
        Runs the sweeps in place of processes of our own.
    progress : callable, optional
        Called with the name of a sweep and a `Progress`.

    Returns
    -------
    list of Claim

    Raises
    ------
    InputError
        For unusable parameters, a folder with tables of another configuration, or when nothing walks.
    """
    folder = default_folder(params, thin) if out is None else out
    return evaluate(collect(folder, params, thin=thin, workers=workers, executor=executor, progress=progress))
