"""Derivation gives the same bytes everywhere, notices drift, and refuses what it cannot print."""

import getpass
import json
import math
import os
import random
import re
import shutil
import socket
import subprocess
import sys
from types import SimpleNamespace

import pytest
import sympy as sp

from stridemap import codegen
from stridemap.derive.elementary import CALLS
from stridemap.derive.printers.c import C
from stridemap.derive.printers.javascript import JavaScript
from stridemap.derive.printers.python import Python
from stridemap.derive.program import Argument, Builder, Entry, Output
from stridemap.solver.model.loading import available, load
from tests.derive.test_afresh import SMALL

GENERATED = codegen.generated_folder()
x, y, z = sp.symbols("x y z", real=True)

MODELS = available()
LARGE = [name for name in MODELS if name not in SMALL]


def contents(folder):
    """Bytes by name of what belongs to a generated folder."""
    files = [path for path in folder.glob("*/*") if path.is_file() and path.suffix != ".pyc"]
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


# -- the same bytes ------------------------------------------------------------------------------------------

ELSEWHERE = {"USER": "somebody", "HOME": "/nonexistent", "TZ": "Asia/Tokyo", "LC_ALL": "C", "COLUMNS": "40"}


def python(code, folder, seed, **environment):
    """Run code in a fresh interpreter with that hash seed, in `folder`."""
    variables = {**os.environ, "PYTHONHASHSEED": str(seed), **environment}
    return subprocess.Popen(
        [sys.executable, "-c", code], cwd=folder, env=variables, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    )  # fmt: skip


def result(process):
    out, complaint = process.communicate(timeout=300)
    assert process.returncode == 0, complaint
    return out


def test_another_derivation_writes_what_is_committed_and_drift_names_the_rest(tmp_path):
    """The large models, with a hash seed and surroundings of its own.

    What is committed was derived with another seed; `make derive` in CI has a further one, and so has
    `test_afresh`, where the small models are.
    """
    expected = damage(tmp_path, LARGE)
    code = "import pathlib; from stridemap import codegen\n"
    code += f"codegen.WALKERS = {{name: codegen.WALKERS[name] for name in {LARGE}}}\n"
    code += "print(*codegen.drift(pathlib.Path('.')))"
    # The drift is what was damaged and nothing else, so all other files are the same bytes.
    assert result(python(code, tmp_path, 1, **ELSEWHERE)).split() == expected


def damage(folder, models=MODELS):
    """Copy what is committed and edit one file, remove one and add one; returns their names, sorted."""
    for name in models:
        shutil.copytree(GENERATED / name, folder / name, ignore=shutil.ignore_patterns("*.pyc"))
    edited, missing, extra = "goswami_compass/goswami_compass.c", "wobbling/example.c", "wobbling/notes.txt"
    text = (folder / edited).read_text()
    (folder / edited).write_text(text.replace("2*beta", "3*beta", 1))
    (folder / missing).unlink()
    (folder / extra).write_text("mine\n")
    return sorted([edited, missing, extra])


def test_drift_of_each_kind(tmp_path, monkeypatch):
    monkeypatch.setattr(codegen, "derive", rewrite)  # the real one runs above
    damaged, whole, empty = (tmp_path / name for name in ("damaged", "whole", "empty"))
    shutil.copytree(GENERATED, whole)
    empty.mkdir()
    assert codegen.drift(whole) == codegen.drift() == []
    assert codegen.drift(empty) == sorted(contents(GENERATED))
    expected = damage(damaged)
    before = contents(damaged)
    assert codegen.drift(damaged) == expected
    assert contents(damaged) == before  # looking changes nothing


def rewrite(folder):
    shutil.copytree(GENERATED, folder, dirs_exist_ok=True)
    return [folder / name for name in contents(GENERATED)]


def test_the_manifest_names_every_file():
    names = {name.split("/")[0] for name in contents(GENERATED)}
    assert names == set(MODELS)
    for name in MODELS:
        files = {path.split("/")[1] for path in contents(GENERATED) if path.startswith(f"{name}/")}
        manifest = json.loads((GENERATED / name / "manifest.json").read_text())
        assert files == {*manifest["files"], "manifest.json"}
        for file in manifest["files"]:
            load(name).text(file)  # raises where the hash is another


def test_generated_text_is_plain_and_names_no_time_host_user_or_path():
    private = {socket.gethostname(), getpass.getuser(), str(GENERATED.parent), os.path.expanduser("~")}
    words = [re.escape(word) for word in private - {"root", "localhost", "/"}]
    words += [r"/(home|root|tmp|usr|var|opt|mnt|Users)/", r"[A-Z]:\\", r"\d{4}-\d\d-\d\d", r"\d\d:\d\d"]
    for name, data in contents(GENERATED).items():
        text = data.decode("ascii")
        assert "\r" not in text and "\t" not in text and text.endswith("\n"), name
        found = re.search("|".join(rf"(?<!\w){word}" for word in words), text)
        assert found is None, f"{name} holds {found}"


