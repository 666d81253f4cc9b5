import inspect
import json
import math
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from spline_strategies import curves, defining_points

from theditor.spline import Curve, Kind, Mode, known, missing, recognise, recognise_segments

DATA = Path(__file__).parents[1] / "data"
KNOWN_CURVES = json.loads((DATA / "known_curves.json").read_text())
FIGURES = json.loads((DATA / "figures.json").read_text())
T = np.linspace(0, 1, 17)

places = st.tuples(st.floats(-5, 5), st.floats(-5, 5))
sizes = st.floats(0.2, 5)
angles = st.floats(-4, 4)
reaches = st.floats(-3, 3)
quarters = st.integers(1, 6)
units = st.integers(1, 3)
degrees = st.sampled_from([2, 3])

MAKERS = {
    Kind.CIRCLE: lambda centre, radius, start: known.ellipse(centre, (radius, radius), 0, start, 1),
    Kind.ELLIPSE: known.ellipse,
    Kind.HYPERBOLA: known.hyperbola,
    Kind.SINE: known.sine,
    Kind.CYCLOID: known.cycloid,
    Kind.PROLATE: known.trochoid,
    Kind.CURTATE: known.trochoid,
    Kind.CATENARY: known.catenary,
    Kind.EXPONENTIAL: known.exponential,
}


@st.composite
def named_curves(draw):
    """A plane curve of each kind, at any place and size, with the kind it must be recognised as."""
    kind = draw(st.sampled_from(list(MAKERS)))
    place, rotation = draw(places), draw(angles)
    match kind:
        case Kind.CIRCLE:
            radius, turn = draw(sizes), draw(angles)
            return kind, known.ellipse(place, (radius, radius), rotation, turn, draw(quarters), draw(degrees))
        case Kind.ELLIPSE:
            axes = draw(st.tuples(sizes, sizes))
            assume(abs(axes[0] - axes[1]) > 1e-3)
            return kind, known.ellipse(place, axes, rotation, draw(angles), draw(quarters), draw(degrees))
        case Kind.HYPERBOLA:
            axes = draw(st.tuples(sizes, sizes))
            return kind, known.hyperbola(place, axes, rotation, draw(reaches), draw(units), draw(degrees))
        case Kind.SINE:
            size = draw(sizes) * draw(st.sampled_from([-1, 1]))
            return kind, known.sine(place, size, draw(sizes), rotation, draw(angles), draw(quarters))
        case Kind.CYCLOID:
            return kind, known.cycloid(place, draw(sizes), rotation, draw(angles), draw(quarters))
        case Kind.PROLATE | Kind.CURTATE:
            radius, ratio = draw(sizes), draw(st.floats(1.01, 3))
            arm = radius * ratio if kind is Kind.PROLATE else radius / ratio
            return kind, known.trochoid(place, radius, arm, rotation, draw(angles), draw(quarters))
        case Kind.CATENARY:
            size = draw(sizes) * draw(st.sampled_from([-1, 1]))
            return kind, known.catenary(place, size, rotation, draw(reaches), draw(units))
        case _:
            size, length = (draw(sizes) * draw(st.sampled_from([-1, 1])) for _ in range(2))
            return kind, known.exponential(place, size, length, rotation, draw(reaches), draw(units))


def rebuilt(found):
    """The curve, one segment long, that the parameters of a recognised segment describe."""
    make, parameters = MAKERS[found.kind], dict(found.parameters)
    backwards = parameters["end"] < parameters["start"]
    parameters["start"] = min(parameters["start"], parameters["end"])
    accepted = inspect.signature(make).parameters
    chosen = {key: value for key, value in parameters.items() if key in accepted}
    chosen |= {key: 1 for key in ("quarters", "units") if key in accepted}
    curve = make(**chosen)
    return curve.reversed() if backwards else curve


@given(named_curves(), st.booleans())
def test_every_segment_of_a_known_curve_is_recognised_with_what_it_takes_to_make_it(named, backwards):
    kind, curve = named
    if backwards:
        curve = curve.reversed()
    for s, found in enumerate(recognise_segments(curve)):
        assert found.kind is kind
        if curve.lambdas[0] == 0:
            assert -1e-6 <= min(found.parameters["start"], found.parameters["end"]) < math.tau
        limit = 1e-7 * np.abs(curve.control_points).max()
        np.testing.assert_allclose(rebuilt(found)(T), curve(s + T), rtol=0, atol=limit)
        assert found == recognise(curve, s)
        assert missing(curve, s) is None


