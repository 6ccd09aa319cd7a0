"""The command line: ``stridemap orbit | sweep | simulate | derive | claims | figures | animate | report``.

Exit status: 0 found or done, 1 nothing found, 2 unusable input (one sentence on standard error).
"""

import errno
import json
import math
import os
import signal
import sys
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NoReturn

import typer

from stridemap.cli.animate import animate
from stridemap.cli.claims import claims
from stridemap.cli.figures import figures
from stridemap.cli.options import (
    FOUND,
    INTERRUPTED,
    NOTHING,
    PARAMETERS,
    UNUSABLE,
    JsonOption,
    ModelOption,
    SetOption,
    WithParameters,
    assign,
    parameters,
    split,
    whole,
)
from stridemap.cli.report import report
from stridemap.errors import InputError

if TYPE_CHECKING:
    from stridemap.solver.cycles.orbit import Orbit

# The base of all complaints about the command line; typer has it under varying module names.
_UsageError: Any = next(c for c in typer.BadParameter.__mro__ if c.__name__ == "ClickException")

app = typer.Typer(
    help="Limit cycles, Floquet multipliers and parameter sweeps of walking models.",
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)

app.command()(claims)
app.command()(figures)
app.command(cls=WithParameters, context_settings=PARAMETERS)(animate)
app.command()(report)


def main() -> NoReturn:
    """Run the command line; every error that the user can mend is one sentence and exit status 2."""
    warnings.showwarning = lambda message, *_: print(f"warning: {message}", file=sys.stderr)
    try:
        status = app(standalone_mode=False)
        sys.stdout.flush()
    except InputError as error:
        _fail(str(error))
    except _UsageError as error:
        command = getattr(getattr(error, "ctx", None), "command_path", "stridemap")
        _fail(f"{error.format_message().rstrip('.')}; see `{command} --help`")
    except (typer.Abort, KeyboardInterrupt):
        print("interrupted", file=sys.stderr)
        sys.exit(INTERRUPTED)
    except BrokenPipeError:
        # The reader (head, less) has seen enough; nothing more can be written to it.
        _discard_output()
        sys.exit(FOUND)
    except OSError as error:
        if error.errno not in (errno.ENOSPC, errno.EFBIG, errno.EIO):
            raise
        _discard_output()
        _fail(f"cannot write to standard output ({error.strerror}); make room or send it elsewhere")
    sys.exit(status if isinstance(status, int) else FOUND)


def _fail(sentence: str) -> NoReturn:
    # A name or path with a line break in it would make two lines of one.
    print(f"error: {' '.join(sentence.split())}", file=sys.stderr)
    sys.exit(UNUSABLE)


