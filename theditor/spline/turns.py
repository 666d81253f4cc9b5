"""How segments turn, as polynomials: what curvature is made of, and how exactly it is known."""

from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.spline import bernstein
from theditor.spline.basis import Floats
from theditor.spline.joints import Segments

_GRAIN = 4e-16  # of stored coordinates and what is computed from them


class Turn(NamedTuple):
    """Polynomials of some segments, in Bernstein form, each with the size of its rounding."""

    turn: Floats  # (k, n + 1): κ|C'|³ in the plane, κ²|C'|⁶ in space
    turn_noise: Floats  # (k,)
    growth: Floats  # (k, n + 1): of the sign of κ' in the plane, of (κ²)' in space
    growth_noise: Floats  # (k,)


def speed_scale(segments: Segments) -> Floats:
    """Return a length, (k,), that the terms of a segment's derivatives do not much exceed."""
    scale: Floats = np.linalg.norm(segments.end - segments.start, axis=0)
    for bend, lam in ((segments.bend_start, segments.lambda_start), (segments.bend_end, segments.lambda_end)):
        scale = scale + np.linalg.norm(bend, axis=0) * (1 + np.abs(lam))
    return scale


def grain(segments: Segments) -> Floats:
    """Return how far off a segment's points may be by rounding, that of its control points included, (k,)."""
    size = np.zeros_like(segments.lambda_start)
    for part in segments[:4]:
        size += np.abs(part).max(axis=0)
    size *= _GRAIN * (1 + np.maximum(np.abs(segments.lambda_start), np.abs(segments.lambda_end)))
    return size


def cross(a: Floats, b: Floats) -> Floats:
    """Return the cross products of vectors, (d, …): numbers in the plane, vectors in space."""
    if len(a) == 2:
        return np.asarray(a[0] * b[1] - a[1] * b[0])
    return np.stack([a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)])


def straight(segments: Segments, degree: int) -> NDArray[np.bool_]:
    """Return which segments, (k,), are straight or a point, to the rounding of their control points.

    Their derivatives are combinations of three vectors at most: they are straight where these are parallel.
    """
    span = [segments.bend_start, segments.bend_end]
    if degree == 3:
        span.append(segments.end - segments.start)
    sizes = [np.linalg.norm(vector, axis=0) for vector in span]
    noise = 8 * grain(segments)
    flat = np.ones(len(noise), dtype=np.bool_)
    for i, j in combinations(range(len(span)), 2):
        area = np.abs(cross(span[i], span[j])).reshape(-1, len(noise)).max(axis=0)
        flat &= area <= noise * (sizes[i] + sizes[j])
    return flat


def turns(segments: Segments, degree: int) -> tuple[Floats, Floats]:
    """Return C' × C'' of plane segments brought to one size, (k, n + 1), and its rounding, (k,)."""
    segments = _enlarged(segments)
    velocity, bend = (bernstein.polynomials(segments, degree, nu) for nu in (1, 2))
    return _crossed(velocity, bend)[0], 8 * grain(segments) * _most(velocity, bend)


def turns_and_growth(segments: Segments, degree: int) -> Turn:
    """Return what the curvature of segments, brought to one size, is made of, and what tells whether it grows.

    With N = C' × C'', the sign of κ' is that of N'|C'|² − 3N(C'·C'').
    """
    segments = _enlarged(segments)
    velocity, bend, third = (bernstein.polynomials(segments, degree, nu) for nu in (1, 2, 3))
    size = _most(velocity, bend, third)
    noise = 8 * grain(segments) * size
    turn, change = _crossed(velocity, bend), _crossed(velocity, third)
    square, along = _dotted(velocity, velocity), _dotted(velocity, bend)
    if len(velocity) == 2:
        growth = bernstein.product(change[0], square) - 3 * bernstein.product(turn[0], along)
        return Turn(turn[0], noise, growth, 32 * noise * size**2)
    most = _most(turn, change)
    turned = _dotted(turn, turn)
    growth = bernstein.product(_dotted(turn, change), square) - 3 * bernstein.product(turned, along)
    return Turn(turned, noise * (most + noise), growth, 64 * noise * most * size**2)


def _enlarged(segments: Segments) -> Segments:
    """Return the segments at a size of about 1 each, so that no product of lengths under- or overflows."""
    scale = speed_scale(segments)
    scale[scale == 0] = 1
    start, end, bend_start, bend_end = (part / scale for part in segments[:4])
    return segments._replace(start=start, end=end, bend_start=bend_start, bend_end=bend_end)


def _most(*vectors: Floats) -> Floats:
    """Return the largest coefficient of polynomial vectors, (k,)."""
    return np.asarray(np.max([np.abs(vector).max(axis=(0, 2)) for vector in vectors], axis=0))


def _crossed(a: Floats, b: Floats) -> Floats:
    """Return the coordinates of the cross product of polynomial vectors; one coordinate in the plane."""
    pairs = [(0, 1)] if len(a) == 2 else [(1, 2), (2, 0), (0, 1)]
    return np.stack([bernstein.product(a[i], b[j]) - bernstein.product(a[j], b[i]) for i, j in pairs])


def _dotted(a: Floats, b: Floats) -> Floats:
    return np.asarray(sum(bernstein.product(x, y) for x, y in zip(a, b, strict=True)))
