"""How fast limit cycles are found, beside the paper's practice: ``python -m benchmarks.bench``.

One process, one thread, one run. Both sides start from the same guesses for the same cycles: every cycle in
the groups A, B and C at `POINTS`, stable and unstable, pairs of cycles at one point included, each guess off
by up to 1 % in every entry. Repetitions of all measurements alternate, so that a busy moment of the machine
hits them alike; the table shows medians, and the best in brackets.

*stridemap* is timed in batches, from guesses to complete orbits: closed to 1e-11, checked at twice the
resolution, multipliers from the exact derivative, extrema in continuous time, work split at its kinks.

*The paper's practice* (MATLAB's ``fsolve``), as one would write it with SciPy: `fsolve` to 1e-9 on the step
map's closing error, with `solve_ivp` up to the touchdown event; once with RK45, the default of `solve_ivp`
and the method of MATLAB's ``ode45``, and once with DOP853, the fastest of SciPy's methods here. The
integrator's tolerances are 1e-10 and 1e-12: with 1e-9 the cycles come out several digits worse than 1e-9.
The right-hand side is the generated one on plain floats with `math.sin`, which is several times faster than
on arrays. The multipliers are the eigenvalues of a matrix of central differences; d_max and work come from
1,000 samples of one more integration, evaluated as arrays.

*A whole sweep* has no guesses: it finds its cycles from quasi-random starts and along branches. Its rate is
in processor time, and everything counts, from the configuration to the tables.
"""

import argparse
import json
import math
import platform
import statistics
import sys
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import Executor, Future
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve

from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.run import sweep

POINTS = (
    {"k": 0.5, "alpha": 0.25, "omega": 3.0},
    {"k": 2.0, "alpha": 0.25, "omega": 3.0},
    {"k": 6.0, "alpha": 0.25, "omega": 3.0},
    {"k": 8.0, "alpha": 0.25, "omega": 2.5},
    {"k": 12.0, "alpha": 0.5, "omega": 3.0},
    {"k": 22.5, "alpha": 0.25, "omega": 3.0},
    {"k": 26.0, "alpha": 0.25, "omega": 3.0},
    {"k": 7.0, "alpha": 0.5, "omega": 2.0},
)
GRID = {
    "k": {"start": 5.0, "stop": 60.0, "num": 400},
    "alpha": {"start": 0.15, "stop": 0.6, "num": 10},
    "omega": [2.0, 3.0],
}
"""What the whole sweep is of. Its starts are as far apart along k as in the default sweep, by 1.5; as there,
special points are not located."""
NEXT_CELL = {"k": 0.5}
"""To the neighbouring cell of the default sweep's grid."""
METHODS = ("RK45", "DOP853")
OFF = 0.01
RESOLUTION = 24
"""RK steps of the step map in the first two rows."""


@dataclass(frozen=True)
class Cycles:
    """What is solved: guesses at points, and the cycle that each is meant for."""

    params: np.ndarray
    guesses: np.ndarray
    cycles: np.ndarray
    groups: tuple[str, ...]
    stable: tuple[bool, ...]


def cycles_to_find(model: Model) -> Cycles:
    """Every cycle of the groups A, B and C at `POINTS`, with a guess `OFF` from it."""
    points = np.array([model.point(p) for p in POINTS])
    _, orbits = find_all(Solver.for_model(model), points)
    orbits = orbits[np.isin(orbits.group, ("A", "B", "C"))]
    noise = np.random.default_rng(0).uniform(-OFF, OFF, orbits.u.shape)
    return Cycles(
        orbits.params,
        orbits.u * (1 + noise),
        orbits.u,
        tuple(orbits.group.tolist()),
        tuple(orbits.stable.tolist()),
    )


# -- stridemap -------------------------------------------------------------------------------------------


def converged_cycles(solver: Solver, guesses: np.ndarray, params: np.ndarray) -> Orbits:
    """Orbits from guesses, as a sweep computes them."""
    u, _ = solver.search(guesses, params)
    return solver.converge(u, params, (0.3, 3.0))


# -- the paper's practice --------------------------------------------------------------------------------


