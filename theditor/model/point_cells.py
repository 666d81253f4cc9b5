"""A curve as cells of text: one row per control point, and the curves that edited or pasted cells make. No Qt here.

The columns are x, y, z in space, λ, and the mode of the segment that begins at the point's joint.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from theditor.model.arithmetic import calculated, number_in
from theditor.model.words import MODE_LETTERS, counted, exact, indexed, sentence
from theditor.spline import Curve, Mode
from theditor.spline.distinct import distinct

LAMBDA, MODE = "λ", "Segment"
_WORDS = np.array([mode.value for mode in Mode], dtype=object)  # in the order of `Curve.mode_codes`

_MODES = {
    name.lower(): mode
    for mode, letter in MODE_LETTERS.items()
    for name in (mode.value, letter, mode.value[0])
} | {"*": Mode.INTERPOLATING}


def columns(curve: Curve) -> tuple[str, ...]:
    """Titles of the columns."""
    return (*"xyz"[: curve.dimension], LAMBDA, MODE)


def value(curve: Curve, row: int, column: int) -> float:
    """Return the number in a cell: a coordinate or λ."""
    table = curve.control_points if column < curve.dimension else curve.lambdas[:, None]
    return float(table[row, column if column < curve.dimension else 0])


def segment_at(curve: Curve, row: int) -> int | None:
    """Return the segment that begins at a control point's joint, counted from 0; None if there is none."""
    segment = row - curve.first_segment
    return segment if 0 <= segment < curve.segment_count else None


def mode_at(curve: Curve, row: int) -> Mode | None:
    """Return the mode of the segment that begins at a control point's joint."""
    segment = segment_at(curve, row)
    return None if segment is None else curve.mode_at(segment)


def text(curve: Curve, row: int, column: int) -> str:
    """Return a cell in full: the shortest exact number, or the mode in a word."""
    return texts(curve, np.array([row]), column)[0]


def texts(curve: Curve, rows: NDArray[np.intp], column: int) -> list[str]:
    """Return cells of a column in full."""
    if column < curve.dimension:
        return [exact(number) for number in curve.control_points[rows, column].tolist()]
    if column == curve.dimension:
        return [exact(number) for number in curve.lambdas[rows].tolist()]
    segments = rows - curve.first_segment
    begun = (segments >= 0) & (segments < curve.segment_count)
    words = np.full(len(rows), "", dtype=object)
    words[begun] = _WORDS[curve.codes_of(segments[begun])]
    found: list[str] = words.tolist()
    return found


def cell_name(curve: Curve, row: int, column: int) -> str:
    """Name a cell: ``x of P₅``, ``λ₅``, ``Segment at P₅``."""
    title, point = columns(curve)[column], indexed("P", row)
    if title == MODE:
        return f"{title} at {point}"
    return indexed(LAMBDA, row) if title == LAMBDA else f"{title} of {point}"


def edited(curve: Curve, row: int, column: int, typed: str) -> Curve:
    """Return the curve after a text was typed into a cell; the same curve if that is what the cell held.

    Raises
    ------
    ValueError
        The text cannot stand there; the message is a sentence that says why and what can.
    """
    name = cell_name(curve, row, column)
    if typed == text(curve, row, column):
        return curve
    if columns(curve)[column] == MODE:
        return _with_mode(curve, row, typed, name)
    try:
        number = calculated(typed, value(curve, row, column))
    except ValueError:
        raise ValueError(f"“{typed}” is no number for {name}: type one such as 0.5, 2/3 or +1.5.") from None
    return _with_numbers(curve, column, [row], [number])


def _with_mode(curve: Curve, row: int, typed: str, name: str) -> Curve:
    segment, mode = segment_at(curve, row), _MODES.get(typed.strip().lower())
    if segment is None:
        raise ValueError(f"No segment begins at {indexed('P', row)}: its mode cannot be set.")
    if mode is None:
        raise ValueError(f"“{typed}” is no mode for {name}: type T, H or λ* (or I).")
    return curve.with_mode([segment], mode)


