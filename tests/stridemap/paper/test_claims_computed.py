"""The verdicts on computed limit cycles, which corrupted cycles change; edges, profiles and the command."""

import json
from dataclasses import replace

import numpy as np
import pandas as pd
import pytest

import stridemap
from stridemap.paper.cycle_tables import cycle_tables
from stridemap.paper.evaluate import STATEMENTS
from stridemap.paper.profile_features import sampled, with_profiles
from stridemap.paper.select import at, main_branch, slices, stable, typical
from stridemap.paper.sweeps import SWEEPS, paper_sweeps
from stridemap.solver.branches.edges import BISECTIONS
from stridemap.solver.model.loading import load
from stridemap.views.report.verdicts import tally
from tests.oracles.claim_tables import changed, swapped
from tests.oracles.shared import once
from tests.oracles.sweeping import Inline

IDS = [f"C{i}" for i in range(1, 21)]
THIN = 14


@pytest.fixture(scope="session")
def computed(common):
    """Coarse sweeps of what the statements are about, and their tables; computed once for all workers."""
    return once(
        common / "claims",
        lambda folder: (folder, cycle_tables(paper_sweeps(folder, thin=THIN, executor=Inline()))),
    )


@pytest.fixture(scope="session")
def folder(computed):
    return computed[0]


@pytest.fixture(scope="session")
def data(computed):
    return computed[1]


CORRUPTED = {
    "C1": lambda d: swapped(d, "A", "B"),
    "C2": lambda d: swapped(d, "A", "B"),
    "C3": lambda d: swapped(d, "A", "B"),
    "C4": lambda d: changed(d, "lines", x_zero_crossings=lambda r: r["x_zero_crossings"] + 4),
    "C5": lambda d: changed(d, "typical", peaks=lambda r: r["peaks"] + 1),
    "C6": lambda d: replace(d, compass=pd.concat([d.compass] * 2, ignore_index=True)),
    "C7": lambda d: changed(d, "lines", lambda r: r.index == 7, spectral_radius=0.5),
    "C8": lambda d: changed(
        changed(d, "lines", spectral_radius=lambda r: 1 / r["k"]),
        "minima",
        spectral_radius=lambda r: 1 / r["k"].astype(float),
    ),
    "C9": lambda d: swapped(swapped(d, 2.0, 3.0, "omega", ("lines",)), 2.0, 3.0, "omega", ("edges",)),
    "C10": lambda d: changed(d, "map", lambda r: (r["alpha"] < 0.4) | (r["alpha"] > 0.6), stable=False),
    "C11": lambda d: swapped(d, "A", "B"),
    "C12": lambda d: changed(d, "compass", d_max=lambda r: 2 * r["d_max"]),
    "C13": lambda d: changed(d, "compass", d_max=lambda r: r["d_max"] / 2),
    "C14": lambda d: changed(d, "lines", d_max=lambda r: r["k"] * r["alpha"] * r["omega"]),
    "C15": lambda d: changed(d, "typical", lambda r: r["group"] == "A", d_travel=lambda r: r["d_travel"] / 2),
    "C16": lambda d: swapped(d, "A", "C"),
    "C17": lambda d: changed(d, "compass", cot=lambda r: 2 * r["cot"]),
    "C18": lambda d: changed(d, "lines", cot=lambda r: 2 * r["cot"]),
    "C19": lambda d: changed(d, "lines", cot=lambda r: r["k"] * r["alpha"] * r["omega"]),
    "C20": lambda d: changed(d, "typical", wobble_amplitude=lambda r: 10 * r["wobble_amplitude"]),
}


@pytest.mark.parametrize("id_", IDS)
def test_corrupted_cycles_change_the_verdict(data, id_):
    before, after = STATEMENTS[id_](data), STATEMENTS[id_](CORRUPTED[id_](data))
    assert after.verdict != before.verdict, before.evidence


def test_flipped_stability_changes_verdicts(data):
    flipped = data
    for table in ("typical", "lines", "map"):
        flipped = changed(flipped, table, stable=lambda r: ~r["stable"])
    different = [id_ for id_ in IDS if STATEMENTS[id_](flipped).verdict != STATEMENTS[id_](data).verdict]
    assert {"C1", "C3", "C5", "C9", "C15", "C20"} <= set(different)


def test_the_main_branch_is_one_cycle_a_spring_in_one_run_a_group(data):
    for name, _, _, orbits in slices(data):
        for group in sorted(orbits["group"][orbits["main"]].unique()):
            k = main_branch(orbits, group)["k"].to_numpy()
            index = np.searchsorted(data.line_k, k)
            assert (np.diff(index) == 1).all(), (name, group, k)
        assert orbits["main"][orbits["stable"]].all()


def test_edges_are_where_an_independent_search_finds_them(data):
    """Stable cycles just inside an edge and none just outside, from many fresh starts at each point."""
    edges = at(data.edges, alpha=0.25, omega=3.0)
    edges = edges[edges["group"].isin(["A", "B"])]
    spacing = data.line_k[1] - data.line_k[0]
    assert len(edges) == 3  # the range of A goes on below the smallest k
    for edge in edges.itertuples():
        assert 0 < edge.side * (edge.k - edge.k_grid) < spacing
        beyond = edge.k + edge.side * 2 * spacing / 2**BISECTIONS
        for k, expected in ((edge.k, True), (beyond, False)):
            found = stridemap.find_orbits("wobbling", k=k, alpha=0.25, omega=3.0)
            assert any(o.stable and o.group == edge.group for o in found) == expected, (edge, k)


