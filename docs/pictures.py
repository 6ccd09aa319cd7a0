"""Make the pictures of the README, docs/images: ``make images``."""

import shutil
from pathlib import Path

import stridemap
from stridemap.paper.points import PLANE, TYPICAL

IMAGES = Path(__file__).parent / "images"
FIGURES = Path("results/paper-figures")


def main() -> None:
    """The paper's three typical solutions walking side by side, and its map."""
    gaits = []
    for group, k in TYPICAL.items():
        found = stridemap.find_orbits("wobbling", k=k, **PLANE)
        gaits.append(min((o for o in found if o.group == group), key=lambda o: o.spectral_radius))
    titles = [f"group {o.group}, k = {o.params['k']:g}" for o in gaits]
    stridemap.animate(gaits, IMAGES / "gaits.gif", titles=titles, size=300, fps=20, magnify=5)
    shutil.copy(FIGURES / "map.png", IMAGES)


if __name__ == "__main__":
    main()
