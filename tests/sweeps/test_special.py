"""Special points along the lines of a sweep, against branches over one parameter and published values."""

import dataclasses
import itertools
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pyarrow as pa
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.solver.branches.conditions import GaitEnd
from stridemap.solver.model.loading import load
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.grid import Grid
from stridemap.sweeps.parts import columns_of, part_table, result_of
from stridemap.sweeps.reading import read_sweep
from stridemap.sweeps.run import sweep
from stridemap.sweeps.special import NOT_LOCATED, Locator, SpecialPoint, _in_turn
from stridemap.sweeps.special_columns import special_columns
from stridemap.sweeps.special_tables import in_order, special_table_of
from stridemap.sweeps.store import SPECIAL, read_orbits, read_special
from stridemap.sweeps.tables import special_schema
from tests.oracles.kernels import needs_compiler
from tests.oracles.sweeping import Inline

pytestmark = needs_compiler

WOBBLING = {
    "model": "wobbling",
    "params": {"alpha": 0.25, "omega": 3.0},
    "grid": {"k": {"start": 5.0, "stop": 13.0, "num": 33}},
    "search": {"starts": 32, "subgrid": 2},
}
SIMPLEST = {
    "model": "simplest_walker",
    "grid": {"slope": {"start": 0.001, "stop": 0.018, "num": 18}},
    "search": {"starts": 32},
}
ENDS = {"grazing", "early_touchdown", "backward", "fall", "period_limit"}


def swept(data, folder, **options):
    summary = sweep(parse_config(data), folder, executor=Inline(), **options)
    return summary, read_special(folder)


@pytest.fixture(scope="module")
def wobbling(tmp_path_factory):
    folder = tmp_path_factory.mktemp("special") / "out"
    # In one tile, so that parts of a branch on which nobody could walk join what they lead to.
    return folder, *swept(WOBBLING, folder, tile_cells=33)


def is_one(one, type_, values, tolerance):
    """Whether rows are the special point of a type with values of some columns."""
    near = [np.abs(one[name] - value) < tolerance for name, value in values.items()]
    return (one["type"] == type_) & np.all(near, axis=0)


# -- against independent values ------------------------------------------------------------------------------


def test_a_line_has_the_special_points_of_the_branches_over_its_parameter(wobbling):
    _, summary, special = wobbling
    found = stridemap.branches("wobbling", "k", (5.0, 13.0), {"alpha": 0.25, "omega": 3.0}, seeds=6)
    wanted = [one for one in found.special if one.gait]
    assert {one.type for one in wanted} >= {"fold", "pd", "grazing", "early_touchdown", "backward"}
    for one in wanted:
        row = special[is_one(special, one.type, {"k": one.value, "period": one.period, **one.state}, 1e-8)]
        assert len(row) == 1, one
        assert (
            row.criticality.isna() if one.criticality is None else row.criticality == one.criticality
        ).all()
        if one.multiplier is not None:
            assert abs(row.multiplier_re.item() - one.multiplier.real) < 1e-8
            np.testing.assert_allclose(abs(row.crossing_slope.item()), abs(one.crossing_slope), rtol=1e-6)
            for name, value in one.null.items():
                assert abs(row[f"null_{name}_re"].item() - value.real) < 1e-6
    # None is spurious. (A branch calls a point a gait where both of its neighbours are, a sweep where it is.)
    for _, row in special[special.gait].iterrows():
        same = [
            abs(one.value - row.k) < 1e-8 and abs(one.period - row.period) < 1e-8 for one in found.special
        ]
        assert sum(same) == 1, row
    assert special.residual.max() < 1e-11
    assert special.reason.isna().all()
    assert sum(summary.special.values()) == len(special)
    assert summary.special["fold"] == (special.type == "fold").sum()
    assert summary.special_not_located == 0