@pytest.mark.parametrize("name", MODELS)
def test_each_file_says_what_made_it_and_that_it_is_not_to_be_edited(name):
    for file in load(name).spec.files:
        head = (GENERATED / name / file).read_text()[:400]
        assert re.search("do not edit", head, flags=re.IGNORECASE) and "stridemap derive" in head, file
        assert file == "README.md" or "SPDX-License-Identifier: BSD-3-Clause" in head, file
        assert not file.endswith((".c", ".h", ".js")) or load(name).hash[:16] in head, file


# -- what cannot be printed ----------------------------------------------------------------------------------

UNKNOWN = {
    sp.Abs(x): "cannot print Abs in Abs(x): generated code has + - * /, powers, sin, cos, tan, asin, acos",
    x + sp.sign(y): "cannot print sign in sign(y): generated code has",
    2 * sp.atan2(y, x): "cannot print atan2 in atan2(y, x)",
    sp.Max(x, y): "cannot print Max",
    sp.Piecewise((x, x > 0), (y, True)): "cannot print Piecewise",
    sp.E * x: "cannot print Exp1 in E",
    sp.floor(x): "cannot print floor in floor(x)",
    x**9: "cannot print the power (x)**(9): generated code has exponents up to 8 that are integers or halves",
    x ** sp.Rational(3, 4): "cannot print the power (x)**(3/4)",
    x ** sp.Rational(17, 2): "cannot print the power (x)**(17/2)",
    x ** sp.Rational(-1, 3): "cannot print the power (x)**(1/3)",
    1 / x**9: "cannot print the power (x)**(9)",
    x**y: "cannot print the power (x)**(y)",
    2**x: "cannot print the power (2)**(x)",
    sp.Float(0.5) * x: "cannot print the number 0.5",
    sp.oo: "cannot print the number oo",
    sp.nan: "cannot print the number nan",
    sp.zoo * x: "cannot print ComplexInfinity",
    sp.I * x: "cannot print ImaginaryUnit",
}


@pytest.mark.parametrize(("expr", "sentence"), UNKNOWN.items(), ids=map(str, UNKNOWN))
@pytest.mark.parametrize("printer", [C(), Python(), JavaScript()], ids=["C", "Python", "JavaScript"])
def test_the_printer_refuses_what_it_does_not_know(printer, expr, sentence):
    with pytest.raises(TypeError) as refusal:
        printer.expression(expr)
    assert str(refusal.value).startswith(sentence)


def random_expression(rng, depth):
    """Sums, products, quotients, powers and calls of x, y, z and fractions."""
    if depth == 0:
        return rng.choice([x, y, z, sp.Integer(rng.randint(-3, 3)), sp.Rational(rng.randint(-5, 5), 4)])
    a, b = random_expression(rng, depth - 1), random_expression(rng, depth - 1)
    forms = [a + b, a - b, a * b, -a * b, a / b if b else a, sp.sin(a), a * b**2, (a - b) * a]
    root = 1 + b * b
    forms += [
        sp.pi * a,
        a / sp.sqrt(root),
        root ** sp.Rational(3, 2),
        sp.tanh(a),
        sp.atan(b),
        sp.asin(1 / root),
    ]
    return rng.choice(forms)


def test_what_is_printed_is_the_expression():
    rng, values = random.Random(5), {x: 0.37, y: -1.21, z: 2.13}
    names = {name: getattr(math, name) for name in ("sqrt", "pi", *CALLS.values())}
    scope = {"xp": SimpleNamespace(**names), **names, **{s.name: value for s, value in values.items()}}
    scope |= {"REAL": float, **{name.upper(): value for name, value in names.items()}}  # as C has them
    printed = 0
    for _ in range(200):
        expr = random_expression(rng, rng.randint(1, 4))
        try:
            texts = C().expression(expr), Python().expression(expr)
        except TypeError as refusal:
            assert "power" in str(refusal) or expr.has(sp.zoo, sp.nan), expr
            continue
        expected = float(expr.evalf(30, subs=values))
        for text in texts:
            value = eval(text, scope)
            assert abs(value - expected) <= 1e-11 * (1 + abs(expected)), f"{expr} is not {text}"
        # C would read -- as a decrement, 1/2 as 0, and ** not at all.
        assert not re.search(r"--|\+\+|\*\*|(?<![\w.])\d+/\d", texts[0]), texts[0]
        printed += 1
    assert printed > 150


