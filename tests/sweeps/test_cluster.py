"""A sweep on a Dask cluster: the same bytes, also when a worker dies, and one sentence for what fails."""

import functools
import logging
import os
import re
import shlex
import signal
from concurrent.futures import CancelledError
from importlib.util import find_spec
from pathlib import Path

import pytest
import typer

import stridemap
from stridemap.cli.app import app
from stridemap.errors import InputError, WorkerError
from stridemap.sweeps import cluster, run, software, tasks
from stridemap.sweeps.config import load_config, parse_config
from stridemap.sweeps.failures import explained
from stridemap.sweeps.grid import Grid, tile_size, tiles
from tests.oracles.sweeping import Inline, parts, tables

sweep = functools.partial(run.sweep, tile_cells=1)

CONFIG = parse_config(
    {
        "model": "compass",
        "grid": {"omega": [2.4, 2.6, 2.8, 3.0, 3.2, 3.4]},
        "search": {"starts": 16, "subgrid": 1},
    }
)
"""Six pieces in the first round, and more in the next."""

needs_dask = pytest.mark.skipif(
    find_spec("distributed") is None, reason="distributed is not installed (the extra `dask`)"
)


def local_cluster(folder, **words):
    """A cluster that listens on the loopback device only, without a dashboard."""
    from distributed import LocalCluster

    return LocalCluster(
        threads_per_worker=1, host="127.0.0.1", protocol="tcp", local_directory=str(folder),
        dashboard_address="127.0.0.1:0", worker_dashboard_address="127.0.0.1:0",
        scheduler_kwargs={"dashboard": False}, silence_logs=logging.CRITICAL, **words,
    )  # fmt: skip


@pytest.fixture(scope="module")
def alone(tmp_path_factory):
    """Tables of the sweep in one process."""
    folder = tmp_path_factory.mktemp("alone") / "out"
    sweep(CONFIG, folder, executor=Inline())
    return tables(folder)


@pytest.fixture(scope="module")
def two_workers(tmp_path_factory):
    """A cluster of two worker processes on this machine; one that dies is replaced."""
    with local_cluster(tmp_path_factory.mktemp("dask"), n_workers=2) as found:
        yield found


def kill_a_busy_worker(client):
    """Kill a worker process that has tiles to compute."""
    busy = max(client.processing().items(), key=lambda pair: len(pair[1]))
    assert busy[1]
    os.kill(client.run(os.getpid, workers=[busy[0]])[busy[0]], signal.SIGKILL)


# -- the same bytes ------------------------------------------------------------------------------------------


@needs_dask
@pytest.mark.skipif(os.name != "posix", reason="SIGKILL is POSIX")
def test_a_killed_worker_loses_nothing(two_workers, alone, tmp_path):
    from distributed import Client

    before = set(two_workers.scheduler_info["workers"])
    seen = []
    with Client(two_workers.scheduler_address, set_as_default=False) as client:

        def watch(at):
            seen.append(at)
            if len(seen) == 3:  # two tiles of the first round are done
                kill_a_busy_worker(client)

        sweep(CONFIG, tmp_path / "out", dask=two_workers.scheduler_address, progress=watch)
        assert set(client.scheduler_info()["workers"]) != before
    assert seen[2].done == 2 < seen[2].total
    assert tables(tmp_path / "out") == alone


@needs_dask
def test_tiles_that_kill_their_workers_end_the_sweep_and_resume_goes_on(two_workers, alone, tmp_path):
    from distributed import Client

    address, scheduler = two_workers.scheduler_address, two_workers.scheduler
    allowed, scheduler.allowed_failures = scheduler.allowed_failures, 0
    with Client(address, set_as_default=False) as client:

        def kill(at):
            if at.done == 2:
                kill_a_busy_worker(client)

        try:
            with pytest.raises(WorkerError, match="a worker died at a tile .*--resume") as caught:
                sweep(CONFIG, tmp_path / "out", dask=address, progress=kill)
        finally:
            scheduler.allowed_failures = allowed
    assert "\n" not in str(caught.value)
    assert len(parts(tmp_path / "out")) >= 2
    sweep(CONFIG, tmp_path / "out", executor=Inline(), resume=True)
    assert tables(tmp_path / "out") == alone