def _with_numbers(curve: Curve, column: int, rows: Sequence[int], numbers: Sequence[float]) -> Curve:
    """Return the curve with numbers in the cells of a column."""
    where = np.array(rows, dtype=np.intp)
    try:
        if column == curve.dimension:
            return curve.with_lambdas(where, numbers)
        points = curve.control_points[where]
        points[:, column] = numbers
        return curve.with_points(where, points)
    except ValueError as error:
        raise ValueError(sentence(str(error))) from None


def copied(curve: Curve, cells: Iterable[tuple[int, NDArray[np.intp]]]) -> str:
    """Write cells for a spreadsheet: tabs between columns, a line per row, every number exact.

    Parameters
    ----------
    cells
        Columns and their rows. Cells between them that are not among these are left empty.
    """
    chosen = {column: rows for column, rows in cells if len(rows)}
    if not chosen:
        return ""
    every = distinct(np.concatenate(list(chosen.values())))
    parts = np.full((len(every), len(chosen)), "", dtype=object)
    for place, column in enumerate(sorted(chosen)):
        parts[np.searchsorted(every, chosen[column]), place] = texts(curve, chosen[column], column)
    return "".join("\t".join(line) + "\n" for line in parts.tolist())


def cells_of(block: str) -> list[list[str]]:
    """Split what a spreadsheet copies into rows of cells, all rows equally long."""
    lines = [line.split("\t") for line in block.removesuffix("\n").splitlines()]
    width = max((len(line) for line in lines), default=0)
    return [line + [""] * (width - len(line)) for line in lines]


def pasted(curve: Curve, row: int, column: int, cells: Sequence[Sequence[str]]) -> Curve:
    """Return the curve with a block of numbers pasted, its first cell at a row and column.

    Empty cells leave what is there. Modes beside pasted λ are passed over: they follow from λ.

    Raises
    ------
    ValueError
        The block does not fit there, or a cell is no number; the message is a sentence that names the place.
    """
    titles, count = columns(curve), len(curve.control_points)
    width = len(cells[0]) if cells else 0
    if not width:
        raise ValueError("There is no text to paste: copy cells in a spreadsheet, or here.")
    if column + width > len(titles):
        room = counted(len(titles) - column, "column")
        raise ValueError(
            f"{counted(width, 'column')} cannot be pasted at {titles[column]}: there is room for {room}."
        )
    if row + len(cells) > count:
        room = counted(count - row, "row")
        place = indexed("P", row)
        raise ValueError(
            f"{counted(len(cells), 'row')} cannot be pasted at {place}: there is room for {room}."
        )
    if titles[column] == MODE:
        raise ValueError("Modes cannot be pasted: paste λ, which they follow from, or type T, H or λ*.")
    for k in range(min(width, len(titles) - 1 - column)):
        filled = [row + i for i, line in enumerate(cells) if line[k].strip()]
        numbers = [_pasted_number(curve, r, column + k, cells[r - row][k]) for r in filled]
        curve = _with_numbers(curve, column + k, filled, numbers)
    return curve


def _pasted_number(curve: Curve, row: int, column: int, cell: str) -> float:
    try:
        return number_in(cell)
    except ValueError:
        name = cell_name(curve, row, column)
        raise ValueError(f"“{cell}” is no number for {name}: nothing was pasted.") from None


def differing_rows(old: Curve, new: Curve) -> NDArray[np.intp] | None:
    """Return the rows in which two curves differ, ascending; None if they have other rows or columns at all."""
    if old.control_points.shape != new.control_points.shape:
        return None
    if (old.degree, old.closed, old.ends) != (new.degree, new.closed, new.ends):
        return np.arange(len(new.lambdas))
    differs = np.zeros(len(new.lambdas), dtype=np.bool_)
    if old.control_points is not new.control_points:
        differs |= (old.control_points != new.control_points).any(axis=1)
    if old.lambdas is not new.lambdas:
        changed = old.lambdas != new.lambdas
        # A λ shapes the segment that ends at it, too; that one begins a row before.
        differs |= changed | np.roll(changed, -1)
    return np.flatnonzero(differs)
