"""All boundaries in the plane of two parameters as a value: tables, JSON, a picture."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.columns import described
from stridemap.services import service
from stridemap.solver.boundaries.survey import Boundary
from stridemap.solver.branches.arclength import ends_in_words
from stridemap.solver.branches.tables import cycle_columns, pair, point_row, save_tables
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]


@dataclass(frozen=True)
class DoublePoint:
    """A point of a boundary at which two things happen at once.

    Parameters
    ----------
    boundary : int
        Number of the boundary.
    type : str
        ``cusp``, ``gpd`` (a doubling turns from supercritical to subcritical), ``fold_flip`` (multipliers 1
        and -1), ``r1`` to ``r4`` (resonances 1:1 to 1:4), ``fold_ns`` and ``pd_ns`` (a multiplier 1 or -1
        beside a pair on the unit circle); or ``corner``, where the boundary begins or ceases to be one of
        gaits.
    meets : str or None
        Of a corner: how gaits end on the other boundary.
    params : dict of str to float
    state : dict of str to float
        Section point at the start of the first step.
    period : float
        Of the whole cycle.
    period_n : int
        Number of walking steps after which it closes.
    arclength : float
        Where it lies along its boundary.
    multipliers : tuple of complex
    residual : float
        Largest entry of the equations that define it.
    gait : bool
        Whether it lies on a gait, or at the end of gaits.
    """

    boundary: int
    type: str
    meets: str | None
    params: dict[str, float]
    state: dict[str, float]
    period: float
    period_n: int
    arclength: float
    multipliers: tuple[complex, ...]
    residual: float
    gait: bool

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON; complex numbers are pairs."""
        return {**vars(self), "multipliers": [pair(one) for one in self.multipliers]}


