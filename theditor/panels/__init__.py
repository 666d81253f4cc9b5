"""The panels beside the canvas: curves, curve, shape (λ), λ strip, segments, selected segment."""

from theditor.panels.curve import CurvePanel
from theditor.panels.curves import CurvesPanel
from theditor.panels.lambda_strip import LambdaStrip
from theditor.panels.segment_info import SegmentPanel
from theditor.panels.segments import SegmentsPanel
from theditor.panels.shape import ShapePanel

__all__ = ["CurvePanel", "CurvesPanel", "LambdaStrip", "SegmentPanel", "SegmentsPanel", "ShapePanel"]
