import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from theditor.spline.polylines import nearest_on_line


@given(st.integers(0, 2**32 - 1), st.integers(2, 200), st.integers(1, 40), st.integers(2, 3))
def test_no_place_on_a_polyline_is_nearer_than_the_one_found(seed, count, size, dimension):
    rng = np.random.default_rng(seed)
    line = np.round(np.cumsum(rng.normal(size=(count, dimension)), axis=0), 1)
    points = rng.normal(scale=5, size=(size, dimension))
    places, distances = nearest_on_line(points, line)
    edge = np.minimum(np.floor(places).astype(int), count - 2)
    feet = line[edge] + (places - edge)[:, None] * (line[edge + 1] - line[edge])
    np.testing.assert_allclose(np.linalg.norm(feet - points, axis=1), distances, atol=1e-12)
    t = np.linspace(0, 1, 33)[:, None, None]
    every = (1 - t) * line[:-1] + t * line[1:]
    least = np.linalg.norm(every[:, :, None] - points, axis=3).min(axis=(0, 1))
    assert (distances <= least + 1e-12).all()
