import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from spline_strategies import curves, scale

from theditor.spline import JOINT_SLOPE_ZERO, Curve, basis, continuity, curvature, known
from theditor.spline.certificate import remarkable, summary, table
from theditor.spline.continuity import measured_again

ZIGZAG = [(0, 0), (1, 2), (3, -1), (4, 1), (6, 0)]


@given(curves(low=-1e3, high=1e3))
def test_the_promise_holds_whatever_points_and_lambdas(curve):
    reports = continuity(curve)
    inner = curve.segment_count if curve.closed else curve.segment_count - 1
    assert len(reports) == len(list(reports)) == inner
    for report in reports:
        assert report.promised == curve.degree - 1
        assert report.holds
        assert report.order >= report.promised
        assert max(report.relative_jumps[: curve.degree]) < 1e-12
    np.testing.assert_array_equal(reports.position, curve(reports.joint))


@given(curves())
def test_jumps_are_those_of_the_curve_and_its_curvature(curve):
    reports = continuity(curve)
    at, sides = reports.joint, ("left", "right")
    size = scale(curve) * (1 + np.abs(curve.lambdas).max())
    for nu in range(3):
        jump = curve(at, nu) - curve(at, nu, "left")
        np.testing.assert_allclose(reports.jumps[:, nu], np.linalg.norm(jump, axis=-1), atol=1e-13 * size)
    for side, measured in zip(sides, (reports.curvature_left, reports.curvature_right), strict=True):
        own, speed = curvature(curve, at, side), np.linalg.norm(curve(at, 1, side), axis=-1)
        np.testing.assert_array_equal(np.isnan(measured), np.isnan(own))
        clear = speed > 1e-3 * size
        slack = 1e-12 * size / speed[clear] ** 2
        assert (np.abs(measured - own)[clear] <= slack).all()
    if curve.dimension == 2:
        jump = reports.curvature_right - reports.curvature_left
        np.testing.assert_array_equal(reports.curvature_jump, jump)


@given(curves(low=-5, high=5), st.integers(0, 8), st.booleans())
def test_measuring_again_what_changed_gives_the_whole_report(curve, place, lam):
    place %= len(curve.lambdas)
    new = (
        curve.with_lambdas(place, -3.0) if lam else curve.with_points(place, curve.control_points[place] + 1)
    )
    again, rows = measured_again(continuity(curve), curve, new)
    whole, before = continuity(new), continuity(curve)
    for name in vars(whole):
        np.testing.assert_array_equal(getattr(again, name), getattr(whole, name))
    others = np.setdiff1d(np.arange(len(whole)), rows)
    np.testing.assert_array_equal(whole.relative_jumps[others], before.relative_jumps[others])


@pytest.mark.parametrize("degree", [2, 3])
def test_a_wrong_basis_function_is_found_at_every_joint(degree, monkeypatch):
    # As in a published misprint: one hyperbolic term a little off.
    def wrong(t, start, end, degree, nu):
        values = basis(t, start, end, degree, nu)
        values[..., -1] *= 1 + 1e-6
        return values

    monkeypatch.setattr(sys.modules[continuity.__module__], "basis", wrong)
    for closed in (False, True):
        report = continuity(Curve(ZIGZAG, 0.7, degree, closed))
        assert not report.holds.any()
        assert "fails: the" in str(report[0])


@given(curves(low=-2, high=9), st.floats(0.01, 100))
def test_verdicts_do_not_depend_on_size(curve, factor):
    before = continuity(curve)
    after = continuity(curve.with_(control_points=curve.control_points * factor))
    np.testing.assert_array_equal(before.order, after.order)
    np.testing.assert_allclose(before.relative_jumps, after.relative_jumps, atol=1e-13)


