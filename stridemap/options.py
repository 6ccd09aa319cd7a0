"""What the options of several commands have in common: the model, its parameters, whole numbers."""

from typing import Annotated, Any

import typer

from stridemap.errors import InputError

FOUND, NOTHING, UNUSABLE, INTERRUPTED = 0, 1, 2, 130
"""Exit statuses."""

# Parameters are options of the commands that take a model (--k 6): which there are depends on the
# model, so they are taken from what is left on the command line.
PARAMETERS = {"allow_extra_args": True, "ignore_unknown_options": True}
EPILOG = (
    "Parameters of the model are options too: --k 6 --alpha 0.25 --omega 3 (the same as --set k=6 ...). "
    "What is not given comes from the model's preset. wobbling: k alpha omega beta Kp Kd S gamma; "
    "compass: omega beta Kp Kd S gamma."
)


def _count(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        raise typer.BadParameter(f"{text!r} is not a whole number; at least 1 is needed") from None


def whole(meaning: str) -> Any:
    """An option that takes a whole number; typer's own complaint does not say what was given."""
    return typer.Option(parser=_count, metavar="N", help=meaning)


ModelOption = Annotated[str, typer.Option("--model", help="Name of the model.")]
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
