"""Flipping, aligning and distributing control points."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from theditor.canvas.arrange import aligned, arrange, distributed, flipped

clouds = arrays(np.float64, st.tuples(st.integers(2, 8), st.just(2)), elements=st.floats(-1e6, 1e6))
axes = st.sampled_from([0, 1])


@given(clouds, axes)
def test_flipping_keeps_the_box_and_twice_is_nothing(points, axis):
    once = flipped(axis)(points)
    assert once[:, 1 - axis].tolist() == points[:, 1 - axis].tolist()
    assert np.allclose([once.min(axis=0), once.max(axis=0)], [points.min(axis=0), points.max(axis=0)])
    assert np.allclose(flipped(axis)(once), points, rtol=0, atol=1e-9)


@given(clouds, axes, st.sampled_from([0.0, 0.5, 1.0]))
def test_aligned_points_share_a_coordinate_of_their_box(points, axis, share):
    result = aligned(axis, share)(points)
    x = points[:, axis]
    assert np.ptp(result[:, axis]) == 0
    assert result[0, axis] == pytest.approx(x.min() + share * np.ptp(x), abs=1e-9)
    assert result[:, 1 - axis].tolist() == points[:, 1 - axis].tolist()


@given(clouds, axes)
def test_distributed_points_are_evenly_spaced_in_their_order(points, axis):
    result = distributed(axis)(points)
    x, new = points[:, axis], result[:, axis]
    gaps = np.diff(np.sort(new))
    assert np.allclose(gaps, np.ptp(x) / (len(x) - 1), atol=1e-9)
    assert all(new[i] <= new[j] + 1e-9 for i in range(len(x)) for j in range(len(x)) if x[i] < x[j])


def test_only_the_selected_points_are_arranged_in_one_step(canvas):
    before = canvas.document.drawing[0].curve.control_points
    canvas.selection.select(points={1, 3})
    arrange(canvas.document, canvas.selection, "Align left", aligned(0, 0.0))
    after = canvas.document.drawing[0].curve.control_points
    assert after[[1, 3], 0].tolist() == [1.0, 1.0]
    assert np.delete(after, [1, 3], axis=0).tolist() == np.delete(before, [1, 3], axis=0).tolist()
    assert canvas.document.undo_stack.undoText() == "Align left: 2 control points"
    canvas.selection.select(points=())
    arrange(canvas.document, canvas.selection, "Flip horizontally", flipped(0))
    assert canvas.document.drawing[0].curve.control_points[0, 0] == pytest.approx(8.0)