@dataclass(frozen=True)
class Boundaries(Sequence[Boundary]):
    """All boundaries of gaits and bifurcations in the plane of two parameters.

    Parameters
    ----------
    model : Model
    vary : (str, str)
        The two parameters.
    ranges : ((float, float), (float, float))
    params : dict of str to float
        The other parameters.
    found : list of Boundary
    """

    model: Model
    vary: tuple[str, str]
    ranges: tuple[tuple[float, float], tuple[float, float]]
    params: dict[str, float]
    found: list[Boundary]

    def __len__(self) -> int:
        return len(self.found)

    def __getitem__(self, index: Any) -> Any:
        return self.found[index]

    def __repr__(self) -> str:
        return self.summary()

    def summary(self, factors: tuple[float, float] = (1.0, 1.0), units: tuple[str, str] = ("", "")) -> str:
        """What was found, in lines.

        Parameters
        ----------
        factors : (float, float)
            What 1 of each parameter is in the unit in which its values are shown.
        units : (str, str)
            What these units are called.
        """
        first, second = self.vary
        count = f"{len(self)} boundar{'y' if len(self) == 1 else 'ies'}"
        area = " and ".join(
            f"{name} from {factor * low:g} to {factor * high:g}{unit and f' {unit}'}"
            for name, (low, high), factor, unit in zip(self.vary, self.ranges, factors, units, strict=True)
        )
        lines = []
        for number, one in enumerate(self.found):
            plane = one.cycles[:, -2:] * factors
            low, high = plane.min(axis=0), plane.max(axis=0)
            lines.append(
                f"  {number}: {one.type}, {low[0]:.6g} <= {first} <= {high[0]:.6g}, "
                f"{low[1]:.6g} <= {second} <= {high[1]:.6g}{ends_in_words(one.reasons)}"
            )
        head = f"<{count} of {self.model.name} over {area}"
        return "\n".join([head, *lines, ">"]) if lines else f"{head}>"

    @cached_property
    def points(self) -> tuple[DoublePoint, ...]:
        """All points at which two things happen at once, in order along each boundary."""
        return tuple(point for number, one in enumerate(self.found) for point in self._points_of(number, one))

    def _points_of(self, number: int, one: Boundary) -> Iterator[DoublePoint]:
        lengths = one.arclength
        gait = one.is_gait
        placed: list[tuple[float, str, str | None, Array, Any, float, bool]] = []
        for before, point in one.codim2:
            along = float(lengths[before]) + one.distance(before, point.cycle)
            on_gait = bool(gait[before : before + 2].all())
            placed.append(
                (along, str(point.type), None, point.cycle, point.multipliers, point.residual, on_gait)
            )
        for before, end in one.corners:
            cycle = one.curve.cycle(end.point.x)
            along = float(lengths[before]) + one.distance(before, cycle)
            placed.append((along, "corner", str(end.type), cycle, end.point.multipliers, end.residual, True))
        names = self.model.section
        for along, kind, meets, cycle, multipliers, residual, on_gait in sorted(
            placed, key=lambda item: item[0]
        ):
            equations = one.curve.equations
            steps, params = equations.steps(cycle), equations.point(cycle[-2:])
            yield DoublePoint(
                number,
                kind,
                meets,
                dict(zip(self.model.spec.names, params.tolist(), strict=True)),
                dict(zip(names, steps[0, :-1].tolist(), strict=True)),
                float(steps[:, -1].sum()),
                one.period_n,
                along,
                tuple(multipliers.tolist()),
                residual,
                on_gait,
            )

    # -- tables ------------------------------------------------------------------------------------------

    def to_frame(self) -> Any:
        """All points of all boundaries as a `pandas.DataFrame`, one row each.

        Columns: ``boundary, type, period_n, gait`` (whether cycles there are gaits, or their ends),
        ``borders_stable`` (whether all other multipliers lie inside the unit circle), ``arclength``, the
        parameters, the section point at the start of the first step, ``period``, and the multipliers, each
        followed by continuity along the boundary.
        """
        import pandas as pd

        frames = [pd.DataFrame(self._columns(number, one)) for number, one in enumerate(self.found)]
        frame = pd.concat(frames, ignore_index=True) if frames else pd.DataFrame()
        return described(frame, self.model.spec, "points of boundaries")

    def points_frame(self) -> Any:
        """All points at which two things happen at once as a `pandas.DataFrame`, one row each."""
        import pandas as pd

        frame = pd.DataFrame([point_row(one) for one in self.points])
        return described(frame, self.model.spec, "double points")

    def _columns(self, number: int, one: Boundary) -> dict[str, Any]:
        m = len(one.points)
        multipliers = np.array([point.multipliers for point in one.points])
        return {
            "boundary": np.full(m, number),
            "type": np.full(m, one.type),
            "period_n": np.full(m, one.period_n),
            "gait": one.is_gait,
            "borders_stable": one.borders_stable,
            "arclength": one.arclength,
            **cycle_columns(one.curve.equations, one.cycles, multipliers),
        }

    def save(self, path: str | Path) -> list[Path]:
        """Write the table of points, and beside it that of the double points, as Parquet or CSV.

        Parameters
        ----------
        path : str or path
            Ends in ``.parquet`` or ``.csv``; the double points go to ``<name>_points`` beside it.

        Returns
        -------
        list of pathlib.Path

        Raises
        ------
        InputError
            For another ending.
        StorageError
            When a file cannot be written.
        """
        return save_tables(path, {"": self.to_frame, "_points": self.points_frame})

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON: boundaries with their curves in the plane and their double points."""
        points = [one.to_dict() for one in self.points]
        return {
            "model": self.model.name,
            "vary": list(self.vary),
            "ranges": [list(one) for one in self.ranges],
            "params": self.params,
            "boundaries": [
                {
                    "boundary": number,
                    "type": one.type,
                    "period_n": one.period_n,
                    "curve": one.cycles[:, -2:].tolist(),
                    "gait": one.is_gait.tolist(),
                    "borders_stable": one.borders_stable.tolist(),
                    "ends": [str(reason) for reason in one.reasons],
                    "points": [point for point in points if point["boundary"] == number],
                }
                for number, one in enumerate(self.found)
            ],
        }

    def plot(self, **options: Any) -> Any:
        """Draw the boundaries with matplotlib: see `stridemap.views.boundary_map`."""
        return service("boundary_map")(self, **options)
