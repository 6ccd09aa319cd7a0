"""The step function in C, compiled, beside the same step by the simulator."""

import ctypes
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np

from stridemap.solver.model.model import Model
from stridemap.solver.model.scales import Scales
from stridemap.solver.walks.equations import Equations
from stridemap.solver.walks.outcomes import Outcome
from stridemap.solver.walks.swing import phases
from tests.oracles.states import need

STRICT = [
    "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wdouble-promotion", "-Wshadow", "-Wfloat-conversion",
    "-Werror",
]  # fmt: skip

STATUS = (
    "TOUCHDOWN", "NO_TOUCHDOWN", "ROCKS_BACK", "STOPS", "FALLS_FORWARD", "FALLS_BACKWARD", "NOT_FINITE",
    "NOT_ALLOWED",
)  # fmt: skip
OF_OUTCOME = {
    Outcome.WALKED: "TOUCHDOWN",
    Outcome.NO_TOUCHDOWN: "NO_TOUCHDOWN",
    Outcome.ROCKS_BACK: "ROCKS_BACK",
    Outcome.GOES_UPHILL: "ROCKS_BACK",
    Outcome.GOES_BACKWARD: "ROCKS_BACK",
    Outcome.STOPS: "STOPS",
    Outcome.FALLS_FORWARD: "FALLS_FORWARD",
    Outcome.FALLS_BACKWARD: "FALLS_BACKWARD",
    Outcome.FAILED: "NOT_FINITE",
}
"""What the C calls each outcome of the simulator."""


class StepInC:
    """The functions of ``<model>_step.c``, through a shared library."""

    def __init__(self, model: Model, folder: Path, single: bool = False) -> None:
        self.model, self.single = model, single
        name, library = model.name, folder / f"{model.name}{'_float' * single}.so"
        for ending in (".h", ".c", "_step.h", "_step.c"):
            (folder / f"{name}{ending}").write_text(model.text(f"{name}{ending}"))
        flags = ["-std=c99", "-O2", "-shared", "-fPIC", *["-DSTRIDEMAP_FLOAT"] * single]
        command = [need("cc", "gcc", "clang"), *flags, f"{name}.c", f"{name}_step.c", "-o", library, "-lm"]
        subprocess.run(command, cwd=folder, check=True)
        self.real = ctypes.c_float if single else ctypes.c_double
        self.library = ctypes.CDLL(str(library))

    def _function(self, name: str) -> Callable[..., int]:
        return getattr(self.library, f"{self.model.name}_{name}{'_float' * self.single}")

    def _array(self, values):
        return (self.real * len(values))(*values)

    def step(self, z, p, dt, most=10_000):
        """Status, section point and period after one step."""
        at, period = self._array(z), self.real()
        function = self._function("step")
        status = function(at, self._array(p), self.real(dt), ctypes.c_int(most), ctypes.byref(period))
        return STATUS[status], np.array(at[:], dtype=float), period.value

    def swing(self, t, q, v, p, dt, most=10_000):
        """Status, time and state just before the touchdown."""
        time, q, v = self.real(t), self._array(q), self._array(v)
        function = self._function("swing")
        status = function(ctypes.byref(time), q, v, self._array(p), self.real(dt), ctypes.c_int(most))
        return STATUS[status], time.value, np.array([*q, *v], dtype=float)


def simulated(model: Model, z, p):
    """The same by the simulator: status, section point (None without a touchdown) and duration."""
    walker = Equations(model, np.asarray(p, dtype=float))
    ((phase, landed),) = phases(walker, 0.0, walker.start(np.asarray(z, dtype=float)), 1)
    return OF_OUTCOME[phase.outcome], landed, phase.begin + phase.duration


def random_points(model: Model, count: int, seed: int, spread: float = 1.5):
    """Section points in and around the search box."""
    middle, half = np.array([model.spec.search_box[name] for name in model.section]).T
    rng = np.random.default_rng(seed)
    return middle + spread * half * rng.uniform(-1, 1, (count, len(middle)))


def usual_dt(model: Model) -> float:
    """A sixtieth of the scale of time."""
    return Scales.of(model).time / 60
