"""The drawing itself inside an SVG picture of it, so that the picture opens again without loss.

It rides along as the native JSON in the `metadata` element, with a fingerprint of the paths and their style
as they were written: once another program has changed them, the JSON no longer tells what the picture shows.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from hashlib import sha256
from html import escape
from typing import Any, Final
from xml.parsers import expat

from theditor.drawing import Drawing, decode, encode

NAMESPACE: Final = "urn:theditor:drawing"
_SVG: Final = "http://www.w3.org/2000/svg"
_LOOKS: Final = ("d", "transform", "style", "stroke", "stroke-width", "display", "visibility")


@dataclass(frozen=True, slots=True)
class Embedded:
    """The drawing found in a picture."""

    drawing: Drawing
    current: bool
    """Whether the picture's paths are still the ones written with the drawing."""


def metadata(drawing: Drawing, picture: str) -> str:
    """Return the `metadata` element for a picture of a drawing.

    Parameters
    ----------
    drawing : Drawing
        Whole, hidden curves and z included.
    picture : str
        The elements that the `svg` element holds besides.
    """
    text = encode(drawing).decode()
    # These two letters may stand in a name, but not in XML.
    text = text.replace("\ufffe", "\\ufffe").replace("\uffff", "\\uffff")
    mark = _parsed(f'<svg xmlns="{_SVG}">{picture}</svg>'.encode()).fingerprint
    content = escape(text, quote=False)
    return f'<metadata><drawing xmlns="{NAMESPACE}" picture="{mark}">\n{content}</drawing></metadata>\n'


def extract(data: bytes) -> Embedded | None:
    """Return the drawing that an SVG picture carries, None if it carries none.

    Raises
    ------
    DrawingError
        If what it carries is damaged.
    """
    if NAMESPACE.encode() not in data:
        return None
    try:
        found = _parsed(data)
    except (expat.ExpatError, _ForeignError):
        return None
    if found.mark is None:
        return None
    drawing = decode("".join(found.texts).strip().encode())
    return Embedded(drawing, found.mark == found.fingerprint)


class _ForeignError(Exception):
    """The picture declares a document type, which this program never does."""


@dataclass(slots=True)
class _Found:
    """What the parser has met: the drawing's text, and everything that tells how a path looks."""

    mark: str | None = None
    inside: bool = False
    texts: list[str] = field(default_factory=list)
    digest: Any = field(default_factory=sha256)

    @property
    def fingerprint(self) -> str:
        return str(self.digest.hexdigest()[:32])

    def start(self, name: str, attributes: dict[str, str]) -> None:
        if name == f"{NAMESPACE} drawing" and self.mark is None:
            self.mark, self.inside = attributes.get("picture", ""), True
        elif name.startswith(f"{_SVG} "):
            for key in _LOOKS:
                if key in attributes:
                    self.digest.update(f"{key}={attributes[key]}\n".encode())

    def end(self, name: str) -> None:
        self.inside &= name != f"{NAMESPACE} drawing"

    def text(self, text: str) -> None:
        if self.inside:
            self.texts.append(text)

    def refuse(self, *_: object) -> None:
        raise _ForeignError


def _parsed(data: bytes) -> _Found:
    found = _Found()
    parser = expat.ParserCreate(namespace_separator=" ")
    parser.buffer_text = True
    parser.StartElementHandler = found.start
    parser.EndElementHandler = found.end
    parser.CharacterDataHandler = found.text
    parser.StartDoctypeDeclHandler = found.refuse
    parser.Parse(data, True)
    return found
