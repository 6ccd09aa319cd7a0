"""What the generated code of a walker depends on, as one hash: the cache keeps models under it."""

import hashlib
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from typing import Any

import sympy as sp

from stridemap.derive.walker import Walker


def fingerprint(walker: Walker) -> str:
    """SHA-256 of everything that the generated code of a walker depends on."""
    versions = [f"{name} {version(name)}" for name in ("stridemap", "sympy", "casadi")]
    paths = [_part("") / name for name in ("codegen.py", "quantities.py", "spec.py", "words.py")]
    paths += [path for part in (".derive", ".solver") for path in sorted(_part(part).rglob("*.py"))]
    sources = [path.read_bytes() for path in paths]
    key = hashlib.sha256("\n".join([*versions, _described(walker)]).encode())
    for text in sources:
        key.update(hashlib.sha256(text).digest())
    return key.hexdigest()


def _part(name: str) -> Path:
    return Path(str(files(f"stridemap{name}")))


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
