"""docs/declare.md, done as it says: its files, its commands, its Python, and the errors that it shows."""

import os
import re
import subprocess
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

import stridemap
from stridemap.codegen import declared
from tests.oracles.rewritten import light_model
from tests.oracles.sweeping import STRIDEMAP

ROOT = Path(__file__).resolve().parents[2]
TEXT = (ROOT / "docs" / "declare.md").read_text(encoding="utf-8")
FENCES = re.findall(r"^```(?:\{code-block\} )?(\w+)\n(?::caption: (\S+)\n\n)?(.*?)^```$", TEXT, re.M | re.S)
ERRORS = re.findall(r"^\| `(.+)` \| `(.+)` \| (.+) \|$", TEXT.partition("what is said")[2], re.M)


def written(name):
    """A file of the tutorial: all blocks that bear its name."""
    return "\n".join(code for _, caption, code in FENCES if caption == name)


def blocks(language):
    """The other blocks of a language."""
    return [code for kind, caption, code in FENCES if kind == language and not caption]


def shortened(table):
    """A printed table to nine digits: the last ones depend on the compiler."""
    return re.sub(r"(\.\d{9})\d*", r"\1", " ".join(table.split()))


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """The reader's folder, with the files."""
    folder = tmp_path_factory.mktemp("tutorial")
    for name in ("walker.py", "spring.toml"):
        (folder / name).write_text(written(name))
    return folder


@pytest.fixture
def reader(folder, monkeypatch):
    """Somebody in that folder without a C compiler: to compile walkers takes longer than all the rest."""
    monkeypatch.chdir(folder)
    monkeypatch.delenv("CC", raising=False)
    return {**os.environ, "PATH": str(folder)}


def test_the_commands_and_then_the_python_blocks_run_as_they_stand(folder, reader, monkeypatch):
    """With fewer springs. The walker of the file is simplified; others that Python declares are not."""
    (folder / "spring.toml").write_text(re.sub(r"num = \d+", "num = 7", written("spring.toml")))
    for block in blocks("sh"):
        for line in block.splitlines():
            words = line.split()
            ours = words[0] == "stridemap"
            command = [*STRIDEMAP, *words[1:]] if ours else ["sh", "-c", line]
            done = subprocess.run(command, env=reader if ours else None, capture_output=True, text=True)
            assert done.returncode == 0, f"{line}\n{done.stderr}"
            if words[1] == "orbit":
                (printed,) = blocks("text")
                assert shortened(done.stdout).startswith(shortened(printed))
    monkeypatch.setenv("PATH", reader["PATH"])
    monkeypatch.syspath_prepend(folder)
    monkeypatch.setitem(sys.modules, "walker", None)
    del sys.modules["walker"]  # it is forgotten afterwards
    monkeypatch.setattr(stridemap, "derive_model", light_model)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "no C compiler found")
        exec("\n".join(blocks("python")) + AFTERWARDS, {"__name__": "reader"})


AFTERWARDS = """
# Not in the text: what it claims.
assert legs.shape == (201, 3, 2)
few = {"starts": 64}
round_ = stridemap.find_orbits(stridemap.derive_model(on_round_feet), radius=0, options=few)
(flat,) = [o for o in round_ if o.stable]
assert abs(flat.period - mine[1].period) < 1e-10
published = stridemap.find_orbits("simplest_walker", slope=0.009, options=few)
assert len(published) == 2
found = stridemap.find_orbits(stridemap.derive_model(simplest), slope=0.009, options=few)
for a in published:
    assert min(abs(o.period - a.period * np.sqrt(1 / 9.81)) for o in found) < 1e-10
"""


def test_the_errors_are_those_that_the_text_shows(tmp_path):
    assert len(ERRORS) > 12
    good = written("walker.py")
    for n, (before, after, sentence) in enumerate(ERRORS):
        assert before in good, before
        path = tmp_path / f"{n}" / "walker.py"
        path.parent.mkdir()
        path.write_text(good.replace(before, after, 1))
        with pytest.raises(stridemap.InputError) as error:
            declared(path)
        said = str(error.value).replace(str(path), "walker.py").removeprefix("model compass_si: ")
        assert said == sentence


def test_cost_of_transport_is_the_sine_of_the_slope(folder, reader):
    walker, few = folder / "walker.py", {"starts": 64}
    found = stridemap.find_orbits(walker, slope=0.04, k=20, backend="interpreter", options=few)
    assert len(found) > 0
    for orbit in found:
        assert orbit.cot == pytest.approx(np.sin(0.04), rel=1e-10)
