"""The output folder of a sweep: tables, provenance, atomic files, and every folder that is refused."""

import itertools
import os
import random
from dataclasses import fields
from enum import StrEnum
from types import SimpleNamespace

import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from stridemap.errors import InputError
from stridemap.solver.cycles.orbit import Orbit
from stridemap.solver.model.loading import load
from stridemap.sweeps.config import canonical_json, parse_config
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.store import Store, read_cells, read_orbits, read_provenance
from stridemap.sweeps.tables import cell_schema, cell_table, orbit_row, orbit_schema, orbit_table

MODEL = load("wobbling")
CONFIG = parse_config({"model": "wobbling", "grid": {"k": [1.0, 2.0, 3.0], "omega": [2.0, 3.0]}})
OTHER = parse_config({"model": "wobbling", "grid": {"k": [1.0, 2.5, 3.0], "omega": [2.0, 3.0]}})
GRID = Grid.from_mapping(CONFIG.grid)
POINTS = GRID.points(MODEL, CONFIG.params)
PROVENANCE = {"model_hash": "ab12", "versions": {"numpy": "2.4.6"}, "flags": ["-O3"], "commit": None}


class Status(StrEnum):
    OK = "ok"
    FALLS = "falls"


def make_orbit(cell, period, group="A", crossings=2, stable=True):
    """Return something that looks like an Orbit, each entry a number that tells where it came from."""
    return SimpleNamespace(
        model="wobbling",
        params=dict(zip((p.name for p in MODEL.parameters), POINTS[cell].tolist(), strict=True)),
        status=Status.OK,
        state=dict(zip(MODEL.section, (0.1, 0.2, 0.3, 0.4, 0.5), strict=True)),
        period=period,
        multipliers=(-0.5 + 0.8j, -0.5 - 0.8j, 0.6 + 0j, 0.2 + 0j, 0j),
        spectral_radius=0.94,
        stable=stable,
        group=group,
        step_length=1.0,
        speed=2.0,
        d_max=3.0,
        work=4.0,
        work_positive=5.0,
        work_net=6.0,
        cot=7.0,
        cot_per_speed=8.0,
        min_vertical_force=9.0,
        friction=10.0,
        clearance=11.0,
        peaks=3,
        x_zero_crossings=crossings,
        residual=1e-13,
        integration_error=1e-12,
    )


def make_rows():
    orbits = [(0, 1.2), (0, 0.9), (2, 1.1), (5, 1.3)]
    rows = [orbit_row(cell, make_orbit(cell, period)) for cell, period in orbits]
    rows[2] = orbit_row(2, make_orbit(2, 1.1, group=None, crossings=None, stable=False))
    return rows


def make_cells(orbits):
    status = ["ok", "failed", "ok", "ok", "ok", "ok"]
    reason = [None, "no start converged", None, None, None, None]
    return cell_table(MODEL, POINTS, orbits, status, reason)


def finished(folder, config=CONFIG, provenance=PROVENANCE):
    store = Store.create(folder, config, provenance)
    orbits = orbit_table(MODEL, make_rows())
    store.finish(orbits, make_cells(orbits))
    return folder


def content(folder):
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


# Tables


def test_columns_bear_the_agreed_names():
    parameters = ["k", "alpha", "omega", "beta", "Kp", "Kd", "S", "gamma"]
    names = orbit_schema(MODEL).names
    assert names[:10] == ["cell", *parameters, "status"]
    assert names[10:16] == ["theta1", "dtheta1", "dtheta2", "x", "dx", "period"]
    assert names[16:26] == [f"multiplier_{i}_{part}" for i in range(5) for part in ("re", "im")]
    measures = "spectral_radius stable group step_length speed d_max work work_positive work_net cot"
    measures += " cot_per_speed min_vertical_force friction clearance peaks x_zero_crossings residual"
    assert names[26:] == [*measures.split(), "integration_error"]
    assert cell_schema(MODEL).names == ["cell", *parameters, "orbits", "stable_orbits", "status", "reason"]
    compass = orbit_schema(load("compass")).names
    assert not {"x", "dx", "k", "alpha"} & set(compass)
    assert [name for name in compass if name.startswith("multiplier_")][-1] == "multiplier_2_im"


