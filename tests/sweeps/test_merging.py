"""Tables that are written and read in pieces: the same rows, and memory that does not grow with them."""

import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.sweeps import files, found, merging
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.families import families
from stridemap.sweeps.reading import open_sweep, read_sweep
from stridemap.sweeps.run import sweep
from tests.oracles.made_up_tiles import MadeUp
from tests.oracles.sweeping import CONFIG, Remembering, tables


def config(*sizes):
    """A grid of so many values of k, alpha and omega."""
    ends = {"k": (0.5, 60.0), "alpha": (0.05, 0.9), "omega": (2.0, 4.0)}
    grid = {
        name: {"start": low, "stop": high, "num": n}
        for (name, (low, high)), n in zip(ends.items(), sizes, strict=True)
    }
    return parse_config({"model": "wobbling", "grid": grid, "special_points": False})


# -- ranges of cells -----------------------------------------------------------------------------------------


@pytest.mark.quick
def test_ranges_have_about_as_many_rows_as_fit(monkeypatch):
    monkeypatch.setattr(merging, "RANGE_ROWS", 4)
    assert merging.ranges(np.array([1, 1, 1, 1, 1, 1, 1, 1])).tolist() == [0, 4]
    assert merging.ranges(np.array([0, 0, 9, 0, 1, 3, 1])).tolist() == [0, 3, 6]
    assert merging.ranges(np.zeros(5, dtype=int)).tolist() == [0]
    counts = np.random.default_rng(0).integers(0, 9, 500)
    begins = merging.ranges(counts)
    rows = np.add.reduceat(counts, begins)
    assert rows.max() < max(4, -(-counts.sum() // merging.MOST_RANGES)) + 9
    assert len(begins) <= merging.MOST_RANGES


def parts(number, rows, cells, seed=0):
    rng = np.random.default_rng(seed)
    for _ in range(number):
        yield pa.table({"cell": rng.integers(0, cells, rows), "row": rng.integers(0, 10**9, rows)})


@pytest.mark.parametrize("rows", [7, 100, 10**6])
def test_rows_come_by_cells_as_they_came_within_a_range(tmp_path, monkeypatch, rows):
    monkeypatch.setattr(merging, "RANGE_ROWS", rows)
    every = pa.concat_tables(parts(9, 50, 60)).to_pandas()
    begins = merging.ranges(np.bincount(every["cell"], minlength=60))
    assert (len(begins) == 1) == (rows > 450)
    pieces = [one.to_pandas() for one in merging.by_cells(parts(9, 50, 60), begins, tmp_path / "x")]
    for piece, first, last in zip(pieces, begins, [*begins[1:], 60], strict=True):
        within = every[(every["cell"] >= first) & (every["cell"] < last)].reset_index(drop=True)
        pd.testing.assert_frame_equal(piece, within)
    assert list(tmp_path.iterdir()) == []


def test_files_of_ranges_are_removed_when_writing_fails(tmp_path, monkeypatch):
    monkeypatch.setattr(merging, "RANGE_ROWS", 7)
    made = merging.by_cells(parts(2, 50, 60), np.array([0, 20, 40]), tmp_path / "x")
    next(made)
    assert len(list(tmp_path.iterdir())) == 2
    made.close()
    assert list(tmp_path.iterdir()) == []


def test_branches_are_first_met_as_in_the_table():
    rng = np.random.default_rng(3)
    rows = [(rng.integers(0, 9, 40), rng.integers(0, 30, 40), rng.integers(0, 4, 40) / 4) for _ in range(6)]
    first = merging.FirstSeen()
    for part in rows:
        first.add(*part)
    branch, cell, period = (np.concatenate(column) for column in zip(*rows, strict=True))
    ordered = branch[np.lexsort((period, cell))]
    assert first.branches().tolist() == list(dict.fromkeys(ordered.tolist()))
    joins = np.array([[1, 4], [4, 7], [2, 3]])
    number = dict(zip(first.branches(), families(first.branches(), joins), strict=True))
    assert [number[one] for one in ordered] == families(ordered, joins).tolist()
    assert merging.FirstSeen().branches().tolist() == []


# -- the same tables -----------------------------------------------------------------------------------------


def test_a_real_sweep_has_the_same_bytes_in_many_ranges(reference, tmp_path, monkeypatch):
    monkeypatch.setattr(merging, "RANGE_ROWS", 3)
    sweep(CONFIG, tmp_path, executor=Remembering(), tile_cells=2)
    assert tables(tmp_path) == tables(reference[0])


def test_bytes_depend_on_the_rows_and_not_on_their_pieces(tmp_path, monkeypatch):
    written = []
    for rows in (100, 10**6):
        monkeypatch.setattr(merging, "RANGE_ROWS", rows)
        monkeypatch.setattr(files, "GROUP_ROWS", 256)
        monkeypatch.setattr(found, "GROUP_ROWS", rows)
        sweep(config(8, 7, 6), tmp_path / str(rows), executor=MadeUp(), tile_cells=20)
        written.append(tables(tmp_path / str(rows)))
    assert written[0] == written[1]
    metadata = pq.read_metadata(tmp_path / "100" / "orbits.parquet")
    groups = [metadata.row_group(i).num_rows for i in range(metadata.num_row_groups)]
    assert groups[:-1] == [256] * (len(groups) - 1) and 0 < groups[-1] <= 256
    orbits, cells = stridemap.read_orbits(tmp_path / "100"), stridemap.read_cells(tmp_path / "100")
    assert len(orbits) == metadata.num_rows > 2 * 336
    assert orbits["cell"].is_monotonic_increasing
    assert orbits.groupby("cell")["period"].is_monotonic_increasing.all()
    assert cells["orbits"].tolist() == orbits.groupby("cell").size().tolist()
    stable = orbits[orbits["stable"]].groupby("cell").size().reindex(range(336), fill_value=0)
    assert cells["stable_orbits"].tolist() == stable.tolist()
    assert list(dict.fromkeys(orbits["branch"])) == list(range(orbits["branch"].nunique()))


# -- memory --------------------------------------------------------------------------------------------------


POOLS = []
"""Pools that were counted with: what lives on must not be given back to one that is gone."""


def most_memory(make):
    """Bytes that Arrow holds at most while something is done, beyond what it held before."""
    pool = pa.default_memory_pool()
    own = pa.proxy_memory_pool(pool)
    POOLS.append(own)
    pa.set_memory_pool(own)
    try:
        make()
        return own.max_memory()
    finally:
        pa.set_memory_pool(pool)


@pytest.fixture(scope="module")
def sizes(tmp_path_factory):
    """Two sweeps, one of four times as many cells, and what memory each took to be written."""
    folder, most = tmp_path_factory.mktemp("sizes"), {}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(merging, "RANGE_ROWS", 1000)
        patch.setattr(files, "GROUP_ROWS", 1000)
        patch.setattr(found, "GROUP_ROWS", 1000)
        for n in (6, 24):
            where = folder / str(n)
            most[n] = most_memory(
                lambda n=n, where=where: sweep(config(20, 20, n), where, executor=MadeUp(), tile_cells=300)
            )
    return folder, most


def test_writing_takes_no_more_memory_for_more_cells(sizes):
    folder, most = sizes
    rows = {n: pq.read_metadata(folder / str(n) / "orbits.parquet").num_rows for n in most}
    assert rows[24] > 3.9 * rows[6] > 3.9 * 2 * 2400
    assert most[24] < 1.3 * most[6]


def test_reading_what_is_selected_takes_no_more_memory_for_more_cells(sizes):
    folder, _ = sizes
    where = "k < 1 and alpha < 0.1"

    def select(n):
        return lambda: stridemap.read_table(folder / str(n), columns=["cot"], where=where)

    def batches(n):
        return lambda: [len(batch) for batch in stridemap.read_batches(folder / str(n))]

    for read in (select, batches):
        few, many = (most_memory(read(n)) for n in (6, 24))
        assert 0 < many < 1.3 * few
    orbits = stridemap.read_orbits(folder / "24")
    assert (
        most_memory(lambda: stridemap.read_orbits(folder / "24")) < 1.2 * pa.Table.from_pandas(orbits).nbytes
    )


# -- reading -------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def swept(sizes):
    return sizes[0] / "6"


def test_a_part_of_a_table_is_that_part(swept):
    whole = stridemap.read_table(swept)
    condition = "stable and k < 20 and group in ('A', 'B')"
    part = stridemap.read_table(swept, columns=["cot", "cell", "stable"], where=condition)
    kept = whole.where(condition).frame
    assert 0 < len(part) < len(whole)
    pd.testing.assert_frame_equal(
        part.frame, kept[["cot", "cell", "stable"]].reset_index(drop=True), check_flags=False
    )
    assert part.columns["cot"] == whole.columns["cot"]
    assert (part.grid, part.cells) == (whole.grid, None)
    assert list(whole.cells["cell"]) == list(range(2400))
    assert len(stridemap.read_table(swept, where="k > 1000")) == 0
    pd.testing.assert_frame_equal(stridemap.read_orbits(swept), read_sweep(swept).orbits)


def test_batches_are_the_table(swept):
    condition = "period > 1.5"
    batches = list(stridemap.read_batches(swept, columns=["k", "period"], where=condition))
    assert len(batches) > 3
    joined = pd.concat([batch.frame for batch in batches], ignore_index=True)
    wanted = stridemap.read_table(swept, columns=["k", "period"], where=condition).frame
    pd.testing.assert_frame_equal(joined, wanted)


def test_conditions_are_on_values_in_the_units_asked_for(swept):
    robot = stridemap.Units(leg_length=0.75, mass=32.0)
    newtons = 32.0 * 9.80665 / 0.75  # N/m of a stiffness of 1
    part = stridemap.read_table(swept, units=robot, columns=["k", "group"], where=f"k < {20 * newtons}")
    own = stridemap.read_table(swept, columns=["k"], where="k < 20")
    np.testing.assert_allclose(part.frame["k"], own.frame["k"] * newtons, rtol=1e-14)
    assert part.columns["k"].unit == "N/m"
    # Columns without a unit are those of a table that has some.
    group = stridemap.read_table(swept, units=robot, columns=["group"])
    assert len(group) == len(stridemap.read_orbits(swept))
    with pytest.raises(
        InputError, match="need the columns k, alpha, omega, cell, period, which the table lacks"
    ):
        group.export("group.nc")


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (
            {"columns": ["k", "cott"]},
            r"there is no column 'cott' \(did you mean cot\?\); columns are cell, k",
        ),
        ({"columns": "cot"}, "columns = 'cot' is not allowed; give a list of names"),
        ({"columns": []}, r"columns = \[\] is not allowed"),
        ({"columns": ["k", "k"]}, "the column k is given twice"),
        ({"columns": ["k"], "where": "kk < 3"}, "there is no column kk .*stable"),
        ({"where": "k"}, "it is a value and not a condition"),
    ],
)
def test_what_is_not_in_a_table_is_refused(swept, options, words):
    for read in (stridemap.read_table, stridemap.read_batches):
        with pytest.raises(InputError, match=words):
            read(swept, **options)
    if "where" not in options:
        with pytest.raises(InputError, match=words):
            stridemap.read_orbits(swept, **options)


