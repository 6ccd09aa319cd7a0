"""What several commands have in common: model, parameters, whole numbers, exit statuses, interrupts."""

import contextlib
import functools
import inspect
import itertools
import os
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any, NoReturn

import typer
import typer.core

from stridemap.cli.progress import be_quiet
from stridemap.errors import InputError

FOUND, NOTHING, UNUSABLE, INTERRUPTED = 0, 1, 2, 130
"""Exit statuses."""


# Model parameters are options of the commands that take a model (--k 6): which there are depends on the
# model, so they are taken from what is left on the command line.
PARAMETERS = {"allow_extra_args": True, "ignore_unknown_options": True}


class Commands(typer.core.TyperGroup):
    """All commands; what each does stands in their list uncut, in several lines where it has to."""

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """Write the list of commands."""
        rows = [(name, one.get_short_help_str(limit=1_000)) for name, one in self.commands.items()]
        with formatter.section("Commands"):
            formatter.write_dl(rows)


class WithParameters(typer.core.TyperCommand):
    """A command whose help lists the parameters of the model that is named together with ``--help``."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Keep the words, because the help is printed before the options are read."""
        ctx.meta["words"] = list(args)
        return super().parse_args(ctx, args)

    def format_epilog(self, ctx: Any, formatter: Any) -> None:
        """Write the model's parameters below the options."""
        from stridemap.solver.model.loading import load

        words = ctx.meta.get("words", [])
        named = [w.partition("=")[2] for w in words if w.startswith("--model=")]
        named += [after for word, after in itertools.pairwise(words) if word == "--model"]
        model = load(named[-1] if named else "wobbling")
        rows = []
        for a in model.parameters:
            default = f"{a.default:.6g}"
            rows.append((f"--{a.name} NUMBER", f"{a.meaning} [{a.unit}]; {a.allowed}; preset {default}"))
        with formatter.section(f"Parameters of the model {model.name} (also --set NAME=VALUE)"):
            formatter.write_dl(rows)


class WithRanges(WithParameters):
    """Such a command with several ``--range LOW HIGH``: typer knows no option of two values given twice."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Make one word of the two values of each range."""
        joined, rest = [], iter(args)
        for word in rest:
            joined.append(word)
            if word == "--range":
                low, high = next(rest, None), next(rest, None)
                if low is not None:
                    joined.append(low if high is None else f"{low} {high}")
        return super().parse_args(ctx, joined)


def number_pairs(words: list[str], option: str) -> list[tuple[float, float]]:
    """Pairs of numbers from words such as ``"0.5 30"``.

    Raises
    ------
    InputError
        Where a word is not two numbers.
    """
    pairs = []
    for word in words:
        try:
            low, high = map(float, word.split())
        except ValueError:
            raise InputError(f"{option} {word} is not understood: it takes two numbers, LOW HIGH") from None
        pairs.append((low, high))
    return pairs


