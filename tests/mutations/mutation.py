"""One change of meaning, and where it is applied: a copy of the checkout, never the checkout itself."""

import os
import shutil
import subprocess
import sys
import time
import tomllib
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]

SECONDS = 600
"""After so long the tests are ended: a change that makes a program run for ever is noticed by that."""

# Put before everything else that finds modules, in this process and in those that tests start.
FINDER = """
import sys
from importlib.util import spec_from_file_location

FOLDERS = {folders!r}

class Copied:
    @staticmethod
    def find_spec(name, path=None, target=None):
        folder = FOLDERS.get(name)
        if folder is None:
            return None
        return spec_from_file_location(name, folder + "/__init__.py", submodule_search_locations=[folder])

sys.meta_path.insert(0, Copied)
"""


@dataclass(frozen=True)
class Mutation:
    """A change of meaning that tests must notice.

    Parameters
    ----------
    file : str
        From the root of the checkout.
    old, new : str
        What is replaced, which occurs exactly once in the file, and by what.
    breaks : str
        What is wrong then.
    tests : tuple of str
        Files of tests, or tests in them, that must notice it: few and fast.
    """

    file: str
    old: str
    new: str
    breaks: str
    tests: tuple[str, ...]

    def applied(self) -> str:
        """The file's text with the change.

        Raises
        ------
        ValueError
            When the old text does not occur exactly once.
        """
        text = (ROOT / self.file).read_text("utf-8")
        if (times := text.count(self.old)) != 1:
            raise ValueError(f"{self.file} holds {self.old!r} {times} times, not once")
        return text.replace(self.old, self.new)


@dataclass(frozen=True)
class Outcome:
    """What became of one run of tests.

    Parameters
    ----------
    word : str
        "passed", "failed", "too long", or "broken" where the tests could not even begin.
    first : str
        The first line that names a fault.
    seconds : float
    """

    word: str
    first: str
    seconds: float


class Copy:
    """A copy of the checkout in a folder, whose package is imported instead of the checkout's.

    Parameters
    ----------
    folder : Path
        Empty. What was compiled before is linked into it, so that what changed files lead to is not kept.
    """

    def __init__(self, folder: Path) -> None:
        self.root, self.finder, cache = folder / "checkout", folder / "finder", folder / "cache"
        listed = ["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
        names = subprocess.run(listed, capture_output=True, text=True, check=True).stdout.split("\0")
        for name in filter(None, names):
            if (ROOT / name).is_file():
                target = self.root / name
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(ROOT / name, target)
        self.finder.mkdir()
        packages = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["setuptools"]
        folders = {name: str(self.root / part) for name, part in packages["package-dir"].items()}
        (self.finder / "sitecustomize.py").write_text(FINDER.format(folders=folders), "utf-8")
        # Compiled files that are compared by content: a change and its undoing may be of one second.
        compiled = ["-m", "compileall", "-q", "--invalidation-mode", "checked-hash", self.root]
        subprocess.run([sys.executable, *compiled], check=True)
        own = Path(os.environ.get("STRIDEMAP_CACHE") or ROOT / ".pytest_cache" / "stridemap")
        if own.is_dir():
            shutil.copytree(own, cache, copy_function=_linked)
        self.environment = {
            **os.environ,
            "PYTHONPATH": str(self.finder),
            "PYTHONDONTWRITEBYTECODE": "1",
            "STRIDEMAP_CACHE": str(cache),
        }

    def imported(self) -> bool:
        """Whether the package and its parts are imported from the copy."""
        code = (
            "import stridemap, stridemap.derive, stridemap.solver as s; print(stridemap.__file__, s.__file__)"
        )
        done = subprocess.run(
            [sys.executable, "-c", code], cwd=self.root, env=self.environment, capture_output=True, text=True
        )
        return all(name.startswith(str(self.root)) for name in (done.stdout.split() or [""]))

    def noticed(self, mutation: Mutation) -> Outcome:
        """The mutation's tests with its change, which is undone afterwards."""
        path = self.root / mutation.file
        before = path.read_bytes()
        path.write_text(mutation.applied(), "utf-8")
        try:
            return self.run(mutation.tests)
        finally:
            path.write_bytes(before)

    def run(self, tests: tuple[str, ...]) -> Outcome:
        """Some tests."""
        options = ["-x", "-q", "-n", "0", "--no-header", "-p", "no:cacheprovider", "--tb", "line"]
        begun = time.monotonic()
        try:
            done = subprocess.run(
                [sys.executable, "-m", "pytest", *options, *tests],
                cwd=self.root, env=self.environment, capture_output=True, text=True, timeout=SECONDS,
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            return Outcome("too long", "", SECONDS)
        word = {0: "passed", 1: "failed"}.get(done.returncode, "broken")
        named = [line for line in done.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
        return Outcome(word, named[0] if named else done.stderr[-500:], time.monotonic() - begun)


def _linked(source: str, target: str) -> None:
    try:
        os.link(source, target)
    except OSError:
        shutil.copyfile(source, target)
