"""The output folder of a sweep: tables, provenance, atomic files, and every folder that is refused."""

import itertools
import json
import os
from dataclasses import replace

import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from stridemap.errors import InputError
from stridemap.quantities import MEASURED, QUANTITIES
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.model.loading import load
from stridemap.sweeps.config import canonical_json, parse_config
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.provenance import DECIDING
from stridemap.sweeps.special_tables import special_table_of
from stridemap.sweeps.store import Store, read_cells, read_orbits, read_provenance
from stridemap.sweeps.tables import cell_schema, cell_table, orbit_schema, orbit_table

MODEL = load("wobbling")
CONFIG = parse_config({"model": "wobbling", "grid": {"k": [1.0, 2.0, 3.0], "omega": [2.0, 3.0]}})
OTHER = parse_config({"model": "wobbling", "grid": {"k": [1.0, 2.5, 3.0], "omega": [2.0, 3.0]}})
GRID = Grid.from_mapping(CONFIG.grid)
POINTS = GRID.points(MODEL, CONFIG.params)
PROVENANCE = {
    "format": 2, "parts_format": 1, "measures": ["cot"], "model_hash": "ab12", "versions": {"numpy": "2.4.6"},
    "arithmetic": "exact", "tile_cells": 160, "compiler": "cc 1.0", "commit": None,
}  # fmt: skip


CELL, BRANCH = np.array([0, 0, 2, 5]), np.array([3, 0, 3, 1])


def make_orbits(cells=CELL, periods=(1.2, 0.9, 1.1, 1.3)):
    """Orbits each of whose entries is a number that tells where it came from; the third lacks two."""
    n = len(cells)
    columns = dict(zip(MODEL.spec.names, POINTS[cells].T, strict=True))
    columns |= {"status": ["converged"] * n, "period": periods}
    columns |= {name: np.full(n, 0.1 * (i + 1)) for i, name in enumerate(MODEL.section)}
    for i, multiplier in enumerate((-0.5 + 0.8j, -0.5 - 0.8j, 0.6 + 0j, 0.2 + 0j, 0j)):
        columns[f"multiplier_{i}_re"] = np.full(n, multiplier.real)
        columns[f"multiplier_{i}_im"] = np.full(n, multiplier.imag)
    for i, name in enumerate(name for name in MEASURED if QUANTITIES[name].type == "float"):
        columns[name] = np.full(n, float(i))
    third = np.arange(n) == 2
    columns["stable"] = ~third
    columns["peaks"] = np.full(n, 3)
    columns["group"] = np.where(third, None, "A")
    columns["x_zero_crossings"] = np.where(third, None, 2)
    return Orbits.from_columns(MODEL, columns)


def make_table():
    return orbit_table(CELL, BRANCH, make_orbits())


NONE = orbit_table(CELL[:0], BRANCH[:0], Orbits.empty(MODEL))


SPECIAL = special_table_of(MODEL, {})


def make_cells(orbits):
    status = ["ok", "failed", "ok", "ok", "ok", "ok"]
    reason = [None, "no start converged", None, None, None, None]
    found, stable = orbits["cell"].to_numpy(), orbits["stable"].fill_null(False).to_numpy()
    of_each = [np.bincount(cell, minlength=6) for cell in (found, found[stable])]
    counts = dict(zip(("orbits", "stable_orbits"), of_each, strict=True))
    return cell_table(MODEL, POINTS, counts, status, reason)


def finished(folder, config=CONFIG, provenance=PROVENANCE):
    store = Store.create(folder, config, provenance)
    orbits = make_table()
    store.finish(orbits, make_cells(orbits), SPECIAL)
    return folder


def content(folder):
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


# Tables


