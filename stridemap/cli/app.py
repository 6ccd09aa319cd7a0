"""The command line: which commands there are, and what becomes of their errors.

Exit status: 0 found or done, 1 nothing found, 2 unusable input or a failure that is explained in one sentence
on standard error.
"""

import contextlib
import errno
import os
import sys
import warnings
from collections.abc import Callable
from typing import Annotated, Any, NoReturn

import typer

from stridemap.cli.animate import animate
from stridemap.cli.boundary import boundary
from stridemap.cli.branch import branch
from stridemap.cli.claims import claims
from stridemap.cli.completion import completion
from stridemap.cli.derive import WithModel, derive
from stridemap.cli.export import export
from stridemap.cli.figures import figures
from stridemap.cli.find import find
from stridemap.cli.models import models
from stridemap.cli.options import (
    FOUND,
    INTERRUPTED,
    PARAMETERS,
    UNUSABLE,
    Commands,
    WithParameters,
    WithRanges,
    with_quiet,
)
from stridemap.cli.orbit import orbit
from stridemap.cli.plot import plot
from stridemap.cli.progress import be_quiet
from stridemap.cli.report import report
from stridemap.cli.simulate import simulate
from stridemap.cli.sweep import sweep
from stridemap.cli.version import version
from stridemap.errors import StridemapError, bounded, short
from stridemap.services import provide

# The base of all complaints about the command line; typer has it under varying module names.
_UsageError: Any = next(c for c in typer.BadParameter.__mro__ if c.__name__ == "ClickException")

app = typer.Typer(
    cls=Commands,
    invoke_without_command=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)


@app.callback()
def _stridemap(
    context: typer.Context,
    version_: Annotated[
        bool, typer.Option("--version", is_eager=True, help="Print the version and exit.")
    ] = False,
) -> None:
    """Limit cycles, Floquet multipliers and parameter sweeps of walking models."""
    if version_:
        version()
        raise typer.Exit()
    if context.invoked_subcommand is None:
        print(context.get_help())


_WITH_PARAMETERS: tuple[Callable[..., int], ...] = (orbit, find, branch, simulate, animate)
_PLAIN: tuple[Callable[..., int], ...] = (
    sweep,
    plot,
    export,
    report,
    claims,
    figures,
    models,
    completion,
    version,
)
for command in _WITH_PARAMETERS:
    app.command(cls=WithParameters, context_settings=PARAMETERS)(with_quiet(command))
app.command(cls=WithModel, context_settings=PARAMETERS)(with_quiet(derive))
app.command(cls=WithRanges, context_settings=PARAMETERS)(with_quiet(boundary))
for command in _PLAIN:
    app.command()(command if command in (completion, version) else with_quiet(command))


def main() -> NoReturn:
    """Run the command line; every error that the user can mend is one sentence and exit status 2."""
    _fill_closed_streams()
    provide(show_work="stridemap.cli.progress:show_work")
    be_quiet(False)
    warnings.showwarning = lambda message, *_: print(f"warning: {message}", file=sys.stderr)
    if sys.stdout is None:
        _fail("standard output is closed, so that nothing can be printed; send it to a file or to /dev/null")
    try:
        status = app(standalone_mode=False)
        sys.stdout.flush()
    except StridemapError as error:
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
        if error.errno is None:
            raise
        _discard_output()
        if error.filename is None and error.errno in _OUTPUT:
            _fail(f"cannot write to standard output ({error.strerror}); make room or send it elsewhere")
        where = "" if error.filename is None else f" with {short(str(error.filename), 200)}"
        _fail(f"the system refuses something{where}: {error.strerror}; {_REMEDIES.get(error.errno, _REMEDY)}")
    except MemoryError:
        _discard_output()
        _fail("there is not enough memory; ask for less at once, or close other programs")
    sys.exit(status if isinstance(status, int) else FOUND)


_OUTPUT = (errno.ENOSPC, errno.EFBIG, errno.EIO, errno.EBADF)
_REMEDY = "give a path that can be read and written"
_REMEDIES = {
    errno.EMFILE: "close other programs, or raise the limit of open files (ulimit -n)",
    errno.ENFILE: "close other programs, or raise the limit of open files (ulimit -n)",
    errno.ENOMEM: "close other programs, or ask for less at once",
    errno.EAGAIN: "close other programs, or raise the limit of processes (ulimit -u)",
    errno.ENAMETOOLONG: "choose a shorter name",
    errno.ENOSPC: "make room, or give another place",
}


def _fail(sentence: str) -> NoReturn:
    # A path with a line break in it would make two lines of one, and other characters steer terminals.
    plain = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in bounded(" ".join(sentence.split())))
    with contextlib.suppress(OSError, ValueError):
        encoding = sys.stderr.encoding or "ascii"
        print(
            f"error: {plain}".encode(encoding, "backslashreplace").decode(encoding),
            file=sys.stderr,
            flush=True,
        )
    sys.exit(UNUSABLE)


def _fill_closed_streams() -> None:
    """Open what was closed for this program, lest a file of ours gets its number and what is printed."""
    for number in (0, 1, 2):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # it gets the lowest number that is free
    if sys.stderr is None:
        sys.stderr = open(2, "w", encoding="utf-8", errors="backslashreplace", closefd=False)


def _discard_output() -> None:
    """Discard the remaining standard output, so that writing it does not fail again at exit."""
    with contextlib.suppress(OSError, ValueError, AttributeError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
