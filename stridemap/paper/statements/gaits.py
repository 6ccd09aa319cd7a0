"""C1 to C6 and C20: which cycles there are, and what their time profiles look like."""

from itertools import pairwise
from typing import Any

import numpy as np
import pandas as pd

from stridemap.paper.claim import Decided, Listed, Parts, shown, statement
from stridemap.paper.cycle_tables import CycleTables
from stridemap.paper.deciding import profiles
from stridemap.paper.deciding import rows as in_rows
from stridemap.paper.points import ACTUAL, GROUPS, GROUPS_FOUND, OMEGAS, TYPICAL
from stridemap.paper.select import (
    at,
    compass,
    extremes,
    main_branch,
    slices,
    span,
    stable,
    typical,
)


@statement(
    "C1",
    "There is a stable cycle at each typical solution: k = 0.5 in A, 6 in B, 22.5 in C",
    short="stable cycles at the typical solutions",
    where=GROUPS_FOUND,
    figure=in_rows.typical_stability,
)
def c1(data: CycleTables) -> Decided:
    """At alpha = 0.25 and omega = 3. A part for each: a stable cycle of that group at that k."""
    parts, numbers = Parts(), []
    for group, k in TYPICAL.items():
        here, found = at(data.typical, k=k), typical(data, group)
        parts.add(
            f"k = {k:g} in {group}", found is not None,
            groups_found=here["group"].tolist(), spectral_radius=here["spectral_radius"].tolist(),
        )  # fmt: skip
        if found is not None:
            numbers.append(f"{group} {found['spectral_radius']:.3f}")
    return parts, f"largest multipliers {', '.join(numbers)}" if numbers else "", {}


@statement(
    "C2",
    "Groups A to E follow each other as k grows, with gaps without a cycle on the main branch",
    short="groups A to E in order, with gaps",
    where=GROUPS_FOUND,
    figure=in_rows.order_of_groups,
)
def c2(data: CycleTables) -> Decided:
    """Whether the main branch comes in pieces, lettered in order.

    At each alpha and omega: ``order``, the letters on the main branch, by their smallest k, are A, B, C ...
    without one left out, as far as k = 60 reaches; ``gaps``, between the largest k of each letter and the
    smallest of the next there are values of k without a cycle on the main branch. For each omega: ``all
    five`` letters have stable cycles somewhere on the map.
    """
    parts, letters = Parts(), {}
    for name, _, _, orbits in slices(data):
        main = orbits[orbits["main"].astype(bool)]
        spans = {g: span(main_branch(main, g)) for g in sorted(main["group"].unique())}
        found = "".join(sorted(spans, key=lambda g: spans[g][0]))
        letters[name] = found or "none"
        parts.add(f"order at {name}", bool(found) and "ABCDEFGHIJ".startswith(found), letters=found, k=spans)
        gaps = [_gap(data, spans[a], spans[b]) for a, b in pairwise(found)]
        good = bool(gaps) and all(gap["k_without"] > 0 for gap in gaps)
        parts.add(f"gaps at {name}", good, gaps=gaps)
    for omega in OMEGAS:
        rows = stable(at(data.map, omega=omega))
        where = {g: sorted(rows["alpha"][rows["group"] == g].unique()) for g in GROUPS}
        parts.add(
            f"all five at omega {omega:g}", all(where.values()),
            alpha={g: [min(a), max(a)] if a else [] for g, a in where.items()},
        )  # fmt: skip
    return parts, Listed("letters up to k = 60", letters), {}


def _gap(data: CycleTables, before: list[float], after: list[float]) -> dict[str, Any]:
    """What lies between two groups: its ends, and how many values of `k` were searched in it."""
    inside = (data.line_k > before[1]) & (data.line_k < after[0])
    return {"k_from": before[1], "k_to": after[0], "k_without": int(inside.sum())}


