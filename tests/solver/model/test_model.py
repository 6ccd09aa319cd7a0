"""A model as a value: found by name or path, sent to other processes with its generated files."""

import copy
import json
import pickle
import shutil
import subprocess
import sys

import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.solver.model.files import GENERATED, Folder
from stridemap.solver.model.loading import available, load
from stridemap.solver.model.model import Model

RUN_ELSEWHERE = """
import json, pickle, sys
from stridemap.solver.api.points import find_orbits
from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.options import SearchOptions
model = pickle.load(open(sys.argv[1], "rb"))
again = pickle.loads(pickle.dumps(model))
assert again is model
orbits = find_orbits(model, options=SearchOptions(starts=16), backend=sys.argv[2])
assert not any(name.split(".")[0] == "sympy" for name in sys.modules)
print(json.dumps([orbit.to_dict() for orbit in orbits]))
"""


def moved(tmp_path, name="compass"):
    """A model that is not the built-in one: generated files in a folder of its own."""
    folder = tmp_path / "mine"
    shutil.copytree(GENERATED / name, folder)
    return folder, load(folder)


@pytest.mark.quick
def test_a_loaded_model_stays_what_it_is():
    model = load("compass")
    assert load(model) is model is load("compass")
    assert copy.copy(model) is copy.deepcopy(model) is model
    assert pickle.loads(pickle.dumps(model)) is model  # in the process that sent it


@pytest.mark.parametrize("backend", [pytest.param("lanes", marks=pytest.mark.quick), "interpreter"])
def test_it_runs_in_a_fresh_process_when_its_folder_is_gone(tmp_path, backend):
    folder, model = moved(tmp_path)
    options = stridemap.SearchOptions(starts=16)
    wanted = [o.to_dict() for o in stridemap.find_orbits(model, options=options, backend=backend)]
    (tmp_path / "sent").write_bytes(pickle.dumps(model))
    shutil.rmtree(folder)
    command = [sys.executable, "-c", RUN_ELSEWHERE, tmp_path / "sent", backend]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, check=False)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == wanted
    assert len(wanted) >= 1


def test_only_what_running_needs_is_sent(tmp_path):
    _, model = moved(tmp_path)
    _, (source, _, pack) = model.__reduce__()
    assert set(pack) == {"manifest.json", "compass.py", "compass_kernels.c"}
    assert source == str(tmp_path / "mine")
    whole = sum(len(path.read_bytes()) for path in (GENERATED / "compass").iterdir() if path.is_file())
    assert len(pickle.dumps(model)) < whole / 3


@pytest.mark.quick
def test_a_changed_file_is_not_sent(tmp_path):
    folder, model = moved(tmp_path)
    with (folder / "compass_kernels.c").open("a") as file:
        file.write("\n")
    with pytest.raises(InputError, match=r"compass_kernels.c is not the file that manifest.json names"):
        pickle.dumps(model)


def test_files_that_were_not_sent_are_named(tmp_path):
    folder, model = moved(tmp_path)
    rebuild, (source, digest, pack) = model.__reduce__()
    shutil.rmtree(folder)
    arrived = rebuild(source + " elsewhere", digest, pack)
    assert arrived.spec == model.spec
    assert arrived.equations.mass_matrix
    with pytest.raises(
        InputError, match=r"cannot read the model that was sent along/compass\.c: the file was not sent"
    ):
        arrived.text("compass.c")


def test_a_folder_without_a_model_is_refused(tmp_path):
    with pytest.raises(InputError, match=r"does not hold a readable manifest.json"):
        Model(Folder(tmp_path), "mine")
    (tmp_path / "manifest.json").write_text("[]")
    with pytest.raises(InputError, match=r"does not hold a readable manifest.json|manifest"):
        load(tmp_path)


def test_models_that_there_are():
    assert {"compass", "goswami_compass", "rimless_wheel", "simplest_walker", "wobbling"} <= set(available())
    for name in available():
        model = load(name)
        assert (model.name, model.source, model.builtin) == (name, name, True)
        assert model.spec.section == model.section
    with pytest.raises(InputError, match="there is no model 'none'; models are compass"):
        load("none")
