"""Generated walkers, loaded."""

from typing import Any


def __getattr__(name: str) -> Any:
    if name == "Parameter":
        raise ImportError("stridemap.solver.model.Parameter is called stridemap.Parameter now")
    if name in ("load", "available"):
        raise ImportError(f"stridemap.solver.model.{name} is called stridemap.{name} now")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
