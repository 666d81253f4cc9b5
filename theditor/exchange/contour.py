"""Contours as foreign formats have them: runs of lines, Béziers and elliptical arcs in the plane."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import comb
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.drawing import DrawingError
from theditor.spline import MAX_COORDINATE
from theditor.spline.distinct import moves_on

Floats = NDArray[np.float64]

_MOST_STEPS: Final = 1000  # of one piece
_SIZE_STEPS: Final = 8


@dataclass(frozen=True, slots=True, eq=False)
class Bezier:
    """A line or a Bézier of degree 2 or 3."""

    points: Floats  # (degree + 1, 2)

    def at(self, t: Floats) -> Floats:
        """Return the points at some t from 0 to 1, (n, 2)."""
        degree = len(self.points) - 1
        if degree == 1:  # exactly at both ends
            return np.outer(1 - t, self.points[0]) + np.outer(t, self.points[1])
        weights = [comb(degree, k) * (1 - t) ** (degree - k) * t**k for k in range(degree + 1)]
        points: Floats = np.stack(weights, axis=1) @ self.points
        return points

    @property
    def ends(self) -> Floats:
        """First and last point, (2, 2)."""
        ends: Floats = self.points[[0, -1]]
        return ends

    @property
    def directions(self) -> Floats:
        """Where it sets off and where it arrives, as unit vectors, (2, 2); zero for a piece without length."""
        leaving = self.points[1:] - self.points[0]
        arriving = self.points[-1] - self.points[-2::-1]
        return np.stack([_first_direction(leaving), _first_direction(arriving)])

    @property
    def bend(self) -> float:
        """A bound of its second derivative."""
        degree = len(self.points) - 1
        if degree == 1:
            return 0.0
        return degree * (degree - 1) * float(np.linalg.norm(np.diff(self.points, 2, axis=0), axis=1).max())

    def moved(self, matrix: Floats) -> Bezier:
        """Return it under an affine map."""
        return Bezier(_mapped(self.points, matrix))


@dataclass(frozen=True, slots=True, eq=False)
class Arc:
    """The arc ``centre + cos(φ) cosine + sin(φ) sine`` of an ellipse, φ from 0 to `angle` > 0."""

    centre: Floats
    cosine: Floats
    sine: Floats
    angle: float

    def at(self, t: Floats) -> Floats:
        """Return the points at some t from 0 to 1, (n, 2)."""
        phi = t * self.angle
        points: Floats = self.centre + np.outer(np.cos(phi), self.cosine) + np.outer(np.sin(phi), self.sine)
        return points

    @property
    def ends(self) -> Floats:
        """First and last point, (2, 2)."""
        return self.at(np.array([0.0, 1.0]))

    @property
    def directions(self) -> Floats:
        """Where it sets off and where it arrives, as unit vectors, (2, 2); zero for a piece without length."""
        cosine, sine = np.cos(self.angle), np.sin(self.angle)
        return np.stack(
            [_first_direction([self.sine]), _first_direction([cosine * self.sine - sine * self.cosine])]
        )

    @property
    def bend(self) -> float:
        """A bound of its second derivative."""
        return self.angle**2 * float(np.hypot(np.linalg.norm(self.cosine), np.linalg.norm(self.sine)))

    def moved(self, matrix: Floats) -> Arc:
        """Return it under an affine map."""
        linear = matrix[:, :2]
        return Arc(_mapped(self.centre, matrix), linear @ self.cosine, linear @ self.sine, self.angle)


Piece = Bezier | Arc


class Contour(NamedTuple):
    """Pieces, each beginning where the one before ends; the last one of a closed contour ends at its start."""

    pieces: tuple[Piece, ...]
    closed: bool

    def moved(self, matrix: Floats) -> Contour:
        """Return the contour under an affine map.

        Parameters
        ----------
        matrix : ndarray, shape (2, 3)
            A point (x, y) goes to ``matrix @ (x, y, 1)``.

        Raises
        ------
        DrawingError
            If a coordinate is not finite or larger than those of a drawing; the middle of a sentence.
        """
        with np.errstate(all="ignore"):
            contour = Contour(tuple(piece.moved(matrix) for piece in self.pieces), self.closed)
            for piece in contour.pieces:
                every = piece.points if isinstance(piece, Bezier) else [*piece.ends, piece.cosine, piece.sine]
                if not (np.abs(every) <= MAX_COORDINATE / 4).all():
                    raise DrawingError(f"coordinates must be numbers within ±{MAX_COORDINATE / 4:g}")
        return contour


def polyline(points: Sequence[Sequence[float]] | Floats, closed: bool = False) -> Contour:
    """Return the contour along some points; points that repeat the one before are left out."""
    every = np.asarray(points, dtype=np.float64)
    if closed and len(every):
        every = np.concatenate((every, every[:1]))
    every = every[moves_on(every)]
    return Contour(tuple(Bezier(every[i : i + 2]) for i in range(len(every) - 1)), closed)


def ellipse(x: float, y: float, a: float, b: float) -> Contour:
    """Return a whole ellipse with semi-axes along x and y."""
    return Contour((Arc(np.array([x, y]), np.array([a, 0.0]), np.array([0.0, b]), 2 * np.pi),), True)


def steps(piece: Piece, chord: float) -> int:
    """Return in how many equal steps of t chords stay so near to a piece."""
    return int(np.clip(np.ceil(np.sqrt(piece.bend / (8 * chord))), 1, _MOST_STEPS))


def size(contours: Sequence[Contour]) -> float:
    """Return the longer side of the box around some contours, 0 if there are none."""
    corners = list(_corners(contours))
    return float(np.ptp(np.concatenate(corners), axis=0).max()) if corners else 0.0


def _corners(contours: Sequence[Contour]) -> Iterator[Floats]:
    t = np.linspace(0, 1, _SIZE_STEPS + 1)
    for contour in contours:
        for piece in contour.pieces:
            straight = isinstance(piece, Bezier) and len(piece.points) == 2
            yield piece.ends if straight else piece.at(t)


def _mapped(points: Floats, matrix: Floats) -> Floats:
    moved: Floats = points @ matrix[:, :2].T + matrix[:, 2]
    return moved


def _first_direction(moves: Sequence[Floats] | Floats) -> Floats:
    """Return the direction of the first of some vectors that has one."""
    for move in moves:
        length = float(np.hypot(*move))
        if length > 0:
            return move / length
    return np.zeros(2)