def _discard_output() -> None:
    """Send what is left for standard output nowhere, so that writing it does not fail again at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


@app.command(cls=WithParameters, context_settings=PARAMETERS)
def orbit(
    context: typer.Context,
    model: ModelOption = "wobbling",
    set_: SetOption = None,
    starts: Annotated[int, whole("Number of quasi-random starts.")] = 512,
    json_: JsonOption = False,
) -> int:
    """Print all limit cycles at one point of parameter space."""
    from stridemap.solver.cycles.search import SearchOptions, find_orbits
    from stridemap.solver.model.loading import load

    loaded = load(model)
    point = loaded.point(parameters(context.args, set_))
    orbits = find_orbits(loaded, point[None, :], SearchOptions(starts=starts))[0]
    if json_:
        params = dict(zip(loaded.preset, point.tolist(), strict=True))
        found = [o.to_dict() for o in orbits]
        print(json.dumps({"model": model, "params": params, "orbits": found}, indent=1, allow_nan=False))
    elif orbits:
        _print_orbits(orbits)
    else:
        print("no limit cycle found", file=sys.stderr)
    return FOUND if orbits else NOTHING


@app.command(cls=WithParameters, context_settings=PARAMETERS)
def simulate(
    context: typer.Context,
    model: ModelOption = "wobbling",
    set_: SetOption = None,
    state: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME=VALUE", help="An entry of the state just after touchdown; all or none."),
    ] = None,
    steps: Annotated[int, whole("Number of steps to walk.")] = 10,
    json_: JsonOption = False,
) -> int:
    """Walk from a state just after touchdown (by default the most stable limit cycle), step by step.

    The integrator is event-driven and shares nothing with the search for limit cycles.
    """
    from stridemap.solver.api import simulate as simulate_
    from stridemap.solver.model.loading import load

    params = parameters(context.args, set_)
    load(model).point(params)  # refuses a name that is no parameter, such as "steps"
    start: dict[str, Any] = {}
    for word in state or ():
        assign(start, *split(word, "--state"))
    walk = simulate_(model, start or None, steps=steps, **params)
    if json_:
        rows = [
            {"period": s.period, "step_length": s.step_length, "state": dict(s.state)} for s in walk.steps
        ]
        out = {"model": model, "params": dict(walk.params), "outcome": str(walk.outcome), "steps": rows}
        print(json.dumps(out, indent=1, allow_nan=False))
    else:
        names = list(walk.steps[0].state) if walk.steps else []
        table = [["step", "period", "length", *names]]
        for i, s in enumerate(walk.steps, 1):
            table.append(
                [str(i), f"{s.period:.9f}", f"{s.step_length:.9f}", *(f"{v:.9f}" for v in s.state.values())]
            )
        _print_table(table)
        print(f"{walk.outcome.value.replace('_', ' ')} after {len(walk.steps)} of {steps} steps")
    return FOUND if len(walk.steps) == steps else NOTHING


@app.command()
def sweep(
    config: Annotated[Path, typer.Argument(help="TOML file of the sweep.")],
    out: Annotated[Path, typer.Option(help="Output folder.")],
    workers: Annotated[int | None, whole("Number of processes; by default one a core.")] = None,
    resume: Annotated[bool, typer.Option("--resume", help="Continue from finished tiles.")] = False,
) -> int:
    """Find all limit cycles of a grid of parameters; writes orbits.parquet and cells.parquet."""
    from stridemap.cli.progress import show
    from stridemap.sweeps.run import sweep as sweep_

    # A terminated sweep ends like an interrupted one: workers are stopped, finished tiles stay.
    signal.signal(signal.SIGTERM, _interrupt)
    try:
        with show() as progress:
            summary = sweep_(config, out, workers=workers, resume=resume, progress=progress)
    except KeyboardInterrupt:
        print(f"interrupted: finished tiles are kept in {out}; continue with --resume", file=sys.stderr)
        return INTERRUPTED
    done = "was finished before" if summary.already_finished else "finished"
    failed = (
        f", {summary.failed_cells:,} cells failed (see the reasons in cells.parquet)"
        if summary.failed_cells
        else ""
    )
    print(
        f"sweep {done}: {summary.orbits:,} limit cycles ({summary.stable_orbits:,} stable) "
        f"in {summary.cells:,} cells{failed}; tables in {summary.folder}"
    )
    return FOUND if summary.orbits else NOTHING


def _interrupt(*_: object) -> NoReturn:
    raise KeyboardInterrupt


@app.command()
def derive(
    path: Annotated[
        Path | None, typer.Argument(help="Python file that declares a model; all built-in ones without it.")
    ] = None,
    out: Annotated[Path | None, typer.Option(help="Folder for the files of the model file.")] = None,
    check: Annotated[
        bool, typer.Option("--check", help="Write nothing; tell which generated files would change.")
    ] = False,
    keep: Annotated[
        bool, typer.Option("--keep", help="Leave files in the cache as they are, even if they were changed.")
    ] = False,
) -> int:
    """Derive a model and write its equations, C and kernels: a model file's, or all built-in ones'.

    A model file's go to --out, or into the user's cache; the built-in ones' into generated/.
    """
    from stridemap import codegen as build

    if path is not None and check:
        raise InputError("--check is for the built-in models; leave it out, or the path of the model file")
    if path is None and out is not None:
        raise InputError("--out is for a model file; give its path, or leave --out out")
    if path is not None:
        walker = build.declared(path)
        folder = build.into_cache(walker, keep) if out is None else build.into_folder(walker, out)
        for written in build.generated_files(folder):
            print(written)
        return FOUND
    if not check:
        for path in build.derive():
            print(path)
        return FOUND
    changed = build.drift()
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


@app.command()
def version() -> int:
    """Print the version."""
    from stridemap import __version__

    print(__version__)
    return FOUND


def _print_orbits(orbits: "list[Orbit]") -> None:
    rows: list[tuple[str, list[str]]] = [("status", [o.status.value for o in orbits])]
    rows += [(name, [f"{o.state[name]:.12f}" for o in orbits]) for name in orbits[0].state]
    rows.append(("period", [f"{o.period:.12f}" for o in orbits]))
    for i in range(len(orbits[0].multipliers)):
        rows.append((f"multiplier {i}", [_complex(o.multipliers[i]) for o in orbits]))
    plain = orbits[0].to_dict().keys() - {"status", "state", "period", "multipliers"}
    for name in [n for n in orbits[0].to_dict() if n in plain]:
        rows.append((name, [_cell(getattr(o, name)) for o in orbits]))
    _print_table(
        [["", *(f"cycle {i}" for i in range(1, len(orbits) + 1))], *([name, *cells] for name, cells in rows)]
    )


def _complex(value: complex) -> str:
    return f"{value.real:.10f}" if value.imag == 0 else f"{value.real:.10f}{value.imag:+.10f}i"


def _cell(value: Any) -> str:
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        if not math.isfinite(value):
            return "-"
        return f"{value:.10f}" if abs(value) >= 1e-3 else f"{value:.3e}"
    return str(value)


def _print_table(rows: list[list[str]]) -> None:
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    for row in rows:
        print(
            "  ".join(
                cell.ljust(w) if i == 0 else cell.rjust(w)
                for i, (cell, w) in enumerate(zip(row, widths, strict=True))
            )
        )
