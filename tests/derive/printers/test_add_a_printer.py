"""docs/add-a-printer.md, done as it says: the C++ that it prints computes the same."""

import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

from stridemap.derive.emit import PRINTERS, equations
from stridemap.derive.models import WALKERS
from stridemap.solver.model.loading import load
from tests.oracles.states import error_bounds, need, states

COUNT = 50
PAGE = Path(__file__).resolve().parents[3] / "docs" / "add-a-printer.md"
TEXT = PAGE.read_text(encoding="utf-8")
FENCES = re.findall(r"^```(?:\{code-block\} )?python\n(?::caption: (\S+)\n\n)?(.*?)^```$", TEXT, re.M | re.S)


@pytest.fixture(scope="module")
def written():
    return equations(WALKERS["compass"], "stridemap")


@pytest.fixture(scope="module")
def printers():
    """The table with the page's printer in it."""
    (caption, printer), (_, table) = FENCES
    assert caption == "derive/printers/cpp.py"
    scope = {"PRINTERS": PRINTERS}
    exec(compile(printer, caption, "exec"), scope)
    exec(table, scope)
    assert len(scope["PRINTERS"]) == len(PRINTERS) + 1
    return scope["PRINTERS"]


def test_it_computes_what_the_python_module_does(printers, written, tmp_path):
    model = load("compass")
    assert written.hash == model.hash
    (tmp_path / "compass.hpp").write_text(printers["{model}.hpp"](written))
    (tmp_path / "main.cpp").write_text(main(model.spec))
    flags = ["-std=c++17", "-pedantic", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off"]
    command = [need("g++", "clang++"), *flags, "main.cpp", "-o", "main"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    values = states("compass", COUNT)
    rows = np.column_stack([values["t"], *(values[a] for a in "qvupz")])
    given = "\n".join(" ".join(map(repr, row)) for row in rows.tolist())
    printed = subprocess.run([tmp_path / "main"], input=given, capture_output=True, text=True, check=True)
    found = iter(np.array([line.split() for line in printed.stdout.splitlines()], dtype=float).T)
    for name, function in model.spec.functions.items():
        wanted, bounds = model.evaluate(name, **values), error_bounds(getattr(model.equations, name), values)
        for out in function.outputs:
            size = np.prod(out.shape, dtype=int)
            seen = np.stack([next(found) for _ in range(size)], axis=-1).reshape(COUNT, *out.shape)
            assert (np.abs(seen - wanted[out.name]) <= 2 * bounds[out.name]).all(), (name, out.name)
    assert next(found, None) is None


def main(spec):
    """A program that reads states and prints, for each, all results of all functions on one line."""
    sizes = {a: spec.size(a) for a in "tqvupz"}
    lines = ['#include "compass.hpp"', "#include <cstdio>", "int main() {"]
    lines += [f"    double {a}[{size}];" for a, size in sizes.items()]
    lines += ["    const auto read = [](double *x, int n) { int all = 1;"]
    lines += [
        '        for (int i = 0; i < n; i++) all &= std::scanf("%lf", x + i) == 1;',
        "        return all; };",
    ]
    lines += ['    const auto show = [](double x) { std::printf("%.17g ", x); };']
    reading = " && ".join(f"read({a}, {size})" for a, size in sizes.items())
    lines += [f"    while ({reading}) {{"]
    for name, function in spec.functions.items():
        outputs = {o.name: np.prod(o.shape, dtype=int) for o in function.outputs}
        given = ["t[0]" if a == "t" else a for a in function.arguments]
        lines += [f"        {{ double {', '.join(f'{o}_[{size}]' for o, size in outputs.items())};"]
        lines += [f"        compass::{name}<double>({', '.join([*given, *(f'{o}_' for o in outputs)])});"]
        lines += [f"        for (double x : {o}_) show(x);" for o in outputs] + ["        }"]
    return "\n".join([*lines, '        std::puts("");', "    }", "}", ""])


def test_it_refuses_what_generated_code_has_no_form_for(printers):
    cpp = printers["{model}.hpp"].__self__
    x = sp.Symbol("x", real=True)
    assert cpp.expression(sp.sqrt(x) / 3 + sp.pi) == "sqrt(x)/T(3) + T(3.141592653589793238L)"
    with pytest.raises(TypeError, match="cannot print Abs in Abs"):
        cpp.expression(sp.Abs(x))


def test_the_page_is_short():
    assert len(TEXT.splitlines()) <= 90
