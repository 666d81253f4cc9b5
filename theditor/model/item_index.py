"""The index that Qt's item models are asked with."""

from PySide6.QtCore import QModelIndex, QPersistentModelIndex

ModelIndex = QModelIndex | QPersistentModelIndex
NO_INDEX = QModelIndex()
"""The parent of the rows of a flat list."""
