"""The name of a model: it begins names of C functions, and is that of files and of a Python module."""

import sys

from stridemap.derive.declaration import Declaration
from stridemap.derive.validate.refusal import refuse
from stridemap.derive.validate.reserved import FILES, in_code

LONGEST = 60
"""Characters of a name: compilers tell the first 63 of an identifier apart, file systems take 255 bytes."""

HEADERS = frozenset(
    "assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign stdarg "
    "stdatomic stdbool stddef stdint stdio stdlib stdnoreturn string tgmath threads time uchar wchar "
    "wctype".split()
)
"""Headers of C: the model's own header would be read in their place."""

MODULES = frozenset("casadi matplotlib numpy pandas pyarrow scipy stridemap sympy".split())
"""Packages that a model's module would be imported in place of."""

DEVICES = frozenset(["con", "prn", "aux", "nul", *(f"{d}{i}" for d in ("com", "lpt") for i in range(1, 10))])
"""Names that no file can have on Windows."""

PREFIXES = frozenset({"casadi", "lockstep"})
"""Prefixes of what the kernels define themselves."""


def validate_model_name(walker: Declaration) -> None:
    """Refuse a name that the generated files or functions of a model cannot have.

    Parameters
    ----------
    walker : Walker

    Raises
    ------
    InputError
        When the name is one.
    """
    name = walker.name
    if len(name) > LONGEST:
        refuse(
            walker,
            f"its name has {len(name)} characters; at most {LONGEST} are allowed: choose a shorter one",
        )
    lower = name.lower()
    reasons = {
        "the name of a header of C": lower in HEADERS,
        "the name of a module of Python": name in sys.stdlib_module_names or name in MODULES,
        "a name that files cannot have on every system": lower in DEVICES,
        "the name of a generated file": lower in {one.lower() for one in FILES},
        "the beginning of names that the kernels define": lower in PREFIXES,
    }
    taken = in_code(name) or next((reason for reason, found in reasons.items() if found), None)
    if taken is not None:
        refuse(walker, f"it has {taken}; choose another name for the model, such as {name}_walker")
