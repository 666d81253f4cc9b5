"""The value a file holds, and the file: immutable drawings, strict JSON, atomic saves. No Qt."""

from theditor.drawing.change import Change, difference
from theditor.drawing.drawing import Drawing, DrawingError, Item
from theditor.drawing.schema import decode, encode, encode_in_parts, json_schema
from theditor.drawing.storage import fingerprint, load, read_bytes, save, shown, unreadable, write_atomically

__all__ = [
    "Change",
    "Drawing",
    "DrawingError",
    "Item",
    "decode",
    "difference",
    "encode",
    "encode_in_parts",
    "fingerprint",
    "json_schema",
    "load",
    "read_bytes",
    "save",
    "shown",
    "unreadable",
    "write_atomically",
]
