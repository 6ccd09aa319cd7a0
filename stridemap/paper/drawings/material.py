"""What the figures are drawn from: cycles of the paper's sweeps, and their motions."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import pandas as pd

from stridemap.errors import InputError
from stridemap.paper.branch_tables import branch_tables
from stridemap.paper.map_boundaries import map_boundaries
from stridemap.paper.points import PLANE, TYPICAL
from stridemap.paper.select import at
from stridemap.paper.sweeps import PaperSweeps
from stridemap.services import shown
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model
from stridemap.solver.observables.motion import Motion, motions

SOLUTIONS = dict(zip("abc", TYPICAL.items(), strict=True))
"""The typical solutions as the paper letters them, each with its group and spring stiffness."""


@dataclass(frozen=True)
class Cycle:
    """A limit cycle of a sweep.

    Parameters
    ----------
    model : Model
    row : pandas.Series
        Its row of ``orbits.parquet``.
    """

    model: Model
    row: pd.Series

    @property
    def period(self) -> float:
        """Time from one touchdown to the next."""
        return float(self.row["period"])

    def motion(self, samples: int) -> Motion:
        """The cycle as a motion of one step, sampled evenly."""
        cycle = self.row[[*self.model.section, "period"]].to_numpy(dtype=float)
        params = self.row[list(self.model.preset)].to_numpy(dtype=float)
        return motions(self.model, cycle[None, :], params[None, :], samples, squeeze=True)


@dataclass
class Material:
    """Cycles of the paper's sweeps as the figures need them; a sweep is run when one first asks for it.

    Parameters
    ----------
    sweeps : PaperSweeps
    say : callable, optional
        Takes a line that says what is being done when boundaries are computed.
    """

    sweeps: PaperSweeps
    say: Callable[[str], None] | None = None

    @cached_property
    def map(self) -> pd.DataFrame:
        """The gaits in the plane of spring stiffness and mass ratio, at the typical solutions' frequency."""
        return at(self.sweeps.gaits("map"), omega=PLANE["omega"])

    @cached_property
    def boundaries(self) -> pd.DataFrame:
        """The boundaries of gaits in that plane, as lines."""
        return map_boundaries(self.sweeps, self.say)

    @cached_property
    def branch_sets(self) -> dict[tuple[float, float], list[pd.DataFrame]]:
        """The branches over the spring stiffness, by mass ratio and frequency."""
        config = self.sweeps.configs["lines"]
        model, springs = load(config.model), np.array(config.grid["k"])
        solver = Solver.for_model(model)
        # Every cycle that was found is followed, those that are no physical gaits among them.
        planes = self.sweeps.orbits("lines").groupby(["alpha", "omega"])
        found: dict[tuple[float, float], list[pd.DataFrame]] = {}
        with shown("following the branches over k", "lines") as update:
            for (alpha, omega), rows in planes:
                update(len(found), len(planes), f"alpha = {alpha:g}, omega = {omega:g}")
                found[alpha, omega] = branch_tables(solver, Orbits.from_columns(model, rows), springs)
        return found

    @cached_property
    def typical(self) -> dict[str, Cycle]:
        """The stable cycles at the typical solutions, by their letters."""
        return {
            letter: self._most_stable("typical", group=group, k=k) for letter, (group, k) in SOLUTIONS.items()
        }

    def compass(self, omega: float) -> Cycle:
        """The cycle of the walker without a wobbling mass."""
        return self._most_stable("compass", omega=omega)

    def _most_stable(self, name: str, **where: Any) -> Cycle:
        rows = at(self.sweeps.gaits(name), stable=True, **where)
        if rows.empty:
            place = ", ".join(f"{key} = {value}" for key, value in where.items())
            raise InputError(
                f"the sweep {name} holds no stable limit cycle at {place}, so that it cannot be drawn; "
                "choose other parameters, or other figures with --only"
            )
        best = rows.iloc[rows["spectral_radius"].to_numpy().argmin()]
        return Cycle(load(self.sweeps.configs[name].model), best)
