"""The recipes docs/add-*.md, done as they say: to a copy of the source, in a process of its own.

The caption of a block says where its text goes: into a new file, or ``above``, ``below`` or ``in place of``
the one line of a file that has the words given, or ``at the end``.
"""

import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PARTS = ("derive", "generated", "solver", "sweeps")
BLOCK = re.compile(
    r"^```(?:\{code-block\} )?(\w+)( no-run)?\n(?::caption: ([^\n]+)\n\n)?(.*?)^```$", re.M | re.S
)
CAPTION = re.compile(
    r"(?P<file>[\w./]+)(?:, (?P<place>above|below|in place of|at the end)(?: `(?P<words>.+)`)?)?"
)

PAGE = """
import shlex, sys
from stridemap.cli.app import main
def stridemap_command(line):
    sys.argv = shlex.split(line, comments=True)
    try:
        main()
    except SystemExit as end:
        assert end.code == 0, line
"""
"""How one process runs all that a page ends with."""

END = "-- next --"


class Copy:
    """A copy of the source with a recipe applied.

    Parameters
    ----------
    folder : pathlib.Path
    page : str
        Name of the recipe, such as ``add-a-measure``.
    """

    def __init__(self, folder, page):
        self.folder = folder
        shutil.copytree(ROOT / "stridemap", folder / "stridemap")  # with bytecode, which saves time
        for part in PARTS:
            shutil.copytree(ROOT / part, folder / "stridemap" / part)
        shutil.copytree(ROOT / "tests", folder / "tests")
        shutil.copy(ROOT / "pyproject.toml", folder)
        self.blocks = BLOCK.findall((ROOT / "docs" / f"{page}.md").read_text("utf-8"))
        self.tests = []
        for _, _, caption, text in self.blocks:
            if caption:
                self.apply(*CAPTION.fullmatch(caption).group("file", "place", "words"), text)

    def path(self, file):
        """Where a file of the repository is in the copy."""
        inside = file.startswith(PARTS)
        return self.folder / "stridemap" / file if inside else self.folder / file

    def apply(self, file, place, words, text):
        """Make one change."""
        path = self.path(file)
        if place is None:
            assert not path.exists(), f"{file} is there already"
            path.write_text(text.lstrip("\n"))
            if file.startswith("tests/"):
                self.tests.append(file)
            return
        lines = path.read_text().splitlines()
        if place == "at the end":
            lines += ["", "", *text.strip("\n").splitlines()]
        else:
            (at,) = [i for i, line in enumerate(lines) if words in line]
            start, stop = {"above": (at, at), "below": (at + 1, at + 1), "in place of": (at, at + 1)}[place]
            if file == "stridemap/quantities.py":  # its entries are some lines long
                start = stop = max(i for i in range(at + 1) if lines[i].strip().startswith("Quantity("))
            lines[start:stop] = text.removeprefix("\n").removesuffix("\n").split("\n")
        path.write_text("\n".join(lines) + "\n")

    def python(self, *words):
        """Run Python there; returns what it printed."""
        environment = {**os.environ, "PYTHONPATH": str(self.folder), "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run(
            [sys.executable, *map(str, words)],
            cwd=self.folder,
            env=environment,
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, f"{words}\n{done.stdout}\n{done.stderr}"
        return done.stdout

    def run_tests(self):
        """Run the tests of the recipe there."""
        assert self.tests
        out = self.python("-m", "pytest", "-q", "-p", "no:cacheprovider", "-n", "0", *self.tests)
        assert "passed" in out

    def run_page(self, further=""):
        """Run the commands and the Python that the page ends with, and further Python.

        Returns a list of what each of them printed.
        """
        pieces = []
        for language, no_run, caption, text in self.blocks:
            if caption or no_run:
                continue
            if language == "python":
                pieces.append(text)
            for line in text.splitlines() if language == "sh" else ():
                pieces += [f"stridemap_command({line!r})"] if line.startswith("stridemap ") else []
        pieces += [further] if further else []
        out = self.python("-c", PAGE + f"\nprint({END!r})\n".join(pieces))
        return out.split(f"{END}\n")


@pytest.fixture
def recipe(tmp_path):
    """Apply a recipe to a copy of the source, whose new files must be in good style."""

    def follow(page):
        copy = Copy(tmp_path, page)
        ruff = shutil.which("ruff", path=Path(sys.executable).parent)
        for command in ("check", "format"):
            words = [ruff, command, *(["--check"] if command == "format" else []), *copy.tests]
            done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True)
            assert done.returncode == 0, done.stdout
        return copy

    return follow


def test_add_a_measure(recipe):
    copy = recipe("add-a-measure")
    copy.run_tests()
    table, python, columns = copy.run_page(SWEEP)
    assert re.search(r"^impact_loss +0\.\d+ +0\.\d+  M g L +energy lost at touchdown$", table, re.M)
    assert re.search(r"^[\d.]+ J$", python, re.M)
    # Where the entry stands in the registry, there is the column.
    names = columns.split()
    assert names[names.index("impact_loss") + 1] == "residual"


SWEEP = """
from tests.oracles.sweeping import Inline
from stridemap.sweeps.config import parse_config
config = parse_config({"model": "wobbling", "grid": {"k": [6.0]}, "search": {"starts": 32}})
stridemap.sweep(config, "swept", executor=Inline())
print(*stridemap.read_orbits("swept").columns)
"""


def test_add_a_model(recipe):
    copy = recipe("add-a-model")
    copy.python("-c", DERIVE)
    copy.run_tests()
    assert "<damped_compass: limit cycle" in copy.run_page()[-1]
    tables = tomllib.loads((copy.folder / "pyproject.toml").read_text())["tool"]["setuptools"]
    assert "stridemap.generated.damped_compass" in tables["packages"]
    suffixes = {f"*{path.suffix}" for path in copy.path("generated/damped_compass").iterdir()}
    assert suffixes - {"*.py"} == set(tables["package-data"]["stridemap.generated.damped_compass"])


DERIVE = """
from stridemap.codegen import WALKERS, generated_folder, write_model
write_model(WALKERS["damped_compass"], generated_folder() / "damped_compass")
"""
"""What `make derive` does, for this one model."""


def test_add_a_backend(recipe):
    copy = recipe("add-a-backend")
    copy.run_tests()
    (table,) = copy.run_page()
    assert "converged" in table


def test_add_a_claim(recipe):
    copy = recipe("add-a-claim")
    copy.run_tests()


def test_add_a_command(recipe):
    copy = recipe("add-a-command")
    copy.run_tests()
    table, json = copy.run_page()
    assert table.startswith("quantity")
    assert json.startswith("{")
    assert copy.python("-c", UNLOADED) == "[]\n"


UNLOADED = """
import sys
import stridemap.cli.app
print([name for name in ("casadi", "pandas") if name in sys.modules])
"""


def test_every_recipe_is_tested_and_listed():
    pages = {path.stem for path in (ROOT / "docs").glob("add-*.md")}
    listed = set(re.findall(r"\((add-[\w-]+)\.md\)", (ROOT / "docs" / "recipes.md").read_text("utf-8")))
    tested = set(re.findall(r'recipe\("([\w-]+)"\)', Path(__file__).read_text("utf-8")))
    assert listed == tested | {"add-a-printer"}  # has a test beside the printers
    assert pages <= listed
