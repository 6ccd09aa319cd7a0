"""A finished tile as a table and back."""

import dataclasses

import numpy as np
import pytest

from stridemap.solver.model.loading import load
from stridemap.sweeps.parts import columns_of, counted_columns, part_table, result_of
from stridemap.sweeps.solutions import Links
from stridemap.sweeps.special_tables import special_table_of
from stridemap.sweeps.tables import table_of
from tests.oracles.kernels import needs_compiler
from tests.sweeps.test_tiles import Line

pytestmark = [needs_compiler, pytest.mark.quick]


def same(one, other):
    """Whether two values, or arrays, or records of arrays are equal to the last bit."""
    if dataclasses.is_dataclass(one):
        return all(same(getattr(one, f.name), getattr(other, f.name)) for f in dataclasses.fields(one))
    return np.array_equal(one, other) if isinstance(one, np.ndarray) else one == other


@pytest.mark.parametrize("cells", [[0, 1], [0]])
def test_a_part_is_the_whole_result(cells):
    line = Line((22.0, 22.5, 23.0), {})
    result = line.result([(0, line.cycles(22.0).u[0])], cells=cells)
    model = load("wobbling")
    result = dataclasses.replace(
        result,
        orbits=columns_of(table_of(model, result.orbits)),
        special=columns_of(special_table_of(model, result.special)),
        outgoing=dataclasses.replace(result.outgoing, origin=result.outgoing.cell + 7),
        failures={1: "ValueError: boom", 0: "é, ∞"},
        links=Links(
            np.array([1, 0]),
            np.arange(12.0).reshape(2, 6),
            np.array([2**33, 5]),
            np.array([4, 3]),
            np.array([7, 2**40]),
        ),
        joins=np.array([[5, 7], [1, 2**40]]),
        discarded={(0, "not_a_step"): 3, (1, "later_touchdown"): 1},
    )
    assert len(result.orbits["cell"]) > 0 and len(result.seen) > 0 and len(result.outgoing) > 0
    assert same(result_of(model, result.round, result.tile, part_table(model, result)), result)
    # Without most columns of cycles, what is counted of it is the same.
    part = part_table(model, result)
    few = result_of(model, result.round, result.tile, part.select(counted_columns(model, special=True)))
    assert same(dataclasses.replace(few, orbits={}), dataclasses.replace(result, orbits={}))
    assert {"cell", "branch", "period", "stable"} <= set(few.orbits) < set(result.orbits)
    assert all(same(few.orbits[name], result.orbits[name]) for name in few.orbits)
    nothing = line.result([(0, np.full(6, 1e3))])
    none = columns_of(table_of(model, nothing.orbits))
    special = columns_of(special_table_of(model, nothing.special))
    nothing = dataclasses.replace(nothing, orbits=none, special=special, failures={}, discarded={})
    assert len(none["cell"]) == len(nothing.joins) == len(nothing.links) == 0
    assert same(result_of(model, nothing.round, nothing.tile, part_table(model, nothing)), nothing)
