"""The generated C under gcc and clang: all warnings as errors, symbols, sanitizers, the worked example.

A compiler that is missing skips its tests, except where the environment variable CI is set: there it fails.
"""

import hashlib
import os
import re
import shutil
import subprocess
from functools import cache

import numpy as np
import pytest

from stridemap import codegen
from stridemap.solver.backends.compiler import cache_folder, version
from stridemap.solver.model.loading import load
from tests.oracles.states import MODELS, lacking, need

STRICT = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror"]
COMPILERS = ("gcc", "clang")
LIBM = {"sin", "cos", "tan", "exp", "log", "sqrt", "sincos"}

CPP = ("g++", "clang++")

all_models = pytest.mark.parametrize("name", MODELS)


def in_turn(*compilers):
    """Each model with one compiler, and each compiler with some models: the same printer wrote them all."""
    pairs = [(name, compilers[i % len(compilers)]) for i, name in enumerate(MODELS)]
    return pytest.mark.parametrize(("name", "compiler"), pairs)


models_and_compilers = in_turn(*COMPILERS)
compilers_and_models = in_turn(*reversed(COMPILERS))


def run(*command, cwd=None):
    """Run a command; its standard output, or its complaint as the failure."""
    done = subprocess.run(
        [str(word) for word in command], cwd=cwd, capture_output=True, text=True, check=False, timeout=300
    )
    assert done.returncode == 0, f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}"
    assert not done.stderr, done.stderr
    return done.stdout


def folder(name):
    return codegen.generated_folder() / name


# -- compilers -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("file", ["{}.c", "example.c"])
@models_and_compilers
def test_readable_c_compiles_without_a_warning(name, compiler, file, tmp_path):
    source = folder(name) / file.format(name)
    run(need(compiler), *STRICT, "-Wconversion", "-O2", "-c", source, "-o", tmp_path / "out.o")


@pytest.mark.parametrize("file", ["{}.c", "example.c"])
@in_turn(*CPP)
def test_readable_c_compiles_as_cpp(name, compiler, file, tmp_path):
    source = folder(name) / file.format(name)
    flags = ["-x", "c++", "-std=c++17", "-Wall", "-Wextra", "-Werror"]
    run(need(compiler), *flags, "-O2", "-c", source, "-o", tmp_path / "out.o")


@pytest.mark.parametrize("compiler", CPP)
def test_cpp_links_with_the_c(compiler, tmp_path):
    """The header's ``extern "C"`` is what makes the two fit."""
    c_compiler = need({"g++": "gcc", "clang++": "clang"}[compiler])
    source = tmp_path / "main.cpp"
    source.write_text(
        "".join(f'#include "{name}.h"\n' for name in MODELS)
        + "int main() { double z[5] = {0}, p[8] = {0}, q[3], v[3]; "
        + "".join(f"{name}_section_state(z, p, q, v); " for name in MODELS)
        + "}\n"
    )
    for name in MODELS:
        run(c_compiler, "-std=c99", "-c", folder(name) / f"{name}.c", "-o", tmp_path / f"{name}.o")
    includes = [f"-I{folder(name)}" for name in MODELS]
    objects = [tmp_path / f"{name}.o" for name in MODELS]
    run(need(compiler), *includes, source, *objects, "-lm", "-o", tmp_path / "program")
    run(tmp_path / "program")


@models_and_compilers
def test_kernels_compile_without_a_warning(name, compiler, tmp_path):
    source = folder(name) / f"{name}_kernels.c"
    run(need(compiler), *STRICT, "-Wno-unused-parameter", "-c", source, "-o", tmp_path / "out.o")


# -- single precision and former prototypes ------------------------------------------------------------------

EVERY_WARNING = [
    *STRICT,
    "-Wconversion",
    "-Wpedantic",
    "-Wshadow",
    "-Wdouble-promotion",
    "-Wfloat-conversion",
]


