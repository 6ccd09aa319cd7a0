"""Running a sweep: the same bytes whoever computes it, the cycles that one point gives, failures as rows."""

import functools
import pickle
import socket
import subprocess
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from importlib.metadata import version
from operator import itemgetter

import numpy as np
import pandas as pd
import pyarrow.parquet as pq
import pytest

import stridemap
from stridemap.errors import CompilerError, InputError
from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.backends.lanes import Lanes
from stridemap.solver.backends.scalar import ScalarC
from stridemap.solver.backends.selection import load_kernels
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.files import GENERATED
from stridemap.solver.model.loading import load
from stridemap.sweeps import run
from stridemap.sweeps.config import canonical_json, parse_config
from stridemap.sweeps.connections import connect
from stridemap.sweeps.families import smallest_of_family
from stridemap.sweeps.solutions import Links
from stridemap.sweeps.store import read_cells, read_orbits, read_provenance
from tests.oracles.reference import REFERENCE
from tests.oracles.shared import once
from tests.oracles.sweeping import ALPHA, CONFIG, Inline, K, Remembering, content, tables

sweep = functools.partial(run.sweep, tile_cells=2)
BASE = {"model": "wobbling", "grid": {"k": K, "alpha": ALPHA}}


# -- the same bytes ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("workers", [1, 2])
def test_any_number_of_processes_gives_the_same_bytes(reference, tmp_path, workers):
    summary = sweep(CONFIG, tmp_path / "out", workers=workers)
    assert tables(tmp_path / "out") == tables(reference[0])
    assert (summary.cells, summary.orbits) == (8, reference[1].orbits)


def test_threads_give_the_same_bytes(reference, tmp_path):
    with ThreadPoolExecutor(3) as executor:
        sweep(CONFIG, tmp_path, executor=executor)
        assert executor.submit(int, "1").result() == 1  # it is not shut down
    assert tables(tmp_path) == tables(reference[0])


@pytest.mark.quick
def test_any_order_of_completion_gives_the_same_bytes(reference, tmp_path, monkeypatch):
    monkeypatch.setattr(run, "wait", lambda futures, **_: ({futures[-1]}, set(futures[:-1])))
    sweep(CONFIG, tmp_path, executor=Remembering())
    assert tables(tmp_path) == tables(reference[0])


def test_a_file_and_a_configuration_are_the_same(reference, tmp_path):
    text = f'model = "wobbling"\n[grid]\nk = {list(K)}\nalpha = {list(ALPHA)}\n[search]\n'
    (tmp_path / "my.toml").write_text(text + "starts = 8\nsubgrid = 2\n[continuation]\nmax_steps = 10\n")
    sweep(str(tmp_path / "my.toml"), str(tmp_path / "out"), executor=Remembering())
    assert tables(tmp_path / "out") == tables(reference[0])


class Keeping(Remembering):
    """Keeps what it was given, what came of it, and whether that was to follow links."""

    def __init__(self):
        super().__init__()
        self.kept = []

    def submit(self, function, task):
        done = super().submit(function, task)
        self.kept.append((task, done.result(), function is connect))
        return done


def test_branches_are_followed_to_each_other_when_nothing_new_appears_and_if_they_are_not_one_yet(
    tmp_path, monkeypatch
):
    followed, joined = 0, 0
    for links in (1000, 2):
        monkeypatch.setattr(run, "LINKS", links)
        executor = Keeping()
        sweep(CONFIG, tmp_path / str(links), executor=executor, tile_cells=3)
        assert tables(tmp_path / str(links)) == tables(tmp_path / "1000")
        results = [result for _, result, _ in executor.kept]
        every = Links.concatenate([result.links for result in results], 6)
        for task, result, _ in filter(itemgetter(2), executor.kept):
            assert 1 <= len(task.incoming) <= links
            assert not len(result.links) and not len(result.seen)
            known = np.concatenate([one.joins for one in results if one.round < task.round])
            for u, branch in zip(task.incoming.u, task.incoming.branch, strict=True):
                (row,) = np.flatnonzero((every.u == u).all(axis=1) & (every.branch == branch))[:1]
                one, other = smallest_of_family(np.array([branch, every.other[row]]), known)
                assert one != other
                followed += 1
            joined += len(result.joins)
    assert followed > 2
    assert joined > 0


# -- what is in the tables -----------------------------------------------------------------------------------


