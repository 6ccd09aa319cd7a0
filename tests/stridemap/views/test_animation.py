"""Animations: frames, loops, what is drawn where, any model, refusals."""

from dataclasses import replace

import numpy as np
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.spec import Line, Mass

pytest.importorskip("matplotlib")
pytest.importorskip("PIL")

from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from PIL import Image

from stridemap.views import palette, walker
from stridemap.views.animation import _titles, choose
from stridemap.views.film import draw_frame
from stridemap.views.scene import scene


@pytest.fixture(scope="module")
def orbits():
    return stridemap.find_orbits("wobbling", k=6, alpha=0.25, omega=3)


def test_a_gif_of_two_walkers(orbits, tmp_path):
    path = stridemap.animate(orbits[:2], tmp_path / "two.gif", steps=2, fps=10, size=120)
    with Image.open(path) as film:
        assert film.size == (240, 120)
        assert film.n_frames == 24  # 1.2 s a step
        assert film.info["duration"] == 100
        assert film.info["loop"] == 0
        frames = []
        for i in range(film.n_frames):
            film.seek(i)
            frames.append(np.asarray(film.convert("RGB")).astype(int))
    # It loops without a jump: from the last frame to the first no more changes than between two others.
    changes = [np.abs(one - other).sum() for one, other in zip(frames, [*frames[1:], frames[0]], strict=True)]
    assert changes[-1] <= 1.2 * max(changes[:-1])
    assert min(changes) > 0
    assert path.stat().st_size < 500_000


def test_a_scene_is_the_motion(orbits):
    shown = scene(orbits[1], 40)
    seen = stridemap.motion(orbits[1], 41)
    height = max(seen.positions[..., 1].max(), seen.lines["legs"][..., 1].max())
    assert np.allclose(shown.positions * height, seen.positions, atol=1e-15)
    assert shown.step * height == pytest.approx(orbits[1].step_length, rel=1e-14)
    assert np.allclose(shown.zmp * height, -seen.d, atol=1e-12)
    assert np.all(shown.contact == 0)
    assert np.all(shown.cop == 0)
    weight = 1 + 2 * orbits[1].params["beta"]
    assert np.allclose(shown.force * weight, seen.force, rtol=1e-14)
    assert shown.masses.sum() == pytest.approx(1.0)


def test_only_the_wobbling_mass_is_magnified(orbits):
    plain, larger = scene(orbits[1], 8), scene(orbits[1], 8, magnify=5)
    roles = [mass.role for mass in plain.bodies]
    hip, mass = (roles.index(role) for role in ("body", "wobbling"))
    displacement = plain.positions[:, mass] - plain.positions[:, hip]
    assert np.allclose(larger.positions[:, mass] - larger.positions[:, hip], 5 * displacement, atol=1e-14)
    assert np.array_equal(larger.positions[:, hip], plain.positions[:, hip])


@pytest.mark.parametrize("model", ["compass", "simplest_walker", "goswami_compass", "rimless_wheel"])
def test_any_model(model, tmp_path):
    (orbit, *_) = stridemap.find_orbits(model)
    path = stridemap.animate(orbit, tmp_path / "walk.gif", fps=5, size=80)
    with Image.open(path) as film:
        assert film.n_frames == 12


def everything(axes):
    """Corners of all lines and discs of a walker; the ground has no end, the zero moment point runs away."""
    walker_s = [line for line in axes.lines if line.get_zorder() >= 2 and line.get_marker() != "^"]
    points = [line.get_xydata() for line in walker_s]
    for disc in (patch for patch in axes.patches if patch.get_gid()):
        centre, radius = np.array(disc.get_center()), disc.get_radius()
        points.append([centre - radius, centre + radius])
    return np.concatenate(points)


