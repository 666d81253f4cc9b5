"""The certificate of a curve: its joints as rows of a table, and all of them in one sentence."""

from collections.abc import Callable, Iterator
from typing import Final

import numpy as np

from theditor.spline.continuity import Continuity, JointReport
from theditor.spline.numerals import counted, position

_POWERS: Final = "⁰¹²"


def _jump(order: int) -> Callable[[JointReport], str]:
    return lambda joint: small(joint.relative_jumps[order])


def _position(joint: JointReport) -> str:
    return position(joint.position)


def _curvature(joint: JointReport) -> str:
    # At a joint without velocity there is no curvature that could jump.
    return "—" if np.isnan(joint.curvature_jump) else small(abs(joint.curvature_jump))


def _measured(joint: JointReport) -> str:
    return f"{_order('C', joint.order)} {_order('G', joint.geometric_order)}"


def _promised(joint: JointReport) -> str:
    promised = _order("C", joint.promised)
    if not joint.holds:
        return f"✗ {promised} fails"
    return f"✓ {promised}" + (", still" if joint.still else ", reversed" if joint.note else "")


COLUMNS: Final[tuple[tuple[str, str, Callable[[JointReport], str]], ...]] = (
    ("Joint", "Its number: that of its λ", lambda joint: str(joint.number)),
    ("Position", "Where it is", _position),
    ("Jump of C", "Jump of the position, relative to the size of what it is made of", _jump(0)),
    ("of C′", "Jump of the first derivative, relative to the size of what it is made of", _jump(1)),
    ("of C″", "Jump of the second derivative, relative to the size of what it is made of", _jump(2)),
    ("of κ", "Jump of the curvature, in 1 / unit", _curvature),
    ("Measured", "How smooth it is: by its derivatives (C) and as a shape (G)", _measured),
    ("Promised", "What the theory promises, and whether that holds", _promised),
)
"""Title, explanation, and the text for a joint."""


def table(report: Continuity) -> list[str]:
    """Return the titles and one line for each joint, in columns."""
    rows = [[title for title, _, _ in COLUMNS], *([text(joint) for *_, text in COLUMNS] for joint in report)]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return ["  ".join(map(str.ljust, row, widths)).rstrip() for row in rows]


def summary(report: Continuity) -> str:
    """Return whether all joints keep what the theory promises, how exactly, and at how many the curvature jumps.

    Notes, where the curve stands still, are counted; `JointReport` tells them one by one.
    """
    count = len(report)
    if not count:
        return "no joints: the curve is one segment"
    promise = f"C{_POWERS[report.promised]}"
    failing = int(np.count_nonzero(~report.holds))
    if failing:
        verdict = f"{failing} of {counted(count, 'joint')} {'fails' if failing == 1 else 'fail'} the promised {promise}"
    elif count == 1:
        verdict = f"1 joint, {promise} as promised"
    else:
        verdict = f"{counted(count, 'joint')}, all {promise} as promised"
    largest = float(report.relative_jumps[:, : report.promised + 1].max())
    limit = f"within {small(report.tolerance)} of the size of the terms"
    parts = [f"{verdict} {limit} (largest jump {small(largest)})"]
    still = int(np.count_nonzero(report.still))
    jumping = int(np.count_nonzero((report.geometric_order < 2) & ~report.still))
    if still:
        parts.append(f"the curve stands still at {still}")
    if jumping:
        parts.append(f"the curvature jumps at {jumping}")
    return "; ".join(parts)


def remarkable(report: Continuity) -> Iterator[JointReport]:
    """Yield the joints where a promise fails, then those where the curve stands still or a λ reverses it."""
    rows = np.flatnonzero(report.still | ~report.holds | np.isin(report.joint, list(report.reversals)))
    failing_first = rows[np.argsort(report.holds[rows], kind="stable")]
    return (report[row] for row in failing_first.tolist())


def small(size: float) -> str:
    """Write a jump: 0, 3e−16, 0.25; of what is near rounding the power tells enough."""
    return f"{size:{'.1g' if size < 1e-4 else '.2g'}}".replace("e-0", "e-").replace("-", "−")


def _order(kind: str, order: int) -> str:
    return f"{kind}{_POWERS[order]}" if order >= 0 else "—"
