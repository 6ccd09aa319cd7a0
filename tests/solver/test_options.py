"""Records of options: what each refuses, quoting the value, and that TOML says the same words."""

import math
from dataclasses import FrozenInstanceError, fields, replace

import numpy as np
import pytest

from stridemap.errors import InputError
from stridemap.solver.branches.continuation import follow
from stridemap.solver.cycles.search import find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import load
from stridemap.solver.options import IN_SWEEPS, AcceptanceOptions, ContinuationOptions, SearchOptions
from stridemap.sweeps.config import parse_config

pytestmark = pytest.mark.quick

RECORDS = (SearchOptions, AcceptanceOptions, ContinuationOptions)


@pytest.mark.parametrize(
    ("record", "options", "sentence"),
    [
        (SearchOptions, {"starts": 0}, "starts = 0 is not allowed: at least 1 start is needed"),
        (SearchOptions, {"starts": 1_000_001}, "starts = 1,000,001 is not allowed: at most 1,000,000"),
        (SearchOptions, {"starts": 2.5}, "starts = 2.5 .*whole number"),
        (SearchOptions, {"starts": True}, "starts = True .*whole number"),
        (SearchOptions, {"seed": "7"}, "seed = '7' .*whole number"),
        (SearchOptions, {"seed": -1}, "seed = -1 is not allowed"),
        (SearchOptions, {"period_min": 0.0}, "period_min = 0.0 is not allowed"),
        (SearchOptions, {"period_min": 3.0, "period_max": 1.0}, "period range 3 to 1 is not allowed"),
        (SearchOptions, {"period_max": math.inf}, "period_max = inf is not allowed"),
        (SearchOptions, {"period_min": math.nan}, "period_min = nan is not allowed"),
        (SearchOptions, {"period_min": "short"}, "period_min = 'short' is not allowed"),
        (AcceptanceOptions, {"max_residual": 0.0}, "max_residual = 0.0 is not allowed"),
        (AcceptanceOptions, {"max_residual": -1e-9}, "max_residual = -1e-09 is not allowed"),
        (AcceptanceOptions, {"standing_angle": 1}, "standing_angle = 1 is not allowed"),
        (AcceptanceOptions, {"max_integration_error": None}, "max_integration_error = None is not"),
        (
            AcceptanceOptions,
            {"max_integration_error": 1e-12},
            "must not be above max_integration_error = 1e-12",
        ),
        (ContinuationOptions, {"ds_max": 0}, "ds_max = 0 is not allowed"),
        (ContinuationOptions, {"ds": 0.5}, "ds = 0.5 is not allowed: .*above ds_max = 0.05"),
        (ContinuationOptions, {"ds_min": 2.0}, "ds_min = 2.0 is not allowed: .*above ds = 0.01"),
        (
            ContinuationOptions,
            {"step_growth": 0.9},
            "step_growth = 0.9 is not allowed: a finite number above 1 is needed",
        ),
        (ContinuationOptions, {"step_growth": "2"}, "step_growth = '2' is not allowed"),
        (ContinuationOptions, {"step_shrink": 1.0}, "step_shrink = 1.0 is not allowed"),
        (ContinuationOptions, {"max_steps": 0}, "max_steps = 0 is not allowed: .*whole number from 1"),
        (ContinuationOptions, {"max_steps": 3.0}, "max_steps = 3.0 is not allowed"),
        (ContinuationOptions, {"max_corrections": True}, "max_corrections = True is not allowed"),
        (ContinuationOptions, {"min_tangent_cosine": math.nan}, "min_tangent_cosine = nan is not allowed"),
        (ContinuationOptions, {"step_growth": math.inf}, "step_growth = inf is not allowed"),
    ],
)
def test_a_bad_value_is_quoted(record, options, sentence):
    for make in (lambda: record(**options), lambda: record.from_mapping(options)):
        with pytest.raises(InputError, match=sentence) as caught:
            make()
        assert "\n" not in str(caught.value)


@pytest.mark.parametrize("record", RECORDS)
def test_a_word_that_is_not_known_is_named_with_those_that_are(record):
    with pytest.raises(InputError, match="unknown option 'stepsize'; the options are ") as caught:
        record.from_mapping({"stepsize": 1})
    for field in fields(record):
        assert field.name in str(caught.value)


