"""Where pairs of segments cross or touch: halved until each pair of parts has one simple answer.

A part is a polynomial in Bernstein form, so its coefficients bound its place, and their differences its
directions. Two parts are settled when

- a box, or a strip along either's chord, separates them: they do not meet;
- no direction of one is a direction of the other: they meet once at most, and Newton's method tells where;
- both are straight to within the tolerance: they meet where they come nearest, if that is near enough.

Parts of one curve that coincide or follow each other are settled as soon as their directions keep to less
than a half turn, for then the curve between cannot return to itself.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.spline import bernstein, joints
from theditor.spline.basis import Floats
from theditor.spline.distinct import distinct

APART, FOLLOWING, SAME = 0, 1, 2  # how the two parts of a pair lie on one curve

_DEEPEST = 40  # halvings
_MOST = 16_000  # pairs of parts of one width, shared by all pairs of segments,
_LEAST = 100  # but so many for each: no two segments need more that do not run along each other
_SLICE = 16_000  # pairs of parts looked at together, so that memory stays bounded
_STEPS = 12  # of Newton's method
_EDGE = 1e-9  # how far outside its part, in t, a crossing may be found


class Contacts(NamedTuple):
    """What was found; `row` says for which pair of segments, `s` and `t` where on each."""

    row: NDArray[np.intp]  # (k,)
    s: Floats  # (k,)
    t: Floats  # (k,)
    width: Floats  # (k,) of the parts, in s and t, that are not told apart here; 0: a crossing
    gap: Floats  # (k,) distance of the two points
    own: NDArray[np.bool_]  # (k,) where a curve turns back on itself: no contact, but its cause


class _Pairs(NamedTuple):
    """Pairs of parts of one width."""

    row: NDArray[np.intp]  # (k,)
    s: Floats  # (k,) where they begin
    t: Floats  # (k,)
    a: Floats  # (2, k, n + 1)
    b: Floats  # (2, k, n + 1)
    kind: NDArray[np.intp]  # (k,)

    def take(self, chosen: NDArray[np.bool_] | NDArray[np.intp]) -> "_Pairs":
        a, b = self.a[:, chosen], self.b[:, chosen]
        return _Pairs(self.row[chosen], self.s[chosen], self.t[chosen], a, b, self.kind[chosen])


def contacts(
    one: joints.Segments,
    other: joints.Segments,
    degrees: tuple[int, int],
    kind: NDArray[np.intp],
    tolerance: float,
) -> Contacts:
    """Return where pairs of plane segments cross, touch or turn back.

    Parameters
    ----------
    one, other : Segments
        k each.
    degrees : (int, int)
    kind : ndarray of int, shape (k,)
        `APART`, or on the same curve `SAME` or `FOLLOWING`: `other` begins where `one` ends.
    tolerance : float
        Points nearer than this count as meeting, positive.
    """
    rows = np.arange(len(kind))
    pairs = _Pairs(
        rows,
        np.zeros(len(rows)),
        np.zeros(len(rows)),
        bernstein.polynomials(one, degrees[0]),
        bernstein.polynomials(other, degrees[1]),
        kind,
    )
    most = max(_LEAST, _MOST // max(len(rows), 1))
    found: list[Contacts] = []
    stack = [(0, pairs)]
    while stack:
        depth, pairs = stack.pop()
        width = 0.5**depth
        pairs = pairs.take(_open(pairs, tolerance))
        # Crossings: no direction in common.
        simple = np.flatnonzero((pairs.kind == APART) & _transversal(pairs))
        places = _places(pairs.take(simple), one, other, degrees, width)
        s, t, hit = _crossing(places)
        gap = np.hypot(*places.apart(s, t))
        hit &= gap <= tolerance
        found.append(_contacts(pairs.take(simple), s, t, 0.0, gap, hit))
        left = np.ones(len(pairs.row), dtype=np.bool_)
        left[simple[hit]] = False
        pairs = pairs.take(left)
        # Straight parts, and what is left when the work gets too much.
        done = _straight(pairs.a, tolerance) & _straight(pairs.b, tolerance)
        done |= (depth == _DEEPEST) | (np.bincount(pairs.row, minlength=len(rows))[pairs.row] > most)
        rest = pairs.take(done)
        s, t, gap = _nearest(_places(rest, one, other, degrees, width))
        found.append(_contacts(rest, s, t, width, gap, (rest.kind != APART) | (gap <= tolerance)))
        pairs = pairs.take(~done)
        if len(pairs.row):
            stack += [(depth + 1, part) for part in _sliced(_halved(pairs, width / 2))]
    return Contacts(*(np.concatenate(column) for column in zip(*found, strict=True)))


def _contacts(
    pairs: _Pairs, s: Floats, t: Floats, width: float, gap: Floats, chosen: NDArray[np.bool_]
) -> Contacts:
    widths = np.full(np.count_nonzero(chosen), width)
    return Contacts(pairs.row[chosen], s[chosen], t[chosen], widths, gap[chosen], pairs.kind[chosen] != APART)


def _sliced(pairs: _Pairs) -> list[_Pairs]:
    """Return the pairs in portions, those of two segments together."""
    if len(pairs.row) <= _SLICE:
        return [pairs]
    order = np.argsort(pairs.row, kind="stable")
    row = pairs.row[order]
    cuts = distinct(np.searchsorted(row, row[_SLICE::_SLICE]))
    return [pairs.take(part) for part in np.split(order, cuts) if len(part)]


def _places(
    pairs: _Pairs, one: joints.Segments, other: joints.Segments, degrees: tuple[int, int], width: float
) -> "_Places":
    return _Places(one.take(pairs.row), other.take(pairs.row), degrees, pairs.s, pairs.t, width)


def _halved(pairs: _Pairs, width: float) -> _Pairs:
    """Return the four pairs of halves of each; three, of a part with itself."""
    a, b = bernstein.halves(pairs.a), bernstein.halves(pairs.b)
    children = []
    for i in (0, 1):
        for j in (0, 1):
            kind = np.zeros_like(pairs.kind)
            kind[(pairs.kind == SAME) & (i == j)] = SAME
            kind[(pairs.kind == SAME) & (i < j)] = FOLLOWING
            kind[(pairs.kind == FOLLOWING) & (i > j)] = FOLLOWING
            child = _Pairs(pairs.row, pairs.s + i * width, pairs.t + j * width, a[i], b[j], kind)
            children.append(child.take((pairs.kind != SAME) | (i <= j)))
    row, first, second, parts, others, kinds = zip(*children, strict=True)
    return _Pairs(
        np.concatenate(row),
        np.concatenate(first),
        np.concatenate(second),
        np.concatenate(parts, axis=1),
        np.concatenate(others, axis=1),
        np.concatenate(kinds),
    )


def _open(pairs: _Pairs, tolerance: float) -> NDArray[np.bool_]:
    """Return which pairs may have a contact."""
    a, b, kind = pairs.a, pairs.b, pairs.kind
    near = (a.min(axis=2) <= b.max(axis=2) + tolerance).all(axis=0)
    near &= (b.min(axis=2) <= a.max(axis=2) + tolerance).all(axis=0)
    for along in (a, b):
        normal = _across(along)
        first = np.einsum("dk,dkn->kn", normal, a)
        second = np.einsum("dk,dkn->kn", normal, b)
        near &= first.min(axis=1) <= second.max(axis=1) + tolerance
        near &= second.min(axis=1) <= first.max(axis=1) + tolerance
    steps = np.diff(a, axis=2)
    following = kind == FOLLOWING
    turning = np.zeros(len(kind), dtype=np.bool_)
    turning[~following] = _spread(steps[:, ~following])
    turning[following] = _spread(np.concatenate((steps, np.diff(b, axis=2)), axis=2)[:, following])
    return np.asarray(near & ((kind == APART) | turning))


def _spread(steps: Floats) -> NDArray[np.bool_]:
    """Return where directions, (2, k, n), do not keep to less than a half turn."""
    low, high, _ = _cone(steps)
    return np.asarray(high - low >= np.pi - 1e-9)


def _cone(steps: Floats) -> tuple[Floats, Floats, Floats]:
    """Return the least and greatest angle of directions, (k,), from their sum's, and that of their sum."""
    middle = steps.sum(axis=2)
    cross = middle[0, :, None] * steps[1] - middle[1, :, None] * steps[0]
    angle = np.arctan2(cross, np.einsum("dk,dkn->kn", middle, steps))
    back = np.hypot(*middle) < 1e-9 * np.hypot(*steps).sum(axis=1)  # the sum tells nothing
    low, high = np.where(back, -np.pi, angle.min(axis=1)), np.where(back, np.pi, angle.max(axis=1))
    return low, high, np.arctan2(middle[1], middle[0])


