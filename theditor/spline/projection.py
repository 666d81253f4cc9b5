"""Space curves as seen from above."""

import numpy as np

from theditor.spline.curve import Curve


def projected(curve: Curve) -> Curve:
    """Return the curve without its z; a plane curve as it is.

    Curves are affinely invariant: the picture of a curve is the curve of the pictures of its control points.
    """
    if curve.dimension == 2:
        return curve
    return curve.with_(control_points=np.ascontiguousarray(curve.control_points[:, :2]))
