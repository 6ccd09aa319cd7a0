"""The report as a file: what is in it, that it needs nothing else, and what it refuses."""

import json
import os
import re
import shutil

import numpy as np
import pandas as pd
import pyarrow.parquet as pq
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.paper.sweeps import paper_sweeps
from stridemap.quantities import QUANTITIES
from stridemap.solver.model.loading import available, load
from stridemap.sweeps import files
from stridemap.sweeps.run import sweep
from stridemap.sweeps.store import read_cells, read_provenance
from stridemap.views.report.claims import read_claims
from stridemap.views.report.write import write_report
from tests.oracles.page_tables import Tables, data_of
from tests.oracles.sweeping import Inline

CLAIMS = {
    "claims": [
        {"id": "C1", "statement": "k < 7 & </script>", "verdict": "holds", "evidence": {"k": [0.5, 6.0]}},
        {
            "id": "C2",
            "statement": "order",
            "verdict": "in part",
            "evidence": {"rows": [{"n": 1, "ok": True}]},
        },
        {"id": "C3", "verdict": "differs", "evidence": None},
    ]
}


@pytest.fixture
def page(done):
    write_report(done / "out", done / "page.html")
    return (done / "page.html").read_text(encoding="utf-8")


# -- what is in it -------------------------------------------------------------------------------------------


def shown(value, decimals):
    """A number as the page shows it: with so many decimals, or small ones in four digits."""
    if pd.isna(value):
        return None
    if not np.isfinite(value):
        return str(value)
    return f"{value:.{decimals}f}" if value == 0 or abs(value) >= 1e-3 else f"{value:.3e}"


def test_it_holds_the_tables_to_the_last_digit_that_is_shown(done, page):
    data, orbits, cells = data_of(page), stridemap.read_orbits(done / "out"), read_cells(done / "out")
    assert data["orbits"]["rows"] == len(orbits) > 0
    assert data["cells"]["rows"] == len(cells)
    tables, model = Tables(data["bytes"]), load("compass")
    assert set(orbits) - set(data["orbits"]["columns"]) == set(model.preset)
    for name, column in data["orbits"]["columns"].items():
        found = tables.column(data["orbits"], name)
        if column["type"] == "number" and not column["whole"]:
            decimals = 12 if name in (*model.section, "period") else 10
            wanted = [shown(value, decimals) for value in orbits[name]]
            assert [shown(np.nan if v is None else v, decimals) for v in found] == wanted, name
        else:
            assert found == [None if pd.isna(value) else value for value in orbits[name]], name
    assert tables.column(data["cells"], "status") == list(cells.status)


def test_cells_are_numbered_as_in_the_tables(tmp_path):
    """The provenance sorts its keys; cells are numbered in the model's order."""
    config = tmp_path / "two.toml"
    config.write_text(
        'model = "wobbling"\n[grid]\nk = [6, 7, 8]\nalpha = [0.2, 0.25]\n[search]\nstarts = 4\n'
    )
    sweep(config, tmp_path / "out", executor=Inline())
    write_report(tmp_path / "out", tmp_path / "page.html")
    data, cells = data_of((tmp_path / "page.html").read_text()), read_cells(tmp_path / "out")
    assert [axis["name"] for axis in data["axes"]] == ["k", "alpha"]
    mesh = np.meshgrid(*(axis["values"] for axis in data["axes"]), indexing="ij")
    assert np.array_equal(np.stack(mesh, -1).reshape(-1, 2), cells[["k", "alpha"]].to_numpy())


def test_it_says_where_the_numbers_come_from(done, page):
    found = read_provenance(done / "out")
    for value in [found["configuration_hash"], found["model_hash"], found["commit"], found["compiler"]]:
        assert value is None or value in page
    for name, version in found["versions"].items():
        assert f"{name} {version}" in page
    assert "identified by search, not published" in page


def test_it_needs_nothing_else(page):
    assert set(re.findall(r"https?://[^\s\"'<)]*", page)) == {
        "http://www.w3.org/2000/svg"
    }  # a name, no address
    assert re.findall(r"(?:src|href)\s*=\s*\"(?!#)([^\"]*)\"", page) == ["data:,"]
    assert "@import" not in page
    assert "url(" not in page
    assert "default-src 'none'" in page
    assert "{{" not in page


def test_the_same_sweep_gives_the_same_bytes(done, monkeypatch):
    for name, zone in [("one.html", "UTC"), ("two.html", "Asia/Tokyo")]:
        monkeypatch.setenv("TZ", zone)
        write_report(done / "out", done / name)
    assert (done / "one.html").read_bytes() == (done / "two.html").read_bytes()


def test_verdicts_are_shown_as_text(done):
    (done / "claims.json").write_text(json.dumps(CLAIMS))
    write_report(done / "out", done / "page.html", done / "claims.json")
    page = (done / "page.html").read_text()
    assert "3 statements: 1 holds, 1 holds in part, 1 differs." in page
    assert "k &lt; 7 &amp; &lt;/script&gt;" in page
    assert page.count("</script>") == page.count("<script") == 2
    assert "<dt>k</dt><dd>0.5, 6</dd>" in page
    assert "No verdicts were given" not in page


