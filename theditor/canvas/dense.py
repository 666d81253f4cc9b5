"""Ink that lies so dense that a line would be drawn for every few pixels: points laid into a finer picture of bits.

Each pixel has 4 × 4 bits. Where a curve passes, a bit is set; then, 64 neighbours being one number, all bits
within half the pen's width of a set one are set at once. How many of its bits are set is how much of a pixel is
covered. So a picture costs its pixels, and for each further point a fraction of what a line takes.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF
from PySide6.QtGui import QColor, QImage, QPainter

from theditor.canvas.viewport import Area, Viewport

Floats = NDArray[np.float64]
Bits = NDArray[np.uint64]
Bytes = NDArray[np.uint8]

FINE = 4
"""Bits along each side of a pixel."""
NARROWEST, WIDEST = 0.5, 8.0
"""Widths in device pixels of the pens that are worth it: a finer one has too few bits, a wider one takes its time."""
TINY = 1e-6
WORD = 64
ONE, REST = np.uint64(1), np.uint64(WORD - 1)
NIBBLES, PAIRS, ODD = (np.uint64(int(digits * 8, 16)) for digits in ("0f", "33", "55"))


def spacing(width: float) -> float:
    """How far apart points may be so that a pen of a width, both in pixels, leaves no dents between them to see."""
    return min(0.6 * width, 1.5)


def paint_dense(
    painter: QPainter, points: Iterable[Floats], viewport: Viewport, width: float, colour: str, area: Area
) -> None:
    """Paint what a round pen leaves that has been at some points.

    Parameters
    ----------
    painter
        Paints an image or a pixmap, at any device pixel ratio.
    points : iterable of (2, n)
        x and y of points of the plane, which on the screen are no farther apart than `spacing`.
    viewport
        Where on the screen they are.
    width
        The pen's diameter in pixels.
    colour
        The pen's colour.
    area
        Where to paint, bounded by whole device pixels.
    """
    left, top, wide, high = area
    ratio = painter.device().devicePixelRatioF()
    columns, rows = math.ceil(wide * ratio - TINY), math.ceil(high * ratio - TINY)
    corner = viewport.to_points((left, top))
    covered = coverage(points, corner, viewport.scale * ratio, width * ratio, columns, rows)
    shaded = _shades(colour).take(covered.view(np.uint16)).view(np.uint32)
    image = QImage(shaded.data, columns, rows, shaded.strides[0], QImage.Format.Format_ARGB32_Premultiplied)
    image.setDevicePixelRatio(ratio)
    painter.drawImage(QPointF(left, top), image)


@lru_cache(maxsize=16)
def _shades(colour: str) -> NDArray[np.uint64]:
    """What two pixels are side by side, premultiplied, of which a pen of that colour covers so and so many bits.

    By one number for both, the right one's bits in the upper byte.
    """
    pen, most = QColor(colour), FINE**2
    parts = np.outer(np.arange(most + 1) / most, (255, pen.red(), pen.green(), pen.blue()))
    one = np.round(parts).astype(np.uint64) @ np.array([1 << 24, 1 << 16, 1 << 8, 1], dtype=np.uint64)
    both = np.zeros((most + 1, 256), dtype=np.uint64)
    both[:, : most + 1] = one[:, None] << np.uint64(32) | one
    return both.ravel()


def coverage(
    points: Iterable[Floats], corner: Floats, scale: float, width: float, columns: int, rows: int
) -> Bytes:
    """How many of its 16 bits a pen covers of each pixel.

    Parameters
    ----------
    points : iterable of (2, n)
        Where the pen has been in the plane, y upward.
    corner : (2,)
        The point of the plane in the top left corner.
    scale
        Pixels per unit.
    width
        The pen's diameter in pixels.
    columns, rows
        How many pixels there are.

    Returns
    -------
    ndarray of uint8, shape (rows, columns and up to 15 more)
    """
    diameter = max(round(FINE * width), 1)
    above = diameter // 2 + 1  # so many rows, and a word on each side, keep what is outside apart
    words = math.ceil(columns * FINE / WORD) + 2
    height = rows * FINE + 2 * above
    touched = np.zeros(height * words * WORD, dtype=np.uint8)
    start, growth = corner[:, None], np.array([[scale], [-scale]]) * FINE
    # An even number of bits lies around a corner of four.
    first = np.array([[WORD], [above]]) + (0.0 if diameter % 2 else 0.5)
    last = np.array([[words * WORD - 1], [height - 1]])
    for some in points:
        fine = some - start
        fine *= growth
        fine += first
        x, y = np.clip(fine, 0, last, out=fine).astype(np.int32)
        y *= words * WORD
        y += x
        touched[y] = 1
    bits = np.packbits(touched, bitorder="little").view(np.uint64)
    return _counted(_spread(bits, diameter, words).reshape(height, words)[above : height - above, 1:-1])


def _spread(bits: Bits, diameter: int, words: int) -> Bits:
    """Set all bits within a diameter around each set one; rows are so many words."""
    even = diameter % 2 == 0
    wide, run, spare = 2 - diameter % 2, bits, np.empty_like(bits)
    if even:
        run = bits | np.right_shift(bits, ONE, out=spare)
        run[:-1] |= np.left_shift(bits[1:], REST, out=spare[1:])
    result = np.zeros_like(bits)
    for row in sorted(
        range(-(diameter // 2), diameter - diameter // 2), key=lambda row: -abs(row + even / 2)
    ):
        reach = math.sqrt(diameter**2 / 4 - (row + even / 2) ** 2)
        while wide + 2 <= (2 * math.floor(reach + 0.5) if even else 2 * math.floor(reach) + 1):
            run, wide = _widened(run, spare, gaps=wide == 1), wide + 2
        if row < 0:
            result[: row * words] |= run[-row * words :]
        else:
            result[row * words :] |= run[: len(run) - row * words]
    return result


def _widened(bits: Bits, spare: Bits, *, gaps: bool) -> Bits:
    """Set the bits to the left and to the right of each set one; lone ones would leave gaps in between."""
    result = bits << ONE
    result |= np.right_shift(bits, ONE, out=spare)
    result[1:] |= np.right_shift(bits[:-1], REST, out=spare[1:])
    result[:-1] |= np.left_shift(bits[1:], REST, out=spare[1:])
    if gaps:
        result |= bits
    return result


def _counted(bits: Bits) -> Bytes:
    """How many bits are set in each square of 4 × 4, from (4 · rows, words) to (rows, 16 · words)."""
    pairs = bits >> ONE
    pairs &= ODD
    np.subtract(bits, pairs, out=pairs)
    fours = pairs >> np.uint64(2)
    fours &= PAIRS
    pairs &= PAIRS
    fours += pairs
    fours = fours.reshape(-1, FINE, fours.shape[1])
    upper, lower = fours[:, 0] + fours[:, 1], fours[:, 2] + fours[:, 3]
    result = np.empty((len(fours), 2 * WORD // 8 * fours.shape[2]), dtype=np.uint8)
    for start, shift in enumerate((np.uint64(0), np.uint64(4))):
        sums = (upper >> shift & NIBBLES) + (lower >> shift & NIBBLES)
        result[:, start::2] = sums.view(np.uint8)
    return result
