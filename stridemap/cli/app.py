"""The command line: which commands there are, and what becomes of their errors.

Exit status: 0 found or done, 1 nothing found, 2 unusable input or a failure that is explained in one sentence
on standard error.
"""

import errno
import os
import sys
import warnings
from collections.abc import Callable
from typing import Any, NoReturn

import typer

from stridemap.cli.animate import animate
from stridemap.cli.claims import claims
from stridemap.cli.derive import derive
from stridemap.cli.figures import figures
from stridemap.cli.find import find
from stridemap.cli.options import FOUND, INTERRUPTED, PARAMETERS, UNUSABLE, WithParameters
from stridemap.cli.orbit import orbit
from stridemap.cli.report import report
from stridemap.cli.simulate import simulate
from stridemap.cli.sweep import sweep
from stridemap.cli.version import version
from stridemap.errors import StridemapError

# The base of all complaints about the command line; typer has it under varying module names.
_UsageError: Any = next(c for c in typer.BadParameter.__mro__ if c.__name__ == "ClickException")

app = typer.Typer(
    help="Limit cycles, Floquet multipliers and parameter sweeps of walking models.",
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)

_WITH_PARAMETERS: tuple[Callable[..., int], ...] = (orbit, find, simulate, animate)
_PLAIN: tuple[Callable[..., int], ...] = (sweep, report, claims, figures, derive, version)
for command in _WITH_PARAMETERS:
    app.command(cls=WithParameters, context_settings=PARAMETERS)(command)
for command in _PLAIN:
    app.command()(command)


def main() -> NoReturn:
    """Run the command line; every error that the user can mend is one sentence and exit status 2."""
    warnings.showwarning = lambda message, *_: print(f"warning: {message}", file=sys.stderr)
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
    """Discard the remaining standard output, so that writing it does not fail again at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
