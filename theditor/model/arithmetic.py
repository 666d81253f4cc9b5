"""What a person may type where a number belongs: a number, simple arithmetic, or a change of the present value.

No Qt here.
"""

from __future__ import annotations

import ast
import math
import operator
import re
from collections.abc import Callable

_LONGEST = 200  # characters
_NUMBER = re.compile(r"(?:\d+(?:\.\d*|,\d+)?|[.,]\d+)(?:[eE][+-]?\d+)?")
_SIGNS = frozenset("+-*/() ")
_RELATIVE = ("+", "*", "/")
_OPERATIONS: dict[type[ast.AST], Callable[..., float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
}


def number_in(text: str) -> float:
    """Return the number that a text is, with a decimal point or comma and any kind of minus sign.

    Raises
    ------
    ValueError
        The text is no finite number, or has both a point and a comma, or several of them.
    """
    plain = _plain(text)
    number = float(plain.replace(",", ".")) if _NUMBER.fullmatch(plain.lstrip("+-")) else math.nan
    if not math.isfinite(number):
        raise ValueError(f"{text!r} is no finite number")
    return number


def calculated(text: str, present: float | None = None) -> float:
    """Return what a text asks for: ``2.5``, ``2,5``, ``2/3``, ``(1+2)*4``, or from the present value ``+1.5``, ``*2``.

    A text that begins with ``+``, ``*`` or ``/`` goes on from the present value; one that begins with a minus
    sign is a negative number. The operators are + − * / ** and brackets; commas are decimal signs. Nothing
    else is understood, so text from anywhere is safe.

    Parameters
    ----------
    present
        The present value, None where there is none.

    Raises
    ------
    ValueError
        The text means no finite number, or would go on from a value that does not exist.
    """
    plain = _plain(text)
    if not plain.startswith(_RELATIVE):
        present = None
    elif present is None:
        raise ValueError(f"{text!r} has nothing to go on from")
    if len(plain) > _LONGEST or not set(_NUMBER.sub("", plain)) <= _SIGNS:
        raise ValueError(f"{text!r} is no arithmetic")
    # Every number as Python writes it: leading zeros and decimal commas are none to its parser.
    sums = _NUMBER.sub(lambda found: f" {number_in(found[0])!r} ", plain).strip()
    try:
        tree = ast.parse(sums if present is None else f"({present!r}){sums}", mode="eval")
        result = _value(tree.body)
    except (SyntaxError, ArithmeticError, RecursionError, MemoryError) as error:
        raise ValueError(f"{text!r} cannot be worked out") from error
    if isinstance(result, complex) or not math.isfinite(result):
        raise ValueError(f"{text!r} is no finite number")
    return result


def _value(node: ast.expr) -> float:
    match node:
        case ast.Constant(value=float() as number):
            return number
        case ast.UnaryOp(op=sign, operand=operand):
            return _OPERATIONS[type(sign)](_value(operand))
        case ast.BinOp(left=left, op=sign, right=right) if type(sign) in _OPERATIONS:
            return _OPERATIONS[type(sign)](_value(left), _value(right))
    raise ValueError("no arithmetic")


def _plain(text: str) -> str:
    """Return the text with plain minus signs and ordinary blanks, as typesetting and spreadsheets have others."""
    return " ".join(text.replace("−", "-").split())
