"""The kernels as C++ that works on several points an instruction.

CasADi's C has no branches and names its type of number once. As C++, with `Lanes` (lanes.h) for that type,
the same text works on 8 points at a time with AVX-512, on 4 with AVX2, on 2 elsewhere. Newton's method,
which stops when it has arrived, is written by hand around it (lockstep.h).

The results do not depend on the processor, nor on which points are in a batch.
"""

from pathlib import Path

from stridemap.solver.backends.compiler import processor_features
from stridemap.solver.kernels.catalogue import LOCKSTEP
from stridemap.solver.model.model import Model

FLAGS = (
    *(
        "-x",
        "c++",
        "-O1",
        "-std=c++17",
        "-ffp-contract=off",
        "-fno-math-errno",
        "-fno-exceptions",
        "-fno-rtti",
    ),
    *("-Wno-psabi", "-Wno-ignored-attributes", "-fPIC", "-shared"),
)
"""No contraction here either: processors that can and that cannot would differ in the last digits."""

INSTRUCTIONS = (
    (frozenset({"avx512f", "avx512dq", "avx512vl"}), ("-mavx512f", "-mavx512dq", "-mavx512vl")),
    (frozenset({"avx2"}), ("-mavx2",)),
)
"""What a processor must offer for which flags, best first."""


def instruction_flags() -> tuple[str, ...]:
    """Flags for the widest instructions of this processor; none where it does not say what it has."""
    return next((flags for needed, flags in INSTRUCTIONS if needed <= processor_features()), ())


def source(model: Model) -> str:
    """The kernels, and what calls them in lockstep, as one C++ file.

    Parameters
    ----------
    model : Model

    Raises
    ------
    InputError
        When the C is not the one that the manifest names.
    """
    here = Path(__file__).parent
    lanes, driver = ((here / name).read_text(encoding="utf-8") for name in ("lanes.h", "lockstep.h"))
    kernels = model.text(f"{model.name}_kernels.c")
    shown = "".join(f"KERNEL({model.name}_{name})\n" for name in LOCKSTEP)
    # What is not shown is not compiled.
    return (
        f"{lanes}\n#define casadi_real Lanes\n#define CASADI_SYMBOL_EXPORT\n"
        f"namespace {{\n{kernels}\n}}\n{driver}\n{shown}"
    )
