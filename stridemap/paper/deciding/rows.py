"""Ranges of k and alpha, and shares, beside their thresholds."""

from typing import Any

import numpy as np

from stridemap.paper.claim import shown
from stridemap.paper.cycle_tables import CycleTables
from stridemap.paper.deciding.over_k import Evidence, ends, title
from stridemap.paper.points import ALPHAS, GROUPS, OMEGAS, PLANE, TYPICAL
from stridemap.paper.select import at, slices, stable
from stridemap.views.small_figures import (
    Axis,
    Band,
    Bar,
    Curve,
    Guide,
    Mark,
    Panel,
    SmallFigure,
    look_of,
    rows_axis,
)

K = "spring stiffness k"
STABILITY = "largest |μ|"
POINTS = {f"alpha {a:g}, omega {w:g}": {"alpha": a, "omega": w} for w in OMEGAS for a in ALPHAS}


def typical_stability(data: CycleTables, evidence: Evidence) -> SmallFigure:
    """C1: the largest multiplier of what is at each typical solution, beside 1."""
    parts = evidence["parts"]
    rows, marks, others = list(TYPICAL.items()), [], []
    for i, (group, k) in enumerate(rows):
        part = parts.get(f"k = {k:g} in {group}", {})
        here = at(data.typical, k=k)
        radii = sorted(here["spectral_radius"][here["group"] == group])
        for number, radius in enumerate(radii):
            if number:
                others.append((radius, i))
            else:
                place = {"k": k, **PLANE}
                marks.append(Mark(radius, i, bool(part.get("holds")), shown(radius, ".3f"), place))
    more = Curve("unstable", [x for x, _ in others], [y for _, y in others], dots=True)
    low, high = ends([1.0, *(mark.x for mark in marks), *more.x], 0.3)
    panel = Panel(
        f"at {title(PLANE)}", Axis(STABILITY, low, high), rows_axis([f"{g}, k = {k:g}" for g, k in rows]),
        [more], marks=marks, guides=[Guide("x", 1.0, "stable below 1")],
    )  # fmt: skip
    return SmallFigure(
        "Largest multipliers at the typical solutions; to the left of 1 a cycle is stable.", [panel]
    )


def order_of_groups(_: CycleTables, evidence: Evidence) -> SmallFigure:
    """C2: where each letter is on the main branch, the gaps between, and where letters are over alpha."""
    parts = evidence["parts"]
    bars, marks = [], []
    for row, (name, point) in enumerate(POINTS.items()):
        letters = parts.get(f"order at {name}", {}).get("k", {})
        for group, k in letters.items():
            if k:
                bars.append(Bar(look_of(group), row, k[0], k[1], group, {"k": k[0], **point}))
        for gap in parts.get(f"gaps at {name}", {}).get("gaps", []):
            k = (gap["k_from"] + gap["k_to"]) / 2
            marks.append(Mark(k, row, gap["k_without"] > 0, "", {"k": k, **point}))
    names = [title(point) for point in POINTS.values()]
    panels = [Panel("groups on the main branch", Axis(K, 0, 61), rows_axis(names), bars=bars, marks=marks)]
    for omega in OMEGAS:
        part = parts.get(f"all five at omega {omega:g}", {})
        spans = part.get("alpha", {})
        bars = [Bar(look_of(g), i, a[0], a[1], g) for i, g in enumerate(GROUPS) if (a := spans.get(g))]
        marks = [
            Mark(0.02, i, holds=False, text="none found") for i, g in enumerate(GROUPS) if not spans.get(g)
        ]
        panels.append(
            Panel(
                f"stable somewhere, ω = {omega:g}", Axis("mass ratio α", 0, 1),
                rows_axis(list(GROUPS)), bars=bars, marks=marks,
            )
        )  # fmt: skip
    return SmallFigure(
        "Where each group is on the main branch; marked are the gaps between groups. For each ω: from the "
        "smallest to the largest α with stable cycles of a group.",
        panels,
    )


def shares_of_time(_: CycleTables, evidence: Evidence) -> SmallFigure:
    """C3: for how much of either half of the step x has the stated sign, at the least."""
    parts = evidence["parts"]
    rows: list[str] = []
    marks: list[Mark] = []
    for part, entry in parts.items():
        group, _, name = part.partition(" at ")
        share, k = entry.get("least_share_of_time"), entry.get("least_share_at_k")
        if share is not None:
            place = None if k is None else {"k": k, **POINTS[name]}
            marks.append(Mark(100 * share, len(rows), entry["holds"], f"{100 * share:.0f} %", place))
        rows.append(f"{group}, {title(POINTS[name])}")
    panel = Panel(
        "least share of either half of the step", Axis("% of the time with the stated sign", 0, 115),
        rows_axis(rows), marks=marks, guides=[Guide("x", 50.0, "half of the time")],
    )  # fmt: skip
    return SmallFigure(
        "The stable cycle of each group whose x has the stated sign for the least time.", [panel]
    )


