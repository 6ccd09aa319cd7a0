"""How many of the paper's statements hold at round values of what it does not print.

``python -m benchmarks.preset`` evaluates them at the preset and at its round neighbours, on thinned-out
sweeps, and prints a table of Markdown.
"""

import argparse
from collections import Counter
from pathlib import Path

import stridemap

CANDIDATES: list[dict[str, float]] = [
    {},
    {"beta": 0.1},
    {"beta": 0.2},
    {"Kp": 5.0},
    {"Kp": 8.0},
    {"Kp": 12.0},
    {"Kd": 0.4},
    {"Kd": 0.8},
    {"S": 0.09, "gamma": 0.09},
    {"S": 0.15, "gamma": 0.15},
    {"S": 0.2, "gamma": 0.2},
    {"beta": 0.2, "S": 0.2, "gamma": 0.2},
    {"beta": 0.1, "S": 0.15, "gamma": 0.15},
]
"""Values in place of the preset's."""


def main() -> None:
    """Print a row a candidate."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--thin", type=int, default=4, help="every so-manieth value of k and alpha")
    parser.add_argument("--workers", type=int, default=None)
    parser.add_argument("--out", type=Path, default=Path("results/preset"), help="folder of the sweeps")
    arguments = parser.parse_args()
    print("| changed | holds | in part | differs | in part: | differ: |\n|---|---|---|---|---|---|")
    for params in CANDIDATES:
        name = ", ".join(f"{key} = {value:g}" for key, value in params.items()) or "nothing"
        folder = arguments.out / (name.replace(" ", "").replace(",", "-"))
        try:
            claims = stridemap.claims(folder, params=params, thin=arguments.thin, workers=arguments.workers)
        except stridemap.InputError as error:
            print(f"| {name} | {error} |", flush=True)
            continue
        count = Counter(claim.verdict.value for claim in claims)
        named = {v: " ".join(c.id for c in claims if c.verdict.value == v) for v in ("in part", "differs")}
        print(
            f"| {name} | {count['holds']} | {count['in part']} | {count['differs']} | {named['in part']} | "
            f"{named['differs']} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
