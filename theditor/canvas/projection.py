"""How a space curve is seen and edited in the plane: from above. The only place that knows of two coordinates.

Curves are affinely invariant: the picture of a curve is the curve of the pictures of its control points, so the
rest of the canvas works on plane curves alone.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from theditor.spline import projected

__all__ = ["moved", "projected"]

Floats = NDArray[np.float64]


def moved(points: Floats, offset: Floats) -> Floats:
    """Points (n, d) moved by an offset (2,) in the plane of the canvas; other coordinates are kept."""
    result = points.copy()
    result[:, :2] += offset
    return result
