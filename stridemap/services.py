"""What a lower room may ask of an upper one without importing it.

An orbit offers `Orbit.plot`, and the path of a model file can be given wherever a model's name can; but
drawing and deriving live above the solver, and imports go one way only. So the top of the package, which
knows every room, says here where such a service lives, and whoever needs it asks for it by name when it is
used.
"""

from collections.abc import Callable
from importlib import import_module
from typing import Any

_HOMES: dict[str, str] = {}


def provide(**homes: str) -> None:
    """State where services live, each as ``name="module:function"``."""
    _HOMES.update(homes)


def offered(name: str) -> bool:
    """Whether a service has been stated: some, such as showing progress, only a command offers."""
    return name in _HOMES


def service(name: str) -> Callable[..., Any]:
    """The function behind a service; its module is imported when it is first asked for."""
    module, _, function = _HOMES[name].partition(":")
    found: Callable[..., Any] = getattr(import_module(module), function)
    return found