@pytest.mark.parametrize("options", [["-DSTRIDEMAP_FLOAT"], ["-DSTRIDEMAP_OLD_SIGNATURES"]])
@compilers_and_models
def test_no_warning_in_single_precision_and_with_former_prototypes(name, compiler, options, tmp_path):
    """The header on its own, too: a caller includes nothing else."""
    caller = tmp_path / "caller.c"
    caller.write_text(f'#include "{name}.h"\nint main(void) {{ return (int) sizeof(stridemap_real); }}\n')
    for source in (folder(name) / f"{name}.c", caller):
        flags = [*EVERY_WARNING, *options, f"-I{folder(name)}", "-O2"]
        run(need(compiler), *flags, "-c", source, "-o", tmp_path / "out.o")


def printing_main(name, calls):
    """A C program that prints all results of functions: name of the function and its arguments in C."""
    model = load(name)
    state = {"t": [0.7], "q": [0.2, -0.3, 0.1], "v": [-0.4, 0.5, 0.6], "u": [0.3], "p": model.point({})}
    state["z"] = ORBITS[name][:-1]
    lines = [f'#include "{name}.h"', "#include <stdio.h>", "int main(void) {", "    int i;"]
    lines += [
        f"    const stridemap_real {k}[] = {{{', '.join(f'(stridemap_real) {float(x)!r}' for x in v)}}};"
        for k, v in state.items()
    ]
    lines += [f"    (void) {k};" for k in state]
    for function, arguments in calls.items():
        outputs = {f"{o.name}_": np.prod(o.shape, dtype=int) for o in model.spec.functions[function].outputs}
        given = ", ".join(["t[0]" if a == "t" else a for a in arguments] + list(outputs))
        lines += ["    {", *(f"        stridemap_real {o}[{size}];" for o, size in outputs.items())]
        lines.append(f"        {name}_{function}({given});")
        shown = 'printf("%.17g\\n", (double) {}[i]);'
        lines += [f"        for (i = 0; i < {n}; i++) {shown.format(o)}" for o, n in outputs.items()] + [
            "    }"
        ]
    return "\n".join([*lines, "    return 0;", "}", ""])


def printed_by(name, calls, options, tmp_path):
    """What all functions give, in one list for each."""
    (tmp_path / "main.c").write_text(printing_main(name, calls))
    flags = [*EVERY_WARNING, "-O2", "-ffp-contract=off", *options, f"-I{folder(name)}"]
    sources = [tmp_path / "main.c", folder(name) / f"{name}.c"]
    run(need(*COMPILERS), *flags, *sources, "-lm", "-o", tmp_path / "main")
    values = iter(run(tmp_path / "main").split())
    spec = load(name).spec
    sizes = {f: sum(np.prod(o.shape, dtype=int) for o in spec.functions[f].outputs) for f in calls}
    found = {f: np.array([float(next(values)) for _ in range(size)]) for f, size in sizes.items()}
    assert next(values, None) is None
    return found


@all_models
def test_single_precision_gives_the_same_numbers(name, tmp_path):
    calls = {f: entry.signature for f, entry in load(name).spec.functions.items()}
    double, single = (printed_by(name, calls, o, tmp_path) for o in ([], ["-DSTRIDEMAP_FLOAT"]))
    for function in calls:
        size = np.abs(double[function]).max()
        off = np.abs(double[function] - single[function]).max()
        assert off <= 1e-4 * size, function
    # It is another precision indeed.
    assert any((double[f] != single[f]).any() for f in calls)
    assert all((np.float32(x) == x).all() for x in single.values())