@given(named_curves(), st.integers(0, 10**6))
def test_a_plane_curve_in_space_is_what_it_is_in_the_plane(named, seed):
    kind, curve = named
    turn, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    lifted = Curve(curve.control_points @ turn[:2] + (1, 2, 3), curve.lambdas, curve.degree, curve.closed)
    found, flat = recognise(lifted, 0), recognise(curve, 0)
    assert found.kind is kind
    if kind is Kind.EXPONENTIAL:  # the same with either sign, seen from above or below
        assert abs(found.parameters["length"]) == pytest.approx(abs(flat.parameters["length"]))
        return
    for key, value in flat.parameters.items():
        if key in ("radius", "arm", "amplitude", "wavelength", "parameter"):
            assert found.parameters[key] == pytest.approx(value)
        elif key == "semi_axes":
            assert sorted(found.parameters[key]) == pytest.approx(sorted(value))
        elif key in ("centre", "vertex"):
            assert found.parameters[key] == pytest.approx(value @ turn[:2] + (1, 2, 3), abs=1e-6)
    assert abs(np.dot(found.parameters["normal"], turn[2])) == pytest.approx(1)


AFFINE = {
    Kind.CIRCLE: Kind.ELLIPSE,
    Kind.ELLIPSE: Kind.ELLIPSE,
    Kind.HYPERBOLA: Kind.HYPERBOLA,
    Kind.SINE: Kind.AFFINE_SINE,
    Kind.CYCLOID: Kind.AFFINE_CYCLOID,
    Kind.PROLATE: Kind.TRIGONOMETRIC,
    Kind.CURTATE: Kind.TRIGONOMETRIC,
    Kind.CATENARY: Kind.AFFINE_CATENARY,
    Kind.EXPONENTIAL: Kind.AFFINE_EXPONENTIAL,
}


@given(named_curves(), st.floats(0.3, 1.5), st.floats(0, math.pi))
def test_an_affine_image_is_recognised_as_one(named, shear, angle):
    kind, curve = named
    assume(kind not in (Kind.ELLIPSE, Kind.HYPERBOLA) or curve.degree == 3)
    c, s = math.cos(angle), math.sin(angle)
    turn = np.array([(c, -s), (s, c)])
    oblique = turn @ [(1, shear), (0, 1)] @ turn.T
    if kind in (Kind.SINE, Kind.CATENARY, Kind.EXPONENTIAL):  # not along an axis, where it stays what it is
        axis = recognise(curve, 0).parameters["rotation"]
        assume(min(abs(math.sin(axis - angle)), abs(math.cos(axis - angle))) > 0.01)
    image = curve.with_(control_points=curve.control_points @ oblique.T)
    found, original = recognise(image, 0), recognise(curve, 0)
    assume(kind is not Kind.ELLIPSE or found.kind is not Kind.CIRCLE)
    assert found.kind is AFFINE[kind]
    if found.kind is Kind.TRIGONOMETRIC:
        ratio = original.parameters["arm"] / original.parameters["radius"]
        assert found.parameters["arm_to_radius"] == pytest.approx(ratio, rel=1e-6)


def test_a_helix_is_recognised_and_its_affine_image_too():
    curve = known.helix((1, 2, 3), 2.0, -5.0, 0.3, 7)
    turn, _ = np.linalg.qr(np.arange(9.0).reshape(3, 3) ** 2 + np.eye(3))
    turn *= np.linalg.det(turn)  # a mirror image would be right-handed
    for found in recognise_segments(curve.with_(control_points=curve.control_points @ turn.T)):
        assert found.kind is Kind.HELIX
        assert (found.parameters["radius"], found.parameters["pitch"]) == pytest.approx((2, -5))
        assert found.parameters["axis"] == pytest.approx(-turn[:, 2])
        foot = np.array(found.parameters["centre"]) - turn @ (1, 2, 3)
        assert np.cross(foot, turn[:, 2]) == pytest.approx(np.zeros(3), abs=1e-12)
    image = curve.with_(control_points=curve.control_points * (1, 1.1, 1))
    assert {found.kind for found in recognise_segments(image)} == {Kind.AFFINE_HELIX}


