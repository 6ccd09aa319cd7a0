"""A limit cycle as a C header: what a controller refers to, as constant arrays."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from stridemap.derive.printers.c import REAL, aligned, wrapped
from stridemap.spec import ModelSpec

Rows = Sequence[Sequence[float]]


@dataclass(frozen=True)
class Cycle:
    """The numbers of a limit cycle.

    Parameters
    ----------
    summary : str
        The cycle in a few words.
    measured : sequence of (str, str)
        What is worth knowing of it: name, and value with its unit.
    params : sequence of float
    z : sequence of rows
        Section point just after the touchdown that begins each walking step.
    periods : sequence of float
        Of each walking step.
    multipliers : sequence of complex
    q, v, dv, u : sequence of tables
        Coordinates, rates, accelerations and torques of each walking step, one row for each of evenly spaced
        times, from the beginning of the step to its end.
    between : (float, float)
        Largest errors of cubic interpolation between rows, in coordinates and in rates.
    """

    summary: str
    measured: Sequence[tuple[str, str]]
    params: Sequence[float]
    z: Rows
    periods: Sequence[float]
    multipliers: Sequence[complex]
    q: Sequence[Rows]
    v: Sequence[Rows]
    dv: Sequence[Rows]
    u: Sequence[Rows]
    between: tuple[float, float]


def cycle_header(spec: ModelSpec, cycle: Cycle, name: str) -> str:
    """The header of a limit cycle.

    Parameters
    ----------
    spec : ModelSpec
    cycle : Cycle
    name : str
        Of the header, without its ending; what is in it begins with this name.
    """
    guard, upper = f"STRIDEMAP_{name.upper()}_H", name.upper()
    lines = [
        f"/* {spec.title}: a limit cycle",
        f" * Written by {spec.generator} for equations {spec.hash[:16]}.",
        " * SPDX-License-Identifier: BSD-3-Clause",
        " *",
        *wrapped(f" * {cycle.summary}."),
        *_facts(cycle.measured),
        " */",
        f"#ifndef {guard}",
        f"#define {guard}",
        "",
        f'#include "{spec.name}_step.h"',
        "",
        *_QUIET,
        "enum {",
        *aligned(
            [
                (f"{upper}_STEPS = {len(cycle.z)}", "walking steps after which it closes"),
                (f"{upper}_ROWS = {len(cycle.q[0])}", "of the motion of each step, with both ends"),
            ]
        ),
        "};",
        "",
        *_parameters(spec, cycle, name),
        "/** Section point just after the touchdown that begins each step. */",
        f"static const {REAL} {name}_z[{len(cycle.z)}][{len(spec.section)}] = {{",
        *_rows(cycle.z),
        "};",
        "",
        "/** Period of each step. */",
        f"static const {REAL} {name}_period[{len(cycle.periods)}] = {{{_numbers(cycle.periods)}}};",
        "",
        "/** Floquet multipliers by falling modulus: real and imaginary part. */",
        f"static const {REAL} {name}_multipliers[{len(cycle.multipliers)}][2] = {{",
        *_rows([(m.real, m.imag) for m in cycle.multipliers]),
        "};",
        "",
        *_tables(spec, cycle, name),
        *_AGAIN,
        *_between(spec, cycle, name),
        f"#endif /* {guard} */",
        "",
    ]
    return "\n".join(lines)


_QUIET = (
    "#if defined STRIDEMAP_FLOAT && defined __GNUC__",
    "#pragma GCC diagnostic push",
    '#pragma GCC diagnostic ignored "-Wfloat-conversion" /* the digits are those of doubles */',
    '#pragma GCC diagnostic ignored "-Wconversion"',
    "#endif",
    "",
)
_AGAIN = (
    "#if defined STRIDEMAP_FLOAT && defined __GNUC__",
    "#pragma GCC diagnostic pop",
    "#endif",
    "",
)


def _facts(measured: Sequence[tuple[str, str]]) -> list[str]:
    if not measured:
        return []
    width = max(len(name) for name, _ in measured)
    return [" *", *(f" *  {name:<{width}}  {value}" for name, value in measured)]


def _parameters(spec: ModelSpec, cycle: Cycle, name: str) -> list[str]:
    if not spec.parameters:
        return []
    entries = [(a.name, a.unit, a.meaning) for a in spec.parameters]
    return [
        f"/** Parameters; by name after {spec.name}_parameters_from_array. */",
        f"static const {REAL} {name}_p[{len(entries)}] = {{",
        *_described(cycle.params, entries),
        "};",
        "",
    ]


def _described(values: Sequence[float], entries: Sequence[tuple[str, str, str]]) -> list[str]:
    """Numbers with what they are beside them."""
    described = (f"{name} [{unit}] {meaning}" for name, unit, meaning in entries)
    return aligned(list(zip(map(_number, values), described, strict=True)))


def _tables(spec: ModelSpec, cycle: Cycle, name: str) -> list[str]:
    """The motion over phase."""
    steps, rows = len(cycle.q), len(cycle.q[0])
    tables = [
        ("q", "Coordinates", [c.name for c in spec.coordinates], cycle.q),
        ("v", "Rates", [f"d{c.name}" for c in spec.coordinates], cycle.v),
        ("dv", "Accelerations", [f"dd{c.name}" for c in spec.coordinates], cycle.dv),
        ("u", "Torques", list(spec.actuated), cycle.u),
    ]
    lines = []
    for letter, what, entries, table in tables:
        if entries:
            lines += wrapped(
                f"/** {what} over the phase i / {rows - 1} of each step, i from 0: {', '.join(entries)}. */"
            )
            lines += [f"static const {REAL} {name}_{letter}[{steps}][{rows}][{len(entries)}] = {{"]
            for i, step in enumerate(table):
                lines += ["    {", *_rows(step, "        "), "    }" + ("," if i + 1 < steps else "")]
            lines += ["};", ""]
    return lines


def _between(spec: ModelSpec, cycle: Cycle, name: str) -> list[str]:
    """The function that interpolates the motion."""
    n, last, (off_q, off_v) = len(spec.coordinates), len(cycle.q[0]) - 1, cycle.between
    text = f"""
