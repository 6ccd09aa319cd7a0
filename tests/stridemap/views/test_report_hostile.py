"""Folders from somebody else: no file in them runs, no text of theirs does, and what is forged is refused."""

import hashlib
import html.parser
import json
import os
import random
import re
import shutil
import time

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

import stridemap
from stridemap.codegen import derive_model
from stridemap.derive import Body, Line, Measured, UnitNames
from stridemap.derive.models import rimless_wheel
from stridemap.errors import InputError, StridemapError
from stridemap.sweeps import files
from stridemap.sweeps.config import canonical_json
from stridemap.sweeps.run import sweep
from stridemap.views.report.write import write_report
from stridemap.views.small_figures import Axis, Band, Bar, Curve, Guide, Mark, Panel, SmallFigure, rows_axis
from tests.oracles.sweeping import Inline

SCRIPTS = (
    "<script>window.ran=1</script>", "</script><script>window.ran=2</script>",
    "</title><script>ran=3</script>", "<img src=x onerror=window.ran=4>",
    '"onmouseover="window.ran=5', "'><svg onload=window.ran=6>",
    "<!--<script>", "&lt;script&gt;ran=7&lt;/script&gt;", "{{script}}", "${window.ran=8}", "javascript:ran=9",
    "</SCRIPT ><ScRiPt>window.ran=10</ScRiPt>",
)  # fmt: skip
"""What a page must show as text."""

ALL = " ".join(SCRIPTS)


def forge(folder, change=None, tables=None):
    """Change a sweep's provenance, and columns of its tables by table and name; digests fit all the same."""
    for name in ("orbits.parquet", "cells.parquet", "special.parquet"):
        table = pq.read_table(folder / name)
        metadata = dict(table.schema.metadata)
        provenance = json.loads(metadata[b"stridemap"])
        if change:
            change(provenance)
        for column, values in (tables or {}).get(name.split(".")[0], {}).items():
            where = table.schema.names.index(column) if column in table.schema.names else None
            if values is None:
                table = table.remove_column(where)
            elif where is None:
                table = table.append_column(column, pa.array(values(table)))
            else:
                field = table.schema.field(column)
                made = values(table)
                kind = made.type if isinstance(made, pa.Array) else field.type
                made = made if isinstance(made, pa.Array) else pa.array(made, kind)
                table = table.set_column(where, pa.field(column, kind, field.nullable), made)
        metadata[b"stridemap"] = json.dumps(provenance).encode()
        table = table.replace_schema_metadata(None)
        metadata[b"stridemap.digest"] = files.digest(table.schema, table.num_rows, metadata)
        pq.write_table(table.replace_schema_metadata(metadata), folder / name)


def rehash(provenance):
    """Give a changed configuration the hash that belongs to it."""
    text = canonical_json(provenance["configuration"])
    provenance["configuration_hash"] = hashlib.sha256(text.encode()).hexdigest()


# -- files that lie in the folder ----------------------------------------------------------------------------

EVIL = "import pathlib\npathlib.Path({marker!r}).write_text('ran')\n"


@pytest.fixture
def trapped(done, tmp_path, monkeypatch):
    """A sweep with files beside its tables that would leave a marker, and the marker."""
    marker = tmp_path / "marker"
    for name in ("evil.py", "compass.py", "sitecustomize.py", "conftest.py", "stridemap.py", "numpy.py"):
        (done / "out" / name).write_text(EVIL.format(marker=str(marker)))
    shutil.copytree(stridemap.load("compass").files.folder, done / "out" / "model")
    equations = done / "out" / "model" / "compass.py"
    equations.write_text(equations.read_text() + EVIL.format(marker=str(marker)))
    monkeypatch.chdir(done / "out")
    return done, marker


