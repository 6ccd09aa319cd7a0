"""Rows that the statements speak of: a pair of alpha and omega, a group, a typical solution."""

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pandas as pd

from stridemap.paper.cycle_tables import CycleTables
from stridemap.paper.points import ALPHAS, OMEGAS, TYPICAL


def slices(data: CycleTables) -> Iterator[tuple[str, float, float, pd.DataFrame]]:
    """Name, alpha, omega and cycles of each pair of alpha and omega."""
    for omega in OMEGAS:
        for alpha in ALPHAS:
            yield (
                f"alpha {alpha:g}, omega {omega:g}",
                alpha,
                omega,
                at(data.lines, alpha=alpha, omega=omega),
            )


def with_minima(data: CycleTables) -> CycleTables:
    """The tables with the cycles between the springs that were searched among the lines.

    They are for smallest values and where these are, not for what is counted, averaged, or compared from one
    spring to the next.
    """
    lines = pd.concat([data.lines.assign(on_grid=True), data.minima.assign(on_grid=False)], ignore_index=True)
    return replace(data, lines=lines)


def at(table: pd.DataFrame, **values: Any) -> pd.DataFrame:
    """Rows in which columns have given values; numbers may differ by rounding."""
    keep = np.ones(len(table), dtype=bool)
    for name, value in values.items():
        column = table[name]
        keep &= (column == value) if isinstance(value, str | bool) else np.isclose(column, value, rtol=1e-9)
    return table[keep]


def stable(orbits: pd.DataFrame, group: str | None = None) -> pd.DataFrame:
    """Stable cycles, of one group if it is given, by `k`."""
    keep = orbits["stable"].fillna(False).astype(bool)  # where it is not known, it is not counted
    if group is not None:
        keep &= orbits["group"] == group
    return orbits[keep].sort_values(["k", "period"])


def main_branch(orbits: pd.DataFrame, group: str) -> pd.DataFrame:
    """Cycles of a group on the main branch, stable or not, by `k`."""
    return orbits[orbits["main"].astype(bool) & (orbits["group"] == group)].sort_values(["k", "period"])


def typical(data: CycleTables, group: str) -> pd.Series | None:
    """The stable cycle of a group at its typical spring; the most stable one if there are several."""
    rows = at(stable(data.typical, group), k=TYPICAL[group])
    return None if rows.empty else rows.iloc[rows["spectral_radius"].to_numpy().argmin()]


def compass(data: CycleTables, omega: float, column: str) -> float:
    """A number of the compass's most stable cycle at a frequency; NaN if there is none."""
    rows = at(data.compass, omega=omega)
    return math.nan if rows.empty else float(rows.iloc[rows["spectral_radius"].to_numpy().argmin()][column])


def span(orbits: pd.DataFrame) -> list[float]:
    """Least and greatest `k`; empty where there are no cycles."""
    return [float(orbits["k"].min()), float(orbits["k"].max())] if len(orbits) else []


def extremes(orbits: pd.DataFrame, column: str) -> dict[str, Any]:
    """Least and greatest value of a column, and at which `k`; empty where there are no cycles.

    The number of cycles counts those at the springs that were searched.
    """
    values = orbits[column]
    if not values.notna().any():
        return {}
    low, high = values.idxmin(), values.idxmax()
    return {
        "cycles": int(orbits["on_grid"].sum()) if "on_grid" in orbits else len(orbits),
        "least": values[low],
        "least_at_k": orbits["k"][low],
        "greatest": values[high],
        "greatest_at_k": orbits["k"][high],
    }