@statement(
    "C3",
    "In A the wobbling mass is behind the hip first and ahead of it later; in B the reverse",
    short="in A the mass is behind the hip first, in B ahead",
    where=GROUPS_FOUND,
    figure=in_rows.shares_of_time,
)
def c3(data: CycleTables) -> Decided:
    """A part for each group at each alpha and omega: it is true of every stable cycle.

    It is true of a cycle if, in either half of the step, x has the stated sign for more than half of the time
    and on average. `x` cannot keep its sign to the very ends of a step, because it is the same at both.
    """
    parts, least = Parts(), 1.0
    for name, _, _, orbits in slices(data):
        for group, sign in (("A", 1), ("B", -1)):
            rows = stable(orbits, group)
            first, second = rows["x_first_behind"], rows["x_second_ahead"]
            if sign < 0:
                first, second = 1 - first, 1 - second
            good = (
                (first > 0.5) & (second > 0.5) & (sign * rows["x_first"] < 0) & (sign * rows["x_second"] > 0)
            )
            shares = np.minimum(first, second).dropna()
            share, where = (shares.min(), rows["k"][shares.idxmin()]) if len(shares) else (np.nan, np.nan)
            least = min(least, share) if len(shares) else least
            parts.add(
                f"{group} at {name}", len(rows) and good.all(),
                cycles=len(rows), so_in=int(good.sum()), least_share_of_time=share, least_share_at_k=where,
                x_mean_first_half=[rows["x_first"].min(), rows["x_first"].max()],
                x_mean_second_half=[rows["x_second"].min(), rows["x_second"].max()],
            )  # fmt: skip
    return parts, f"so for at least {least:.0%} of either half of the step", {}


@statement(
    "C4",
    "The wobbling mass oscillates twice per step in C, three times in D, four times in E",
    short="2, 3, 4 oscillations per step in C, D, E",
    where=GROUPS_FOUND,
    figure=in_rows.sign_changes,
)
def c4(data: CycleTables) -> Decided:
    """Oscillations are half the sign changes of `x` within a step.

    For each of these groups that has stable cycles at an alpha and omega: ``most`` of them and ``all`` of
    them oscillate so; a group without stable cycles anywhere fails. Maxima of `x` are counted as further
    evidence.
    """
    parts, texts, seen = Parts(), {}, set()
    for name, _, _, orbits in slices(data):
        shares = []
        for group, oscillations in (("C", 2), ("D", 3), ("E", 4)):
            rows = stable(orbits, group)
            if rows.empty:
                continue
            seen.add(group)
            good = rows["x_zero_crossings"] == 2 * oscillations
            numbers = {
                "cycles": len(rows),
                "so_in": int(good.sum()),
                "k_so": span(rows[good]),
                "k_not_so": span(rows[~good]),
                "sign_changes": _counts(rows["x_zero_crossings"]),
                "maxima_of_x": _counts(rows["x_maxima"]),
            }
            parts.add(f"most of {group} at {name}", good.mean() > 0.5, **numbers)
            parts.add(f"all of {group} at {name}", good.all())
            shares.append(f"{group} {good.mean():.0%}")
        texts[name] = " ".join(shares) or "none"
    for group in sorted(set("CDE") - seen):
        parts.add(f"{group} exists", False)
    return parts, Listed("share of stable cycles that do", texts), {}


@statement(
    "C5",
    "The rate of theta1 has 1, 2 and 3 peaks in the typical solutions of A, B and C",
    short="1, 2, 3 peaks of the rate of theta1 in A, B, C",
    where=GROUPS_FOUND,
    figure=profiles.peaks,
)
def c5(data: CycleTables) -> Decided:
    """A part for each typical solution. Peaks of all stable cycles are further evidence."""
    parts, counts = Parts(), []
    for peaks, group in enumerate(TYPICAL, 1):
        cycle = typical(data, group)
        found = None if cycle is None else int(cycle["peaks"])
        parts.add(f"{group}: {peaks}", found == peaks, peaks=found)
        counts.append(f"{group} {'-' if found is None else found}")
    further = {
        name: {group: _counts(stable(orbits, group)["peaks"]) for group in TYPICAL}
        for name, _, _, orbits in slices(data)
    }
    return parts, "peaks: " + ", ".join(counts), {"stable_cycles_by_peaks": further}