@pytest.mark.parametrize("entry", ["model", "configuration", "both"])
@pytest.mark.parametrize("name", ["evil.py", "{out}/evil.py", "{out}/model", "model", "../out/evil", "evil"])
def test_nothing_that_the_metadata_names_is_run(trapped, refused, entry, name):
    done, marker = trapped
    named = name.format(out=done / "out")

    def change(provenance):
        if entry in ("model", "both"):
            provenance["model"] = named
        if entry in ("configuration", "both"):
            provenance["configuration"]["model"] = named
            rehash(provenance)

    forge(done / "out", change)
    if entry == "configuration" and name in ("model", "evil"):
        write_report(done / "out", done / "a.html")  # a name like any other, of which nothing follows
    else:
        refused(f"report {done}/out --out {done}/a.html", str(done / "out"))
    for reader in (stridemap.read_orbits, stridemap.read_cells, stridemap.read_provenance):
        reader(done / "out")
    assert not marker.exists()


def test_a_file_of_the_name_of_a_built_in_model_is_not_taken_for_it(trapped):
    done, marker = trapped
    write_report(done / "out", done / "a.html")
    assert not marker.exists()


# -- texts ---------------------------------------------------------------------------------------------------


def hostile_walker():
    """The rimless wheel with scripts in every text that a declaration has."""
    walker = rimless_wheel.WALKER
    (hub,) = walker.bodies
    theta = walker.coordinates[0]
    coordinate = type(theta)(theta.name, ALL, ALL)
    return walker.with_(
        name="hostile",
        title=ALL,
        reference=ALL,
        coordinates=(coordinate,),
        stance_angle=coordinate,
        parameters=tuple(
            type(a)(a.name, a.default, ALL, ALL, a.lower, a.upper, a.lower_open, a.upper_open)
            for a in walker.parameters
        ),
        bodies=(Body(ALL, hub.mass, hub.position, hub.inertia, hub.angle),),
        drawing=tuple(Line(one.name, one.points) for one in walker.drawing),
        quantities=(Measured("lean", theta.symbol, "maximum", ALL, ALL, "length"),),
        units=UnitNames(ALL, ALL, "time" + ALL, ALL),
        sources={"mass_matrix": ALL},
    )


def hostile_figure():
    """With a text in each place, and bars wide enough to show theirs."""
    axis, rows = Axis(ALL, 0.0, 1.0), rows_axis([ALL, ALL])
    place = {ALL: 0.5}
    first = Panel(
        ALL, axis, axis, [Curve("group-A", [0.1, 0.5], [0.1, 0.5], text=ALL)],
        marks=[Mark(0.5, 0.5, True, ALL, place)], guides=[Guide("y", 0.5, ALL)],
        bands=[Band("x", 0.2, 0.4, ALL)],
    )  # fmt: skip
    second = Panel(ALL, axis, rows, bars=[Bar("group-B", 0, 0.0, 1.0, ALL, place)])
    return SmallFigure(ALL, [first, second]).to_dict()


def hostile_claims():
    return {
        "claims": [
            {
                "id": ALL,
                "statement": ALL,
                "verdict": "holds",
                "numbers": ALL,
                "short": ALL,
                "where": ALL,
                "listed": {ALL: ALL},
                "figure": hostile_figure(),
                "evidence": {ALL: [ALL, {ALL: [1.5, None, True]}], "half": "\ud800"},
            }
        ]
    }


@pytest.fixture(scope="module")
def hostile(tmp_path_factory):
    """A page made of a sweep whose model, tables, metadata and verdicts have scripts wherever text can be."""
    folder = tmp_path_factory.mktemp("hostile")
    model = derive_model(hostile_walker(), folder / "model")
    config = {"model": str(folder / "model"), "grid": {"slope": [0.2, 0.25, 0.3]}, "search": {"starts": 16}}
    sweep(stridemap.parse_config(config), folder / "out", executor=Inline())

    def change(provenance):
        provenance.update(compiler=ALL, commit=ALL, arithmetic=ALL, versions={ALL: ALL})
        provenance["configuration"]["search"]["starts"] = ALL
        rehash(provenance)

    cells = {"reason": lambda table: [ALL] * len(table), "status": lambda table: ["failed"] + ["found"] * 2}
    orbits = {"group": lambda table: [ALL] * len(table)}
    forge(folder / "out", change, {"cells": cells, "orbits": orbits})
    (folder / "claims.json").write_text(json.dumps(hostile_claims()))
    write_report(folder / "out", folder / "page.html", folder / "claims.json", folder / "model")
    assert model.name == "hostile"
    return folder