# What is not quite a known curve


@pytest.mark.parametrize(
    "curve",
    [
        known.ellipse(degree=3, quarters=1),
        known.ellipse(semi_axes=(1, 1), quarters=1),
        known.ellipse(semi_axes=(1, 1), quarters=1, degree=2),
        known.hyperbola(units=1),
        known.sine(quarters=1, start=0.4),
        known.cycloid(quarters=1, start=1),
        known.trochoid(quarters=1),
        known.catenary(units=1),
        known.exponential(units=1, start=0),
        known.helix(quarters=1),
    ],
    ids=lambda curve: recognise(curve, 0).name + f" {curve.degree}",
)
def test_near_misses_are_refused(curve):
    kind = recognise(curve, 0).kind
    size = np.ptp(curve.control_points, axis=0).max()
    step = 1e-6 * size * np.array([0.8, 0.6, 0.5])[: curve.dimension]
    for i, point in enumerate(curve.control_points):
        assert recognise(curve.with_points(i, point + step), 0).kind is not kind
        rounding = 1e-12 * step / np.abs(step).max() * size
        assert recognise(curve.with_points(i, point + rounding), 0).kind is kind
    (first, last) = curve.lambda_indices(0)
    for changed in ([first], [last], [first, last]):
        near = curve.with_lambdas(changed, curve.lambdas[0] + 1e-6)
        assert recognise(near, 0) is None
        repair = missing(near, 0)
        assert repair.changes == tuple((i, curve.lambdas[0]) for i in changed)
        assert repair.recognised.kind is kind
        assert recognise(near.with_lambdas(*zip(*repair.changes, strict=True)), 0) == repair.recognised


SLIGHT = 1e-6
STRETCH, SHEAR = np.diag([1, 1 + SLIGHT]), np.array([(1, SLIGHT), (0, 1)])


@pytest.mark.parametrize(
    ("curve", "map_", "kind"),
    [
        (known.ellipse(semi_axes=(2, 2)), STRETCH, Kind.ELLIPSE),
        (known.sine(start=0.4), STRETCH, Kind.SINE),
        (known.sine(start=0.4), SHEAR, Kind.AFFINE_SINE),
        (known.catenary(), STRETCH, Kind.AFFINE_CATENARY),
        (known.catenary(), SHEAR, Kind.AFFINE_CATENARY),
        (known.exponential(start=0), STRETCH, Kind.EXPONENTIAL),
        (known.exponential(start=0), SHEAR, Kind.AFFINE_EXPONENTIAL),
        (known.cycloid(), STRETCH, Kind.AFFINE_CYCLOID),
        (known.trochoid(arm=1 + SLIGHT), np.eye(2), Kind.PROLATE),
        (known.trochoid(arm=1 - SLIGHT), np.eye(2), Kind.CURTATE),
        (known.trochoid(arm=1 - SLIGHT), np.array([(1, 0.5), (0, 1)]), Kind.TRIGONOMETRIC),
        (known.helix(), np.diag([1, 1 + SLIGHT, 1]), Kind.AFFINE_HELIX),
        (known.helix(), np.array([(1, 0, SLIGHT), (0, 1, 0), (0, 0, 1)]), Kind.AFFINE_HELIX),
    ],
)
def test_the_slightest_stretch_or_shear_counts(curve, map_, kind):
    image = curve.with_(control_points=curve.control_points @ map_.T)
    assert {found.kind for found in recognise_segments(image)} == {kind}


def test_what_is_missing_is_said_in_a_sentence():
    curve = Curve(FIGURES["figure 10"]["control_points"], FIGURES["figure 10"]["lambda"])
    one = missing(curve.with_lambdas(6, 0.97), 5)
    assert one.text == "λ₆ = 0.97: set to 1 to make it a hyperbola arc"
    both = missing(curve.with_lambdas([5, 6], [0.97, 1.05]), 4)
    assert both.text == "λ₅ = 0.97 and λ₆ = 1.05: set both to 1 to make it a catenary"
    assert (
        missing(curve.with_lambdas(1, -0.05), 0).text == "λ₁ = −0.05: set to 0 to make it a prolate trochoid"
    )
    assert missing(curve.with_lambdas(11, 0.02), 9).text == "λ₁₁ = 0.02: set to 0 to make it an ellipse arc"
    assert missing(curve.with_lambdas(6, 0.89), 5) is None  # too far off
    assert missing(curve.with_lambdas(7, 0.99), 6) is None  # it would have no name of its own
    assert missing(curve, 1) is None
    assert missing(Curve([(0, 0), (1, 1), (2, 2), (5, 5)], 0.97), 0) is None  # a line already


