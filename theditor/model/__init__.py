"""The Qt model: the document with its undo history, gestures, and what is selected."""

from theditor.model.colours import DARK, LIGHT, Colours, colours_for
from theditor.model.document import Document
from theditor.model.gesture import Gesture
from theditor.model.selection import Selection
from theditor.model.unbreakable import unbreakable

__all__ = ["DARK", "LIGHT", "Colours", "Document", "Gesture", "Selection", "colours_for", "unbreakable"]