class Elements(html.parser.HTMLParser):
    """Every element of a page, with its attributes."""

    def __init__(self):
        super().__init__()
        self.found = []

    def handle_starttag(self, tag, attributes):
        self.found.append((tag, dict(attributes)))


def test_texts_make_no_element_and_no_attribute(hostile):
    parser = Elements()
    parser.feed((hostile / "page.html").read_text(encoding="utf-8"))
    tags = [tag for tag, _ in parser.found]
    assert tags.count("script") == 2
    drawings = [attributes for tag, attributes in parser.found if tag == "svg"]
    assert [attributes["id"] for attributes in drawings if "id" in attributes] == ["curves"]
    assert sum(attributes.get("class") == "small" for attributes in drawings) == 2  # the panels of the figure
    assert not {name for attributes in drawings for name in attributes} - {
        "id", "class", "viewbox", "role", "aria-label", "aria-hidden",
    }  # fmt: skip
    assert not {"img", "iframe", "object", "embed", "base", "form"} & set(tags)
    assert not [(tag, a) for tag, attributes in parser.found for a in attributes if a.startswith("on")]
    assert {attributes.get("href", "#")[0] for tag, attributes in parser.found if tag == "a"} == {"#"}


def look(browser, path):
    """Open a page and use all that can be used; returns it, and what it asked for or complained of."""
    faults = []
    context = browser.new_context(viewport={"width": 1200, "height": 900}, reduced_motion="reduce")
    page = context.new_page()
    page.on("console", lambda message: faults.append(message.text))
    page.on("pageerror", lambda error: faults.append(str(error.stack)))
    page.on("dialog", lambda dialog: (faults.append(dialog.message), dialog.dismiss()))
    page.on("request", lambda asked: faults.append(asked.url) if not asked.url.startswith(own) else None)
    own = path.as_uri()
    page.goto(own)
    limit = time.monotonic() + 30
    while page.evaluate("document.documentElement.dataset.ready") != "yes" and not faults:
        assert time.monotonic() < limit
        page.wait_for_timeout(20)
    for chooser in page.locator("select").all():
        if chooser.is_visible():
            for i in range(chooser.locator("option").count()):
                chooser.select_option(index=i)
    for cell in range(page.evaluate("stridemap.cells.length")):
        page.evaluate("cell => stridemap.choose(cell)", cell)
    page.mouse.move(300, 300)
    page.wait_for_timeout(200)
    return page, [fault for fault in faults if fault != "data:,"]


@pytest.mark.parametrize("policy", [True, False], ids=["as written", "without its policy"])
def test_no_text_runs_in_the_browser(hostile, browser, policy):
    text = (hostile / "page.html").read_text(encoding="utf-8")
    path = hostile / f"look{policy}.html"
    bare, times = re.subn(r'<meta http-equiv="Content-Security-Policy"[^>]*>', "", text)
    assert times == 1
    path.write_text(text if policy else bare, encoding="utf-8")
    page, faults = look(browser, path)
    assert faults == []
    assert page.evaluate("typeof window.ran") == "undefined"
    assert "window.ran=1" in page.title()  # it is shown
    assert page.evaluate("document.images.length + document.querySelectorAll('svg[onload]').length") == 0
    page.context.close()


def test_the_policy_stops_what_gets_in_all_the_same(hostile, browser):
    text = (hostile / "page.html").read_text(encoding="utf-8")
    inserted = "<script>window.ran = 1</script><img src='data:,' onerror='window.ran = 2'>"
    (hostile / "inserted.html").write_text(text.replace("<main>", f"{inserted}<main>"), encoding="utf-8")
    page, faults = look(browser, hostile / "inserted.html")
    assert page.evaluate("typeof window.ran") == "undefined"
    assert "Content Security Policy" in " ".join(faults)
    page.context.close()