def test_a_clamped_end_goes_by_its_one_active_lambda():
    curve = Curve([(0, 0), (1, 2), (3, 1), (4, 4)], [0.5, 0.98, 3.0, 0.0], ends="clamped")
    assert recognise(curve, 0) is None
    hyperbolic = curve.with_mode(0, Mode.HYPERBOLIC)
    assert recognise(hyperbolic, 0).kind is Kind.HYPERBOLIC
    quadratic = Curve([(0, 1), (2, 0), (1, -3)], [0.5, 0.02, 0.0], 2, ends="clamped")
    assert missing(quadratic, 0).changes == ((1, 0.0),)
    found = recognise(quadratic.with_mode(0, Mode.TRIGONOMETRIC), 0)
    centre = (np.array((0, 1)) * 2 - (2, 0) + np.array((1, -3)) * 2 - (2, 0)) / 2
    assert found.parameters["centre"] == pytest.approx(centre)


# Lines and points, of any mode


@given(curves(degrees=(2, 3)), st.sampled_from([0.0, 1.0, 0.3, 7.0]), st.data())
def test_collinear_points_make_a_line_segment_of_all_that_is_run_through(curve, lam, data):
    steps = data.draw(st.lists(st.integers(-6, 6), min_size=9, max_size=9))[: len(curve.control_points)]
    direction = np.array([3.0, -4.0, 12.0])[: curve.dimension]
    straight = curve.with_(control_points=1.0 + np.outer(steps, direction), lambdas=lam)
    for s, found in enumerate(recognise_segments(straight)):
        points = straight(s + np.linspace(0, 1, 201))
        if len(np.unique(defining_points(straight)[s], axis=0)) == 1:
            assert found.kind is Kind.POINT
            assert found.parameters["position"] == pytest.approx(points[0])
            continue
        assert found.kind is Kind.LINE
        start, end = (np.array(found.parameters[key]) for key in ("start", "end"))
        lowest, highest = np.minimum(start, end), np.maximum(start, end)
        assert points.min(axis=0) == pytest.approx(lowest, abs=2e-2)
        assert points.max(axis=0) == pytest.approx(highest, abs=2e-2)
        assert (points >= lowest - 1e-9).all()
        assert (points <= highest + 1e-9).all()


@given(curves(low=0, high=1))
def test_segments_of_other_modes_have_no_name_unless_straight_and_all_others_have_one(curve):
    for s, found in enumerate(recognise_segments(curve)):
        if curve.modes[s] in (Mode.TRIGONOMETRIC, Mode.HYPERBOLIC):
            assert found is not None
            assert found.description.startswith(found.name)
        elif found is not None:
            edges = np.diff(defining_points(curve)[s], axis=0)
            assert np.linalg.matrix_rank(edges, tol=1e-6 * np.abs(edges).max()) < 2


# Words


def evaluated(equation: str) -> np.ndarray:
    """The right side of an equation as printed, at all T."""
    text = equation.split(" = ")[1].split(", t ∈")[0].replace("−", "-")
    for old, new in (
        ("eᵗ", "exp(t)"),
        ("e⁻ᵗ", "exp(-t)"),
        ("πt/2", "pi*t/2"),
        ("cosh t", "cosh(t)"),
        ("sinh t", "sinh(t)"),
    ):
        text = text.replace(old, new)
    text = re.sub(r"(\d)\s?([a-z])(?!-|\+|\d)", r"\1*\2", text)
    names = {name: getattr(np, name) for name in ("sin", "cos", "sinh", "cosh", "exp", "pi")}
    return np.stack(np.broadcast_arrays(*eval(text, names | {"t": T})), axis=-1)


