"""What a whole process costs: until its first window is painted, and at the most in memory.

    pytest tests/benchmarks/test_process.py -n 0

prints wall and processor time from starting the program to its first painted window, with Figure 10 in it, as a
multiple of an empty pyqtgraph plot window of that size (the aim: at most 1.2); the peak of memory with a drawing of
10⁵ points open as a multiple of that with Figure 10 (at most 2); and by how much 10,000 edits of single points of a
curve of 10⁵ let the memory grow (less than 50 MB).

The processes take turns, with their modules compiled; medians are compared, and nothing here fails on them.
"""

import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

import pytest
from first_window import FIRST_WINDOW
from large import spiral

from theditor.drawing import save

ROUNDS = 7
PLOT = """
import os
import pyqtgraph
app = pyqtgraph.mkQApp()
window = pyqtgraph.PlotWidget()
window.resize(1360, 860)
window.show()
app.processEvents()
window.repaint()
os._exit(0)
"""
WINDOW = f"""
import os

def begun():
    app = QApplication.instance()
    app.processEvents()
    for window in app.topLevelWidgets():
        if window.isVisible():
            window.repaint()
    with open("/proc/self/status") as status:
        os.write(1, status.read().partition("VmHWM:")[2].split()[0].encode())
    os._exit(0)

{FIRST_WINDOW}
main(sys.argv[1:])
"""
EDITS = """
import os
from large import spiral
from theditor.model import Document

def used():
    with open("/proc/self/statm") as pages:
        return int(pages.read().split()[1]) * os.sysconf("SC_PAGESIZE") / 1e6

document = Document(spiral())
document.apply_curve("Reverse", 0, document.drawing[0].curve.reversed())
before = used()
for k in range(10_000):
    curve = document.drawing[0].curve
    point = curve.control_points[k] + 1.0
    document.apply_curve("Move point", 0, curve.with_points(k, point))
print(used() - before)
"""


@pytest.fixture
def measure(tmp_path):
    """Run Python code once; return its wall time, its processor time in seconds, and its peak of memory in MB."""
    surroundings = dict(
        os.environ, QT_QPA_PLATFORM="offscreen", PYTHONPYCACHEPREFIX=str(tmp_path / "compiled")
    )
    surroundings |= {name: str(tmp_path) for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME")}
    surroundings.pop("PYTHONDONTWRITEBYTECODE", None)

    def measured(code, *arguments):
        start = time.perf_counter()
        command = [sys.executable, "-c", code, *arguments]
        process = subprocess.Popen(command, env=surroundings, stdout=subprocess.PIPE)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        assert process.returncode == 0
        wall = time.perf_counter() - start
        # What the operating system tells of a process that has ended counts what it was forked from, too.
        assert process.stdout is not None
        with process.stdout as peak:
            return wall, usage.ru_utime + usage.ru_stime, int(peak.read() or 0) / 1024

    return measured


def test_starting(measure, report):
    runs = [(measure(WINDOW), measure(PLOT)) for _ in range(ROUNDS + 1)][1:]
    for k, what in enumerate(("wall", "processor")):
        ours, plot = (statistics.median(run[i][k] for run in runs) for i in (0, 1))
        report(
            f"start to first painted window: {ours / plot:.2f} × an empty plot in {what} time ({ours:.3f} s)"
        )


def test_peak_of_memory(measure, tmp_path, report):
    large = tmp_path / "large.json"
    save(spiral(), large)
    runs = [(measure(WINDOW, str(large))[2], measure(WINDOW)[2]) for _ in range(3)]
    large, small = (statistics.median(run[i] for run in runs) for i in (0, 1))
    report(
        f"peak of memory with 10⁵ points: {large / small:.2f} × with Figure 10 ({large:.0f} and {small:.0f} MB)"
    )


def test_a_long_history(report):
    run = subprocess.run(
        [sys.executable, "-c", EDITS], cwd=Path(__file__).parent, capture_output=True, check=True, text=True
    )
    report(f"10,000 edits of single points of 10⁵: {float(run.stdout):.1f} MB")
