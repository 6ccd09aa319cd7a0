"""Every verdict is what the tables say: on made-up tables that hold, hold in part and differ."""

import json
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pandas as pd
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.paper.branch_tables import EDGE_COLUMNS
from stridemap.paper.claim import Parts, Verdict
from stridemap.paper.evaluate import STATEMENTS, evaluate
from stridemap.paper.points import ALPHAS, OMEGAS, PLANE, TYPICAL
from stridemap.paper.stable_runs import stable_runs
from stridemap.paper.statements.stability import _length
from stridemap.paper.sweeps import configurations, default_folder
from stridemap.solver.cycles.gait import is_physical_gait
from tests.oracles.claim_tables import changed, made_up, slow, swapped

IDS = [f"C{i}" for i in range(1, 21)]


def verdict(id_, data):
    return str(STATEMENTS[id_](data).verdict)


def group(*letters):
    return lambda rows: rows["group"].isin(letters)


def first_of(letter):
    """The rows of one group at omega = 2 and alpha = 0.25."""
    return lambda rows: (rows["group"] == letter) & (rows["omega"] == 2.0) & (rows["alpha"] == 0.25)


# For each statement: a change after which it holds in part, and one after which it differs.
CHANGES = {
    "C1": (
        lambda d: changed(d, "typical", group("B"), stable=False),
        lambda d: changed(d, "typical", stable=False),
    ),
    "C2": (
        lambda d: swapped(d, "C", "D"),
        lambda d: changed(changed(d, "lines", main=False), "map", stable=False),
    ),
    "C3": (lambda d: changed(d, "lines", first_of("A"), x_first=0.01), lambda d: swapped(d, "A", "B")),
    "C4": (
        lambda d: changed(d, "lines", first_of("D"), x_zero_crossings=8),
        lambda d: changed(d, "lines", x_zero_crossings=2),
    ),
    "C5": (lambda d: changed(d, "typical", group("C"), peaks=1), lambda d: changed(d, "typical", peaks=7)),
    "C6": (
        lambda d: changed(d, "typical", group("A"), likeness=0.0),
        lambda d: changed(
            replace(d, compass=pd.concat([d.compass] * 2, ignore_index=True).assign(peaks=2)),
            "typical",
            group("A"),
            likeness=0.0,
        ),
    ),
    "C7": (
        lambda d: changed(d, "lines", first_of("E"), spectral_radius=0.6),
        lambda d: changed(d, "lines", spectral_radius=0.5),
    ),
    "C8": (
        lambda d: changed(d, "lines", first_of("C"), spectral_radius=lambda r: 2 - 0.01 * r["k"]),
        lambda d: changed(d, "lines", spectral_radius=lambda r: 2 - 0.01 * r["k"]),
    ),
    "C9": (
        lambda d: changed(d, "lines", lambda r: (r["omega"] == 3) & r["k"].between(24, 30), stable=False),
        lambda d: swapped(d, 2.0, 3.0, "omega", ("lines",)),
    ),
    "C10": (
        lambda d: changed(d, "map", lambda r: r["alpha"] == 0.1, stable=True),
        lambda d: changed(d, "map", stable=lambda r: r["alpha"] != 0.45),
    ),
    "C11": (
        lambda d: changed(d, "lines", first_of("B"), d_max=1.0),
        lambda d: changed(d, "lines", group("A"), d_max=0.0),
    ),
    "C12": (
        lambda d: changed(d, "lines", first_of("A"), d_max=0.0),
        lambda d: changed(d, "compass", d_max=9.0),
    ),
    "C13": (
        lambda d: changed(d, "lines", first_of("B"), d_max=1.0),
        lambda d: changed(d, "compass", d_max=0.0),
    ),
    "C14": (
        lambda d: changed(d, "lines", first_of("B"), d_max=lambda r: 1 - 0.001 * r["k"]),
        lambda d: changed(d, "lines", d_max=lambda r: 1 / (r["k"] * r["alpha"] * r["omega"])),
    ),
    "C15": (
        lambda d: changed(d, "typical", group("B"), d_sign_changes=3),
        lambda d: changed(d, "typical", d_start=-0.1, d_travel=0.3),
    ),
    "C16": (
        lambda d: changed(d, "lines", first_of("B"), cot=1.0),
        lambda d: changed(d, "lines", group("A"), cot=0.0),
    ),
    "C17": (lambda d: changed(d, "lines", first_of("A"), cot=0.0), lambda d: changed(d, "compass", cot=9.0)),
    "C18": (lambda d: changed(d, "compass", slow, cot=0.0), lambda d: changed(d, "compass", cot=0.0)),
    "C19": (
        lambda d: changed(d, "lines", first_of("B"), cot=lambda r: 1 - 0.001 * r["k"]),
        lambda d: changed(d, "lines", cot=lambda r: 1 / (r["k"] * r["alpha"] * r["omega"])),
    ),
    "C20": (
        lambda d: changed(d, "typical", wobble_amplitude=0.03),
        lambda d: changed(d, "typical", wobble_amplitude=0.5),
    ),
}