def _count(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        raise typer.BadParameter(f"{text!r} is not a whole number; at least 1 is needed") from None


def whole(meaning: str) -> Any:
    """An option that takes a whole number; typer's own complaint does not say what was given."""
    return typer.Option(parser=_count, metavar="N", help=meaning)


ModelOption = Annotated[
    str, typer.Option("--model", help="Name of a built-in model, a model file (.py), or a derived folder.")
]
SetOption = Annotated[list[str] | None, typer.Option("--set", metavar="NAME=VALUE", help="Set a parameter.")]


def _set_derive_timeout(seconds: float | None) -> float | None:
    """Set the limit for this process, by the variable that holds it elsewhere too."""
    from stridemap.solver.model.derivation import VARIABLE, derive_timeout

    if seconds is not None:
        os.environ[VARIABLE] = repr(seconds)
        derive_timeout()  # refuses what is not allowed
    return seconds


DeriveTimeoutOption = Annotated[
    float | None,
    typer.Option(
        "--derive-timeout",
        metavar="SECONDS",
        callback=_set_derive_timeout,
        help="End the derivation of a model file after so long; by default after an hour.",
    ),
]
PeriodNOption = Annotated[int, whole("Number of walking steps after which the cycles close.")]
FrictionOption = Annotated[
    float | None,
    typer.Option("--friction-limit", help="Largest ratio of horizontal to vertical ground force of a gait."),
]
SearchOption = Annotated[
    list[str] | None,
    typer.Option(
        "--search", metavar="NAME=VALUE", help="An option of the search: seed, period_min, period_max, widen."
    ),
]
SearchBoxOption = Annotated[
    list[str] | None,
    typer.Option(
        metavar="NAME=LOW:HIGH", help="Where starts lie in an entry of the state; see --search widen=2."
    ),
]
ContinuationOption = Annotated[
    list[str] | None,
    typer.Option(
        "--continuation", metavar="NAME=VALUE", help="An option of the step control, such as ds_max."
    ),
]
TableOption = Annotated[
    Path | None, typer.Option("--out", metavar="FILE.parquet", help="Write all points as a table.")
]
TableArgument = Annotated[
    Path,
    typer.Argument(
        metavar="TABLE", help="Output folder of a sweep, or a table (.parquet, .csv) that stridemap wrote."
    ),
]
TableModelOption = Annotated[
    str | None,
    typer.Option(
        "--model", help="The table's model, where that is not a built-in one or a .csv does not say it."
    ),
]
CsvOption = Annotated[
    bool,
    typer.Option("--csv", help="Print comma-separated values and nothing else: one row per limit cycle."),
]
JsonOption = Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")]


def _set_quiet(quiet: bool) -> bool:
    """Show no progress in this process, where that is asked for."""
    if quiet:
        be_quiet()
    return quiet


QuietOption = Annotated[
    bool, typer.Option("--quiet", callback=_set_quiet, help="Do not show how far the command is.")
]


def with_quiet(command: Callable[..., int]) -> Callable[..., int]:
    """A command that takes ``--quiet`` too: all commands do, and none has to know."""

    @functools.wraps(command)
    def quieter(*args: Any, quiet: bool = False, **options: Any) -> int:
        return command(*args, **options)

    own = inspect.signature(command)
    more = inspect.Parameter("quiet", inspect.Parameter.KEYWORD_ONLY, default=False, annotation=QuietOption)
    quieter.__signature__ = own.replace(parameters=[*own.parameters.values(), more])  # type: ignore[attr-defined]
    quieter.__annotations__ = {**command.__annotations__, "quiet": QuietOption}
    return quieter


def one_format(json_: bool, csv: bool) -> None:
    """Refuse two formats for one output.

    Raises
    ------
    InputError
    """
    if json_ and csv:
        raise InputError("--json and --csv cannot be given together; leave one of them out")


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
        if name == "units":
            raise InputError(
                "--units is not an option of this command, whose parameters are in the model's units; "
                "stridemap orbit --units leg_length=...,mass=... shows a cycle in SI units, and "
                "stridemap.Units converts numbers"
            )
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
    """Enter a number, or the text itself where it is not one: whoever knows the allowed range refuses it."""
    if name in pairs:
        raise InputError(f"{name} is given twice")
    try:
        pairs[name] = float(text)
    except ValueError:
        pairs[name] = text


def option_values(option: str, assignments: list[str] | None) -> dict[str, Any]:
    """Options of a record from words ``NAME=VALUE``: whole numbers stay whole."""
    pairs: dict[str, Any] = {}
    for word in assignments or ():
        name, text = split(word, option)
        assign(pairs, name, text)
        with contextlib.suppress(ValueError):
            pairs[name] = int(text)
    return pairs


def box(ranges: list[str] | None, option: str = "--search-box") -> dict[str, tuple[float, float]]:
    """Ranges of values, such as a search box, from words ``NAME=LOW:HIGH``."""
    out: dict[str, tuple[float, float]] = {}
    for word in ranges or ():
        name, text = split(word, option)
        low, _, high = text.partition(":")
        try:
            ends = (float(low), float(high))
        except ValueError:
            raise InputError(
                f"{option} {word!r} is not understood; write {option} NAME=LOW:HIGH with two numbers"
            ) from None
        if name in out:
            raise InputError(f"{name} is given twice")
        out[name] = ends
    return out


def end_like_interrupted() -> None:
    """Treat a termination as an interrupt: workers are stopped, what is finished stays."""
    signal.signal(signal.SIGTERM, _interrupt)


def _interrupt(*_: object) -> NoReturn:
    raise KeyboardInterrupt
