"""How the time of a change of degree grows with the number of control points.

    pytest tests/benchmarks/test_degrees.py -n 0

prints the time for 10⁵ control points, as a multiple of that for 10³ and a hundredth of it (1 where the cost is
proportional to their number), and as a multiple of evaluating the curve at as many parameters as the refit has
targets, 10 a segment. Times on a busy machine mean little, so nothing here fails on them; processor time is compared.
"""

import time

import numpy as np
import pytest
from large import scribble, spiral
from paired import fastest

from theditor.spline import with_degree


@pytest.mark.parametrize("drawing", [spiral, scribble])
@pytest.mark.parametrize("degree", [2, 3])
def test_change_of_degree(drawing, degree, report):
    small, large = (drawing(count)[0].curve.with_(degree=5 - degree) for count in (1000, 100_000))
    u = np.linspace(0, large.segment_count, 10 * large.segment_count + 1)
    few, many, once = fastest(
        lambda: with_degree(small, degree),
        lambda: with_degree(large, degree),
        lambda: large(u),
        rounds=2,
        clock=time.process_time,
    )
    report(
        f"{drawing.__name__} to degree {degree}: 10⁵ points in {many:.1f} s "
        f"= {many / few / 100:.2f} × 100 × 10³ points = {many / once:.0f} evaluations"
    )
