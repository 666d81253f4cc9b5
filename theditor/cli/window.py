"""Opening the window, or saying in a sentence why there can be none."""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from theditor.cli import fail

DEBIAN_PACKAGES = (
    "libgl1 libegl1 libxkbcommon0 libdbus-1-3 libfontconfig1 libglib2.0-0 fonts-dejavu-core "
    "libxkbcommon-x11-0 libx11-xcb1 libxcb-cursor0 libxcb-icccm4 libxcb-image0 libxcb-keysyms1 libxcb-randr0 "
    "libxcb-render-util0 libxcb-shape0 libxcb-shm0 libxcb-sync1 libxcb-xfixes0 libxcb-xkb1"
)


def open_window(files: Sequence[str]) -> int:
    """Open a window for each file and return the exit code when all are closed."""
    if sys.platform == "linux" and not any(
        os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")
    ):
        return fail(
            "there is no display to open a window on: start it from a desktop session, "
            "or set DISPLAY to one (QT_QPA_PLATFORM=offscreen runs it unseen)."
        )
    gc.disable()  # nothing that loading makes is garbage: looking for it takes a tenth of the time, now and later
    try:
        from theditor.app.loading_qt import load_qt

        load_qt()
        from theditor.app.main import run
    except ImportError as error:
        return fail(missing_library(error))
    finally:
        gc.freeze()
        gc.enable()
    return run([Path(file) for file in files])


def missing_library(error: ImportError) -> str:
    """Say which system library is missing and how to install it; any other error is raised again."""
    library, _, reason = str(error).partition(": ")
    if "shared object" not in reason:
        raise error
    return (
        f"the system library {library} is missing: on Debian or Ubuntu, "
        f"sudo apt-get install -y {DEBIAN_PACKAGES}"
    )
