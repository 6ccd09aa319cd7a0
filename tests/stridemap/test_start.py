"""What a start loads: counted in modules, not in seconds."""

import json
import pickle
import subprocess
import sys

import numpy as np
import pytest

from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.model.loading import load
from stridemap.solver.options import IN_SWEEPS, AcceptanceOptions, SearchOptions
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.solutions import Guesses, Solutions
from stridemap.sweeps.tasks import Task
from tests.oracles.kernels import needs_compiler

pytestmark = pytest.mark.quick

TABLES = {"pandas", "pyarrow"}
SLOW = TABLES | {"scipy", "sympy", "matplotlib", "rich", "mpmath"}
"""Packages each of which takes longer to load than a search at one point takes altogether."""

LISTED = "import json; print(json.dumps(sorted(sys.modules)), file=sys.stderr)"


def loaded(code, *words):
    """Names of the modules that a new process has loaded at its end, beyond those of Python itself."""
    bare = "import sys; " + LISTED
    before, after = (
        subprocess.run([sys.executable, "-c", one, *words], capture_output=True, text=True, check=True)
        for one in (bare, f"import sys\n{code}\n{LISTED}")
    )
    return set(json.loads(after.stderr.splitlines()[-1])) - set(json.loads(before.stderr.splitlines()[-1]))


def packages(modules):
    return {name.partition(".")[0] for name in modules}


COMMAND = """
from stridemap.cli.app import main
try:
    main()
except SystemExit as end:
    assert not end.code
"""


def test_the_package_loads_next_to_nothing():
    modules = loaded("import stridemap")
    ours = {name for name in modules if name.startswith("stridemap")}
    assert ours == {"stridemap", "stridemap.services"}
    assert packages(modules) - {"stridemap"} <= set(sys.stdlib_module_names)
    assert not modules & {"importlib.metadata", "inspect", "ast"}


def test_the_version_is_printed_without_any_of_the_rooms():
    modules = loaded(COMMAND, "version")
    assert not packages(modules) & (SLOW | {"numpy", "casadi"})
    assert not {name for name in modules if name.startswith(("stridemap.solver", "stridemap.sweeps"))}


@needs_compiler
def test_cycles_at_one_point_are_found_without_what_is_slow_to_load():
    load("compass")
    modules = loaded(COMMAND, "orbit", "--model", "compass", "--starts", "16")
    assert "stridemap.solver.cycles.search" in modules
    assert not packages(modules) & (SLOW | {"pydantic"})
    assert "numpy.ma" not in modules
    others = (
        "stridemap.derive",
        "stridemap.sweeps",
        "stridemap.views",
        "stridemap.paper",
        "stridemap.codegen",
    )
    assert not {name for name in modules if name.startswith(others)}


def test_a_worker_loads_neither_tables_nor_commands(tmp_path):
    model = load("rimless_wheel")
    nothing = Guesses.concatenate([], len(model.section) + 1)
    seen = Solutions.concatenate([], len(model.section) + 1)
    slope = model.preset["slope"] * np.array([1.0, 1.01])
    params = {name: value for name, value in model.preset.items() if name != "slope"}
    search, cells = SearchOptions(starts=64).resolved_for(model), np.arange(2)
    grid = Grid(("slope",), (slope,))
    task = Task(
        *(model, grid, params, search, AcceptanceOptions(), IN_SWEEPS, Interpreter(), 1, 0, cells),
        *(cells, nothing, seen, seen),
    )
    (tmp_path / "task").write_bytes(pickle.dumps(task))
    code = (
        "import pickle\nfrom stridemap.sweeps.tiles import work\n"
        "result = work(pickle.load(open(sys.argv[1], 'rb')))\npickle.dumps(result)\n"
        "assert len(result.orbits['cell']) >= 2 and not result.failures"
    )
    modules = loaded(code, str(tmp_path / "task"))
    assert not packages(modules) & (SLOW | {"typer", "pydantic"})
