"""``python -m tests.mutate [--only WORD] [--list]``: whether the tests notice changes of meaning.

Each change in `tests.mutations` is applied by itself to a copy of the checkout, and tests that must notice it
are run there. It is not part of the tests: all of them take a quarter of an hour.
"""

import argparse
import sys
import tempfile
from pathlib import Path

from tests.mutations import MUTATIONS
from tests.mutations.mutation import Copy, Mutation


def main() -> int:
    """Print what was noticed; 1 where a change was not, or cannot be applied."""
    parser = argparse.ArgumentParser(prog="python -m tests.mutate", description=__doc__.splitlines()[0])
    parser.add_argument("--only", metavar="WORD", help="those whose file, text or meaning holds this")
    parser.add_argument("--list", action="store_true", help="print them and change nothing")
    options = parser.parse_args()
    chosen = [one for one in MUTATIONS if options.only is None or options.only in _text(one)]
    if not chosen:
        print(f"no change holds {options.only!r}")
        return 1
    if options.list:
        print("\n".join(f"{one.file}: {one.breaks}" for one in chosen))
        return 0
    with tempfile.TemporaryDirectory() as folder:
        return _tried(Copy(Path(folder)), chosen)


def _text(one: Mutation) -> str:
    return "\n".join((one.file, one.old, one.new, one.breaks, *one.tests))


def _tried(copy: Copy, chosen: list[Mutation]) -> int:
    if not copy.imported():
        print("the package is not imported from the copy, so that nothing could be noticed")
        return 1
    tests = tuple(dict.fromkeys(test for one in chosen for test in one.tests))
    if (plain := copy.run(tests)).word != "passed":
        print(f"without a change the tests {plain.word}: {plain.first}")
        return 1
    print(f"without a change the tests pass ({plain.seconds:.0f} s)", flush=True)
    noticed = 0
    for one in chosen:
        try:
            outcome = copy.noticed(one)
        except ValueError as error:
            print(f"GONE       {error}", flush=True)
            continue
        seen = outcome.word in ("failed", "too long")
        noticed += seen
        word = "noticed" if seen else {"passed": "UNNOTICED"}.get(outcome.word, outcome.word.upper())
        print(f"{word:10} {outcome.seconds:5.1f} s  {one.file}: {one.breaks}", flush=True)
        print(f"{'':20}{outcome.first[:150]}", flush=True)
    print(f"{noticed} of {len(chosen)} noticed ({noticed / len(chosen):.0%})")
    return int(noticed < len(chosen))


if __name__ == "__main__":
    sys.exit(main())
