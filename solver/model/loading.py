"""Finding a model: by name, by the path of its file, or by the folder of its generated files."""

import hashlib
import os
from functools import cache
from pathlib import Path

from stridemap.errors import InputError, short
from stridemap.solver.model.derivation import derive_file
from stridemap.solver.model.files import GENERATED, MANIFEST, Folder, contents
from stridemap.solver.model.model import Model
from stridemap.words import hint


def available() -> list[str]:
    """Names of the built-in models."""
    return sorted(path.parent.name for path in GENERATED.glob(f"*/{MANIFEST}"))


def load(model: str | Path | Model) -> Model:
    """Load a model.

    Parameters
    ----------
    model : str, path or Model
        A built-in model's name; the path of a model file (``.py``), which is derived if that was not done
        before; or the folder that `stridemap derive` wrote. A model that is loaded is returned as it is.

    Raises
    ------
    InputError
        When there is no such model, or its file declares none.
    """
    if isinstance(model, Model):
        return model
    text = str(model)
    if text.endswith(".py"):
        return _loaded(_derived(Path(text)), text)
    if text in available():
        return _loaded(GENERATED / text, text)
    if os.path.exists(Path(text) / MANIFEST):
        return _loaded(Path(text).resolve(), text)
    raise InputError(
        f"there is no model {short(text)}{hint(text, available())}; models are {', '.join(available())}, or "
        "give the path of a model "
        "file (.py) or of a folder that `stridemap derive` wrote"
    )


def _derived(path: Path) -> Path:
    """Folder of the generated files of a model file; derived again only when a file of its folder changed."""
    if not os.path.isfile(path):  # of a name that is too long, too
        raise InputError(f"cannot read the model file {path}; give the path of a Python file (.py)")
    folder = sorted(path.resolve().parent.glob("*.py"))  # it may import them
    return _derived_once(path, path.resolve(), tuple((p.name, _changed(p)) for p in folder))


def _changed(path: Path) -> int:
    try:
        return path.stat().st_mtime_ns
    except OSError:  # a dangling link, say
        return 0


@cache
def _derived_once(path: Path, _resolved: Path, _folder: tuple[tuple[str, int], ...]) -> Path:
    return derive_file(path)


def _loaded(folder: Path, source: str) -> Model:
    try:
        manifest = contents(folder / MANIFEST)
    except OSError:
        manifest = b""  # `Model` reports it
    return _load(folder, source, hashlib.sha256(manifest).hexdigest())


@cache
def _load(folder: Path, source: str, _manifest: str) -> Model:
    return Model(Folder(folder), source)