def test_every_statement_is_declared_once_and_in_order():
    assert [claim.id for claim in evaluate(made_up())] == IDS
    assert set(CHANGES) == set(IDS)


@pytest.mark.parametrize("id_", IDS)
def test_holds_where_the_tables_say_so(id_):
    claim = STATEMENTS[id_](made_up())
    assert claim.verdict is Verdict.HOLDS, claim.evidence


@pytest.mark.parametrize("id_", IDS)
def test_holds_in_part_after_one_change(id_):
    claim = STATEMENTS[id_](CHANGES[id_][0](made_up()))
    assert claim.verdict is Verdict.IN_PART, claim.evidence
    assert "not so: " in claim.numbers


@pytest.mark.parametrize("id_", IDS)
def test_differs_after_the_opposite(id_):
    claim = STATEMENTS[id_](CHANGES[id_][1](made_up()))
    assert claim.verdict is Verdict.DIFFERS, claim.evidence


def beside_the_compass(factor, column, letters):
    """The tables with a column of some groups at a factor of the compass's own number, at each omega."""

    def value(rows):
        compass = made_up().compass.set_index("omega")[column]
        return factor * rows["omega"].map(compass)

    return changed(made_up(), "lines", group(*letters), **{column: value})


@pytest.mark.parametrize(
    ("id_", "column", "letters", "factor", "expected"),
    [
        ("C7", "spectral_radius", "ABCDE", 0.98, "differs"),
        ("C7", "spectral_radius", "ABCDE", 1.02, "holds"),
        ("C12", "d_max", "A", 0.98, "differs"),
        ("C12", "d_max", "A", 1.02, "holds"),
        ("C13", "d_max", "BC", 1.02, "differs"),
        ("C13", "d_max", "BC", 0.98, "holds"),
        ("C17", "cot", "A", 0.98, "differs"),
        ("C17", "cot", "A", 1.02, "holds"),
        ("C18", "cot", "BC", 1.02, "differs"),
        ("C18", "cot", "BC", 0.98, "holds"),
    ],
)
def test_comparisons_with_the_compass_are_with_its_own_number(id_, column, letters, factor, expected):
    assert verdict(id_, beside_the_compass(factor, column, letters)) == expected


@pytest.mark.parametrize("id_", IDS)
def test_evidence_decides_again_and_is_plain(id_):
    for change in (lambda d: d, *CHANGES[id_]):
        claim = STATEMENTS[id_](change(made_up()))
        entry = json.loads(json.dumps(claim.to_dict(), allow_nan=False))
        assert entry == claim.to_dict()
        parts = Parts()
        for name, part in entry["evidence"]["parts"].items():
            parts.add(name, part["holds"])
        assert parts.verdict() == entry["verdict"]


@pytest.mark.parametrize("id_", IDS)
def test_no_stable_cycle_leaves_a_verdict(id_):
    """Nothing to speak of is no reason to hold."""
    data = made_up()
    for table in ("typical", "lines", "map"):
        data = changed(data, table, stable=False)
    data = changed(data, "lines", main=False)
    # The compass, and what all cycles of the walker have, are still there.
    assert verdict(id_, data) == {"C6": "in part", "C7": "holds"}.get(id_, "differs")


def test_a_claim_is_frozen():
    claim = STATEMENTS["C1"](made_up())
    with pytest.raises(AttributeError):
        claim.verdict = Verdict.DIFFERS
    with pytest.raises(TypeError):
        claim.evidence["parts"] = {}


def test_only_cycles_that_walk_count():
    rows = pd.DataFrame(
        {
            "status": ["converged", "inaccurate", "converged", "converged"],
            "step_length": [0.2, 0.2, -0.2, 0.2],
            "min_vertical_force": [1.0, 1.0, 1.0, 0.0],
        }
    )
    assert is_physical_gait(rows).tolist() == [True, False, False, False]


def test_ranges_are_closed_by_bisected_edges():
    grid = np.arange(1.0, 11.0)
    orbits = pd.DataFrame({"k": [1.0, 2.0, 3.0, 6.0, 7.0, 8.0], "stable": [True] * 4 + [False, True]})
    edges = pd.DataFrame(
        [(0.25, 3.0, "A", 3.0, 1, 3.4), (0.25, 3.0, "A", 6.0, -1, 5.2)], columns=EDGE_COLUMNS
    )
    runs = stable_runs(orbits, grid, edges)
    assert [(r.low, r.high, r.opens, r.closes) for r in runs] == [
        (1, 3, 1, 3.4),
        (6, 6, 5.2, 6),
        (8, 8, 8, 8),
    ]
    assert [r.cut_low for r in runs] == [True, False, False]
    assert runs[0].width == pytest.approx(2.4)


