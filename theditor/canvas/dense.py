"""Ink that lies so dense that a line would be drawn for every few pixels: points laid into a finer picture of bits.

Each pixel has 4 × 4 bits, a smaller one of a fine screen 2 × 2. Where a curve passes, a bit is set; then, 64
neighbours being one number, all bits within half the pen's width of a set one are set at once. How many of its
bits are set is how much of a pixel is covered. So a picture costs its pixels, and for each further point a
fraction of what a line takes.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF
from PySide6.QtGui import QColor, QImage, QPainter

from theditor.canvas.raster import Along, Raster
from theditor.canvas.viewport import Area, Viewport

Floats = NDArray[np.float64]
Bits = NDArray[np.uint64]
Bytes = NDArray[np.uint8]

NARROWEST, WIDEST = 0.5, 24.0
"""Widths in pixels of the pens that will do: a finer one has too few bits, half of a wider one more than a word."""
FINE_SCREEN = 1.5
"""From so many device pixels a pixel on, half as many bits along each side of one will do."""
BAND = 2**18
"""So many pixels are worked on at a time, as what belongs to them stays in the processor's cache."""
TINY = 1e-6
WORD = 64
NONE, ONE, TWO, FOUR, REST = (np.uint64(shift) for shift in (0, 1, 2, 4, WORD - 1))
PLACES = ONE << np.arange(WORD, dtype=np.uint64)
NIBBLES, PAIRS, ODD = (np.uint64(int(digits * 8, 16)) for digits in ("0f", "33", "55"))


class Grid(NamedTuple):
    """Pixels over part of the plane."""

    corner: Floats
    """(2,): the point in the top left corner."""
    scale: float
    """Pixels per unit."""
    columns: int
    rows: int
    fine: int
    """Bits along each side of a pixel, 4 or 2."""


def spacing(width: float) -> float:
    """How far apart points may be so that a pen of a width, both in pixels, leaves no dents between them to see."""
    return min(0.65 * width, 1.5)


def paint_dense(
    painter: QPainter, points: Along, viewport: Viewport, width: float, colour: str, area: Area
) -> None:
    """Paint what a round pen leaves that has been at some points.

    Parameters
    ----------
    painter
        Paints an image or a pixmap, at any device pixel ratio.
    points
        Points of the plane, which on the screen are no farther apart than `spacing`.
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
    corner, fine = viewport.to_points((left, top)), 4 if ratio < FINE_SCREEN else 2
    grid = Grid(corner, viewport.scale * ratio, columns, rows, fine)
    for first, covered in coverage(points, width * ratio, grid):
        shaded = _shades(colour).take(covered.view(np.uint16)).view(np.uint32)
        image = QImage(
            shaded.data, columns, len(shaded), shaded.strides[0], QImage.Format.Format_ARGB32_Premultiplied
        )
        image.setDevicePixelRatio(ratio)
        painter.drawImage(QPointF(left, top + first / ratio), image)


@lru_cache(maxsize=16)
def _shades(colour: str) -> NDArray[np.uint64]:
    """What two pixels are side by side, premultiplied, of which a pen of that colour covers so many sixteenths.

    By one number for both, the right one's sixteenths in the upper byte.
    """
    pen = QColor(colour)
    parts = np.outer(np.arange(17) / 16, (255, pen.red(), pen.green(), pen.blue()))
    one = np.round(parts).astype(np.uint64) @ np.array([1 << 24, 1 << 16, 1 << 8, 1], dtype=np.uint64)
    both = np.zeros((17, 256), dtype=np.uint64)
    both[:, :17] = one[:, None] << np.uint64(32) | one
    return both.ravel()


def coverage(points: Along, width: float, grid: Grid) -> Iterator[tuple[int, Bytes]]:
    """How many sixteenths a pen covers of each pixel, some rows of pixels at a time from the top down.

    Parameters
    ----------
    points
        Where the pen has been in the plane, y upward.
    width
        The pen's diameter in pixels.
    grid
        The pixels.

    Yields
    ------
    int
        The first row.
    ndarray of uint8, shape (k, columns and up to 31 more)
    """
    fine = grid.fine
    diameter = max(round(fine * width), 1)
    above = diameter // 2 + 1  # so many rows, and a word on each side, keep what is outside apart
    words = math.ceil(grid.columns * fine / WORD) + 2
    height = grid.rows * fine + 2 * above
    bits = np.zeros(height * words, dtype=np.uint64)
    # An even number of bits lies around a corner of four.
    first = np.array([[WORD], [above]]) + (0.0 if diameter % 2 else 0.5)
    last = np.array([[words * WORD - 1], [height - 1]], dtype=np.float32)
    raster = Raster(grid.corner[:, None], np.array([[grid.scale], [-grid.scale]]) * fine, first)
    for some in points(raster):
        x, y = np.clip(some, 0, last).astype(np.int32)
        y *= words * WORD
        y += x
        np.bitwise_or.at(bits, y >> 6, PLACES.take(y & (WORD - 1)))
    lines = bits.reshape(height, words)
    band = max(BAND // grid.columns, 1)
    for top in range(0, grid.rows, band):
        within = lines[top * fine : min(top + band, grid.rows) * fine + 2 * above].ravel()
        spread = _spread(within, diameter, words).reshape(-1, words)
        yield top, _counted(spread[above:-above, 1:-1], fine)


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


def _counted(bits: Bits, fine: int) -> Bytes:
    """How many sixteenths are set of each square of bits, from (fine · rows, words) to (rows, 64 / fine · words)."""
    pairs = bits >> ONE
    pairs &= ODD
    np.subtract(bits, pairs, out=pairs)
    right = pairs >> TWO
    right &= PAIRS
    left = pairs
    left &= PAIRS
    if fine == 4:
        # Two neighbours are a pixel's row. Of its rows two fit where one was; four need the room of two.
        left += right
        rows = left.reshape(-1, 4, left.shape[1])
        one, other = rows[:, 0] + rows[:, 1], rows[:, 2] + rows[:, 3]
        numbers = [(one >> shift & NIBBLES) + (other >> shift & NIBBLES) for shift in (NONE, FOUR)]
    else:
        sides = [side[::2] + side[1::2] for side in (left, right)]
        numbers = [(side >> shift & NIBBLES) << TWO for shift in (NONE, FOUR) for side in sides]
    result = np.empty((len(numbers[0]), WORD // fine * left.shape[1]), dtype=np.uint8)
    for start, number in enumerate(numbers):
        result[:, start :: len(numbers)] = number.view(np.uint8)
    return result