# -- numbers -------------------------------------------------------------------------------------------------

EXTREMES = (np.nan, np.inf, -np.inf, 1e308, -1e308, 5e-324, 0.0, -0.0)


def test_measures_that_are_no_numbers_are_shown(done, browser):
    """Quantities may be anything; the page stays what it is."""
    measured = stridemap.load("compass").measured
    columns = {
        name: lambda table, i=i: [EXTREMES[(i + j) % len(EXTREMES)] for j in range(len(table))]
        for i, (name, quantity) in enumerate(measured.items())
        if quantity.type == "float" and name != "period"
    }
    forge(done / "out", tables={"orbits": columns})
    write_report(done / "out", done / "page.html")
    _, faults = look(browser, done / "page.html")
    assert faults == []


def test_states_from_which_nothing_can_be_integrated_are_shown(done, browser):
    section = stridemap.load("compass").section
    columns = {name: lambda table: [1e308] * len(table) for name in (*section, "period")}
    forge(done / "out", tables={"orbits": columns})
    write_report(done / "out", done / "page.html")
    _, faults = look(browser, done / "page.html")
    assert faults == []


@pytest.mark.parametrize(
    ("table", "column", "values", "words"),
    [
        ("orbits", "period", lambda t: [np.nan] * len(t), "not a finite number"),
        ("orbits", "theta1", lambda t: [np.inf] * len(t), "not a finite number"),
        ("orbits", "period", lambda t: [-1.0] * len(t), "a period is not above 0"),
        ("orbits", "period", lambda t: pa.array(["long"] * len(t)), "the column period of orbits.parquet is"),
        ("orbits", "stable", lambda t: pa.array([1.0] * len(t)), "the column stable of orbits.parquet is"),
        ("orbits", "cell", lambda t: [99] * len(t), "not in the order of their cells"),
        ("orbits", "cell", lambda t: [-1] * len(t), "not in the order of their cells"),
        ("orbits", "omega", lambda t: [2.0] * len(t), "not at its cell's parameters"),
        ("orbits", "status", lambda t: ["not_a_step"] * len(t), "a status that is not one"),
        ("orbits", "multiplier_0_re", lambda t: [np.nan] * len(t), "a multiplier is not a number"),
        ("orbits", "spectral_radius", None, "lacks the column spectral_radius"),
        ("orbits", "theta1", None, "lacks the column theta1"),
        ("orbits", "constructor", lambda t: ["x"] * len(t), "has a column 'constructor'"),
        ("cells", "status", lambda t: ["<b>"] * len(t), "a cell has a status that is not one"),
        ("cells", "omega", lambda t: [1.0] * len(t), "are not those of the grid"),
        ("cells", "cell", lambda t: [5] * len(t), "are not those of the grid"),
        ("cells", "reason", None, "lacks the column reason"),
        ("cells", "reason", lambda t: pa.array([1] * len(t)), "the column reason of cells.parquet is"),
    ],
)  # fmt: skip
def test_tables_that_no_sweep_writes(done, refused, table, column, values, words):
    forge(done / "out", tables={table: {column: values}})
    refused(f"report {done}/out --out {done}/a.html", str(done / "out"), words)


