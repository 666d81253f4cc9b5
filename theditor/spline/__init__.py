"""TH-type uniform B-splines: one curve, trigonometric, hyperbolic or interpolating by segments."""

from theditor.spline.basis import (
    CONVEX_HULL_RANGE,
    INTERPOLATING,
    JOINT_SLOPE_ZERO,
    Mode,
    basis,
    lambda_of,
    mode_of,
)
from theditor.spline.checks import MAX_COORDINATE, MAX_LAMBDA, fewest_points
from theditor.spline.curve import Curve, Ends
from theditor.spline.sampling import (
    Samples,
    changed_segments,
    evaluate_segments,
    intervals_for,
    sample_adaptively,
    segment_bounds,
)
from theditor.spline.shape import PULL_BOUNDS, Pulled, pull, pull_points

__all__ = [
    "CONVEX_HULL_RANGE",
    "INTERPOLATING",
    "JOINT_SLOPE_ZERO",
    "MAX_COORDINATE",
    "MAX_LAMBDA",
    "PULL_BOUNDS",
    "Curve",
    "Ends",
    "Mode",
    "Pulled",
    "Samples",
    "basis",
    "changed_segments",
    "evaluate_segments",
    "fewest_points",
    "intervals_for",
    "lambda_of",
    "mode_of",
    "pull",
    "pull_points",
    "sample_adaptively",
    "segment_bounds",
]
