"""Writes ``generated/``: equations from `derive`, kernels from `solver`, and the manifest that names both."""

import hashlib
import importlib.util
import json
import sys
import tempfile
import traceback
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from typing import Any

import sympy as sp

from stridemap.derive.declaration import Walker
from stridemap.derive.emit import emit
from stridemap.derive.models import WALKERS
from stridemap.errors import InputError
from stridemap.solver.compiler import cache_folder

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
        _write(folder, texts, manifest)  # the manifest last: it names the others
    except OSError as error:
        raise InputError(f"cannot write {error.filename or folder}: {error.strerror}") from None
    return sorted(folder / name for name in [*texts, MANIFEST])


def _write(folder: Path, texts: dict[str, str], manifest: dict[str, Any]) -> None:
    hashes = {name: hashlib.sha256(text.encode()).hexdigest() for name, text in sorted(texts.items())}
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8", newline="\n")
    text = json.dumps({**manifest, "files": hashes}, indent=1) + "\n"
    (folder / MANIFEST).write_text(text, encoding="utf-8", newline="\n")


def declared(path: Path) -> Walker:
    """The walker that a Python file declares under the name ``WALKER``.

    Parameters
    ----------
    path : pathlib.Path

    Raises
    ------
    InputError
        When the file cannot be read or run, or declares none.
    """
    spec = importlib.util.spec_from_file_location(f"stridemap_model_{path.stem}", path)
    if not path.is_file() or spec is None or spec.loader is None:
        raise InputError(f"cannot read the model file {path}; give the path of a Python file")
    module = importlib.util.module_from_spec(spec)
    sys.path.insert(0, str(path.resolve().parent))  # as for a script: files beside it can be imported
    try:
        spec.loader.exec_module(module)
    except InputError:
        raise
    except Exception as error:
        place = _line_in(path, error)
        raise InputError(f"{path}{place}: {type(error).__name__}: {error}") from error
    finally:
        sys.path.pop(0)
    walker = getattr(module, "WALKER", None)
    if not isinstance(walker, Walker):
        raise InputError(
            f"{path} declares no walker; it must have WALKER = Walker(...), with stridemap.derive.Walker"
        )
    return walker


def _line_in(path: Path, error: BaseException) -> str:
    """Where in a model file an exception arose."""
    if isinstance(error, SyntaxError):
        return f", line {error.lineno}"
    lines = [f.lineno for f in traceback.extract_tb(error.__traceback__) if Path(f.filename) == path]
    return f", line {lines[-1]}" if lines else ""


def derive_file(path: Path, folder: Path | None = None) -> list[Path]:
    """Write the generated code of a model file.

    Parameters
    ----------
    path : pathlib.Path
        Python file that declares a walker.
    folder : pathlib.Path, optional
        Where the files go; by default into the user's cache, unless they are there already.

    Raises
    ------
    InputError
        When the file declares no walker that can be derived, or the folder cannot be written.
    """
    walker = declared(path)
    if folder is not None:
        return write_model(walker, folder)
    target = cache_folder() / "models" / f"{walker.name}-{fingerprint(walker)[:32]}"
    if not (target / MANIFEST).exists():
        write_model(walker, target)
    return sorted(p for p in target.iterdir() if p.is_file())


def fingerprint(walker: Walker) -> str:
    """SHA-256 of everything that the generated code of a walker depends on."""
    versions = [f"{name} {version(name)}" for name in ("stridemap", "sympy", "casadi")]
    sources = [p.read_bytes() for part in ("derive", "solver") for p in sorted(_part(part).glob("*.py"))]
    key = hashlib.sha256("\n".join([*versions, _described(walker)]).encode())
    for text in sources:
        key.update(hashlib.sha256(text).digest())
    return key.hexdigest()


def _part(name: str) -> Path:
    return Path(str(files(f"stridemap.{name}")))


def _described(value: Any) -> str:
    """A declaration as text that is equal for equal declarations only."""
    if isinstance(value, sp.Basic | sp.MatrixBase):
        return sp.srepr(value)
    if is_dataclass(value) and not isinstance(value, type):
        inner = ", ".join(f"{f.name}={_described(getattr(value, f.name))}" for f in fields(value))
        return f"{type(value).__name__}({inner})"
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_described(k)}: {_described(v)}" for k, v in value.items()) + "}"
    if isinstance(value, tuple | list):
        return "(" + ", ".join(map(_described, value)) + ")"
    return repr(value)


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
