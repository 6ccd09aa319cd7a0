"""Whether every cell of the paper's map lies on the side of the boundaries that they say.

    python -m benchmarks.map_sides --cells 200

The boundaries cut the map into regions; in each, all cells must be of one class: without a gait, with
unstable gaits only, or with a stable one. This is asked of all cells of the sweep; and, independently of it,
of random cells that are searched anew from many starts, as are the cells that disagree.
"""

import argparse
from collections import Counter
from pathlib import Path

import numpy as np

import stridemap
from stridemap.paper.drawings.map import mapped
from stridemap.paper.drawings.material import Material
from stridemap.paper.drawings.regions import UNKNOWN
from stridemap.paper.points import PLANE
from stridemap.paper.sweeps import default_folder, paper_sweeps
from stridemap.solver.branches.plane import NONE, STABLE, UNSTABLE
from stridemap.solver.cycles.gait import is_physical_gait

WORDS = {NONE: "none", UNSTABLE: "unstable only", STABLE: "stable", UNKNOWN: "unknown"}


def searched(k: float, alpha: float, starts: int) -> int:
    """The class of a point, from a search of its own."""
    found = stridemap.find_orbits(
        "wobbling", k=float(k), alpha=float(alpha), omega=PLANE["omega"], options={"starts": starts}
    )
    gaits = found[is_physical_gait(found)]
    return NONE if not len(gaits) else STABLE if gaits.known_stable.any() else UNSTABLE


def main() -> None:
    """Print how many cells agree, and each that does not."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sweeps", type=Path, default=default_folder())
    parser.add_argument("--cells", type=int, default=200, help="random cells to search anew")
    parser.add_argument("--starts", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    given = parser.parse_args()
    plane, _, regions, classes = mapped(Material(paper_sweeps(given.sweeps)))
    side = classes[regions.of_cells(plane)]
    wrong = regions.on_the_other_side(plane, classes)
    print(
        f"cells of the sweep on the side that the boundaries say: {side.size - len(wrong):,} of {side.size:,}"
    )
    for i, j in wrong.tolist():
        anew = searched(plane.x[j], plane.y[i], given.starts)
        print(
            f"  k = {plane.x[j]:g}, alpha = {plane.y[i]:g}: sweep {WORDS[int(plane.classes[i, j])]}, "
            f"boundaries {WORDS[int(side[i, j])]}, searched from {given.starts:,} starts {WORDS[anew]}"
        )
    rng = np.random.default_rng(given.seed)
    counted: Counter[str] = Counter()
    for cell in rng.choice(side.size, size=min(given.cells, side.size), replace=False).tolist():
        i, j = divmod(cell, side.shape[1])
        anew = searched(plane.x[j], plane.y[i], given.starts)
        counted["agree" if anew == side[i, j] else "differ"] += 1
        if anew != side[i, j]:
            print(
                f"  k = {plane.x[j]:g}, alpha = {plane.y[i]:g}: boundaries {WORDS[int(side[i, j])]}, "
                f"searched {WORDS[anew]}"
            )
    print(
        f"random cells that a search of their own puts on that side: {counted['agree']:,} of {given.cells:,}"
    )


if __name__ == "__main__":
    main()
