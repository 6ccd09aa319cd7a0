"""Names that are taken: the list is complete, and holds nothing else."""

import inspect
import keyword
import re
import subprocess

import pytest
import typer

import stridemap
from stridemap.cli.app import app
from stridemap.derive import Parameter
from stridemap.derive.models import WALKERS
from stridemap.derive.validate import reserved
from stridemap.errors import InputError
from stridemap.quantities import QUANTITIES
from stridemap.sweeps.tables import cell_schema, orbit_schema
from stridemap.words import CELL_COLUMNS, OPTION_WORDS, column, multiplier_columns
from tests.oracles.states import need

COMPASS = WALKERS["compass"]
TAKEN = sorted(
    {*QUANTITIES, *CELL_COLUMNS, *OPTION_WORDS, *reserved.ARGUMENTS, *reserved.BASE}
    | reserved.C
    | reserved.PYTHON
    | reserved.JAVASCRIPT
)


def options():
    """Every option of the command line, and every argument of the public functions."""
    found = set()
    for command in typer.main.get_command(app).commands.values():
        found |= {"help", *(p.name.rstrip("_") for p in command.params)}
        found |= {word.lstrip("-").replace("-", "_") for p in command.params for word in p.opts}
    public = [getattr(stridemap, name) for name in stridemap.__all__]
    for function in filter(inspect.isfunction, public):
        parameters = inspect.signature(function).parameters.values()
        found |= {p.name for p in parameters if p.kind is not inspect.Parameter.VAR_KEYWORD}
    # `stridemap plot` takes no parameters of a model, whose coordinates are often called x and y.
    return {word for word in found - {"x", "y"} if not word.endswith("_")}


def test_option_words_are_the_options_and_nothing_else():
    measured = {*QUANTITIES, *CELL_COLUMNS}  # these are taken anyway
    assert options() - OPTION_WORDS - measured == set(), "add these to stridemap.words.OPTION_WORDS"
    assert OPTION_WORDS - options() == set(), "take these out of stridemap.words.OPTION_WORDS"


@pytest.mark.parametrize("schema", [orbit_schema, cell_schema])
def test_every_column_of_a_table_is_taken_but_those_of_the_model(schema):
    model = stridemap.load("wobbling")
    own = {*model.preset, *model.section}
    names = set(schema(model).names)
    assert {name for name in names - own if column(name) is None} == set()
    assert {name for name in own if column(name) is not None} == set()
    assert set(multiplier_columns(0)) <= set(orbit_schema(model).names)


def test_keywords_and_the_headers_of_c_are_taken(tmp_path):
    assert reserved.PYTHON == set(keyword.kwlist)
    headers = ("math", "complex", "stdio", "stdlib", "errno", "assert", "stdbool")
    source = tmp_path / "headers.c"
    source.write_text("".join(f"#include <{h}.h>\n" for h in headers))
    command = [need("gcc", "clang"), "-std=c99", "-dM", "-E", source]
    macros = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    names = {line.split()[1].partition("(")[0] for line in macros}
    # Error numbers beyond C99's own and limits of files are of no use to a model, and many.
    unlikely = re.compile(r"_\w+|E[A-Z0-9]{2,}|FP_\w+|(TMP|L)_\w+|\w+_MAX|P_tmpdir|MATH_\w+|linux|unix|i386")
    assert {name for name in names if not unlikely.fullmatch(name)} - reserved.C == set()
    assert {"sin", "tgamma", "M_PI", "INFINITY", "I", "stdin", "errno", "bool", "class", "main"} <= reserved.C


def test_a_name_that_is_taken_has_a_meaning_and_a_better_one_has_none():
    for name in TAKEN:
        assert reserved.meaning(name), name
        better = reserved.better(name)
        assert better.isidentifier() and reserved.meaning(better) is None, name


@pytest.mark.parametrize("walker", WALKERS.values(), ids=WALKERS)
def test_what_the_built_in_models_use_is_free(walker):
    own = [*(c.name for c in walker.coordinates), *(c.rate.name for c in walker.coordinates)]
    own += [a.name for a in walker.parameters] + [line.name for line in walker.drawing]
    assert [name for name in own if reserved.meaning(name)] == []


def test_every_kind_of_name_is_looked_at():
    for name in ("speed", "steps", "double"):
        with pytest.raises(InputError, match=f"the parameter {name} has "):
            COMPASS.with_(parameters=(*COMPASS.parameters, Parameter(name, 1.0, "1", "a meaning")))
    for name in ("M", "h", "d", "u", "mass", "length", "com", "foot", "weight", "M_11", "c_theta1", "force"):
        COMPASS.with_(parameters=(*COMPASS.parameters, Parameter(name, 1.0, "1", "a meaning")))


def test_the_old_name_of_unit_names_says_the_new_one():
    with pytest.raises(ImportError, match=r"^stridemap\.derive\.Units is called UnitNames now$"):
        from stridemap.derive import Units  # noqa: F401


def test_a_model_of_ones_own_does_not_take_a_built_in_name():
    """A changed walker needs a name of its own; the very same walker may keep it."""
    with pytest.raises(InputError, match="^model compass: this is the name of a built-in model"):
        stridemap.derive_model(COMPASS.with_(title="Mine"))
    from stridemap.codegen import _own

    assert _own(COMPASS.with_()) == COMPASS


@pytest.mark.parametrize(
    "name", ["stridemap_real", "STRIDEMAP_FLOAT", "linux", "unix", "char16_t", "co_await"]
)
def test_types_and_macros_that_the_c_compiler_or_the_generated_c_defines_are_taken(name):
    assert name in reserved.C
    assert reserved.in_code(name)
