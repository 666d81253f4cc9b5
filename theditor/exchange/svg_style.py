"""How SVG says what an element looks like: attributes, style sheets, and what is passed on to the elements within."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Final, NamedTuple

import svgelements

from theditor.drawing.drawing import DEFAULT_COLOR
from theditor.exchange.xml_tree import Node

Rules = list[tuple[tuple[int, int], str, dict[str, str]]]
"""Specificity and order, selector, properties; the last that applies wins."""

_PROPERTIES: Final[tuple[str, ...]] = (
    "color", "stroke", "stroke-width", "fill", "display", "visibility", "clip-path", "mask", "filter"
)  # fmt: skip
_COMMENT: Final = re.compile(r"/\*.*?\*/", re.DOTALL)
_BLOCK: Final = re.compile(r"([^{}]{1,1000})\{([^{}]*)\}")
_SELECTOR: Final = re.compile(r"([\w-]+|\*)?([.#][\w-]+)?")
_LENGTH: Final = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([A-Za-z%]*)\s*")
_LONGEST: Final = 1e30
_UNITS: Final = {
    "": 1.0, "px": 1.0, "in": 96.0, "cm": 96 / 2.54, "mm": 96 / 25.4, "q": 96 / 101.6, "pt": 4 / 3, "pc": 16.0,
    "em": 16.0, "ex": 8.0,
}  # fmt: skip


class Look(NamedTuple):
    """What elements within take over."""

    color: str = "black"
    stroke: str = "none"
    fill: str = "black"
    width: float = 1.0
    visible: bool = True
    displayed: bool = True


def length(text: str, whole: float = 100.0) -> float:
    """Return a length in user units, by CSS 96 to the inch; per cent are parts of `whole`.

    Raises
    ------
    ValueError
        If the text is no length.
    """
    found = _LENGTH.fullmatch(text)
    if found is None:
        raise ValueError(f"{text[:20]!a} is no length")
    number, unit = float(found[1]), found[2].lower()
    if not abs(number) <= _LONGEST:
        raise ValueError(f"{text[:20]!a} is too large")
    if unit == "%":
        return number * whole / 100
    if unit not in _UNITS:
        raise ValueError(f"{unit[:20]!a} is no unit of length")
    return number * _UNITS[unit]


def rules(sheets: Iterable[str]) -> Rules:
    """Return the rules of style sheets whose selectors are simple: ``path``, ``.thick``, ``path.thick``, ``#a``."""
    found: Rules = []
    for selectors, block in _BLOCK.findall(_COMMENT.sub("", "\n".join(sheets))):
        properties = declarations(block)
        for selector in selectors.split(","):
            match = _SELECTOR.fullmatch(selector.strip())
            if match and match[0]:
                weight = 10 * (match[2] or "").count(".") + 100 * (match[2] or "").count("#")
                weight += match[1] not in (None, "*")
                found.append(((weight, len(found)), match[0], properties))
    return sorted(found, key=lambda rule: rule[0])


def declarations(text: str) -> dict[str, str]:
    """Return the properties of ``stroke: red; fill: none``."""
    pairs = (part.partition(":") for part in text.split(";"))
    return {
        name.strip().lower(): value.replace("!important", "").strip() for name, sign, value in pairs if sign
    }


def properties(tag: str, node: Node, sheet: Rules) -> dict[str, str]:
    """Return what is said about an element itself."""
    said: dict[str, str] = {
        name: node.attributes[name].strip() for name in _PROPERTIES if name in node.attributes
    }
    classes = {f".{name}" for name in node.attributes.get("class", "").split()}
    identity = f"#{node.attributes.get('id', '')}"
    for _, selector, declared in sheet:
        match = _SELECTOR.fullmatch(selector)
        assert match is not None
        if match[1] in (None, "*", tag) and (match[2] is None or match[2] in classes or match[2] == identity):
            said |= declared
    return said | declarations(node.attributes.get("style", ""))


def inherited(look: Look, said: dict[str, str]) -> Look:
    """Return how an element looks: as said, else like the one around it.

    Raises
    ------
    ValueError
        If its stroke width is no length.
    """
    said = {name: value for name, value in said.items() if value != "inherit"}
    visible = said.get("visibility", "visible" if look.visible else "hidden") == "visible"
    return Look(
        said.get("color", look.color),
        said.get("stroke", look.stroke),
        said.get("fill", look.fill),
        length(said["stroke-width"]) if "stroke-width" in said else look.width,
        visible,
        look.displayed and said.get("display") != "none",
    )


def colour(look: Look) -> str:
    """Return the colour of the stroke, else of what is filled, as ``#rrggbb``."""
    for paint in (look.stroke, look.fill):
        name = look.color if paint.lower() == "currentcolor" else paint
        if name.lower() in ("none", "transparent") or name.startswith(("url(", "context-")):
            continue
        try:
            found = str(svgelements.Color(name).hexrgb)
        except (ValueError, TypeError, ArithmeticError):
            continue
        if re.fullmatch("#[0-9a-fA-F]{6}", found):
            return found
    return DEFAULT_COLOR
