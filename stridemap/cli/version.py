"""``stridemap version``."""

from stridemap.cli.options import FOUND


def version() -> int:
    """Print the version."""
    from stridemap import __version__

    print(__version__)
    return FOUND
