"""Times that pages say, against what was measured: within a factor of two."""

import re
from pathlib import Path

import pytest

from benchmarks import times

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
RECORDED = times.recorded()
SAID = [(name, page, words) for name, one in RECORDED.items() for page, words in one.get("pages", {}).items()]

UNITS = {"s": 1, "second": 1, "min": 60, "minute": 60, "h": 3600, "hour": 3600}
NUMBERS = "half-a one two three four five six seven eight nine ten eleven twelve".split()
WORDS = {word: float(i) for i, word in enumerate(NUMBERS)} | {
    "a": 1.0, "an": 1.0, "half a": 0.5, "half an": 0.5, "a few": 4.0, "some": 4.0,
    "fifteen": 15.0, "twenty": 20.0, "thirty": 30.0,
}  # fmt: skip
COUNT = rf"(?:\d[\d,.]*|{'|'.join(sorted(WORDS, key=len, reverse=True))})"
TIME = re.compile(rf"\b({COUNT}) (s|seconds?|min|minutes?|h|hours?)\b|\b(in) (seconds|minutes)\b")
ORDINAL = re.compile(r"(?<!takes )(?<!take )(?<!after )(?<!within )\ba second (?=[a-z])")
"""As in "a second derivation"."""

NOT_MEASURED = {
    ("CONTRIBUTING.md", "a minute"): "set-up, which depends on the network, and the tests of `make quick`",
    ("CONTRIBUTING.md", "ten minutes"): "the limit that the command names",
    ("docs/declare.md", "an hour"): "the limit after which a derivation is ended",
    ("docs/declare.md", "in seconds"): "of terms of a length that is not said",
    ("docs/declare.md", "0.732414844429 s"): "the period of a gait",
    ("docs/sweeps.md", "0.01 s"): "one of 7,698 special points on 140 lines of a sweep",
    ("docs/many-machines.md", "some seconds"): "what a tile takes on a cluster",
}
"""Times on pages that no command of the record takes, with the reason."""


def bounds(words):
    """What a time in words allows to be measured: half of it to twice, and less than twenty of no number."""
    count, unit, vague, units = TIME.search(words).groups()
    if vague:
        return 0.0, 20.0 * UNITS[units.removesuffix("s")]
    number = WORDS[count] if count in WORDS else float(count.replace(",", ""))
    seconds = number * UNITS[unit.removesuffix("s") or unit]
    return seconds / 2, 2 * seconds


@pytest.mark.parametrize(("name", "page", "words"), SAID, ids=[f"{name}-{page}" for name, page, _ in SAID])
def test_a_page_says_what_was_measured(name, page, words):
    assert words in " ".join((ROOT / page).read_text("utf-8").split())
    seconds = RECORDED[name].get("seconds")
    if seconds is None:
        pytest.skip(f"not measured: python -m benchmarks.times {name}")
    low, high = bounds(words)
    assert low <= seconds <= high


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_every_time_on_a_page_is_of_a_command_that_is_measured(page):
    name = page.relative_to(ROOT).as_posix()
    text = ORDINAL.sub("another ", " ".join(page.read_text("utf-8").split()))
    covered = [
        (at.start(), at.end()) for _, where, words in SAID if where == name
        for at in re.finditer(re.escape(words), text)
    ]  # fmt: skip
    for found in TIME.finditer(text):
        if (name, found[0]) not in NOT_MEASURED:
            assert any(begin <= found.start() and found.end() <= end for begin, end in covered), found[0]


@pytest.mark.parametrize(
    ("words", "low", "high"),
    [
        ("about six minutes of processor time", 180, 720),
        ("138 s of processor time", 69, 276),
        ("two minutes the first time", 60, 240),
        ("half a minute", 15, 60),
        ("run in seconds", 0, 20),
    ],
)
def test_times_in_words_are_understood(words, low, high):
    assert bounds(words) == (low, high)


def test_a_measurement_is_written_where_it_belongs(tmp_path, monkeypatch):
    copy = tmp_path / "times.toml"
    copy.write_text(times.RECORD.read_text("utf-8"), "utf-8")
    monkeypatch.setattr(times, "RECORD", copy)
    before = times.recorded()
    for seconds in (7.25, 1.0):
        times.record("claims", seconds)
    after = times.recorded()
    assert after.pop("claims") == {**before.pop("claims"), "seconds": 1.0}
    assert after == before
    assert times.machine() in copy.read_text("utf-8")


def test_a_command_runs_after_those_that_it_needs():
    assert times.with_earlier(RECORDED, ["report"]) == ["claims", "map", "report"]
    assert times.with_earlier(RECORDED, []) == list(RECORDED)
    with pytest.raises(SystemExit, match="no command 'clams'"):
        times.with_earlier(RECORDED, ["clams"])
