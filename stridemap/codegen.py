"""Writes ``generated/``: equations from `derive`, kernels from `solver`, and the manifest that names both."""

import contextlib
import hashlib
import importlib.util
import json
import os
import sys
import tempfile
import traceback
from collections.abc import Callable, Mapping
from dataclasses import replace
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from types import ModuleType
from typing import Any

from stridemap.derive.emit import emit
from stridemap.derive.fingerprint import fingerprint
from stridemap.derive.models import WALKERS
from stridemap.derive.walker import Walker
from stridemap.errors import InputError
from stridemap.services import shown
from stridemap.solver.backends.compiler import cache_folder
from stridemap.solver.model import derivation
from stridemap.solver.model.files import MANIFEST, Folder, contents, kernels_file
from stridemap.solver.model.loading import load
from stridemap.solver.model.model import Model
from stridemap.spec import ModelSpec


def generated_folder() -> Path:
    """Where the generated code of the built-in models lives."""
    package = Path(str(files("stridemap")))
    # In a checkout the parts of the package lie side by side; installed, they lie inside it.
    return package / "generated" if (package / "solver").is_dir() else package.parent / "generated"


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
    # Only here: SciPy takes half of the start of a process, in which most models are found in the cache.
    from stridemap.solver.kernels.catalogue import c_source

    with shown(f"deriving {walker.name}", "functions", announced=True) as update:

        def progress(done: int, total: int, name: str) -> None:
            update(done, total, f"{name} done" if done < total else "writing the kernels")

        texts, spec = emit(walker, f"stridemap {version('stridemap')}", progress)
        # The kernels are printed from the equations as written; a half-written folder is never seen.
        with tempfile.TemporaryDirectory() as scratch:
            _write(Path(scratch), texts, spec)
            texts[kernels_file(walker.name)] = c_source(Model(Folder(Path(scratch)), walker.name))
    try:
        folder.mkdir(parents=True, exist_ok=True)
        _write(folder, texts, spec)  # the manifest last: it names the others
    except OSError as error:
        raise _unwritable(folder, error) from error
    return sorted(folder / name for name in [*texts, MANIFEST])


def _write(folder: Path, texts: dict[str, str], spec: ModelSpec) -> None:
    hashes = {name: _digest(text.encode()) for name, text in sorted(texts.items())}
    text = json.dumps(replace(spec, files=hashes).to_manifest(), indent=1) + "\n"
    for name, content in [*texts.items(), (MANIFEST, text)]:
        _put(folder / name, content.encode())


def _put(path: Path, content: bytes) -> None:
    # Beside and renamed: another process, which may write the same, never sees half a file.
    scratch = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        scratch.write_bytes(content)
        scratch.replace(path)
    finally:
        scratch.unlink(missing_ok=True)


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def derive_model(model: Walker | str | Path, out: str | Path | None = None) -> Model:
    """Derive a walker of your own and load it.

    Parameters
    ----------
    model : stridemap.derive.Walker, or path
        A declaration, or the Python file that has one under the name ``WALKER``.
    out : path, optional
        Folder for the generated files; by default the user's cache, where equal declarations share theirs.

    Returns
    -------
    Model
        It stands wherever a model's name does: ``stridemap.find_orbits(model, k=2)``.

    Raises
    ------
    InputError
        When the declaration contradicts itself or bears the name of a built-in model, when the file has none,
        or when the folder cannot be written.
    """
    if not isinstance(model, Walker):  # in a process of its own
        return load(derivation.derive_file(Path(model), None if out is None else Path(out), keep=False))
    walker = _own(model)
    return load(into_cache(walker) if out is None else into_folder(walker, Path(out)))


def into_folder(walker: Walker, folder: Path) -> Path:
    """Write the generated code of a walker into a folder of the user's; returns it.

    Raises
    ------
    InputError
        When the folder cannot be written, or files in it that are not of this model would be lost.
    """
    check_folder(folder, walker.name)
    try:
        cached = _into_cache(walker)
    except InputError as error:
        if not isinstance(error.__cause__, OSError):
            raise
        write_model(walker, folder)  # there is no cache that can be written
        return folder
    _copy(cached, folder)
    return folder


def check_folder(folder: Path, model: str) -> None:
    """Refuse a folder in which files that are not of a model would be lost.

    Parameters
    ----------
    folder : pathlib.Path
    model : str
        Name of the model whose files are to be written.

    Raises
    ------
    InputError
        When there are such files, or the folder cannot be looked into.
    """
    names = ("README.md", "example.c", MANIFEST)  # those that do not bear the model's name
    try:
        present = [name for name in names if (folder / name).exists()]
    except OSError as error:  # a name that is longer than the file system allows, for instance
        raise _unwritable(folder, error) from error
    if present and _manifest_in(folder).get("name") != model:
        raise InputError(
            f"{folder / present[0]} does not belong to the model {model} and would be overwritten; "
            "give --out another folder"
        )


def _copy(source: Path, folder: Path) -> None:
    """Copy a model's files, the manifest last: it names the others."""
    names = [*_manifest_in(source)["files"], MANIFEST]
    put_all(folder, {name: (source / name).read_bytes() for name in names})


def copied(model: Model, folder: Path) -> list[Path]:
    """Copy the generated files of a model into a folder; returns them, sorted.

    Raises
    ------
    InputError
        When the folder cannot be written, or files in it that are not of this model would be lost.
    """
    check_folder(folder, model.name)
    return sorted(put_all(folder, contents_of(model)))


