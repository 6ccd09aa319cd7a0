"""stridemap: limit cycles, exact Floquet multipliers and parameter sweeps of walking models.

>>> import stridemap
>>> orbits = stridemap.find_orbits("wobbling", k=6, alpha=0.25, omega=3)
>>> [orbit.group for orbit in orbits]
['B', 'B']
>>> stridemap.load("wobbling").mass_matrix
Function(mass_matrix:(q[3],p[8])->(M[3x3]) SXFunction)
"""

from importlib.metadata import version
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from stridemap.codegen import derive_model
    from stridemap.errors import InputError
    from stridemap.paper.claim import Claim, Verdict
    from stridemap.paper.evaluate import claims
    from stridemap.solver.api import find_orbits, simulate
    from stridemap.solver.cycles.orbit import Orbit, Status
    from stridemap.solver.cycles.search import SearchOptions
    from stridemap.solver.model.model import Model, load
    from stridemap.solver.observables.motion import Motion, motion
    from stridemap.sweeps.run import sweep
    from stridemap.sweeps.store import read_cells, read_orbits
    from stridemap.units import Units
    from stridemap.views.animate import animate

__version__ = version("stridemap")

_HOMES = {
    "Claim": "stridemap.paper.claim",
    "InputError": "stridemap.errors",
    "Model": "stridemap.solver.model.model",
    "Motion": "stridemap.solver.observables.motion",
    "Orbit": "stridemap.solver.cycles.orbit",
    "SearchOptions": "stridemap.solver.cycles.search",
    "Status": "stridemap.solver.cycles.orbit",
    "Units": "stridemap.units",
    "Verdict": "stridemap.paper.claim",
    "animate": "stridemap.views.animate",
    "claims": "stridemap.paper.evaluate",
    "derive_model": "stridemap.codegen",
    "find_orbits": "stridemap.solver.api",
    "load": "stridemap.solver.model.model",
    "motion": "stridemap.solver.observables.motion",
    "read_cells": "stridemap.sweeps.store",
    "read_orbits": "stridemap.sweeps.store",
    "simulate": "stridemap.solver.api",
    "sweep": "stridemap.sweeps.run",
}

__all__ = [
    "Claim",
    "InputError",
    "Model",
    "Motion",
    "Orbit",
    "SearchOptions",
    "Status",
    "Units",
    "Verdict",
    "__version__",
    "animate",
    "claims",
    "derive_model",
    "find_orbits",
    "load",
    "motion",
    "read_cells",
    "read_orbits",
    "simulate",
    "sweep",
]


def __getattr__(name: str) -> Any:
    """Import a public name when it is first used, so that each part can be imported alone."""
    if name not in _HOMES:
        raise AttributeError(f"module 'stridemap' has no attribute {name!r}")
    from importlib import import_module

    value = getattr(import_module(_HOMES[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """Public names, loaded or not."""
    return sorted(__all__)