def test_rows_that_no_sweep_writes_are_refused_wherever_they_are(swept, tmp_path):
    """Each piece is looked at with what came before it."""
    opened = open_sweep(swept)
    frames = list(opened.frames())
    assert len(frames) == 6
    for fault, change in {
        "not in the order of their cells": ("cell", lambda cell: cell - 300),
        "not at its cell's parameters": ("k", lambda k: k + 1e-9),
        "not a finite number": ("dx", lambda x: x * np.inf),
        "a period is not above 0": ("period", lambda period: -period),
        "status that is not one": ("status", lambda status: status + "?"),
    }.items():
        name, function = change
        last = frames[-1].assign(**{name: function(frames[-1][name])})
        cells = int(frames[-2]["cell"].iloc[-1])
        with pytest.raises(InputError, match=fault):
            opened._check_orbits(last, cells)
    opened._check_orbits(frames[-1], int(frames[-2]["cell"].iloc[-1]))


def test_a_row_group_that_lacks_rows_is_refused(swept, tmp_path):
    path = tmp_path / "t.parquet"
    pq.write_table(pa.table({"a": [1.0, 2.0], "b": [1.0, 2.0]}), path)
    with pytest.raises(InputError, match="damaged"), files.opened(path) as file:
        files._row_group(Short(file), 0, ["a"])


class Short:
    """A file whose footer promises more rows than there are."""

    def __init__(self, file):
        self.metadata = self
        self.num_rows = 3
        self.read_row_group = file.read_row_group

    def row_group(self, _):
        return self
