"""The canvas: the drawing on the screen, and the mouse on it."""

from theditor.canvas.canvas import Canvas
from theditor.canvas.picture import Shown
from theditor.canvas.words import Pointed

__all__ = ["Canvas", "Pointed", "Shown"]