def test_a_row_holds_the_orbit():
    row = orbit_row(5, make_orbit(5, 1.3))
    assert list(row) == orbit_schema(MODEL).names
    assert (row["cell"], row["k"], row["omega"], row["status"]) == (5, 3.0, 3.0, "ok")
    assert type(row["status"]) is str
    assert (row["multiplier_0_re"], row["multiplier_1_im"], row["dx"]) == (-0.5, -0.8, 0.5)
    assert (row["work"], row["work_net"], row["cot_per_speed"]) == (4.0, 6.0, 8.0)


def test_columns_and_orbit_have_the_same_measures():
    spread = {"model", "params", "status", "state", "multipliers"}  # columns of their own, or in the metadata
    measures = [field.name for field in fields(Orbit) if field.name not in spread]
    columns = orbit_schema(MODEL).names
    assert [name for name in columns if name in measures] == measures
    assert make_orbit(0, 1.0).__dict__.keys() == {field.name for field in fields(Orbit)}


def test_orbit_table_refuses_rows_that_do_not_fit():
    row = make_rows()[0]
    with pytest.raises(ValueError, match="columns: extra"):
        orbit_table(MODEL, [row, {**row, "extra": 1}])
    with pytest.raises(ValueError, match="columns: period"):
        orbit_table(MODEL, [{name: value for name, value in row.items() if name != "period"}])
    with pytest.raises(ValueError, match="period has missing"):
        orbit_table(MODEL, [{**row, "period": None}])


def test_cell_table_counts_orbits():
    cells = make_cells(orbit_table(MODEL, make_rows())).to_pydict()
    assert cells["cell"] == [0, 1, 2, 3, 4, 5]
    assert cells["orbits"] == [2, 0, 1, 0, 0, 1]
    assert cells["stable_orbits"] == [2, 0, 0, 0, 0, 1]
    assert cells["k"] == [1.0, 1.0, 2.0, 2.0, 3.0, 3.0]
    assert cells["reason"][1] == "no start converged"
    with pytest.raises(ValueError, match="status has missing"):
        cell_table(MODEL, POINTS, orbit_table(MODEL, []), [None] * 6, [None] * 6)


# Writing and reading


def test_tables_come_back_as_written(tmp_path):
    finished(tmp_path / "out")
    assert sorted(os.listdir(tmp_path / "out")) == ["cells.parquet", "orbits.parquet"]
    orbits = read_orbits(tmp_path / "out")
    assert orbits[["cell", "period"]].to_numpy().tolist() == [[0, 0.9], [0, 1.2], [2, 1.1], [5, 1.3]]
    assert list(orbits.columns) == orbit_schema(MODEL).names
    assert orbits["stable"].dtype == bool
    assert orbits["x_zero_crossings"].dtype == pd.Int64Dtype()
    assert orbits["x_zero_crossings"].isna().tolist() == [False, False, True, False]
    assert orbits["group"].isna().tolist() == [False, False, True, False]
    cells = read_cells(tmp_path / "out")
    assert cells["orbits"].tolist() == [2, 0, 1, 0, 0, 1]
    assert cells["status"][1] == "failed"
    # Other readers see the same, and that only three columns can be empty.
    schema = pq.read_schema(tmp_path / "out" / "orbits.parquet")
    assert schema.remove_metadata() == orbit_schema(MODEL)
    assert [field.name for field in schema if field.nullable] == ["group", "x_zero_crossings"]
    assert len(pd.read_parquet(tmp_path / "out" / "cells.parquet")) == 6


def test_a_sweep_without_any_orbit(tmp_path):
    store = Store.create(tmp_path, CONFIG, PROVENANCE)
    none = orbit_table(MODEL, [])
    store.finish(none, make_cells(none))
    assert len(read_orbits(tmp_path)) == 0
    assert read_orbits(tmp_path)["period"].dtype == float
    assert read_cells(tmp_path)["orbits"].sum() == 0


def test_provenance_comes_back(tmp_path):
    found = read_provenance(finished(tmp_path))
    assert found["configuration_hash"] == CONFIG.config_hash
    assert canonical_json(found["configuration"]) == CONFIG.canonical()
    assert {name: found[name] for name in PROVENANCE} == PROVENANCE
    raw = pq.read_schema(tmp_path / "orbits.parquet").metadata[b"stridemap"]
    assert raw == canonical_json(found).encode()


