"""What commands print: tables in plain text, numbers in full."""

import math
import sys
from collections.abc import Sequence
from typing import Any

from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.report import ENDS, SearchReport


def print_orbits(orbits: Orbits, varied: str | None = None) -> None:
    """Print limit cycles as a table, one column each, below the values of a parameter that differs."""
    shown = list(orbits)
    rows: list[tuple[str, list[str]]] = []
    if varied is not None:
        rows.append((varied, [f"{o.params[varied]:.14g}" for o in shown]))
    rows.append(("status", [o.status.value for o in shown]))
    if shown[0].steps:
        rows.append(("steps", [str(o.period_n) for o in shown]))
    rows += [(name, [f"{o.state[name]:.12f}" for o in shown]) for name in shown[0].state]
    rows.append(("period", [f"{o.period:.12f}" for o in shown]))
    for i in range(len(shown[0].multipliers)):
        rows.append((f"multiplier {i}", [_complex(o.multipliers[i]) for o in shown]))
    rows += [(name, [_cell(o.measures[name]) for o in shown]) for name in shown[0].measures]
    head = ["", *(f"cycle {i}" for i in range(1, len(shown) + 1))]
    print_table([head, *([name, *cells] for name, cells in rows)])


def print_search(report: SearchReport) -> None:
    """Print on standard error what a search may have missed, and then how many starts ended where."""
    if not report.warnings:
        return
    ended = (f"{count:,} {ENDS[word]}" for word, count in report.ended.items() if count)
    print(f"{report.starts:,} starts ended: {'; '.join(ended)}", file=sys.stderr)
    for warning in report.warnings:
        print(f"warning: {warning}", file=sys.stderr)


def print_table(rows: Sequence[Sequence[str]]) -> None:
    """Print rows with their columns aligned, the first to the left and the others to the right."""
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    for first, *rest in rows:
        cells = [first.ljust(widths[0]), *(cell.rjust(w) for cell, w in zip(rest, widths[1:], strict=True))]
        print("  ".join(cells))


def _complex(value: complex) -> str:
    return f"{value.real:.10f}" if value.imag == 0 else f"{value.real:.10f}{value.imag:+.10f}i"


def _cell(value: Any) -> str:
    if value is None or value == "":
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        if not math.isfinite(value):
            return "-"
        return f"{value:.10f}" if abs(value) >= 1e-3 else f"{value:.3e}"
    return str(value)