def test_ranges_that_overlap_count_once():
    """1 to 3 and 2 to 5 and 7 to 8 and 7.5 to 7.75: five in all."""
    k = np.array([[1.0, 3.0], [2.0, 5.0], [7.0, 8.0], [7.5, 7.75]])
    runs = [SimpleNamespace(opens=low, closes=high) for low, high in k]
    assert _length({"B": [runs[2], runs[1]], "A": [runs[0], runs[3]]}) == 5.0
    assert _length({}) == 0.0


@pytest.mark.parametrize(
    ("table", "column"), [("typical", "likeness"), ("compass", "cot"), ("lines", "main"), ("map", "alpha")]
)
def test_a_missing_column_is_reported(table, column):
    data = made_up()
    with pytest.raises(InputError, match=f"the table {table} has no column {column}; give tables of"):
        replace(data, **{table: getattr(data, table).drop(columns=column)})


@pytest.mark.parametrize("table", ["compass", "lines", "map"])
def test_an_empty_sweep_is_reported(table):
    data = made_up()
    with pytest.raises(InputError, match=f"the sweep {table} holds no limit cycle that is a physical gait"):
        replace(data, **{table: getattr(data, table).iloc[:0]})


def test_parameters_that_the_statements_fix_cannot_be_set():
    with pytest.raises(InputError, match="k cannot be set here: .* beta, Kp, Kd, S, gamma"):
        configurations({"k": 3.0})
    with pytest.raises(InputError, match=r"beta = -1.0 is outside the allowed range"):
        configurations({"beta": -1.0})
    with pytest.raises(InputError, match="thin = 0 is not allowed"):
        configurations(thin=0)


def test_configurations_take_parameters_and_thin_out():
    plain, thin = configurations(), configurations({"beta": 0.2}, thin=10)
    assert [config.n_cells for config in plain.values()] == [3, 2, 2400, 18000]
    assert {0.5, 6.0, 22.5} <= set(plain["lines"].grid["k"])
    # The statements name these points.
    assert (plain["lines"].grid["alpha"], plain["lines"].grid["omega"]) == (ALPHAS, OMEGAS)
    assert (plain["map"].grid["omega"], plain["compass"].grid["omega"]) == (OMEGAS, OMEGAS)
    assert set(plain["typical"].grid["k"]) == set(TYPICAL.values())
    assert PLANE.items() <= plain["typical"].params.items()
    assert [config.n_cells for config in thin.values()] == [3, 2, 61 * 4, 13 * 9 * 2]
    assert all(config.params["beta"] == 0.2 for config in thin.values())


def test_the_pages_have_the_configurations_of_the_sweeps():
    """Numbers of cells, wherever a page gives them, and the folder."""
    cells = {name: config.n_cells for name, config in configurations().items()}
    docs = Path(__file__).parents[3] / "docs"
    claims, figures = ((docs / f"{page}.md").read_text("utf-8") for page in ("claims", "figures"))
    rows = re.findall(r"^\| `(\w+)` \| .* \| ([\d,]+) \|$", claims, re.MULTILINE)
    assert {name: int(count.replace(",", "")) for name, count in rows} == cells
    named = re.findall(r"`(\w+)`\s+\(([\d,]+) cells\)", figures)
    assert {name: int(count.replace(",", "")) for name, count in named}.items() <= cells.items()
    assert {name for name, _ in named} == {"lines", "map"}
    assert len(re.findall(r"[\d,]+ cells", figures)) == len(named)
    assert f"`{default_folder().as_posix()}`" in claims


def test_each_choice_of_parameters_has_its_own_folder():
    assert default_folder().parts == ("results", "paper-sweeps")
    assert default_folder({"beta": 0.2, "S": 0.1}, 10).name == "paper-sweeps-S=0.1-beta=0.2-thin=10"


def test_the_folder_of_the_sweeps_is_called_sweeps(refused, tmp_path):
    with pytest.raises(InputError, match=r"given by `sweeps` now: write sweeps='here'"):
        stridemap.claims(out="here")
    refused(f"claims --out {tmp_path}", f"--out is called --sweeps now: write --sweeps {tmp_path}")


PUBLIC = """
import sys
import stridemap.paper, stridemap.views
assert stridemap.paper.Claim.__name__ == "Claim"
assert all(callable(getattr(stridemap.paper, name)) for name in stridemap.paper.__all__)
assert all(callable(getattr(stridemap.views, name)) for name in stridemap.views.__all__)
assert not {"matplotlib", "PIL"} & set(sys.modules)
"""


def test_public_names_need_nothing_that_draws():
    done = subprocess.run([sys.executable, "-c", PUBLIC], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert stridemap.paper.claims is stridemap.claims
    assert [v.value for v in stridemap.Verdict] == ["holds", "in part", "differs"]
    with pytest.raises(AttributeError, match="has no attribute 'claim_s'"):
        stridemap.paper.claim_s  # noqa: B018
