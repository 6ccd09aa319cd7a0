"""C7 to C10: largest multipliers, and where cycles are stable."""

from typing import Any

import numpy as np
import pandas as pd

from stridemap.paper.claim import Decided, Listed, Parts, shown, statement
from stridemap.paper.cycle_tables import CycleTables
from stridemap.paper.deciding import rows as in_rows
from stridemap.paper.deciding.over_k import least_of_groups, least_of_part, over_k
from stridemap.paper.points import ALPHAS, DEPENDENCY, GROUPS, OMEGAS, PERFORMANCE
from stridemap.paper.select import (
    at,
    compass,
    extremes,
    main_branch,
    slices,
    stable,
    with_minima,
)
from stridemap.paper.stable_runs import Run, stable_runs


@statement(
    "C7",
    "The largest multiplier of every cycle is larger than the compass's",
    short="largest multipliers are above the compass's",
    where=PERFORMANCE,
    figure=over_k(
        "spectral_radius",
        least_of_part,
        "Largest multiplier over k; marked is the smallest of all cycles.",
        reference=True,
    ),
)
def c7(data: CycleTables) -> Decided:
    """A part for each alpha and omega: true for every physical gait, stable or not."""
    parts, texts = Parts(), {}
    for name, _, omega, orbits in slices(with_minima(data)):
        reference, found = compass(data, omega, "spectral_radius"), extremes(orbits, "spectral_radius")
        least = found.get("least", np.nan)
        below = int((orbits["spectral_radius"] <= reference).sum())
        parts.add(name, least > reference, compass=reference, cycles_not_above=below, **found)
        texts[name] = f"{shown(least, '.3f')} (compass {shown(reference, '.3f')})"
    return parts, Listed("smallest", texts), {}


@statement(
    "C8",
    "Within B, C and D the largest multiplier is smallest towards the group's small-k end",
    short="multipliers of B, C, D are smallest towards small k",
    where=PERFORMANCE,
    figure=over_k(
        "spectral_radius",
        least_of_groups("{group} at {name}"),
        "Largest multiplier over k; marked is the smallest on the main branch, and of stable cycles.",
        groups="BCD",
    ),
)
def c8(data: CycleTables) -> Decided:
    """The fold, where a multiplier is 1, is at the smallest `k` itself; so the minimum lies somewhat inside.

    For each group that has stable cycles at an alpha and omega: the minimum lies in the lower half of the
    group's range of `k`, once among all cycles of the group on the main branch and once among its stable
    cycles.
    """
    parts, locations = Parts(), []
    for name, _, _, orbits in slices(with_minima(data)):
        for group in "BCD":
            if stable(orbits, group).empty:
                continue
            for what, rows in (("", main_branch(orbits, group)), (" among stable", stable(orbits, group))):
                location, numbers = _location_of_least(rows, "spectral_radius")
                parts.add(f"{group} at {name}{what}", location < 0.5, **numbers)
                locations.append(location)
    if not len(parts):
        return parts, "no stable cycles in B, C or D", {}
    return parts, f"minimum at {min(locations):.0%} to {max(locations):.0%} of the range of k", {}


def _location_of_least(rows: pd.DataFrame, column: str) -> tuple[float, dict[str, Any]]:
    """Where in a range of `k` a column is smallest: 0 at its start, 1 at its end; NaN for an empty table."""
    if rows.empty:
        return np.nan, {}
    low, high = rows["k"].min(), rows["k"].max()
    where = rows["k"][rows[column].idxmin()]
    location = 0.0 if high == low else (where - low) / (high - low)
    numbers = {
        "k_low": low,
        "k_high": high,
        "least": rows[column].min(),
        "least_at_k": where,
        "place": location,
    }
    return float(location), numbers


@statement(
    "C9",
    "The range of k with stable cycles is wider at omega = 3 than at omega = 2",
    short="stable ranges of k are wider at omega = 3",
    where=PERFORMANCE,
    figure=in_rows.stable_ranges,
)
def c9(data: CycleTables) -> Decided:
    """Total length of the values of `k` from 0.1 to 60 with stable cycles, ends bisected.

    A part for each alpha, all groups together, and for each alpha and each group that has stable cycles and
    ends before k = 60 at both frequencies.
    """
    parts, texts, ranges = Parts(), [], {}
    for alpha in ALPHAS:
        found = {omega: _runs(data, alpha, omega) for omega in OMEGAS}
        total = {omega: _length(groups) for omega, groups in found.items()}
        slow, fast = (total[omega] for omega in OMEGAS)
        parts.add(
            f"all groups at alpha {alpha:g}", fast > slow, k_length={f"{w:g}": total[w] for w in OMEGAS}
        )
        texts.append(f"alpha {alpha:g}: {fast:.2f} at omega 3, {slow:.2f} at omega 2")
        for group in GROUPS:
            both = [found[omega][group] for omega in OMEGAS]
            if all(both) and not any(run.cut_high for one in both for run in one):
                slow, fast = (sum(run.width for run in one) for one in both)
                parts.add(f"{group} at alpha {alpha:g}", fast > slow, k_length={"2": slow, "3": fast})
        for omega in OMEGAS:
            ranges[f"alpha {alpha:g}, omega {omega:g}"] = {
                group: [[run.opens, run.closes] for run in one] for group, one in found[omega].items()
            }
    return parts, "length of the range of k: " + ", ".join(texts), {"stable_k": ranges}


