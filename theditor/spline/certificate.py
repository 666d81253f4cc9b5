"""The continuity of a whole curve in one sentence."""

from collections.abc import Iterator

import numpy as np

from theditor.spline.continuity import Continuity, JointReport

_POWERS = "⁰¹²"


def summary(report: Continuity) -> str:
    """Return whether all joints keep what the theory promises, and at how many the curvature jumps.

    Notes, where the curve stands still, are counted; `JointReport` tells them one by one.
    """
    count = len(report)
    if not count:
        return "no joints: the curve is one segment"
    promise = f"C{_POWERS[report.promised]}"
    failing = int(np.count_nonzero(~report.holds))
    if failing:
        verdict = f"{failing} of {joints(count)} {'fails' if failing == 1 else 'fail'} the promised {promise}"
    elif count == 1:
        verdict = f"1 joint, {promise} as promised"
    else:
        verdict = f"{joints(count)}, all {promise} as promised"
    largest = float(report.relative_jumps[:, : report.promised + 1].max())
    parts = [f"{verdict} (largest jump {largest:.1g})"]
    still = int(np.count_nonzero(report.still))
    jumping = int(np.count_nonzero((report.geometric_order < 2) & ~report.still))
    if still:
        parts.append(f"the curve stands still at {still}")
    if jumping:
        parts.append(f"the curvature jumps at {jumping}")
    return "; ".join(parts)


def remarkable(report: Continuity) -> Iterator[JointReport]:
    """Yield the joints where a promise fails or the curve stands still."""
    return (report[row] for row in np.flatnonzero(report.still | ~report.holds).tolist())


def joints(count: int) -> str:
    """Count joints: ``1 joint``, ``3 joints``."""
    return "1 joint" if count == 1 else f"{count} joints"
