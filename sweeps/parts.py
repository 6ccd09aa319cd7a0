"""What is kept of a finished tile until its sweep is finished: all of a result in one table."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from stridemap.solver.model.model import Model
from stridemap.sweeps.solutions import Guesses, Links, Solutions
from stridemap.sweeps.special_tables import special_table_of
from stridemap.sweeps.tables import orbit_schema, special_schema, table_of
from stridemap.sweeps.tasks import Result

KIND, REASON, NUMBER, OTHER = "_kind", "_reason", "_number", "_other"
"""Columns of a part that orbits lack: what a row is, why a cell failed, a number, and another branch. A row
of solutions that were thrown away has their status as its reason, and how many they are as its number; a
guess or a link has the cell that it comes from as its number."""

ORBIT, FAILURE, SEEN, GUESS, LINK, DISCARDED, JOIN, SPECIAL = (
    "orbit", "failure", "seen", "guess", "link", "discarded", "join", "special"
)  # fmt: skip
"""Kinds of rows of a part."""


def part_table(model: Model, result: Result) -> pa.Table:
    """A result as a table.

    Parameters
    ----------
    model : Model
    result : Result
    """
    failures = sorted(result.failures.items())
    orbits = table_of(model, result.orbits)
    of_kind: dict[str, Mapping[str, Any]] = {
        ORBIT: columns_of(orbits),
        FAILURE: {"cell": [cell for cell, _ in failures], REASON: [why for _, why in failures]},
        DISCARDED: {
            "cell": [cell for cell, _ in result.discarded],
            REASON: [status for _, status in result.discarded],
            NUMBER: list(result.discarded.values()),
        },
        SEEN: _columns(model, result.seen),
        GUESS: {**_columns(model, result.outgoing), NUMBER: result.outgoing.origin},
        LINK: {**_columns(model, result.links), NUMBER: result.links.origin, OTHER: result.links.other},
        SPECIAL: columns_of(special_table_of(model, result.special)),
        JOIN: {"branch": result.joins[:, 0], OTHER: result.joins[:, 1]},
    }
    schema = _schema(model)
    return pa.concat_tables([_rows(schema, kind, columns) for kind, columns in of_kind.items()])


def result_of(model: Model, round_: int, tile: int, part: pa.Table) -> Result:
    """The result from which a table was made.

    Parameters
    ----------
    model : Model
    round_, tile : int
    part : Table
        As from `part_table`, or what `counted_columns` names of it: cycles then have these columns only.
    """

    def rows(kind: str) -> pa.Table:
        return part.filter(pc.equal(part[KIND], kind))

    orbits, failed, thrown, joins = (rows(k) for k in (ORBIT, FAILURE, DISCARDED, JOIN))
    special = rows(SPECIAL)
    if len(special):
        special = special.select(special_schema(model).names).cast(special_schema(model))
    else:
        special = special_table_of(model, {})
    cycles = pa.schema([field for field in orbit_schema(model) if field.name in part.column_names])
    lost = zip(*(thrown[name].to_pylist() for name in ("cell", REASON, NUMBER)), strict=True)
    return Result(
        round_,
        tile,
        columns_of(orbits.select(cycles.names).cast(cycles)),
        dict(zip(failed["cell"].to_pylist(), failed[REASON].to_pylist(), strict=True)),
        solutions_of(model, rows(SEEN)),
        guesses_of(model, part),
        _links_of(model, rows(LINK)),
        np.column_stack([joins[name].to_numpy() for name in ("branch", OTHER)]),
        columns_of(special),
        {(cell, status): n for cell, status, n in lost},
    )


def counted_columns(model: Model, special: bool) -> list[str]:
    """The columns of a part that are needed to take account of it, special points included or not."""
    names = [*guess_columns(model), "stable", REASON, OTHER]
    return list(dict.fromkeys(names + (special_schema(model).names if special else [])))


def orbits_of(model: Model, part: pa.Table) -> pa.Table:
    """The limit cycles of a part, as a table of `orbit_schema`, from at least `orbit_columns`."""
    schema = orbit_schema(model)
    return part.filter(pc.equal(part[KIND], ORBIT)).select(schema.names).cast(schema)


def orbit_columns(model: Model) -> list[str]:
    """The columns of a part that limit cycles have, and the one that says which rows these are."""
    return [*orbit_schema(model).names, KIND]


def known_of(model: Model, part: pa.Table) -> tuple[Solutions, Solutions]:
    """Cycles of a part, and what the search gave before it converged, from at least `known_columns`."""
    cycles, seen = (solutions_of(model, part.filter(pc.equal(part[KIND], kind))) for kind in (ORBIT, SEEN))
    return cycles, seen


def guesses_of(model: Model, part: pa.Table) -> Guesses:
    """The guesses of a part for other tiles, from at least `guess_columns`."""
    guesses = part.filter(pc.equal(part[KIND], GUESS))
    made = solutions_of(model, guesses)
    return Guesses(made.cell, made.u, made.branch, guesses[NUMBER].to_numpy())


def _links_of(model: Model, rows: pa.Table) -> Links:
    """The links of rows."""
    made = solutions_of(model, rows)
    return Links(made.cell, made.u, made.branch, rows[NUMBER].to_numpy(), rows[OTHER].to_numpy())


def guess_columns(model: Model) -> list[str]:
    """The columns of a part that `guesses_of` needs."""
    return [*known_columns(model), NUMBER]


def known_columns(model: Model) -> list[str]:
    """The columns of a part that `known_of` needs."""
    return ["cell", "branch", *model.section, "period", KIND]


def columns_of(table: pa.Table) -> dict[str, pa.ChunkedArray]:
    """The columns of a table by name."""
    return dict(zip(table.column_names, table.columns, strict=True))


def solutions_of(model: Model, rows: Mapping[str, Any] | pa.Table) -> Solutions:
    """Section points and periods of rows, with their cells and branches."""
    u = np.column_stack([np.asarray(rows[name]) for name in (*model.section, "period")])
    return Solutions(np.asarray(rows["cell"]), u, np.asarray(rows["branch"]))


def _columns(model: Model, solutions: Solutions) -> dict[str, Any]:
    u = dict(zip((*model.section, "period"), solutions.u.T, strict=True))
    return {"cell": solutions.cell, "branch": solutions.branch, **u}


def _rows(schema: pa.Schema, kind: str, columns: Mapping[str, Any]) -> pa.Table:
    """Rows of one kind; null in the columns that are not given."""
    n = len(next(iter(columns.values())))
    nulls = {field.name: pa.nulls(n, field.type) for field in schema}
    return pa.Table.from_pydict({**nulls, **columns, KIND: [kind] * n}, schema=schema)


def _schema(model: Model) -> pa.Schema:
    fields = [field.with_nullable(True) for field in orbit_schema(model)]
    have = set(orbit_schema(model).names)
    fields += [field.with_nullable(True) for field in special_schema(model) if field.name not in have]
    fields += [
        pa.field(KIND, pa.string()),
        pa.field(REASON, pa.string()),
        *(pa.field(name, pa.int64()) for name in (NUMBER, OTHER)),
    ]
    return pa.schema(fields)
