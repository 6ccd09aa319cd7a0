"""Frames of walkers side by side, and their writing as a GIF of few colours."""

import io
from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from stridemap.services import shown
from stridemap.views import palette, style, walker
from stridemap.views.scene import Scene

FORCE = 0.3
"""Length of the arrow for a force that equals the weight, in heights of the walker."""
HATCHES = 3
"""Hatches of the ground per step, a whole number so that the ground repeats with the steps."""
COLOURS = 32


def film(
    walkers: Sequence[Sequence[Scene]],
    titles: Sequence[str],
    steps: int,
    hundredths: int,
    size: int,
    magnify: float,
) -> bytes:
    """A GIF that loops for ever.

    Parameters
    ----------
    walkers : sequence of sequence of Scene
        The steps of each walker, over and over again; all with the same number of frames.
    titles : sequence of str
        One for each walker.
    steps : int
    hundredths : int
        Duration of a frame in hundredths of a second.
    size : int
        Width and height of a panel in pixels.
    magnify : float
        As the scenes were made with; the picture says so if it is not 1.
    """
    frames = len(walkers[0][0].middle) - 1
    places = [(step, i) for step in range(steps) for i in range(frames)]
    images = []
    with style.styled(), shown("drawing the film", "frames") as update:
        for number, (step, i) in enumerate(places):
            update(number, len(places))
            images.append(_frame([of[step % len(of)] for of in walkers], titles, step, i, size, magnify))
    return _gif(images, hundredths)


def _frame(
    scenes: Sequence[Scene], titles: Sequence[str], step: int, i: int, size: int, magnify: float
) -> Image.Image:
    dpi = size / 2.4  # so that text grows with the picture
    figure = Figure(figsize=(2.4 * len(scenes), 2.4), dpi=dpi)
    canvas = FigureCanvasAgg(figure)
    for n, (of, title) in enumerate(zip(scenes, titles, strict=True)):
        axes = figure.add_axes((n / len(scenes), 0, 1 / len(scenes), 1))
        draw_frame(axes, of, step, i)
        axes.text(0.5, 0.985, title, transform=axes.transAxes, ha="center", va="top", fontsize=8)
        if magnify != 1:
            axes.text(
                0.99, 0.037, f"displacement of the wobbling mass ×{magnify:g}", transform=axes.transAxes,
                ha="right", va="bottom", fontsize=6, color=style.DARK,
            )  # fmt: skip
    canvas.draw()
    return Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3].copy())


def draw_frame(axes: Axes, of: Scene, step: int, i: int) -> None:
    """Draw sample `i` of a scene in its step number `step`; in odd steps the right leg is the stance leg."""
    left, right, bottom, top = of.view
    middle = of.middle[i]
    level = of.rise / of.step * middle if of.rise else 0.0
    axes.set(xlim=(middle + left, middle + right), ylim=(level + bottom, level + top))
    axes.set_aspect("equal")
    axes.axis("off")
    reach = 0.2 + right - left  # more than is seen
    walker.draw_ground(axes, middle - reach, middle + reach, of.step / HATCHES, of.step, of.rise)
    stance, swing = (walker.LEFT, walker.RIGHT) if step % 2 == 0 else (walker.RIGHT, walker.LEFT)
    _draw_prints(axes, of, stance, swing)
    hip = None
    for line in of.drawn_lines:
        points = of.lines[line.name][i]
        if line.role == "spring":
            walker.draw_spring(axes, points)
        elif line.role == "legs":
            stance_leg, swing_leg = walker.leg_points(points)
            walker.draw_leg(axes, swing_leg, swing)
            walker.draw_leg(axes, stance_leg, stance)
            hip = swing_leg[0]
        else:
            axes.plot(*points.T, color=style.DARK, linewidth=2, zorder=2)
    if of.radius > 0:
        for foot, colour, up in zip(of.feet, (stance, swing), _leg_directions(of, i), strict=True):
            walker.draw_arc(axes, foot[i], of.radius, up, colour)
    colours = walker.mass_colours(of.bodies, of.positions[i], hip, stance, swing)
    walker.draw_masses(axes, [mass.name for mass in of.bodies], of.positions[i], of.masses, colours)
    arrow = {"arrowstyle": "-|>,head_width=0.25,head_length=0.5", "color": palette.FORCE, "linewidth": 1.5}
    below = np.array([of.cop[i], 0.0])
    axes.annotate(
        "", below + FORCE * of.force[i], below, arrowprops={**arrow, "shrinkA": 0, "shrinkB": 0}, zorder=6
    )
    axes.plot(of.zmp[i], -0.035, "^", color=palette.ZMP, markersize=6, mew=0, zorder=6)
    legend = {"transform": axes.transAxes, "va": "bottom", "fontsize": 4.8}
    axes.text(0.01, 0.005, f"→ {palette.MEANINGS['force']}", color=palette.FORCE, **legend)
    zmp = palette.MEANINGS["zmp"].removeprefix("the ")
    axes.text(0.99, 0.005, f"▲ {zmp}", ha="right", color=palette.ZMP, **legend)


def _leg_directions(of: Scene, i: int) -> tuple[np.ndarray, np.ndarray]:
    """From each foot towards where the legs meet; towards the centre of mass where no line says where."""
    legs = [of.lines[line.name][i] for line in of.drawn_lines if line.role == "legs"]
    mass = of.masses @ of.positions[i] / of.masses.sum()
    hip = walker.leg_points(legs[0])[1][0] if legs else mass
    return hip - of.feet[0][i], hip - of.feet[1][i]


def _draw_prints(axes: Axes, of: Scene, stance: str, swing: str) -> None:
    """Earlier footholds, in the colours of their legs."""
    for back in range(1, int(np.ceil(1 / of.step)) + 1):
        axes.plot(
            -back * of.step,
            -back * of.rise,
            "_",
            color=stance if back % 2 == 0 else swing,
            markersize=7,
            mew=2,
            zorder=1,
        )


def _gif(images: Sequence[Image.Image], hundredths: int) -> bytes:
    """All frames share one palette of few colours, without dithering, so that still parts cost nothing."""
    sheet = Image.new("RGB", (images[0].width, 4 * images[0].height))
    for n in range(4):
        sheet.paste(images[n * len(images) // 4], (0, n * images[0].height))
    palette = sheet.quantize(COLOURS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    few = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    out = io.BytesIO()
    few[0].save(
        out, "GIF", save_all=True, append_images=few[1:], duration=10 * hundredths, loop=0, optimize=False
    )
    return out.getvalue()
