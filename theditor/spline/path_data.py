"""Outlines as the path data of SVG: `M`, `L`, `A`, `C`, `Z`, with digits that read back as the same numbers."""

from typing import TYPE_CHECKING

import numpy as np

from theditor.spline.basis import Floats
from theditor.spline.convert import Outline, Piece, outline
from theditor.spline.geometry import bounds
from theditor.spline.projection import projected

if TYPE_CHECKING:
    from theditor.spline.curve import Curve

_ROUND = 1e-14  # relative difference of axes that are equal
_LEVEL = 1e-13  # degrees of a turn that is none


def path_data(pieces: Outline) -> str:
    """Return an outline in the plane as the `d` of an SVG path; it is for the caller to turn y upward.

    Elliptical arcs are given by one `A` for each quarter, which leaves no doubt about their centre.

    Raises
    ------
    ValueError
        If the outline has rational quadratics, which SVG does not know, or lies in space.
    """
    if (pieces.kinds == Piece.CONIC).any() or pieces.ends.shape[1] != 2:
        raise ValueError("path data needs a plane outline without rational quadratics")
    kinds = pieces.kinds.tolist()
    ends = pieces.ends.tolist()
    handles = pieces.inner.reshape(-1, 4).tolist()
    arcs = iter(_ellipses(pieces).tolist())
    words = [f"M{ends[0][0]!r},{ends[0][1]!r}"]
    for kind, (x, y), (a, b, c, d) in zip(kinds, ends[1:], handles, strict=True):
        if kind == Piece.CUBIC:
            words.append(f"C{a!r},{b!r} {c!r},{d!r} {x!r},{y!r}")
        elif kind == Piece.LINE:
            words.append(f"L{x!r},{y!r}")
        else:
            rx, ry, turned, sweep = next(arcs)
            words.append(f"A{rx!r},{ry!r} {turned!r} 0 {sweep:.0f} {x!r},{y!r}")
    if pieces.closed:
        words.append("Z")
    return "".join(words)


def picture(curve: "Curve") -> str:
    """Return a plain SVG picture of a curve, y upward, a space curve seen from above; for notebooks."""
    flat = projected(curve)
    low, high = bounds(flat)
    size = float((high - low).max()) or 1.0
    # Drawn at a size of 100, since viewers calculate in single precision.
    middle, scale = (low + high) / 2, 100 / size
    d = path_data(outline(flat).scaled((scale, -scale), middle * (-scale, scale)))
    width, height = ((high - low) * scale + 8).tolist()
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{4 * width:.0f}" height="{4 * height:.0f}" '
        f'viewBox="{-width / 2!r} {-height / 2!r} {width!r} {height!r}">'
        f'<path d="{d}" fill="none" stroke="currentColor" stroke-width="0.5"/></svg>'
    )


def _ellipses(pieces: Outline) -> Floats:
    """Return of each arc its radii, the x-axis' turn in degrees, and 1 if angles increase along it, (k, 4)."""
    arcs = np.flatnonzero(pieces.kinds == Piece.ARC)
    centre = pieces.inner[arcs, 0]
    x1, y1 = (pieces.ends[arcs] - centre).T
    x2, y2 = (pieces.ends[arcs + 1] - centre).T
    # The conjugate radii at the angle where they are at right angles are the axes.
    angle = np.arctan2(2 * (x1 * x2 + y1 * y2), x1**2 + y1**2 - x2**2 - y2**2) / 2
    cosine, sine = np.cos(angle), np.sin(angle)
    x, y = x1 * cosine + x2 * sine, y1 * cosine + y2 * sine
    major, minor = np.hypot(x, y), np.hypot(x2 * cosine - x1 * sine, y2 * cosine - y1 * sine)
    circular = major - minor <= _ROUND * major
    turned = np.remainder(np.degrees(np.arctan2(y, x)) + 90, 180) - 90
    turned[circular | (np.abs(turned) < _LEVEL)] = 0
    return np.stack((major, np.where(circular, major, minor), turned, x1 * y2 > x2 * y1), axis=1)
