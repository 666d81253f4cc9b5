"""The same surroundings for every run: no screen, no settings of the user's, one locale, no hurry."""

import atexit
import os
import shutil
import tempfile
from pathlib import Path

from hypothesis import HealthCheck, settings

from theditor.app.loading_qt import load_qt

# Qt reads these when it is imported or an application is made: they are set before any test module loads.
# THEDITOR_TEST_PLATFORM=xcb (wayland, cocoa, windows) shows the windows on a real screen.
os.environ["QT_QPA_PLATFORM"] = os.environ.get("THEDITOR_TEST_PLATFORM", "offscreen")
os.environ["LC_ALL"] = "C.UTF-8"
for name in ("QT_SCALE_FACTOR", "QT_SCREEN_SCALE_FACTORS", "QT_STYLE_OVERRIDE"):
    os.environ.pop(name, None)

HOME = Path(tempfile.mkdtemp(prefix="theditor-tests-"))
atexit.register(shutil.rmtree, HOME, ignore_errors=True)
for name, folder in {
    "HOME": "home",
    "XDG_CONFIG_HOME": "config",
    "XDG_DATA_HOME": "data",
    "XDG_STATE_HOME": "state",
    "XDG_CACHE_HOME": "cache",
}.items():
    (HOME / folder).mkdir()
    os.environ[name] = str(HOME / folder)
if os.environ["QT_QPA_PLATFORM"] == "offscreen":  # a real screen's sockets may live in the user's own folder
    (HOME / "runtime").mkdir(mode=0o700)
    os.environ["XDG_RUNTIME_DIR"] = str(HOME / "runtime")

load_qt()  # as the program does

# The same examples every time; THEDITOR_LONG_RUN=1 looks for others, and many more of them.
# A slow or shared machine is no failure.
LONG_RUN = bool(os.environ.get("THEDITOR_LONG_RUN"))
settings.register_profile(
    "theditor",
    max_examples=1000 if LONG_RUN else 60,
    derandomize=not LONG_RUN,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow],
)
settings.load_profile("theditor")
