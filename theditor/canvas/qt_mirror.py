"""Loading pyqtgraph without every class of Qt."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from importlib import import_module
from types import ModuleType

MIRRORED = ("QtCore", "QtGui", "QtWidgets")


@contextmanager
def names_on_demand() -> Iterator[None]:
    """Let pyqtgraph, loaded meanwhile, look up Qt's names as it needs them.

    It keeps mirrors of Qt's modules, and fills them with all that `dir` tells of those. PySide makes each of its
    classes when it is first looked up: all 700 took an eighth of the time until the window was painted.
    """
    if "pyqtgraph" in sys.modules:
        yield
        return
    told = {}
    for name in MIRRORED:
        module = import_module(f"PySide6.{name}")
        mirror = ModuleType(f"pyqtgraph.Qt.{name}")
        vars(mirror).update(__getattr__=partial(getattr, module), __dir__=partial(dir, module))
        sys.modules[mirror.__name__] = mirror
        told[module] = vars(module).get("__dir__")
        vars(module)["__dir__"] = list
    try:
        yield
    finally:
        for module, names in told.items():
            if names is None:
                del vars(module)["__dir__"]
            else:
                vars(module)["__dir__"] = names
