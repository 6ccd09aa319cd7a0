"""``stridemap derive``: equations, C and kernels of models, written."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from stridemap.cli.options import FOUND, NOTHING, DeriveTimeoutOption
from stridemap.errors import InputError


def derive(
    path: Annotated[
        Path | None, typer.Argument(help="Python file that declares a model; all built-in ones without it.")
    ] = None,
    out: Annotated[Path | None, typer.Option(help="Folder for the files of the model file.")] = None,
    check: Annotated[
        bool, typer.Option("--check", help="Write nothing; list the generated files that would change.")
    ] = False,
    derive_timeout: DeriveTimeoutOption = None,
) -> int:
    """Derive a model and write its equations, C and kernels: a model file's, or all built-in ones'.

    A model file's go to --out, or into the user's cache; the built-in ones' into generated/.
    """
    from stridemap import codegen
    from stridemap.solver.model.derivation import derive_file

    if path is not None and check:
        raise InputError("--check is for the built-in models; leave it out, or the path of the model file")
    if path is None and out is not None:
        raise InputError("--out is for a model file; give its path, or leave --out out")
    if path is not None:
        for written in codegen.generated_files(derive_file(path, out, keep=False)):
            print(written)
        return FOUND
    if not check:
        for path in codegen.derive():
            print(path)
        return FOUND
    changed = codegen.drift()
    for name in changed:
        print(f"differs: {name}")
    if changed:
        print(
            f"{len(changed)} generated files differ from the derivation; run `stridemap derive`",
            file=sys.stderr,
        )
        return NOTHING
    print("generated files are what the derivation writes")
    return FOUND
