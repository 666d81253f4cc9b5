import numpy as np
import pytest

from theditor.spline import Curve, nearest, remove
from theditor.spline.deviation import deviation


@pytest.mark.parametrize("degree", [2, 3])
def test_where_a_part_is_gone_other_parts_of_the_curve_count(degree):
    # A part of a spiral is cut short, so what is nearest to it are the turns beside it, and not where it was.
    turns = np.sqrt(np.arange(1, 161) / np.pi)
    angle = 2 * np.pi * turns
    spiral = Curve(turns[:, None] * np.stack((np.cos(angle), np.sin(angle)), axis=1), 0.3, degree)
    cut = remove(spiral, np.arange(80, 110))
    whole = [(0, spiral.segment_count), (0, cut.curve.segment_count)]
    # Farther away the curves are the same.
    across = [c(np.arange(70, end, 0.25)) for c, end in ((spiral, 120), (cut.curve, 90))]
    far = max(nearest(cut.curve, across[0])[1].max(), nearest(spiral, across[1])[1].max())
    for told in (cut.deviation, deviation(spiral, cut.curve, *whole)):
        assert far * (1 - 1e-9) <= told <= far * 1.05