@pytest.mark.quick
def test_columns_bear_the_agreed_names():
    parameters = ["k", "alpha", "omega", "beta", "Kp", "Kd", "S", "gamma", "c"]
    names = orbit_schema(MODEL).names
    assert names[:12] == ["cell", *parameters, "branch", "status"]
    assert names[12:18] == ["theta1", "dtheta1", "dtheta2", "x", "dx", "period"]
    assert names[18:28] == [f"multiplier_{i}_{part}" for i in range(5) for part in ("re", "im")]
    measures = "spectral_radius multiplier_error stable undecided group step_length speed d_max"
    measures += " cop_max work work_positive work_net peak_torque peak_power cot cot_per_speed"
    measures += " min_vertical_force friction clearance peaks x_zero_crossings wobble_amplitude"
    measures += " touchdown_speed impact_friction lift_off_speed trailing_lifts_off residual"
    measures += " state_error integration_error"
    assert names[28:] == measures.split() == list(MEASURED)
    assert cell_schema(MODEL).names == ["cell", *parameters, "orbits", "stable_orbits", "status", "reason"]
    compass = orbit_schema(load("compass")).names
    assert not {"x", "dx", "k", "alpha"} & set(compass)
    assert [name for name in compass if name.startswith("multiplier_") and name.endswith("_im")][
        -1
    ] == "multiplier_2_im"


@pytest.mark.quick
def test_a_row_holds_the_orbit():
    orbits = make_orbits()
    table = make_table()
    assert table.column_names == orbit_schema(MODEL).names
    row = table.to_pylist()[3]
    assert (row["cell"], row["branch"], row["k"], row["status"]) == (5, 1, 3.0, "converged")
    assert (row["multiplier_0_re"], row["multiplier_1_im"], row["dx"]) == (-0.5, -0.8, 0.5)
    orbit = orbits[3]
    for name in MEASURED:
        assert row[name] == getattr(orbit, name), name
        assert type(row[name]) is type(getattr(orbit, name)), name
    assert row["period"] == orbit.period == 1.3


@pytest.mark.quick
def test_a_missing_value_is_refused_where_columns_must_be_full():
    orbits = make_orbits()
    peaks = np.array([3, 3, None, 3], dtype=object)
    with pytest.raises(ValueError, match="peaks has missing"):
        orbit_table(CELL, BRANCH, replace(orbits, measures={**orbits.measures, "peaks": peaks}))


@pytest.mark.quick
def test_a_table_of_cells_begins_at_any_cell():
    cells = make_cells(make_table()).to_pydict()
    assert cells["cell"] == [0, 1, 2, 3, 4, 5]
    assert cells["orbits"] == [2, 0, 1, 0, 0, 1]
    assert cells["stable_orbits"] == [2, 0, 0, 0, 0, 1]
    assert cells["k"] == [1.0, 1.0, 2.0, 2.0, 3.0, 3.0]
    assert cells["reason"][1] == "no start converged"
    none = {"orbits": np.zeros(2, np.int32), "stable_orbits": np.zeros(2, np.int32)}
    two = cell_table(MODEL, POINTS[4:], none, ["empty", "empty"], [None, None], first=4)
    assert two["cell"].to_pylist() == [4, 5]
    assert two.schema == cell_schema(MODEL)
    with pytest.raises(ValueError, match="status has missing"):
        cell_table(MODEL, POINTS[4:], none, [None, None], [None, None])


# Writing and reading


