"""How fast a large curve is sampled, beside two yardsticks, and how little a step of a drag costs.

    pytest tests/benchmarks/test_evaluation.py -n 0

prints, for 10⁴ and 10⁵ segments × 16 samples in the plane, the time of `Curve.sample` with `out` given as a
multiple of copying an array as large, the limit for anything that writes its result (the aim: at most 1.4 and 1.25
copies), and how many times longer `scipy.interpolate.BSpline` takes for as many points on the same polygon (at
least 20). A curve keeps what its samples are combined of, so that sampling it once more is quicker than the first
time. Then it prints what a step of a drag costs, from the old curve to the new samples of what changed, as a share
of sampling all of the new curve (at most 1/10 for 10⁵).

Times on a busy machine mean little, so nothing here fails on them.
"""

import numpy as np
import pytest
from large import spiral
from paired import fastest
from scipy.interpolate import BSpline

from theditor.spline import changed_segments, evaluate_segments

PER_SEGMENT = 16
STEPS = 10


@pytest.fixture(params=[10_000, 100_000], ids=["1e4", "1e5"])
def size(request):
    return request.param


@pytest.fixture(params=[2, 3], ids=["quadratic", "cubic"])
def curve(request, size):
    return spiral(size + request.param)[0].curve.with_(degree=request.param)


@pytest.fixture
def room(curve):
    return np.empty((2, curve.segment_count * PER_SEGMENT + 1))


def test_sampling(curve, room, report):
    count, degree, source = curve.segment_count, curve.degree, np.ones_like(room)
    ordinary = BSpline(np.arange(count + 2 * degree + 1.0) - degree, curve.control_points, degree)
    u = np.linspace(0, count, room.shape[1])
    copy, sample, scipy = fastest(
        lambda: np.copyto(room, source), lambda: curve.sample(PER_SEGMENT, room), lambda: ordinary(u)
    )
    np.testing.assert_allclose(room.T[::PER_SEGMENT], curve.joints, rtol=0, atol=1e-10)
    report(
        f"degree {degree}, {count:,} segments: sampling = {sample / copy:.2f} × copying, "
        f"SciPy = {scipy / sample:.0f} × sampling"
    )


def test_dragging(curve, room, report):
    def moved(step):
        return curve.with_points(500, (0.0, step))

    def reshaped(step):
        return curve.with_lambdas(500, 0.3 + step)

    def drag(made):
        for step in range(STEPS):
            new = made(step)
            evaluate_segments(new, changed_segments(curve, new), PER_SEGMENT)

    assert len(changed_segments(curve, moved(0))) == curve.degree + 1
    assert len(changed_segments(curve, reshaped(0))) == 2
    whole, point, lam = fastest(
        lambda: moved(0).sample(PER_SEGMENT, room), lambda: drag(moved), lambda: drag(reshaped)
    )
    report(
        f"degree {curve.degree}, {curve.segment_count:,} segments: a step of a dragged point = "
        f"{point / STEPS / whole:.3f}, of a dragged λ = {lam / STEPS / whole:.3f} × sampling all of the new curve"
    )
