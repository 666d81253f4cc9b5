"""What a start loads: what the first painted window needs, and nothing that can be loaded when it is asked for."""

import os
import subprocess
import sys
from importlib.util import find_spec

from first_window import FIRST_WINDOW

# Tools, dialogs, formats and libraries: each of these also brings others with it.
LATER = {
    "theditor.app.clipboard_data",
    "theditor.app.importing",
    "theditor.app.insert_dialog",
    "theditor.app.recover_dialog",
    "theditor.canvas.freehand",
    "theditor.canvas.pen",
    "theditor.exchange",
    "theditor.panels.continuity",
    "theditor.panels.curvature",
    "theditor.panels.points",
    *("concurrent.futures", "difflib", "hashlib", "html", "secrets"),
    *("ezdxf", "svgelements", "tqdm"),
}

START = f"""
def begun():
    app = QApplication.instance()
    app.processEvents()
    (window,) = (each for each in app.topLevelWidgets() if each.isVisible())
    assert window.document.title == "Figure 10" and not window.canvas.viewport().visibleRegion().isEmpty()
    print(*sys.modules)
    assert __import__.__name__ == "__import__", "Qt reads the source of whatever is loaded"
    from PySide6 import QtGui
    assert "QVector4D" not in vars(QtGui), "classes of Qt that nobody needs have been made"
    from pyqtgraph.Qt import QtGui as mirror
    assert "QVector4D" in dir(QtGui) and "QVector4D" in dir(mirror) and mirror.QVector4D is QtGui.QVector4D
    sys.stdout.flush()
    return 0

{FIRST_WINDOW}
sys.exit(main([]))
"""


def test_a_start_loads_only_what_the_first_window_needs(tmp_path):
    folders = {name: str(tmp_path) for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME")}
    run = subprocess.run(
        [sys.executable, "-c", START],
        capture_output=True,
        text=True,
        timeout=60,
        env={**os.environ, **folders},
    )
    assert run.returncode == 0, run.stderr
    loaded = run.stdout.split()
    assert all(find_spec(name) for name in LATER)
    assert LATER.intersection(loaded) == set()
