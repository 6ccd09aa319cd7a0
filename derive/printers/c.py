"""Readable C99: a header and a source file for a walker's programs.

The prototype of a function depends on the model's sizes only: every function takes time, coordinates, rates,
torques and parameters, and leaves alone what it does not need. All numbers are `stridemap_real`: double, or
float where ``STRIDEMAP_FLOAT`` is defined.
"""

import math
import re
import textwrap
from collections.abc import Iterable, Sequence

from stridemap.derive.elementary import CALLS
from stridemap.derive.printers.printer import Equations, Printer
from stridemap.derive.program import Argument, Output, Program
from stridemap.derive.validate import reserved

_HARD = "\N{NO-BREAK SPACE}"

NAMES = frozenset({*CALLS.values(), "sqrt"})
"""Functions of <math.h> that generated code calls."""

REAL, OLD = "stridemap_real", "STRIDEMAP_OLD_SIGNATURES"

EXACT = 2**24
"""Largest integer that a float, too, holds exactly, with all below it."""

PRECISION = (
    "/* Numbers are double; they are float where STRIDEMAP_FLOAT is defined, for callers and the .c file. */",
    "#ifndef STRIDEMAP_REAL_IS_DEFINED",
    "#define STRIDEMAP_REAL_IS_DEFINED",
    "#ifdef STRIDEMAP_FLOAT",
    f"typedef float {REAL};",
    "#else",
    f"typedef double {REAL};",
    "#endif",
    "#endif",
    "",
)
"""What every header says of the type of numbers; those of several models may be included together."""


class C(Printer):
    """Readable C99: results are written to arrays that the caller passes in."""

    pi = f"REAL({math.pi!r})"  # C99 has no name for it
    reserved = reserved.C
    results_are_arguments = True

    def number(self, value: int) -> str:
        """A number of the type that is computed with: a quotient of integers would be cut off."""
        return f"REAL({value}.0)"

    def integer(self, value: int) -> str:
        """A plain integer, which takes the type of what it stands beside, where that holds it exactly."""
        return str(value) if abs(value) <= EXACT else self.number(value)

    def call(self, function: str, argument: str) -> str:
        """A macro for the function of <math.h> of the type that is computed with."""
        return f"{function.upper()}({argument})"

    def function(self, program: Program, model: str) -> list[str]:
        """The lines of one function, in sections: inputs, intermediate terms, outputs."""
        count = "1 operation" if program.operations == 1 else f"{program.operations} operations"
        lines = [f"/* {program.summary}. {count}.", *wrapped(f" * {program.source}. */")]
        lines += [*signature(model, program), "{"]
        inputs = [f"    const {REAL} {name} = {a.name}[{i}];" for name, a, i in self.inputs(program)]
        if inputs:
            lines += ["    /* inputs */", *inputs, ""]
        unused = " ".join(f"(void) {a.name};" for a in program.signature if a not in program.arguments)
        if program.statements:
            lines.append(f"    /* intermediate terms ({len(program.statements)}) */")
            for name, value in self.terms(program):
                lines += wrapped(f"    const {REAL} {name} = {value};")
            lines.append("")
        lines.append(f"    /* outputs ({sum(len(o.entries) for o in program.outputs)}) */")
        for out, entries in self.results(program):
            for i, value in enumerate(entries):
                result = self.result_name(program, out)
                lines += wrapped(f"    {result}[{i}] = {value};{_position(out, i)}")
        return [*lines, *(["", "    /* not needed */", f"    {unused}"] if unused else []), "}", ""]

    def text(self, equations: Equations) -> str:
        """The source file: no allocation, no global state, one function for each quantity."""
        body = [line for program in equations.programs for line in self.function(program, equations.model)]
        lines = [*banner(equations), f"#undef {OLD} /* that is for callers */"]
        lines += [
            f'#include "{equations.model}.h"',
            "",
            "#include <math.h>",
            "",
            *_macros("\n".join(body)),
            "",
        ]
        return "\n".join(lines + body)

    def header(self, equations: Equations) -> str:
        """The header file: every function with its documentation."""
        guard = f"STRIDEMAP_{equations.model.upper()}_H"
        lines = [*banner(equations), f"#ifndef {guard}", f"#define {guard}", ""]
        lines += [*PRECISION, *_names_of_float(equations), ""]
        lines += ["#ifdef __cplusplus", 'extern "C" {', "#endif", ""]
        for program in equations.programs:
            lines += [*_documentation(program), *signature(equations.model, program, ";"), ""]
        lines += ["#ifdef __cplusplus", "}", "#endif", "", *_old_signatures(equations)]
        return "\n".join([*lines, f"#endif /* {guard} */", ""])


def banner(equations: Equations, what: str = "readable equations") -> list[str]:
    """First lines of every generated C file."""
    return [
        f"/* {equations.walker.title}: {what}",
        f" * Generated by {equations.generator} from equations {equations.hash[:16]}. Do not edit: run "
        "`stridemap derive`.",
        " * SPDX-License-Identifier: BSD-3-Clause",
        " */",
    ]


