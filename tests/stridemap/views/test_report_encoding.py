"""Columns of the page: few bytes, and every digit that is shown is that of the table."""

import numpy as np
import pandas as pd
import pytest

from stridemap.views.report.encoding import Encoder, base85
from tests.oracles.page_tables import ALPHABET, Tables

RNG = np.random.default_rng(5)


def carried(values, state=False):
    """A column as the page gets it, and its description."""
    encoder = Encoder()
    table = encoder.table(pd.DataFrame({"a": values}), ["a"] if state else [])
    return Tables(encoder.packed()).column(table, "a"), table["columns"]["a"]


def shown(value, state):
    if state:
        return f"{value:.12f}"
    return f"{value:.10f}" if value == 0 or abs(value) >= 1e-3 else f"{value:.3e}"


@pytest.mark.parametrize("state", [False, True])
@pytest.mark.parametrize(
    "values",
    [
        RNG.uniform(-2, 2, 3000),
        RNG.uniform(-1e-2, 1e-2, 3000),
        10.0 ** RNG.uniform(-9, 3, 3000),
        10.0 ** RNG.uniform(-20, -4, 3000) * RNG.choice([-1, 1], 3000),
        RNG.normal(0, 1e-14, 3000),
        np.concatenate([RNG.uniform(0, 1, 3000), [1e300, -1e19, 5e-324, 1e-9, 123456.789]]),
        np.array([0.0, -0.0, 1.0, 0.5]),
        np.array([3.3]),
    ],
)
def test_the_digits_that_are_shown_are_those_of_the_table(values, state):
    found, _ = carried(values, state)
    assert [shown(v, state).lstrip("-") for v in found] == [shown(v, state).lstrip("-") for v in values]
    large = np.abs(values) > 1e-9
    assert np.array_equal(np.sign(found)[large], np.sign(values)[large])


def test_states_keep_fifteen_decimals_and_the_twelve_that_are_shown():
    """With three decimals more they are rounded twice: 0.1234567890125|4 and |49999 differ in the twelfth."""
    twelve = [f"0.{digits}" for digits in RNG.integers(10**11, 10**12, 1500)]
    near = [
        float(f"{text}{more}") * sign
        for text in twelve
        for more in ("4999", "5001", "4996", "5004")
        for sign in (1, -1)
    ]
    found, _ = carried(np.array(near), True)
    assert [f"{v:.12f}" for v in found] == [f"{v:.12f}" for v in near]
    assert np.abs(np.array(found) - near).max() < 1.6e-15


def test_near_a_half_the_decimal_expansion_decides():
    """Products with a power of ten are rounded: these lie on the other side of a half than their products."""
    near = [float(f"0.{digits}5") for digits in RNG.integers(10**9, 10**10, 3000)]
    near += [np.nextafter(v, side) for v in near for side in (0, 1)]
    found, _ = carried(np.array(near))
    assert [f"{v:.10f}" for v in found] == [f"{v:.10f}" for v in near]


def test_small_numbers_are_rounded_once():
    """1.23449996e-5 is 1.234e-5; with ten decimals first it would be 0.0000123450, and then 1.235e-5."""
    found, column = carried(np.array([1.23449996e-5, *RNG.uniform(0.1, 1, 60)]))
    assert column["decimals"] == 10
    assert f"{found[0]:.3e}" == "1.234e-05"


def test_gaps_infinities_and_whole_numbers():
    values = [1.5, np.nan, np.inf, -np.inf, *[0.25] * 60]
    found, _ = carried(np.array(values))
    assert found[:4] == [1.5, None, np.inf, -np.inf]
    whole = pd.array([3, None, 70_000, -2], dtype="Int64")
    found, column = carried(whole)
    assert found == [3, None, 70_000, -2]
    assert column["whole"]
    found, column = carried(np.array([0, 0, 1, 5, 5, 300]))
    assert found == [0, 0, 1, 5, 5, 300]
    assert column["planes"] == 2
    assert carried(np.array([np.nan, np.nan]))[0] == [None, None]


def test_what_no_decimals_can_stand_for_is_in_double_precision():
    values = np.concatenate([10.0 ** RNG.uniform(-300, 300, 500), RNG.uniform(0, 1, 100)])
    found, column = carried(values)
    assert "double" in column
    assert np.array_equal(found, values)


def test_words_and_truth_stand_where_they_stand_in_the_table():
    words = ["found", "empty", "failed", None, "empty", "found"]
    assert carried(pd.Series(words))[0] == words
    assert carried(pd.Series([None] * 3, dtype=object))[0] == [None] * 3
    known = pd.array([True, None, False], dtype="boolean")
    assert carried(known)[0] == [True, None, False]
    assert carried(np.array([True, False]))[0] == [True, False]


def test_the_alphabet_is_harmless():
    text = base85(RNG.bytes(20_000))
    assert set(text) <= set(ALPHABET)
    assert len(set(ALPHABET)) == 85
    assert not set("\"\\<&'{(@/ ") & set(text)
    assert len(text) == 25_000