def _runs(data: CycleTables, alpha: float, omega: float) -> dict[str, list[Run]]:
    """Ranges with stable cycles of each of the five groups at one alpha and omega."""
    orbits, edges = at(data.lines, alpha=alpha, omega=omega), at(data.edges, alpha=alpha, omega=omega)
    return {
        group: stable_runs(orbits[orbits["group"] == group], data.line_k, edges[edges["group"] == group])
        for group in GROUPS
    }


def _length(groups: dict[str, list[Run]]) -> float:
    """Length of the union of all ranges."""
    length, reached = 0.0, -np.inf
    for run in sorted((run for one in groups.values() for run in one), key=lambda run: run.opens):
        length += max(0.0, run.closes - max(run.opens, reached))
        reached = max(reached, run.closes)
    return length


@statement(
    "C10",
    "Stable cycles take most of k for alpha from 0.4 to 0.5, little for very small or large alpha",
    short="most stable cycles are at alpha from 0.4 to 0.5",
    where=DEPENDENCY,
    figure=in_rows.shares_over_alpha,
)
def c10(data: CycleTables) -> Decided:
    """The share of the values of `k` up to 60 at which there is a stable cycle, over a fine axis of alpha.

    For each omega: ``largest from 0.4 to 0.5``; ``few at the smallest alpha`` and ``few at the largest
    alpha`` that were searched: less than half of the largest share; ``stability is lost``: cycles are there
    at the largest alpha too, but the share of `k` with cycles that has stable ones is less than half of
    what it is from 0.4 to 0.5.
    """
    parts, texts = Parts(), []
    further: dict[str, Any] = {}
    for omega in OMEGAS:
        orbits = at(data.map, omega=omega)
        alpha, count = data.map_alpha, len(data.map_k)
        walk, firm = _share(orbits, alpha, count), _share(stable(orbits), alpha, count)
        kept = np.divide(firm, walk, out=np.zeros_like(firm), where=walk > 0)
        middle = (alpha >= 0.4 - 1e-9) & (alpha <= 0.5 + 1e-9)
        best, around = alpha[firm.argmax()], firm[middle].max(initial=0)
        here = f"at omega {omega:g}"
        parts.add(
            f"largest from 0.4 to 0.5 {here}",
            0.4 <= round(best, 9) <= 0.5,
            largest_at_alpha=best,
            share=firm.max(),
        )
        for which, i in (("smallest", 0), ("largest", -1)):
            parts.add(
                f"few at the {which} alpha {here}", firm[i] < firm.max() / 2, alpha=alpha[i], share=firm[i]
            )
        kept_around = kept[middle].max(initial=0)
        lost = walk[-1] > 0 and kept[-1] < kept_around / 2
        parts.add(
            f"stability is lost {here}", lost,
            kept_at_largest_alpha=kept[-1], kept_from_04_to_05=kept_around,
        )  # fmt: skip
        by_group = {g: _share(stable(orbits, g), alpha, count) for g in GROUPS}
        further[f"omega {omega:g}"] = {
            "alpha": alpha,
            "share_of_k_with_cycles": walk,
            "share_of_k_with_stable_cycles": firm,
            "by_group": by_group,
            "largest_by_group_at_alpha": {g: alpha[s.argmax()] for g, s in by_group.items() if s.any()},
        }
        single = ", ".join(
            f"{g} {a:g}"
            for g, a in further[f"omega {omega:g}"]["largest_by_group_at_alpha"].items()
            if g in "ABC"
        )
        texts.append(
            f"omega {omega:g}: largest ({firm.max():.0%}) at alpha {best:g}, {around:.0%} from 0.4 to 0.5, "
            f"{firm[-1]:.0%} at {alpha[-1]:g}, group by group at {single}"
        )
    return parts, "; ".join(texts), further


def _share(orbits: pd.DataFrame, alpha: np.ndarray, count: int) -> np.ndarray:
    """Share of `count` values of `k` that occur among `orbits`, for each alpha."""
    found = orbits.groupby("alpha")["k"].nunique()
    return found.reindex(alpha).fillna(0).to_numpy(dtype=np.float64) / count
