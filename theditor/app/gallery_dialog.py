"""The gallery: a menu of pictures to start from."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QLabel,
    QListView,
    QListWidget,
    QListWidgetItem,
    QVBoxLayout,
    QWidget,
)

from theditor.app.thumbnail import thumbnail
from theditor.drawing import load
from theditor.model import colours_for
from theditor.resources import Picture, gallery

PICTURE = QSize(168, 112)


class GalleryDialog(QDialog):
    """Pictures of the shipped drawings; `chosen` is the one picked, None until then."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Gallery")
        self.resize(824, 620)
        self.chosen: Picture | None = None
        self._list = QListWidget()
        self._list.setAccessibleName("Pictures in the gallery")
        self._list.setViewMode(QListView.ViewMode.IconMode)
        self._list.setMovement(QListView.Movement.Static)
        self._list.setResizeMode(QListView.ResizeMode.Adjust)
        self._list.setIconSize(PICTURE)
        self._list.setGridSize(PICTURE + QSize(16, 36))
        self._list.setWordWrap(True)
        self._about = QLabel()
        self._about.setWordWrap(True)
        self._about.setProperty("role", "secondary")
        self._about.setMinimumHeight(3 * self.fontMetrics().lineSpacing() + 4)
        self._about.setAlignment(Qt.AlignmentFlag.AlignTop)
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Open | QDialogButtonBox.StandardButton.Cancel
        )
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 16, 16, 16)
        layout.setSpacing(12)
        for widget in (self._list, self._about, buttons):
            layout.addWidget(widget)

        colours, ratio = colours_for(self.palette()), self.devicePixelRatioF()
        for picture in gallery():
            pixmap = thumbnail(load(picture.path), PICTURE, ratio, colours)
            icon = QIcon(pixmap)
            icon.addPixmap(pixmap, QIcon.Mode.Selected)  # colours mean modes: no tint when selected
            item = QListWidgetItem(icon, picture.title)
            item.setData(Qt.ItemDataRole.UserRole, picture)
            item.setToolTip(picture.about)
            self._list.addItem(item)
        self._list.currentItemChanged.connect(self._show)
        self._list.itemActivated.connect(self.accept)
        self._list.setCurrentRow(0)

    def _show(self, item: QListWidgetItem | None) -> None:
        self.chosen = item.data(Qt.ItemDataRole.UserRole) if item is not None else None
        self._about.setText(self.chosen.about if self.chosen is not None else "")
