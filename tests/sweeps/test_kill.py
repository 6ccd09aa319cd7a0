"""Parts of a sweep after damage, failures and kills: what is on the disk is whole or is refused."""

import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

from stridemap.errors import InputError, StorageError
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.store import Store

CONFIG = parse_config({"model": "wobbling", "grid": {"k": [1.0, 2.0, 3.0], "omega": [2.0, 3.0]}})
PROVENANCE = {"commit": None}


def content(folder):
    return {path.name: path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_damaged_parts_are_refused_and_kept(tmp_path):
    store = Store.create(tmp_path, CONFIG, PROVENANCE)
    store.write_part(2, 7, {"cell": np.arange(300)})
    part = tmp_path / "parts" / "round-000002-tile-000007.parquet"
    whole = part.read_bytes()
    for size in range(0, len(whole), 97):
        part.write_bytes(whole[:size])
        for action in (lambda: Store.resume(tmp_path, CONFIG, PROVENANCE), lambda: store.read_part(2, 7)):
            with pytest.raises(
                InputError, match=r"round-000002-tile-000007\.parquet is damaged or is not a Parquet"
            ):
                action()
        assert part.read_bytes() == whole[:size]


@pytest.mark.quick
def test_a_flipped_bit_in_the_data_is_noticed(tmp_path):
    store = Store.create(tmp_path, CONFIG, PROVENANCE)
    store.write_part(0, 0, {"cell": np.random.default_rng(0).integers(0, 2**60, 1000)})
    part = tmp_path / "parts" / "round-000000-tile-000000.parquet"
    data = bytearray(part.read_bytes())
    data[4000] ^= 1
    part.write_bytes(bytes(data))
    with pytest.raises(InputError, match="damaged"):
        store.read_part(0, 0)


@pytest.mark.quick
@pytest.mark.parametrize(
    "step", ["os.fsync", "pathlib.Path.replace", "pyarrow.parquet.ParquetWriter.write_table"]
)
def test_a_failure_while_writing_keeps_the_old_file(tmp_path, monkeypatch, step):
    store = Store.create(tmp_path, CONFIG, PROVENANCE)
    store.write_part(0, 0, {"cell": [1]})
    before = content(tmp_path)

    def full(*args, **kwargs):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(step, full)
        with pytest.raises(StorageError, match=r"cannot write .*round-000000.*No space left.*--resume"):
            store.write_part(0, 0, {"cell": [2]})
    assert content(tmp_path) == before


WRITER = """
import itertools, sys
import pandas  # Arrow loads it with the first table, and that is to be over when the clock starts
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.store import Store
config = parse_config({"model": "wobbling", "grid": {"k": [1.0, 2.0, 3.0], "omega": [2.0, 3.0]}})
store = Store.resume(sys.argv[1], config, {"commit": None})
print("ready", flush=True)
for turn in itertools.count():
    store.write_part(0, turn % 3, {"turn": [turn] * 20000})
"""


@pytest.mark.skipif(os.name != "posix", reason="SIGKILL is POSIX")
def test_a_killed_writer_leaves_whole_files(tmp_path):
    for delay in (0.0, 0.03, 0.1, 0.25):
        with subprocess.Popen(
            [sys.executable, "-c", WRITER, str(tmp_path)], stdout=subprocess.PIPE, text=True
        ) as writer:
            assert writer.stdout.readline() == "ready\n"
            time.sleep(delay)
            writer.send_signal(signal.SIGKILL)
        store = Store.resume(tmp_path, CONFIG, PROVENANCE)
        for tile in filter(lambda tile: store.has_part(0, tile), range(3)):
            turns = store.read_part(0, tile)["turn"].to_pylist()
            assert len(turns) == 20000
            assert len(set(turns)) == 1
            assert turns[0] % 3 == tile
    assert list((tmp_path / "parts").glob("round-*"))
