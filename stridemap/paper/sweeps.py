"""The sweeps of the paper: one set, from which its statements, its figures and its report are made.

The configurations are the TOML files next to this module. A sweep is run when its cycles are first asked
for, and read again from its folder afterwards.
"""

import math
import tomllib
from collections.abc import Callable, Mapping
from concurrent.futures import Executor
from dataclasses import dataclass, field
from importlib.resources import files
from pathlib import Path
from typing import Any

import pandas as pd

from stridemap.errors import InputError
from stridemap.solver.cycles.gait import is_physical_gait
from stridemap.sweeps.config import SweepConfig, parse_config
from stridemap.sweeps.run import Progress, sweep
from stridemap.sweeps.store import read_cells, read_orbits

SWEEPS = ("typical", "compass", "lines", "map")
"""Names of the sweeps: the three typical solutions, the compass, `k` at four points, and `k` with `alpha`."""

FREE = ("beta", "Kp", "Kd", "S", "gamma")
"""Parameters whose values the paper does not print."""


@dataclass
class PaperSweeps:
    """The sweeps of the paper in a folder, each run when it is first needed. Made by `paper_sweeps`.

    Parameters
    ----------
    folder : pathlib.Path
        Each sweep has a folder of its name in it.
    configs : mapping of str to SweepConfig
        The configurations, by the names of the sweeps.
    workers, executor
        As for `stridemap.sweep`.
    progress : callable, optional
        Called with the name of the sweep and a `Progress`.
    """

    folder: Path
    configs: Mapping[str, SweepConfig]
    workers: int | None = None
    executor: Executor | None = None
    progress: Callable[[str, Progress], None] | None = None
    _orbits: dict[str, pd.DataFrame] = field(default_factory=dict, init=False, repr=False)
    _finished: set[str] = field(default_factory=set, init=False, repr=False)

    def run(self, name: str) -> Path:
        """Run a sweep, or continue it, unless it is finished, and return its folder.

        Raises
        ------
        InputError
            When the folder cannot be used, for instance because it holds the output of another configuration.
        """
        where = self.folder / name
        if name in self._finished:
            return where

        def report(seen: Progress) -> None:
            if self.progress:
                self.progress(name, seen)

        config = self.configs[name]
        sweep(config, where, workers=self.workers, executor=self.executor, resume=True, progress=report)
        self._finished.add(name)
        return where

    def orbits(self, name: str) -> pd.DataFrame:
        """All limit cycles of a sweep, as rows of its ``orbits.parquet``."""
        if name not in self._orbits:
            self._orbits[name] = read_orbits(self.run(name))
        return self._orbits[name]

    def gaits(self, name: str) -> pd.DataFrame:
        """The limit cycles of a sweep that count as gaits.

        Raises
        ------
        InputError
            When there are none, save at the typical solutions.
        """
        orbits = self.orbits(name)
        gaits = orbits[is_physical_gait(orbits)].reset_index(drop=True)
        require_gaits(gaits, name)
        return gaits

    def cells(self, name: str) -> pd.DataFrame:
        """The grid cells of a sweep, as rows of its ``cells.parquet``."""
        return read_cells(self.run(name))


def paper_sweeps(
    folder: str | Path | None = None,
    params: Mapping[str, Any] | None = None,
    thin: int = 1,
    *,
    workers: int | None = None,
    executor: Executor | None = None,
    progress: Callable[[str, Progress], None] | None = None,
) -> PaperSweeps:
    """The sweeps of the paper; none of them is run yet.

    Parameters
    ----------
    folder : path, optional
        By default `default_folder`.
    params, thin
        As for `configurations`.
    workers, executor, progress
        As for `PaperSweeps`.

    Raises
    ------
    InputError
        As for `configurations`.
    """
    where = default_folder(params, thin) if folder is None else Path(folder)
    return PaperSweeps(where, configurations(params, thin), workers, executor, progress)


def default_folder(params: Mapping[str, Any] | None = None, thin: int = 1) -> Path:
    """The folder of the sweeps below the current one; each choice of parameters has its own."""
    words = ["paper-sweeps", *(f"{name}={value}" for name, value in sorted((params or {}).items()))]
    return Path("results") / "-".join([*words, f"thin={thin}"] if thin != 1 else words)


def configurations(params: Mapping[str, Any] | None = None, thin: int = 1) -> dict[str, SweepConfig]:
    """The configurations of the sweeps, by name.

    Parameters
    ----------
    params : mapping, optional
        Values of parameters in `FREE` that replace the preset's.
    thin : int
        Only every `thin`-th value of the ranges is searched, which is faster and decides less.

    Raises
    ------
    InputError
        For a parameter that the paper fixes or the model does not have, or a value out of range.
    """
    if thin < 1:
        raise InputError(f"thin = {thin} is not allowed: at least 1 is needed")
    for name in params or {}:
        if name not in FREE:
            raise InputError(
                f"{name} cannot be set here: the paper's statements and figures are about given k, alpha and "
                f"omega; what can be set is {', '.join(FREE)}"
            )
    out = {}
    for name in SWEEPS:
        data = tomllib.loads(files("stridemap.paper").joinpath(f"{name}.toml").read_text("utf-8"))
        for axis in data["grid"].values():
            if isinstance(axis, dict):
                axis["num"] = math.ceil((axis["num"] - 1) / thin) + 1
        data["params"] = data.get("params", {}) | dict(params or {})
        out[name] = parse_config(data, f"the sweep {name}")
    return out


def require_gaits(table: pd.DataFrame, name: str) -> None:
    """Refuse a table without a gait; only at the typical solutions there may be none.

    Raises
    ------
    InputError
        Naming the sweep.
    """
    if table.empty and name != "typical":
        raise InputError(
            f"the sweep {name} holds no limit cycle that is a physical gait, so that nothing can be decided "
            "or drawn; choose other parameters, or sweep into another folder"
        )
