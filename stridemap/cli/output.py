"""What commands print: tables in plain text, numbers in full."""

import math
import re
import sys
from collections.abc import Mapping, Sequence
from typing import Any

from stridemap.cli.si import Size
from stridemap.columns import Column, columns_of
from stridemap.quantities import QUANTITIES
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.report import ENDS, SearchReport
from stridemap.spec import Quantity


def print_orbits(orbits: Orbits, size: Size | None = None, varied: str | None = None) -> None:
    """Print limit cycles as a table: a column per cycle, and behind them each row's unit and meaning.

    Parameters
    ----------
    orbits : Orbits
    size : Size, optional
        The units in which numbers are printed.
    varied : str, optional
        A parameter that differs, whose values come first.
    """
    size = size or Size(columns_of(orbits.model.spec))
    shown = list(orbits)
    rows: list[tuple[str, list[str]]] = []
    if varied is not None:
        rows.append((varied, [f"{size.shown(varied, o.params[varied]):.14g}" for o in shown]))
    rows.append(("status", [o.status.value for o in shown]))
    if shown[0].steps:
        rows.append(("steps", [str(o.period_n) for o in shown]))
    rows += [(name, [f"{size.shown(name, o.state[name]):.12f}" for o in shown]) for name in shown[0].state]
    rows.append(("period", [f"{size.shown('period', o.period):.12f}" for o in shown]))
    for i in range(len(shown[0].multipliers)):
        rows.append((f"multiplier {i}", [_complex(o.multipliers[i]) for o in shown]))
    rows += [(name, [_cell(size.shown(name, o.measures[name])) for o in shown]) for name in shown[0].measures]
    head = ["", *(f"cycle {i}" for i in range(1, len(shown) + 1)), "unit", "meaning"]
    print_table(
        [head, *([name, *cells, *_words(name, size, orbits.model.measured)] for name, cells in rows)], texts=2
    )


def print_csv(orbits: Orbits, size: Size) -> None:
    """Print limit cycles as comma-separated values: a row per cycle, the columns of a sweep's table."""
    from stridemap.tables.export import csv_text
    from stridemap.tables.table import table_of

    table = table_of(orbits)
    print(csv_text((table if size.units is None else table.to_si(size.units)).frame), end="")


def _words(name: str, size: Size, measured: Mapping[str, Quantity]) -> list[str]:
    """Unit and meaning of a row."""
    if name.startswith("multiplier "):
        return ["1", f"Floquet multiplier {name.removeprefix('multiplier ')}"]
    if name == "steps":
        return ["", "walking steps until the gait repeats"]
    one = size.column(name)
    return [one.unit, _meaning(one, measured)]


def _meaning(one: Column, measured: Mapping[str, Quantity]) -> str:
    """What a row holds: its label, or where that only repeats the name the beginning of its definition."""
    quantity = measured.get(one.name, QUANTITIES.get(one.name))
    if quantity is None or one.label.replace("-", " ") != one.name.replace("_", " "):
        return one.label
    words = re.split(r"[;:.]", quantity.definition)[0]
    return words[:1].lower() + words[1:]


def print_search(report: SearchReport, found: bool) -> None:
    """Print on standard error how many starts ended where, and what may have been missed."""
    if found and not report.warnings:
        return
    ended = (f"{count:,} {ENDS[word]}" for word, count in report.ended.items() if count)
    print(f"{report.starts:,} starts ended: {'; '.join(ended)}", file=sys.stderr)
    for warning in report.warnings:
        print(f"warning: {warning}", file=sys.stderr)


def print_table(rows: Sequence[Sequence[str]], texts: int = 0) -> None:
    """Print rows with their columns aligned: see `aligned`."""
    for line in aligned(rows, texts):
        print(line)


def aligned(rows: Sequence[Sequence[str]], texts: int = 0) -> list[str]:
    """Rows with their columns aligned, the first to the left and the others to the right.

    Parameters
    ----------
    rows : sequence of sequence of str
    texts : int
        How many of the last columns stand to the left as well.
    """
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    last = len(widths) - texts
    lines = []
    for row in rows:
        cells = [
            cell.rjust(w) if 0 < i < last else cell.ljust(w)
            for i, (cell, w) in enumerate(zip(row, widths, strict=True))
        ]
        lines.append("  ".join(cells).rstrip() if texts else "  ".join(cells))
    return lines


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