def assert_row_is_orbit(row, orbit):
    """Every column of a row of orbits is what the search at that point gives."""
    names = list(orbit.state)
    state = [row[name] for name in names]
    np.testing.assert_allclose(state, list(orbit.state.values()), atol=1e-9, rtol=0)
    multipliers = [complex(row[f"multiplier_{i}_re"], row[f"multiplier_{i}_im"]) for i in range(len(names))]
    # Of a complex pair either may come first, and the zero may be anything below rounding.
    np.testing.assert_allclose(np.abs(multipliers), np.abs(orbit.multipliers), atol=1e-8)
    np.testing.assert_allclose(np.sort(np.imag(multipliers)), np.sort(np.imag(orbit.multipliers)), atol=1e-8)
    for name, value in orbit.to_dict().items():
        if name in (
            "state",
            "period_n",
            "multipliers",
            "residual",
            "integration_error",
            "state_error",
            "multiplier_error",
        ):
            continue
        if isinstance(value, float):
            assert row[name] == pytest.approx(value, abs=1e-8, rel=1e-8), name
        elif value is None:
            assert pd.isna(row[name]), name
        else:
            assert row[name] == value, name
    assert row["residual"] < 1e-11
    assert row["integration_error"] < 1e-9 or row["status"] == "inaccurate"


def matches(rows, orbit):
    """Rows of one cell that are an orbit."""
    names = list(orbit.state)
    near = (rows["period"] - orbit.period).abs() < 1e-6
    for name in names:
        near &= (rows[name] - orbit.state[name]).abs() < 1e-6
    return rows[near]


@pytest.fixture(scope="session")
def thorough(common):
    """A sweep with many starts in every cell."""
    config = parse_config({**BASE, "search": {"starts": 512, "subgrid": 1}, "special_points": False})
    once(common / "thorough", lambda folder: sweep(config, folder / "out", executor=Inline()))
    return common / "thorough" / "out"


def test_every_orbit_of_a_point_is_a_row_of_its_cell(thorough):
    rows = read_orbits(thorough)
    agreeing = 0
    for cell, (k, alpha) in enumerate((k, alpha) for k in K for alpha in ALPHA):
        mine = rows[rows["cell"] == cell]
        assert (mine[["k", "alpha", "omega"]] == [k, alpha, 3.0]).all(axis=None)
        orbits = stridemap.find_orbits("wobbling", k=k, alpha=alpha)
        for orbit in orbits:
            (row,) = matches(mine, orbit).to_dict("records")
            assert_row_is_orbit(row, orbit)
        agreeing += len(orbits) == len(mine)
    # Elsewhere a neighbour led to one more than the starts at the point found.
    assert agreeing >= 6


@pytest.mark.quick
def test_the_reference_orbits_are_rows(thorough):
    rows = read_orbits(thorough)
    fixed = {**load("wobbling").preset, "alpha": 0.25}
    entries = [
        e for e in REFERENCE if e["model"] == "wobbling" and {**e["params"], "k": 0} == {**fixed, "k": 0}
    ]
    assert sorted(e["params"]["k"] for e in entries if e["params"]["k"] in K) == [0.5, 6.0, 6.0, 22.5]
    for entry in entries:
        if entry["params"]["k"] in K:
            here = rows[(rows["k"] == entry["params"]["k"]) & (rows["alpha"] == 0.25)]
            wanted = [*entry["state"].values(), entry["period"]]
            differences = here[[*entry["state"], "period"]].sub(wanted).abs().max(axis=1)
            assert (differences < 1e-10).sum() == 1


@pytest.mark.quick
def test_few_starts_and_neighbours_find_the_same(reference, thorough):
    """Eight starts in half of the cells, and what neighbours hand on."""
    few, many = read_orbits(reference[0]), read_orbits(thorough)
    assert set(few["cell"]) == set(range(8))
    for row in few.itertuples():
        near = many[(many["cell"] == row.cell) & ((many["period"] - row.period).abs() < 1e-9)]
        assert len(near) >= 1
    assert len(few) >= 0.8 * len(many)


