"""The packages that are needed for drawing only."""

from importlib.util import find_spec

from stridemap.errors import InputError

PACKAGES = {"matplotlib": "matplotlib", "PIL": "Pillow"}
"""Import name and name of each."""


def require_pictures() -> None:
    """Refuse to draw where a package is missing, before anything is computed.

    Raises
    ------
    InputError
        When matplotlib or Pillow is not installed.
    """
    missing = [name for module, name in PACKAGES.items() if find_spec(module) is None]
    if missing:
        are = "is" if len(missing) == 1 else "are"
        raise InputError(
            f"drawing needs {' and '.join(missing)}, which {are} not installed here: run "
            f"`pip install {' '.join(missing)}`"
        )
