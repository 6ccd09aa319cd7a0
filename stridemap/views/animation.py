"""Limit cycles in motion: a looping GIF of one walker, or of several side by side."""

import math
import textwrap
from collections.abc import Sequence
from pathlib import Path

from stridemap.errors import InputError
from stridemap.solver.cycles.orbit import Orbit
from stridemap.views.optional import require_pictures

SECONDS = 1.2
"""Duration of a step on the screen: about three times that of a leg of one metre on Earth."""

TITLE_WIDTH = 40
"""Letters that a panel is wide."""

STEPS_MAX = 100
"""Most steps of a film, unless a cycle of more steps needs them."""

FPS, SIZE, WALKERS = (2, 50), (80, 1600), 6
"""Frames per second and pixels that are allowed, and how many walkers."""


def animate(
    orbits: Orbit | Sequence[Orbit],
    path: str | Path,
    *,
    titles: Sequence[str] | None = None,
    steps: int | None = None,
    fps: int = 25,
    size: int = 320,
    magnify: float = 1.0,
) -> Path:
    """Write a GIF of limit cycles walking side by side, which loops without a jump.

    It shows the legs, the masses (discs whose areas are as the masses), springs, the force of the ground at
    the centre of pressure (arrow) and the paper's zero moment point, from which its distance d is measured
    (triangle). A step of each walker lasts the same time on the screen, whatever its period.

    Parameters
    ----------
    orbits : Orbit or sequence of Orbit
    path : path
        Where the GIF goes.
    titles : sequence of str, optional
        One for each; by default the model's title, group and stability, and the parameters that differ.
    steps : int, optional
        Steps until it repeats, an even number: after an odd number left and right leg are exchanged. For
        cycles of several steps, a multiple of these too; by default the smallest number.
    fps : int
        Frames per second; the duration of a frame is rounded to hundredths of a second, as GIF has it.
    size : int
        Width and height of each walker's panel in pixels.
    magnify : float
        Factor by which the displacement of the wobbling mass is drawn larger than it is; the picture says so.

    Returns
    -------
    pathlib.Path

    Raises
    ------
    InputError
        For an orbit that was not found, a setting out of range, a missing package, or a path that cannot be
        written.
    """
    shown = [orbits] if isinstance(orbits, Orbit) else list(orbits)
    _check_range("orbits", len(shown), (1, WALKERS), "walkers side by side")
    _check_range("fps", fps, FPS, "frames per second")
    _check_range("size", size, SIZE, "pixels")
    least = math.lcm(2, *(orbit.period_n for orbit in shown))
    steps = least if steps is None else steps
    most = max(STEPS_MAX, least)
    if steps < 2 or steps % least or steps > most:
        what = "an even number" if least == 2 else f"a multiple of {least}"
        raise InputError(f"steps = {steps} is not allowed: {what} from {least} to {most} is needed")
    if not (math.isfinite(magnify) and 0 < magnify <= 100):
        raise InputError(f"magnify = {magnify:g} is not allowed: a number above 0 and up to 100 is needed")
    if titles is not None and len(titles) != len(shown):
        raise InputError(f"{len(titles)} titles were given for {len(shown)} orbits; give one for each")
    if Path(path).suffix.lower() != ".gif":
        raise InputError(f"{path} does not end in .gif; an animation is a GIF, so give it that ending")
    require_pictures()
    from stridemap.views.film import film
    from stridemap.views.scene import scenes
    from stridemap.views.style import put

    hundredths = round(100 / fps)
    frames = round(100 * SECONDS / hundredths)
    walkers = [scenes(orbit, frames, magnify) for orbit in shown]
    content = film(walkers, titles or _titles(shown), steps, hundredths, size, magnify)
    return put(Path(path), content)


def choose(orbits: Sequence[Orbit], group: str | None = None, cycle: int | None = None) -> Orbit:
    """One of the limit cycles of a point: by number from 1, or the most stable one, of a group or of all.

    Raises
    ------
    InputError
        When there is no such cycle or group, or both are asked for.
    """
    if group is not None and cycle is not None:
        raise InputError(f"--group {group} and --cycle {cycle} are two choices; give one of them")
    if cycle is not None:
        _check_range("cycle", cycle, (1, len(orbits)), "the cycles at this point")
        return orbits[cycle - 1]
    candidates = [orbit for orbit in orbits if group in (None, orbit.group)]
    if not candidates:
        known = sorted({orbit.group for orbit in orbits if orbit.group})
        have = f"groups there: {', '.join(known)}" if known else f"{orbits[0].model.name} has no groups"
        raise InputError(f"there is no limit cycle of group {group!r} at this point; {have}")
    return min(candidates, key=lambda orbit: orbit.spectral_radius)


def _check_range(name: str, value: int, allowed: tuple[int, int], what: str) -> None:
    low, high = allowed
    if not low <= value <= high:
        raise InputError(f"{name} = {value} is not allowed: {low} to {high} ({what})")


def _titles(orbits: Sequence[Orbit]) -> list[str]:
    """What distinguishes the walkers: model, group, stability, and the parameters that differ."""
    alike = len({orbit.model for orbit in orbits}) == 1
    names = dict.fromkeys(name for orbit in orbits if alike for name in orbit.params)
    differing = [n for n in names if len({orbit.params.get(n) for orbit in orbits}) > 1]
    out = []
    for orbit in orbits:
        group = f"group {orbit.group}, " if orbit.group else ""
        words = [textwrap.fill(orbit.model.title, TITLE_WIDTH)]
        several = f"{orbit.period_n} steps, " if orbit.steps else ""
        words += [f"{group}{several}{orbit.stability}"]
        shown = differing or [n for n in orbit.params if n in ("k", "alpha", "omega")]
        values = ", ".join(f"{n} = {orbit.params[n]:g}" for n in shown)
        words += [
            textwrap.fill(textwrap.shorten(values, 2 * TITLE_WIDTH - 8, placeholder=" ..."), TITLE_WIDTH)
        ]
        out.append("\n".join(word for word in words if word))
    return out
