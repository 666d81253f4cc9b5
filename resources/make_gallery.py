"""Write the drawings of the gallery from exact formulas: ``python resources/make_gallery.py``.

The figures are those of J. Xie, "A Geometric Modeling Method Based on TH-Type Uniform B-Splines",
Mathematical Problems in Engineering 2014, 242469. Titles, descriptions and order: ``gallery/index.json``.

A curve of known equation is given as a formula in t, c and s, affine in each, where c, s stand for cos(πt/2),
sin(πt/2) (trigonometric) or cosh t, sinh t (hyperbolic). With c and s enlarged, the same formula at whole t
gives the control points, for a chain of any length, as these spaces are invariant under translation in t.
"""

from collections.abc import Callable
from math import cos, cosh, pi, sin, sinh, tanh
from pathlib import Path

from theditor.drawing import Drawing, Item, save
from theditor.spline import INTERPOLATING, Curve

GALLERY = Path(__file__).parent / "gallery"

# Colours of a second curve and of guide lines, at least 3:1 against a white and a near-black ground.
SECOND, GUIDE = "#C2417A", "#7C8796"

Points = list[tuple[float, ...]]
Formula = Callable[[float, float, float], tuple[float, ...]]

T, H = 0.0, 1.0


def quarters(j: int) -> tuple[float, float]:
    """Return the exact cosine and sine of j quarter turns."""
    return (1.0, 0.0, -1.0, 0.0)[j % 4], (0.0, 1.0, 0.0, -1.0)[j % 4]


def trigonometric(formula: Formula, segments: int) -> Points:
    """Return control points of a trigonometric cubic with t from 0 to `segments`."""
    return [formula(j, *(pi / 2 * x for x in quarters(j))) for j in range(-1, segments + 2)]


def hyperbolic(formula: Formula, start: int, end: int) -> Points:
    """Return control points of a hyperbolic cubic with t from `start` to `end`."""
    return [formula(j, cosh(j) / sinh(1), sinh(j) / sinh(1)) for j in range(start - 1, end + 2)]


def hyperbolic_quadratic(formula: Formula, start: int, end: int) -> Points:
    """Return control points of a hyperbolic quadratic, t from `start` to `end`; the formula may not use t."""
    middles = [j - 0.5 for j in range(start, end + 2)]
    return [formula(t, cosh(t) / cosh(0.5), sinh(t) / cosh(0.5)) for t in middles]


def moved(points: Points, x: float, y: float) -> Points:
    """Return plane points shifted by (x, y)."""
    return [(px + x, py + y) for px, py in points]


# Figures 1 to 4: what λ does, on one polygon with a steep edge P₂P₃ and a sharp turn at P₅

POLYGON: Points = [
    (0.0, 1.0), (0.5, 3.5), (2.5, 4.5), (3.5, 0.0), (5.0, 0.0),
    (6.0, 4.5), (7.0, 0.0), (9.0, 0.5), (9.5, 3.0),
]  # fmt: skip


def shaped(degree: int, lambdas: dict[int, float], name: str) -> Drawing:
    """Return the polygon's curve with every λ = 0.5, and another where some λ differ."""
    even = Curve(POLYGON, 0.5, degree)
    other = even.with_lambdas(list(lambdas), list(lambdas.values()))
    return Drawing([Item(even, "λ = 0.5 everywhere"), Item(other, name, SECOND)])


# Figures 5 to 8 and the known curves

RECTANGLE: Points = [(2.0, 1.0), (-2.0, 1.0), (-2.0, -1.0), (2.0, -1.0)]
DIAMOND: Points = [(2.0 * c * pi / 2, s * pi / 2) for c, s in map(quarters, range(4))]


def trochoid(radius: float, arm: float) -> Formula:
    """Return the path of a point `arm` from the centre of a rolling circle, starting at the lowest point."""
    return lambda t, c, s: (radius * pi / 2 * t - arm * s, radius - arm * c)


def right_branch(t: float, c: float, s: float) -> tuple[float, ...]:
    """Return x² − y² = 1 with x > 0."""
    return c, s


def left_branch(t: float, c: float, s: float) -> tuple[float, ...]:
    """Return x² − y² = 1 with x < 0."""
    return -c, s


def catenary(t: float, c: float, s: float) -> tuple[float, ...]:
    """Return the curve y = cosh x."""
    return t, c


def ellipses() -> Drawing:
    """Return one ellipse as a quadratic and beside it as a cubic."""
    return Drawing(
        [
            Item(Curve(moved(RECTANGLE, -3.0, 0.0), T, degree=2, closed=True), "Quadratic"),
            Item(Curve(moved(DIAMOND, 3.0, 0.0), T, closed=True), "Cubic", SECOND),
        ]
    )


def hyperbola(reach: int) -> list[Item]:
    """Return both branches of a hyperbola, t from −reach to reach, one quadratic and one cubic."""
    return [
        Item(Curve(hyperbolic(right_branch, -reach, reach), H), "Right branch, cubic"),
        Item(Curve(hyperbolic_quadratic(left_branch, -reach, reach), H, 2), "Left branch, quadratic", SECOND),
    ]


