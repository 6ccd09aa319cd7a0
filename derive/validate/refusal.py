"""How a declaration is refused."""

from typing import NoReturn

from stridemap.derive.declaration import Declaration
from stridemap.errors import InputError

LONGEST = 600
"""Characters of a sentence: an expression may have a million."""


def refuse(walker: Declaration, sentence: str) -> NoReturn:
    """Raise an InputError that names the walker."""
    one_line = " ".join(sentence.split())  # matrices have several
    if len(one_line) > LONGEST:
        one_line = f"{one_line[: LONGEST // 2]} ... {one_line[-LONGEST // 2 :]}"
    name = walker.name if isinstance(walker.name, str) else "without a name"
    raise InputError(f"model {' '.join(name[:60].split())}: {one_line}")