def sign_changes(data: CycleTables, evidence: Evidence) -> SmallFigure:
    """C4: how often x changes its sign, over k; marked is the first cycle that does not as stated."""
    parts = evidence["parts"]
    panels = []
    for name, alpha, omega, orbits in slices(data):
        point, curves, marks = {"alpha": alpha, "omega": omega}, [], []
        for group in GROUPS:
            rows = stable(orbits, group)
            if rows.empty:
                continue
            curves.append(_dots(group, rows["k"], rows["x_zero_crossings"]))
            entry = parts.get(f"most of {group} at {name}")
            if entry:
                all_ = entry["so_in"] == entry["cycles"]
                k = (entry["k_so"] if all_ else entry["k_not_so"])[0]
                (count, *_) = rows["x_zero_crossings"][np.isclose(rows["k"], k)]
                marks.append(Mark(k, count, all_, f"{entry['so_in']}/{entry['cycles']}", {"k": k, **point}))
        guides = [Guide("y", 2.0 * n, f"{g}: {2 * n}") for g, n in (("C", 2), ("D", 3), ("E", 4))]
        panels.append(
            Panel(
                title(point), Axis(K, 0, 61), Axis("sign changes of x per step", 0, 11.5), curves,
                marks=marks, guides=guides,
            )
        )  # fmt: skip
    return SmallFigure(
        "How often x changes its sign in stable cycles; marked is the first that is not as stated, "
        "with how many are.",
        panels,
    )


def _dots(group: str, x: Any, y: Any) -> Curve:
    return Curve(look_of(group), list(x), list(y), dots=True, text=group)


def stable_ranges(_: CycleTables, evidence: Evidence) -> SmallFigure:
    """C9: the ranges of k with stable cycles, and their lengths at both frequencies."""
    parts, found = evidence["parts"], evidence["stable_k"]
    order = [f"alpha {a:g}, omega {w:g}" for a in ALPHAS for w in OMEGAS]
    bars = [
        Bar(look_of(g), row, low, high, g, {"k": low, **POINTS[name]})
        for row, name in enumerate(order)
        for g, runs in found.get(name, {}).items()
        for low, high in runs
    ]
    ranges = Panel(
        "ranges with stable cycles", Axis(K, 0, 61), rows_axis([title(POINTS[n]) for n in order]), bars=bars
    )
    lengths = {part: entry["k_length"] for part, entry in parts.items()}
    marks, spans = [], []
    for row, (part, length) in enumerate(lengths.items()):
        slow, fast = length["2"], length["3"]
        spans.append(Bar("plain", row, min(slow, fast), max(slow, fast)))
        marks.append(Mark(fast, row, parts[part]["holds"], f"{slow:.3g} → {fast:.3g}"))
    rows = [part.replace(" at alpha ", ", α ") for part in lengths]
    high = max([length for of in lengths.values() for length in of.values()], default=1.0) or 1.0
    longer = Panel("length of the ranges", Axis("length in k, from ω = 2 to 3", 0, 1.7 * high),
                   rows_axis(rows), bars=spans, marks=marks)  # fmt: skip
    return SmallFigure(
        "Where stable cycles are, and how long these ranges of k are at ω = 3.", [ranges, longer]
    )


def shares_over_alpha(_: CycleTables, evidence: Evidence) -> SmallFigure:
    """C10: the share of k with cycles, and with stable ones, over alpha."""
    panels = []
    for omega in OMEGAS:
        parts, found, here = evidence["parts"], evidence[f"omega {omega:g}"], f"at omega {omega:g}"
        alpha = found.get("alpha", [])
        curves = [
            Curve("unstable", alpha, _percent(found.get("share_of_k_with_cycles", []))),
            Curve("stable", alpha, _percent(found.get("share_of_k_with_stable_cycles", []))),
        ]
        marks = []
        largest = parts.get(f"largest from 0.4 to 0.5 {here}", {})
        ends_ = [parts.get(f"few at the {which} alpha {here}", {}) for which in ("smallest", "largest")]
        for entry, key in ((largest, "largest_at_alpha"), *((entry, "alpha") for entry in ends_)):
            if entry:
                a, share = entry[key], 100 * entry["share"]
                mark = Mark(a, share, entry["holds"], f"{share:.0f} %", {"alpha": a, "omega": omega})
                marks += [mark] if mark not in marks else []
        panels.append(
            Panel(
                title({"omega": omega}), Axis("mass ratio α", 0, 1), Axis("% of k up to 60", 0, 118),
                curves, marks=marks, bands=[Band("x", 0.4, 0.5, "where the paper has most stable cycles")],
            )
        )  # fmt: skip
    return SmallFigure(
        "Share of the values of k at which there is a stable cycle (thick), or any (thin); shaded is α from "
        "0.4 to 0.5.",
        panels,
    )


def _percent(values: Any) -> list[float]:
    return [100 * value for value in values]