@needs_dask
def test_the_command_takes_an_address_and_a_scheduler_file(two_workers, run, finished, tmp_path):
    for given in (two_workers.scheduler_address, tmp_path / "scheduler.json"):
        (tmp_path / "scheduler.json").write_text(f'{{"address": "{two_workers.scheduler_address}"}}')
        out = tmp_path / f"out-{given == two_workers.scheduler_address}"
        status, said, _ = run("sweep", finished / "small.toml", "--out", out, "--dask", given)
        assert (status, said.startswith("sweep finished: ")) == (0, True)
        assert tables(out) == tables(finished / "out")


@needs_dask
def test_an_executor_of_a_client_gives_the_same_bytes(two_workers, finished, tmp_path):
    from distributed import Client

    with Client(two_workers.scheduler_address, set_as_default=False) as client:
        run.sweep(finished / "small.toml", tmp_path / "out", executor=client.get_executor())
        assert client.submit(int, "1").result() == 1  # it is still open
    assert tables(tmp_path / "out") == tables(finished / "out")


# -- what fails ----------------------------------------------------------------------------------------------


@needs_dask
def test_a_scheduler_that_ends_is_one_sentence(tmp_path):
    with local_cluster(tmp_path, n_workers=1, processes=False) as found:

        def end(at):
            if at.done == 1:
                found.close()

        with pytest.raises(WorkerError, match="the connection to the workers was lost.*--resume"):
            sweep(CONFIG, tmp_path / "out", dask=found.scheduler_address, progress=end)
    assert parts(tmp_path / "out")


@needs_dask
@pytest.mark.parametrize(
    "given",
    ["", "foo", "127.0.0.1", "tcp://127.0.0.1", "http://h:8786", "tcp://a b:1", "h:0", "h:65536", "x\ny:1"],
)
def test_what_is_not_an_address_is_refused(refused, finished, tmp_path, given):
    refused(
        ["sweep", finished / "small.toml", "--out", tmp_path / "out", "--dask", given],
        ascii(given) if "\n" in given else repr(given), "is not the address of a Dask scheduler", "tcp://",
    )  # fmt: skip
    assert not (tmp_path / "out").exists()


@needs_dask
@pytest.mark.parametrize("text", ["", "{", "[]", '{"id": 1}', "[" * 5000])
def test_what_is_not_a_scheduler_file_is_refused(refused, finished, tmp_path, text):
    (tmp_path / "file.json").write_text(text)
    refused(
        ["sweep", finished / "small.toml", "--out", tmp_path / "out", "--dask", tmp_path / "file.json"],
        "file.json' is not the scheduler file",
    )


@needs_dask
def test_an_address_where_nobody_answers_is_refused_soon(refused, finished, tmp_path, monkeypatch):
    monkeypatch.setattr(cluster, "TIMEOUT", 0.5)
    refused(
        ["sweep", finished / "small.toml", "--out", tmp_path / "out", "--dask", "tcp://127.0.0.1:1"],
        "no Dask scheduler answers at tcp://127.0.0.1:1 (tried for 0.5 s)",
    )


def test_two_kinds_of_workers_are_refused(refused, finished, tmp_path):
    words = ["sweep", finished / "small.toml", "--out", tmp_path / "out", "--dask", "tcp://127.0.0.1:1"]
    refused([*words, "--workers", "2"], "--dask and --workers cannot be given together")
    for name, more in {"workers": {"workers": 1}, "executor": {"executor": Inline()}}.items():
        with pytest.raises(InputError, match=f"dask and {name} cannot be given together"):
            sweep(finished / "small.toml", tmp_path / "out", dask="tcp://127.0.0.1:1", **more)


