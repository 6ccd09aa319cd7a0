"""Many limit cycles as arrays: a sequence, columns, a table, and what a notebook shows."""

import pickle
from collections.abc import Sequence

import numpy as np
import pandas as pd
import pytest

from stridemap.quantities import MEASURED
from stridemap.solver.api.points import find_orbits
from stridemap.solver.cycles.orbit import Orbit
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import continued, find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.cycles.status import Status
from stridemap.solver.model.loading import load
from stridemap.sweeps.tables import orbit_schema
from tests.oracles.reference import GUESSES, TYPICAL, parameters

pytestmark = pytest.mark.quick


@pytest.fixture(scope="module")
def orbits():
    """Every cycle at the three typical points, stable and unstable."""
    model = load("wobbling")
    return find_all(Solver.for_model(model), np.array([model.point(p) for p in TYPICAL]))[1]


@pytest.fixture(scope="module")
def mixed():
    """One result per status, failures included."""
    model = load("wobbling")
    points = [dict(zip(("k", "alpha", "omega"), point, strict=True)) for point, _ in GUESSES.values()]
    params = np.array([model.point(point) for point in points])
    return continued(Solver.for_model(model), params, np.array([guess for _, guess in GUESSES.values()]))


def assert_same(one, other):
    """Equal in every array; Orbits themselves are compared by identity."""
    assert one.model is other.model
    for name, column in one.columns().items():
        np.testing.assert_array_equal(column, other.columns()[name], err_msg=name)
    np.testing.assert_array_equal(one.jacobian, other.jacobian)


# -- a sequence ------------------------------------------------------------------------------------------


def test_it_is_a_sequence_of_orbits(orbits):
    assert isinstance(orbits, Sequence)
    assert len(orbits) == len(list(orbits)) >= 4
    assert all(isinstance(orbit, Orbit) for orbit in orbits)
    assert orbits[-1] == orbits[len(orbits) - 1] == list(orbits)[-1]
    assert orbits[np.int64(1)] == orbits[1]
    assert next(reversed(orbits)) == orbits[-1]
    assert orbits[1] in list(orbits)
    for index in (len(orbits), -len(orbits) - 1):
        with pytest.raises(IndexError, match=f"there is no cycle {index}: there are {len(orbits)}"):
            orbits[index]


def test_an_orbit_is_a_row(orbits):
    for i, orbit in enumerate(orbits):
        assert orbit.model is orbits.model
        assert list(orbit.params.values()) == orbits.params[i].tolist()
        assert [*orbit.state.values(), orbit.period] == orbits.u[i].tolist()
        assert list(orbit.state) == list(orbits.model.section)
        assert list(orbit.multipliers) == orbits.multipliers[i].tolist()
        assert orbit.status is orbits.status[i] is Status.CONVERGED
        for name in MEASURED:
            assert getattr(orbit, name) == getattr(orbits, name)[i], name
            assert not isinstance(getattr(orbit, name), np.generic), name
        np.testing.assert_array_equal(parameters(orbit), orbits.params[i])


def test_some_of_them(orbits):
    every = list(orbits)
    assert list(orbits[1:3]) == every[1:3]
    assert list(orbits[::-1]) == every[::-1]
    assert list(orbits[[2, 0]]) == list(orbits.take([2, 0])) == [every[2], every[0]]
    assert list(orbits[orbits.stable]) == [orbit for orbit in every if orbit.stable]
    assert list(orbits[orbits.period > 1.2]) == [orbit for orbit in every if orbit.period > 1.2]
    for nothing in ([], np.zeros(len(orbits), dtype=bool), slice(2, 2), np.array([], dtype=int)):
        assert len(orbits[nothing]) == 0
        assert list(orbits[nothing].columns()) == list(orbits.columns())
    assert 0 < len(orbits[orbits.stable]) < len(orbits)


def test_parts_put_together(orbits):
    assert_same(Orbits.concatenate(orbits.model, [orbits[:2], orbits[2:3], orbits[3:]]), orbits)
    assert_same(Orbits.concatenate(orbits.model, [orbits, Orbits.empty(orbits.model)]), orbits)
    none = Orbits.concatenate(orbits.model, [])
    assert len(none) == 0
    assert list(none.columns()) == list(orbits.columns())
    assert {n: c.dtype for n, c in none.columns().items()} == {
        n: c.dtype for n, c in orbits.columns().items()
    }


def test_failures_are_entries_that_say_why(mixed):
    assert set(mixed.status) == set(GUESSES)
    assert mixed.found.tolist() == [status.found for status in mixed.status]
    for orbit in mixed:
        assert (orbit.state == {}) == (not orbit.status.found)
        assert orbit.residual >= 0 or np.isnan(orbit.residual)
    failed = mixed[~mixed.found]
    assert np.isnan(failed.multipliers).all()
    assert np.isnan(failed.cot).all()
    assert not failed.stable.any()
    assert set(failed.group) == {None}


