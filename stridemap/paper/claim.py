"""What a verdict is, and how the parts of a statement add up to it."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from types import MappingProxyType
from typing import Any

import numpy as np

from stridemap.paper.cycle_tables import CycleTables


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
    """

    id: str
    statement: str
    verdict: Verdict
    numbers: str
    evidence: Mapping[str, Any]

    def __post_init__(self) -> None:
        object.__setattr__(self, "evidence", MappingProxyType(dict(self.evidence)))

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON."""
        return {
            "id": self.id,
            "statement": self.statement,
            "verdict": self.verdict.value,
            "numbers": self.numbers,
            "evidence": dict(self.evidence),
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


Decided = tuple[Parts, str, dict[str, Any]]
"""The parts of a statement, the deciding numbers in a few words, and further evidence."""


@dataclass(frozen=True)
class Statement:
    """A statement of the paper and the function that decides it."""

    id: str
    text: str
    decide: Callable[[CycleTables], Decided]

    def __call__(self, data: CycleTables) -> Claim:
        """Decide the statement."""
        parts, numbers, further = self.decide(data)
        if failing := parts.failing():
            named = ", ".join(failing[:4]) + (f" and {len(failing) - 4} more" if len(failing) > 4 else "")
            numbers = f"{numbers}; not so: {named}" if numbers else f"not so: {named}"
        evidence = {"parts": parts.to_dict(), **plain(further)}
        return Claim(self.id, self.text, parts.verdict(), numbers, evidence)


def statement(id_: str, text: str) -> Callable[[Callable[[CycleTables], Decided]], Statement]:
    """Declare the function below as the one that decides a statement."""
    return lambda decide: Statement(id_, text, decide)


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
