"""Run every static check: `make lint` calls this with the interpreter of `.venv`.

The folders at the root are the parts of one package (see `package-dir` in pyproject.toml). Python finds them
through the editable install, static tools do not; so mypy and import-linter run in `.venv/tree`, where the
package stands as one tree of links, made anew every time.
"""

import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BIN = Path(sys.executable).parent
TREE = BIN.parent / "tree"


def make_tree(package_dir: dict[str, str]) -> None:
    """Lay the package out as one tree of links; new files in a linked folder are seen at once."""
    shutil.rmtree(TREE, ignore_errors=True)
    for package, folder in sorted(package_dir.items()):  # a parent sorts before its children
        target = TREE.joinpath(*package.split("."))
        if any(other.startswith(f"{package}.") for other in package_dir):
            target.mkdir(parents=True)
            for entry in (ROOT / folder).iterdir():
                if entry.name != "__pycache__":
                    target.joinpath(entry.name).symlink_to(entry)
        else:
            target.symlink_to(ROOT / folder, target_is_directory=True)


def unpackaged(setuptools: dict) -> list[str]:
    """Return a sentence for each file below a package folder that the wheel would not hold."""
    faults = []
    for package, folder in setuptools["package-dir"].items():
        for path in sorted((ROOT / folder).rglob("*")):
            if path.is_dir() or "__pycache__" in path.parts or path.name.startswith("."):
                continue
            name = ".".join((package, *path.relative_to(ROOT / folder).parent.parts))
            shown = path.relative_to(ROOT)
            if path.suffix == ".py":
                if name not in setuptools["packages"]:
                    faults.append(f'{shown}: add "{name}" to `packages` in pyproject.toml')
            elif not any(path.match(glob) for glob in setuptools["package-data"].get(name, [])):
                faults.append(f'{shown}: name it under `package-data`, "{name}", in pyproject.toml')
    return faults


def run(*command: str | Path, cwd: Path = ROOT) -> bool:
    """Run one check, name files as they lie in the repository, and return whether it passed."""
    print(f"-- {Path(command[0]).name}", flush=True)
    done = subprocess.run((BIN / command[0], *command[1:]), cwd=cwd, capture_output=True, text=True)
    shown = re.sub(r"^stridemap/(?=(derive|generated|solver|sweeps)/)", "", done.stdout, flags=re.MULTILINE)
    print(shown.strip() + done.stderr, flush=True)
    return done.returncode == 0


def main() -> int:
    """Run all checks, also after one has failed, and return the exit status."""
    project = ROOT / "pyproject.toml"
    setuptools = tomllib.loads(project.read_text("utf-8"))["tool"]["setuptools"]
    make_tree(setuptools["package-dir"])

    print("-- packages")
    faults = unpackaged(setuptools)
    print(*faults or ["Every file is in the wheel."], sep="\n")
    cache = ROOT / ".mypy_cache"
    passed = {
        "packages": not faults,
        "ruff check": run("ruff", "check", "."),
        "ruff format": run("ruff", "format", "--check", "."),
        "mypy": run("mypy", "--config-file", project, "--cache-dir", cache, "-p", "stridemap", cwd=TREE),
        "import-linter": run("lint-imports", "--config", project, "--no-cache", "--no-logo", cwd=TREE),
    }
    failed = [name for name, good in passed.items() if not good]
    print(f"lint: failed: {', '.join(failed)}" if failed else "lint: all checks passed")
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