def test_without_verdicts_it_says_how_to_get_them(page):
    assert "No verdicts were given to this report." in page


@pytest.mark.parametrize(
    ("light", "start"), [(True, ":root {"), (False, "@media screen and (prefers-color-scheme: dark)")]
)
def test_text_stands_out_from_its_ground(page, light, start):
    """Contrast of WCAG 2.1, at least 4.5."""

    def luminance(colour):
        channels = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
        linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
        return float(np.dot(linear, [0.2126, 0.7152, 0.0722]))

    named = dict(re.findall(r"--([\w-]+): (#\w{6});", page[page.index(start) :].split("}")[0]))
    for text in ("ink", "ink-soft", "accent", "good", "bad"):
        for ground in ("page", "card"):
            dark, bright = sorted([luminance(named[text]), luminance(named[ground])])
            assert (bright + 0.05) / (dark + 0.05) >= 4.5, (text, ground)


# -- the equations -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", available())
def test_every_generated_function_is_there(name):
    model = load(name)
    text = model.text(f"{name}.js")
    for generated in model.spec.functions:
        assert re.search(rf"^ *{generated}\(", text, re.MULTILINE), generated
    assert text.rstrip().endswith("})")


# -- the command and its refusals ----------------------------------------------------------------------------


def test_the_command_writes_it_and_says_so(done, run):
    status, out, err = run("report", done / "out", "--out", done / "new" / "page.html")
    size = (done / "new" / "page.html").stat().st_size
    orbits = len(stridemap.read_orbits(done / "out"))
    assert (status, err) == (0, "")
    assert out == (
        f"report of {orbits} limit cycles in 2 cells: {done / 'new' / 'page.html'} ({size / 1e6:.1f} MB)\n"
    )
    assert os.listdir(done / "new") == ["page.html"]


def test_measures_are_those_of_the_registry(done, page):
    shown, orbits = data_of(page)["measures"], stridemap.read_orbits(done / "out")
    names = [measure["name"] for measure in shown]
    assert names == [name for name in QUANTITIES if name in orbits and not orbits[name].isna().all()]
    for measure in shown:
        quantity = QUANTITIES[measure["name"]]
        assert (measure["label"], measure["meaning"]) == (quantity.label, quantity.definition)
    units = {measure["name"]: measure["unit"] for measure in shown}
    assert (units["period"], units["d_max"], units["work"]) == ("√(L/g)", "L", "M g L")
    assert (units["speed"], units["min_vertical_force"], units["cot"]) == ("√(g L)", "M g", "")


def test_roles_travel_with_the_page(page):
    model = data_of(page)["model"]
    assert model["lines"] == [{"name": "legs", "role": "legs"}]
    assert [mass["role"] for mass in model["masses"]] == ["body", "stance_foot", "swing_foot"]


# -- the paper's map -----------------------------------------------------------------------------------------

OPTIONS = ("--thin", 60, "--workers", 2)


@pytest.fixture(scope="module")
def paper(tmp_path_factory):
    """The paper's sweeps, very coarse; the map and what it is compared with are all there is to show."""
    folder = tmp_path_factory.mktemp("paper")
    sweeps = paper_sweeps(folder, thin=60, executor=Inline())
    sweeps.run("map")
    sweeps.run("compass")
    return folder


def test_without_a_folder_it_is_the_papers_map(paper, tmp_path, run, monkeypatch):
    preset = {**load("wobbling").preset, "k": [6.0, 7.0], "alpha": [0.2, 0.3], "omega": 3.0}
    lines = {"boundary": 0, "type": "fold", "gait": True, "borders_stable": True}
    monkeypatch.setattr(
        "stridemap.paper.map_report.map_boundaries", lambda sweeps, say: pd.DataFrame(preset | lines)
    )
    (tmp_path / "claims.json").write_text(json.dumps(CLAIMS))
    words = ("report", "--sweeps", paper, *OPTIONS, "--claims", tmp_path / "claims.json")
    status, out, err = run(*words, "--out", tmp_path / "map.html")
    assert (status, err) == (0, "")  # nothing is swept again, and no other sweep is needed
    page, cells = (tmp_path / "map.html").read_text(), read_cells(paper / "map")
    assert f"in {len(cells)} cells: {tmp_path / 'map.html'}" in out
    assert [axis["name"] for axis in data_of(page)["axes"]] == ["k", "alpha", "omega"]
    assert "3 statements: 1 holds, 1 holds in part, 1 differs." in page
    assert [one["type"] for one in data_of(page)["curves"]] == ["fold"]
    compared = {(one["quantity"], one["parameters"]["omega"]): one for one in data_of(page)["references"]}
    at_three = compared["cot", 3.0]
    assert at_three["label"] == "compass"
    (published,) = [
        row for row in stridemap.read_orbits(paper / "compass").itertuples() if row.omega == 3 and row.stable
    ]
    assert at_three["value"] == published.cot