@pytest.mark.parametrize("record", RECORDS)
def test_records_cannot_be_changed_and_are_compared_by_value(record):
    assert record() == record.from_mapping({})
    assert hash(record()) == hash(record())
    name = fields(record)[0].name
    with pytest.raises(FrozenInstanceError):
        setattr(record(), name, getattr(record(), name))


def test_an_arclength_step_may_stay_as_it_is():
    assert ContinuationOptions(step_growth=1).step_growth == 1.0


def test_the_period_range_is_the_models_where_none_is_given():
    wobbling = load("wobbling")
    assert SearchOptions().resolved_for(wobbling).period_range == wobbling.period_range
    mine = SearchOptions(period_min=1).resolved_for(wobbling)
    assert (mine.period_min, mine.period_max) == (1.0, wobbling.period_range[1])
    low, high = mine.wider_period_range
    assert low < 1.0 < high
    assert SearchOptions(period_max=2.0).period_range[0] > 0


# -- the same words in TOML ------------------------------------------------------------------------------

BASE = {"model": "compass", "grid": {"omega": [3.0]}}


def other(value):
    """An allowed value that is not the default."""
    return value + 1 if isinstance(value, int) else value * 1.01 if value else value


@pytest.mark.parametrize(
    ("table", "usual"), [("acceptance", AcceptanceOptions()), ("continuation", IN_SWEEPS)]
)
def test_every_option_is_a_key_of_its_table(table, usual):
    assert getattr(parse_config(BASE), table) == usual
    for field in fields(usual):
        value = other(getattr(usual, field.name)) if field.name != "target_integration_error" else 9e-12
        config = parse_config({**BASE, table: {field.name: value}})
        assert getattr(config, table) == replace(usual, **{field.name: value})
        assert config.config_hash != parse_config(BASE).config_hash
        with pytest.raises(InputError, match=rf"^mine.toml: \[{table}\] {field.name} = -1 is not allowed"):
            parse_config({**BASE, table: {field.name: -1}}, "mine.toml")
    with pytest.raises(InputError, match=rf"\[{table}\] unknown option 'nonsense'; the options are"):
        parse_config({**BASE, table: {"nonsense": 1}})


def test_search_has_the_same_words_and_those_of_a_grid():
    for name, value in {"starts": 7, "seed": 3, "period_min": 0.5, "period_max": 2.5}.items():
        config = parse_config({**BASE, "search": {name: value}})
        resolved = SearchOptions(**{"starts": 64, name: value}).resolved_for(load("compass"))
        assert config.search.options == resolved
    with pytest.raises(InputError, match=r"starts = 0 must be a whole number from 1"):
        parse_config({**BASE, "search": {"starts": 0}})


def test_whole_numbers_and_floats_that_are_equal_have_one_hash():
    one = parse_config({**BASE, "continuation": {"ds_max": 2}})
    assert one.config_hash == parse_config({**BASE, "continuation": {"ds_max": 2.0}}).config_hash


# -- that they are obeyed --------------------------------------------------------------------------------


def test_the_solver_obeys():
    model = load("compass")
    point = model.point({"omega": 3.0})[None]
    solver = Solver.for_model(model)
    _, orbits = find_all(solver, point)
    period = orbits.period[0]
    assert len(find_all(solver, point, SearchOptions(period_min=1.01 * period))[1]) == 0
    assert find_all(solver, point, SearchOptions(seed=5))[1].period[0] == pytest.approx(period, abs=1e-10)
    assert len(find_all(Solver.for_model(model, None, AcceptanceOptions(max_residual=1e-30)), point)[1]) == 0


def test_continuation_obeys():
    model = load("compass")
    points = np.array([model.point({"omega": 3.0}), model.point({"omega": 2.5})])
    solver = Solver.for_model(model)
    _, orbits = find_all(solver, points[:1])
    ends = (np.zeros(len(orbits)), orbits.params, np.repeat(points[1:], len(orbits), axis=0))
    args = (solver, orbits.u, *ends, (0.3, 3.0))
    assert follow(*args).x[:, -1].max() == 1
    assert follow(*args, ContinuationOptions(max_steps=1, ds=1e-2, ds_max=1e-2)).x[:, -1].max() <= 0.01