def test_a_quadratic_is_smooth_once_and_says_how_its_curvature_jumps():
    first, second = continuity(Curve(ZIGZAG, 0.5, 2))
    assert (first.order, first.geometric_order) == (1, 1)
    assert first.number == 2
    assert first.curvature_left * first.curvature_right < 0
    assert "Joint 2 at (2, 0.5): C¹ and G¹; the promised C¹ holds; the curvature jumps from" in str(first)
    assert second.curvature_jump == pytest.approx(second.curvature_right - second.curvature_left)


def test_a_cubic_is_smooth_twice():
    for report in continuity(Curve(ZIGZAG, [0, 1, 2, 3, 4], 3)):
        assert (report.order, report.geometric_order) == (2, 2)
        assert str(report).endswith("C² and G²; the promised C² holds.")


def test_an_ellipse_is_smoother_than_a_quadratic_promises():
    for report in continuity(known.ellipse(degree=2)):
        assert (report.order, report.geometric_order, report.promised) == (2, 2, 1)


def test_curvature_may_agree_where_the_second_derivative_does_not():
    # Mirror images of each other in the joint's normal, but for λ: a change of speed alone.
    report = continuity(Curve([(0, 1), (0, 0), (2, 0), (2, 1)], 0.5, 2))[0]
    assert report.order == 1
    assert report.geometric_order == 2
    assert report.curvature_left == pytest.approx(report.curvature_right)


def test_standing_still_is_a_note_and_no_failure():
    for curve, why in (
        (Curve(ZIGZAG, JOINT_SLOPE_ZERO, 2), "because its λ is −2.648…"),
        (
            Curve([(0, 0), (1, 1), (1, 1), (2, 0)], 0.0, 2),
            "because the two control points beside it coincide",
        ),
        (
            Curve([(0, 0), (1, 1), (3, 1), (1, 1), (0, 0)], 0.0, 3),
            "because the control points before and after it coincide",
        ),
        (Curve([(1, 1)] * 5), "coincide"),
    ):
        noted = [report for report in continuity(curve) if report.note]
        assert noted
        for report in noted:
            assert report.holds
            assert report.geometric_order == 0
            assert np.isnan(report.curvature_left)
            assert why in report.note
            assert report.note in str(report)


def test_a_tolerance_below_rounding_is_not_met_and_the_sentence_says_by_how_much():
    generator = np.random.default_rng(5)
    reports = continuity(Curve(generator.normal(size=(200, 2)), generator.uniform(-9, 9, 200)), 0)
    assert not reports.holds.all()
    broken = next(report for report in reports if not report.holds)
    assert "the promised C² fails: the first derivative jumps by" in str(broken)
    assert next(remarkable(reports)).holds is False


def test_a_joint_has_one_number_and_its_report_says_what_a_low_lambda_does_there():
    report = continuity(Curve(ZIGZAG, [0, 0, -5, 0, 0], 2))
    assert "λ₂ = −5 is below −2.648…: the velocity reverses at joint 2" in str(report[0])
    assert report[0].number == 2
    assert [joint.number for joint in remarkable(report)] == [2]
    titles, first, second = table(report)
    assert titles.split()[:2] == ["Joint", "Position"]
    assert first.split()[0] == "2"
    assert first.endswith("✓ C¹, reversed")
    assert second.endswith("✓ C¹")


def test_the_summary_states_the_tolerance():
    assert "as promised within 1e−6 of the size of the terms" in summary(continuity(Curve(ZIGZAG), 1e-6))


def test_numbers_follow_the_points_whose_lambda_it_is():
    assert [report.number for report in continuity(Curve(ZIGZAG, closed=True))] == [0, 1, 2, 3, 4]
    assert [report.number for report in continuity(Curve(ZIGZAG, ends="clamped"))] == [1, 2, 3]
    assert [report.number for report in continuity(Curve(ZIGZAG))] == [2]
    assert len(continuity(Curve(ZIGZAG[:4]))) == 0


def test_a_negative_tolerance_is_refused():
    with pytest.raises(ValueError, match="tolerance must be a number of at least 0"):
        continuity(Curve(ZIGZAG), -1e-9)
