"""The paper of Kamimura and Sano (ICRA 2023): its statements decided, and its figures drawn, by computation.

One set of sweeps (`stridemap.paper.sweeps`) is behind all of it. `claims` decides the statements, `figures`
draws the figures, and `report` writes the map as a page to explore.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from stridemap.paper.claim import Claim, Verdict
    from stridemap.paper.drawings.draw import figures
    from stridemap.paper.evaluate import claims
    from stridemap.paper.map_report import report

__all__ = ["Claim", "Verdict", "claims", "figures", "report"]

# Imported when they are first used, so that whoever decides statements needs nothing that draws.
_HOMES = {
    "Claim": "claim",
    "Verdict": "claim",
    "claims": "evaluate",
    "figures": "drawings.draw",
    "report": "map_report",
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return __all__