@pytest.mark.quick
def test_neighbours_hand_cycles_on_across_tiles(tmp_path):
    """Starts at both ends only, and a tile per cell."""
    grid = {"k": [22.0, 22.2, 22.4, 22.6, 22.8, 23.0]}
    search = {"starts": 32, "subgrid": 5}
    executor = Inline()
    config = parse_config({"model": "wobbling", "grid": grid, "search": search})
    sweep(config, tmp_path, executor=executor, tile_cells=1)
    assert {task.tile for task in executor.tasks if len(task.seeds)} == {0, 5}
    assert (read_cells(tmp_path)["orbits"] >= 1).all()


def test_rows_are_ordered_and_distinct(thorough):
    rows = read_orbits(thorough)
    assert rows[["cell", "period"]].equals(rows[["cell", "period"]].sort_values(["cell", "period"]))
    for _, cell in rows.groupby("cell"):
        u = cell[["theta1", "dtheta1", "dtheta2", "x", "dx", "period"]].to_numpy()
        apart = np.abs(u[:, None] - u).max(axis=2) + np.eye(len(u))
        assert (apart > 1e-6).all()


@pytest.mark.quick
def test_cells_count_the_orbits_and_summary_adds_up(reference):
    folder, summary, _, _ = reference
    orbits, cells = read_orbits(folder), read_cells(folder)
    assert cells["cell"].tolist() == list(range(8))
    assert cells[["k", "alpha"]].to_numpy().tolist() == [[k, alpha] for k in K for alpha in ALPHA]
    counted = orbits.groupby("cell").size().reindex(range(8), fill_value=0)
    assert cells["orbits"].tolist() == counted.tolist()
    stable = orbits[orbits["spectral_radius"] < 1].groupby("cell").size().reindex(range(8), fill_value=0)
    assert cells["stable_orbits"].tolist() == stable.tolist()
    assert (cells["status"] == "found").equals(cells["orbits"] > 0)
    assert cells.loc[cells["status"] == "found", "reason"].isna().all()
    wanted = (folder, 8, len(orbits), int(stable.sum()), 0, False)
    assert (
        summary.folder, summary.cells, summary.orbits, summary.stable_orbits, summary.failed_cells,
        summary.already_finished,
    ) == wanted  # fmt: skip


@pytest.mark.quick
def test_cells_without_a_cycle_say_so(tmp_path):
    # The only cycles at k = 0.5 last 1.22, one at k = 6 lasts 1.18.
    search = {"starts": 64, "subgrid": 1, "period_min": 1.1, "period_max": 1.2}
    config = parse_config({"model": "wobbling", "grid": {"k": [0.5, 6.0]}, "search": search})
    assert sweep(config, tmp_path, executor=Inline()).failed_cells == 0
    empty, found = read_cells(tmp_path).to_dict("records")
    assert (empty["status"], empty["orbits"], empty["stable_orbits"]) == ("empty", 0, 0)
    assert "1.1 < period <= 1.2" in empty["reason"]
    assert found["status"] == "found"
    assert pd.isna(found["reason"])
    assert read_orbits(tmp_path)["period"].between(1.1, 1.2).all()


def test_two_axes_far_apart_and_one_axis(tmp_path):
    search = {"starts": 256, "subgrid": 1}
    grid = {"omega": [2.5, 3.0, 3.5]}
    config = parse_config({"model": "compass", "grid": grid, "search": search})
    sweep(config, tmp_path / "one", executor=Inline())
    rows = read_orbits(tmp_path / "one")
    for cell, omega in enumerate(grid["omega"]):
        orbits = stridemap.find_orbits("compass", omega=omega)
        assert orbits
        for orbit in orbits:
            (row,) = matches(rows[rows["cell"] == cell], orbit).to_dict("records")
            assert_row_is_orbit(row, orbit)
    # The same points as a part of a grid with another axis, which comes after omega.
    grid = {"gamma": [0.18, 0.2], **grid}
    sweep(
        parse_config({"model": "compass", "grid": grid, "search": search}),
        tmp_path / "two",
        executor=Inline(),
    )
    both = read_orbits(tmp_path / "two")
    assert sorted(set(both["gamma"])) == [0.18, 0.2]
    names = ["theta1", "dtheta1", "dtheta2", "period"]
    same = both[both["gamma"] == 0.18]
    assert len(same) >= len(rows)
    for row in rows.itertuples():
        here = same[same["omega"] == row.omega]
        distance = here[names].sub([getattr(row, name) for name in names]).abs().max(axis=1)
        assert distance.min() < 1e-9


# -- provenance ----------------------------------------------------------------------------------------------


