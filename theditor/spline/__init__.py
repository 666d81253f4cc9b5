"""TH-type uniform B-splines: curves that are trigonometric, hyperbolic or interpolating segment by segment."""

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

__all__ = [
    "CONVEX_HULL_RANGE",
    "INTERPOLATING",
    "JOINT_SLOPE_ZERO",
    "MAX_COORDINATE",
    "MAX_LAMBDA",
    "Curve",
    "Ends",
    "Mode",
    "basis",
    "fewest_points",
    "lambda_of",
    "mode_of",
]
