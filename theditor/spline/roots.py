"""Where polynomials in Bernstein form change sign."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.spline import bernstein
from theditor.spline.basis import Floats

_CLOSE = 1e-9  # a Newton step this short leaves an error of about its square
_STEPS = 60  # of the bracketed Newton method, which bisects when it does not converge


class SignChanges(NamedTuple):
    """The sign changes of many polynomials, ascending by row, then by t."""

    row: NDArray[np.intp]  # (k,) which polynomial
    t: Floats  # (k,) where, 0 < t < 1
    rising: NDArray[np.bool_]  # (k,) from negative to positive
    first: Floats  # (rows,) the sign right after t = 0; 0 for a polynomial that vanishes
    last: Floats  # (rows,) the sign right before t = 1


def sign_changes(coefficients: Floats, noise: Floats, accuracy: float) -> SignChanges:
    """Return every place in (0, 1) where a polynomial changes sign, exact to rounding.

    Halves what may change sign more than once, until each part provably does at most once. Coefficients
    within the noise count as 0: a polynomial of nothing else vanishes and never changes sign, and a root that
    the noise smears over a stretch is given once, inside it. Roots where the sign stays are not given.

    Parameters
    ----------
    coefficients : ndarray, shape (rows, n + 1)
    noise : ndarray, shape (rows,)
        How far off each row's coefficients may be.
    accuracy : float
        Two sign changes closer than this in t may be missed together.
    """
    deepest = int(np.ceil(-np.log2(np.clip(accuracy, 1e-13, 1))))
    rows = np.arange(len(coefficients))
    low = np.zeros(len(rows))
    parts, brackets = [], []
    first = last = np.empty(0)
    for depth in range(deepest + 1):
        width = 0.5**depth
        before, after, changes = signs(coefficients, noise[rows])
        if depth == 0:
            first, last = before, after
        done = (changes < 2) | (depth == deepest)
        kept = done & (before != 0)
        parts.append(np.stack((rows[kept], low[kept], low[kept] + width, before[kept], after[kept])))
        inside = kept & (before != after)
        t = low[inside] + width * _bracketed(coefficients[inside], before[inside])
        brackets.append(np.stack((rows[inside], t, after[inside])))
        rows, low = rows[~done], low[~done]
        if not len(rows):
            break
        coefficients = np.concatenate(bernstein.halves(coefficients[~done]))
        rows, low = np.tile(rows, 2), np.concatenate((low, low + width / 2))
    row, start, end, before, after = _in_order(parts)
    # A root that fell on a cut shows only in the signs on either side of it.
    between = np.flatnonzero((row[:-1] == row[1:]) & (after[:-1] != before[1:]))
    brackets.append(np.stack((row[between], (end[between] + start[between + 1]) / 2, before[between + 1])))
    row, t, sign = _in_order(brackets)
    return SignChanges(row.astype(np.intp), t, sign > 0, first, last)


def signs(coefficients: Floats, noise: Floats) -> tuple[Floats, Floats, NDArray[np.intp]]:
    """Return the first and the last sign among each row's coefficients, and how often it changes.

    Coefficients within the noise are left out. The first sign is the polynomial's right after t = 0, the last
    one its sign right before t = 1; they are 0 for a row of nothing but noise.
    """
    sign = np.sign(coefficients) * (np.abs(coefficients) > noise[:, None])
    place = np.where(sign != 0, np.arange(sign.shape[1]), 0)
    filled = np.take_along_axis(sign, np.maximum.accumulate(place, axis=1), axis=1)
    first = np.take_along_axis(sign, np.argmax(sign != 0, axis=1)[:, None], axis=1)[:, 0]
    return first, filled[:, -1], np.count_nonzero(filled[:, 1:] * filled[:, :-1] < 0, axis=1)


def _in_order(tables: list[Floats]) -> Floats:
    """Return one table of all the columns, sorted by their first entry, then by their second."""
    table = np.concatenate(tables, axis=1)
    return table[:, np.lexsort((table[1], table[0]))]


def _bracketed(coefficients: Floats, before: Floats) -> Floats:
    """Return the one place where each polynomial, of the given sign at first, changes it."""
    low, high = np.zeros(len(before)), np.ones(len(before))
    t = np.full(len(before), 0.5)
    slopes = np.diff(coefficients, axis=1) * (coefficients.shape[1] - 1)
    active = np.arange(len(before))
    for _ in range(_STEPS):
        here = t[active]
        height = bernstein.value(coefficients[active], here)
        slope = bernstein.value(slopes[active], here)
        early = height * before[active] > 0
        low[active[early]], high[active[~early]] = here[early], here[~early]
        with np.errstate(divide="ignore", invalid="ignore"):
            new = here - height / slope
        wild = ~((new > low[active]) & (new < high[active]))
        new[wild] = ((low + high) / 2)[active][wild]
        t[active] = new
        active = active[np.abs(new - here) > _CLOSE]
        if not len(active):
            break
    return t