def test_options_of_the_papers_sweeps_are_for_them_alone(done, refused, tmp_path):
    line = f"report {done}/out --out {done}/a.html"
    refused(f"{line} --thin 2", "--thin cannot be given with the sweep in", "leave the folder out")
    refused(f"{line} --sweeps {tmp_path} --set beta=1", "--sweeps, --set cannot be given")
    refused(f"report --model m.py --out {done}/a.html", "--model is for the sweep in SWEEP_DIR")


def test_no_sweep(tmp_path, refused):
    refused(f"report {tmp_path} --out {tmp_path}/a.html", "there is no orbits.parquet in", tmp_path)
    refused(f"report {tmp_path}/nowhere --out {tmp_path}/a.html", "give the output folder of a sweep")
    assert not (tmp_path / "a.html").exists()


def test_a_sweep_that_found_nothing(tmp_path, refused):
    config = tmp_path / "none.toml"
    config.write_text(
        'model = "compass"\n[params]\nKp = 0\nKd = 0\n[grid]\nomega = [3.0]\n[search]\nstarts = 4\n'
    )
    sweep(config, tmp_path / "out", executor=Inline())
    refused(
        f"report {tmp_path}/out --out {tmp_path}/a.html", "found no limit cycle, so there is nothing to show"
    )


def altered(folder, change):
    """The tables of a sweep with another provenance."""
    for name in ("orbits.parquet", "cells.parquet", "special.parquet"):
        table = pq.read_table(folder / name)
        metadata = dict(table.schema.metadata)
        provenance = json.loads(metadata[b"stridemap"])
        change(provenance)
        metadata[b"stridemap"] = json.dumps(provenance).encode()
        metadata[b"stridemap.digest"] = files.digest(table.schema, table.num_rows, metadata)
        pq.write_table(table.replace_schema_metadata(metadata), folder / name)


def test_another_version_of_the_model(done, refused):
    altered(done / "out", lambda provenance: provenance.update(model_hash="0" * 64))
    refused(
        f"report {done}/out --out {done}/a.html",
        "is of another version of the model compass (hash 000000000000 there", "sweep again",
    )  # fmt: skip


def test_a_model_that_is_not_there(done, refused):
    altered(done / "out", lambda provenance: provenance.update(model="hexapod"))
    words = ("is of the model hexapod, which does not come with stridemap", "--model hexapod.py")
    refused(f"report {done}/out --out {done}/a.html", *words)


def test_tables_of_two_sweeps(done, tmp_path_factory, refused):
    other = tmp_path_factory.mktemp("other")
    (other / "c.toml").write_text((done / "small.toml").read_text().replace("3.0", "3.1"))
    sweep(other / "c.toml", other / "out", executor=Inline())
    shutil.copy(other / "out" / "cells.parquet", done / "out")
    refused(f"report {done}/out --out {done}/a.html", "are not of one sweep")


def test_where_it_cannot_be_written(done, refused):
    refused(f"report {done}/out --out {done}", "is a folder; give the name of a file")
    refused(f"report {done}/out/orbits.parquet --out {done}/a.html", "is a file; give the output folder")
    (done / "file").write_text("")
    refused(f"report {done}/out --out {done}/file/a.html", "cannot write", "a folder on the way is a file")
    refused("report", "Missing option '--out'")


def test_the_papers_report_tries_its_file_before_it_sweeps(tmp_path, refused):
    (tmp_path / "a file").touch()
    refused(
        ["report", "--out", tmp_path / "a file" / "report.html", "--sweeps", tmp_path / "sweeps"], "a file"
    )
    assert not (tmp_path / "sweeps").exists()


def test_a_failed_write_leaves_what_was_there(done, monkeypatch):
    (done / "page.html").write_text("before")
    monkeypatch.setattr(
        "os.replace", lambda *_: (_ for _ in ()).throw(OSError(28, "No space left on device"))
    )
    with pytest.raises(InputError, match="No space left on device"):
        write_report(done / "out", done / "page.html")
    assert (done / "page.html").read_text() == "before"
    assert sorted(os.listdir(done)) == ["out", "page.html", "small.toml"]


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("", "is not JSON"),
        ("[1]", 'does not hold a list "claims"'),
        ('{"claims": 3}', 'does not hold a list "claims"'),
        ('{"claims": [{"verdict": "holds"}]}', "does not have an id"),
        ('{"claims": [{"id": "C1", "verdict": "maybe"}]}', "'maybe', not one of holds, in part, differs"),
        ('{"claims": [{"id": "C1", "verdict": ["holds"]}]}', "not one of holds"),
        (b"\xff\xfe\x00", "is not JSON"),
    ],
)
def test_files_that_do_not_hold_claims(done, refused, content, words):
    (done / "c.json").write_bytes(content if isinstance(content, bytes) else content.encode())
    refused(f"report {done}/out --out {done}/a.html --claims {done}/c.json", words, "stridemap claims --json")


def test_no_file_of_claims(tmp_path):
    with pytest.raises(InputError, match="cannot read .*No such file"):
        read_claims(tmp_path / "none.json")


def test_a_page_that_is_too_large(done, refused, monkeypatch):
    monkeypatch.setattr("stridemap.views.report.write.LARGEST", 1000)
    refused(f"report {done}/out --out {done}/a.html", "show fewer limit cycles, or a part of the grid")