/* The cubic from a to b with these rates at its ends, at s from 0 to 1. */
static inline {REAL} {name}_cubic({REAL} a, {REAL} b, {REAL} da,
        {REAL} db, {REAL} s)
{{
    const {REAL} cubic = da + db - 2 * (b - a);

    return a + s * (da + s * (b - a - da - cubic + s * cubic));
}}

/** The motion at a time since touchdown, by cubic interpolation.
 *
 * Between two rows it is off by at most {off_q:.1e} in q and {off_v:.1e} in v.
 *
 *  in   step  walking step of the cycle, from 0
 *  in   t     time since touchdown; before 0 and after the period the motion is that at the end
 *  out  q, v  coordinates and rates
 */
static inline void {name}_at(int step, {REAL} t, {REAL} q[{n}], {REAL} v[{n}])
{{
    const {REAL} h = {name}_period[step] / {last};
    {REAL} s = t / h;
    int i, row;

    if (!(s > 0))
        s = 0;
    if (s > {last})
        s = {last};
    row = s < {last} ? (int) s : {last - 1};
    s -= ({REAL}) row;
    for (i = 0; i < {n}; i++) {{
        q[i] = {name}_cubic({name}_q[step][row][i], {name}_q[step][row + 1][i],
                h * {name}_v[step][row][i], h * {name}_v[step][row + 1][i], s);
        v[i] = {name}_cubic({name}_v[step][row][i], {name}_v[step][row + 1][i],
                h * {name}_dv[step][row][i], h * {name}_dv[step][row + 1][i], s);
    }}
}}
"""
    return [*text.strip().split("\n"), ""]


def _rows(rows: Rows, indent: str = "    ") -> list[str]:
    ends = ["," if i + 1 < len(rows) else "" for i in range(len(rows))]
    return [f"{indent}{{{_numbers(row)}}}{end}" for row, end in zip(rows, ends, strict=True)]


def _numbers(values: Iterable[float]) -> str:
    return ", ".join(map(_number, values))


def _number(value: float) -> str:
    """All digits; a negative zero would only puzzle the reader."""
    return repr(float(value) + 0.0)
