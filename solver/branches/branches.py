"""All branches over one parameter as a value: tables of points and of special points, JSON, a picture."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.columns import described
from stridemap.services import service
from stridemap.solver.branches.arclength import ends_in_words
from stridemap.solver.branches.bifurcation import Special, SpecialType
from stridemap.solver.branches.ends import End
from stridemap.solver.branches.survey import Branch
from stridemap.solver.branches.tables import cycle_columns, pair, point_row, save_tables
from stridemap.solver.cycles.chain_measures import chain_measures
from stridemap.solver.cycles.orbits import column
from stridemap.solver.model.model import Model
from stridemap.words import multiplier_columns

Array = NDArray[np.float64]


@dataclass(frozen=True)
class SpecialPoint:
    """A special point of a branch.

    Parameters
    ----------
    branch : int
        Number of the branch.
    type : str
        ``fold``, ``pd`` (period doubling), ``ns`` (torus) or ``bp`` (branch point); or how a gait ends there:
        ``grazing, early_touchdown, backward, fall, contact, friction``.
    value : float
        Of the parameter that varies.
    params : dict of str to float
    state : dict of str to float
        Section point at the start of the first step.
    period : float
        Of the whole cycle.
    period_n : int
        Number of walking steps after which it closes.
    steps : tuple of tuple of float, shape (period_n, nz + 1)
        Section point and period of each step.
    arclength : float
        Where it lies along its branch, as in the column of that name.
    multipliers : tuple of complex
    residual : float
        Largest entry of the equations that define it.
    gait : bool
        Whether it lies on a gait, or at its end.
    criticality : {"supercritical", "subcritical"} or None
        Of a doubling: whether the doubled cycles exist where the single one is unstable.
    multiplier : complex or None
        Of a bifurcation: the one that crosses the unit circle.
    crossing_slope : float or None
        Of a bifurcation: by how much, per unit of arclength, what passes through a value there changes.
    null : dict of str to complex, or None
        Of a bifurcation: the direction that neither grows nor shrinks, at the section of the first step.
    """

    branch: int
    type: str
    value: float
    params: dict[str, float]
    state: dict[str, float]
    period: float
    period_n: int
    steps: tuple[tuple[float, ...], ...]
    arclength: float
    multipliers: tuple[complex, ...]
    residual: float
    gait: bool
    criticality: str | None = None
    multiplier: complex | None = None
    crossing_slope: float | None = None
    null: dict[str, complex] | None = None

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON; complex numbers are pairs."""
        plain = {**vars(self), "multipliers": [pair(value) for value in self.multipliers]}
        plain["steps"] = [list(step) for step in self.steps]
        plain["multiplier"] = None if self.multiplier is None else pair(self.multiplier)
        plain["null"] = self.null and {name: pair(value) for name, value in self.null.items()}
        return plain


