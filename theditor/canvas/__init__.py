"""The canvas: the drawing on the screen, and the mouse on it."""

from theditor.canvas.canvas import Canvas, Pointed
from theditor.canvas.picture import Shown

__all__ = ["Canvas", "Pointed", "Shown"]
