"""What the options of several commands have in common: parameters, whole numbers, exit statuses."""

from typing import Annotated, Any

import typer

from stridemap.errors import InputError

FOUND, NOTHING, UNUSABLE, INTERRUPTED = 0, 1, 2, 130
"""Exit statuses."""


def _count(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        raise typer.BadParameter(f"{text!r} is not a whole number; at least 1 is needed") from None


def whole(meaning: str) -> Any:
    """An option that takes a whole number; typer's own complaint does not say what was given."""
    return typer.Option(parser=_count, metavar="N", help=meaning)


SetOption = Annotated[list[str] | None, typer.Option("--set", metavar="NAME=VALUE", help="Set a parameter.")]
JsonOption = Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")]


def parameters(extra: list[str], assignments: list[str] | None) -> dict[str, Any]:
    """Model parameters from ``--name value``, ``--name=value`` and ``--set name=value``."""
    pairs: dict[str, Any] = {}
    rest = iter(extra)
    for word in rest:
        if not word.startswith("--"):
            raise InputError(
                f"{word!r} is not understood: parameters are given as --NAME VALUE or --set NAME=VALUE"
            )
        name, equals, value = word[2:].partition("=")
        text = value if equals else next(rest, None)
        if text is None or (text.startswith("--") and not equals):
            raise InputError(f"--{name} needs a value")
        assign(pairs, name, text)
    for word in assignments or ():
        assign(pairs, *split(word, "--set"))
    return pairs


def split(word: str, option: str) -> tuple[str, str]:
    """Name and value of a word ``NAME=VALUE``."""
    name, equals, text = word.partition("=")
    if not equals or not name:
        raise InputError(f"{option} {word!r} is not understood; write {option} NAME=VALUE")
    return name, text


def assign(pairs: dict[str, Any], name: str, text: str) -> None:
    """Enter a number, or the text itself where it is none: who knows the allowed range refuses it."""
    if name in pairs:
        raise InputError(f"{name} is given twice")
    try:
        pairs[name] = float(text)
    except ValueError:
        pairs[name] = text
