"""Conditions: pandas' own selections on made-up rows, Kleene's logic for gaps, and what is refused."""

import numpy as np
import pandas as pd
import pytest

from stridemap.errors import InputError
from stridemap.tables.table import Table

FRAME = pd.DataFrame(
    {
        "k": [1.0, 6.0, 12.0, np.nan, 3.0],
        "n": [1, 2, 3, 4, 5],
        "cot": [0.2, 0.3, np.nan, 0.1, 0.0],
        "stable": pd.array([True, False, None, True, False], dtype="boolean"),
        "gait": [True, True, False, False, True],
        "group": ["A", "B", None, "B", "it's & so"],
    }
)
TABLE = Table.of_frame(FRAME)


def rows(condition):
    return TABLE.where(condition).frame.index.tolist()


@pytest.mark.quick
@pytest.mark.parametrize(
    ("condition", "wanted"),
    [
        ("k < 10", [0, 1, 4]),
        ("0 < k <= 6", [0, 1, 4]),
        ("10 > k", [0, 1, 4]),
        ("stable", [0, 3]),
        ("not stable", [1, 4]),
        ("~stable", [1, 4]),
        ("stable == False", [1, 4]),
        ("not (k < 10)", [2]),  # a gap is not known, and neither is its opposite
        ("not not (k < 10)", [0, 1, 4]),
        ("cot < 1 or cot >= 1", [0, 1, 3, 4]),
        ("stable or gait", [0, 1, 3, 4]),  # not known or no: not known; not known or yes: yes
        ("stable and gait", [0]),
        ("k < 10 & stable", [0]),  # as in a query of pandas
        ("stable | n == 5", [0, 3, 4]),
        ("k < 10 && stable || n == 3", [0, 2]),
        ("group == 'B'", [1, 3]),
        ('group != "B"', [0, 4]),
        ("group in ('A', 'B')", [0, 1, 3]),
        ("group not in ['A', 'B']", [4]),
        ('group == "it\'s & so"', [4]),
        ("n in (1, 3)", [0, 2]),
        ("n % 2 == 0", [1, 3]),
        ("abs(k - 6) <= 5", [0, 1, 4]),
        ("k / cot > 15", [1, 4]),  # 6/0.3 = 20, and 3/0 is infinite
        ("cot / cot == 1", [0, 1, 3]),  # 0/0 is a gap
        ("not (cot / cot == 1)", []),
        ("-k < -2", [1, 2, 4]),
        ("2 ** n > 8", [3, 4]),
        ("k<10 and\n n>1", [1, 4]),
    ],
)
def test_conditions(condition, wanted):
    assert rows(condition) == wanted


@pytest.mark.quick
@pytest.mark.parametrize(
    ("condition", "sentence"),
    [
        ("", "'' is not a condition; write columns"),
        (3, "3 is not a condition"),
        ("k", "it is a value and not a condition; compare it with something"),
        ("k and stable", "'k' is a value and not a condition"),
        ("k = 6", "equality is written =="),
        ("stabel", r"there is no column stabel \(did you mean stable\?\); columns are k, n, cot"),
        ("k <", "it breaks off or has something superfluous"),
        ("import os", "it breaks off or has something superfluous at character"),
        ("__import__('os').system('true')", "is not allowed"),
        ("exec('1') == 1", r"exec\(\) is not a function here; only abs\(\) is"),
        ("k.values > 3", "'k.values' is not allowed"),
        ("k[0] > 3", "is not allowed"),
        ("(lambda: k)() > 1", "is not allowed"),
        ("k is None", "is not allowed"),
        ("group < 3", "compares a text with a number; texts stand in quotation marks"),
        ("stable < 3", "compares a truth with a number"),
        ("group + 1 > 3", "'group' is not a number, so that it cannot be computed with"),
        ("9**9**9 < k", "a power of 387420489 is too high"),
        ("'a' < 'b'", "names no column"),
        ("k in 3", "in takes a list"),
        ("k < 1" + " and k < 1" * 200, "more than 1,000 characters"),
        ("(" * 400 + "k" + ")" * 400 + "< 1", "."),
        ("not " * 240 + "stable", "^$|."),
    ],
)
def test_what_is_refused_is_one_sentence(condition, sentence):
    try:
        TABLE.where(condition)
    except InputError as error:
        assert "\n" not in str(error)
        assert pd.Series([str(error)]).str.contains(sentence).all(), str(error)
    else:
        assert condition == "not " * 240 + "stable"  # deep, but understood


def test_no_row_of_an_empty_table():
    assert len(Table.of_frame(FRAME[:0]).where("k < 10 and stable")) == 0