def test_bytes_do_not_depend_on_how_the_rows_came(tmp_path):
    finished(tmp_path / "a")
    rows = make_rows()
    random.Random(1).shuffle(rows)
    store = Store.create(tmp_path / "b", CONFIG, dict(reversed(PROVENANCE.items())))
    for number, row in enumerate(rows):
        store.write_part(0, number, orbit_table(MODEL, [row]))
    orbits = pa.concat_tables([store.read_part(0, number) for number in range(len(rows))])
    store.finish(orbits, make_cells(orbits))
    assert content(tmp_path / "a") == content(tmp_path / "b")


def test_equal_periods_are_ordered_by_the_other_columns(tmp_path):
    rows = [orbit_row(0, make_orbit(0, 1.0)), orbit_row(0, make_orbit(0, 1.0))]
    rows[1]["theta1"] = 0.05
    for name, order in (("a", rows), ("b", rows[::-1])):
        orbits = orbit_table(MODEL, order)
        Store.create(tmp_path / name, CONFIG, PROVENANCE).finish(orbits, make_cells(orbits))
        assert read_orbits(tmp_path / name)["theta1"].tolist() == [0.05, 0.1]
    assert content(tmp_path / "a") == content(tmp_path / "b")


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


def test_resume_continues_and_knows_when_all_is_done(tmp_path):
    assert not Store.resume(tmp_path / "out", CONFIG, PROVENANCE).finished  # nothing there: the beginning
    Store.create(tmp_path / "out", CONFIG, PROVENANCE).write_part(0, 0, {"cell": [1]})
    store = Store.resume(tmp_path / "out", CONFIG, PROVENANCE)
    assert not store.finished
    assert store.read_part(0, 0).to_pydict() == {"cell": [1]}
    orbits = orbit_table(MODEL, make_rows())
    store.finish(orbits, make_cells(orbits))
    before = content(tmp_path / "out")
    assert Store.resume(tmp_path / "out", CONFIG, PROVENANCE).finished
    assert content(tmp_path / "out") == before


def test_one_table_alone_is_not_finished(tmp_path):
    (finished(tmp_path) / "cells.parquet").unlink()
    assert not Store.resume(tmp_path, CONFIG, PROVENANCE).finished
    with pytest.raises(InputError, match="not finished; continue it with --resume"):
        read_cells(tmp_path)


def test_finish_keeps_what_is_not_ours_and_clears_what_is(tmp_path):
    store = Store.create(tmp_path, CONFIG, PROVENANCE)
    store.write_part(0, 0, {"cell": [1]})
    (tmp_path / "parts" / "left-by-a-kill.tmp").write_bytes(b"x")
    (tmp_path / "parts" / "notes.txt").write_text("mine")
    (tmp_path / "readme.txt").write_text("mine")
    orbits = orbit_table(MODEL, [])
    store.finish(orbits, make_cells(orbits))
    names = sorted(path.name for path in tmp_path.rglob("*"))
    assert names == ["cells.parquet", "notes.txt", "orbits.parquet", "parts", "readme.txt"]
    assert Store.resume(tmp_path, CONFIG, PROVENANCE).finished


def test_create_over_a_finished_sweep_keeps_it_until_the_new_one_is_done(tmp_path):
    finished(tmp_path)
    store = Store.create(tmp_path, CONFIG, {**PROVENANCE, "commit": "newer"})
    store.write_part(0, 0, {"cell": [1]})
    assert read_provenance(tmp_path)["commit"] is None
    # Killed between the two tables: parts remain, so this is no finished sweep, and can be continued.
    store._write(tmp_path / "orbits.parquet", orbit_table(MODEL, []))
    with pytest.raises(InputError, match=r'not of one sweep .*commit is "newer" there, null here'):
        read_provenance(tmp_path)
    assert not Store.resume(tmp_path, CONFIG, {**PROVENANCE, "commit": "newer"}).finished
    store.finish(orbit_table(MODEL, []), make_cells(orbit_table(MODEL, [])))
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