@pytest.mark.quick
def test_tables_come_back_as_written(tmp_path):
    finished(tmp_path / "out")
    assert sorted(os.listdir(tmp_path / "out")) == ["cells.parquet", "orbits.parquet", "special.parquet"]
    orbits = read_orbits(tmp_path / "out")
    assert orbits[["cell", "period"]].to_numpy().tolist() == [[0, 0.9], [0, 1.2], [2, 1.1], [5, 1.3]]
    assert list(orbits.columns) == orbit_schema(MODEL).names
    assert orbits["stable"].dtype == pd.BooleanDtype()
    assert orbits["x_zero_crossings"].dtype == pd.Int64Dtype()
    assert orbits["x_zero_crossings"].isna().tolist() == [False, False, True, False]
    assert orbits["group"].isna().tolist() == [False, False, True, False]
    cells = read_cells(tmp_path / "out")
    assert cells["orbits"].tolist() == [2, 0, 1, 0, 0, 1]
    assert cells["status"][1] == "failed"
    # Other readers see the same, and which columns can be empty.
    schema = pq.read_schema(tmp_path / "out" / "orbits.parquet")
    assert schema.remove_metadata() == orbit_schema(MODEL)
    nullable = ["stable", "group", "x_zero_crossings", "wobble_amplitude"]
    assert [f.name for f in schema if f.nullable] == nullable
    assert len(pd.read_parquet(tmp_path / "out" / "cells.parquet")) == 6


@pytest.mark.quick
def test_a_sweep_without_any_orbit(tmp_path):
    store = Store.create(tmp_path, CONFIG, PROVENANCE)
    none = NONE
    store.finish(none, make_cells(none), SPECIAL)
    assert len(read_orbits(tmp_path)) == 0
    assert read_orbits(tmp_path)["period"].dtype == float
    assert read_cells(tmp_path)["orbits"].sum() == 0


@pytest.mark.quick
def test_provenance_comes_back(tmp_path):
    found = read_provenance(finished(tmp_path))
    assert found["configuration_hash"] == CONFIG.config_hash
    assert canonical_json(found["configuration"]) == CONFIG.canonical()
    assert {name: found[name] for name in PROVENANCE} == PROVENANCE
    raw = pq.read_schema(tmp_path / "orbits.parquet").metadata[b"stridemap"]
    assert raw == canonical_json(found).encode()


@pytest.mark.quick
def test_bytes_do_not_depend_on_how_the_rows_came(tmp_path):
    finished(tmp_path / "a")
    order = np.random.default_rng(1).permutation(len(CELL))
    store = Store.create(tmp_path / "b", CONFIG, dict(reversed(PROVENANCE.items())))
    for number, row in enumerate(order):
        store.write_part(0, number, orbit_table(CELL[[row]], BRANCH[[row]], make_orbits()[[row]]))
    orbits = pa.concat_tables([store.read_part(0, number) for number in range(len(order))])
    store.finish(orbits, make_cells(orbits), SPECIAL)
    assert content(tmp_path / "a") == content(tmp_path / "b")


@pytest.mark.quick
def test_equal_periods_are_ordered_by_the_other_columns(tmp_path):
    two = make_orbits(np.array([0, 0]), (1.0, 1.0))
    two.u[1, 0] = 0.05
    for name, order in (("a", [0, 1]), ("b", [1, 0])):
        orbits = orbit_table(np.array([0, 0]), np.array([0, 0]), two[order])
        Store.create(tmp_path / name, CONFIG, PROVENANCE).finish(orbits, make_cells(orbits), SPECIAL)
        assert read_orbits(tmp_path / name)["theta1"].tolist() == [0.05, 0.1]
    assert content(tmp_path / "a") == content(tmp_path / "b")


@pytest.mark.quick
def test_parts_are_tables_or_columns(tmp_path):
    store = Store.create(tmp_path, CONFIG, PROVENANCE)
    assert not store.has_part(0, 3)
    store.write_part(0, 3, {"cell": np.arange(3), "reason": ["a", None, "b"]})
    assert store.has_part(0, 3)
    assert not store.has_part(3, 0)
    assert store.read_part(0, 3).to_pydict() == {"cell": [0, 1, 2], "reason": ["a", None, "b"]}
    store.write_part(0, 3, pa.table({"cell": [7]}))
    assert store.read_part(0, 3).to_pydict() == {"cell": [7]}
    with pytest.raises(InputError, match=r"cannot read .*round-000001"):
        store.read_part(1, 3)


