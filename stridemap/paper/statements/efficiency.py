"""C11 to C19: distance of the zero moment point from the foot, and cost of transport."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pandas as pd

from stridemap.paper.claim import Decided, Listed, Parts, shown, statement
from stridemap.paper.cycle_tables import CycleTables
from stridemap.paper.deciding import profiles
from stridemap.paper.deciding.over_k import a_against_b_and_c, growth, least_of_groups, least_of_part, over_k
from stridemap.paper.points import ALPHAS, GROUPS, OMEGAS, PERFORMANCE, TYPICAL
from stridemap.paper.select import (
    compass,
    extremes,
    main_branch,
    slices,
    span,
    stable,
    typical,
    with_minima,
)

Rule = Callable[[CycleTables, str], tuple[Parts, str | Listed]]


def least_is_largest_in_a(data: CycleTables, column: str) -> tuple[Parts, Listed]:
    """At each alpha and omega, the smallest value over stable A is above those over stable B and stable C."""
    parts, texts = Parts(), {}
    for name, _, _, orbits in slices(with_minima(data)):
        found = {g: extremes(stable(orbits, g), column) for g in "ABC"}
        least = {g: found[g].get("least", np.nan) for g in "ABC"}
        for g in "BC":
            parts.add(f"A above {g} at {name}", least["A"] > least[g], A=found["A"], **{g: found[g]})
        texts[name] = "/".join(shown(value, ".3g") for value in least.values())
    return parts, Listed("smallest in A/B/C", texts)


def a_is_above_the_compass(data: CycleTables, column: str) -> tuple[Parts, Listed]:
    """Every stable cycle of A is above the compass, at each alpha and omega."""
    parts, texts = Parts(), {}
    for name, _, omega, orbits in slices(with_minima(data)):
        reference, found = compass(data, omega, column), extremes(stable(orbits, "A"), column)
        parts.add(name, found.get("least", np.nan) > reference, compass=reference, **found)
        texts[name] = f"{shown(found.get('least', np.nan), '.3g')} (compass {shown(reference, '.3g')})"
    return parts, Listed("smallest in A", texts)


def some_are_below_the_compass(
    data: CycleTables, column: str, omegas: tuple[float, ...]
) -> tuple[Parts, Listed]:
    """Some stable cycles of B, and some of C, are below the compass, at each alpha and some omega."""
    parts, texts = Parts(), {}
    for name, _, omega, orbits in slices(data):
        if omega not in omegas:
            continue
        reference, counts = compass(data, omega, column), []
        for g in "BC":
            rows = stable(orbits, g)
            below = rows[rows[column] < reference]
            parts.add(
                f"{g} at {name}", len(below),
                compass=reference, cycles_below=len(below), k_below=span(below), **extremes(rows, column),
            )  # fmt: skip
            counts.append(f"{g} {len(below)}/{len(rows)}")
        texts[name] = " ".join(counts)
    return parts, Listed("stable cycles below it", texts)


def grows(data: CycleTables, column: str) -> tuple[Parts, str]:
    """Whether a measure grows with alpha and with omega, and falls as `k` falls within a group.

    Everything is asked twice: of the group's main branch, and of its stable cycles alone. With alpha and
    with omega it is the mean over a group, for groups that end before k = 60 at both values. With k
    it is that the value at the group's small-k end is below that at the large-k end, and that the smallest
    lies in the lower half of the range. How quickly it falls is evidence only, because the paper does not
    give a scale for it.
    """
    parts = Parts()
    cycles = {
        (alpha, omega): {
            (g, what): rows
            for g in GROUPS
            for what, rows in (("", main_branch(orbits, g)), (" among stable", stable(orbits, g)))
            if len(rows) > 1
        }
        for _, alpha, omega, orbits in slices(data)
    }
    for direction, pairs in (
        ("alpha", [((ALPHAS[0], w), (ALPHAS[1], w), f"omega {w:g}") for w in OMEGAS]),
        ("omega", [((a, OMEGAS[0]), (a, OMEGAS[1]), f"alpha {a:g}") for a in ALPHAS]),
    ):
        for low, high, where in pairs:
            for key in cycles[low]:
                both = [cycles[point][key] for point in (low, high) if key in cycles[point]]
                if len(both) == 2 and all(rows["k"].max() < data.line_k[-1] for rows in both):
                    one, other = (rows[column].mean() for rows in both)
                    name = f"with {direction}, {key[0]} at {where}{key[1]}"
                    parts.add(name, other > one, means=[one, other])
    for (alpha, omega), groups in cycles.items():
        for (g, what), rows in groups.items():
            rises, numbers = _rise(rows, column)
            parts.add(f"with k, {g} at alpha {alpha:g}, omega {omega:g}{what}", rises, **numbers)
    return parts, _tally(parts)


def _rise(rows: pd.DataFrame, column: str) -> tuple[bool, dict[str, Any]]:
    """Whether a measure rises over the range of `k` of a group, and by how much."""
    k, values = rows["k"].to_numpy(), rows[column].to_numpy()
    location = (k[values.argmin()] - k[0]) / (k[-1] - k[0]) if k[-1] > k[0] else np.nan
    numbers = {
        "k": [k[0], k[-1]],
        "ends": [values[0], values[-1]],
        "least": values.min(),
        "least_at_k": k[values.argmin()],
        "share_of_rising_steps": (np.diff(values) > 0).mean(),
        "relative_fall": 1 - values[0] / values[-1],
        "relative_fall_of_k": 1 - k[0] / k[-1],
    }
    return bool(values[0] < values[-1] and location < 0.5), numbers


def _tally(parts: Parts) -> str:
    """How many of the parts about each direction are true."""
    entries = parts.to_dict()
    texts = []
    for direction in ("alpha", "omega", "k"):
        verdicts = [e["holds"] for name, e in entries.items() if name.startswith(f"with {direction},")]
        texts.append(f"with {direction} {sum(verdicts)} of {len(verdicts)}")
    return "so " + ", ".join(texts)


def of_cost(data: CycleTables, rule: Rule) -> Decided:
    """Decide by the cost of transport, and report how the paper's own formula decides.

    The paper divides work by weight and mean speed, which is not a dimensionless cost; the cost of transport
    is work per weight and distance.
    """
    parts, text = rule(data, "cot")
    other, _ = rule(data, "cot_per_speed")
    per_speed = {"verdict": other.verdict().value, "not_so": other.failing()}
    return parts, text, {"with_work_per_weight_and_speed": per_speed}


@statement(
    "C11",
    "The smallest d_max of stable cycles is larger in A than in B and than in C",
    short="smallest d_max is larger in A than in B and C",
    where=PERFORMANCE,
    figure=over_k(
        "d_max",
        a_against_b_and_c,
        "d_max of stable cycles in A, B and C; marked are the smallest.",
        groups="ABC",
    ),
)
def c11(data: CycleTables) -> Decided:
    """See `least_is_largest_in_a`."""
    return *least_is_largest_in_a(data, "d_max"), {}


@statement(
    "C12",
    "In stable cycles of A, d_max is always above the compass's",
    short="d_max of stable A is above the compass's",
    where=PERFORMANCE,
    figure=over_k(
        "d_max",
        least_of_part,
        "d_max of A; marked is the smallest of stable cycles.",
        groups="A",
        reference=True,
    ),
)
def c12(data: CycleTables) -> Decided:
    """See `a_is_above_the_compass`."""
    return *a_is_above_the_compass(data, "d_max"), {}


@statement(
    "C13",
    "At omega = 2, some stable cycles of B and of C have d_max below the compass's",
    short="some of B and C have d_max below the compass's",
    where=PERFORMANCE,
    figure=over_k(
        "d_max",
        least_of_groups("{group} at {name}"),
        "d_max of B and C; marked are the smallest of stable cycles.",
        groups="BC",
        reference=True,
        omegas=(2.0,),
    ),
)
def c13(data: CycleTables) -> Decided:
    """See `some_are_below_the_compass`."""
    return *some_are_below_the_compass(data, "d_max", (2.0,)), {}


@statement(
    "C14",
    "d_max grows with alpha and omega, and falls quickly as k falls within a group",
    short="d_max grows with alpha, omega, and k within a group",
    where=PERFORMANCE,
    figure=growth("d_max"),
)
def c14(data: CycleTables) -> Decided:
    """See `grows`."""
    return *grows(data, "d_max"), {}


@statement(
    "C15",
    "d is positive first and then negative; of the typical solutions A's d fluctuates most",
    short="d is positive, then negative; it varies most in A",
    where=PERFORMANCE,
    figure=profiles.distance,
)
def c15(data: CycleTables) -> Decided:
    """Signs in each typical solution, and which of them has the largest range of d.

    Signs: d starts positive, changes its sign once, and is on average positive in the first half of the
    step and negative in the second. How long it is positive, and the signs in all stable cycles, are
    further evidence. Range: greatest minus least d.
    """
    parts, travel, crossing = Parts(), {}, []
    for g in TYPICAL:
        cycle = typical(data, g)
        good = cycle is not None and _turns_negative_once(cycle)
        names = (
            "d_start",
            "d_sign_changes",
            "d_crossing",
            "d_first",
            "d_second",
            "d_first_positive",
            "d_second_negative",
        )
        parts.add(f"signs in {g}", good, **({} if cycle is None else {name: cycle[name] for name in names}))
        travel[g] = np.nan if cycle is None else float(cycle["d_travel"])
        crossing.append("-" if cycle is None else shown(cycle["d_crossing"], ".2f"))
    parts.add("A fluctuates most", travel["A"] > max(travel["B"], travel["C"]), travel=travel)
    ranges = ", ".join(f"{g} {shown(value, '.3f')}" for g, value in travel.items())
    elsewhere = {
        name: {
            g: f"{_turns_negative_once(rows).sum()} of {len(rows)}"
            for g in TYPICAL
            for rows in [stable(orbits, g)]
        }
        for name, _, _, orbits in slices(data)
    }
    return (
        parts,
        f"range of d: {ranges}; sign changes at {'/'.join(crossing)} of the step",
        {"so_in_stable_cycles": elsewhere},
    )


def _turns_negative_once(cycles: Any) -> Any:
    """Whether d goes from positive to negative, in a cycle or in each of a table."""
    averages = (cycles["d_first"] > 0) & (cycles["d_second"] < 0)
    return (cycles["d_start"] > 0) & (cycles["d_sign_changes"] == 1) & averages


@statement(
    "C16",
    "The smallest CoT of stable cycles is larger in A than in B and than in C",
    short="smallest CoT is larger in A than in B and C",
    where=PERFORMANCE,
    figure=over_k(
        "cot",
        a_against_b_and_c,
        "Cost of transport of stable cycles in A, B and C; marked are the smallest.",
        groups="ABC",
    ),
)
def c16(data: CycleTables) -> Decided:
    """See `least_is_largest_in_a`."""
    return of_cost(data, least_is_largest_in_a)


@statement(
    "C17",
    "In stable cycles of A, CoT is always above the compass's",
    short="CoT of stable A is above the compass's",
    where=PERFORMANCE,
    figure=over_k(
        "cot",
        least_of_part,
        "Cost of transport of A; marked is the smallest of stable cycles.",
        groups="A",
        reference=True,
    ),
)
def c17(data: CycleTables) -> Decided:
    """See `a_is_above_the_compass`."""
    return of_cost(data, a_is_above_the_compass)


@statement(
    "C18",
    "Some stable cycles of B and of C have CoT below the compass's",
    short="some of B and C have CoT below the compass's",
    where=PERFORMANCE,
    figure=over_k(
        "cot",
        least_of_groups("{group} at {name}"),
        "Cost of transport of B and C; marked are the smallest of stable cycles.",
        groups="BC",
        reference=True,
    ),
)
def c18(data: CycleTables) -> Decided:
    """See `some_are_below_the_compass`."""
    return of_cost(data, lambda d, column: some_are_below_the_compass(d, column, OMEGAS))


@statement(
    "C19",
    "CoT grows with alpha and omega, and falls quickly as k falls within a group",
    short="CoT grows with alpha, omega, and k within a group",
    where=PERFORMANCE,
    figure=growth("cot"),
)
def c19(data: CycleTables) -> Decided:
    """See `grows`."""
    return of_cost(data, grows)
