"""How fast a drawing of 10⁵ points is written in foreign formats, beside writing the numbers alone.

    pytest tests/benchmarks/test_exchange.py -n 0

prints each time, and as a multiple of what Python takes to write as many numbers as the SVG has to the last digit
(`repr`). Times on a busy machine mean little, so nothing here fails on them; processor time is compared.
"""

import time

import pytest
from large import spiral
from paired import fastest

from theditor.exchange import Options, write
from theditor.spline import outline


@pytest.fixture(scope="module")
def drawing():
    return spiral()


def test_conversion(drawing, report):
    curve = drawing[0].curve
    size = float(max(curve.control_points.max(axis=0) - curve.control_points.min(axis=0)))
    for part in (1e-4, 1e-6, 1e-8):
        pieces = outline(curve, part * size)
        (ours,) = fastest(lambda part=part: outline(curve, part * size), rounds=3, clock=time.process_time)
        report(
            f"{len(pieces.kinds):,} pieces within {part:g} of the size: {ours:.2f} s; "
            f"measured {pieces.deviation / size:.1e}"
        )


@pytest.mark.parametrize("suffix", [".svg", ".dxf", ".tex", ".csv"])
def test_writing(drawing, suffix, report):
    numbers = outline(drawing[0].curve).inner.ravel().tolist() * 2
    options = Options(samples=2)
    plain, ours = fastest(
        lambda: ",".join(map(repr, numbers)),
        lambda: write(drawing, suffix, options),
        rounds=2,
        clock=time.process_time,
    )
    report(f"10⁵ points as {suffix}: {ours:.2f} s = {ours / plain:.1f} × the numbers alone")
