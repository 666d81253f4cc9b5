"""Reading CSV: the points of a table become curves, one for each name in a column ``curve``."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from theditor.drawing import Drawing, DrawingError, Item
from theditor.drawing.drawing import NAME_LENGTH
from theditor.exchange.options import DEFAULTS, Imported, Options, Progress
from theditor.spline import INTERPOLATING, Curve, fit
from theditor.spline.distinct import moves_on
from theditor.spline.numerals import counted

Floats = NDArray[np.float64]

MOST_ROWS: Final = 1_000_000
_MOST_FITTED: Final = 2000  # points of a curve that are fitted; a fit takes its time
_DENSE: Final = np.radians(10)  # points that turn by less are samples of a curve to be found
_NUMBER: Final = r"[+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d+)?"
_AXES: Final = ("x", "y", "z")
_SHAPE: Final = frozenset({"lambda", "λ"})


class _Columns(NamedTuple):
    """Which columns of a table mean something."""

    width: int  # how many there are
    axes: tuple[int, ...]
    shape: int | None = None
    name: int | None = None


class _Row(NamedTuple):
    line: int
    cells: list[str]


def read(data: bytes, options: Options = DEFAULTS, progress: Progress | None = None) -> Imported:
    """Turn a table of points into curves.

    Columns are separated by tabs, else semicolons, else blanks, else commas; where commas do not separate, they
    are decimal signs. Without a header line there are two or three columns: x, y and perhaps z. With one, the
    columns called x, y, z, lambda (or λ) and curve (a name, for several curves) are read in any order, and others
    passed over, so that a table that was written here comes back.

    The points are taken as control points of an open curve if the options say so or the table has λ. Otherwise
    they are points to pass through, round if the last is the first: samples so dense that the chords between them
    keep to the tolerance are fitted within it by fewer control points; each of others becomes a control point
    with λ*, which the curve meets.

    Raises
    ------
    DrawingError
        If the text is no such table, with line and column, or its points make no curve; one sentence.
    """
    rows = _rows(_text(data))
    columns, rows = _header(rows)
    runs = list(_runs(rows, columns))
    items, notes, deviation = [], [], 0.0
    for done, (name, run) in enumerate(runs):
        if progress is not None:
            progress(done / len(runs))
        points, lambdas = _numbers(run, columns)
        try:
            curve, off, note = _curve(points, lambdas, options)
            item = Item(curve, name)
        except ValueError as error:
            first, last = run[0].line, run[-1].line
            what = f"Line {first} makes" if first == last else f"Lines {first} to {last} make"
            raise DrawingError(f"{what} no curve: {error}.") from None
        items.append(item)
        deviation = max(deviation, off)
        notes += [note] if note else []
    return Imported(Drawing(items), deviation, tuple(dict.fromkeys(notes)))


# The table


def _text(data: bytes) -> str:
    wide = data.startswith((b"\xff\xfe", b"\xfe\xff"))  # spreadsheets save "Unicode text" so
    try:
        text = data.decode("utf-16" if wide else "utf-8-sig")
    except UnicodeDecodeError as error:
        raise DrawingError(
            f"The text is not UTF-8 at byte {error.start + 1}: save the table as UTF-8."
        ) from None
    return text.replace("−", "-")


def _rows(text: str) -> list[_Row]:
    lines = [(number, line.strip()) for number, line in enumerate(text.splitlines(), 1) if line.strip()]
    if not lines:
        raise DrawingError("There are no points: the table is empty.")
    if len(lines) > MOST_ROWS:
        raise DrawingError(f"The table has {len(lines)} lines, and {MOST_ROWS} are the most that are read.")
    separator = _separator([line for _, line in lines])
    if separator is None:
        return [_Row(number, line.split()) for number, line in lines]
    rows = []
    for number, line in lines:
        try:
            cells = next(csv.reader([line], delimiter=separator, skipinitialspace=True, strict=True))
        except csv.Error:
            raise DrawingError(
                f"Line {number}, “{_short(line)}”, is no row of a table: check its quotes."
            ) from None
        rows.append(_Row(number, [cell.strip() for cell in cells]))
    return rows


def _separator(lines: Sequence[str]) -> str | None:
    """Return the sign that separates columns, None for blanks."""
    body = lines[1:101] or lines
    for sign in ("\t", ";"):
        if all(sign in line for line in body):
            return sign
    blanks = rf"{_NUMBER}(\s+{_NUMBER})+"
    return "," if any("," in line and not re.fullmatch(blanks, line) for line in body) else None


def _header(rows: list[_Row]) -> tuple[_Columns, list[_Row]]:
    """Return what the columns mean, and the rows without the header."""
    first = rows[0].cells
    if any(re.fullmatch(_NUMBER, cell) for cell in first):
        if len(first) not in (2, 3):
            raise DrawingError(
                f"Line {rows[0].line} has {counted(len(first), 'column')}: without a header line there must be "
                "two or three, for x, y and z."
            )
        return _Columns(len(first), tuple(range(len(first)))), rows
    names = [cell.lower() for cell in first]
    axes = tuple(names.index(axis) for axis in _AXES if axis in names)
    if not {"x", "y"} <= set(names):
        raise DrawingError(
            f"Line {rows[0].line}, “{_short(' '.join(first))}”, is neither a row of numbers nor a header with x and y."
        )
    if len(rows) == 1:
        raise DrawingError("There are no points: the table has a header line alone.")
    shape = next((i for i, name in enumerate(names) if name in _SHAPE), None)
    name = names.index("curve") if "curve" in names else None
    return _Columns(len(first), axes, shape, name), rows[1:]


def _runs(rows: list[_Row], columns: _Columns) -> Iterator[tuple[str, list[_Row]]]:
    """Yield the rows of each curve with its name."""
    if columns.name is None:
        yield "Points", rows
        return
    runs: dict[str, list[_Row]] = {}
    for row in rows:
        name = " ".join(row.cells[columns.name].split()) if columns.name < len(row.cells) else ""
        runs.setdefault(name[:NAME_LENGTH] or "Points", []).append(row)
    yield from runs.items()


def _numbers(rows: list[_Row], columns: _Columns) -> tuple[Floats, Floats | None]:
    """Return the points and, if there are any, λ."""
    wanted = [*columns.axes, *([] if columns.shape is None else [columns.shape])]
    table = np.empty((len(rows), len(wanted)))
    for row, values in zip(rows, table, strict=True):
        if len(row.cells) != columns.width:
            raise DrawingError(
                f"Line {row.line} has {counted(len(row.cells), 'column')}, and the first line has {columns.width}."
            )
        for place, column in enumerate(wanted):
            cell = row.cells[column]
            if not re.fullmatch(_NUMBER, cell):
                what = f"“{_short(cell)}” is no number" if cell else "a number is missing"
                raise DrawingError(f"Line {row.line}, column {column + 1}: {what}.")
            values[place] = float(cell.replace(",", "."))
    signs = {sign for row in rows for column in wanted for sign in ",." if sign in row.cells[column]}
    if len(signs) > 1:
        raise DrawingError("The table has both points and commas as decimal signs: write all numbers alike.")
    points, shape = table[:, : len(columns.axes)], table[:, len(columns.axes) :]
    return points, shape[:, 0] if shape.size else None


def _short(text: str) -> str:
    return text if len(text) <= 40 else f"{text[:39]}…"


# The curves


def _curve(points: Floats, lambdas: Floats | None, options: Options) -> tuple[Curve, float, str]:
    """Return a curve of points, how far it is from them, and what there is to tell of it."""
    if options.control_points or lambdas is not None:
        return Curve(points, 0.0 if lambdas is None else lambdas, options.degree, ends="clamped"), 0.0, ""
    points = points[moves_on(points)]
    closed = len(points) > 3 and bool((points[0] == points[-1]).all())
    if closed:
        points = points[:-1]
    tolerance = options.tolerance * float(np.ptp(points, axis=0).max())
    if len(points) <= _MOST_FITTED and _dense(points, tolerance):
        fitted = fit(points, options.degree, tolerance, closed)
        if fitted.deviation <= tolerance and len(fitted.curve.control_points) < len(points):
            return fitted.curve, fitted.deviation, ""
    if options.degree == 2 and len(points) == 2:
        points = np.insert(points, 1, points.mean(axis=0), axis=0)
    through = Curve(points, INTERPOLATING[options.degree], options.degree, closed, "clamped")
    return through, 0.0, "The curve passes through each point, as λ = λ*."


def _dense(points: Floats, tolerance: float) -> bool:
    """Whether points follow each other closely along a curve, most of them on chords within a tolerance of it.

    Else a fit would have to follow the chords, with more control points than there are points.
    """
    steps = np.diff(points, axis=0)
    if len(steps) < 8:
        return False
    lengths = np.linalg.norm(steps, axis=1)
    cosines = np.einsum("ij,ij->i", steps[:-1], steps[1:]) / (lengths[:-1] * lengths[1:])
    turns = np.arccos(np.clip(cosines, -1, 1))
    heights = np.minimum(lengths[:-1], lengths[1:]) * turns / 8
    return bool(np.median(turns) <= _DENSE and np.median(heights) <= tolerance)