def asymptotes(reach: float) -> list[Item]:
    """Return the lines y = x and y = −x as straight clamped cubics."""
    return [
        Item(
            Curve([(-reach, -slope * reach), (reach, slope * reach)], ends="clamped"),
            name,
            GUIDE,
            1.0,
            locked=True,
        )
        for slope, name in ((1.0, "Asymptote y = x"), (-1.0, "Asymptote y = −x"))
    ]


def on_line(radius: float, arm: float, segments: int, name: str) -> Drawing:
    """Return a trochoid and the line that its circle rolls on."""
    length = radius * pi / 2 * segments
    return Drawing(
        [
            Item(Curve(trigonometric(trochoid(radius, arm), segments), T), name),
            Item(
                Curve([(0.0, 0.0), (length, 0.0)], ends="clamped"), "Line rolled on", GUIDE, 1.0, locked=True
            ),
        ]
    )


def cycloids() -> Drawing:
    """Return one arch of the curve that the paper calls a cycloid, and one of a cycloid."""
    return Drawing(
        [
            Item(Curve(trigonometric(trochoid(2 / pi, 1.0), 4), T), "The paper's curve"),
            Item(Curve(trigonometric(trochoid(2 / pi, 2 / pi), 4), T), "Cycloid", SECOND),
        ]
    )


# Figures 9 and 10: several kinds of segment in one curve


def figure_9() -> Curve:
    """Return a closed quadratic with elliptic, hyperbolic and interpolating segments."""
    low, high, inset = tanh(0.5), sinh(1.5) / cosh(0.5), 4.0 - 2.0 * cosh(1)
    points: Points = [(-3.0, low), (-3.0, -low), (3.0, -low), (3.0, low), (inset, high), (-inset, high)]
    through = INTERPOLATING[2]
    return Curve(points, [through, T, T, H, H, through], degree=2, closed=True)


def figure_10() -> Curve:
    """Return an open cubic with a trochoid, an interpolating segment, a catenary and an ellipse."""
    rolled = trigonometric(lambda t, c, s: (t - s, 1.0 - c), 1)
    catenary_segment = hyperbolic(lambda t, c, s: (-t, 1.0 + c), -1, 0)
    hyperbola_segment = hyperbolic(lambda t, c, s: (-s, 1.0 + c), 0, 1)
    ellipse = trigonometric(lambda t, c, s: (-2.0 + s, -c / 2), 1)
    # The hyperbola goes on from the catenary: its first three points are the catenary's last three.
    points = rolled + catenary_segment + hyperbola_segment[3:] + ellipse
    through = INTERPOLATING[3]
    return Curve(points, [T, T, T, through, through, H, H, H, H, 0.5, T, T, T])


# A curve through its control points


def star() -> Drawing:
    """Return a closed curve through the corners of a star, and one without λ* for comparison."""
    radii = (3.0, 1.5) * 5
    corners: Points = [(r * sin(pi * k / 5), r * cos(pi * k / 5)) for k, r in enumerate(radii)]
    through = Curve(corners, INTERPOLATING[3], closed=True)
    return Drawing(
        [Item(through, "λ* everywhere"), Item(through.with_(lambdas=T), "λ = 0 everywhere", SECOND)]
    )


def pictures() -> dict[str, Drawing]:
    """Return every drawing of the gallery by its name."""
    alone = {
        "figure-08": Item(Curve(hyperbolic(catenary, -1, 1), H), "Catenary"),
        "figure-09": Item(figure_9(), "Figure 9"),
        "figure-10": Item(figure_10(), "Figure 10"),
        "ellipse-quadratic": Item(Curve(RECTANGLE, T, degree=2, closed=True), "Ellipse"),
        "ellipse-cubic": Item(Curve(DIAMOND, T, closed=True), "Ellipse"),
        "catenary": Item(Curve(hyperbolic(catenary, -2, 2), H), "Catenary"),
        "exponential": Item(Curve(hyperbolic(lambda t, c, s: (t, c + s), -3, 1), H), "y = exp x"),
        "sine": Item(Curve(trigonometric(lambda t, c, s: (pi / 2 * t, s), 8), T), "y = sin x"),
        "helix": Item(Curve(trigonometric(lambda t, c, s: (c, s, t / 4), 12), T), "Helix"),
    }
    return {name: Drawing([item]) for name, item in alone.items()} | {
        "figure-01": shaped(2, {3: -1.0}, "λ₃ = −1"),
        "figure-02": shaped(3, {5: -1.0}, "λ₅ = −1"),
        "figure-03": shaped(2, {5: INTERPOLATING[2], 6: INTERPOLATING[2]}, "λ₅ = λ₆ = λ*"),
        "figure-04": shaped(3, {5: INTERPOLATING[3]}, "λ₅ = λ*"),
        "figure-05": ellipses(),
        "figure-06": Drawing(hyperbola(1)),
        "figure-07": cycloids(),
        "hyperbola": Drawing(hyperbola(2) + asymptotes(4.0)),
        "interpolating": star(),
        "cycloid": on_line(1.0, 1.0, 12, "Cycloid"),
        "trochoid-prolate": on_line(0.5, 1.0, 12, "Prolate trochoid"),
        "trochoid-curtate": on_line(1.0, 0.5, 12, "Curtate trochoid"),
    }


def main() -> None:
    """Write all files."""
    for name, drawing in pictures().items():
        save(drawing, GALLERY / f"{name}.json")


if __name__ == "__main__":
    main()