LONG = "x" * 1_000_000


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda p: p.update(format=99), "another version of stridemap (format 99"),
        (lambda p: p.update(model=["compass"]), "model in their metadata is ['compass']"),
        (lambda p: p.update(model=LONG), "model in their metadata is 'xxx"),
        (lambda p: p.update(model_hash="../../x"), "model_hash in their metadata"),
        (lambda p: p.update(versions=[]), "versions in their metadata"),
        (lambda p: p.update(compiler="\x1b[2J"), "compiler in their metadata is '\\x1b[2J'"),
        (lambda p: p.update(commit="\ud800"), "commit in their metadata is '\\ud800'"),
        (lambda p: p.update(measures={"a": 1}), "measures in their metadata"),
        (lambda p: p["measures"].append("soul"), "have the column soul"),
        (lambda p: p.pop("compiler"), "compiler in their metadata"),
        (lambda p: p["configuration"].pop("grid"), "configuration.grid in their metadata"),
        (
            lambda p: p["configuration"]["search"].update(starts=["many"]),
            "configuration.search.starts in their metadata is ['many']",
        ),
        (lambda p: p["configuration"]["grid"].update(omega="fast"), "configuration.grid.omega"),
        (lambda p: p["configuration"]["grid"].update(omega=[2.5, 4.0]), "does not have the hash"),
        (lambda p: (p["configuration"]["grid"].update(omega=[3.0, 2.5]), rehash(p)), "do not ascend"),
        (lambda p: (p["configuration"]["grid"].update(omega=[-1.0, 2.5]), rehash(p)), "omega = -1"),
        (lambda p: (p["configuration"]["params"].update(x=1.0), rehash(p)), "the parameters of compass"),
        (lambda p: (p["configuration"]["params"].pop("beta"), rehash(p)), "the parameters of compass"),
        (
            lambda p: (p["configuration"]["grid"].update(omega=[1.0, 2.0, 3.0]), rehash(p)),
            "2 rows for a grid of 3",
        ),
    ],
)  # fmt: skip
def test_metadata_that_no_sweep_writes(done, refused, change, words):
    forge(done / "out", change)
    refused(f"report {done}/out --out {done}/a.html", str(done / "out"), words)


def test_metadata_that_is_nested_without_end(done, refused):
    path = done / "out" / "orbits.parquet"
    table = pq.read_table(path)
    metadata = {**table.schema.metadata, b"stridemap": b"[" * 200_000}
    table = table.replace_schema_metadata(None)
    metadata[b"stridemap.digest"] = files.digest(table.schema, table.num_rows, metadata)
    pq.write_table(table.replace_schema_metadata(metadata), path)
    refused(f"report {done}/out --out {done}/a.html", path, "not one that a sweep wrote")


def test_text_that_is_no_text(done, refused):
    bad = pa.Array.from_buffers(
        pa.string(), 2, [None, pa.py_buffer(np.array([0, 1, 2], np.int32)), pa.py_buffer(b"\xff\xfe")]
    )
    forge(done / "out", tables={"cells": {"reason": lambda _: bad}})
    refused(f"report {done}/out --out {done}/a.html", "cells.parquet is damaged")


def test_damaged_tables_are_refused_or_read_as_they_are(done):
    """Cut short or with bytes changed, anywhere: a sentence, or the very numbers."""
    rng = random.Random(1)
    for name in ("orbits.parquet", "cells.parquet", "special.parquet"):
        path = done / "out" / name
        whole, wanted = path.read_bytes(), stridemap.read_orbits(done / "out")
        refusals = 0
        for _ in range(50):
            data = bytearray(whole)
            if rng.random() < 0.4:
                del data[rng.randrange(len(data)) :]
            else:
                data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)
            path.write_bytes(data)
            try:
                write_report(done / "out", done / "a.html")
                assert stridemap.read_orbits(done / "out").equals(wanted)
            except StridemapError as error:
                assert "\n" not in str(error)
                refusals += 1
        assert refusals > 25  # not every byte of a file matters
        path.write_bytes(whole)


@pytest.mark.parametrize("name", ["orbits.parquet", "cells.parquet", "special.parquet"])
def test_what_is_no_file_is_not_waited_for(done, refused, name):
    (done / "out" / name).unlink()
    os.mkfifo(done / "out" / name)
    refused(f"report {done}/out --out {done}/a.html", name, "it is not a file")


def test_claims_that_are_nested_without_end(done):
    (done / "c.json").write_text("[" * 200_000)
    with pytest.raises(InputError, match="is not JSON"):
        write_report(done / "out", done / "a.html", done / "c.json")
