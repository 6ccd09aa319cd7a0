"""What the documentation says is run, and what it lists is complete."""

import contextlib
import doctest
import importlib
import io
import json
import re
import shlex
import shutil
import subprocess
import tomllib
from dataclasses import fields
from pathlib import Path

import pytest
import typer

import stridemap
import stridemap.derive
import stridemap.paper
import stridemap.views
from stridemap.cli.app import app
from stridemap.quantities import QUANTITIES
from stridemap.solver.model.loading import available
from stridemap.sweeps.config import Search, load_config, parse_config
from stridemap.sweeps.run import sweep
from stridemap.sweeps.tables import cell_schema, orbit_schema
from tests.oracles.states import need
from tests.oracles.sweeping import Inline

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
GENERATED = sorted((ROOT / "generated").glob("*/README.md"))
BLOCK = re.compile(r"^```([\w-]+)([^\n]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
FENCE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)

NOT_RUN = {". .venv/bin/activate", "pip install .", "git clone"}
"""Shell lines that set up what a test has already."""


def name_of(path):
    return path.relative_to(ROOT).as_posix()


def blocks(path, *languages):
    """Language, words behind it and text of the fenced blocks of a page."""
    found = BLOCK.findall(path.read_text("utf-8"))
    return [block for block in found if not languages or block[0] in languages]


every_page = pytest.mark.parametrize("page", PAGES, ids=name_of)
# The tutorial builds up one file as it goes, and recipes change the source: test_tutorial.py and
# test_recipes.py read along.
ALONE = [page for page in PAGES if page.name != "declare.md" and not page.name.startswith("add-")]
every_page_alone = pytest.mark.parametrize("page", ALONE, ids=name_of)


# -- blocks that can be run ----------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def swept(tmp_path_factory):
    """The tables of a sweep over springs and mass ratios, as the pages have them."""
    folder = tmp_path_factory.mktemp("swept")
    grid = {"k": [0.5, 6.0, 22.5], "alpha": [0.25, 0.5]}
    config = {"model": "wobbling", "grid": grid, "search": {"starts": 32}}
    sweep(parse_config(config), folder / "paper", executor=Inline())
    return folder


@pytest.fixture
def reader(swept, tmp_path, monkeypatch, no_workers):
    """The folder in which somebody reads along: two finished sweeps, and whatever the page has them write."""
    shutil.copytree(swept / "paper", tmp_path / "results" / "paper")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@every_page_alone
def test_python_blocks(page, reader):
    """All blocks of a page in one namespace, in order."""
    texts = [text for language, words, text in blocks(page, "python") if "no-run" not in words]
    shutil.copytree(reader / "results" / "paper", reader / "results" / "my")
    namespace = {"__name__": "page"}
    for text in texts:
        with contextlib.redirect_stdout(io.StringIO()):
            exec(compile(text, name_of(page), "exec"), namespace)


@every_page_alone
def test_shell_blocks(page, reader, run):
    """Commands run with a page's own configuration (fewer values of each range); targets of make exist."""
    targets = set(re.findall(r"^([a-z]+):", (ROOT / "Makefile").read_text(), re.MULTILINE))
    for _, _, text in blocks(page, "toml"):
        (reader / "my.toml").write_text(re.sub(r"num = \d+", "num = 3", text))
        assert load_config("my.toml").n_cells > 1
    commands = typer.main.get_command(app).commands
    for _, words, text in blocks(page, "sh"):
        for line in text.splitlines():
            command, *rest = shlex.split(line, comments=True) or [""]
            if not command or " ".join([command, *rest]) in NOT_RUN:
                continue
            if command == "make":
                assert set(rest[:1]) <= targets, line
                continue
            assert command == "stridemap", f"{name_of(page)} has a command that no test runs: {line}"
            assert rest[0] in commands, line
            if "no-run" not in words:
                status, out, err = run(*rest)
                assert status == 0, line
                assert not re.search("error|warning|Traceback", err), line  # but for a sweep's progress
                assert out