def _unwritable(folder: Path, error: OSError) -> InputError:
    """That files cannot be written into a folder."""
    reason = "it is a file" if os.path.isfile(folder) else error.strerror  # of too long a name, too
    return InputError(f"cannot write {folder} ({reason}); give a folder that can be written")


def contents_of(model: Model) -> dict[str, bytes]:
    """The generated files of a model by name, the manifest last: it names the others."""
    return {name: model.text(name).encode() for name in model.spec.files} | {
        MANIFEST: model.files.read(MANIFEST)
    }


def put_all(folder: Path, files: Mapping[str, bytes]) -> list[Path]:
    """Write files into a folder, which is made if it does not exist; returns their paths in order.

    Raises
    ------
    InputError
        When the folder cannot be written.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, content in files.items():
            _put(folder / name, content)
    except OSError as error:
        raise _unwritable(folder, error) from error
    return [folder / name for name in files]


def into_cache(walker: Walker, keep: bool = False) -> Path:
    """Write the generated code of a walker into the user's cache, unless it is there; returns the folder.

    Parameters
    ----------
    walker : Walker
    keep : bool
        Whether files that are there stay even if they were changed since; loading them then refuses.
    """
    try:
        return _into_cache(walker, keep)
    except InputError as error:
        raise InputError(
            f"{error}; set STRIDEMAP_CACHE to a folder that can be written, or derive with --out"
            if isinstance(error.__cause__, OSError)
            else str(error)
        ) from None


def _into_cache(walker: Walker, keep: bool = False) -> Path:
    folder = cache_folder() / "models" / f"{walker.name}-{fingerprint(walker)[:32]}"
    manifest = _manifest_in(folder)
    if not manifest or not (keep or _intact(folder, manifest)):
        write_model(walker, folder)
    return folder


def _manifest_in(folder: Path) -> dict[str, Any]:
    """The manifest in a folder; empty where none can be read."""
    try:
        found = json.loads(contents(folder / MANIFEST).decode("utf-8"))
    except (OSError, ValueError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}


def derive_file(
    path: Path, out: Path | None = None, keep: bool = True, declared_: Callable[[], None] = lambda: None
) -> Path:
    """Run a model file in this process and derive what it declares; see `derivation.derive_file`.

    `declared_` is called between the two.
    """
    walker = declared(path)
    declared_()
    return into_cache(walker, keep) if out is None else into_folder(walker, out)


def generated_files(folder: Path) -> list[Path]:
    """What the manifest in a folder names, and the manifest, sorted."""
    return sorted(folder / name for name in [*_manifest_in(folder).get("files", {}), MANIFEST])


def _intact(folder: Path, manifest: Mapping[str, Any]) -> bool:
    """Whether every file is the one that the manifest names."""
    try:
        return all(_digest(contents(folder / name)) == d for name, d in manifest["files"].items())
    except (OSError, KeyError, ValueError, AttributeError, TypeError):
        return False


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
    walker = getattr(_run(path.resolve(), path), "WALKER", None)
    if not isinstance(walker, Walker):
        found = "has no WALKER" if walker is None else f"has a WALKER that is a {type(walker).__name__}"
        raise InputError(f"{path} {found}; write WALKER = Walker(...) with stridemap.derive.Walker")
    return _own(walker)


def _own(walker: Walker) -> Walker:
    """`walker`, unless it bears the name of another one that comes with stridemap.

    Raises
    ------
    InputError
        When it does.
    """
    if walker.name in WALKERS and walker != WALKERS[walker.name]:
        raise InputError(
            f"model {walker.name}: this is the name of a built-in model; choose another name for yours, such "
            f"as my_{walker.name}"
        )
    return walker


def _run(path: Path, shown: Path) -> ModuleType:
    """Run a Python file as a module of its own, with the files beside it in reach, as for a script."""
    name = f"stridemap_model_{path.stem}"
    spec = importlib.util.spec_from_file_location(name, path)
    if not path.is_file() or spec is None or spec.loader is None:
        raise InputError(f"cannot read the model file {shown}; give the path of a Python file (.py)")
    module = importlib.util.module_from_spec(spec)
    before = set(sys.modules)
    sys.modules[name] = module  # dataclasses look there
    sys.path.insert(0, str(path.parent))
    # From the source: after an edit within a second that keeps the size, old bytecode would be taken for new.
    importlib.invalidate_caches()
    kept, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    try:
        with contextlib.redirect_stdout(sys.stderr):  # ours is for results
            exec(compile(path.read_bytes(), str(path), "exec"), vars(module))
    except InputError:
        raise
    except (Exception, SystemExit) as error:
        where, said = _position(path, error)
        raise InputError(f"{shown}{where}: {type(error).__name__}: {said}") from error
    finally:
        sys.dont_write_bytecode = kept
        sys.path.remove(str(path.parent))
        # What lies beside it is read anew the next time, and is not mistaken for another file's neighbour.
        for other in set(sys.modules) - before:
            file = getattr(sys.modules[other], "__file__", None)
            if file is not None and Path(file).parent == path.parent:
                del sys.modules[other]
    return module


def _position(path: Path, error: BaseException) -> tuple[str, str]:
    """Where in a model file an exception arose, and what it says."""
    if isinstance(error, SyntaxError) and error.filename == str(path):
        return f", line {error.lineno}", error.msg
    lines = [f.lineno for f in traceback.extract_tb(error.__traceback__) if f.filename == str(path)]
    return (f", line {lines[-1]}" if lines else ""), str(error) or "no message"


def derive(folder: Path | None = None) -> list[Path]:
    """Write the generated code of every built-in model.

    Parameters
    ----------
    folder : pathlib.Path, optional
        Holds one folder for each model; by default the package's own.

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
