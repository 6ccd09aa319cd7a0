"""Markers, letters and lines of special points and boundaries, in all pictures and on the page to explore."""

from stridemap.views import palette

MARKERS = {
    "fold": ("o", "LP"),
    "pd": ("D", "PD"),
    "ns": ("s", "NS"),
    "bp": ("*", "BP"),
    "grazing": ("|", "grazing"),
    "early_touchdown": ("v", "early touchdown"),
    "backward": ("<", "backward"),
    "fall": ("x", "fall"),
    "contact": ("^", "contact lost"),
    "friction": ("P", "friction"),
}
"""Marker and label of each type of special point; LP, PD, NS and BP are the field's letters."""

POINTS = {
    "cusp": ("o", "CP"),
    "gpd": ("D", "GPD"),
    "fold_flip": ("s", "LPPD"),
    "r1": ("^", "R1"),
    "r2": ("v", "R2"),
    "r3": ("<", "R3"),
    "r4": (">", "R4"),
    "fold_ns": ("P", "LPNS"),
    "pd_ns": ("X", "PDNS"),
    "corner": (".", "corner"),
}
"""Marker and label of each type of double point; CP to PDNS are the field's letters."""

BOUNDARY_NAMES = {
    "fold": "fold",
    "pd": "period doubling",
    "ns": "torus",
    "grazing": "grazing",
    "early_touchdown": "early touchdown",
    "backward": "backward",
    "fall": "fall",
    "contact": "contact lost",
    "friction": "friction",
    "period_limit": "period limit",
}
"""Each type of boundary in words."""

BOUNDARY_LINES: dict[str, tuple[str, tuple[float, ...]]] = {
    "fold": (palette.DARK, ()),
    "pd": (palette.VERMILION, (6, 2)),
    "ns": (palette.BLUE, (6, 2, 1, 2)),
    "grazing": (palette.GREEN, ()),
    "early_touchdown": (palette.GREEN, (4, 1.5)),
    "backward": (palette.GREEN, (1.5, 1.5)),
    "contact": (palette.PURPLE, ()),
    "friction": (palette.PURPLE, (4, 1.5)),
    "fall": (palette.PURPLE, (1.5, 1.5)),
    "period_limit": (palette.GREY, (1, 1.5)),
}
"""Colour and dashes, in line widths, of each type of boundary; no two types have the same of both."""