@dataclass(frozen=True)
class Branches(Sequence[Branch]):
    """All branches of cycles over one parameter.

    Parameters
    ----------
    model : Model
    vary : str
        Name of the parameter that varies.
    range : (float, float)
    params : dict of str to float
        The other parameters.
    found : list of Branch
    """

    model: Model
    vary: str
    range: tuple[float, float]
    params: dict[str, float]
    found: list[Branch]

    def __len__(self) -> int:
        return len(self.found)

    def __getitem__(self, index: Any) -> Any:
        return self.found[index]

    def __repr__(self) -> str:
        return self.summary()

    def summary(self, factor: float = 1.0, unit: str = "") -> str:
        """What was found, in lines.

        Parameters
        ----------
        factor : float
            What 1 of the parameter is in the unit in which its values are shown.
        unit : str
            What that unit is called.
        """
        low, high = (end * factor for end in self.range)
        lines = [
            f"  {number}: {branch.period_n}-step cycles, {len(branch.points)} points, "
            f"{factor * branch.x[:, -1].min():.6g} <= {self.vary} <= {factor * branch.x[:, -1].max():.6g}"
            f"{ends_in_words(branch.reasons)}"
            for number, branch in enumerate(self.found)
        ]
        count = f"{len(self)} branch{'' if len(self) == 1 else 'es'}"
        head = f"<{count} of {self.model.name} over {self.vary} from {low:g} to {high:g}{unit and f' {unit}'}"
        return "\n".join([head, *lines, ">"]) if lines else f"{head}>"

    # -- special points ----------------------------------------------------------------------------------

    @cached_property
    def special(self) -> tuple[SpecialPoint, ...]:
        """All special points, in order along each branch."""
        return tuple(
            point for number, branch in enumerate(self.found) for point in self._special_of(number, branch)
        )

    def _special_of(self, number: int, branch: Branch) -> Iterator[SpecialPoint]:
        gait = branch.is_gait
        lengths = branch.arclength
        placed: list[tuple[float, int, Special | End, int]] = []
        for place, (before, special) in enumerate(branch.specials):
            placed.append((lengths[before] + branch.distance(before, special.x), before, special, place))
        for before, end in branch.ends:
            placed.append((lengths[before] + branch.distance(before, end.point.x), before, end, -1))
        for arclength, before, one, place in sorted(placed, key=lambda item: item[0]):
            if isinstance(one, End):
                multipliers = one.point.multipliers
                yield self._special_point(
                    number, branch, one.type, one.point.x, arclength, multipliers, one.residual, True
                )
                continue
            on_gait = bool(gait[before] and gait[min(before + 1, len(gait) - 1)])
            point = self._special_point(
                number, branch, one.type, one.x, arclength, one.multipliers, one.residual, on_gait
            )
            first = np.asarray(one.null, dtype=np.complex128)[: len(self.model.section)]
            largest = first[np.abs(first).argmax()] if len(first) else 1.0
            null = dict(zip(self.model.section, (first / (largest or 1.0)).tolist(), strict=True))
            critical = branch.criticality.get(place)
            words = {True: "supercritical", False: "subcritical", None: None}
            criticality = words[critical] if one.type == SpecialType.PD else None
            yield SpecialPoint(
                **{
                    **vars(point),
                    "criticality": criticality,
                    "multiplier": one.multiplier,
                    "crossing_slope": one.slope,
                    "null": null,
                }
            )

    def _special_point(
        self,
        number: int,
        branch: Branch,
        kind: str,
        x: Array,
        arclength: float,
        multipliers: Any,
        residual: float,
        gait: bool,
    ) -> SpecialPoint:
        steps = x[:-1].reshape(branch.period_n, -1)
        params = dict(zip(self.model.spec.names, branch.curve.equations.point(x[-1]).tolist(), strict=True))
        return SpecialPoint(
            number,
            str(kind),
            float(x[-1]),
            params,
            dict(zip(self.model.section, steps[0, :-1].tolist(), strict=True)),
            float(steps[:, -1].sum()),
            branch.period_n,
            tuple(map(tuple, steps.tolist())),
            float(arclength),
            tuple(multipliers.tolist()),
            residual,
            gait,
        )

    # -- tables ------------------------------------------------------------------------------------------

    def to_frame(self) -> Any:
        """All points of all branches as a `pandas.DataFrame`, one row each.

        Columns: ``branch, period_n, gait, arclength``, the parameters, the section point at the start
        of the first step, ``period``, the multipliers (each followed by continuity along the branch), every
        measured quantity over the whole cycle, and the unit tangent as ``tangent_<name>``.
        """
        import pandas as pd

        frames = [pd.DataFrame(self._columns(number, branch)) for number, branch in enumerate(self.found)]
        frame = pd.concat(frames, ignore_index=True) if frames else pd.DataFrame()
        return described(frame, self.model.spec, "points of branches")

    def special_frame(self) -> Any:
        """All special points as a `pandas.DataFrame`, one row each.

        Columns: ``branch, type, value, period, period_n, arclength, residual`` of the equations that define
        it, ``gait, criticality, multiplier, crossing_slope``, the parameters, the section point at the start
        of the first step, the multipliers, and every measured quantity over the whole cycle.
        """
        import pandas as pd

        rows = [
            {**point_row(one), "multiplier": None if one.multiplier is None else str(one.multiplier)}
            for one in self.special
        ]
        frame = pd.DataFrame(rows).drop(columns="null", errors="ignore")
        if not rows:
            frame = pd.DataFrame(columns=self._special_names)
        for name, values in self._measured_specials().items():
            if name not in frame:
                frame[name] = values
        return described(frame, self.model.spec, "special points", {"value": self.vary})

    @property
    def _special_names(self) -> list[str]:
        """Columns of the table of special points."""
        model = self.model
        own = [one.name for one in fields(SpecialPoint)]
        own = [name for name in own if name not in ("params", "state", "steps", "multipliers", "null")]
        multipliers = [name for i in range(len(model.section)) for name in multiplier_columns(i)]
        every = (*own, *model.spec.names, *model.section, *multipliers, *model.measured)
        return list(dict.fromkeys(every))

    def _measured_specials(self) -> dict[str, Any]:
        """Every measured quantity at all special points, by column."""
        parts: dict[str, list[Any]] = {}
        for number, branch in enumerate(self.found):
            points = [one for one in self.special if one.branch == number]
            if not points:
                continue
            u = np.array([np.ravel(one.steps) for one in points])
            params = np.array([list(one.params.values()) for one in points])
            n_rk = [branch.curve.n_rk(np.append(x, one.value)) for x, one in zip(u, points, strict=True)]
            with np.errstate(all="ignore"):  # multipliers are infinite at a grazing touchdown
                measures = chain_measures(
                    branch.curve.chain, n_rk, u, params, np.array([one.multipliers for one in points])
                )
            for name, values in measures.items():
                parts.setdefault(name, []).append(column(self.model.measured[name], values, len(points)))
        return {name: np.concatenate(each) for name, each in parts.items()}

    def _columns(self, number: int, branch: Branch) -> dict[str, Any]:
        x, m = branch.x, len(branch.points)
        equations = branch.curve.equations
        multipliers = np.array([point.multipliers for point in branch.points])
        out: dict[str, Any] = {
            "branch": np.full(m, number),
            "period_n": np.full(m, branch.period_n),
            "gait": branch.is_gait,
            "arclength": branch.arclength,
            **cycle_columns(equations, x, multipliers),
        }
        params = np.array([equations.point(value) for value in x[:, -1]])
        n_rk = [point.n_rk for point in branch.points]
        measures = chain_measures(branch.curve.chain, n_rk, x[:, :-1], params, multipliers)
        out |= {name: column(self.model.measured[name], values, m) for name, values in measures.items()}
        tangents = np.array([point.tangent for point in branch.points])
        names = [*self.model.section, "period"]
        out |= {f"tangent_{name}": tangents[:, i] for i, name in enumerate(names)}
        return out | {f"tangent_{self.vary}": tangents[:, -1]}

    def save(self, path: str | Path) -> list[Path]:
        """Write the table of points, and beside it that of the special points, as Parquet or CSV.

        Parameters
        ----------
        path : str or path
            Ends in ``.parquet`` or ``.csv``; the special points go to ``<name>_special`` beside it.

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
        return save_tables(path, {"": self.to_frame, "_special": self.special_frame})

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON: branches with their special points, without the points between."""
        special = [one.to_dict() for one in self.special]
        return {
            "model": self.model.name,
            "vary": self.vary,
            "range": list(self.range),
            "params": self.params,
            "branches": [
                {
                    "branch": number,
                    "period_n": branch.period_n,
                    "points": len(branch.points),
                    "from": float(branch.x[0, -1]),
                    "to": float(branch.x[-1, -1]),
                    "ends": [str(reason) for reason in branch.reasons],
                    "special": [one for one in special if one["branch"] == number],
                }
                for number, branch in enumerate(self.found)
            ],
        }

    def plot(self, y: str = "period", **options: Any) -> Any:
        """Draw a bifurcation diagram with matplotlib: see `stridemap.views.branch_diagram`."""
        return service("branch_diagram")(self, y, **options)