def test_unknown_attributes_are_named(orbits):
    with pytest.raises(AttributeError, match="Orbits have no attribute 'costs'; measured are .*cot"):
        orbits.costs  # noqa: B018
    assert {"cot", "period", "to_frame", "status"} <= set(dir(orbits))


# -- columns ---------------------------------------------------------------------------------------------


def test_the_table_has_the_columns_of_a_sweep(orbits, mixed):
    for some in (orbits, mixed, find_orbits("compass"), Orbits.empty(load("compass"))):
        frame = some.to_frame()
        of_sweeps = [name for name in orbit_schema(some.model).names if name not in ("cell", "branch")]
        assert list(frame.columns) == of_sweeps
        assert len(frame) == len(some)
    frame = orbits.to_frame()
    assert frame["period"].tolist() == orbits.period.tolist()
    assert frame["multiplier_1_im"].tolist() == orbits.multipliers[:, 1].imag.tolist()
    assert frame["status"].tolist() == ["converged"] * len(orbits)
    assert frame["stable"].dtype == "boolean"
    assert frame["peaks"].dtype == np.int64


def test_columns_go_there_and_back(orbits, mixed):
    for some in (orbits, mixed, find_orbits("compass"), Orbits.empty(load("compass"))):
        again = Orbits.from_columns(some.model, some.columns())
        for name, column in some.columns().items():
            np.testing.assert_array_equal(again.columns()[name], column, err_msg=name)
        assert np.isnan(again.jacobian).all()


def test_a_frame_goes_back_too(orbits):
    again = Orbits.from_columns(orbits.model, orbits.to_frame())
    assert list(again) == list(orbits)


def test_nulls_of_any_kind_become_none(orbits):
    frame = orbits.to_frame()
    for null in (None, np.nan, pd.NA):
        columns = frame.assign(
            group=pd.array([null] * len(frame), dtype=object),
            x_zero_crossings=pd.array([None] + [3] * (len(frame) - 1), dtype="Int64"),
        )
        again = Orbits.from_columns(orbits.model, columns)
        assert again.group.tolist() == [None] * len(frame)
        assert again.x_zero_crossings.tolist() == [None] + [3] * (len(frame) - 1)
        assert again[1].group is None
        assert type(again[1].x_zero_crossings) is int


def test_columns_that_are_not_known_are_missing_values(orbits):
    names = [*orbits.model.spec.names, *orbits.model.section, "period", "status"]
    bare = Orbits.from_columns(orbits.model, {name: orbits.columns()[name] for name in names})
    assert np.isnan(bare.multipliers).all()
    assert np.isnan(bare.cot).all()
    assert bare.group.tolist() == [None] * len(bare)
    assert [orbit.section_point for orbit in bare] == [orbit.section_point for orbit in orbits]


def test_pickles(orbits, mixed):
    for some in (orbits, mixed, Orbits.empty(orbits.model)):
        again = pickle.loads(pickle.dumps(some))
        assert again.model.hash == some.model.hash
        for name, column in some.columns().items():
            np.testing.assert_array_equal(again.columns()[name], column, err_msg=name)
        np.testing.assert_array_equal(again.jacobian, some.jacobian)


# -- shown -----------------------------------------------------------------------------------------------


def test_repr_has_a_line_for_each(orbits):
    first, *lines, last = repr(orbits).splitlines()
    assert first == f"<{len(orbits)} limit cycles of wobbling"
    assert last == ">"
    assert len(lines) == len(orbits)
    for i, (line, orbit) in enumerate(zip(lines, orbits, strict=True)):
        assert line.startswith(f"  {i}: limit cycle, group {orbit.group}, period {orbit.period:.6g}, ")
    assert repr(Orbits.empty(orbits.model)) == "<0 limit cycles of wobbling>"
    assert repr(orbits[:1]).startswith("<1 limit cycle of wobbling\n")


def test_html_escapes_and_leaves_out_what_the_model_lacks(orbits):
    text = orbits._repr_html_()
    assert text.count("<tr>") == len(orbits) + 2  # names and units
    assert "<td>sqrt(L/g)</td>" in text
    assert "<th>group</th>" in text
    assert f"<td>{orbits[0].period:.6g}</td>" in text
    measures = {**orbits.measures, "group": np.array(["<b>&"] * len(orbits), dtype=object)}
    hostile = Orbits(
        orbits.model, orbits.params, orbits.u, orbits.codes, orbits.jacobian, orbits.multipliers, measures
    )
    assert "<b>" not in hostile._repr_html_()
    assert "&lt;b&gt;&amp;" in hostile._repr_html_()
    assert "<th>group</th>" not in find_orbits("compass")._repr_html_()
    assert "0 limit cycles of compass" in Orbits.empty(load("compass"))._repr_html_()