class Practice:
    """Limit cycles by `fsolve` over `solve_ivp` with a touchdown event.

    Parameters
    ----------
    model : Model
    params : ndarray, shape (n_params,)
    method : str
        Of `solve_ivp`.
    """

    xtol, rtol, atol = 1e-9, 1e-10, 1e-12

    def __init__(self, model: Model, params: np.ndarray, method: str) -> None:
        self.model, self.params, self.p, self.method = model, params, params.tolist(), method
        equations, p = model.equations, self.p

        def rate(t: float, y: np.ndarray) -> list[float]:
            theta1, theta2, x, dtheta1, dtheta2, dx = y.tolist()
            out = equations.state_derivative(math, t, (theta1, theta2, x), (dtheta1, dtheta2, dx), p)
            return out["dq"] + out["dv"]

        def touchdown(t: float, y: np.ndarray) -> float:
            return y[1] - 2 * y[0] if y[0] < 0 else 1.0

        touchdown.terminal, touchdown.direction = True, 1.0  # type: ignore[attr-defined]
        self.rate, self.touchdown = rate, touchdown
        self.evaluations = 0

    def swing(self, z: np.ndarray, **options: Any) -> Any:
        """Integrate one swing phase."""
        theta1, dtheta1, dtheta2, x, dx = z.tolist()
        start = [theta1, 2 * theta1, x, dtheta1, dtheta2, dx]
        options |= {"events": self.touchdown, "rtol": self.rtol, "atol": self.atol}
        return solve_ivp(self.rate, (0, 5), start, self.method, **options)

    def step(self, z: np.ndarray) -> np.ndarray:
        """The step map: section point after the impact."""
        self.evaluations += 1
        y = self.swing(z).y[:, -1].tolist()
        out = self.model.equations.impact_map(math, y[:3], y[3:], self.p)
        q, v = out["q_plus"], out["v_plus"]
        return np.array([q[0], v[0], v[1], q[2], v[2]])

    def cycle(self, guess: np.ndarray) -> tuple[np.ndarray, np.ndarray, float, float]:
        """Section point, multipliers, d_max and CoT."""
        # Difference quotients need a step well above the integrator's error.
        z = fsolve(lambda z: self.step(z) - z, guess, xtol=self.xtol, epsfcn=1e-8)
        size = 1e-4
        columns = [(self.step(z + size * e) - self.step(z - size * e)) / (2 * size) for e in np.eye(len(z))]
        multipliers = np.linalg.eigvals(np.array(columns).T)
        motion = self.swing(z, dense_output=True)
        t = np.linspace(0, motion.t[-1], 1000)
        y = motion.sol(t).T
        values = {"t": t, "q": y[:, :3], "v": y[:, 3:], "p": self.params}
        d_max = np.abs(self.model.evaluate("zmp", **values)["d"]).max()
        power = np.abs(self.model.evaluate("controller_torque", **values)["u"][:, 0] * y[:, 4])
        mass = self.model.evaluate("total_mass", p=self.params)["mass"]
        return z, multipliers, float(d_max), float(np.trapezoid(power, t) / (mass * 2 * math.sin(z[0])))


# -- a whole sweep ---------------------------------------------------------------------------------------


class Here(Executor):
    """Computes each tile at once, in this process."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """The result, in a future."""
        future: Future[Any] = Future()
        future.set_result(fn(*args, **kwargs))
        return future


def whole_sweep() -> dict[str, float]:
    """Cells, limit cycles and processor seconds of the sweep of `GRID`."""
    search = {"starts": 48, "subgrid": {"k": 11}}
    config = {"model": "wobbling", "grid": GRID, "search": search, "special_points": False}
    with tempfile.TemporaryDirectory() as folder:
        start = time.process_time()
        summary = sweep(parse_config(config), Path(folder, "out"), executor=Here())
        seconds = time.process_time() - start
    return {"cells": summary.cells, "cycles": summary.orbits, "seconds": seconds}


# -- measuring -------------------------------------------------------------------------------------------


def timed(work: Callable[[], Any]) -> tuple[float, Any]:
    """Wall time and result."""
    start = time.perf_counter()
    result = work()
    return time.perf_counter() - start, result


def measure(batch: int, repeat: int, practice_repeat: int) -> dict[str, Any]:
    """Run everything; rates are per second, one entry per repetition."""
    model = load("wobbling")
    solver = Solver.for_model(model)
    todo = cycles_to_find(model)
    n = len(todo.cycles)
    copies = -(-batch // n)
    which = np.tile(np.arange(n), copies)
    params, cycles = todo.params[which], todo.cycles[which]
    noise = np.random.default_rng(1).uniform(-OFF, OFF, cycles.shape)
    noise[:n] = todo.guesses / todo.cycles - 1
    guesses = cycles * (1 + noise)
    shifted = params.copy()
    for name, by in NEXT_CELL.items():
        shifted[:, list(model.preset).index(name)] += by

    rates: dict[str, list[float]] = {
        key: [] for key in ("step", "variational", "cycle", "neighbour", *METHODS)
    }
    found = {"cycle": 0.0, "neighbour": 0.0}
    practice: dict[str, dict[str, float]] = {}
    for turn in range(repeat):
        seconds, _ = timed(lambda: solver.kernels.residual(RESOLUTION, cycles, params))
        rates["step"].append(len(cycles) / seconds)
        seconds, _ = timed(lambda: solver.kernels.jacobian(RESOLUTION, cycles, params))
        rates["variational"].append(len(cycles) / seconds)
        for key, starts, points in (("cycle", guesses, params), ("neighbour", cycles, shifted)):
            seconds, orbits = timed(
                lambda starts=starts, points=points: converged_cycles(solver, starts, points)
            )
            good = int(orbits.found.sum())
            found[key] = good / len(orbits)
            rates[key].append(good / seconds)  # only what was found counts
        for method in METHODS:
            if turn < practice_repeat:
                seconds, practice[method] = timed(lambda method=method: practice_cycles(model, todo, method))
                rates[method].append(n / seconds)
    return {
        "sweep": whole_sweep(),
        "rates": rates,
        "found": found,
        "practice": practice,
        "batch": len(which),
        "set": {
            "points": list(POINTS),
            "cycles": n,
            "groups": {g: todo.groups.count(g) for g in "ABC"},
            "stable": sum(todo.stable),
        },
        "machine": {
            "processor": _processor(),
            "python": platform.python_version(),
            "numpy": np.__version__,
            "casadi": ca.__version__,
            "kernels": solver.kernels.compiler,
        },
    }


def practice_cycles(model: Model, todo: Cycles, method: str) -> dict[str, float]:
    """All cycles by the paper's practice: largest distance from ours, and step maps per cycle."""
    distance, evaluations = 0.0, 0
    for point, guess, cycle in zip(todo.params, todo.guesses, todo.cycles, strict=True):
        practice = Practice(model, point, method)
        z, *_ = practice.cycle(guess[:-1])
        distance = max(distance, float(np.abs(z - cycle[:-1]).max()))
        evaluations += practice.evaluations
    return {"distance": distance, "step_maps": evaluations / len(todo.cycles)}


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


