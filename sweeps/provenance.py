"""What a sweep was computed with."""

import platform
import subprocess
from importlib.metadata import version
from typing import Any

from stridemap.solver.backends.library import Kernels
from stridemap.solver.model.files import GENERATED
from stridemap.solver.model.model import Model

PACKAGES = ("stridemap", "numpy", "scipy", "casadi", "pyarrow")


def provenance(model: Model, kernels: Kernels) -> dict[str, Any]:
    """Model, versions, compiler and commit, as plain values without time or host.

    Parameters
    ----------
    model : Model
    kernels : Kernels

    Returns
    -------
    dict
        `commit` is None outside a checkout.
    """
    return {
        "model": model.name,
        "model_hash": model.hash,
        "versions": {"python": platform.python_version(), **{name: version(name) for name in PACKAGES}},
        "compiler": kernels.compiler,
        "commit": _commit(),
    }


def _commit() -> str | None:
    """The checkout's commit, with a mark where there are changes on top of it."""
    command = [
        "git",
        "-C",
        str(GENERATED),
        "describe",
        "--always",
        "--dirty",
        "--abbrev=40",
        "--exclude=*",
    ]
    try:
        run = subprocess.run(command, capture_output=True, text=True, check=False, timeout=10)
    except (OSError, subprocess.TimeoutExpired):
        return None
    # A package installed below somebody else's checkout is not of that checkout.
    tracked = subprocess.run(
        ["git", "-C", str(GENERATED), "ls-files", "--error-unmatch", "compass/manifest.json"],
        capture_output=True,
        check=False,
    )
    return run.stdout.strip() or None if tracked.returncode == 0 else None
