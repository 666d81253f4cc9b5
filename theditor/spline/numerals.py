"""Numbers as sentences take them: six digits with true minus signs, subscripts, and counted things."""

from collections.abc import Iterable
from typing import Final

_SUBSCRIPTS: Final = str.maketrans("0123456789-", "₀₁₂₃₄₅₆₇₈₉₋")


def number(value: float, tolerance: float = 0.0) -> str:
    """Write a number in at most six significant digits; what is within the tolerance of zero is 0."""
    return "0" if abs(value) <= tolerance else f"{value:.6g}".replace("-", "−")


def position(point: Iterable[float], tolerance: float = 0.0) -> str:
    """Write a point or vector: ``(1, −2)``."""
    return f"({', '.join(number(x, tolerance) for x in point)})"


def indexed(symbol: str, index: int) -> str:
    """Return a symbol with its subscript: ``λ₁₂``."""
    return symbol + str(index).translate(_SUBSCRIPTS)


def counted(count: int, noun: str) -> str:
    """Count: ``1 point``, ``3 points``, ``10,000 points``."""
    number = f"{count:,}" if count >= 10_000 else str(count)
    return f"{number} {noun}" if count == 1 else f"{number} {noun}s"
