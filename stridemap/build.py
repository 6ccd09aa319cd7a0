"""Writes ``generated/``: equations from `derive`, kernels from `solver`, and the manifest that names both."""

import hashlib
import json
import tempfile
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from typing import Any

from stridemap.derive.declaration import Walker
from stridemap.derive.emit import emit
from stridemap.derive.models import WALKERS
from stridemap.errors import InputError

MANIFEST = "manifest.json"


def generated_folder() -> Path:
    """Where the generated code of the built-in models lives."""
    face = Path(str(files("stridemap")))
    # In a checkout the parts of the package lie side by side; installed, they lie inside it.
    return face / "generated" if (face / "solver").is_dir() else face.parent / "generated"


def write_model(walker: Walker, folder: Path) -> list[Path]:
    """Derive one walker and write everything that is generated for it.

    Parameters
    ----------
    walker : Walker
    folder : pathlib.Path
        Made if it does not exist.

    Returns
    -------
    list of pathlib.Path
        The files, sorted.

    Raises
    ------
    InputError
        When the folder cannot be written.
    """
    from stridemap.solver.kernels import c_source
    from stridemap.solver.model import Model

    texts, manifest = emit(walker, f"stridemap {version('stridemap')}")
    # The kernels are printed from the equations as written; a half-written folder is never seen.
    with tempfile.TemporaryDirectory() as scratch:
        _write(Path(scratch), texts, manifest)
        texts[f"{walker.name}_kernels.c"] = c_source(Model(Path(scratch)))
    try:
        folder.mkdir(parents=True, exist_ok=True)
        _write(folder, texts, manifest)
    except OSError as error:
        raise InputError(f"cannot write {error.filename or folder}: {error.strerror}") from None
    return sorted(folder / name for name in [*texts, MANIFEST])


def _write(folder: Path, texts: dict[str, str], manifest: dict[str, Any]) -> None:
    hashes = {name: hashlib.sha256(text.encode()).hexdigest() for name, text in sorted(texts.items())}
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8", newline="\n")
    text = json.dumps({**manifest, "files": hashes}, indent=1) + "\n"
    (folder / MANIFEST).write_text(text, encoding="utf-8", newline="\n")


def derive(folder: Path | None = None) -> list[Path]:
    """Write the generated code of every built-in model.

    Parameters
    ----------
    folder : pathlib.Path, optional
        Holds one folder a model; by default the package's own.

    Raises
    ------
    InputError
        When the folder cannot be written.
    """
    target = folder or generated_folder()
    return [path for name, walker in WALKERS.items() for path in write_model(walker, target / name)]


def drift(folder: Path | None = None) -> list[str]:
    """Names of generated files that differ from what would be written now, without writing them.

    Parameters
    ----------
    folder : pathlib.Path, optional
        As for `derive`.
    """
    target = folder or generated_folder()
    with tempfile.TemporaryDirectory() as scratch:
        fresh = {path.relative_to(scratch): path.read_bytes() for path in derive(Path(scratch))}
    kept = (p for p in target.glob("*/*") if p.suffix not in (".pyc",) and p.is_file())
    present = {path.relative_to(target): path.read_bytes() for path in kept}
    return sorted(str(name) for name in fresh.keys() | present.keys() if fresh.get(name) != present.get(name))