# -- the table -------------------------------------------------------------------------------------------


def table(result: dict[str, Any]) -> str:
    """The result in words."""
    rates, machine, chosen = result["rates"], result["machine"], result["set"]
    middle = {key: statistics.median(values) for key, values in rates.items()}
    best = {key: max(values) for key, values in rates.items()}
    swept = result["sweep"]
    sweep_rate = swept["cycles"] / swept["seconds"]
    name = f"whole sweep, {swept['cells']:,} cells, per processor second"

    def row(name: str, key: str, digits: int = 0) -> str:
        return f"{name:55s} {middle[key]:>11,.{digits}f}   ({best[key]:,.{digits}f})"

    lines = [
        f"{machine['processor']}, one core; {machine['kernels']}",
        f"{chosen['cycles']} cycles at {len(chosen['points'])} points "
        f"({', '.join(f'{n} in {g}' for g, n in chosen['groups'].items())}; {chosen['stable']} stable), "
        f"in batches of {result['batch']}",
        "",
        f"per second, median of {len(rates['cycle'])} repetitions (and the best)",
        row(f"steps of the walker ({RESOLUTION} Runge-Kutta steps of order 8)", "step"),
        row("  with variational equations", "variational"),
        row(f"complete limit cycles, from {OFF:.0%} off", "cycle"),
        row("  from the cycle of the neighbouring cell", "neighbour"),
        *(row(f"the same by fsolve over solve_ivp, {m}, from {OFF:.0%} off", m, 2) for m in METHODS),
        *(f"{'ratio to ' + m:55s} {middle['cycle'] / middle[m]:>11,.0f}" for m in METHODS),
        "",
        f"{name:55s} {sweep_rate:>11,.0f}",
        *(f"{'ratio to ' + m:55s} {sweep_rate / middle[m]:>11,.0f}" for m in METHODS),
        "",
        f"found, and only these count: {result['found']['cycle']:.1%} from {OFF:.0%} off, "
        f"{result['found']['neighbour']:.1%} in the neighbouring cell;",
        *(
            f"fsolve and {m}: at most {p['distance']:.0e} away, by {p['step_maps']:.0f} step maps per cycle"
            for m, p in result["practice"].items()
        ),
    ]
    return "\n".join(lines)


def main(arguments: list[str] | None = None) -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.bench", description="Measure the speed.")
    parser.add_argument("--json", action="store_true", help="print one JSON object with every repetition")
    parser.add_argument("--batch", type=int, default=1000, help="guesses in one batch, at least (1000)")
    parser.add_argument("--repeat", type=int, default=9, help="repetitions (9)")
    parser.add_argument("--practice", type=int, default=3, help="repetitions of the paper's practice (3)")
    options = parser.parse_args(arguments)
    if min(options.batch, options.repeat, options.practice) < 1:
        parser.error("--batch, --repeat and --practice are at least 1")
    result = measure(options.batch, options.repeat, min(options.practice, options.repeat))
    print(json.dumps(result, indent=1) if options.json else table(result))
    return 0


if __name__ == "__main__":
    sys.exit(main())
