"""How fast a large curve is sampled, beside two yardsticks.

    pytest tests/benchmarks/test_evaluation.py -n 0 -s

prints, for 10⁵ segments × 16 samples in the plane, the time of `Curve.sample` with `out` given, as a multiple of
copying an array as large (the limit for anything that writes its result), and how many times longer
`scipy.interpolate.BSpline` takes for as many points of an ordinary B-spline of that degree. The aim is at most
1.25 copies and at least 15 times the speed of SciPy. Times on a busy machine mean little, so nothing here fails
on them; the fastest of several rounds is compared. The rest is what a canvas does in one frame.
"""

import numpy as np
import pytest
from scipy.interpolate import BSpline

from theditor.spline import Curve, changed_segments, evaluate_segments, sample_adaptively

SEGMENTS, PER_SEGMENT = 100_000, 16
POINTS = SEGMENTS * PER_SEGMENT + 1

fastest: dict[tuple[str, int], float] = {}

pytestmark = pytest.mark.benchmark(min_rounds=5, max_time=1.0, warmup=True, warmup_iterations=1)


@pytest.fixture(params=[2, 3], ids=["quadratic", "cubic"])
def curve(request):
    rng = np.random.default_rng(0)
    count = SEGMENTS + request.param
    steps = rng.normal(size=(count, 2))
    return Curve(steps.cumsum(axis=0), rng.uniform(-3, 9, count), request.param)


def note(benchmark, name, degree):
    if benchmark.stats:
        fastest[name, degree] = benchmark.stats.stats.min


def test_copy(benchmark, curve):
    out, source = np.empty((2, POINTS)), np.ones((2, POINTS))
    benchmark(np.copyto, out, source)
    note(benchmark, "copy", curve.degree)


def test_sample(benchmark, curve):
    out = np.empty((2, POINTS))
    samples = benchmark(curve.sample, PER_SEGMENT, out)
    np.testing.assert_allclose(samples[::PER_SEGMENT], curve.joints, rtol=0, atol=1e-10)
    note(benchmark, "sample", curve.degree)


def test_scipy(benchmark, curve):
    knots = np.arange(SEGMENTS + 2 * curve.degree + 1.0) - curve.degree
    ordinary = BSpline(knots, curve.control_points, curve.degree)
    benchmark(ordinary, np.linspace(0, SEGMENTS, POINTS))
    note(benchmark, "scipy", curve.degree)


@pytest.mark.parametrize("degree", [2, 3], ids=["quadratic", "cubic"])
def test_ratios(degree, capsys):
    try:
        copy, sample, scipy = (fastest[name, degree] for name in ("copy", "sample", "scipy"))
    except KeyError:
        pytest.skip("needs the times of the tests above")
    with capsys.disabled():
        kind = "quadratic" if degree == 2 else "cubic"
        print(f"\n{kind}: sample = {sample / copy:.2f} × copy, SciPy = {scipy / sample:.1f} × sample")


def test_dragging_one_point(benchmark, curve):
    def drag():
        moved = curve.with_points(500, (0.0, 0.0))
        return evaluate_segments(moved, changed_segments(curve, moved), PER_SEGMENT)

    assert len(benchmark(drag)) == curve.degree + 1


@pytest.mark.parametrize("pixels", [1000, 10_000], ids=["fitted", "zoomed in tenfold"])
def test_zooming(benchmark, curve, pixels):
    low, high = curve.control_points.min(axis=0), curve.control_points.max(axis=0)
    tolerance = (high - low).max() / pixels / 4
    drawn = benchmark(sample_adaptively, curve, tolerance, low, high)
    assert len(drawn.segments) > SEGMENTS * 0.99
