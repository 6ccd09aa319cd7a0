"""The wheel, built from the source distribution and installed into an environment of its own."""

import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

import stridemap
from stridemap.codegen import generated_folder
from stridemap.solver.model.loading import available, load

ROOT = Path(__file__).resolve().parents[2]
LEFT_OUT = shutil.ignore_patterns(
    ".*", "__pycache__", "*.egg-info", "build", "dist", "results", "docs", "tests", "benchmarks"
)

ASKED = """
import json, sys
import stridemap, stridemap.codegen, stridemap.solver.model.model, stridemap.sweeps.run
from importlib.resources import files
from stridemap.sweeps.config import load_config
from stridemap.sweeps.provenance import provenance
from stridemap.solver.backends.selection import load_kernels
model = stridemap.load("compass")
print(json.dumps({
    "modules": {name: m.__file__ for name, m in sys.modules.items() if name.split(".")[0] == "stridemap"},
    "bare": sorted({"derive", "generated", "solver", "sweeps"} & set(sys.modules)),
    "version": stridemap.__version__,
    "generated": str(stridemap.codegen.generated_folder()),
    "cells": load_config(str(files("stridemap.sweeps") / "paper.toml")).n_cells,
    "typed": (files("stridemap") / "py.typed").is_file(),
    "commit": provenance(load_kernels(model, None))["commit"],
}))
"""


def run(*command, **options):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """The wheel, built without network from a copy of the sources."""
    pytest.importorskip("build")
    folder = tmp_path_factory.mktemp("build")
    shutil.copytree(ROOT, folder / "source", ignore=LEFT_OUT)
    run(
        *(sys.executable, "-m", "build", "--no-isolation", "--outdir", folder / "dist", folder / "source"),
        env={**os.environ, "PIP_NO_INDEX": "1"},
    )
    (built,) = (folder / "dist").glob("*.whl")
    return built


@pytest.fixture(scope="module")
def installed(wheel, tmp_path_factory):
    """The scripts folder of a fresh environment with the wheel, which sees our requirements but not us."""
    folder = tmp_path_factory.mktemp("environment")
    run(sys.executable, "-m", "venv", "--without-pip", folder / "venv")
    # Somebody else's checkout around it, whose commit is not ours.
    author = ["-c", "user.name=somebody", "-c", "user.email=somebody@example.org"]
    if shutil.which("git"):
        run("git", "init", "--quiet", folder)
        run("git", "-C", folder, *author, "commit", "--quiet", "--allow-empty", "--message", "theirs")
    scripts = folder / "venv" / ("Scripts" if os.name == "nt" else "bin")
    python = scripts / Path(sys.executable).name
    run(
        *(sys.executable, "-m", "pip", "--disable-pip-version-check", "--python", python),
        *("install", "--no-deps", "--no-index", wheel),
    )
    site = Path(run(python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))").strip())
    # A path in a .pth file comes last, and .pth files found there (our editable install) are not read.
    requirements = [path for path in sys.path if Path(path).name in ("site-packages", "dist-packages")]
    (site / "requirements.pth").write_text("\n".join(requirements) + "\n")
    return scripts, site


def test_the_wheel_holds_the_package_and_all_of_it(wheel):
    setuptools = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["setuptools"]
    names = set(zipfile.ZipFile(wheel).namelist())
    assert {name.split("/")[0] for name in names} == {
        "stridemap",
        f"stridemap-{stridemap.__version__}.dist-info",
    }
    wanted = set()
    for package, folder in setuptools["package-dir"].items():
        for path in (ROOT / folder).rglob("*"):
            if path.is_file() and "__pycache__" not in path.parts and not path.name.startswith("."):
                wanted.add(f"{package.replace('.', '/')}/{path.relative_to(ROOT / folder).as_posix()}")
    held = {name for name in names if ".dist-info/" not in name}
    assert held == wanted
    for model in available():
        for name in ("manifest.json", f"{model}.c", f"{model}.h", f"{model}_kernels.c", f"{model}.py"):
            inside = zipfile.ZipFile(wheel).read(f"stridemap/generated/{model}/{name}")
            assert inside == (generated_folder() / model / name).read_bytes()
    assert any(name.endswith("dist-info/licenses/LICENSE") for name in names)


def test_the_installed_package_stands_alone(installed, tmp_path):
    scripts, site = installed
    tops = {path.name for path in site.iterdir()} - {"requirements.pth"}
    assert tops == {"stridemap", f"stridemap-{stridemap.__version__}.dist-info"}
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    here = {"cwd": tmp_path, "env": environment}
    found = json.loads(run(scripts / Path(sys.executable).name, "-c", ASKED, **here))
    assert [name for name, file in found["modules"].items() if not Path(file).is_relative_to(site)] == []
    assert {"stridemap.solver.cycles.search", "stridemap.derive.models", "stridemap.generated"} <= set(
        found["modules"]
    )
    assert found["bare"] == []
    assert found["version"] == stridemap.__version__
    assert Path(found["generated"]) == site / "stridemap" / "generated"
    assert found["cells"] == 16800
    assert found["typed"]
    assert found["commit"] is None
    words = ["orbit", "--model", "wobbling", "--k", "6", "--alpha", "0.25", "--omega", "3", "--json"]
    printed = json.loads(run(scripts / "stridemap", *words, **here))
    orbits = stridemap.find_orbits("wobbling", k=6, alpha=0.25, omega=3)
    assert printed["orbits"] == [orbit.to_dict() for orbit in orbits]
    assert len(orbits) == 2


def test_the_installed_package_sweeps(installed, tmp_path):
    (tmp_path / "my.toml").write_text('model = "compass"\n[grid]\nomega = [3.0]\n[search]\nstarts = 16\n')
    run(installed[0] / "stridemap", "sweep", "my.toml", "--out", "out", "--workers", "1", cwd=tmp_path)
    assert stridemap.read_cells(tmp_path / "out")["omega"].tolist() == [3.0]
    assert load("compass").hash == stridemap.sweeps.store.read_provenance(tmp_path / "out")["model_hash"]


def locked(file):
    """Version and hashes of each package of a lock file."""
    out, name = {}, ""
    for line in (ROOT / "requirements" / file).read_text("utf-8").splitlines():
        if found := re.match(r"([a-z0-9][\w.-]*)==([^ ;]+)", line):
            name = found[1]
            out[name] = {found[2]}
        out.setdefault(name, set()).update(re.findall(r"sha256:\w+", line))
    return out


def test_lock_files_agree_on_what_several_of_them_hold():
    """Each is made beside the others; a merge of two changes can leave the hashes of another version."""
    known = {}
    for file in ("run.txt", "pictures.txt", "dev.txt", "docs.txt"):
        for name, pinned in locked(file).items():
            assert known.setdefault(name, pinned) == pinned, f"{name} in {file}; run `make lock`"
    assert len(known) > 40