def test_the_first_doubling_of_the_simplest_walker(tmp_path):
    _, special = swept(SIMPLEST, tmp_path)
    assert special["type"].tolist() == ["pd"]
    (row,) = special.to_dict("records")
    # shared table of values: DOP853 at 1e-13, Newton's method, differences of the fourth order
    assert abs(row["slope"] - 0.015088437940) < 1e-11
    assert abs(row["theta"] - 0.23716586) < 1e-8
    assert abs(row["dtheta"] + 0.23192708) < 1e-8
    assert abs(row["period"] - 3.9124092125) < 1e-9
    assert abs(row["multiplier_0_re"] + 1) < 1e-9
    assert abs(row["multiplier_1_re"] + 0.297621) < 1e-6
    assert (row["multiplier_re"], row["multiplier_im"]) == (-1.0, 0.0)
    assert row["criticality"] == "supercritical"
    assert row["gait"] is True
    cells = np.linspace(0.001, 0.018, 18)
    assert row["cell"] == np.flatnonzero(cells <= row["slope"])[-1]
    assert row["line"] == 0
    assert row["lower"] == row["upper"] == row["slope"]


def test_the_first_doubling_of_the_compass_gait(tmp_path):
    slope = {"start": float(np.radians(3.0)), "stop": float(np.radians(5.0)), "num": 5}
    data = {"model": "goswami_compass", "params": {"mu": 2.0, "beta": 1.0}, "grid": {"slope": slope}}
    _, special = swept({**data, "search": {"starts": 32}}, tmp_path)
    doublings = special[special.type == "pd"]
    assert np.abs(np.degrees(doublings.slope) - 4.390898249724).min() < 2e-10
    assert doublings.loc[doublings.slope.idxmin(), "criticality"] == "supercritical"


def test_where_the_period_leaves_its_range_it_has_the_limit(tmp_path):
    data = {**SIMPLEST, "search": {"starts": 32, "period_max": 3.85}}
    _, special = swept(data, tmp_path)
    assert "period_limit" in set(special["type"])
    limits = special[special.type == "period_limit"]
    np.testing.assert_allclose(limits.period, 3.85, rtol=0, atol=1e-11)
    for slope in limits.slope:  # a cycle of that period, by a search that knows nothing of the limit
        periods = stridemap.find_orbits("simplest_walker", slope=slope).period
        assert np.abs(periods - 3.85).min() < 1e-9


# -- what the table of orbits says ---------------------------------------------------------------------------


def holes(orbits, special, vary, values):
    """Cells between which the number of cycles of a family changes, and special points do not say why."""
    out = []
    count = lambda branch, v: int(((orbits.branch == branch) & (orbits[vary] == v)).sum())  # noqa: E731
    for branch in orbits.branch.unique():
        own = special[special.branch == branch]
        for low, high in itertools.pairwise(values):
            change = count(branch, high) - count(branch, low)
            between = own[(own[vary] > low) & (own[vary] <= high)]
            ends = int(between["type"].isin(ENDS).sum())
            folds = int((between["type"] == "fold").sum())
            if abs(change) > ends + 2 * folds or (change - ends) % 2:
                out.append((branch, low, high, change, ends, folds))
    return out


def test_no_cycle_vanishes_along_a_line_without_a_special_point(wobbling):
    folder, _, special = wobbling
    orbits = read_orbits(folder)
    values = np.linspace(5.0, 13.0, 33)
    assert set(orbits.branch) >= set(special.branch[special.type == "fold"])
    assert holes(orbits, special, "k", values) == []
    # The walk itself can fail: without one end there is a hole.
    last = special[special["type"].isin(ENDS)].index[-1]
    assert len(holes(orbits, special.drop(index=last), "k", values)) > 0


# -- tiles, order, parts -------------------------------------------------------------------------------------


def test_tiles_share_what_lies_between_them(wobbling, tmp_path):
    _, _, special = wobbling
    _, cut = swept(WOBBLING, tmp_path, tile_cells=4)
    assert len(cut) == len(special)
    assert cut["type"].tolist() == special["type"].tolist()
    assert cut["cell"].tolist() == special["cell"].tolist()
    columns = ["k", "period", *load("wobbling").section]
    np.testing.assert_allclose(cut[columns], special[columns], rtol=0, atol=1e-8)