def test_code_of_different_precision_does_not_link(tmp_path):
    here = folder("compass")
    (tmp_path / "main.c").write_text(printing_main("compass", {"mass_matrix": ("t", "q", "v", "u", "p")}))
    compiler, flags = need(*COMPILERS), [f"-I{here}", "-std=c99"]
    run(compiler, *flags, "-DSTRIDEMAP_FLOAT", "-c", tmp_path / "main.c", "-o", tmp_path / "main.o")
    linked = subprocess.run(
        [compiler, *flags, tmp_path / "main.o", here / "compass.c", "-lm", "-o", tmp_path / "main"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert linked.returncode and "compass_mass_matrix_float" in linked.stderr


@all_models
def test_former_prototypes_take_what_a_function_reads(name, tmp_path):
    functions = load(name).spec.functions
    now = {f: entry.signature for f, entry in functions.items()}
    former = {f: now[f] if f.startswith("forward") else entry.arguments for f, entry in functions.items()}
    assert former != now
    expected = printed_by(name, now, [], tmp_path)
    found = printed_by(name, former, ["-DSTRIDEMAP_OLD_SIGNATURES"], tmp_path)
    for function in functions:
        np.testing.assert_array_equal(found[function], expected[function], err_msg=function)


def test_prototypes_depend_on_sizes_only():
    """Those of two models differ in their names and in the numbers of entries, and in nothing else."""

    def shapes(name):
        text = re.sub(r"#ifdef STRIDEMAP_OLD.*", "", load(name).text(f"{name}.h"), flags=re.DOTALL)
        found = dict(re.findall(rf"^void {name}_(\w+)\(([^)]*)\);", text, flags=re.M))
        return {f: re.sub(r"\[\d+\]|\*", "", re.sub(r"\s+", " ", a)) for f, a in found.items()}

    one, *others = (shapes(name) for name in MODELS)
    for other in others:
        for function in one.keys() & other.keys() - {"drawing", "bias_forces", "quantities"}:
            assert one[function] == other[function], function
    start = "stridemap_real t, const stridemap_real q, const stridemap_real v, const stridemap_real u, "
    assert all(a.startswith(start) for f, a in one.items() if f != "section_state")
    assert one["section_state"].startswith("const stridemap_real z, const stridemap_real p, ")


# -- symbols -------------------------------------------------------------------------------------------------


@models_and_compilers
def test_readable_c_exports_its_functions_and_needs_only_libm(name, compiler, tmp_path):
    run(need(compiler), "-std=c99", "-O2", "-c", folder(name) / f"{name}.c", "-o", tmp_path / "out.o")
    symbols = [line.split()[-2:] for line in run(need("nm"), tmp_path / "out.o").splitlines()]
    kinds = {kind: {symbol for k, symbol in symbols if k == kind} for kind, _ in symbols}
    assert kinds["T"] == {f"{name}_{function}" for function in load(name).spec.functions}
    assert kinds["U"] <= LIBM  # so there is no allocation either
    assert not kinds.keys() & set("BbCDdGgSs"), "there is data that can change"


# -- the worked example and the README -----------------------------------------------------------------------


def example_by_python(name):
    """What example.c prints, from the Python module."""
    model = load(name)
    text = (folder(name) / "example.c").read_text()
    p, z = (np.array(eval(f"[{m}]")) for m in re.findall(r"_real [pz]\[\d+\] = \{([^}]*)\}", text))
    np.testing.assert_array_equal(p, model.point({}))
    at = {"t": 0.0, "p": p, **model.evaluate("section_state", z=z)}
    energy = model.evaluate("kinetic_energy", **at)["kinetic"]
    energy = energy + model.evaluate("potential_energy", **at)["potential"]
    rate = model.evaluate("state_derivative", **at)
    moved = {**at, "q": at["q"] + 1e-3 * rate["dq"], "v": at["v"] + 1e-3 * rate["dv"]}
    after = model.evaluate("impact_map", **moved)
    state = np.stack([after["q_plus"], after["v_plus"]], axis=-1)
    force = model.evaluate("ground_force", **at)["force"]
    return np.concatenate([model.evaluate("mass_matrix", **at)["M"].ravel(), [energy], force, state.ravel()])


def numbers(printed):
    return [float(x) for x in re.findall(r"(?<![\w\[(])-?\d+\.\d+", printed)]


@models_and_compilers
def test_the_example_prints_what_python_computes(name, compiler, tmp_path):
    sources = [folder(name) / "example.c", folder(name) / f"{name}.c"]
    run(need(compiler), "-std=c99", *sources, "-lm", "-o", tmp_path / "example")
    printed = numbers(run(tmp_path / "example"))
    expected = example_by_python(name)
    assert len(printed) == len(expected)
    np.testing.assert_allclose(printed, expected, rtol=0, atol=5.1e-7)  # it prints 6 digits and more
    assert len(set(np.abs(printed))) > len(printed) / 2, "a dull example"


@compilers_and_models
def test_the_example_is_right_in_single_precision(name, compiler, tmp_path):
    sources = [folder(name) / "example.c", folder(name) / f"{name}.c"]
    run(need(compiler), *STRICT, "-DSTRIDEMAP_FLOAT", *sources, "-lm", "-o", tmp_path / "example")
    expected = example_by_python(name)
    printed = numbers(run(tmp_path / "example"))
    np.testing.assert_allclose(printed, expected, rtol=0, atol=1e-4 * np.abs(expected).max())


@all_models
def test_the_readme_builds_the_example_and_names_everything(name, tmp_path):
    need("cc")
    shutil.copytree(folder(name), tmp_path / name)
    readme = (tmp_path / name / "README.md").read_text()
    command = re.search(r"```sh\n(.*?)\n```", readme, flags=re.DOTALL)[1]
    assert "M(1,:)" in run("sh", "-c", command, cwd=tmp_path / name)
    for file in {path.name for path in folder(name).iterdir() if path.is_file()} - {"README.md"}:
        assert f"`{file}`" in readme, file
    for function, entry in load(name).spec.functions.items():
        assert f"| `{name}_{function}` | {entry.operations} |" in readme, function
        assert f"void {name}_{function}(" in readme, function
    for argument in ("q", "v", "p", "z"):
        assert f"`{argument}[" in readme


@all_models
def test_header_and_readme_list_what_each_function_reads(name):
    spec = load(name).spec
    header, readme = (load(name).text(file) for file in (f"{name}.h", "README.md"))
    documented = re.findall(r"/\*\* (.*?)\*/\nvoid\s+(\w+)\(", header, flags=re.DOTALL)
    assert [function for _, function in documented] == [f"{name}_{function}" for function in spec.functions]
    for (comment, _), (function, entry) in zip(documented, spec.functions.items(), strict=True):
        reads = [read for argument in entry.inputs for read in argument.reads]
        assert re.findall(r"^ \*  in +\S+ +(\w+) ", comment, flags=re.M) == reads
        shown = ", ".join(f"`{read}`" for read in reads) or "nothing"
        assert re.search(
            rf"^\| `{name}_{function}` \| \d+ \| [^|]+ \| {re.escape(shown)} \|$", readme, flags=re.M
        )
        # What the code reads, it reads by index; the comment names the same entries.
        body = re.search(rf"^def {function}\(.*?(?=^def |\Z)", load(name).text(f"{name}.py"), re.M | re.S)[0]
        unpacked = re.findall(r"^    (\w+) = [qvupz]\[\d+\]$", body, flags=re.M)
        assert [read for read in reads if read != "t"] == unpacked


# -- sanitizers ----------------------------------------------------------------------------------------------

ORBITS = {  # a limit cycle of each at the preset: the point on the section, and the period
    "wobbling": [0.0975854377, -0.1236463659, -0.0023474881, 0.0045399252, 0.2844991066, 1.1544726234],
    "compass": [0.0892433641, -0.1689726626, -0.0026843865, 1.2184370389],
    "simplest_walker": [0.2003109005, -0.1998324730, 3.8824637529],
    "goswami_compass": [0.2668212224, -0.3460754495, -0.218981989, 2.2939906403],
    "rimless_wheel": [-0.5235987756, 0.4603411266, 2.310014865],
}


def c_list(values):
    return "{" + ", ".join(repr(float(v)) for v in values) + "}"


def readable_main(name):
    """A C program that calls every readable function on heap arrays of exactly the declared sizes."""
    model = load(name)
    state = {"q": [0.2, -0.3, 0.1], "v": [-0.4, 0.5, 0.6], "p": model.point({}), "z": ORBITS[name][:-1]}
    state["u"] = [0.3]
    lines = [f'#include "{name}.h"', "#include <math.h>", "#include <stdio.h>", "#include <stdlib.h>"]
    lines += ["static double *copy(const double *from, int n) {"]
    lines += ["    double *x = malloc((size_t) n * sizeof(double));", "    int i;"]
    lines += ["    for (i = 0; i < n; i++) x[i] = from ? from[i] : NAN;", "    return x;", "}"]
    lines += ["static void check(const char *what, double *x, int n) {", "    int i;"]
    lines += ["    for (i = 0; i < n; i++) if (!isfinite(x[i])) { puts(what); exit(1); }", "}"]
    lines += ["int main(void) {"]
    lines += [f"    const double {k}0[] = {c_list(v)};" for k, v in state.items()]
    for function, entry in model.spec.functions.items():
        inputs = [a for a in entry.signature if a != "t"]
        outputs = [(o.name, np.prod(o.shape, dtype=int)) for o in entry.outputs]
        arrays = [(a, f"copy({a}0, {model.spec.size(a)})") for a in inputs]
        arrays += [(f"{o}_", f"copy(0, {size})") for o, size in outputs]
        given = ["0.7" if a == "t" else a for a in entry.signature] + [f"{o}_" for o, _ in outputs]
        lines += ["    {"] + [f"        double *{a} = {made};" for a, made in arrays]
        lines += [f"        {name}_{function}({', '.join(given)});"]
        lines += [f'        check("{function}", {o}_, {size});' for o, size in outputs]
        lines += [f"        free({a});" for a, _ in arrays] + [f'        puts("{function}");', "    }"]
    return "\n".join([*lines, "    return 0;", "}", ""])


KERNELS_MAIN = """
#include <stdio.h>
#include <string.h>

typedef const casadi_int* (*shape_of)(casadi_int);

static casadi_int entries(const casadi_int* s) { return s[2] == 1 ? s[0] * s[1] : s[2 + s[1]]; }

static const double* value_of(const char* name) {
    if (!strcmp(name, "p")) return p;
    if (!strcmp(name, "u0") || !strcmp(name, "u")) return u;
    return w; /* state and work, or just t or h: its first entry */
}

static int run(const char* what, MODEL_kernel kernel, const casadi_int* size, casadi_int n_in,
    casadi_int n_out, shape_of in_shape, shape_of out_shape, const char* (*name_in)(casadi_int))
{
    const double* in[8];
    double* out[8];
    casadi_int in_size[8], out_size[8], i, j, k, bad = 0;
    int* failed = malloc(POINTS * sizeof(int));
    for (j = 0; j < n_in; j++) {
        const casadi_int n = in_size[j] = entries(in_shape(j));
        double* x = malloc((size_t) (POINTS * n) * sizeof(double));
        for (i = 0; i < POINTS; i++)
            for (k = 0; k < n; k++) x[i * n + k] = value_of(name_in(j))[k] * (1 + 1e-4 * (double) i);
        in[j] = x;
    }
    for (j = 0; j < n_out; j++) {
        out_size[j] = entries(out_shape(j));
        out[j] = malloc((size_t) (POINTS * out_size[j]) * sizeof(double));
    }
    if (MODEL_map(kernel, size, POINTS, n_in, in, in_size, n_out, out, out_size, failed)) bad++;
    for (i = 0; i < POINTS; i++) bad += failed[i] != 0;
    for (j = 0; j < n_out; j++)
        for (i = 0; i < POINTS * out_size[j]; i++) bad += !isfinite(out[j][i]);
    printf("%s %d\\n", what, (int) bad);
    for (j = 0; j < n_in; j++) free((void*) in[j]);
    for (j = 0; j < n_out; j++) free(out[j]);
    free(failed);
    return bad != 0;
}

#define RUN(k) do { \\
        casadi_int size[4]; \\
        k##_work(size, size + 1, size + 2, size + 3); \\
        bad += run(#k, k, size, k##_n_in(), k##_n_out(), k##_sparsity_in, k##_sparsity_out, k##_name_in); \\
    } while (0)
"""


def kernels_main(name):
    """A C program that maps every kernel over a handful of points."""
    model = load(name)
    source = (folder(name) / f"{name}_kernels.c").read_text()
    kernels = re.findall(r"^CASADI_SYMBOL_EXPORT int (\w+)\(const casadi_real\*\* arg", source, flags=re.M)
    orbit = ORBITS[name]
    start = model.evaluate("section_state", z=np.array(orbit[:-1]))
    state = [*start["q"], *start["v"], *np.zeros(len(model.actuated))]
    tangents = np.zeros(
        len(state) * len(model.section)
    )  # the state with its tangents is a kernel's input too
    lines = [f'#include "{folder(name) / f"{name}_kernels.c"}"', "#define POINTS 3"]
    lines += [f"static const double p[] = {c_list(model.point({}))};"]
    lines += [
        f"static const double u[] = {c_list(orbit)};",
        f"static const double w[] = {c_list([*state, *tangents])};",
    ]
    lines += [KERNELS_MAIN.replace("MODEL", name), "int main(void) {", "    int bad = 0;"]
    lines += [f"    RUN({k});" for k in kernels]
    return "\n".join([*lines, "    return bad;", "}", ""]), kernels


SANITIZED = ["-std=c99", "-O0", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]


@cache
def has_sanitizers(compiler):
    """Whether a compiler can link with the sanitizers."""
    command = [compiler, *SANITIZED, "-x", "c", "-", "-o", os.devnull]
    return not subprocess.run(
        command, input="int main(void) { return 0; }\n", text=True, capture_output=True, check=False
    ).returncode


def sanitized(compiler, source, *others, includes, tmp_path):
    """Build with address and undefined-behaviour sanitizers, run, and return what is printed.

    The program is kept like compiled kernels are, by the hash of all that it was made from.
    """
    if not has_sanitizers(need(compiler)):
        lacking(f"{compiler} cannot link with the sanitizers")
    (tmp_path / "main.c").write_text(source)
    parts = [version(compiler), *SANITIZED, source, *(path.read_text() for path in others)]
    parts += [path.read_text() for path in sorted(includes.glob("*.[ch]"))]
    kept = cache_folder() / f"sanitized-{hashlib.sha256(repr(parts).encode()).hexdigest()}"
    if not kept.exists():
        program = tmp_path / "program"
        run(compiler, *SANITIZED, f"-I{includes}", tmp_path / "main.c", *others, "-lm", "-o", program)
        kept.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(program, beside := kept.with_suffix(f".{os.getpid()}"))
        os.replace(beside, kept)  # another process never runs half a program
    return run(kept).split("\n")[:-1]


@models_and_compilers
def test_readable_c_under_sanitizers(name, compiler, tmp_path):
    here = folder(name)
    printed = sanitized(compiler, readable_main(name), here / f"{name}.c", includes=here, tmp_path=tmp_path)
    assert printed == list(load(name).spec.functions)


@pytest.mark.parametrize(("name", "compiler"), [(n, COMPILERS[n != "compass"]) for n in MODELS])
def test_kernels_under_sanitizers(name, compiler, tmp_path):
    """One of them with gcc, which takes twice as long."""
    source, kernels = kernels_main(name)
    assert len(kernels) >= 4
    printed = sanitized(compiler, source, includes=folder(name), tmp_path=tmp_path)
    assert printed == [f"{kernel} 0" for kernel in kernels]


def test_sanitizers_would_see_an_array_that_is_too_small(tmp_path):
    source = readable_main("compass").replace("copy(q0, 2)", "copy(q0, 1)", 1)
    here = folder("compass")
    compiler = need(*COMPILERS)
    with pytest.raises(AssertionError, match="heap-buffer-overflow"):
        sanitized(compiler, source, here / "compass.c", includes=here, tmp_path=tmp_path)
