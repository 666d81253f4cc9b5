"""The pointer's shape, which tells what a press would do."""

from __future__ import annotations

from PySide6.QtCore import Qt

from theditor.canvas.hit_test import BoxHit, Hit, JointHit, MiddleHit, PointHit, SegmentHit

_Shape = Qt.CursorShape


def cursor_over(hit: Hit) -> Qt.CursorShape:
    """The pointer's shape over what would be grabbed."""
    match hit:
        case BoxHit("turn"):
            return _Shape.PointingHandCursor
        case BoxHit(_, 0, _):
            return _Shape.SizeVerCursor
        case BoxHit(_, _, 0):
            return _Shape.SizeHorCursor
        case BoxHit(_, x, y):
            return _Shape.SizeBDiagCursor if x == y else _Shape.SizeFDiagCursor
        case PointHit():
            return _Shape.SizeAllCursor
        case JointHit() | MiddleHit():
            return _Shape.CrossCursor
        case SegmentHit():
            return _Shape.PointingHandCursor
        case _:
            return _Shape.ArrowCursor