@pytest.mark.quick
def test_resume_continues_and_knows_when_all_is_done(tmp_path):
    assert not Store.resume(tmp_path / "out", CONFIG, PROVENANCE).finished  # nothing there: the beginning
    Store.create(tmp_path / "out", CONFIG, PROVENANCE).write_part(0, 0, {"cell": [1]})
    store = Store.resume(tmp_path / "out", CONFIG, PROVENANCE)
    assert not store.finished
    assert store.read_part(0, 0).to_pydict() == {"cell": [1]}
    orbits = make_table()
    store.finish(orbits, make_cells(orbits), SPECIAL)
    before = content(tmp_path / "out")
    assert Store.resume(tmp_path / "out", CONFIG, PROVENANCE).finished
    assert content(tmp_path / "out") == before


@pytest.mark.quick
def test_one_table_alone_is_not_finished(tmp_path):
    (finished(tmp_path) / "cells.parquet").unlink()
    assert not Store.resume(tmp_path, CONFIG, PROVENANCE).finished
    with pytest.raises(InputError, match="not finished; continue it with --resume"):
        read_cells(tmp_path)


@pytest.mark.quick
def test_finish_keeps_what_is_not_ours_and_clears_what_is(tmp_path):
    store = Store.create(tmp_path, CONFIG, PROVENANCE)
    store.write_part(0, 0, {"cell": [1]})
    (tmp_path / "parts" / "left-by-a-kill.tmp").write_bytes(b"x")
    (tmp_path / "parts" / "notes.txt").write_text("mine")
    (tmp_path / "readme.txt").write_text("mine")
    orbits = NONE
    store.finish(orbits, make_cells(orbits), SPECIAL)
    names = sorted(path.name for path in tmp_path.rglob("*"))
    assert names == [
        "cells.parquet", "notes.txt", "orbits.parquet", "parts", "readme.txt", "special.parquet"
    ]  # fmt: skip
    assert Store.resume(tmp_path, CONFIG, PROVENANCE).finished


@pytest.mark.quick
def test_a_finished_sweep_is_not_begun_again(tmp_path):
    before = content(finished(tmp_path))
    assert Store.create(tmp_path, CONFIG, PROVENANCE).finished
    assert content(tmp_path) == before
    (tmp_path / "cells.parquet").unlink()
    assert not Store.create(tmp_path, CONFIG, PROVENANCE).finished


@pytest.mark.quick
def test_create_over_a_finished_sweep_keeps_it_until_the_new_one_is_done(tmp_path):
    finished(tmp_path)
    store = Store.create(tmp_path, CONFIG, {**PROVENANCE, "commit": "newer"})
    store.write_part(0, 0, {"cell": [1]})
    assert read_provenance(tmp_path)["commit"] is None
    # Killed between the two tables: parts remain, so this is no finished sweep, and can be continued.
    store._write(tmp_path / "orbits.parquet", NONE)
    with pytest.raises(InputError, match=r'not of one sweep .*commit is "newer" there, null here'):
        read_provenance(tmp_path)
    assert not Store.resume(tmp_path, CONFIG, {**PROVENANCE, "commit": "newer"}).finished
    store.finish(NONE, make_cells(NONE), SPECIAL)
    assert read_provenance(tmp_path)["commit"] == "newer"


# Refused folders: the sentence, and that nothing is touched


def refused(action, folder, *names):
    before = content(folder) if folder.is_dir() else None
    with pytest.raises(InputError) as caught:
        action()
    message = str(caught.value)
    assert "\n" not in message
    for name in names:
        assert name in message
    if before is not None:
        assert content(folder) == before