# -- programs ------------------------------------------------------------------------------------------------


def arguments(*symbols):
    return (Argument("q", tuple(Entry(s, "1", "an entry") for s in symbols)),)


def building(*entries):
    return Builder(arguments(*(entries or (x, y, z))))


def close(builder, *outputs):
    named = [Output(f"out{i}", sp.sympify(value), "a result") for i, value in enumerate(outputs)]
    return builder.close("function", "A function", "a source", named)


def test_two_terms_of_one_name_are_refused():
    builder = building()
    builder.let("speed", x + y)
    with pytest.raises(ValueError, match="^two intermediate terms are named speed$"):
        builder.let("speed", x - y)


def assert_computes(program, values, *expected):
    """The program has distinct names and gives what is expected."""
    names = [s.name for s, _ in program.statements] + [e.symbol.name for e in program.arguments[0].entries]
    assert len(names) == len(set(names))
    for value, expr in zip(evaluated(program, values), expected, strict=True):
        assert abs(value - expr.evalf(30, subs=values)) < 1e-14


def test_sines_and_cosines_have_names_of_their_own():
    program = close(building(), sp.cos(x * y) + sp.cos(x / y))  # both would be c_x_y
    assert {"c_x_y", "c_x_y_"} <= {s.name for s, _ in program.statements}
    assert_computes(program, {x: 0.3, y: 0.5}, sp.cos(x * y) + sp.cos(x / y))


@pytest.mark.parametrize("name", ["c_x", "x", "q", "out0", "t1"])
def test_a_term_named_like_something_else_is_renamed(name):
    builder = building()
    product = x * y + z
    term = builder.let(name, product)
    program = close(builder, term * sp.cos(x), (y + z) * sp.sin(y + z) * term)
    values = {x: 0.3, y: 0.5, z: 0.7}
    assert_computes(program, values, product * sp.cos(x), (y + z) * sp.sin(y + z) * product)


@pytest.mark.parametrize("name", ["c_x", "t1", "M_11", "c_x_"])
def test_an_entry_named_like_a_term_keeps_its_name(name):
    entry = sp.Symbol(name, real=True)
    builder = building(x, y, entry)
    matrix = builder.let_symmetric("M", sp.Matrix([[x + y * entry]]))
    shared = sp.sin(x + y) * (y + entry) / (x + entry)
    program = close(builder, matrix[0] * sp.cos(x) * shared, shared + entry)
    values = {x: 0.3, y: 0.5, entry: 0.7}
    assert_computes(program, values, (x + y * entry) * sp.cos(x) * shared, shared + entry)


def test_an_undeclared_symbol_is_refused():
    with pytest.raises(ValueError, match=r"^function uses \['z'\], which no argument or term defines$"):
        close(building(x, y), x + z)


def evaluated(program, values):
    """Run a program's statements as they stand; a term used before it is there is an error."""
    known = {symbol: sp.Float(value, 30) for symbol, value in values.items()}
    for symbol, expr in program.statements:
        assert expr.free_symbols <= known.keys() and symbol not in known
        known[symbol] = expr.xreplace(known).evalf(30)
    return [e.xreplace(known).evalf(30) for o in program.outputs for e in o.entries]


def test_a_shared_term_takes_no_name_that_is_in_use():
    builder = building()
    first = builder.let("t1", x * y + z)  # t1 is how shared terms are named
    shared = sp.sin(x) * (y + z) / (x + z)
    program = close(builder, first * shared, shared + 1, shared * first**2)
    names = [s.name for s, _ in program.statements]
    assert len(names) == len(set(names)) and "t2" in names
    values = {x: 0.3, y: 0.5, z: 0.7}
    expected = [(x * y + z) * shared, shared + 1, shared * (x * y + z) ** 2]
    for value, expr in zip(evaluated(program, values), expected, strict=True):
        assert abs(value - expr.evalf(30, subs=values)) < 1e-14


def test_a_shared_term_that_is_a_named_one_bears_its_name():
    builder = building()
    matrix = builder.let_symmetric("M", sp.Matrix([[x, y * (x + z)], [y * (x + z), y]]))
    program = close(builder, matrix, 1 / (y * (x + z)))
    symbol, expr = program.statements[0]
    assert (symbol.name, str(expr)) == ("M_12", "y*(x + z)")
    assert str(program.outputs[0].value) == "Matrix([[x, M_12], [M_12, y]])"


def test_unused_arguments_are_dropped():
    extra = Argument("p", (Entry(z, "1", "unused"),))
    program = Builder((*arguments(x, y), extra)).close("f", "F", "a source", [Output("out", x, "x")])
    assert [a.name for a in program.arguments] == ["q"]
