"""What a sweep was computed with."""

import subprocess
from typing import Any

from stridemap.solver.backends.base import Kernels
from stridemap.solver.model.files import GENERATED
from stridemap.sweeps.software import versions
from stridemap.sweeps.tables import FORMAT, PARTS_FORMAT

DECIDING = ("format", "parts_format", "measures", "model_hash", "versions", "arithmetic", "tile_cells")
"""Entries on which the numbers depend. A sweep is continued only where they are the same; the commit and the
compiler's name are for readers."""


def provenance(kernels: Kernels) -> dict[str, Any]:
    """Model, versions, compiler and commit, as plain values without time or host.

    Parameters
    ----------
    kernels : Kernels

    Returns
    -------
    dict
        `commit` is None outside a checkout.
    """
    model = kernels.model
    return {
        "format": FORMAT,
        "parts_format": PARTS_FORMAT,
        "measures": list(model.measured),
        "model": model.name,
        "model_hash": model.hash,
        "versions": versions(),
        "arithmetic": kernels.backend.arithmetic,
        "compiler": kernels.compiler,
        "commit": _commit(),
    }


def _commit() -> str | None:
    """The checkout's commit, with a mark where there are changes on top of it."""
    git = ["git", "-C", str(GENERATED)]
    describe = [*git, "describe", "--always", "--dirty", "--abbrev=40", "--exclude=*"]
    # A package installed below somebody else's checkout is not of that checkout.
    tracked = [*git, "ls-files", "--error-unmatch", "compass/manifest.json"]
    try:
        runs = [
            subprocess.run(words, capture_output=True, text=True, check=False, timeout=10)
            for words in (tracked, describe)
        ]
    except (OSError, subprocess.TimeoutExpired):
        return None
    return runs[1].stdout.strip() or None if runs[0].returncode == 0 else None
