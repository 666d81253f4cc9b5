"""A start of the program as a process of its own: code for it, up to what is done in place of waiting for events.

What comes before it defines `begun`, which is called then, and what comes after it calls `main`.
"""

FIRST_WINDOW = """
import sys
from theditor.cli import main

class Finder:
    # The program is to import Qt itself, when it comes to it.
    def find_spec(self, name, path=None, target=None):
        global QApplication
        if name == "theditor.app.main":
            sys.meta_path.remove(self)
            from PySide6.QtWidgets import QApplication
            QApplication.exec = staticmethod(begun)

sys.meta_path.insert(0, Finder())
"""
