"""Steps from one version of the file to the next, as functions of the plain data that JSON holds."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

STEPS: Final[dict[int, Callable[[dict[str, Any]], dict[str, Any]]]] = {}
"""For each old version, the function that turns its data into that of the next version; there is no old one yet.

A step takes what `json.loads` gives, changes nothing in it, and returns the data of the next version, ``version``
included; what it does not understand it leaves to the check of the newest version, which comes last. Whoever
changes the format raises `theditor.drawing.schema.VERSION`, adds the step from the version before, and keeps a
file of the old version in ``tests/data``.
"""


def migrated(data: dict[str, Any], version: int, newest: int) -> dict[str, Any]:
    """Return data of a version as data of the newest version; KeyError if a step is missing."""
    for old in range(version, newest):
        data = STEPS[old](data)
    return data