def test_rows_are_ordered_and_on_their_line(tmp_path):
    grid = {"beta": [0.15, 0.16], "k": {"start": 5.0, "stop": 7.0, "num": 5}}
    data = {**WOBBLING, "grid": grid, "params": {"alpha": 0.25, "omega": 3.0}}
    _, special = swept(data, tmp_path)
    assert special.sort_values(["line", "k"], kind="stable").index.tolist() == list(special.index)
    assert set(special.line) == {0, 1}  # beta runs fastest: it is after k among the parameters
    assert special.beta.tolist() == [0.15 if line == 0 else 0.16 for line in special.line]
    values = np.linspace(5.0, 7.0, 5)
    place = (special.cell - special.line) // 2
    assert (special.k >= values[place]).all()
    assert (special.k < np.append(values, np.inf)[place + 1]).all()
    assert (special.alpha == 0.25).all()


@pytest.mark.quick
def test_the_order_and_what_is_one_point():
    model, grid = load("simplest_walker"), Grid(("slope",), (np.array([0.0, 0.5, 1.0]),))

    def point(value, u, type_="fold", branch=3, residual=0.0):
        values = {"u": np.array(u), "multipliers": np.array([1.0, 0.5]), "residual": residual}
        return SpecialPoint(0, branch, type_, value, value, values)

    lost = SpecialPoint(2, 3, "pd", 0.2, 0.6, {}, NOT_LOCATED)
    points = [
        point(0.7, (0.1, -0.1, 3.0)),
        point(0.5, (0.2, -0.2, 4.0), residual=1.0),
        lost,
        point(0.5 + 1e-9, (0.2, -0.2, 4.0)),  # the second one again, from another tile
        point(0.5, (0.2, -0.2, 4.0), "pd", branch=4),  # not what was lost: of another family
        replace(lost, lower=0.3),
        point(0.7, (0.1, -0.1, 3.01)),
        point(0.9, (0.1, -0.1, 3.0), "pd"),  # nor this, which is not between its values
    ]
    table = special_table_of(model, special_columns(model, grid, {}, points))
    rows = in_order(model, "slope", 1.0, table).to_pylist()
    seen = [(r["type"], r["lower"], r["period"], r["cell"], r["reason"]) for r in rows]
    assert seen == [
        ("pd", 0.2, None, 0, NOT_LOCATED),
        ("fold", 0.5, 4.0, 1, None),
        ("pd", 0.5, 4.0, 1, None),
        ("fold", 0.7, 3.0, 1, None),
        ("fold", 0.7, 3.01, 1, None),
        ("pd", 0.9, 3.0, 1, None),
    ]
    assert rows[1]["residual"] == 1.0  # the first of those that are one
    assert rows[0]["slope"] is None
    located = [*points, point(0.4, (0.3, -0.3, 5.0), "pd")]
    rows = in_order(
        model, "slope", 1.0, special_table_of(model, special_columns(model, grid, {}, located))
    ).to_pylist()
    assert [r["type"] for r in rows if r["reason"]] == []
    # Of one point that two tiles have met, the family with cycles counts: its number is the lower one.
    twice = [point(0.7, (0.1, -0.1, 3.0), branch=branch) for branch in (7, 2)]
    table = special_table_of(model, special_columns(model, grid, {}, twice))
    assert [r["branch"] for r in in_order(model, "slope", 1.0, table).to_pylist()] == [2]


class Piece:
    """A part of a branch at a place, on which things were found at other places."""

    def __init__(self, place, *found):
        self.place, self.found, self.entered = place, found, []
        self.curve = SimpleNamespace(equations=SimpleNamespace(point=lambda values: values))
        self.one = self.other = SimpleNamespace(n_rk=48)

    def is_near(self, other):
        return abs(self.place - other.place) < 1

    def has_bifurcations(self):
        return True

    def bifurcations_are_among(self, met):
        return any(abs(special.x[-1] - self.place) < 1 for special in met)

    def bifurcations(self):
        return [SimpleNamespace(x=np.array([0.0, at])) for at in self.found]
        yield  # a search that asks nothing

    def criticality(self, special):
        return f"at {special.x[-1]:g}"
        yield

    def enter(self, special, criticality, gait):
        self.entered.append((special.x[-1], criticality, gait))


