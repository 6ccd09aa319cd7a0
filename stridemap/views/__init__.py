"""What draws models and limit cycles: animations, plots, and the report of a sweep as a page to explore.

Only here and in the drawings of the paper is matplotlib imported, and only when something is drawn.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from stridemap.views.animation import animate
    from stridemap.views.boundary_map import boundary_map
    from stridemap.views.branch_diagram import branch_diagram
    from stridemap.views.plots import plot
    from stridemap.views.report.references import Reference
    from stridemap.views.report.write import ReportSummary, write_report
    from stridemap.views.scatter import plot_table

__all__ = [
    "Reference",
    "ReportSummary",
    "animate",
    "boundary_map",
    "branch_diagram",
    "plot",
    "plot_table",
    "write_report",
]

_HOMES = {
    "Reference": "report.references",
    "ReportSummary": "report.write",
    "animate": "animation",
    "boundary_map": "boundary_map",
    "branch_diagram": "branch_diagram",
    "plot": "plots",
    "plot_table": "scatter",
    "write_report": "report.write",
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return __all__
