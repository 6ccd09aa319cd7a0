"""One sweep and the cycles of one point, which the tests of tables have in common."""

import pytest

import stridemap
from stridemap.sweeps.config import parse_config
from stridemap.sweeps.run import sweep
from tests.oracles.shared import once
from tests.oracles.sweeping import Inline

GRID = {"k": [4.0, 6.0, 8.0], "alpha": [0.2, 0.25]}


@pytest.fixture(scope="session")
def swept(common):
    """The folder of a small sweep of the wobbling walker, whose cells have no, one or several cycles."""

    def make(folder):
        config = {"model": "wobbling", "grid": GRID, "search": {"starts": 8}}
        sweep(parse_config(config), folder / "out", executor=Inline())

    once(common / "swept_for_tables", make)
    return common / "swept_for_tables" / "out"


@pytest.fixture(scope="session")
def table(swept):
    return stridemap.read_table(swept)


@pytest.fixture(scope="session")
def orbits():
    return stridemap.find_orbits("wobbling", k=6, alpha=0.25, omega=3)
