"""The generated JavaScript, run by Node or a browser: the numbers of the Python module at random states."""

import json
import shutil
import subprocess

import numpy as np
import pytest
import sympy as sp

from stridemap.derive.printers.javascript import JavaScript
from stridemap.derive.program import Argument, Builder, Entry, Output
from stridemap.derive.validate import reserved
from stridemap.solver.model.loading import load
from tests.oracles.states import BROWSERS, MODELS, error_bounds, need, states

COUNT = 200
FLAGS = ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"]


RUN = """
const [code, argument] = JSON.parse(require("fs").readFileSync(0, "utf8"));
const value = (0, eval)(code);
process.stdout.write(JSON.stringify(typeof value === "function" ? value(argument) : value));
"""


@pytest.fixture(scope="module")
def evaluate():
    """Evaluates an expression, and calls it with an argument where it is a function."""
    path = need("node", *BROWSERS)
    if path == "node":
        yield in_node
        return
    api = pytest.importorskip("playwright.sync_api")
    with api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which(path), args=FLAGS)
        yield browser.new_page().evaluate
        browser.close()


def in_node(code, argument=None):
    given = json.dumps([code, argument])
    done = subprocess.run(["node", "-e", RUN], input=given, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@pytest.mark.parametrize("name", MODELS)
def test_every_function_gives_the_results_of_the_python_module(name, evaluate):
    model = load(name)
    text = model.text(f"{name}.js")
    assert evaluate(f"Object.keys({text})") == list(model.spec.functions)
    values = states(name, COUNT)
    plain = {key: np.asarray(value).tolist() for key, value in values.items()}
    found = evaluate(
        f"""([inputs, order]) => {{
            const equations = {text};
            return Object.fromEntries(Object.entries(order).map(([name, args]) => [name,
                inputs.t.map((_, i) => equations[name](Math, ...args.map((a) => inputs[a][i])))]));
        }}""",
        [plain, {f: spec.arguments for f, spec in model.spec.functions.items()}],
    )
    for function, spec in model.spec.functions.items():
        wanted = model.evaluate(function, **values)
        bounds = error_bounds(getattr(model.equations, function), values)
        for out in spec.outputs:
            seen = np.array([row[out.name] for row in found[function]], dtype=float)
            assert seen.shape == (COUNT, *out.shape)
            # Both are within their bound of the truth; sines differ in their last bits.
            assert (np.abs(seen - wanted[out.name]) <= 2 * bounds[out.name]).all(), (function, out.name)


def test_it_is_a_banner_and_one_expression(evaluate):
    for name in MODELS:
        banner, _, body = load(name).text(f"{name}.js").partition("({\n")
        assert all(line.startswith("// ") for line in banner.splitlines()) and body.endswith("})\n")
        assert "<" not in body  # it stands in HTML as it is
        assert evaluate(f"typeof ({banner}({{\n{body})") == "object"


def printed(expr, *names):
    entries = tuple(Entry(sp.Symbol(name, real=True), "1", "an entry") for name in names)
    builder = Builder((Argument("q", entries),))
    program = builder.close("f", "F", "a source", [Output("y", expr, "y"), Output("new", expr, "y")])
    return JavaScript().function(program)


def test_reserved_words_are_renamed_by_the_printer(evaluate):
    new, other = sp.Symbol("new", real=True), sp.Symbol("new_", real=True)
    lines = printed(new + 2 * other, "new", "new_")
    assert lines[1:3] == ["  const new__ = q[0];", "  const new_ = q[1];"]
    assert evaluate("({\n%s\n}).f(Math, [3, 5])" % "\n".join(lines)) == {"y": 13, "new": 13}  # noqa: UP031


def test_the_words_are_those_that_the_language_has_taken(evaluate):
    words = [*sorted(reserved.JAVASCRIPT), "theta1", "of", "async"]
    refused = evaluate(
        """words => words.filter((word) => {
            try { new Function("Math", `"use strict"; const ${word} = 1;`); return false; }
            catch { return true; } })""",
        words,
    )
    meant_by_the_code = {"await", "undefined", "Infinity", "NaN"}  # `Math` is the argument
    assert set(refused) == reserved.JAVASCRIPT - meant_by_the_code
