"""Verdicts on statements of the paper, in words and marks."""

from collections.abc import Iterable

VERDICTS = {"holds": "✓", "in part": "◐", "differs": "✗"}
"""What a verdict may be, each with a mark that distinguishes it from the others without colour."""

_SAID = {
    "holds": ("holds", "hold"),
    "in part": ("holds in part", "hold in part"),
    "differs": ("differs", "differ"),
}


def tally(verdicts: Iterable[str]) -> str:
    """How many statements there are of each verdict, such as ``14 hold, 1 holds in part, none differs``."""
    found = list(verdicts)
    counts = {verdict: found.count(verdict) for verdict in VERDICTS}
    return ", ".join(f"{count or 'none'} {_SAID[verdict][count > 1]}" for verdict, count in counts.items())
