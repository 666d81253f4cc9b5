"""TH-type uniform B-splines: one curve, trigonometric, hyperbolic or interpolating by segments."""

from theditor.spline import formula, known
from theditor.spline.basis import (
    CONVEX_HULL_RANGE,
    INTERPOLATING,
    JOINT_SLOPE_ZERO,
    Mode,
    basis,
    lambda_of,
    mode_of,
)
from theditor.spline.catalogue import KNOWN, Known, Parameter
from theditor.spline.changed import changed_segments
from theditor.spline.checks import MAX_COORDINATE, MAX_LAMBDA, fewest_points
from theditor.spline.continuity import Continuity, JointReport, continuity
from theditor.spline.convert import Outline, Piece, outline
from theditor.spline.corners import corner, smooth
from theditor.spline.crossings import intersections, self_intersections
from theditor.spline.curvature import bending_energy, curvature, osculating_circle
from theditor.spline.curve import Curve, Ends
from theditor.spline.degrees import with_degree
from theditor.spline.ends import with_ends
from theditor.spline.fit import Fitted, fit
from theditor.spline.formula import FormulaError
from theditor.spline.geometry import bounds, nearest
from theditor.spline.guards import Guards, ReversedJoint, hull, negative_basis, reversed_joints
from theditor.spline.kinds import Kind
from theditor.spline.lambdas import gradient, shifted, smoothed
from theditor.spline.length import arc_length, arc_lengths, parameter_at
from theditor.spline.path_data import path_data
from theditor.spline.pieces import Split, closed, join, opened, split, with_free_ends
from theditor.spline.points import Edited, insert, insert_many, insert_on_edge, remove
from theditor.spline.projection import projected
from theditor.spline.reach import Reach, Track, joint_track, middle_track, reach
from theditor.spline.recognise import Missing, Recognised, missing, recognise, recognise_segments
from theditor.spline.sampling import (
    Samples,
    evaluate_segments,
    intervals_for,
    sample_adaptively,
    segment_bounds,
)
from theditor.spline.shape import PULL_BOUNDS, Pulled, pull, pull_points
from theditor.spline.uniform import uniform_b_spline_samples, uniform_segments
from theditor.spline.vertices import CurvatureExtremes, Inflections, curvature_extremes, inflections

__all__ = [
    "CONVEX_HULL_RANGE",
    "INTERPOLATING",
    "JOINT_SLOPE_ZERO",
    "KNOWN",
    "MAX_COORDINATE",
    "MAX_LAMBDA",
    "PULL_BOUNDS",
    "Continuity",
    "CurvatureExtremes",
    "Curve",
    "Edited",
    "Ends",
    "Fitted",
    "FormulaError",
    "Guards",
    "Inflections",
    "JointReport",
    "Kind",
    "Known",
    "Missing",
    "Mode",
    "Outline",
    "Parameter",
    "Piece",
    "Pulled",
    "Reach",
    "Recognised",
    "ReversedJoint",
    "Samples",
    "Split",
    "Track",
    "arc_length",
    "arc_lengths",
    "basis",
    "bending_energy",
    "bounds",
    "changed_segments",
    "closed",
    "continuity",
    "corner",
    "curvature",
    "curvature_extremes",
    "evaluate_segments",
    "fewest_points",
    "fit",
    "formula",
    "gradient",
    "hull",
    "inflections",
    "insert",
    "insert_many",
    "insert_on_edge",
    "intersections",
    "intervals_for",
    "join",
    "joint_track",
    "known",
    "lambda_of",
    "middle_track",
    "missing",
    "mode_of",
    "nearest",
    "negative_basis",
    "opened",
    "osculating_circle",
    "outline",
    "parameter_at",
    "path_data",
    "projected",
    "pull",
    "pull_points",
    "reach",
    "recognise",
    "recognise_segments",
    "remove",
    "reversed_joints",
    "sample_adaptively",
    "segment_bounds",
    "self_intersections",
    "shifted",
    "smooth",
    "smoothed",
    "split",
    "uniform_b_spline_samples",
    "uniform_segments",
    "with_degree",
    "with_ends",
    "with_free_ends",
]
