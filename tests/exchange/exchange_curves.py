"""Curves to write in foreign formats, and how to compare with what comes out."""

import numpy as np

from theditor.spline import INTERPOLATING, Curve

ELLIPSE = Curve([[-3, 1], [3, 1], [3, -1], [-3, -1]], 0.0, 2, closed=True)
TURNED = Curve(np.array([[-3, 1], [2, 2], [3, -1], [-2, -2]]) + 40, 0.0, 2)
BLEND = Curve(
    [[0, 0], [1, 2], [3, 2], [4, 0], [6, 1], [7, 4]], [0, 0.5, 1, 1, INTERPOLATING[3], -3], ends="clamped"
)
STRAIGHT = Curve([[0, 0], [5, 5], [2, 2], [3, 3]], 3.0, ends="clamped")
HYPERBOLA = Curve([[0, 0], [1, 2], [3, 2], [4, -1]], 1.0, 2)
SPACE = Curve([[0, 0, 1], [1, 2, 0], [3, 2, 2], [4, 0, 5]], 0.3)
CLOSED = Curve([[0, 0], [4, 1], [5, 5], [1, 3]], [0, 1, 0.5, 9], closed=True)
CURVES = {
    "ellipse": ELLIPSE,
    "turned": TURNED,
    "blend": BLEND,
    "straight": STRAIGHT,
    "hyperbola": HYPERBOLA,
    "space": SPACE,
    "closed": CLOSED,
}


def size_of(curve: Curve) -> float:
    return float(np.ptp(curve.sample(8), axis=0).max())


def gap(a: np.ndarray, b: np.ndarray) -> float:
    """The largest distance of the points a from the chain of chords b."""
    start, step = b[:-1], np.diff(b, axis=0)
    length = np.maximum((step**2).sum(axis=1), 1e-300)
    away = a[:, None] - start
    t = np.clip((away * step).sum(axis=2) / length, 0, 1)
    return float(np.linalg.norm(away - t[..., None] * step, axis=2).min(axis=1).max())