class Conditions:
    """Solutions at even places are cycles; those at places above 10 keep contact."""

    def of_cycles(self, n_rk, u, params, n_steps):
        assert n_rk == [96] * len(u)  # twice that of the points
        places = params[:, -1]
        return {
            GaitEnd.GRAZING: np.where(places % 2 == 0, 1.0, -1.0),
            GaitEnd.CONTACT: np.where(places > 10, 1.0, -1.0),
        }


@pytest.mark.quick
def test_each_bifurcation_of_a_cycle_is_entered_where_it_was_found():
    """Whether it is a gait is its own; solutions that are no cycles stand before some that are."""
    first, second = Piece(0, 1.0, 2.0, 14.0), Piece(20, 3.0, 20.0, 5.0, 6.0)
    Locator(Conditions(), "k", 0.0, 1.0)._find_bifurcations([(0, first), (0, second)])
    assert first.entered == [(2.0, "at 2", False), (14.0, "at 14", True)]
    assert second.entered == [(20.0, "at 20", True), (6.0, "at 6", False)]


@pytest.mark.quick
def test_what_two_stretches_share_is_looked_for_on_one_of_them():
    """On one line; on another one it is something else. Where one finds nothing, the other one looks."""
    pieces = [Piece(0, 0.0), Piece(0.5, 0.0), Piece(4), Piece(4.5, 4.0), Piece(0, 0.0)]
    waiting = [(0, piece) for piece in pieces[:-1]] + [(1, pieces[-1])]
    Locator(Conditions(), "k", 0.0, 1.0)._find_bifurcations(waiting)
    assert [[at for at, _, _ in piece.entered] for piece in pieces] == [[0.0], [], [], [4.0], [0.0]]
    turns = [[piece.place for _, piece in turn] for turn in _in_turn(waiting, lambda *_: True)]
    assert turns == [[0, 4, 0], [0.5, 4.5]]


def test_a_part_keeps_special_points(wobbling):
    folder, _, _ = wobbling
    from tests.sweeps.test_tiles import Line

    result = Line((22.0, 22.5), {}).result([(0, Line((22.0,), {}).cycles(22.0).u[0])])
    model = load("wobbling")
    table = pa.Table.from_pandas(read_special(folder), schema=special_schema(model), preserve_index=False)
    kept = result_of(model, 1, 0, part_table(model, dataclasses.replace(result, special=columns_of(table))))
    assert special_table_of(model, kept.special).equals(table)


# -- options and older folders -------------------------------------------------------------------------------


def test_they_can_be_left_out(tmp_path):
    summary, special = swept({**SIMPLEST, "special_points": False}, tmp_path)
    assert len(special) == 0
    assert summary.special == {}
    assert list(special.columns) == special_schema(load("simplest_walker")).names


def test_a_read_sweep_and_the_summary_of_a_finished_one_have_them(wobbling):
    folder, summary, special = wobbling
    assert read_sweep(folder).special.equals(special)
    again = sweep(parse_config(WOBBLING), folder, executor=Inline(), resume=True, tile_cells=33)
    assert again.already_finished
    assert again.special == summary.special


def test_a_folder_of_an_earlier_version_says_so(wobbling, tmp_path):
    for name in ("orbits.parquet", "cells.parquet"):
        (tmp_path / name).write_bytes((wobbling[0] / name).read_bytes())
    with pytest.raises(InputError, match=f"^there is no {SPECIAL} in .* an earlier version of stridemap"):
        read_special(tmp_path)
    with pytest.raises(InputError, match=r"special.parquet in nowhere|there is no"):
        read_special(tmp_path / "nowhere")
    assert len(stridemap.read_orbits(tmp_path)) > 0
    assert stridemap.read_provenance(tmp_path)["format"] == 5


def test_the_command_line_counts_them(run, tmp_path):
    (tmp_path / "a.toml").write_text(
        'model = "simplest_walker"\n[grid]\nslope = { start = 0.014, stop = 0.016, num = 5 }\n'
    )
    status, out, _ = run("sweep", tmp_path / "a.toml", "--out", tmp_path / "out", "--workers", "1")
    assert status == 0
    assert out.splitlines()[-1] == "special points along the lines of the grid: 1 pd"
