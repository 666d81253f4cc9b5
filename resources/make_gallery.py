"""Write the drawings of the gallery from exact formulas: ``python resources/make_gallery.py``.

The figures are those of J. Xie, "A Geometric Modeling Method Based on TH-Type Uniform B-Splines",
Mathematical Problems in Engineering 2014, 242469. Titles, descriptions and order: ``gallery/index.json``.
"""

from math import cos, cosh, pi, sin, sinh, tanh
from pathlib import Path

from theditor.drawing import Drawing, Item, save
from theditor.spline import INTERPOLATING, Curve, known
from theditor.spline.chains import hyperbolic, trigonometric

GALLERY = Path(__file__).parent / "gallery"

# Colours of a first and a second curve and of guide lines, at least 3:1 against a white and a near-black ground.
FIRST, SECOND, GUIDE = "#1F8A8A", "#C2417A", "#7C8796"

Points = list[tuple[float, ...]]

T, H = 0.0, 1.0


# Figures 1 to 4: what λ does, on one polygon with a steep edge P₂P₃ and a sharp turn at P₅

POLYGON: Points = [
    (0.0, 1.0), (0.5, 3.5), (2.5, 4.5), (3.5, 0.0), (5.0, 0.0),
    (6.0, 4.5), (7.0, 0.0), (9.0, 0.5), (9.5, 3.0),
]  # fmt: skip


def shaped(degree: int, lambdas: dict[int, float], name: str) -> Drawing:
    """Return the polygon's curve with every λ = 0.5, and another where some λ differ."""
    even = Curve(POLYGON, 0.5, degree)
    other = even.with_lambdas(list(lambdas), list(lambdas.values()))
    return Drawing([Item(even, "λ = 0.5 everywhere", FIRST), Item(other, name, SECOND)])


# Figures 5 to 8 and the known curves


def ellipses() -> Drawing:
    """Return one ellipse as a quadratic and beside it as a cubic."""
    return Drawing(
        [
            Item(known.ellipse((-3.0, 0.0), degree=2), "Quadratic"),
            Item(known.ellipse((3.0, 0.0)), "Cubic", SECOND),
        ]
    )


def hyperbola(reach: int) -> list[Item]:
    """Return both branches of a hyperbola, t from −reach to reach, one quadratic and one cubic."""
    right = known.hyperbola(start=-reach, units=2 * reach)
    left = hyperbolic((0, 0), (0, 0), (-1, 0), (0, 1), 2 * reach, -reach, degree=2)  # upwards too
    return [Item(right, "Right branch, cubic"), Item(left, "Left branch, quadratic", SECOND)]


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


def on_line(radius: float, arm: float, quarters: int, name: str) -> Drawing:
    """Return a trochoid and the line that its circle rolls on."""
    line = Curve([(0.0, 0.0), (radius * pi / 2 * quarters, 0.0)], ends="clamped")
    return Drawing(
        [
            Item(known.trochoid(radius=radius, arm=arm, quarters=quarters), name),
            Item(line, "Line rolled on", GUIDE, 1.0, locked=True),
        ]
    )


def cycloids() -> Drawing:
    """Return one arch of the curve that the paper calls a cycloid, and one of a cycloid."""
    return Drawing(
        [
            Item(known.trochoid(radius=2 / pi, arm=1.0), "The paper's curve"),
            Item(known.cycloid(radius=2 / pi), "Cycloid", SECOND),
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
    parts = (
        trigonometric((0, 1), (1, 0), (0, -1), (-1, 0)),  # (t − sin, 1 − cos)
        hyperbolic((0, 1), (-1, 0), (0, 1), (0, 0), start=-1),  # (−t, 1 + cosh t)
        hyperbolic((0, 1), (0, 0), (0, 1), (-1, 0)),  # (−sinh t, 1 + cosh t)
        trigonometric((-2, 0), (0, 0), (0, -0.5), (1, 0)),  # (−2 + sin, −cos/2)
    )
    rolled, hanging, branch, arc = (part.control_points.tolist() for part in parts)
    # The hyperbola goes on from the catenary: its first three points are the catenary's last three.
    points = rolled + hanging + branch[3:] + arc
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
        "figure-08": Item(known.catenary(), "Catenary"),
        "figure-09": Item(figure_9(), "Figure 9"),
        "figure-10": Item(figure_10(), "Figure 10"),
        "ellipse-quadratic": Item(known.ellipse(degree=2), "Ellipse"),
        "ellipse-cubic": Item(known.ellipse(), "Ellipse"),
        "catenary": Item(known.catenary(start=-2, units=4), "Catenary"),
        "exponential": Item(known.exponential(), "y = exp x"),
        "sine": Item(known.sine(wavelength=2 * pi), "y = sin x"),
        "helix": Item(known.helix(), "Helix"),
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
