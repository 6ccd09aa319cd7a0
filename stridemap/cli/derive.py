"""``stridemap derive``: equations, C and kernels of models, written, and a limit cycle beside them."""

import difflib
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stridemap.cli.options import (
    FOUND,
    NOTHING,
    DeriveTimeoutOption,
    PeriodNOption,
    SearchOption,
    SetOption,
    WithParameters,
    option_values,
    parameters,
    whole,
)
from stridemap.errors import InputError

if TYPE_CHECKING:
    from stridemap.solver.cycles.orbit import Orbit
    from stridemap.solver.cycles.orbits import Orbits

STABLE = "stable"


class WithModel(WithParameters):
    """A command whose help lists the parameters of the model that is its first word."""

    def format_epilog(self, ctx: Any, formatter: Any) -> None:
        """Write the model's parameters below the options."""
        first = ctx.meta.get("words", [])[:1]
        ctx.meta["words"] = [] if not first or first[0].startswith("-") else ["--model", *first]
        super().format_epilog(ctx, formatter)


def derive(
    context: typer.Context,
    model: Annotated[
        str | None,
        typer.Argument(
            metavar="MODEL",
            help="Python file that declares a model, or with --out the name of a built-in one; without it, "
            "all built-in ones.",
        ),
    ] = None,
    out: Annotated[Path | None, typer.Option(help="Folder for the files of the model.")] = None,
    check: Annotated[
        bool, typer.Option("--check", help="Write nothing; list the generated files that would change.")
    ] = False,
    cycle: Annotated[
        str | None,
        typer.Option(
            metavar="N|stable",
            help="Write a limit cycle, too, as a C header: this one, as `stridemap orbit` numbers them, or "
            "the most stable one.",
        ),
    ] = None,
    set_: SetOption = None,
    period_n: PeriodNOption = 1,
    starts: Annotated[
        int | None, whole("Number of quasi-random starts of the search; 512 by default.")
    ] = None,
    search: SearchOption = None,
    samples: Annotated[int | None, whole("Rows of the cycle's motion per step; 65 by default.")] = None,
    header: Annotated[
        str | None, typer.Option(metavar="NAME", help="Name of the cycle's header; MODEL_cycle by default.")
    ] = None,
    derive_timeout: DeriveTimeoutOption = None,
) -> int:
    """Derive a model and write its equations, C and kernels: a model file's, or all built-in ones'.

    A model file's go to --out, or into the user's cache; the built-in ones' into generated/. With --cycle and
    parameters, a limit cycle at that point goes to --out as well.
    """
    if model is not None and model.startswith("-"):
        raise _unknown_option(model, [name for option in context.command.params for name in option.opts])
    _check_words(context.args, model, out, check, cycle)
    if cycle is None:
        _refuse_of_cycles(set_, period_n, starts, search, samples, header)
    if model is None:
        return _built_in(check)
    if cycle is not None:
        assert out is not None
        point = {"params": parameters(context.args, set_), "period_n": period_n}
        how = option_values("--search", search) | ({} if starts is None else {"starts": starts})
        return _with_cycle(model, out, cycle, point, how, samples=samples, header=header)
    return _written(model, out)


def _unknown_option(word: str, known: list[str]) -> InputError:
    """That a word where the model is expected is a misspelt option."""
    close = difflib.get_close_matches(word, known, n=1)
    hint = f"did you mean {close[0]}? " if close else ""
    return InputError(f"there is no option {word}; {hint}see `stridemap derive --help`")


def _check_words(
    words: list[str], model: str | None, out: Path | None, check: bool, cycle: str | None
) -> None:
    """Refuse what does not go together."""
    if model is not None and check:
        raise InputError("--check is for the built-in models; leave it out, or the path of the model file")
    if cycle is not None and (model is None or out is None):
        raise InputError(
            "--cycle needs a model and a folder: stridemap derive MODEL --out DIR --cycle stable"
        )
    if cycle is None and words:
        what = f"{words[0]} is not understood; see `stridemap derive --help`"
        raise InputError(f"{what} (parameters are those of a limit cycle: they need --cycle)")
    if model is None and out is not None:
        raise InputError("--out is for one model; name it, or leave --out out")


def _refuse_of_cycles(set_: Any, period_n: int, *others: Any) -> None:
    """Refuse options that say which limit cycle and how, where none is asked for."""
    names = ("--starts", "--search", "--samples", "--header")
    given = {"--set": set_, **dict(zip(names, others, strict=True)), "--period-n": period_n != 1 or None}
    for name, value in given.items():
        if value is not None and value != []:
            raise InputError(f"{name} is for a limit cycle; add --cycle {STABLE}, or leave {name} out")


def _built_in(check: bool) -> int:
    """Write the files of all built-in models, or look at them."""
    from stridemap import codegen

    if not check:
        for path in codegen.derive():
            print(path)
        return FOUND
    changed = codegen.drift()
    for name in changed:
        print(f"differs: {name}")
    if changed:
        print(
            f"{len(changed)} generated files differ from the derivation; run `stridemap derive`",
            file=sys.stderr,
        )
        return NOTHING
    print("generated files are what the derivation writes")
    return FOUND


def _written(model: str, out: Path | None) -> int:
    """Write the files of one model."""
    from stridemap import codegen
    from stridemap.solver.model.derivation import derive_file
    from stridemap.solver.model.loading import available, load

    if model not in available() or Path(model).is_file():
        files = codegen.generated_files(derive_file(Path(model), out, keep=False))
    elif out is None:
        raise InputError(
            f"{model} is a built-in model, whose code comes with stridemap; add --out DIR to copy it"
        )
    else:
        files = codegen.copied(load(model), out)
    for path in files:
        print(path)
    return FOUND


def _with_cycle(
    model: str, out: Path, cycle: str, point: dict[str, Any], search: dict[str, Any], **header: Any
) -> int:
    """Write the files of a model and a limit cycle."""
    from stridemap.controller import write_c
    from stridemap.solver.api.points import find_orbits
    from stridemap.solver.options import SearchOptions

    if cycle != STABLE and not (cycle.isdecimal() and len(cycle) < 10):
        raise InputError(f"--cycle {cycle} is not allowed: a number from 1, or {STABLE}")
    orbits = find_orbits(model, **point, options=SearchOptions.from_mapping(search))
    if not len(orbits):
        print("no limit cycle found", file=sys.stderr)
        return NOTHING
    chosen = _chosen(orbits, cycle)
    if chosen is None:
        print(
            f"no cycle is stable at this point; --cycle 1 to {len(orbits)} writes an unstable one",
            file=sys.stderr,
        )
        return NOTHING
    for path in write_c(chosen, out, **header):
        print(path)
    return FOUND


def _chosen(orbits: "Orbits", cycle: str) -> "Orbit | None":
    """A cycle by its number, or the most stable one; None where none is stable."""
    if cycle == STABLE:
        best = min(orbits, key=lambda orbit: orbit.spectral_radius)
        return best if best.stable else None
    if not 1 <= int(cycle) <= len(orbits):
        raise InputError(f"--cycle {cycle} is not allowed: 1 to {len(orbits)} (the cycles at this point)")
    return orbits[int(cycle) - 1]
