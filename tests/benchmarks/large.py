"""Large drawings like those that people make: long spirals, many curves, tight scribbles.

    python tests/benchmarks/large.py spiral large.json

writes one to a file, to be looked at in the window; the names are those of `DRAWINGS`.
"""

import sys

import numpy as np

from theditor.drawing import Drawing, Item, save
from theditor.spline import INTERPOLATING, Curve

RUN = 40
"""About as many neighbouring control points have λ of the same kind."""


def lambdas(rng, count, degree=3):
    """λ of `count` control points: runs of T, H, λ* and of values in between."""
    runs = count // RUN + 1
    values = rng.choice([0.0, 1.0, INTERPOLATING[degree], np.nan], runs, p=[0.4, 0.25, 0.15, 0.2])
    lengths = rng.integers(RUN // 2, 2 * RUN, runs)
    spread = np.resize(np.repeat(values, lengths), count)
    return np.where(np.isnan(spread), rng.uniform(-3, 3, count), spread)


def spiral(count=100_000, seed=0):
    """One curve that winds outward, as far from turn to turn as from point to point."""
    turns = np.sqrt(np.arange(1, count + 1) / np.pi)
    angles = 2 * np.pi * turns
    points = turns[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return Drawing([Item(Curve(points, lambdas(np.random.default_rng(seed), count)), name="Spiral")])


def many_curves(curves=1000, count=100, seed=0):
    """Wavy curves of both degrees in rows and columns, some closed, in several colours."""
    rng = np.random.default_rng(seed)
    columns = int(np.ceil(np.sqrt(curves)))
    angles = np.arange(count) * 2 * np.pi / count
    items = []
    for index in range(curves):
        waves = rng.normal(size=(3, 2)) / np.arange(2, 5)[:, None]
        radius = 1 + waves[:, 0] @ np.sin(np.outer(np.arange(2, 5), angles)) * 0.5
        points = radius[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1) + waves[0]
        points += np.array([index % columns, index // columns]) * 3.0
        degree, colour = int(rng.integers(2, 4)), rng.choice(["#334155", "#0072B2", "#8A4B08", "#7A5AC8"])
        curve = Curve(
            points, lambdas(rng, count, degree), degree, closed=bool(rng.integers(2)), ends="clamped"
        )
        items.append(Item(curve, name=f"Curve {index + 1}", color=str(colour)))
    return Drawing(items)


def scribble(count=100_000, seed=0):
    """One curve of small loops that run to and fro in rows, like writing, with an unsteady hand."""
    rng = np.random.default_rng(seed)
    rows = max(1, round(np.sqrt(count / 60)))
    along = np.linspace(0, rows, count, endpoint=False)
    row, place = np.floor(along), along % 1
    place = np.where(row % 2, 1 - place, place) * rows * 3
    angle = np.arange(count) * 2 * np.pi / 7.3
    loops = rng.uniform(0.6, 1.4, (count, 1)) * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    points = np.stack([place, -3.0 * row], axis=1) + loops + rng.normal(scale=0.05, size=(count, 2))
    return Drawing([Item(Curve(points, lambdas(rng, count), ends="clamped"), name="Scribble")])


DRAWINGS = {"spiral": spiral, "many": many_curves, "scribble": scribble}

if __name__ == "__main__":
    save(DRAWINGS[sys.argv[1]](), sys.argv[2])