def test_without_dask_the_package_is_named(refused, finished, tmp_path, monkeypatch):
    monkeypatch.setattr(cluster, "find_spec", lambda name: None)
    words = ["sweep", finished / "small.toml", "--out", tmp_path / "out", "--dask", "tcp://127.0.0.1:1"]
    refused(words, "pip install distributed")


def test_a_worker_that_lacks_stridemap_and_a_lost_connection_are_sentences():
    for error, words in {
        ModuleNotFoundError("No module named 'stridemap'"): "cannot load stridemap",
        CancelledError(): "the connection to the workers was lost",
    }.items():
        assert words in str(explained(error))
        assert "--resume" in str(explained(error))
    assert explained(ValueError("ours")) is None
    assert explained(KeyboardInterrupt()) is None


# -- the same software ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "value"), [("numpy", "1.0"), (software.SOURCE, "0123456789ab")])
def test_a_worker_with_other_software_refuses_its_task(finished, tmp_path, monkeypatch, name, value):
    here = software.software()
    monkeypatch.setattr(tasks, "software", lambda: {**here, name: value})
    with pytest.raises(
        stridemap.WorkerError,
        match=f"the worker on .* other software than this program \\({name} {here[name]}, not {value}\\)",
    ):
        sweep(finished / "small.toml", tmp_path / "out", executor=Inline())


class Asked:
    """What a client is asked; a first worker comes after two questions."""

    def __init__(self, worker):
        own = {"python": "3.11.7.final.0", **dict.fromkeys(software.PACKAGES, "1.0")}
        self.versions = {
            "client": {"packages": own},
            "scheduler": {"packages": own},
            "workers": {"tcp://a:1": {"packages": own}, "tcp://b:2": {"packages": {**own, **worker}}},
        }
        self.waits = 2

    def nthreads(self):
        self.waits -= 1
        return {} if self.waits >= 0 else {"tcp://a:1": 1}

    def get_versions(self, packages):
        return self.versions


@pytest.mark.parametrize(
    ("worker", "words"),
    [
        ({"stridemap": None}, "stridemap missing, not 1.0"),
        ({"scipy": "1.1", "python": "3.12.1.final.0"}, "python 3.12.1, not 3.11.7 and scipy 1.1, not 1.0"),
    ],
)
def test_workers_with_other_versions_are_refused_before_the_sweep(worker, words):
    cluster._check_versions(Asked({}))
    with pytest.raises(WorkerError, match="the worker tcp://b:2 runs other software") as caught:
        cluster._check_versions(Asked(worker))
    assert words in str(caught.value)


def test_a_cluster_without_workers_is_waited_for():
    client = Asked({})
    cluster._wait_for_a_worker(client, "tcp://a:1")
    assert client.waits == -1


# -- what the page says --------------------------------------------------------------------------------------


def test_the_scripts_of_the_page_give_options_that_exist():
    page = (Path(__file__).resolve().parents[2] / "docs" / "many-machines.md").read_text("utf-8")
    command = typer.main.get_command(app).commands["sweep"]
    lines = re.findall(r"^(?:exec )?stridemap sweep (.+?)(?: +#.*)?$", page, re.MULTILINE)
    assert len(lines) == 3
    for line in lines:
        context = command.make_context("sweep", shlex.split(line.replace("$SLURM_CPUS_PER_TASK", "64")))
        assert str(context.params["config"]) == "my.toml"
        assert context.params["workers"] == 64 or context.params["dask"]


def test_the_page_says_into_how_many_tiles_the_default_grid_is_cut():
    page = (Path(__file__).resolve().parents[2] / "docs" / "many-machines.md").read_text("utf-8")
    grid = Grid.from_mapping(load_config(Path(run.__file__).parent / "paper.toml").grid)
    assert f"{grid.n_cells:,} cells into {len(tiles(grid, tile_size(grid)))}\nonly" in page
