"""What a verdict is, and how the parts of a statement add up to it."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from types import MappingProxyType
from typing import Any

import numpy as np

from stridemap.paper.cycle_tables import CycleTables
from stridemap.views.small_figures import SmallFigure


class Verdict(StrEnum):
    """How a statement of the paper fares."""

    HOLDS = "holds"
    """All of its parts are true."""
    IN_PART = "in part"
    """Some of them are."""
    DIFFERS = "differs"
    """None of them is."""


@dataclass(frozen=True)
class Claim:
    """A statement of the paper with its verdict.

    Parameters
    ----------
    id : str
        C1 to C20.
    statement : str
    verdict : Verdict
    numbers : str
        The deciding numbers in a few words.
    evidence : mapping
        Plain values. ``parts`` has an entry for each part of the statement: whether it ``holds``, and the
        numbers that decide it.
    short : str
        The statement in a few words.
    where : str
        The section of the paper that says so.
    listed : mapping of str to str
        The deciding numbers of each pair of alpha and omega, where there are some for each.
    figure : SmallFigure, optional
        What decides it, as a drawing.
    """

    id: str
    statement: str
    verdict: Verdict
    numbers: str
    evidence: Mapping[str, Any]
    short: str = ""
    where: str = ""
    listed: Mapping[str, str] = field(default_factory=dict)
    figure: SmallFigure | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "evidence", MappingProxyType(dict(self.evidence)))
        object.__setattr__(self, "listed", MappingProxyType(dict(self.listed)))

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON."""
        return {
            "id": self.id,
            "statement": self.statement,
            "short": self.short,
            "where": self.where,
            "verdict": self.verdict.value,
            "numbers": self.numbers,
            "listed": dict(self.listed),
            "evidence": dict(self.evidence),
            "figure": None if self.figure is None else self.figure.to_dict(),
        }


@dataclass
class Parts:
    """The parts of a statement while it is being decided."""

    _entries: dict[str, dict[str, Any]] = field(default_factory=dict)

    def add(self, name: str, holds: Any, **numbers: Any) -> None:
        """Enter a part: whether it is true, and by which numbers."""
        if name in self._entries:
            raise ValueError(f"part {name!r} is entered twice")
        self._entries[name] = {"holds": bool(holds), **plain(numbers)}

    def verdict(self) -> Verdict:
        """Whether all, some or none of them are true; a statement about nothing that was found differs."""
        answers = [entry["holds"] for entry in self._entries.values()]
        if not any(answers):
            return Verdict.DIFFERS
        return Verdict.HOLDS if all(answers) else Verdict.IN_PART

    def failing(self) -> list[str]:
        """Names of the parts that are not true."""
        return [name for name, entry in self._entries.items() if not entry["holds"]]

    def __len__(self) -> int:
        return len(self._entries)

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON."""
        return dict(self._entries)


@dataclass(frozen=True)
class Listed:
    """Deciding numbers at each pair of alpha and omega: what they are, and they by the name of the pair."""

    what: str
    values: Mapping[str, str]

    def __str__(self) -> str:
        return f"{self.what}: {', '.join(self.values.values())}"


Decided = tuple[Parts, str | Listed, dict[str, Any]]
"""The parts of a statement, the deciding numbers in a few words, and further evidence."""


@dataclass(frozen=True)
class Statement:
    """A statement of the paper, the function that decides it, and the one that draws what decides it."""

    id: str
    text: str
    decide: Callable[[CycleTables], Decided]
    short: str = ""
    where: str = ""
    figure: Callable[[CycleTables, Mapping[str, Any]], SmallFigure] | None = None

    def __call__(self, data: CycleTables) -> Claim:
        """Decide the statement."""
        parts, said, further = self.decide(data)
        numbers, listed = str(said), said.values if isinstance(said, Listed) else {}
        if failing := parts.failing():
            named = ", ".join(failing[:4]) + (f" and {len(failing) - 4} more" if len(failing) > 4 else "")
            numbers = f"{numbers}; not so: {named}" if numbers else f"not so: {named}"
        evidence = {"parts": parts.to_dict(), **plain(further)}
        return Claim(
            self.id,
            self.text,
            parts.verdict(),
            numbers,
            evidence,
            self.short or self.text,
            self.where,
            listed,
        )

    def drawn(self, data: CycleTables) -> Claim:
        """Decide the statement, and draw what decides it."""
        claim = self(data)
        return replace(claim, figure=self.figure(data, claim.evidence)) if self.figure else claim


def statement(
    id_: str,
    text: str,
    *,
    short: str = "",
    where: str = "",
    figure: Callable[[CycleTables, Mapping[str, Any]], SmallFigure] | None = None,
) -> Callable[[Callable[[CycleTables], Decided]], Statement]:
    """Declare the function below as the one that decides a statement.

    Parameters
    ----------
    id_, text : str
    short : str
        The statement in a few words, for a line on a terminal; by default all of it.
    where : str
        The section of the paper that says so.
    figure : callable, optional
        Draws what decides it, from the tables and the evidence.
    """
    return lambda decide: Statement(id_, text, decide, short, where, figure)


def shown(value: float, form: str) -> str:
    """A number in a given form; a dash for NaN."""
    return "-" if math.isnan(value) else format(value, form)


def plain(value: Any) -> Any:
    """A value as JSON has it: numbers of NumPy as Python's, what is not a finite number as None.

    Floats are rounded to 9 digits, which is less than an orbit is good for and more than a verdict needs.
    """
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple | np.ndarray):
        return [plain(item) for item in value]
    if isinstance(value, bool | np.bool_):
        return bool(value)
    if isinstance(value, int | np.integer):
        return int(value)
    if isinstance(value, float | np.floating):
        return float(f"{value:.9g}") if math.isfinite(value) else None
    return value
