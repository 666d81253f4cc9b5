"""How a space curve is seen and edited in the plane: from above. The only place that knows of two coordinates.

Curves are affinely invariant: the picture of a curve is the curve of the pictures of its control points, so the
rest of the canvas works on plane curves alone.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from theditor.spline import Curve

Floats = NDArray[np.float64]


def projected(curve: Curve) -> Curve:
    """The curve as the canvas shows it; a plane curve is returned as it is."""
    if curve.dimension == 2:
        return curve
    plane = np.ascontiguousarray(curve.control_points[:, :2])
    return Curve(plane, curve.lambdas, degree=curve.degree, closed=curve.closed, ends=curve.ends)


def moved(points: Floats, offset: Floats) -> Floats:
    """Points (n, d) moved by an offset (2,) in the plane of the canvas; other coordinates are kept."""
    result = points.copy()
    result[:, :2] += offset
    return result