def _transversal(pairs: _Pairs) -> NDArray[np.bool_]:
    """Return which pairs have no direction in common, nor opposite ones."""
    low, high, middle = _cone(np.diff(pairs.a, axis=2))
    other_low, other_high, other_middle = _cone(np.diff(pairs.b, axis=2))
    between = (other_middle - middle) % np.pi  # a line's direction is one modulo a half turn
    return np.asarray((between + other_low - high > 1e-9) & (between + other_high - low < np.pi - 1e-9))


def _across(coefficients: Floats) -> Floats:
    """Return the unit normal of each part's chord, (2, k); 0 for a part that ends where it begins."""
    chord = coefficients[:, :, -1] - coefficients[:, :, 0]
    length = np.hypot(*chord)
    return np.divide((-chord[1], chord[0]), length, out=np.zeros_like(chord), where=length > 0)


def _straight(coefficients: Floats, tolerance: float) -> NDArray[np.bool_]:
    """Return which parts are, well within the tolerance, a chord run through one way, or a point."""
    from_start = coefficients - coefficients[:, :, :1]
    aside = np.abs(np.einsum("dk,dkn->kn", _across(coefficients), from_start)).max(axis=1)
    point = np.hypot(*from_start).max(axis=1) <= tolerance / 4
    return np.asarray(point | ((aside <= tolerance / 4) & ~_spread(np.diff(coefficients, axis=2))))


