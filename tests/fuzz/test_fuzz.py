"""Two thousand inputs that nobody writes on purpose; ``python -m tests.fuzz 100000`` tries more."""

import shutil

import pytest

from tests.fuzz.harness import KINDS, Fault, cut

SHARES, PIECES = {"command lines": 700, "configurations": 800, "declarations": 500}, 4


@pytest.mark.parametrize("piece", range(PIECES))
@pytest.mark.parametrize("kind", list(KINDS))
def test_every_input_is_understood_or_refused_in_a_sentence(kind, piece, finished, tmp_path, monkeypatch):
    shutil.copy(finished / "small.toml", tmp_path)
    shutil.copytree(finished / "out", tmp_path / "out")
    cut(monkeypatch)
    faults, seen = [], set()
    for number in range(piece, SHARES[kind], PIECES):
        try:
            seen.add(KINDS[kind](number, tmp_path))
        except Fault as fault:
            faults.append(f"{number}: {fault}")
    assert faults == []
    # Some are in order, some are not; of declarations with one thing changed hardly any is.
    assert seen >= ({2} if kind == "declarations" else {0, 2})
