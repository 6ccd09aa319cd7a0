"""Symbols and units as they are written, in plain text and in LaTeX."""

import pytest

import stridemap
from stridemap.solver.model.loading import available
from stridemap.spec import UnitNames
from stridemap.units import KINDS
from stridemap.views.notation import (
    latex_axis,
    latex_symbol,
    latex_unit,
    rate_symbol,
    state_labels,
    symbol,
    unit_of,
    units,
)

SCALED, SI, CGS = UnitNames(), UnitNames("kg", "m", "s", "J"), UnitNames("g", "cm", "s", "erg")


@pytest.mark.parametrize(
    ("name", "shown"),
    [("theta1", "θ₁"), ("alpha", "α"), ("k", "k"), ("Kp", "Kp"), ("x2", "x₂"), ("leg_1", "leg_1")],
)
def test_symbols(name, shown):
    assert symbol(name) == shown


def test_symbols_of_rates():
    assert [rate_symbol(name) for name in ("theta1", "x", "leg")] == ["θ\u0307₁", "x\u0307", "dleg"]


@pytest.mark.parametrize(
    ("name", "plain", "rate"),
    [
        ("theta1", r"\theta_{1}", r"\dot{\theta}_{1}"),
        ("x", "x", r"\dot{x}"),
        ("leg_1", r"\mathrm{leg\_1}", None),
    ],
)
def test_symbols_in_latex(name, plain, rate):
    assert latex_symbol(name) == plain
    assert rate is None or latex_symbol(name, rate=True) == rate


def test_units_of_each_kind():
    assert {kind: unit_of(kind, SCALED) for kind in KINDS} == {
        kind: unit for kind, (unit, _) in KINDS.items()
    }
    assert {kind: unit_of(kind, SI) for kind in KINDS} == {kind: si for kind, (_, si) in KINDS.items()}
    assert (units(SCALED)["number"], units(SCALED)["speed"]) == ("", "√(g L)")
    assert unit_of("force", UnitNames("m", "L", "sqrt(L/g)", "m g L")) == "m g"
    composed = {"length": "cm", "energy": "erg", "speed": "cm s^-1", "force": "g cm s^-2", "number": "1"}
    assert {kind: unit_of(kind, CGS) for kind in composed} == composed
    assert unit_of("angle", CGS) == "rad"


@pytest.mark.parametrize(
    ("unit", "names", "text"),
    [
        ("1", SCALED, "–"),
        ("M g / L", SCALED, r"$M\,g/L$"),
        ("rad sqrt(g/L)", SCALED, r"$\mathrm{rad}\,\sqrt{g/L}$"),
        ("M L^2", SCALED, r"$M\,L^2$"),
        ("kg m^2", SI, r"$\mathrm{kg}\,\mathrm{m}^2$"),
        ("g cm s^-2", CGS, r"$\mathrm{g}\,\mathrm{cm}\,\mathrm{s}^{-2}$"),
    ],
)
def test_units_in_latex(unit, names, text):
    assert latex_unit(unit, names) == text
    assert latex_axis("label", unit, names) == f"label  [{text}]"


@pytest.mark.parametrize("model", available())
def test_labels_of_every_model_can_be_typeset(model):
    mathtext = pytest.importorskip("matplotlib.mathtext")
    spec = stridemap.load(model).spec
    labels = state_labels(spec)
    assert list(labels) == [e.name for e in (*spec.entries("q"), *spec.entries("v"))]
    parser = mathtext.MathTextParser("path")
    texts = [text for pair in labels.values() for text in pair]
    texts += [latex_axis("x", p.unit, spec.units) for p in spec.parameters]
    texts += [latex_axis("x", unit_of(kind, spec.units), spec.units) for kind in KINDS]
    for text in texts:
        parser.parse(text)
