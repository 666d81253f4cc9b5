"""Points of outlines, computed from the definitions of their pieces alone, and distances to judge them by."""

import numpy as np

from theditor.spline import Outline, Piece


def along(pieces: Outline, steps: int = 24) -> np.ndarray:
    """Points at equal steps on every piece, one after the other, (k, d)."""
    t = np.arange(steps)[:, None] / steps
    runs = []
    for kind, start, end, (first, second), weight in zip(
        pieces.kinds, pieces.ends[:-1], pieces.ends[1:], pieces.inner, pieces.weights, strict=True
    ):
        if kind == Piece.LINE:
            run = start + t * (end - start)
        elif kind == Piece.ARC:
            run = first + np.cos(np.pi / 2 * t) * (start - first) + np.sin(np.pi / 2 * t) * (end - first)
        elif kind == Piece.CONIC:
            a, b, c = (1 - t) ** 2, 2 * weight * t * (1 - t), t**2
            run = (a * start + b * first + c * end) / (a + b + c)
        else:
            run = (
                (1 - t) ** 3 * start + 3 * t * (1 - t) ** 2 * first + 3 * t**2 * (1 - t) * second + t**3 * end
            )
        runs.append(run)
    return np.concatenate([*runs, pieces.ends[-1:]])


def farthest(points: np.ndarray, line: np.ndarray) -> float:
    """The largest distance of points from a chain of chords."""
    start, step = line[:-1], np.diff(line, axis=0)
    length = np.maximum((step**2).sum(axis=1), 1e-300)
    worst = 0.0
    for block in np.array_split(points, max(1, len(points) // 100)):
        away = block[:, None] - start
        t = np.clip((away * step).sum(axis=2) / length, 0, 1)
        gap = away - t[..., None] * step
        worst = max(worst, float(np.sqrt((gap**2).sum(axis=2).min(axis=1)).max()))
    return worst
