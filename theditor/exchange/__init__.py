"""Foreign formats: drawings go out as SVG, DXF, PDF, PNG, TikZ and CSV, and come in from SVG and CSV.

Bytes in, bytes out; who calls stores them. Qt is loaded for PDF and PNG alone.
"""

from theditor.exchange.formats import FORMATS, Format, read, readable, writable, write
from theditor.exchange.options import PARTS, Imported, Options, Progress, Written, told

__all__ = [
    "FORMATS",
    "PARTS",
    "Format",
    "Imported",
    "Options",
    "Progress",
    "Written",
    "read",
    "readable",
    "told",
    "writable",
    "write",
]