@pytest.mark.quick
@pytest.mark.parametrize("begin", [Store.create, Store.resume])
def test_output_of_another_configuration_is_refused(tmp_path, begin):
    out = finished(tmp_path / "out", OTHER)
    refused(
        lambda: begin(out, CONFIG, PROVENANCE), out, "orbits.parquet", "another", "grid.k.1 is 2.5", "2.0"
    )
    parts = tmp_path / "parts-only"
    Store.create(parts, OTHER, PROVENANCE).write_part(0, 0, {"cell": [1]})
    refused(
        lambda: begin(parts, CONFIG, PROVENANCE), parts, "round-000000-tile-000000", "another", "grid.k.1"
    )


@pytest.mark.quick
def test_differences_in_shape_are_told(tmp_path):
    Store.create(tmp_path, CONFIG, PROVENANCE).write_part(0, 0, {"cell": [1]})
    fewer = parse_config({"model": "wobbling", "grid": {"k": [1.0], "omega": [2.0, 3.0]}})
    refused(lambda: Store.resume(tmp_path, fewer, PROVENANCE), tmp_path, "grid.k has 3 values there, 1 here")
    compass = parse_config({"model": "compass", "grid": {"omega": [2.0, 3.0]}})
    refused(
        lambda: Store.resume(tmp_path, compass, PROVENANCE), tmp_path, "grid.k is [1.0, 2.0, 3.0] there, null"
    )


@pytest.mark.quick
def test_create_refuses_an_unfinished_sweep(tmp_path):
    Store.create(tmp_path, CONFIG, PROVENANCE).write_part(0, 0, {"cell": [1]})
    refused(
        lambda: Store.create(tmp_path, CONFIG, PROVENANCE), tmp_path, "unfinished", "1 finished", "--resume"
    )


@pytest.mark.quick
@pytest.mark.parametrize("name", DECIDING)
def test_resume_refuses_other_software(tmp_path, name):
    newer = {**PROVENANCE, name: "newer"}
    told = [f'{name} is {json.dumps(PROVENANCE[name])} there, "newer" here', "different software"]
    Store.create(tmp_path / "a", CONFIG, PROVENANCE).write_part(0, 0, {"cell": [1]})
    refused(lambda: Store.resume(tmp_path / "a", CONFIG, newer), tmp_path / "a", "round-000000", *told)
    finished(tmp_path / "b")
    refused(lambda: Store.resume(tmp_path / "b", CONFIG, newer), tmp_path / "b", "orbits.parquet", *told)
    bare = {key: value for key, value in PROVENANCE.items() if key != name}
    told = f"{name} is {json.dumps(PROVENANCE[name])} there, null here"
    refused(lambda: Store.resume(tmp_path / "b", CONFIG, bare), tmp_path / "b", told)


@pytest.mark.quick
def test_resume_says_which_version_differs(tmp_path):
    newer = {**PROVENANCE, "versions": {"numpy": "2.5.0"}}
    told = 'versions.numpy is "2.4.6" there, "2.5.0" here'
    finished(tmp_path)
    refused(lambda: Store.resume(tmp_path, CONFIG, newer), tmp_path, told)


@pytest.mark.quick
def test_resume_accepts_another_commit_and_another_compiler(tmp_path):
    """They change no number: equations, versions, arithmetic, format and tiles decide."""
    other = {**PROVENANCE, "commit": "another", "compiler": "another 1.0", "host_is_never_in_it": True}
    Store.create(tmp_path / "a", CONFIG, PROVENANCE).write_part(0, 0, {"cell": [1]})
    store = Store.resume(tmp_path / "a", CONFIG, other)
    assert not store.finished
    assert store.read_part(0, 0).to_pydict() == {"cell": [1]}
    store.finish(NONE, make_cells(NONE), SPECIAL)
    assert read_provenance(tmp_path / "a")["commit"] == "another"
    assert Store.resume(finished(tmp_path / "b"), CONFIG, other).finished


@pytest.mark.quick
def test_a_part_of_other_software_is_not_read(tmp_path):
    older = Store.create(tmp_path, CONFIG, PROVENANCE)
    newer = Store.create(tmp_path, CONFIG, {**PROVENANCE, "model_hash": "cd34"})
    older.write_part(0, 0, {"cell": [1]})
    refused(lambda: newer.read_part(0, 0), tmp_path, 'model_hash is "ab12" there, "cd34" here')


