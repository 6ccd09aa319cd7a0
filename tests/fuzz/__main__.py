"""``python -m tests.fuzz 100000``: many inputs, a table of what became of them, and the first faults."""

import collections
import shutil
import sys
import tempfile
import time
from pathlib import Path

import pytest

from stridemap.sweeps.run import sweep
from tests.fuzz.harness import KINDS, Fault, cut
from tests.oracles.sweeping import SMALL, Inline


def run(count, seconds=None):
    """Try `count` inputs, a third of each kind, or as many as some seconds allow."""
    begun, faults, outcomes = time.monotonic(), [], collections.Counter()
    with tempfile.TemporaryDirectory() as name, pytest.MonkeyPatch.context() as patch:
        folder = Path(name)
        (folder / "small.toml").write_text(SMALL)
        sweep(folder / "small.toml", folder / "out", executor=Inline())
        cut(patch)
        for number in range(count):
            if seconds is not None and time.monotonic() - begun > seconds:
                break
            kind = list(KINDS)[number % len(KINDS)]
            try:
                outcomes[kind, KINDS[kind](number, folder)] += 1
            except Fault as fault:
                outcomes[kind, "fault"] += 1
                faults.append((kind, number, str(fault)))
            for left in folder.iterdir():
                if left.name not in ("small.toml", "out"):
                    shutil.rmtree(left) if left.is_dir() else left.unlink()
    return outcomes, faults, time.monotonic() - begun


if __name__ == "__main__":
    outcomes, faults, took = run(int(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else None)
    for kind, number, fault in faults[:40]:
        print(f"{kind} {number}: {fault}")
    for (kind, outcome), times in sorted(outcomes.items(), key=str):
        print(f"{kind:16} {outcome!s:6} {times:8,}")
    print(f"{sum(outcomes.values()):,} inputs, {len(faults)} faults, {took:.0f} s")
    sys.exit(bool(faults))
