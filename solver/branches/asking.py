"""Searches that ask, so that many of them are answered in one call of a kernel.

A search is a generator: where it needs what a kernel computes it yields a `Question`, is sent the answer, and
in the end returns what it has found. One that runs alone is answered at once. Of those that run together all
questions of one kind are answered together, in one call of a kernel for many points, which takes hardly
longer than one for a single point. What a search finds does not depend on the others.
"""

from abc import ABC, abstractmethod
from collections.abc import Generator, Hashable, Iterable, Sequence
from typing import Any, Generic, Self, TypeVar

A = TypeVar("A")
T = TypeVar("T")


class Question(ABC, Generic[A]):
    """What a search asks for."""

    @property
    @abstractmethod
    def kind(self) -> Hashable:
        """Questions of one class and kind can be answered together."""

    @classmethod
    @abstractmethod
    def answers(cls, questions: Sequence[Self]) -> Sequence[A]:
        """Answers to questions of one kind, in their order."""


Asking = Generator[Question[Any], Any, T]
"""A search that returns a T."""


def asked(question: Question[A]) -> Asking[A]:
    """The answer to a question."""
    answer: A = yield question
    return answer


def alone(search: Asking[T]) -> T:
    """What a search returns that runs alone."""
    return together([search])[0]


def together(searches: Iterable[Asking[T]]) -> list[T]:
    """What searches return that run together, in their order."""
    running = dict(enumerate(searches))
    returned: dict[int, T] = {}
    answers: dict[int, Any] = dict.fromkeys(running)
    while answers:
        asking: dict[tuple[type[Question[Any]], Hashable], list[tuple[int, Question[Any]]]] = {}
        for number, answer in sorted(answers.items()):
            try:
                question = running[number].send(answer)
            except StopIteration as stop:
                returned[number] = stop.value
            else:
                asking.setdefault((type(question), question.kind), []).append((number, question))
        answers = {}
        for (kind, _), some in asking.items():
            given = kind.answers([question for _, question in some])
            answers |= zip((number for number, _ in some), given, strict=True)
    return [returned[number] for number in running]