@pytest.mark.quick
def test_both_tables_say_how_they_were_made(reference):
    folder = reference[0]
    found = read_provenance(folder)
    model = load("wobbling")
    assert canonical_json(found["configuration"]) == CONFIG.canonical()
    assert found["configuration_hash"] == CONFIG.config_hash
    assert (found["model"], found["model_hash"]) == ("wobbling", model.hash)
    for name in ("stridemap", "numpy", "scipy", "casadi", "pyarrow"):
        assert found["versions"][name] == version(name)
    assert "python" in found["versions"]
    assert found["compiler"] == load_kernels(model, None).compiler
    assert found["arithmetic"] == Lanes().arithmetic
    assert found["tile_cells"] == 2
    commit = subprocess.run(
        ["git", "-C", GENERATED, "rev-parse", "HEAD"], capture_output=True, text=True, check=False
    )
    if commit.returncode:
        assert found["commit"] is None
    else:
        assert found["commit"].removesuffix("-dirty") == commit.stdout.strip()
    for name in ("orbits.parquet", "cells.parquet", "special.parquet"):
        raw = pq.read_schema(folder / name).metadata[b"stridemap"].decode()
        assert raw == canonical_json(found)
        for private in (socket.gethostname(), str(folder), "workers", "time"):
            assert private not in raw


# -- progress ------------------------------------------------------------------------------------------------


@pytest.mark.quick
def test_progress_only_goes_on(reference):
    _, summary, seen, computed = reference
    order = [(p.round, p.done) for p in seen]
    assert order == sorted(order)
    assert len(set(order)) == len(order)
    orbits = [p.orbits for p in seen]
    assert orbits == sorted(orbits)
    assert orbits[-1] == summary.orbits
    rounds = {p.round for p in seen}
    assert rounds == set(range(1, len(rounds) + 1))
    for number in rounds:
        (total,) = {p.total for p in seen if p.round == number}
        assert total == sum(round_ == number for round_, _ in computed) > 0
        assert [p.done for p in seen if p.round == number] == list(range(total + 1))


# -- cells that fail -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("error", "stage"),
    [
        (FloatingPointError("boom"), "quick_search"),
        (np.linalg.LinAlgError("boom"), "converge"),
        (MemoryError("boom"), "quick_search"),
        (IndexError("boom"), "converge"),
    ],
)
def test_a_cell_that_raises_is_a_row_with_a_reason(tmp_path, monkeypatch, stage, error):
    grid, search = {"k": [0.5, 6.0, 8.0]}, {"starts": 64, "subgrid": 1}
    config = parse_config({"model": "wobbling", "grid": grid, "search": search})
    sweep(config, tmp_path / "sound", executor=Remembering(), tile_cells=3)
    whole = getattr(Solver, stage)

    def part(self, guesses, params, *rest):
        if (params[:, 0] == 6.0).any():
            raise error
        return whole(self, guesses, params, *rest)

    monkeypatch.setattr(Solver, stage, part)
    assert sweep(config, tmp_path / "out", executor=Inline(), tile_cells=3).failed_cells == 1
    cells = read_cells(tmp_path / "out")
    assert cells["status"].tolist() == ["found", "failed", "found"]
    assert cells["reason"][1] == f"{type(error).__name__}: boom"
    rows, sound = read_orbits(tmp_path / "out"), read_orbits(tmp_path / "sound")
    # What branches from other cells pass there is found all the same, if only the search fails.
    assert 0 <= cells["orbits"][1] <= (sound["cell"] == 1).sum()
    assert (cells["orbits"][1] > 0) == (stage == "quick_search")
    rows, sound = rows[rows["cell"] != 1], sound[sound["cell"] != 1]
    assert rows["cell"].tolist() == sound["cell"].tolist()
    np.testing.assert_allclose(rows["period"], sound["period"], atol=1e-9, rtol=0)


# -- tasks, backends and tiles -------------------------------------------------------------------------------

COMPASS = parse_config({"model": "compass", "grid": {"omega": [2.5, 3.0]}, "search": {"starts": 8}})


class Posted(Inline):
    """Computes what arrives of a task after it was sent as bytes, which it keeps."""

    def __init__(self):
        super().__init__()
        self.sent = []

    def submit(self, fn, /, task):
        self.sent.append(pickle.dumps(task))
        return super().submit(fn, pickle.loads(self.sent[-1]))


