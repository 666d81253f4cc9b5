"""The curve: an immutable value made of control points, shape parameters, degree and ends."""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from theditor.spline import checks, enclosures, joints, sampling
from theditor.spline.basis import INTERPOLATING, Floats, Mode, check_degree, check_order, lambda_of

Ends = Literal["free", "clamped"]

_MODES = np.array([Mode.TRIGONOMETRIC, Mode.HYPERBOLIC, Mode.INTERPOLATING, Mode.BLEND], dtype=object)


@dataclass(frozen=True, init=False, eq=False, repr=False)
class Curve:
    """A TH-type uniform B-spline of degree 2 (C¹) or 3 (C²) in the plane or in space.

    A value: it never changes, compares and hashes by content, and every ``with_…`` method returns another
    curve, which shares with this one whatever is the same. Points on the curve are within
    1e-15·max|coordinate|·max(1, |λ|) of the exact ones, derivatives within 1e-14 of the like.

    Parameters
    ----------
    points : array_like, shape (m, 2) or (m, 3)
        Control points, finite and at most `MAX_COORDINATE` in size.
    lambdas : float or array_like, shape (m,)
        Shape parameter λ of each control point, at most `MAX_LAMBDA` in size. A quadratic's λ_i belongs to
        the edge from point i−1 to point i, a cubic's to point i.
    degree : {2, 3}
        Quadratic or cubic.
    closed : bool
        Whether the curve runs round and ends where it began.
    ends : {"free", "clamped"}
        How an open curve ends: as the basis has it, or at the first and last control point, tangent to the
        polygon there. Kept, but without effect, while the curve is closed.

    Raises
    ------
    ValueError
        If there are fewer than `fewest_points` control points, a number is not finite or too large, or a
        shape is wrong.
    """

    control_points: Floats
    lambdas: Floats
    degree: int
    closed: bool
    ends: Ends

    def __init__(
        self,
        points: ArrayLike,
        lambdas: ArrayLike = 0.0,
        degree: int = 3,
        closed: bool = False,
        ends: Ends = "free",
    ) -> None:
        check_degree(degree)
        checks.check_closed(closed)
        control_points = checks.clean_points(points)
        count = len(control_points)
        checks.check_count(count, degree, closed, ends)
        vars(self).update(
            control_points=control_points,
            lambdas=checks.clean_lambdas(lambdas, count),
            degree=int(degree),
            closed=bool(closed),
            ends=ends,
        )
        self._freeze()

    def _freeze(self) -> None:
        self.control_points.flags.writeable = False
        self.lambdas.flags.writeable = False

    def _replaced(self, **changes: object) -> Self:
        """Return the curve with these attributes, which have been checked, in place of its own."""
        other = object.__new__(type(self))
        vars(other).update({name: getattr(self, name) for name in self.__dataclass_fields__} | changes)
        other._freeze()
        return other

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Curve):
            return NotImplemented
        return self is other or (
            (self.degree, self.closed, self.ends) == (other.degree, other.closed, other.ends)
            and _same(self.control_points, other.control_points)
            and _same(self.lambdas, other.lambdas)
        )

    @cached_property
    def _hash(self) -> int:
        content = self.control_points.tobytes(), self.lambdas.tobytes()
        return hash((*content, self.dimension, self.degree, self.closed, self.ends))

    def __hash__(self) -> int:
        return self._hash

    def __reduce__(self) -> tuple[type[Self], tuple[object, ...]]:
        return type(self), (self.control_points, self.lambdas, self.degree, self.closed, self.ends)

    def __repr__(self) -> str:
        kind = "quadratic" if self.degree == 2 else "cubic"
        ends = "closed" if self.closed else self.ends
        return f"<Curve: {ends} {kind}, {len(self.control_points)} points, {self.dimension}-D>"

    def _repr_svg_(self) -> str:
        from theditor.spline.path_data import picture  # which needs this class itself

        return picture(self)

    # What the curve consists of

    @property
    def dimension(self) -> int:
        """Number of coordinates, 2 or 3."""
        return int(self.control_points.shape[1])

    @property
    def segment_count(self) -> int:
        """Number of segments."""
        count = len(self.control_points)
        if self.closed:
            return count
        return count - 2 if self.degree == 2 else count - 3 + 2 * (self.ends == "clamped")

    @property
    def domain(self) -> tuple[int, int]:
        """The range of u = segment + t."""
        return 0, self.segment_count

    @property
    def first_segment(self) -> int:
        """What to add to a segment's index to number it as the paper does.

        Segment s runs between joints s and s + 1, which belong to λ of the same index plus this number.
        """
        return 0 if self.closed or (self.degree == 3 and self.ends == "clamped") else 1

    def lambda_indices(self, segment: int) -> tuple[int | None, int | None]:
        """Return the two control points whose λ shape a segment; None where a clamped end fixes it.

        Raises
        ------
        ValueError
            If there is no such segment.
        """
        if np.ndim(segment) != 0:
            raise ValueError(f"give one segment, not an array of shape {np.shape(segment)}")
        (index,) = checks.clean_indices(segment, self.segment_count, "segment")
        pair = ((int(index) + self.first_segment + step) % len(self.control_points) for step in (0, 1))
        start, end = (i if self.active_lambdas[i] else None for i in pair)
        return start, end

    @cached_property
    def active_lambdas(self) -> NDArray[np.bool_]:
        """Which λ influence the curve, (m,)."""
        active = np.ones(len(self.control_points), dtype=np.bool_)
        if not self.closed:
            active[0] = False
            active[-1] = self.degree == 2
        active.flags.writeable = False
        return active

    @cached_property
    def mode_codes(self) -> NDArray[np.int8]:
        """The mode of each segment as a number: 0 trigonometric, 1 hyperbolic, 2 interpolating, 3 blend."""
        codes = self.codes_of(np.arange(self.segment_count))
        codes.flags.writeable = False
        return codes

    def codes_of(self, segments: NDArray[np.intp]) -> NDArray[np.int8]:
        """Return the modes of some segments as numbers, like `mode_codes`, without looking at the others."""
        return joints.mode_codes(self, segments)

    @cached_property
    def modes(self) -> tuple[Mode, ...]:
        """The mode of each segment. A segment at a clamped cubic end goes by its one active λ."""
        return tuple(_MODES[self.mode_codes].tolist())

    def mode_at(self, segment: int) -> Mode:
        """Return the mode of one segment without looking at the others, as `modes` has it."""
        code = self.codes_of(np.array([segment]))[0]
        mode: Mode = _MODES[code]
        return mode

    @property
    def polygon(self) -> Floats:
        """The polygon to draw: the control points, the first one repeated when the curve is closed."""
        points = self.control_points
        return np.concatenate((points, points[:1])) if self.closed else points

    @cached_property
    def joint_form(self) -> joints.Segments:
        """Every segment as the evaluations take it, made when first needed."""
        return joints.all_segments(self)

    @cached_property
    def features(self) -> Floats:
        """What the samples of each segment are combined of, (d, segment_count, features); see `sampling`."""
        return sampling.features(self.joint_form, self.degree)

    @cached_property
    def boxes(self) -> tuple[Floats, Floats]:
        """Corners of a box around each segment, coordinate-major; `segment_bounds` explains them."""
        return enclosures.boxes(self.joint_form, self.degree)

    @cached_property
    def turning(self) -> Floats:
        """A bound of the second derivative's length along each segment, (segment_count,)."""
        return enclosures.turning(self.joint_form, self.degree)

    # Points on it

    def __call__(self, u: ArrayLike, nu: int = 0, side: Literal["left", "right"] = "right") -> Floats:
        """Return points of the curve, or derivatives with respect to u.

        Parameters
        ----------
        u : array_like
            Parameters within `domain`; u = s + t is the point at t of segment s.
        nu : {0, 1, 2, 3}
            Order of the derivative.
        side : {"right", "left"}
            Which segment counts at a joint: the one beginning there or the one ending there. At the end of
            the domain the last segment counts on either side.

        Returns
        -------
        ndarray, shape (..., d)

        Raises
        ------
        ValueError
            If a parameter lies outside the domain, or `nu` or `side` is none of the values above.
        """
        check_order(nu)
        if side not in ("left", "right"):
            raise ValueError(f'side must be "left" or "right", not {side!r}')
        u = np.asarray(u, dtype=np.float64)
        count = self.segment_count
        outside = ~((u >= 0) & (u <= count))
        if outside.any():
            raise ValueError(f"u = {float(u[outside].flat[0])} lies outside the curve's domain, 0 to {count}")
        if side == "right":
            segment = np.minimum(np.floor(u), count - 1)
        else:
            segment = np.maximum(np.ceil(u) - 1, -1 if self.closed else 0)
        t = (u - segment).ravel()
        where = segment.astype(np.intp).ravel() % count
        values = joints.evaluate(joints.take_segments(self, where), t, self.degree, nu)
        return np.ascontiguousarray(values.T).reshape(*u.shape, self.dimension)

    @property
    def joints(self) -> Floats:
        """The joints in order, (segment_count + 1, d); (segment_count, d) when the curve is closed."""
        return self(np.arange(self.segment_count + (not self.closed)))

    def sample(self, per_segment: int = 16, out: Floats | None = None) -> Floats:
        """Return points at `per_segment` equal steps of t along every segment, and the last point.

        Parameters
        ----------
        per_segment : int
            Steps in each segment, at least 1.
        out : ndarray, optional
            C-contiguous float64 array of shape (d, N) to write into, which saves most of the time.

        Returns
        -------
        ndarray, shape (N, d)
            N = segment_count·per_segment + 1 points, the transpose of `out`. Those of a closed curve end with
            the very point they began with.

        Raises
        ------
        ValueError
            If `per_segment` is not a positive integer or `out` does not fit.
        """
        return sampling.sample(self, per_segment, out)

    # Other curves made from it

    def with_(
        self,
        *,
        control_points: ArrayLike | None = None,
        lambdas: ArrayLike | None = None,
        degree: int | None = None,
        closed: bool | None = None,
        ends: Ends | None = None,
    ) -> Self:
        """Return the curve with these attributes changed and the others kept.

        With a new degree, and no new `lambdas`, every λ at the old degree's interpolating value moves to the
        new degree's. A new number of control points needs new `lambdas` as well.

        Raises
        ------
        ValueError
            As the constructor does.
        """
        changes: dict[str, object] = {}
        if degree is not None:
            check_degree(degree)
            changes["degree"] = int(degree)
            if lambdas is None and degree != self.degree:
                interpolating = self.lambdas == INTERPOLATING[self.degree]
                changes["lambdas"] = np.where(interpolating, INTERPOLATING[degree], self.lambdas)
        if closed is not None:
            checks.check_closed(closed)
            changes["closed"] = bool(closed)
        if ends is not None:
            changes["ends"] = ends
        points = self.control_points
        if control_points is not None:
            changes["control_points"] = points = checks.clean_points(control_points)
        count = len(points)
        if lambdas is not None:
            changes["lambdas"] = checks.clean_lambdas(lambdas, count)
        elif count != len(self.lambdas):
            raise ValueError(f"{count} control points need as many λ, but the curve has {len(self.lambdas)}")
        changed = self._replaced(**changes)
        checks.check_count(count, changed.degree, changed.closed, changed.ends)
        return changed

    def with_points(self, indices: ArrayLike, values: ArrayLike) -> Self:
        """Return the curve with some control points moved.

        Parameters
        ----------
        indices : int or array_like of int, shape (k,)
            Which control points, from 0.
        values : array_like
            Their new coordinates, (k, d) or broadcasting to it.

        Raises
        ------
        ValueError
            If there is no such control point, or the coordinates are not acceptable.
        """
        where = checks.clean_indices(indices, len(self.control_points), "control point")
        new = checks.clean_values(values, "new control points", (len(where), self.dimension))
        checks.check_coordinates(new, where)
        points = self.control_points.copy()
        points[where] = new
        return self._replaced(control_points=points)

    def with_lambdas(self, indices: ArrayLike, values: ArrayLike) -> Self:
        """Return the curve with the λ of some control points changed.

        Parameters
        ----------
        indices : int or array_like of int, shape (k,)
            Which control points, from 0.
        values : array_like
            Their new λ, (k,) or one for all.

        Raises
        ------
        ValueError
            If there is no such control point, or a λ is not acceptable.
        """
        where = checks.clean_indices(indices, len(self.control_points), "control point")
        new = checks.clean_values(values, "new λ", (len(where),))
        checks.check_lambdas(new, where)
        lambdas = self.lambdas.copy()
        lambdas[where] = new
        return self._replaced(lambdas=lambdas)

    def with_mode(self, segments: ArrayLike, mode: Mode) -> Self:
        """Return the curve with some segments made trigonometric, hyperbolic or interpolating.

        Both λ of each segment change; the neighbours share them and become blends unless they agree.

        Parameters
        ----------
        segments : int or array_like of int
            Which segments, from 0.
        mode : Mode
            Any but ``Mode.BLEND``.

        Raises
        ------
        ValueError
            If there is no such segment, or the mode is a blend.
        """
        lam = lambda_of(mode, self.degree)
        where = checks.clean_indices(segments, self.segment_count, "segment") + self.first_segment
        both = np.concatenate((where, where + 1)) % len(self.control_points)
        if self.active_lambdas.any():
            both = both[self.active_lambdas[both]]
        return self.with_lambdas(both, lam)

    def reversed(self) -> Self:
        """Return the same curve run through backwards, its control points in reverse order.

        Point u lies where point segment_count − u did; on a closed cubic, where segment_count − 1 − u did,
        counted round.
        """
        lambdas = self.lambdas[::-1]
        if self.degree == 2:
            lambdas = np.roll(lambdas, 1)
        return self._replaced(
            control_points=self.control_points[::-1].copy(), lambdas=np.ascontiguousarray(lambdas)
        )


def _same(a: Floats, b: Floats) -> bool:
    return a is b or np.array_equal(a, b)