@given(
    named_curves() | st.tuples(st.none(), curves(low=0, high=0)) | st.tuples(st.none(), curves(low=1, high=1))
)
def test_the_equation_as_printed_is_that_of_the_segment(named):
    _, curve = named
    found = recognise(curve, 0)
    assume(found.kind not in (Kind.LINE, Kind.POINT))
    limit = 1e-4 * max(np.abs(found.coefficients).max(), 1e-12)
    np.testing.assert_allclose(evaluated(found.equation), curve(T), rtol=0, atol=limit)


def test_descriptions_and_equations_read_well():
    arc = recognise(known.ellipse((1, 2), (3, 1.5)), 0)
    assert arc.description == "ellipse arc, centre (1, 2), semi-axes 3 and 1.5, 0°–90°"
    assert arc.equation == "(x, y) = (1 + 3 cos(πt/2), 2 + 1.5 sin(πt/2)), t ∈ [0, 1]"
    turned = recognise(known.ellipse((-1, 0), (3, 1), math.pi / 6, quarters=1, degree=2).reversed(), 0)
    assert turned.description == "ellipse arc, centre (−1, 0), semi-axes 3 and 1, turned by 30°, 90°–0°"
    line = recognise(Curve([(1, 1), (4, -3)], ends="clamped"), 0)
    assert line.description == "line segment from (1, 1) to (4, −3)"
    assert line.equation == "(x, y) = (1 + 3s, 1 − 4s), s ∈ [0, 1]"
    point = recognise(Curve([(1, -1)] * 4, 0.5), 0)
    assert (point.description, point.equation) == ("point (1, −1)", "(x, y) = (1, −1)")
    helix = recognise(known.helix(pitch=-2), 0)
    assert helix.description == (
        "helix, radius 1, pitch 2, left-handed, axis through (0, 0, 0) along (0, 0, −1)"
    )
    falling = recognise(known.exponential(length=-1, start=0), 0)
    assert falling.equation == "(x, y) = (−t, eᵗ), t ∈ [0, 1]"


# Reference data


@pytest.mark.parametrize("name", KNOWN_CURVES)
def test_the_reference_curves_are_recognised(name):
    entry = KNOWN_CURVES[name]
    curve = Curve(entry["control_points"], entry["lambda"], entry["degree"], entry["closed"])
    for found in recognise_segments(curve):
        word = next(
            w
            for w in (
                "ellipse",
                "hyperbola",
                "catenary",
                "exponential",
                "trochoid",
                "cycloid",
                "sine",
                "helix",
            )
            if w in name
        )
        assert word in found.name
        assert found.kind.has_own_name


def test_figure_9_segment_by_segment():
    entry = FIGURES["figure 9"]
    curve = Curve(entry["control_points"], entry["lambda"], 2, closed=True)
    names = [found and found.name for found in recognise_segments(curve)]
    assert names == [None, "ellipse arc", None, "hyperbola arc", None, None]
    assert recognise(curve, 1).parameters["semi_axes"] == pytest.approx((3, math.tanh(0.5)))
    axis = (2 * math.cosh(1) - 1) / (2 * math.cosh(1) - 2)
    assert recognise(curve, 3).parameters["semi_axes"] == pytest.approx((axis, 1))
    assert recognise(curve, 3).parameters["centre"] == pytest.approx((3 + axis, 0))


def test_figure_10_segment_by_segment():
    curve = Curve(FIGURES["figure 10"]["control_points"], FIGURES["figure 10"]["lambda"])
    found = {number: recognise(curve, number - 1) for number in range(1, 11)}
    assert {number: segment.name for number, segment in found.items() if segment} == {
        1: "trochoid, prolate",
        5: "catenary",
        6: "hyperbola arc",
        7: "general hyperbolic arc",
        10: "ellipse arc",
    }
    assert (found[1].parameters["radius"], found[1].parameters["arm"]) == pytest.approx((2 / math.pi, 1))
    assert found[5].equation == "(x, y) = (1 − t, 1 + cosh(1 − t)), t ∈ [0, 1]"
    assert found[5].description == "catenary, parameter 1, vertex (0, 2), from τ = 1 to 0"
    assert found[6].parameters["centre"] == pytest.approx((0, 1))
    assert found[10].parameters["semi_axes"] == pytest.approx((1, 0.5))
    assert found[10].description == "ellipse arc, centre (−2, 0), semi-axes 1 and 0.5, 270°–360°"
