"""Short forms of expressions that another test has sought already: walkers have most of theirs in common.

What is remembered is what `derive.simplify` itself found for that very expression, so that the equations are
those of a derivation without this. Tests of the derivation itself go without.
"""

import hashlib
import os
import pickle
from contextlib import contextmanager
from functools import cache
from importlib.metadata import version
from pathlib import Path
from unittest import mock

import sympy as sp

from stridemap.derive import normal_form, simplify
from stridemap.derive.terms import Term
from stridemap.solver.backends.compiler import cache_folder

SOUGHT = simplify._simplified


@contextmanager
def remembered():
    """What is derived inside has short forms from earlier derivations of these tests, and leaves its own."""
    with mock.patch.object(simplify, "_simplified", _simplified):
        yield


def _simplified(expr):
    if expr.has(Term):
        return SOUGHT(expr)
    path = (
        cache_folder() / "simplified" / hashlib.sha256(f"{_seekers()} {sp.srepr(expr)}".encode()).hexdigest()
    )
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        half = path.with_suffix(f".{os.getpid()}")
        half.write_bytes(pickle.dumps(SOUGHT(expr)))
        half.replace(path)  # beside and renamed: another process never reads half of it
    return pickle.loads(path.read_bytes())


@cache
def _seekers():
    """What the short forms depend on."""
    sources = [Path(module.__file__).read_bytes() for module in (simplify, normal_form)]
    return version("sympy") + hashlib.sha256(b"".join(sources)).hexdigest()
