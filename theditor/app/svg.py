"""A picture of curves as SVG, in cubic Béziers, for drawing programs to take over."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

import numpy as np
from numpy.typing import NDArray

from theditor.canvas.projection import projected
from theditor.drawing import Item
from theditor.spline import Curve
from theditor.spline.extent import extent

Floats = NDArray[np.float64]

TOLERANCE = 0.01
"""Largest distance in pixels between a curve and its Béziers."""
LARGEST = 10_000
"""Size in pixels of the largest picture."""
_MOST_PIECES = 64  # of a segment


def svg(items: Sequence[Item], scale: float) -> bytes:
    """Draw curves, at `scale` pixels per unit and y upward, each as one path in its own colour and width.

    Pictures larger than `LARGEST` are drawn smaller. The Béziers deviate by at most `TOLERANCE`. Space curves
    are seen from above.
    """
    curves = [projected(item.curve) for item in items]
    every = np.concatenate([curve.control_points for curve in curves])
    low, high = extent(every)
    scale = min(scale, LARGEST / max(float(np.max(high - low)), 1e-300))
    flip, corner = np.array([scale, -scale]), np.array([low[0], high[1]])
    pictures = [curve.with_(control_points=(curve.control_points - corner) * flip) for curve in curves]
    paths = [beziers(picture, TOLERANCE) for picture in pictures]
    margin = max(item.width for item in items)
    every = np.concatenate([path.reshape(-1, 2) for path in paths])
    low, high = extent(every)
    (left, top), (right, bottom) = low - margin, high + margin
    width, height = float(right - left), float(bottom - top)
    drawn = "".join(map(_path, items, paths))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width!r}" height="{height!r}" '
        f'viewBox="{float(left)!r} {float(top)!r} {width!r} {height!r}">\n{drawn}</svg>\n'
    ).encode()


def beziers(curve: Curve, tolerance: float) -> Floats:
    """Return cubic Béziers one after the other, (n, 4, d), that have the curve's points and tangents at their ends.

    A segment is halved until it deviates from the curve by at most `tolerance`, measured at three places of
    every piece, or has been halved six times.
    """
    segments, pieces = np.arange(curve.segment_count, dtype=np.float64), 1
    found = []
    while True:
        starts = (segments[:, None] + np.arange(pieces) / pieces).ravel()
        ends = (segments[:, None] + np.arange(1, pieces + 1) / pieces).ravel()
        first, last = curve(starts), curve(ends)
        arms = curve(starts, nu=1) / (3 * pieces), curve(ends, nu=1) / (3 * pieces)
        cubics = np.stack([first, first + arms[0], last - arms[1], last], axis=1)
        off = np.zeros(len(starts))
        for t in (0.25, 0.5, 0.75):
            weights = np.array([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3])
            apart = np.einsum("k,nkd->nd", weights, cubics) - curve(starts + t * (ends - starts))
            off = np.maximum(off, np.sqrt((apart**2).sum(axis=1)))
        rough = off.reshape(-1, pieces).max(axis=1) > tolerance
        if pieces == _MOST_PIECES:
            rough[:] = False
        good = np.repeat(~rough, pieces)
        found.append((starts[good], cubics[good]))
        if not rough.any():
            break
        segments, pieces = segments[rough], 2 * pieces
    order = np.argsort(np.concatenate([starts for starts, _ in found]))
    result: Floats = np.concatenate([cubics for _, cubics in found])[order]
    return result


def _path(item: Item, cubics: Floats) -> str:
    x, y = cubics[0, 0].tolist()
    numbers = cubics[:, 1:].reshape(-1, 6).tolist()
    bends = "".join(f"C{a!r},{b!r} {c!r},{d!r} {e!r},{f!r}" for a, b, c, d, e, f in numbers)
    end = "Z" if item.curve.closed else ""
    return (
        f'<path d="M{x!r},{y!r}{bends}{end}" fill="none" stroke="{item.color}" stroke-width="{item.width!r}" '
        f'stroke-linecap="round" stroke-linejoin="round"><title>{escape(item.name, quote=False)}</title></path>\n'
    )