@pytest.mark.quick
def test_a_task_carries_all_that_it_needs_and_no_path_of_the_sender(tmp_path):
    executor = Posted()
    sweep(COMPASS, tmp_path / "out", executor=executor)
    sweep(COMPASS, tmp_path / "plain", executor=Inline())
    assert tables(tmp_path / "out") == tables(tmp_path / "plain")
    (task, *_) = executor.tasks
    assert task.backend == Lanes()
    assert (task.acceptance, task.continuation) == (COMPASS.acceptance, COMPASS.continuation)
    for sent in executor.sent:
        for path in (GENERATED, GENERATED.parent, tmp_path):
            assert str(path).encode() not in sent


def test_the_backend_is_an_argument_and_equal_arithmetic_gives_equal_numbers(tmp_path):
    backends = {"scalar": "scalar", "virtual": Interpreter(), "narrow": Lanes(instructions=()), "lanes": None}
    seen = {}
    for name, backend in backends.items():
        executor = Inline()
        sweep(COMPASS, tmp_path / name, executor=executor, backend=backend)
        seen[name] = executor.tasks[0].backend
    assert seen == {
        "scalar": ScalarC(), "virtual": Interpreter(), "narrow": Lanes(instructions=()), "lanes": Lanes(),
    }  # fmt: skip
    for one, other in (("scalar", "virtual"), ("narrow", "lanes")):
        pd.testing.assert_frame_equal(
            read_orbits(tmp_path / one), read_orbits(tmp_path / other), check_exact=True
        )
        assert (
            read_provenance(tmp_path / one)["arithmetic"] == read_provenance(tmp_path / other)["arithmetic"]
        )
    assert tables(tmp_path / "narrow") == tables(tmp_path / "lanes")
    assert (
        read_provenance(tmp_path / "scalar")["arithmetic"]
        != read_provenance(tmp_path / "lanes")["arithmetic"]
    )


@pytest.mark.quick
def test_to_resume_with_another_arithmetic_is_refused(tmp_path):
    sweep(COMPASS, tmp_path, executor=Inline(), backend="scalar")
    before = content(tmp_path)
    with pytest.raises(InputError, match="different software .*arithmetic is .*one point at a time"):
        sweep(COMPASS, tmp_path, executor=Inline(), resume=True, backend="lanes")
    with pytest.raises(InputError, match="different software .*tile_cells is 2 there, 1 here"):
        sweep(COMPASS, tmp_path, executor=Inline(), resume=True, backend="scalar", tile_cells=1)
    # The virtual machine computes the same bits.
    assert sweep(COMPASS, tmp_path, executor=Inline(), resume=True, backend="interpreter").already_finished
    assert content(tmp_path) == before


@pytest.mark.quick
def test_a_backend_that_cannot_be_had_there_is_an_error_and_no_failed_cell(tmp_path):
    """Else every cell would be a failure, in tables that look finished."""
    with pytest.raises(CompilerError, match="failed|cannot|no C compiler"):
        sweep(COMPASS, tmp_path / "out", executor=Elsewhere("false"))
    assert not (tmp_path / "out" / "orbits.parquet").exists()


class Elsewhere(Inline):
    """Computes with a compiler that does not work there."""

    def __init__(self, compiler):
        super().__init__()
        self.compiler = compiler

    def submit(self, fn, /, task):
        return super().submit(fn, replace(task, backend=ScalarC(self.compiler)))


@pytest.mark.quick
@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({"workers": 0}, "workers = 0 is not allowed"),
        ({"tile_cells": 0}, "tile_cells = 0 is not allowed"),
        ({"backend": "gpu"}, "unknown backend 'gpu'"),
    ],
)
def test_arguments_are_checked(tmp_path, arguments, sentence):
    with pytest.raises(InputError, match=sentence):
        sweep(COMPASS, tmp_path / "out", **arguments)
    assert not (tmp_path / "out").exists()


def test_the_tables_orbits_come_back_as_orbits(reference):
    rows = read_orbits(reference[0])
    orbits = stridemap.Orbits.from_columns(load("wobbling"), rows)
    pd.testing.assert_frame_equal(
        orbits.to_frame(), rows.drop(columns=["cell", "branch"]), check_dtype=False, check_exact=True
    )
    again = stridemap.find_orbits("wobbling", orbits[0].params)
    assert min(abs(orbit.period - orbits[0].period) for orbit in again) < 1e-9
