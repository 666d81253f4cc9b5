"""Who may import whom, read from the syntax tree of every module."""

import ast
import subprocess
import sys
from collections.abc import Iterator, Set
from graphlib import TopologicalSorter
from importlib.util import resolve_name
from pathlib import Path

import pytest

import theditor

PACKAGE = Path(theditor.__file__).parent

QT = {"PySide6", "shiboken6", "pyqtgraph"}

# What each part may import besides itself, `resources` and the standard library.
LAYERS = {
    "resources": set(),
    "spline": {"numpy"},
    "drawing": {"spline", "msgspec"},
    "exchange": {"spline", "drawing", "numpy", "svgelements", "ezdxf"},
    "model": {"spline", "drawing", "numpy", "PySide6.QtCore", "PySide6.QtGui"},
    "canvas": {"spline", "drawing", "model", "numpy", *QT},
    "panels": {"spline", "drawing", "model", "numpy", *QT},
    "app": {"spline", "drawing", "exchange", "model", "canvas", "panels", "numpy", *QT},
    "cli": {"spline", "drawing", "exchange", "tqdm"},
    "__main__": {"cli"},
    "__init__": set(),
}
# Only inside a function, so that the command line starts without Qt.
DEFERRED = {"cli": {"app"}}
# One module of its part, which is imported by name only when it is asked for.
ALONE = {"exchange/picture.py": {"PySide6.QtCore", "PySide6.QtGui"}}


def imported(tree: ast.AST, package: str, deferred: bool = False) -> Iterator[tuple[int, str, bool]]:
    """Line, absolute dotted name and "inside a function" of everything the tree imports."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.Import):
            yield from ((node.lineno, alias.name, deferred) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            source = resolve_name("." * node.level + (node.module or ""), package)
            yield from ((node.lineno, f"{source}.{alias.name}", deferred) for alias in node.names)
        in_function = isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
        yield from imported(node, package, deferred or in_function)


def violations(source: str, part: str, package: str, alone: Set[str] = frozenset()) -> list[str]:
    """Return the imports of a module's source that its part of the package may not make."""

    def allowed(name: str, deferred: bool) -> bool:
        if name.split(".")[0] in sys.stdlib_module_names:
            return True
        permitted = LAYERS[part] | {part, "resources"} | alone
        permitted |= DEFERRED.get(part, set()) if deferred else set()
        prefixes = {f"theditor.{p}" if p in LAYERS else p for p in permitted}
        return any(f"{name}.".startswith(f"{prefix}.") for prefix in prefixes)

    return [
        f"line {line}: {part} imports {name}"
        for line, name, deferred in imported(ast.parse(source), package)
        if not allowed(name, deferred)
    ]


@pytest.mark.parametrize("module", sorted(p.relative_to(PACKAGE).as_posix() for p in PACKAGE.rglob("*.py")))
def test_every_module_keeps_to_its_layer(module):
    relative = Path(module).with_suffix("")
    package = ".".join(["theditor", *relative.parent.parts])
    source = (PACKAGE / module).read_text("utf-8")
    assert violations(source, relative.parts[0], package, ALONE.get(module, set())) == []


def test_no_circle_is_permitted():
    parts = {part: (below | DEFERRED.get(part, set())) & LAYERS.keys() for part, below in LAYERS.items()}
    TopologicalSorter(parts).prepare()


@pytest.mark.parametrize(
    ("part", "source"),
    [
        ("spline", "import PySide6.QtCore"),
        ("spline", "from theditor.drawing import load"),
        ("spline", "from ..drawing import load"),
        ("spline", "from .. import drawing"),
        ("spline", "import theditor"),
        ("drawing", "def late():\n    import scipy.linalg"),
        ("exchange", "from PySide6.QtGui import QImage"),
        ("exchange", "from theditor.canvas.projection import projected"),
        ("model", "from PySide6 import QtWidgets"),
        ("canvas", "if TYPE_CHECKING:\n    from theditor.panels.curves import CurvesPanel"),
        ("panels", "from theditor import canvas"),
        ("panels", "from ..canvas.tools import *"),
        ("app", "from tests.conftest import HOME"),
        ("app", "import theditor.cli"),
        ("cli", "from theditor.app.main_window import MainWindow"),
        ("cli", "class Command:\n    from theditor import app"),
    ],
)
def test_a_violation_is_seen(part, source):
    assert len(violations(source, part, f"theditor.{part}")) == 1


@pytest.mark.parametrize(
    ("part", "source"),
    [
        ("spline", "import math\nfrom numpy import pi\nfrom . import basis\nfrom .basis import k"),
        ("model", "import numpy.linalg\nfrom PySide6 import QtGui\nfrom ..drawing import Drawing"),
        ("panels", "from theditor import resources\nfrom PySide6 import QtWidgets"),
        ("cli", "def main():\n    with suppress(OSError):\n        from theditor.app.main_window import run"),
    ],
)
def test_what_a_layer_may_import_passes(part, source):
    assert violations(source, part, f"theditor.{part}") == []


def test_the_command_line_loads_without_qt():
    code = f"import sys, theditor.cli, theditor.exchange; print(*{QT} & sys.modules.keys())"
    run = subprocess.run([sys.executable, "-P", "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.split() == []
