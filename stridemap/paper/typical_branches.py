"""The branches through the paper's typical solutions, followed over the spring and kept beside its sweeps."""

import hashlib
import json
import os
from collections.abc import Callable
from pathlib import Path

from stridemap.paper.points import PLANE
from stridemap.paper.sweeps import PaperSweeps
from stridemap.services import told
from stridemap.solver.api.branches import branches
from stridemap.solver.model.loading import load

FORMAT = 1
"""Of what is kept; it rises when what is computed changes."""

SPECIAL = "_special"
"""Stands behind the name of the table of special points, as `stridemap branch --out` writes it."""


def typical_branches(sweeps: PaperSweeps, say: Callable[[str], None] | None = None) -> Path:
    """The table of all branches over the spring stiffness where the typical solutions are.

    They are followed when they are first asked for, and lie beside the sweeps afterwards.

    Parameters
    ----------
    sweeps : PaperSweeps
    say : callable, optional
        Takes a line that says what is being done.

    Returns
    -------
    pathlib.Path
        A table as ``stridemap branch --out`` writes it, with that of the special points beside it.
    """
    config = sweeps.configs["map"]
    springs = config.grid["k"]
    ends, params = (springs[0], springs[-1]), {**config.params, **PLANE}
    parts = [FORMAT, load(config.model).hash, ends, params]
    key = hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()[:16]
    path = sweeps.folder / f"typical-branches-{key}.parquet"
    if path.exists():
        return path
    with told("branches through the typical solutions", say) as progress:
        found = branches(config.model, "k", ends, params, progress=progress)
        points, special = found.save(path.with_stem(f".{path.stem}.{os.getpid()}"))
    os.replace(special, path.with_stem(path.stem + SPECIAL))
    os.replace(points, path)  # the last: it says that both are whole
    return path