@statement(
    "C6",
    "The compass has one cycle at each omega, with one peak in the rate of theta1, and resembles A",
    short="the compass has one cycle, which resembles A",
    where=GROUPS_FOUND,
    figure=profiles.like_the_compass,
)
def c6(data: CycleTables) -> Decided:
    """One cycle and one peak at each omega; the likeness with the typical solutions, at omega = 3.

    ``as many peaks as A alone``: as the typical solution of A, and not as those of B and C. ``most like
    A``: the least of the correlations, over the step, between the compass's angles and rates of the legs
    and a typical solution's is larger for A than for B and for C. The greatest differences are further
    evidence: by these C is as near as A in the angles.
    """
    parts = Parts()
    for omega in OMEGAS:
        rows = at(data.compass, omega=omega)
        parts.add(f"one cycle at omega {omega:g}", len(rows) == 1, cycles=len(rows))
        parts.add(f"one peak at omega {omega:g}", len(rows) and (rows["peaks"] == 1).all())
    own = compass(data, OMEGAS[-1], "peaks")
    peaks = {g: _number(typical(data, g), "peaks") for g in TYPICAL}
    alone = [g for g in TYPICAL if peaks[g] == own] == ["A"]
    parts.add("as many peaks as A alone", alone, compass=own, typical=peaks)
    likeness = {g: _number(typical(data, g), "likeness") for g in TYPICAL}
    difference = {
        name: {g: _number(typical(data, g), name) for g in TYPICAL}
        for name in ("angle_difference", "rate_difference")
    }
    likest = likeness["A"] > max(likeness["B"], likeness["C"])
    parts.add("most like A", likest, least_correlation=likeness, **difference)
    text = "least correlation with typical solutions: " + ", ".join(
        f"{g} {shown(c, '.4f')}" for g, c in likeness.items()
    )
    return parts, text, {}


@statement(
    "C20",
    "The wobbling mass moves by about 0.05 of the leg length in the solutions shown",
    short="the mass moves by about 0.05 L",
    where=ACTUAL,
    figure=profiles.amplitude,
)
def c20(data: CycleTables) -> Decided:
    """The greatest modulus of `x` over the three typical solutions.

    ``rounds to 0.05``: from 0.045 to 0.055. ``within a factor of two``: from 0.025 to 0.1. Stable cycles
    elsewhere are further evidence: the paper does not say which solution it means.
    """
    amplitude = {g: _number(typical(data, g), "wobble_amplitude") for g in TYPICAL}
    travel = {g: _number(typical(data, g), "x_travel") for g in TYPICAL}
    largest = np.nanmax([*amplitude.values(), 0.0])
    parts = Parts()
    parts.add("rounds to 0.05", 0.045 <= largest < 0.055, largest=largest, amplitude=amplitude, travel=travel)
    parts.add("within a factor of two", 0.025 <= largest <= 0.1, largest=largest)
    elsewhere = {
        name: {g: extremes(stable(orbits, g), "wobble_amplitude") for g in GROUPS}
        for name, _, _, orbits in slices(data)
    }
    text = "largest |x|: " + ", ".join(f"{g} {shown(value, '.3f')}" for g, value in amplitude.items())
    return parts, text, {"stable_cycles": elsewhere}


def _number(cycle: pd.Series | None, column: str) -> float:
    return float("nan") if cycle is None else float(cycle[column])


def _counts(column: pd.Series) -> dict[str, int]:
    """How often each whole number occurs."""
    return {str(int(value)): int(n) for value, n in column.value_counts().sort_index().items()}
