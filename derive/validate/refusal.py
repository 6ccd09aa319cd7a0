"""How a declaration is refused."""

from typing import NoReturn

from stridemap.derive.declaration import Declaration
from stridemap.errors import InputError


def refuse(walker: Declaration, sentence: str) -> NoReturn:
    """Raise an InputError that names the walker."""
    one_line = " ".join(sentence.split())  # matrices have several
    raise InputError(f"model {walker.name}: {one_line}")
