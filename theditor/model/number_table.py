"""A table of numbers in plain text, as spreadsheets, editors and other programs copy it. No Qt here."""

from __future__ import annotations

import re

from theditor.model.arithmetic import number_in

_WIDTHS = (2, 3)


def points_in(text: str) -> list[list[float]]:
    """Return the rows of a table with two or three columns.

    Columns are separated by tabs, else semicolons, else blanks, else commas; where commas do not separate
    they are decimal signs, unless there are decimal points as well. Blank lines are passed over.

    Raises
    ------
    ValueError
        The text is no such table; the message says where, as the middle of a sentence.
    """
    lines = [(number, line.strip()) for number, line in enumerate(text.splitlines(), 1) if line.strip()]
    if not lines:
        raise ValueError("it holds no text")
    separator = _separator([line for _, line in lines])
    rows: list[list[float]] = []
    for number, line in lines:
        cells = [cell.strip() for cell in re.split(separator, line)]
        try:
            row = [number_in(cell) for cell in cells]
        except ValueError:
            raise ValueError(f"line {number}, “{_short(line)}”, is no row of numbers") from None
        if len(row) not in _WIDTHS:
            raise ValueError(f"line {number}, “{_short(line)}”, has not two or three columns")
        if rows and len(row) != len(rows[0]):
            raise ValueError(f"line {number}, “{_short(line)}”, has not as many columns as the first")
        rows.append(row)
    if (
        separator != _COMMA
        and any("," in line for _, line in lines)
        and any("." in line for _, line in lines)
    ):
        raise ValueError("it has both points and commas as decimal signs")
    return rows


_COMMA = r"\s*,\s*"


def _separator(lines: list[str]) -> str:
    """Return what separates columns, as a pattern."""
    whole = "\n".join(lines)
    for sign in ("\t", ";"):
        if sign in whole:
            return sign
    blanks = any(re.search(r"[^\s,]\s+[^\s,]", line) for line in lines)
    return r"\s+" if blanks else _COMMA


def _short(line: str) -> str:
    return line if len(line) <= 40 else f"{line[:39]}…"