def test_differences_in_shape_are_told(tmp_path):
    Store.create(tmp_path, CONFIG, PROVENANCE).write_part(0, 0, {"cell": [1]})
    fewer = parse_config({"model": "wobbling", "grid": {"k": [1.0], "omega": [2.0, 3.0]}})
    refused(lambda: Store.resume(tmp_path, fewer, PROVENANCE), tmp_path, "grid.k has 3 values there, 1 here")
    compass = parse_config({"model": "compass", "grid": {"omega": [2.0, 3.0]}})
    refused(
        lambda: Store.resume(tmp_path, compass, PROVENANCE), tmp_path, "grid.k is [1.0, 2.0, 3.0] there, null"
    )


def test_create_refuses_an_unfinished_sweep(tmp_path):
    Store.create(tmp_path, CONFIG, PROVENANCE).write_part(0, 0, {"cell": [1]})
    refused(
        lambda: Store.create(tmp_path, CONFIG, PROVENANCE), tmp_path, "unfinished", "1 finished", "--resume"
    )


def test_resume_refuses_other_software(tmp_path):
    newer = {**PROVENANCE, "versions": {"numpy": "2.5.0"}}
    told = ['versions.numpy is "2.4.6" there, "2.5.0" here', "other software"]
    Store.create(tmp_path / "a", CONFIG, PROVENANCE).write_part(0, 0, {"cell": [1]})
    refused(lambda: Store.resume(tmp_path / "a", CONFIG, newer), tmp_path / "a", "round-000000", *told)
    finished(tmp_path / "b")
    refused(lambda: Store.resume(tmp_path / "b", CONFIG, newer), tmp_path / "b", "orbits.parquet", *told)
    bare = {name: value for name, value in PROVENANCE.items() if name != "versions"}
    told = 'versions is {"numpy": "2.4.6"} there, null here'
    refused(lambda: Store.resume(tmp_path / "b", CONFIG, bare), tmp_path / "b", told)


def test_a_part_of_other_software_is_not_read(tmp_path):
    older = Store.create(tmp_path, CONFIG, PROVENANCE)
    newer = Store.create(tmp_path, CONFIG, {**PROVENANCE, "model_hash": "cd34"})
    older.write_part(0, 0, {"cell": [1]})
    refused(lambda: newer.read_part(0, 0), tmp_path, 'model_hash is "ab12" there, "cd34" here')


def test_a_file_where_the_folder_should_be(tmp_path):
    path = tmp_path / "file"
    path.write_text("mine")
    for folder in (path, path / "below"):
        for begin in (Store.create, Store.resume):
            refused(lambda f=folder, b=begin: b(f, CONFIG, PROVENANCE), tmp_path, str(folder), "cannot write")


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
            refused(action, out, str(out / name), "damaged or is no Parquet file")


def test_a_flipped_bit_is_refused_or_changes_nothing(tmp_path):
    """In the footer, which has no checksum of its own, and in the pages."""
    out = finished(tmp_path / "out")
    path = out / "cells.parquet"
    whole, sound = path.read_bytes(), read_cells(out)
    footer = len(whole) - 8 - int.from_bytes(whole[-8:-4], "little")
    refusals = 0
    for at in [*range(4, footer, 301), *range(footer, len(whole), 3)]:
        broken = bytearray(whole)
        broken[at] ^= 1 << (at % 8)
        path.write_bytes(broken)
        try:
            pd.testing.assert_frame_equal(read_cells(out), sound)
        except InputError as error:
            assert str(path) in str(error)
            refusals += 1
    assert refusals > (len(whole) - footer) / 6


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


def test_a_renamed_file_is_refused(tmp_path):
    out = finished(tmp_path)
    (out / "orbits.parquet").rename(out / "cells.parquet")
    refused(lambda: read_cells(out), out, "cells.parquet", "under this name")


def test_readers_say_what_is_missing(tmp_path):
    for reader in (read_orbits, read_cells, read_provenance):
        with pytest.raises(InputError, match=r"there is no \w+\.parquet in .*output folder of a sweep"):
            reader(tmp_path / "nowhere")
    (tmp_path / "orbits.parquet").mkdir()
    refused(lambda: read_orbits(tmp_path), tmp_path, "orbits.parquet")
