"""How long a press on the report of 100,000 cycles keeps the browser busy: ``python -m benchmarks.press``.

The page is of a made-up sweep. One cell of its map after another is pressed, until its frame is drawn.
With ``--profile`` the functions in which the time goes are listed.
"""

import argparse
import shutil
import statistics
import sys
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any
from unittest import mock

import stridemap
from stridemap.sweeps.config import parse_config
from stridemap.views.report import write
from tests.oracles.large_sweep import large_sweep
from tests.oracles.states import BROWSERS

FRAME = "new Promise(done => requestAnimationFrame(() => setTimeout(done)))"
PLACE = """i => { const { left, top } = document.getElementById("map").getBoundingClientRect();
    const { x, y, width, height } = stridemap.map.box(20 + 8 * i % 180, 5 + 7 * i % 40);
    return [left + x + width / 2, top + y + height / 2]; }"""


def write_page(path: Path) -> None:
    """The report of a made-up sweep with 100,000 limit cycles."""
    grid = {"k": [6.0], "alpha": [0.25], "omega": [3.0]}
    config = parse_config({"model": "wobbling", "grid": grid, "special_points": False})
    stridemap.sweep(config, path.parent / "sweep", workers=1)
    orbits = stridemap.read_orbits(path.parent / "sweep")
    with mock.patch.object(write, "read_shown", lambda *_: large_sweep(orbits[orbits.stable].iloc[0])):
        write.write_report("made up", path)


def press(page: Any, session: Any, i: int) -> tuple[float, float]:
    """Milliseconds for which a press keeps the page busy: in all, and in its own functions."""

    def busy() -> tuple[float, float]:
        found = {one["name"]: one["value"] for one in session.send("Performance.getMetrics")["metrics"]}
        return 1000 * found["TaskDuration"], 1000 * found["ScriptDuration"]

    page.mouse.move(*page.evaluate(PLACE, i))
    page.evaluate(FRAME)
    before = busy()
    page.mouse.down()
    page.mouse.up()
    page.evaluate(FRAME)
    task, script = (now - then for now, then in zip(busy(), before, strict=True))
    return task, script


def functions(profile: dict[str, Any]) -> Counter[str]:
    """Milliseconds in each function by itself."""
    names = {node["id"]: node["callFrame"] for node in profile["nodes"]}
    spent: Counter[str] = Counter()
    for node, micro in zip(profile["samples"], profile["timeDeltas"], strict=True):
        frame = names[node]
        spent[f"{frame['functionName'] or '(unnamed)'} line {frame['lineNumber'] + 1}"] += micro / 1000
    return spent


def main() -> None:
    """Make the page, press, and say how long it took."""
    from playwright.sync_api import sync_playwright

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--presses", type=int, default=40)
    parser.add_argument("--profile", action="store_true")
    options = parser.parse_args()
    chromium = next((found for name in BROWSERS if (found := shutil.which(name))), None)
    if chromium is None:
        sys.exit(f"No browser here: install one of {', '.join(BROWSERS)}.")
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        path = Path(folder) / "page.html"
        write_page(path)
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox", "--disable-gpu"])
        page = browser.new_page(viewport={"width": 1400, "height": 900}, reduced_motion="reduce")
        page.goto(path.as_uri())
        page.wait_for_selector("html[data-ready=yes]", state="attached", timeout=60_000)
        session = page.context.new_cdp_session(page)
        session.send("Performance.enable", {"timeDomain": "threadTicks"})
        if options.profile:
            session.send("Profiler.enable")
            session.send("Profiler.start")
        times = [press(page, session, i) for i in range(options.presses)]
        tasks, scripts = (sorted(one) for one in zip(*times, strict=True))
        print(f"page of {path.stat().st_size / 1e6:.1f} MB, {options.presses} presses")
        for title, found in (("busy", tasks), ("in scripts", scripts)):
            ends = f"from {found[0]:.1f} to {found[-1]:.1f} ms"
            print(f"{title:12} median {statistics.median(found):6.1f} ms, {ends}")
        if options.profile:
            for name, spent in functions(session.send("Profiler.stop")["profile"]).most_common(30):
                print(f"{spent / options.presses:8.2f} ms  {name}")
        browser.close()


if __name__ == "__main__":
    main()