@pytest.mark.parametrize("page", GENERATED, ids=name_of)
def test_shell_blocks_beside_the_generated_code(page, tmp_path):
    need("cc")
    shutil.copytree(page.parent, tmp_path, dirs_exist_ok=True)
    (block,) = blocks(page, "sh")
    done = subprocess.run(["sh", "-ec", block[2]], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "energy" in done.stdout


@pytest.mark.parametrize("page", GENERATED, ids=name_of)
def test_prototypes_beside_the_generated_code(page):
    """The prototypes that a generated README shows are those of the header."""
    header = " ".join((page.parent / f"{page.parent.name}.h").read_text().split())
    _, block = blocks(page, "c")
    shown = [" ".join(prototype.split()) for prototype in block[2].split(";") if prototype.strip()]
    functions = json.loads((page.parent / "manifest.json").read_text())["functions"]
    assert len(shown) == len(functions)
    assert all(f"{prototype};" in header for prototype in shown)


@pytest.mark.parametrize("page", GENERATED, ids=name_of)
def test_the_step_beside_the_generated_code(page, tmp_path):
    """The lines that a generated README shows take a step."""
    name = page.parent.name
    block, _ = blocks(page, "c")
    lines = f'#include "{name}_step.h"\nint main(void)\n{{\n{block[2]}return (int) status;\n}}\n'
    (tmp_path / "main.c").write_text(lines)
    sources = [tmp_path / "main.c", page.parent / f"{name}_step.c", page.parent / f"{name}.c"]
    flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", f"-I{page.parent}"]
    subprocess.run([need("cc"), *flags, *sources, "-lm", "-o", tmp_path / "main"], check=True)
    status = subprocess.run([tmp_path / "main"], check=False).returncode
    assert status < 6, "the state that is shown is one that a walker can be in"


@every_page
def test_queries_name_columns_that_there_are(page):
    """SQL and MATLAB are not run here; the columns that they name exist."""
    columns = set(orbit_schema(stridemap.load("wobbling")).names)
    for language, _, text in blocks(page, "sql", "matlab"):
        if language == "sql":
            words = re.findall(r"\b[a-z_]+\b", re.sub(r"'[^']*'", "", text))
            assert set(words) - {"count", "min", "max"} <= columns
        else:
            assert set(re.findall(r"\b(?:orbits|b)\.(\w+)", re.sub(r'"[^"]*"', "", text))) <= columns


MODULES = [
    "stridemap",
    "stridemap.codegen",
    "stridemap.units",
    *sorted(
        ".".join(["stridemap", *path.relative_to(ROOT).with_suffix("").parts])
        for folder in ("solver", "sweeps", "derive")
        for path in (ROOT / folder).rglob("*.py")
        if path.name != "__init__.py"
    ),
]


@pytest.mark.parametrize("name", MODULES)
def test_examples_in_docstrings(name):
    module = importlib.import_module(name)
    assert doctest.testmod(module, optionflags=doctest.NORMALIZE_WHITESPACE).failed == 0


def test_there_are_examples_in_docstrings():
    finder = doctest.DocTestFinder()
    homes = ["stridemap", "stridemap.units", "stridemap.solver.api.points"]
    assert all(any(t.examples for t in finder.find(importlib.import_module(home))) for home in homes)


# -- lists that must be complete -----------------------------------------------------------------------------


def words_of(*names):
    """Every word between backticks, or after a dot, in these pages."""
    text = " ".join((ROOT / "docs" / f"{name}.md").read_text("utf-8") for name in names)
    return {word for code in re.findall(r"`([^`\n]+)`", text) for word in re.findall(r"\w+", code)}, text


def test_the_page_of_python_names_is_the_list_of_public_names():
    _, text = words_of("api")
    documented = re.findall(r"\.\. (?:auto\w+|py:data):: ([\w.]+)", text)
    assert len(documented) == len(set(documented))
    top = {f"stridemap.{name}" for name in stridemap.__all__ if name != "__version__"}
    # What paper and views offer stands at the top level, or under the room's own name.
    rooms = {
        f"{room.__name__}.{name}"
        for room in (stridemap.derive, stridemap.paper, stridemap.views)
        for name in room.__all__
        if room is stridemap.derive or f"stridemap.{name}" not in top
    }
    assert set(documented) == top | rooms
    for target in documented:
        home, _, name = target.rpartition(".")
        value = getattr(importlib.import_module(home), name)
        assert value.__doc__ or not callable(value), target


def test_pages_show_public_names_only():
    """Except for those that are about changing stridemap itself."""
    inside = {"architecture.md", "CONTRIBUTING.md", "glossary.md", "recipes.md", "changelog.md"}
    for page in PAGES:
        if page.name in inside or page.name.startswith("add-"):
            continue
        text = page.read_text("utf-8")
        for room, name in re.findall(r"\bstridemap\.([a-z_]+)[.](\w+)", text):
            assert room in ("derive", "paper", "views"), f"{page.name}: stridemap.{room}.{name}"
        for name in re.findall(r"(?<![\w/.])stridemap\.([A-Za-z_]\w+)", text):
            assert name in (*stridemap.__all__, "derive", "paper", "views"), f"{page.name}: {name}"


def test_tables_of_options_have_every_word():
    """They are made from the docstrings of the records."""
    _, text = words_of("sweeps")
    shown = re.findall(r"```\{stridemap-options\} stridemap\.([\w.]+)", text)
    assert shown == ["AcceptanceOptions", "SweepConfig.continuation"]
    for name in ("AcceptanceOptions", "ContinuationOptions", "SearchOptions"):
        record = getattr(stridemap, name)
        entries = re.findall(r"^ {4}([\w, ]+) : ", record.__doc__, re.MULTILINE)
        assert [word for entry in entries for word in entry.split(", ")] == [f.name for f in fields(record)]


def test_every_measure_is_defined():
    words, text = words_of("measures")
    measured = {f.name for f in fields(stridemap.Orbit)} - {"model", "params", "measures", "steps"}
    tables = re.findall(r"^```\{stridemap-quantities\}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    assert measured - words <= set(QUANTITIES)
    assert set(" ".join(tables).split()) - {":rest:"} <= set(QUANTITIES)
    assert tables[-1] == ":rest:\n"  # whatever the registry has, the page defines


@pytest.mark.parametrize("schema", [orbit_schema, cell_schema])
def test_every_column_is_listed(schema):
    words, _ = words_of("sweeps")
    columns = {
        name for name in schema(stridemap.load("wobbling")).names if not name.startswith("multiplier_")
    }
    state = {"theta1", "dtheta1", "dtheta2", "x", "dx"}
    assert "QUANTITIES" in words  # stands for all that is measured
    assert columns - set(stridemap.load("wobbling").preset) - state - set(QUANTITIES) - words == set()


def test_every_setting_of_the_search_is_listed_with_its_default():
    _, text = words_of("sweeps")
    rows = [line for line in text.splitlines() if line.startswith("| `[search]")]
    for name, field in Search.model_fields.items():
        (row,) = [row for row in rows if f" {name}`" in row or f"`{name}`" in row]
        if isinstance(field.default, int | float):  # a box has none but the model's
            assert f"{field.default:g}" in row.split("|")[3], row


def test_the_table_of_parameters_is_that_of_the_models():
    _, text = words_of("model")
    table = re.findall(
        r"^\| (`\w+`(?:, `\w+`)*) \| (\S[^|]*) \| ([\d.]+) \| ([^|]+) \| (\w+) \|$", text, re.MULTILINE
    )
    written = {
        name: (unit.strip("`"), float(default), allowed, models)
        for names, unit, default, allowed, models in table
        for name in re.findall(r"\w+", names)
    }
    compass = stridemap.load("compass").preset
    wanted = {
        p.name: (p.unit, p.default, p.allowed, "both" if p.name in compass else "wobbling")
        for p in stridemap.load("wobbling").parameters
    }
    assert written == wanted


def test_every_option_in_the_pages_exists():
    """A page that shows ``stridemap orbit --foo`` is caught by running it; prose is not."""
    known = {"--help", "--version"} | {
        f"--{p.name}" for m in available() for p in stridemap.load(m).parameters
    }
    for command in typer.main.get_command(app).commands.values():
        known |= {option for parameter in command.params for option in parameter.opts}
    for page in PAGES[2:]:
        prose = FENCE.sub("", page.read_text("utf-8"))
        codes = re.findall(r"`([^`\n]*)`", prose)
        assert {word for code in codes for word in re.findall(r"(?<!\S)--[\w-]+", code)} <= known, page


# -- links ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("page", [*PAGES, *GENERATED], ids=name_of)
def test_links_lead_somewhere(page):
    text = FENCE.sub("", page.read_text("utf-8"))
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if "://" in target:
            continue
        path, _, anchor = target.partition("#")
        if path.startswith("gallery/"):
            picture = re.fullmatch(r"gallery/images/sphx_glr_(\w+)_\d+\.png", path)
            name = picture[1] if picture else path.removeprefix("gallery/")
            assert path == "gallery/index" or (ROOT / "examples" / f"{name}.py").exists(), target
            continue
        linked = page.parent / path if path else page
        assert linked.exists(), target
        if anchor:
            heads = re.findall(r"^#+ (.+)$", linked.read_text("utf-8"), re.MULTILINE)
            assert anchor in {re.sub(r"[^\w -]", "", head.lower()).replace(" ", "-") for head in heads}, (
                target
            )


def test_the_citation_is_that_of_the_package():
    cff = (ROOT / "CITATION.cff").read_text("utf-8")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert f"license: {project['license']}" in cff
    assert "arXiv:2209.14515" in cff
    assert "arXiv:2209.14515" in (ROOT / "docs" / "citing.md").read_text("utf-8")
