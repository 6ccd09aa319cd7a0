"""Markers and letters of special points in pictures of branches and boundaries."""

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
