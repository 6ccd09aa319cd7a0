"""Names that mean something else in tables, options, generated code or the languages that it is written in.

There is one list. A parameter that bore one of these names would hide a column of a table, could not be given
as an option, or would make code that does not compile.
"""

import keyword

from stridemap.words import OPTION_WORDS, column

PYTHON = frozenset(keyword.kwlist)

C = frozenset(
    # keywords of C99, and of C++, as which the header compiles too
    "auto break case char const continue default do double else enum extern float for goto if inline int "
    "long register restrict return short signed sizeof static struct switch typedef union unsigned void "
    "volatile while alignas alignof asm bitand bitor bool catch class compl concept consteval constexpr "
    "constinit const_cast decltype delete dynamic_cast explicit export false friend mutable namespace new "
    "noexcept not_eq nullptr operator or_eq private protected public reinterpret_cast requires "
    "static_assert static_cast template this thread_local throw true try typeid typename using virtual "
    "wchar_t xor xor_eq and_eq char8_t char16_t char32_t co_await co_return co_yield "
    # macros that compilers define unless they are told -std=c99
    "linux unix i386 "
    # the type of numbers in the generated C, and the switch of its precision
    "stridemap_real STRIDEMAP_FLOAT "
    # math.h and complex.h
    "acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh erf erfc exp exp2 expm1 fabs fdim "
    "floor fma fmax fmin fmod frexp hypot ilogb isfinite isinf isnan isnormal ldexp lgamma log log10 "
    "log1p log2 logb lrint lround llrint llround modf nan nearbyint nextafter nexttoward pow remainder "
    "remquo rint round scalbln scalbn signbit sin sinh sqrt tan tanh tgamma trunc fpclassify isgreater "
    "isgreaterequal isless islessequal islessgreater isunordered float_t double_t math_errhandling "
    "HUGE_VAL HUGE_VALF HUGE_VALL INFINITY NAN M_E M_LOG2E M_LOG10E M_LN2 M_LN10 M_PI M_PI_2 M_PI_4 M_1_PI "
    "M_2_PI M_2_SQRTPI M_SQRT2 M_SQRT1_2 I complex imaginary "
    # stdio.h, stdlib.h, errno.h, assert.h
    "FILE EOF BUFSIZ NULL SEEK_SET SEEK_CUR SEEK_END size_t fpos_t stdin stdout stderr fclose fflush "
    "fgetc fgets fopen fprintf fputc fputs fread freopen fscanf fseek fsetpos ftell fwrite getc getchar "
    "gets perror printf putc putchar puts remove rename rewind scanf setbuf setvbuf snprintf sprintf "
    "sscanf tmpfile tmpnam ungetc vfprintf vprintf vsnprintf vsprintf EXIT_FAILURE EXIT_SUCCESS "
    "MB_CUR_MAX RAND_MAX abort abs atexit atof atoi atol atoll bsearch calloc div div_t exit free getenv "
    "labs ldiv ldiv_t llabs lldiv malloc mblen qsort rand realloc srand strtod strtof strtol strtold "
    "strtoll strtoul strtoull system errno EDOM EILSEQ ERANGE assert NDEBUG main".split()
)

MACROS = "STRIDEMAP_"
"""Beginning of the macros of generated C, such as those that keep a header from being read twice."""

JAVASCRIPT = frozenset(
    "arguments await break case catch class const continue debugger default delete do else enum eval export "
    "extends false finally for function if implements import in instanceof interface let new null package "
    "private protected public return static super switch this throw true try typeof undefined var void while "
    "with yield Infinity Math NaN".split()
)

ARGUMENTS = {
    "t": "the time",
    "q": "the coordinates",
    "v": "their rates",
    "p": "the parameters",
    "z": "the point on the section",
    "xp": "the namespace of the functions",
}
"""Arguments of generated functions, each with what it holds."""

BASE = frozenset("stance_x stance_y dstance_x dstance_y".split())
"""Position and velocity of `STANCE_FOOT`."""

FILES = frozenset({"example", "manifest", "README"})
"""Names of generated files that do not bear the model's name."""

_BETTER = {
    "friction": "friction_coefficient",
    "speed": "belt_speed",
    "lambda": "lambda1",
    "I": "inertia",
    "work": "work_limit",
}


def meaning(name: str) -> str | None:
    """What a name already is where a model's parameters or coordinates appear; None where it is free.

    Parameters
    ----------
    name : str
        Of a parameter, a coordinate, a rate, a line or an output for a potential.
    """
    held = column(name)
    if held is not None:
        return f"the name of a column of the tables ({held})"
    if name in OPTION_WORDS:
        return "the name of an option of stridemap's commands or an argument of its functions"
    return in_code(name)


def in_code(name: str) -> str | None:
    """What a name already is in generated code or in the languages that it is written in."""
    if name in ARGUMENTS:
        return f"the name of an argument of generated functions ({ARGUMENTS[name]})"
    if name in BASE:
        return "the name of an entry of STANCE_FOOT or of its velocity"
    languages = {"Python": PYTHON, "C": C, "JavaScript": JAVASCRIPT}
    taken = [language for language, words in languages.items() if name in words]
    if not taken and name.startswith(MACROS):
        return f"a name that begins with {MACROS}, as macros of the generated C do"
    return f"a name that means something in {' and in '.join(taken)}" if taken else None


def better(name: str) -> str:
    """A name in place of one that is taken."""
    candidates = (_BETTER.get(name, f"{name}_value"), f"{name}_of_walker", f"walker_{name}")
    return next(one for one in candidates if meaning(one) is None)
