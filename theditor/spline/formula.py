"""Formulas for λ, such as ``sin(i/3)``, evaluated safely for many control points at once."""

import ast
import sys
import warnings
from collections.abc import Callable
from functools import reduce
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from theditor.spline.basis import Floats
from theditor.spline.checks import MAX_LAMBDA, clean_indices, clean_values

_LONGEST: Final = 500  # characters
_DEEPEST: Final = 100  # operations within one another, as in a sum of so many terms

_OPERATORS: Final[dict[type[ast.AST], Callable[..., Any]]] = {
    ast.Add: np.add,
    ast.Sub: np.subtract,
    ast.Mult: np.multiply,
    ast.Div: np.divide,
    ast.Mod: np.mod,
    ast.Pow: np.power,
    ast.UAdd: np.positive,
    ast.USub: np.negative,
    ast.Lt: np.less,
    ast.LtE: np.less_equal,
    ast.Gt: np.greater,
    ast.GtE: np.greater_equal,
    ast.Eq: np.equal,
    ast.NotEq: np.not_equal,
}

_FUNCTIONS: Final[dict[str, Callable[..., Any]]] = {
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "asin": np.arcsin,
    "acos": np.arccos,
    "atan": np.arctan,
    "sinh": np.sinh,
    "cosh": np.cosh,
    "tanh": np.tanh,
    "exp": np.exp,
    "log": np.log,
    "sqrt": np.sqrt,
    "abs": np.abs,
    "floor": np.floor,
    "ceil": np.ceil,
    "round": np.rint,
    "sign": np.sign,
}

_FOLDED: Final[dict[str, Callable[..., Any]]] = {
    "min": np.minimum,
    "max": np.maximum,
}  # of any number of values


class FormulaError(ValueError):
    """A formula that cannot be used; the message says where and what to do."""


def evaluate(
    text: str, count: int, values: ArrayLike | None = None, indices: ArrayLike | None = None
) -> Floats:
    """Return the value of a formula at each control point, or at some.

    A formula consists of numbers, the index i from 0, the number n of control points, the current value λ
    (also written l), pi, e, the operators + − * / % **, comparisons (1 where true, 0 where false),
    ``a if condition else b``, and the functions sin cos tan asin acos atan sinh cosh tanh exp log sqrt abs
    floor ceil round sign min max. Angles are in radians, log is natural, round goes to the even number at
    halves. Nothing else is understood, so text from anywhere is safe, and the time it takes is bounded.

    Parameters
    ----------
    text : str
        The formula, of at most 500 characters.
    count : int
        The number of control points.
    values : array_like, shape (count,), optional
        The current λ; without them a formula may not use λ.
    indices : array_like of int, shape (k,), optional
        The control points wanted; what the formula gives elsewhere, such as 1/i at 0, is not judged.

    Returns
    -------
    ndarray, shape (count,), or (k,) with `indices`
        Finite and at most `MAX_LAMBDA` in size.

    Raises
    ------
    FormulaError
        If the text is no such formula, or a value is not acceptable as λ. The message names the place.
    ValueError
        If there is no such control point, or the number of current λ is not `count`.
    """
    wanted = np.arange(count) if indices is None else clean_indices(indices, count, "control point")
    known: dict[str, Any] = {"i": wanted.astype(np.float64), "n": float(count)}
    known |= {"pi": np.pi, "e": np.e}
    if values is not None:
        known["λ"] = known["l"] = clean_values(values, "the current λ", (count,))[wanted]
    source = _clean(text)
    with np.errstate(all="ignore"):  # what is not finite is refused below, or a condition does not choose it
        result = _Formula(source, known).value(_parsed(source))
    results: Floats = np.array(np.broadcast_to(result, wanted.shape), dtype=np.float64) + 0.0  # no −0.0
    bad = np.flatnonzero(~(np.abs(results) <= MAX_LAMBDA))
    if len(bad):
        value = float(results[bad[0]])
        what = f"λ = {value:g}" if np.isfinite(value) else "no finite λ"
        raise FormulaError(
            f"at i = {wanted[bad[0]]} the formula gives {what}: change it so that every λ is at most "
            f"{MAX_LAMBDA:g} in size"
        )
    return results


