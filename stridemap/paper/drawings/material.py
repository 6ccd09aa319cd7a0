"""What the figures are drawn from: two sweeps of their own, and the typical solutions."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from importlib.resources import as_file, files
from pathlib import Path
from typing import Any

import pandas as pd

from stridemap.errors import InputError
from stridemap.paper.select import TYPICAL as SPRINGS
from stridemap.solver.api import find_orbits
from stridemap.solver.branches.joining import branches
from stridemap.solver.branches.main_branch import walks
from stridemap.solver.cycles.orbit import Orbit
from stridemap.solver.model.loading import load
from stridemap.sweeps.config import SweepConfig, load_config
from stridemap.sweeps.run import sweep
from stridemap.sweeps.store import read_orbits

PLANE = {"alpha": 0.25, "omega": 3.0}
"""Where the paper's typical solutions are."""

TYPICAL = dict(zip("abc", SPRINGS.items(), strict=True))
"""Its typical solutions: their letter, group and spring stiffness."""


def config_of(name: str) -> SweepConfig:
    """The configuration of one of the figures' sweeps, ``map`` or ``branches``."""
    with as_file(files("stridemap.paper.figures") / f"{name}.toml") as path:
        return load_config(path)


@dataclass(frozen=True)
class Table:
    """A finished sweep: its configuration and its limit cycles."""

    config: SweepConfig
    orbits: pd.DataFrame


@dataclass
class Data:
    """Data of the figures, each computed when it is first asked for.

    Parameters
    ----------
    folder : pathlib.Path
        The sweeps' folders are made in there; what is there already is used.
    workers : int, optional
        Processes of a sweep.
    progress : callable, optional
        As of `stridemap.sweep`.
    configs : dict of str to SweepConfig
        Other configurations than those of the paper's figures, by the name of the sweep.
    """

    folder: Path
    workers: int | None = None
    progress: Callable[[Any], None] | None = None
    configs: dict[str, SweepConfig] = field(default_factory=dict)

    @cached_property
    def map(self) -> Table:
        """The plane of spring stiffness and mass ratio."""
        return self._table("map")

    @cached_property
    def branches(self) -> Table:
        """Spring stiffness, finely, at two mass ratios and two frequencies; all cycles, to be followed."""
        return self._table("branches", everything=True)

    @cached_property
    def branch_sets(self) -> dict[tuple[float, float], list[pd.DataFrame]]:
        """The branches over the spring stiffness, by mass ratio and frequency."""
        table = self.branches
        model, values = load(table.config.model), table.config.grid["k"]
        planes = table.orbits.groupby(["alpha", "omega"])
        return {(alpha, omega): branches(model, rows, "k", values) for (alpha, omega), rows in planes}

    @cached_property
    def typical(self) -> dict[str, Orbit]:
        """The stable limit cycles at the paper's three points, by their letter."""
        return {letter: _stable("wobbling", group, k=k, **PLANE) for letter, (group, k) in TYPICAL.items()}

    def compass(self, omega: float) -> Orbit:
        """The limit cycle of the walker without a wobbling mass."""
        return _stable("compass", None, omega=omega)

    def _table(self, name: str, everything: bool = False) -> Table:
        config = self.configs.get(name) or config_of(name)
        folder = self.folder / name
        sweep(config, folder, workers=self.workers, resume=True, progress=self.progress)
        orbits = read_orbits(folder)
        return Table(config, orbits if everything else orbits[walks(orbits)])


def _stable(model: str, group: str | None, **params: Any) -> Orbit:
    """The most stable cycle of a group (of a model without groups: of all) at a point."""
    found = [orbit for orbit in find_orbits(model, **params) if orbit.stable and orbit.group == group]
    if not found:
        where = ", ".join(f"{name} = {value:g}" for name, value in params.items())
        raise InputError(f"{model} has no stable limit cycle of group {group} at {where}")
    return min(found, key=lambda orbit: orbit.spectral_radius)