def array(kind: str, name: str, size: int) -> str:
    """The declaration of an array argument; C has no arrays without entries."""
    return f"{kind} {name}[{size}]" if size else f"{kind} *{name}"


def _declared(arguments: Iterable[Argument]) -> list[str]:
    return [
        f"{REAL} {a.name}" if a.scalar else array(f"const {REAL}", a.name, len(a.entries)) for a in arguments
    ]


def _prototype(
    name: str, program: Program, arguments: Iterable[Argument], end: str = "", kind: str = "void"
) -> list[str]:
    """A declaration as lines, with a hard space wherever a line may not break."""
    results = [array(REAL, C().result_name(program, o), len(o.entries)) for o in program.outputs]
    parameters = ", ".join(part.replace(" ", _HARD) for part in [*_declared(arguments), *results])
    lines = wrapped(f"{kind.replace(' ', _HARD)}{_HARD}{name}({parameters}){end}")
    return [line.replace(_HARD, " ") for line in lines]


def signature(model: str, program: Program, end: str = "") -> list[str]:
    """The C declaration of `program`, as lines, closed by `end`."""
    return _prototype(f"{model}_{program.name}", program, program.signature, end)


def _names_of_float(equations: Equations) -> list[str]:
    """Other names in single precision, so that code of different precision does not link."""
    names = [f"{equations.model}_{program.name}" for program in equations.programs]
    return ["#ifdef STRIDEMAP_FLOAT", *(f"#define {name} {name}_float" for name in names), "#endif"]


def _old_signatures(equations: Equations) -> list[str]:
    """Functions as they were called before every function took all arguments, for one release."""
    lines = [
        "/* For one release: the functions with those arguments only that each of them needs. */",
        f"#ifdef {OLD}",
    ]
    for program in equations.programs:
        if program.arguments == program.signature or program.name.startswith("forward_dynamics"):
            continue
        name, old = f"{equations.model}_{program.name}", f"{equations.model}_old_{program.name}"
        head = _prototype(old, program, program.arguments, kind="static inline void")
        given = [a.name if a in program.arguments else "0" for a in program.signature]
        given += [C().result_name(program, out) for out in program.outputs]
        lines += [*head, "{", *wrapped(f"    {name}({', '.join(given)});"), "}"]
        lines += [f"#undef {name}", f"#define {name} {old}", ""]
    return [*lines, f"#endif /* {OLD} */", ""]


def _macros(body: str) -> list[str]:
    """What the functions need of the type that is computed with."""
    calls = sorted({call for call in re.findall(r"\b([A-Z][A-Z0-9]*)\(", body) if call.lower() in NAMES})
    lines = [f"#define REAL(x) (({REAL}) (x))"] if "REAL(" in body else []
    if not calls:
        return lines
    lines += ["#ifdef STRIDEMAP_FLOAT", *(f"#define {call}(x) {call.lower()}f(x)" for call in calls)]
    return [*lines, "#else", *(f"#define {call}(x) {call.lower()}(x)" for call in calls), "#endif"]


def _documentation(program: Program) -> list[str]:
    """The comment above a declaration: of the arguments it lists what the function reads."""
    lines = [f"/** {program.summary}.", " *", *wrapped(f" * Source: {program.source}."), " *"]
    for argument in program.arguments:
        for i, entry in enumerate(argument.entries):
            if entry.symbol in program.used:
                where = argument.name if argument.scalar else f"{argument.name}[{i}]"
                lines.append(f" *  in   {where:<6} {entry.symbol.name:<8} [{entry.unit}] {entry.meaning}")
    for out in program.outputs:
        name = C().result_name(program, out)
        shape = {0: "scalar", 1: "vector", 2: "matrix, row-major"}[len(out.shape)]
        size = " x ".join(map(str, out.shape))
        lines.append(f" *  out  {name:<15} {out.meaning} ({size + ' ' if size else ''}{shape})")
    return [*lines, " */"]


def _position(out: Output, index: int) -> str:
    """A comment that says which entry of a matrix this is, counted from 1 as in papers."""
    if len(out.shape) < 2:
        return ""
    row, column = divmod(index, out.shape[1])
    return f" /* {out.name}({row + 1},{column + 1}) */"


def wrapped(line: str) -> list[str]:
    """A line as several, where it is longer than 110 characters."""
    indent = " * " if line.startswith(" * ") else " " * (len(line) - len(line.lstrip()) + 8)
    return textwrap.wrap(line, 110, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def aligned(entries: Sequence[tuple[str, str]]) -> list[str]:
    """Entries of a list in braces, with comments beside them."""
    last = len(entries) - 1
    texts = [name + ("," if i < last else "") for i, (name, _) in enumerate(entries)]
    width = max(map(len, texts))
    return [f"    {text:<{width}} /* {meaning} */" for text, (_, meaning) in zip(texts, entries, strict=True)]