class _Places(NamedTuple):
    """Pairs of segments, and between which limits to look at each."""

    one: joints.Segments
    other: joints.Segments
    degrees: tuple[int, int]
    low_s: Floats  # (k,)
    low_t: Floats  # (k,)
    width: float

    def apart(self, s: Floats, t: Floats) -> Floats:
        """Return from which point to which it is how far, (2, k)."""
        here = joints.evaluate(self.one, s, self.degrees[0], 0)
        return here - joints.evaluate(self.other, t, self.degrees[1], 0)

    def derivatives(self, s: Floats, t: Floats, nu: int) -> tuple[Floats, Floats]:
        first = joints.evaluate(self.one, s, self.degrees[0], nu)
        return first, joints.evaluate(self.other, t, self.degrees[1], nu)

    def limited(self, s: Floats, t: Floats, beyond: float = 0.0) -> tuple[Floats, Floats]:
        first = np.clip(s, self.low_s - beyond, self.low_s + self.width + beyond)
        return first, np.clip(t, self.low_t - beyond, self.low_t + self.width + beyond)


def _crossing(places: _Places) -> tuple[Floats, Floats, NDArray[np.bool_]]:
    """Return where Newton's method for a crossing ends, and whether within the parts."""
    s, t = places.low_s + places.width / 2, places.low_t + places.width / 2
    for _ in range(_STEPS):
        apart, (v, w) = places.apart(s, t), places.derivatives(s, t, 1)
        steps = _solved(v, -w, -apart)
        s, t = places.limited(s + steps[0], t + steps[1], places.width)
        if not np.any(np.abs(steps) > 1e-15):
            break
    first, second = places.limited(s, t)
    inside = (np.abs(first - s) <= _EDGE) & (np.abs(second - t) <= _EDGE)
    return first, second, inside


def _nearest(places: _Places) -> tuple[Floats, Floats, Floats]:
    """Return where straight parts come nearest, and how near.

    That is at an end of one of them, unless they cross, or touch at a point where they are parallel.
    """
    low_s, low_t, width = places.low_s, places.low_t, places.width
    tries = [_crossing(places)[:2]]
    for end in (0.0, width):
        tries.append((low_s + end, _projected(places, low_s + end, low_t + width / 2, 1)))
        tries.append((_projected(places, low_s + width / 2, low_t + end, 0), low_t + end))
    s, t, gap = _best(places, tries)
    return _best(places, [(s, t), _parallel(places, s, t)]) if gap.size else (s, t, gap)


def _best(places: _Places, tries: list[tuple[Floats, Floats]]) -> tuple[Floats, Floats, Floats]:
    gaps = np.stack([np.hypot(*places.apart(s, t)) for s, t in tries])
    best = np.argmin(gaps, axis=0)[None]
    s, t = (np.take_along_axis(np.stack(values), best, axis=0)[0] for values in zip(*tries, strict=True))
    return s, t, np.take_along_axis(gaps, best, axis=0)[0]


def _projected(places: _Places, s: Floats, t: Floats, which: int) -> Floats:
    """Return s (which = 0) or t (1) of the point nearest to the other curve's, by Gauss–Newton steps."""
    for _ in range(_STEPS):
        apart, velocity = places.apart(s, t), places.derivatives(s, t, 1)[which]
        square = np.einsum("dk,dk->k", velocity, velocity)
        step = np.einsum("dk,dk->k", apart, velocity) * (1 if which else -1)
        step = np.divide(step, square, out=np.zeros_like(step), where=square > 0)
        s, t = places.limited(s, t + step) if which else places.limited(s + step, t)
    return t if which else s


def _parallel(places: _Places, s: Floats, t: Floats) -> tuple[Floats, Floats]:
    """Return where, near s and t, the curves run parallel and neither is ahead: Newton's method."""
    for _ in range(_STEPS):
        apart = places.apart(s, t)
        (v, w), (a, b) = places.derivatives(s, t, 1), places.derivatives(s, t, 2)
        wanted = np.stack((_cross(v, w), np.einsum("dk,dk->k", apart, v)))
        by_s = np.stack((_cross(a, w), np.einsum("dk,dk->k", v, v) + np.einsum("dk,dk->k", apart, a)))
        by_t = np.stack((_cross(v, b), -np.einsum("dk,dk->k", w, v)))
        steps = _solved(by_s, by_t, -wanted)
        s, t = places.limited(s + steps[0], t + steps[1])
    return s, t


def _solved(first: Floats, second: Floats, right: Floats) -> Floats:
    """Solve first·x + second·y = right, (2, k) each; 0 where the columns are parallel."""
    area = _cross(first, second)
    solution = np.stack((_cross(right, second), _cross(first, right)))
    return np.divide(solution, area, out=np.zeros_like(solution), where=area != 0)


def _cross(a: Floats, b: Floats) -> Floats:
    return np.asarray(a[0] * b[1] - a[1] * b[0])
