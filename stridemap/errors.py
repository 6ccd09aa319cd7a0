"""Errors that every room may raise. A leaf: importing it costs nothing."""


class StridemapError(Exception):
    """The base of all errors that stridemap raises on purpose; the message is one sentence.

    The command line prints it as ``error: <sentence>`` without a traceback and exits with status 2.
    """


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