@pytest.mark.quick
def test_a_file_where_the_folder_should_be(tmp_path):
    path = tmp_path / "file"
    path.write_text("mine")
    for folder in (path, path / "below"):
        for begin in (Store.create, Store.resume):
            refused(lambda f=folder, b=begin: b(f, CONFIG, PROVENANCE), tmp_path, str(folder), "cannot write")


@pytest.mark.quick
def test_a_folder_that_cannot_be_written(tmp_path, monkeypatch):
    monkeypatch.setattr(os, "access", lambda path, mode: False)  # root may write everything
    with pytest.raises(InputError, match=r"cannot write the sweep to .*no permission"):
        Store.create(tmp_path / "out", CONFIG, PROVENANCE)


def damaged(path):
    """Yield one damaged version of the file at a time."""
    whole = path.read_bytes()
    yield b"cell,period\n0,1.2\n"
    for size in range(0, len(whole), 211):
        yield whole[:size]


@pytest.mark.parametrize("name", ["orbits.parquet", "cells.parquet"])
def test_damaged_tables_are_refused(tmp_path, name):
    out = finished(tmp_path / "out")
    reader = read_orbits if name == "orbits.parquet" else read_cells
    for data in damaged(out / name):
        (out / name).write_bytes(data)
        for action in (lambda: Store.create(out, CONFIG, PROVENANCE), lambda: reader(out)):
            refused(action, out, str(out / name), "damaged or is not a Parquet file")


def test_a_flipped_bit_is_refused_or_changes_nothing(tmp_path):
    """In the footer, which has no checksum of its own, and in the pages."""
    out = finished(tmp_path / "out")
    path = out / "cells.parquet"
    whole, sound = path.read_bytes(), read_cells(out)
    footer = len(whole) - 8 - int.from_bytes(whole[-8:-4], "little")
    refusals = 0
    for at in [*range(4, footer, 601), *range(footer, len(whole), 7)]:
        broken = bytearray(whole)
        broken[at] ^= 1 << (at % 8)
        path.write_bytes(broken)
        try:
            pd.testing.assert_frame_equal(read_cells(out), sound)
        except InputError as error:
            assert str(path) in str(error)
            refusals += 1
    assert refusals > (len(whole) - footer) / 14


@pytest.mark.quick
def test_foreign_parquet_files_are_refused(tmp_path):
    for name, metadata in itertools.product(
        ("orbits.parquet", "cells.parquet"),
        (None, {b"stridemap": b"{", b"stridemap.file": b"x"}, {b"stridemap": b"[1]"}),
    ):
        table = pa.table({"cell": [1]}).replace_schema_metadata(metadata)
        out = tmp_path / f"{name}-{metadata}"[:40].replace("/", "")
        out.mkdir(exist_ok=True)
        pq.write_table(table, out / name)
        for begin in (Store.create, Store.resume):
            refused(lambda o=out, b=begin: b(o, CONFIG, PROVENANCE), out, name, "not one that a sweep wrote")


@pytest.mark.quick
def test_a_renamed_file_is_refused(tmp_path):
    out = finished(tmp_path)
    (out / "orbits.parquet").rename(out / "cells.parquet")
    refused(lambda: read_cells(out), out, "cells.parquet", "under this name")


@pytest.mark.quick
def test_readers_say_what_is_missing(tmp_path):
    for reader in (read_orbits, read_cells, read_provenance):
        with pytest.raises(InputError, match=r"there is no \w+\.parquet in .*output folder of a sweep"):
            reader(tmp_path / "nowhere")
    (tmp_path / "orbits.parquet").mkdir()
    refused(lambda: read_orbits(tmp_path), tmp_path, "orbits.parquet")
