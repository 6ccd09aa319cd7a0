"""Errors that every layer may raise. A leaf: importing it costs nothing."""


class InputError(ValueError):
    """Unusable input: a bad value, file or option, told in one sentence.

    The message names the offending value, where it stands, what is allowed and what to do. The
    command line prints it as ``error: <sentence>`` without a traceback and exits with status 2.
    """