class _Formula(NamedTuple):
    """The text of a formula, to quote from, and the names it may use."""

    source: str
    known: dict[str, Any]

    def value(self, node: ast.expr, depth: int = 0) -> Any:
        """Return the value of a part of the formula: a float, or an array with one for each i."""
        if depth > _DEEPEST:
            raise self.error(node, f"lies more than {_DEEPEST} operations deep: write it more simply")

        def of(part: ast.expr) -> Any:
            return self.value(part, depth + 1)

        match node:
            case ast.Constant(value=int() | float() as number) if not isinstance(number, bool):
                if abs(number) > sys.float_info.max:
                    raise self.error(node, "is too large: write a smaller number")
                return float(number)
            case ast.Name(id=name) if name in self.known:
                return self.known[name]
            case ast.UnaryOp(op=operator, operand=operand) if type(operator) in _OPERATORS:
                return _OPERATORS[type(operator)](of(operand))
            case ast.BinOp(left=left, op=operator, right=right) if type(operator) in _OPERATORS:
                return _OPERATORS[type(operator)](of(left), of(right))
            case ast.Compare(left=left, ops=operators, comparators=others) if all(
                type(operator) in _OPERATORS for operator in operators
            ):
                terms = [of(part) for part in (left, *others)]
                pairs = zip(operators, terms[:-1], terms[1:], strict=True)
                return reduce(np.multiply, [_OPERATORS[type(o)](a, b) * 1.0 for o, a, b in pairs])
            case ast.IfExp(test=test, body=body, orelse=orelse):
                return np.where(of(test) != 0, of(body), of(orelse))
            case ast.Call(func=ast.Name(id=name), args=[part], keywords=[]) if name in _FUNCTIONS:
                return _FUNCTIONS[name](of(part))
            case ast.Call(func=ast.Name(id=name), args=[_, *_] as parts, keywords=[]) if name in _FOLDED:
                return reduce(_FOLDED[name], [of(part) for part in parts])
        raise self.error(node, _cure(node))

    def error(self, node: ast.expr, why: str) -> FormulaError:
        """Return a refusal of a part of the formula."""
        part = ast.get_source_segment(self.source, node) or ""
        part = part if len(part) <= 40 else f"{part[:39]}…"
        before = self.source.encode()[: node.col_offset].decode()
        return FormulaError(f"“{part}” at character {len(before) + 1} {why}")


def _cure(node: ast.expr) -> str:
    """Say what is wrong with a part that no rule allows, and what to write instead."""
    match node:
        case ast.Name(id="λ" | "l"):
            return "has no value here: use i and n"
        case ast.Name(id=name) if name in _FUNCTIONS or name in _FOLDED:
            return f"needs brackets: write {name}(i)"
        case ast.Call(func=ast.Name(id=name)) if name in _FUNCTIONS:
            return f"has the wrong number of values: {name} takes one"
        case ast.Call(func=ast.Name(id=name)) if name in _FOLDED:
            return f"has no values: {name} takes one or more, with commas between"
        case ast.Tuple():
            return "has a comma: write decimals with a point"
        case ast.BinOp(op=ast.BitXor()):
            return "has a ^: write ** for powers"
    return "is not understood: use numbers, i, n, λ, pi, e, + − * / % **, comparisons, and functions as in sin(i)"


def _clean(text: str) -> str:
    """Return the text on one line, without blanks at its ends, and with plain minus signs."""
    # Typographic minus signs come from what is shown elsewhere, line breaks from pasting.
    source = "".join(" " if c.isspace() else c for c in text).strip().replace("−", "-")
    if not source:
        raise FormulaError("the formula is empty: write one such as sin(i/3)")
    if len(source) > _LONGEST:
        raise FormulaError(f"the formula has {len(source)} characters: shorten it to {_LONGEST}")
    return source


def _parsed(source: str) -> ast.expr:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of Python's own, about forms that it is about to drop
            return ast.parse(source, mode="eval").body
    except SyntaxError as error:
        place = f"at character {error.offset}" if error.offset else "at its end"
        reason = f"the formula cannot be read {place}: check brackets and operators there, as in 2*sin(i/3)"
        raise FormulaError(reason) from None
    except (ValueError, RecursionError, MemoryError):
        raise FormulaError("the formula cannot be read: write a simpler one such as sin(i/3)") from None
