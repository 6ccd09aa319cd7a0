"""Errors that every room may raise. A leaf: importing it costs nothing."""

import re


def short(value: object, most: int = 100) -> str:
    """A value as a message quotes it: on one line, whatever its characters, and of bounded length."""
    try:
        text = ascii(value) if isinstance(value, str) and not value.isprintable() else repr(value)
    except Exception:  # a whole number of too many digits, or a class of the user's
        text = f"a {type(value).__name__} that cannot be printed"
    text = " ".join(text.split())
    return text if len(text) <= most else f"{text[: most - 3]}..."


LONGEST_WORD, LONGEST = 250, 800
"""Characters of a word or quotation, and of a sentence: what was given is quoted, not a whole file of it."""


_QUOTED = re.compile(r"""(?<!\w)(['"]).*?\1(?!\w)""", re.DOTALL)
"""What stands in quotation marks; an apostrophe within a word is none."""


class StridemapError(Exception):
    """The base of all errors that stridemap raises on purpose; the message is one sentence.

    The command line prints it as ``error: <sentence>`` without a traceback and exits with status 2.
    """

    def __init__(self, message: object = "", *rest: object) -> None:
        super().__init__(bounded(message) if isinstance(message, str) else message, *rest)


def bounded(sentence: str) -> str:
    """A sentence; it, its words and its quotations are cut in the middle where they are too long."""
    if len(sentence) > LONGEST_WORD:
        sentence = _QUOTED.sub(lambda quoted: _cut(quoted[0], LONGEST_WORD), sentence)
        words = (_cut(word, LONGEST_WORD) for word in sentence.split(" ", 10 * LONGEST))
        sentence = _cut(" ".join(words), LONGEST)
    return sentence


def _cut(text: str, most: int) -> str:
    return text if len(text) <= most else f"{text[: most // 2]}...{text[3 - most // 2 :]}"


class InputError(StridemapError, ValueError):
    """Unusable input: a bad value, file or option, reported in one sentence.

    The message names the offending value, where it stands, what is allowed and what to do.
    """


class CompilerError(StridemapError, RuntimeError):
    """The C compiler failed, or wrote something that cannot be loaded."""


class WorkerError(StridemapError, RuntimeError):
    """A worker process died, or computes with a different arithmetic than the process that began a sweep."""


class StorageError(StridemapError, RuntimeError):
    """A file or folder could not be written: no room, or no permission."""
