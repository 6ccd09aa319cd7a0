"""The list of changes that the tests must notice (`python -m tests.mutate`) fits the files as they are."""

import ast
from functools import cache

import pytest

from tests.mutations import MUTATIONS
from tests.mutations.mutation import ROOT

pytestmark = pytest.mark.quick


@cache
def functions(file):
    """Names of the tests in a file."""
    tree = ast.parse((ROOT / file).read_text("utf-8"))
    return {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}


def test_every_change_can_be_applied():
    for one in MUTATIONS:
        assert one.old != one.new
        assert one.new in one.applied()  # which raises where the old text does not occur once


def test_every_test_that_is_named_exists():
    for one in MUTATIONS:
        assert one.tests, one.breaks
        for test in one.tests:
            file, _, name = test.partition("::")
            assert (ROOT / file).is_file(), test
            assert not name or name.partition("[")[0] in functions(file), test


def test_there_are_many_and_no_two_are_the_same():
    assert len(MUTATIONS) >= 60
    assert len({(one.file, one.old, one.new) for one in MUTATIONS}) == len(MUTATIONS)
    assert len({one.breaks for one in MUTATIONS}) == len(MUTATIONS)