def test_smallest_values_are_those_that_fresh_searches_find_around_them(data):
    rows = at(data.minima, alpha=0.5, omega=2.0)
    rows = rows[rows["stable"].astype(bool) & (rows["group"] == "A")]
    grid = at(data.lines, alpha=0.5, omega=2.0)
    grid = stable(grid, "A")
    for measure in ("spectral_radius", "cot"):
        least, on_grid = rows[measure].astype(float).min(), grid[measure].min()
        k = float(rows["k"][rows[measure].astype(float).idxmin()])
        best = min(least, on_grid)
        around = np.clip(np.linspace(k - 0.01, k + 0.01, 9), data.line_k[0], data.line_k[-1])
        for near in (k, *around):
            found = stridemap.find_orbits("wobbling", k=float(near), alpha=0.5, omega=2.0)
            values = [getattr(o, measure) for o in found if o.stable and o.group == "A"]
            assert values
            assert min(values) > best - 1e-5
            assert near != k or min(values) == pytest.approx(least, abs=1e-9)
    # Two multipliers pass each other in modulus there, between the springs of the grid.
    assert rows["spectral_radius"].astype(float).min() < grid["spectral_radius"].min() - 0.01


def test_profiles_agree_with_what_was_located_in_continuous_time(data):
    """Extremes and zeros of the table come from root finding between nodes, the profiles from samples."""
    rows = stable(data.lines)
    motion = sampled(load("wobbling"), rows)
    x = motion.coordinate("x")
    crossings = (np.signbit(x[:, 1:]) != np.signbit(x[:, :-1])).sum(axis=1)
    assert (
        crossings != rows["x_zero_crossings"].to_numpy(dtype=int)
    ).mean() < 0.02  # two zeros between samples
    d_max = np.abs(motion.d).max(axis=1)
    assert (d_max <= rows["d_max"] + 1e-12).all()
    assert d_max == pytest.approx(rows["d_max"].to_numpy(), rel=1e-4)
    assert rows["x_travel"].to_numpy() == pytest.approx(np.ptp(x, axis=1))
    assert rows["d_first"].to_numpy() == pytest.approx(motion.d[:, :201].mean(axis=1))


def test_profiles_of_no_cycles():
    empty = with_profiles(load("wobbling"), pd.DataFrame({"k": []}))
    assert "x_first" in empty.columns
    assert empty.empty


def test_the_typical_solutions_are_those_of_the_paper(data):
    assert [len(at(data.typical, k=k)) > 0 for k in (0.5, 6.0, 22.5)] == [True] * 3
    assert [typical(data, group)["peaks"] for group in "ABC"] == [1, 2, 3]


def test_json(folder, run):
    status, out, err = run("claims", "--json", "--sweeps", folder, "--thin", THIN)
    assert (status, err) == (0, "")
    answer = json.loads(out)
    assert [claim["id"] for claim in answer["claims"]] == IDS
    for claim in answer["claims"]:
        assert claim["verdict"] in ("holds", "in part", "differs")
        assert claim["statement"]
        assert claim["evidence"]["parts"]
    assert answer["params"] == {"beta": 0.15, "Kp": 10.0, "Kd": 0.6, "S": 0.18, "gamma": 0.18}
    assert "not published" in answer["origin"]


@pytest.fixture
def tables_of_before(data, monkeypatch):
    """The tables are not made anew from the sweeps, which are read all the same; for test_json they are."""

    def read(sweeps):
        assert all(len(sweeps.orbits(name)) for name in SWEEPS)
        return data

    monkeypatch.setattr("stridemap.paper.evaluate.cycle_tables", read)


def test_table(folder, tables_of_before, run):
    status, out, _ = run("claims", "--sweeps", folder, "--thin", THIN)
    assert status == 0
    lines = out.splitlines()
    assert [line.split()[0] for line in lines[:20]] == IDS
    verdicts = [line[5:13].strip() for line in lines[:20]]
    counts = [verdicts.count(v) for v in ("holds", "in part", "differs")]
    assert lines[20] == tally(verdicts)
    assert all(len(line) < 80 for line in lines[:21])
    assert counts[0] > 5
    assert f"every {THIN}th value" in out
    assert "not published" in lines[-1]


def test_from_python_and_a_second_time(folder, tables_of_before):
    seen = []
    claims = stridemap.claims(folder, thin=THIN, progress=lambda *args: seen.append(args))
    assert [claim.id for claim in claims] == IDS
    assert seen == []  # nothing was computed again


def test_another_configurations_folder_is_refused(folder, refused):
    refused(["claims", "--sweeps", folder, "--thin", "7"], "output of another configuration")
    refused(
        ["claims", "--sweeps", folder, "--thin", THIN, "--set", "beta=0.2"], "beta", "give another folder"
    )


def test_another_models_folder_is_refused(folder, tmp_path, refused):
    (tmp_path / "typical").symlink_to(folder / "compass")
    refused(["claims", "--sweeps", tmp_path], "output of another configuration")


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("--set k=3", "k cannot be set here"),
        ("--set beta", "write --set NAME=VALUE"),
        ("--set beta=x", "beta = 'x' is not a finite number"),
        ("--thin 0", "thin = 0 is not allowed"),
        ("--workers 0", "workers = 0 is not allowed"),
    ],
)
def test_unusable_words_are_refused(words, expected, tmp_path, refused):
    refused(f"claims --sweeps {tmp_path} {words}", expected)


def test_sweeps_without_a_physical_gait_are_reported(tmp_path, run):
    """Where the leg is to swing backwards, 8,192 starts find none at each of five frequencies."""
    status, out, err = run(*f"claims --sweeps {tmp_path} --thin 60 --workers 1 --set S=-1.5".split())
    assert (status, out) == (2, "")
    assert err.splitlines()[-1].startswith(
        "error: the sweep compass holds no limit cycle that is a physical gait"
    )
    assert "Traceback" not in err