@pytest.mark.parametrize(
    ("model", "params"),
    [
        ("rimless_wheel", {}),
        ("rimless_wheel", {"spokes": 5, "slope": 0.4}),
        ("round_feet", {}),
        ("compass", {}),
    ],
)
def test_nothing_leaves_the_picture(model, params):
    for orbit in stridemap.find_orbits(model, params):
        shown = scene(orbit, 12)
        for i in range(12):
            axes = Figure().add_subplot()
            draw_frame(axes, shown, i % 2, i)
            seen = everything(axes)
            (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
            assert (seen[:, 0] > left).all()
            assert (seen[:, 0] < right).all()
            assert (seen[:, 1] > bottom).all()
            assert (seen[:, 1] < top).all()
            assert right - left == pytest.approx(top - bottom)


def feet_of(axes):
    return [line.get_xydata() for line in axes.lines if line.get_gid() == "foot"]


def test_round_feet_are_arcs_on_the_ground():
    """Each foot is an arc about its centre; the stance foot's lowest point is on the ground all the time."""
    for orbit in stridemap.find_orbits("round_feet"):
        shown = scene(orbit, 10)
        assert shown.rise == 0
        for i in range(10):
            axes = Figure().add_subplot()
            draw_frame(axes, shown, 0, i)
            stance, swing = feet_of(axes)
            assert stance[:, 1].min() == pytest.approx(0, abs=2e-3 * shown.radius)
            for foot, points in zip(shown.feet, (stance, swing), strict=True):
                distance = np.hypot(*(points - foot[i]).T)
                assert distance == pytest.approx(np.full(len(points), shown.radius))
    axes = Figure().add_subplot()
    draw_frame(axes, scene(stridemap.find_orbits("compass")[0], 4), 0, 1)
    assert feet_of(axes) == []


def test_stairs_are_drawn_where_the_ground_rises(orbits):
    shown = replace(scene(orbits[1], 10), rise=0.05)
    for i in range(10):
        axes = Figure().add_subplot()
        draw_frame(axes, shown, 0, i)
        (stairs,) = [line.get_xydata() for line in axes.lines if line.get_gid() == "stairs"]
        height = dict(zip(np.round(stairs[:, 0].reshape(-1, 2).mean(axis=1) / shown.step).astype(int),
                          stairs[::2, 1], strict=True))  # fmt: skip
        for foothold in (-1, 0, 1):
            assert height[foothold] == pytest.approx(foothold * 0.05, abs=1e-12)
        # The view goes up with the walker.
        assert np.mean(axes.get_ylim()) == pytest.approx(
            np.mean([shown.view[2], shown.view[3]]) + 0.05 * shown.middle[i] / shown.step
        )
    flat = scene(orbits[1], 10)
    assert (flat.rise, flat.radius) == (0.0, 0.0)


def test_titles_are_the_models_titles(orbits):
    assert _titles(orbits[:1])[0].replace("\n", " ").startswith(orbits[0].model.title)
    (wheel, *_) = stridemap.find_orbits("rimless_wheel")
    assert _titles([wheel]) == ["Rimless wheel\nstable"]
    for words in _titles([*orbits, wheel]):
        assert max(len(line) for line in words.split("\n")) <= 40
    assert wheel.plot().get_suptitle() == "Rimless wheel, stable"


def drawn(shown):
    """Colours and line widths of a frame, and the colours of its discs by mass."""
    axes = Figure().add_subplot()
    draw_frame(axes, shown, 0, 3)
    discs = {patch.get_gid(): to_hex(patch.get_facecolor()) for patch in axes.patches if patch.get_gid()}
    return [(line.get_color(), line.get_linewidth(), len(line.get_xdata())) for line in axes.lines], discs


def test_names_do_not_matter_but_roles_do(orbits, monkeypatch):
    shown = scene(orbits[1], 8)
    model = shown.seen.model
    lines, discs = drawn(shown)
    assert discs == {
        "hip": walker.HIP, "wobbling mass": palette.MASS, "stance foot": walker.LEFT,
        "swing foot": walker.RIGHT,
    }  # fmt: skip
    names = [mass.name for mass in model.spec.masses]
    others = tuple(Mass(f"part {i}", mass.role) for i, mass in enumerate(model.spec.masses))
    monkeypatch.setattr(model, "spec", replace(model.spec, masses=others))
    renamed = drawn(shown)
    assert renamed == (lines, {f"part {i}": discs[m] for i, m in enumerate(names)})
    swapped = tuple(Mass(mass.name, "body") for mass in others)
    monkeypatch.setattr(model, "spec", replace(model.spec, masses=swapped))
    assert set(drawn(shown)[1].values()) == {walker.HIP, palette.BODY}
    rigid = tuple(Line(line.name, "part") for line in model.spec.lines)
    monkeypatch.setattr(model, "spec", replace(model.spec, lines=rigid))
    assert len(drawn(shown)[0]) == len(lines) - 1  # one line in place of two legs


def test_choices(orbits):
    assert choose(orbits) == choose(orbits, group="B") == min(orbits, key=lambda o: o.spectral_radius)
    assert choose(orbits, cycle=1) == orbits[0]
    with pytest.raises(InputError, match="no limit cycle of group 'C' at this point; groups there: B"):
        choose(orbits, group="C")
    with pytest.raises(InputError, match="cycle = 3 is not allowed: 1 to 2"):
        choose(orbits, cycle=3)


@pytest.mark.parametrize(
    ("setting", "sentence"),
    [
        ({"steps": 3}, "steps = 3 is not allowed: an even number"),
        ({"fps": 500}, "fps = 500 is not allowed: 2 to 50"),
        ({"size": 5}, "size = 5 is not allowed: 80 to 1600"),
        ({"magnify": float("nan")}, "magnify = nan is not allowed"),
        ({"titles": ["one", "two"]}, "2 titles were given for 1 orbits"),
    ],
)
def test_settings_are_checked(orbits, tmp_path, setting, sentence):
    with pytest.raises(InputError, match=sentence):
        stridemap.animate(orbits[0], tmp_path / "a.gif", **setting)
    assert not list(tmp_path.iterdir())


def test_the_command(run, refused, tmp_path):
    small = ("--fps", 5, "--size", 80)
    status, out, _ = run("animate", "--k", 6, "--group", "B", *small, "--out", tmp_path / "b.gif")
    assert (status, out) == (0, f"{tmp_path}/b.gif\n")
    nothing = ("animate", "--model", "rimless_wheel", "--slope", 0.05)  # it does not get over the top
    assert run(*nothing, "--out", tmp_path / "n.gif") == (1, "", "no limit cycle found\n")
    assert not (tmp_path / "n.gif").exists()
    refused(["animate", "--k", 6, "--out", tmp_path / "b.mp4"], "b.mp4 does not end in .gif")
    (tmp_path / "file").write_text("")
    status, _, err = run("animate", "--k", 6, *small, "--out", tmp_path / "file" / "b.gif")
    assert status == 2
    assert "cannot write" in err
