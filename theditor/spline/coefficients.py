"""The equations of segments: c0 + c1 t + c2 cos(πt/2) + c3 sin(πt/2), or with cosh t and sinh t."""

from typing import Final

import numpy as np

from theditor.spline.basis import Floats, Mode
from theditor.spline.joints import Segments

_K = float(np.e / (np.e - 1) ** 2)  # h(t) = _K (cosh t − 1)
_C, _S = float(np.cosh(1.0)), float(np.sinh(1.0))

_FROM_JOINT_FORM: Final[dict[tuple[Mode, int], Floats]] = {
    # c0 … c3 by rows, from the straight part's start and end and the bends at start and end
    (Mode.TRIGONOMETRIC, 2): np.array(
        [[1, 0, -0.5, 0.5], [0, 0, 0, 0], [0, 0, 0, -0.5], [0, 0, 0.5, 0]],
    ),
    (Mode.TRIGONOMETRIC, 3): np.array(
        [[1, 0, 0.5, 0], [-1, 1, -0.5, 0.5], [0, 0, -1 / np.pi, 0], [0, 0, 0, -1 / np.pi]],
    ),
    (Mode.HYPERBOLIC, 2): np.array(
        [[1, 0, _K, -_K], [0, 0, 0, 0], [0, 0, -_K * _C, _K], [0, 0, _K * _S, 0]],
    ),
    (Mode.HYPERBOLIC, 3): np.array(
        [[1, 0, -_K, 0], [-1, 1, _K, -_K], [0, 0, _K * _S, 0], [0, 0, -_K * _C, _K]],
    ),
}


def coefficients(segments: Segments, degree: int, mode: Mode) -> Floats:
    """Return c0 … c3 of each segment, (4, d, k), as if both its λ were those of the mode.

    Exact but for rounding, relative to the coordinates for c0 and to the polygon's size for the others.

    Parameters
    ----------
    segments : Segments
    degree : {2, 3}
    mode : {Mode.TRIGONOMETRIC, Mode.HYPERBOLIC}
        The other modes have no such equation (KeyError).
    """
    form = np.stack(segments[:4])
    return np.tensordot(_FROM_JOINT_FORM[mode, degree], form, axes=1)


def tolerances(segments: Segments) -> Floats:
    """Return by how much coefficients may miss those of a named curve, (k,).

    That is 1e-9 of the polygon's size (its longest edge or bend) plus the rounding of coordinates far from
    the origin, but never more than 1e-7 of the size.
    """
    parts = np.stack((segments.end - segments.start, segments.bend_start, segments.bend_end))
    size = np.sqrt(np.einsum("pdk,pdk->pk", parts, parts)).max(axis=0)
    far = np.abs(segments.start).max(axis=0)
    tolerance: Floats = np.minimum(1e-9 * size + 4 * np.finfo(float).eps * far, 1e-7 * size)
    return tolerance
