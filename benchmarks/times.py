"""What the commands take of which pages say how long they take: ``python -m benchmarks.times [NAME ...]``.

The commands stand in ``times.toml``, and their processor seconds are written there, those of the processes
that they start included. A name brings those with it after which its command runs; without names all are
measured, which takes about half an hour.
"""

import os
import platform
import re
import resource
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
RECORD = Path(__file__).with_suffix(".toml")
BLOCK = re.compile(r"^```\{code-block\} python\n:caption: (\S+)\n\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def recorded() -> dict[str, dict[str, Any]]:
    """The commands with what they took, by name, in the order in which they can run."""
    data = tomllib.loads(RECORD.read_text("utf-8"))
    return {name: entry for name, entry in data.items() if isinstance(entry, dict)}


def with_earlier(entries: Mapping[str, dict[str, Any]], names: list[str]) -> list[str]:
    """Names with those after which they run, in order."""
    wanted: set[str] = set()
    for name in names or entries:
        while name is not None and name not in wanted:
            if name not in entries:
                raise SystemExit(f"there is no command {name!r} in {RECORD.name}: {', '.join(entries)}")
            wanted.add(name)
            name = entries[name].get("after")
    return [name for name in entries if name in wanted]


def processor_seconds(entry: Mapping[str, Any], folder: Path, cache: Path) -> float:
    """What a command takes in a folder; the first time that it runs, where `cache` is empty."""
    for name, page in entry.get("files", {}).items():
        blocks = BLOCK.findall((ROOT / page).read_text("utf-8"))
        (folder / name).write_text("\n".join(code for caption, code in blocks if caption == name))
    program, *words = entry["command"].split()
    words = [str(ROOT / word) if (ROOT / word).is_file() else word for word in words]
    start = [sys.executable, "-m", "stridemap"] if program == "stridemap" else [sys.executable]
    environment = {**os.environ, "STRIDEMAP_CACHE": str(cache)}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([*start, *words], cwd=folder, env=environment, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def machine() -> str:
    """The processor and the interpreter, for readers."""
    try:
        lines = Path("/proc/cpuinfo").read_text("utf-8").splitlines()
        model = next(line.split(":")[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        model = platform.machine()
    return f"{model}, {os.cpu_count()} processors, Python {platform.python_version()}"


def record(name: str, seconds: float) -> None:
    """Write what a command took, and on which machine."""
    text = RECORD.read_text("utf-8")
    head, mark, rest = text.partition(f"[{name}]\n")
    own, *others = re.split(r"(?m)^(?=\[)", rest, maxsplit=1)
    own = re.sub(r"(?m)^seconds = .*\n", "", own)
    own = re.sub(r"(?m)^(command = .*\n)", rf"\g<1>seconds = {seconds:.1f}\n", own)
    head = re.sub(r'(?m)^machine = ".*"', f'machine = "{machine()}"', head)
    RECORD.write_text("".join([head, mark, own, *others]), "utf-8")


def main(names: list[str]) -> None:
    """Measure commands by name, one after another, each as the first of its kind."""
    entries = recorded()
    with tempfile.TemporaryDirectory() as scratch:
        folder, warm = Path(scratch) / "work", Path(scratch) / "cache"
        folder.mkdir()
        caches = {name: warm for name in entries}
        for name in with_earlier(entries, names):
            entry = entries[name]
            if entry.get("cache") == "new":
                caches[name] = Path(scratch) / f"cache-{name}"
            elif "after" in entry:
                caches[name] = caches[entry["after"]]
            elif caches[name] is warm:  # what is not about the first use has its kernels
                processor_seconds({**entry, "command": "stridemap orbit --model compass"}, folder, warm)
                processor_seconds({**entry, "command": "stridemap orbit"}, folder, warm)
            seconds = processor_seconds(entry, folder, caches[name])
            print(f"{name}: {seconds:.1f} s of processor time ({entry['command']})", flush=True)
            record(name, seconds)


if __name__ == "__main__":
    main(sys.argv[1:])
