"""stridemap: limit cycles, exact Floquet multipliers and parameter sweeps of walking models.

>>> import stridemap
>>> orbits = stridemap.find_orbits("wobbling", k=6, alpha=0.25, omega=3)
>>> [orbit.group for orbit in orbits]
['B', 'B']
>>> stridemap.load("wobbling").mass_matrix
Function(mass_matrix:(t,q[3],v[3],u,p[9])->(M[3x3]) SXFunction)
"""

from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any

from stridemap.services import provide

# The one list of public names. Type checkers read it as it stands; when the package runs, `__getattr__` reads
# it too and imports a name when it is first used (PEP 562), so that each room can be imported alone, and
# `import stridemap` loads next to nothing.
if TYPE_CHECKING:
    from stridemap.codegen import derive_model
    from stridemap.columns import Column
    from stridemap.controller import write_c
    from stridemap.errors import CompilerError, InputError, StorageError, StridemapError, WorkerError
    from stridemap.paper.claim import Claim, Verdict
    from stridemap.paper.evaluate import claims
    from stridemap.quantities import QUANTITIES
    from stridemap.solver.api.boundaries import boundaries
    from stridemap.solver.api.branches import branches
    from stridemap.solver.api.points import find_orbits, motion, simulate
    from stridemap.solver.api.targets import Matches, find
    from stridemap.solver.backends.base import Backend
    from stridemap.solver.backends.interpreter import Interpreter
    from stridemap.solver.backends.lanes import Lanes
    from stridemap.solver.backends.scalar import ScalarC
    from stridemap.solver.boundaries.boundaries import Boundaries, DoublePoint
    from stridemap.solver.branches.branches import Branches, SpecialPoint
    from stridemap.solver.cycles.gait import is_physical_gait
    from stridemap.solver.cycles.orbit import Orbit
    from stridemap.solver.cycles.orbits import Orbits
    from stridemap.solver.cycles.report import SearchReport
    from stridemap.solver.cycles.status import Status
    from stridemap.solver.model.loading import available, load
    from stridemap.solver.model.model import Model
    from stridemap.solver.observables.motion import Motion
    from stridemap.solver.options import (
        AcceptanceOptions,
        ContinuationOptions,
        SearchOptions,
    )
    from stridemap.solver.walks.outcomes import Outcome
    from stridemap.solver.walks.simulator import Step, Walk
    from stridemap.solver.walks.trajectory import Trajectory
    from stridemap.spec import ModelSpec, Parameter, Quantity
    from stridemap.sweeps.config import SweepConfig, load_config, parse_config
    from stridemap.sweeps.run import Progress, Summary, sweep
    from stridemap.sweeps.store import read_cells, read_orbits, read_provenance, read_special
    from stridemap.tables.reading import read_batches, read_table
    from stridemap.tables.table import Table
    from stridemap.units import Units, critical_damping
    from stridemap.views.animation import animate

    __version__: str


@cache
def _homes() -> dict[str, str]:
    """Where each public name lives, from the list above."""
    import ast
    import inspect
    import sys

    source = inspect.getsource(sys.modules[__name__])
    (block,) = (node for node in ast.parse(source).body if isinstance(node, ast.If))
    imports = (node for node in block.body if isinstance(node, ast.ImportFrom))
    return {alias.name: node.module or "" for node in imports for alias in node.names}


provide(
    animate="stridemap.views.animation:animate",
    boundary_map="stridemap.views.boundary_map:boundary_map",
    branch_diagram="stridemap.views.branch_diagram:branch_diagram",
    derive_file="stridemap.codegen:derive_file",
    export="stridemap.tables.export:export",
    in_si="stridemap.tables.conversion:in_si",
    picture="stridemap.views.notebook:picture",
    plot="stridemap.views.plots:plot",
    plot_table="stridemap.views.scatter:plot_table",
    simulate="stridemap.solver.api.points:simulate",
    table_of="stridemap.tables.table:table_of",
    table_si="stridemap.tables.conversion:table_si",
    to_xarray="stridemap.tables.gridded:to_xarray",
)


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        value: Any = version("stridemap")
    elif name == "__all__":
        value = ["__version__", *sorted(_homes())]
    elif name.startswith("__") or name not in _homes():
        raise AttributeError(f"module 'stridemap' has no attribute {name!r}")
    else:
        value = getattr(import_module(_homes()[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    names: list[str] = __getattr__("__all__")
    return names
