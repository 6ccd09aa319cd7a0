"""Tables in which every statement of the paper holds, and changes that undo one statement each."""

from dataclasses import replace

import numpy as np
import pandas as pd

from stridemap.paper.cycle_tables import CycleTables

STARTS = {"A": 0.5, "B": 10.0, "C": 22.0, "D": 34.0, "E": 46.0}
STABLE, MAIN = {2.0: 4.0, 3.0: 6.0}, 8.0
"""Made-up groups: where each begins in k, over what length it is stable, and how long it is."""

LINE_K = np.arange(0.5, 60.1, 0.5)
MAP_ALPHA = np.array([0.1, 0.3, 0.45, 0.6, 0.9])
WALKS = {"status": "converged", "step_length": 0.2, "min_vertical_force": 1.0}


def made_up():
    """Tables of the same form as those of the sweeps, with round numbers; all statements hold."""
    compass = pd.DataFrame(
        [
            {
                **WALKS, **_measure(0.13, w), "omega": w, "period": 1.0, "spectral_radius": 0.7,
                "stable": True, "peaks": 1,
            }
            for w in (2.0, 3.0)
        ]
    )  # fmt: skip
    turn = np.linspace(0, 2 * np.pi, 401)
    lines = pd.DataFrame([row for a in (0.25, 0.5) for w in (2.0, 3.0) for row in _line(a, w)])
    return CycleTables(
        typical=pd.DataFrame([_typical(g, k) for g, k in (("A", 0.5), ("B", 6.0), ("C", 22.5))]),
        compass=compass,
        lines=lines,
        minima=lines.iloc[:0],
        edges=pd.DataFrame({n: [] for n in ("alpha", "omega", "group", "k_grid", "side", "k")}),
        map=pd.DataFrame([row for w in (2.0, 3.0) for a in MAP_ALPHA for row in _map_row(a, w)]),
        line_k=LINE_K,
        map_k=LINE_K,
        map_alpha=MAP_ALPHA,
        profiles={
            name: {"x": 0.05 * np.sin(turn), "d": 0.2 * np.sin(turn), "dtheta1": -np.cos(n * turn)}
            for name, n in (("A", 1), ("B", 2), ("C", 3), ("compass", 1))
        },
    )


def _measure(value, omega):
    value = value + 0.1 * (omega - 2)
    return {"d_max": value, "cot": value, "cot_per_speed": value}


def _line(alpha, omega):
    for index, (group, start) in enumerate(STARTS.items()):
        for k in LINE_K[(start <= LINE_K) & (start + MAIN >= LINE_K)]:
            stable = k <= start + STABLE[omega]
            level = 0.15 if group == "A" else 0.1
            yield {
                **WALKS, **profile(group), **_measure(level + 0.02 * alpha + 0.001 * (k - start), omega),
                "alpha": alpha, "omega": omega, "k": k, "group": group, "period": 1.0, "main": True,
                "spectral_radius": 0.9 + 0.01 * (k - start) + 0.1 * (not stable), "stable": stable,
                "peaks": index + 1, "x_zero_crossings": 2 * max(index, 1),
            }  # fmt: skip


def profile(group):
    """Time profiles of A, or else of B."""
    sign = 1 if group == "A" else -1
    return {
        "x_first": -0.01 * sign, "x_second": 0.01 * sign, "x_first_behind": 0.5 + 0.5 * sign,
        "x_second_ahead": 0.5 + 0.5 * sign, "wobble_amplitude": 0.05, "x_travel": 0.1, "x_maxima": 1,
        "d_first": 0.1, "d_second": -0.1, "d_first_positive": 0.9, "d_second_negative": 1.0,
        "d_travel": 0.4 if group == "A" else 0.3, "d_start": 0.1, "d_sign_changes": 1, "d_crossing": 0.45,
    }  # fmt: skip


def _typical(group, k):
    likeness = {"A": 0.99, "B": 0.1, "C": 0.2}[group]
    return {
        **WALKS, **profile(group), **_measure(0.1, 3.0), "alpha": 0.25, "omega": 3.0, "k": k, "group": group,
        "period": 1.0, "spectral_radius": 0.9, "stable": True, "peaks": "ABC".index(group) + 1,
        "x_zero_crossings": 2,
        "likeness": likeness, "angle_difference": 1 - likeness, "rate_difference": 1 - likeness,
    }  # fmt: skip


def _map_row(alpha, omega):
    """Cycles for every k at every alpha, most of them stable at alpha = 0.45 and none at 0.9."""
    stable_k = {0.1: 5.0, 0.3: 20.0, 0.45: 50.0, 0.6: 20.0, 0.9: 0.0}[alpha]
    for k in LINE_K:
        group = "ABCDE"[min(int(k // 10), 4)]
        yield {
            **WALKS, **_measure(0.1, omega), "alpha": alpha, "omega": omega, "k": k, "group": group,
            "period": 1.0, "spectral_radius": 0.9, "stable": k <= stable_k, "peaks": 1, "x_zero_crossings": 2,
        }  # fmt: skip


def changed(data, table, where=None, **columns):
    """The data with columns of one table changed, where `where` says so, to a value or function of rows."""
    rows = getattr(data, table).copy()
    at = np.ones(len(rows), dtype=bool) if where is None else np.asarray(where(rows), dtype=bool)
    for name, new in columns.items():
        values = new(rows) if callable(new) else new
        kind = bool if rows[name].dtype == bool else object if rows[name].dtype.kind not in "fiub" else float
        old = rows[name].to_numpy(dtype=kind)
        rows[name] = np.where(at, np.asarray(values), old)
    return replace(data, **{table: rows})


def swapped(data, one, other, column="group", tables=("typical", "lines", "minima", "edges", "map")):
    """The data with two values of a column swapped in all tables."""
    for table in tables:
        rows = getattr(data, table)
        data = replace(
            data, **{table: rows.assign(**{column: rows[column].replace({one: other, other: one})})}
        )
    return data


def slow(rows):
    """Rows at omega = 2."""
    return rows["omega"] == 2.0
