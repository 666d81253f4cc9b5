"""Where panels dwell: a scrolling column on the right, tabs below the canvas; both can be moved and hidden."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QShowEvent
from PySide6.QtWidgets import QDockWidget, QFrame, QMainWindow, QScrollArea, QVBoxLayout, QWidget

from theditor.model import colours_for


class Grip(QWidget):
    """A slim title bar for a dock: a row of dots to drag it by; the tabs say what it is."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFixedHeight(10)
        self.setCursor(Qt.CursorShape.SizeAllCursor)
        self.setToolTip("Drag to move the panel; double-click to let it float, or to put it back")

    def sizeHint(self) -> QSize:
        """As slim as it may be."""
        return QSize(40, 10)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the dots."""
        painter = QPainter(self)
        colours = colours_for(self.palette())
        painter.fillRect(self.rect(), QColor(colours.panel))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(colours.border))
        for k in range(-2, 3):
            painter.drawEllipse(self.width() // 2 + 6 * k, 4, 3, 3)
        painter.end()


class Column(QScrollArea):
    """Panels one above the other with rules between them, which scroll if they are too high.

    They are to be made in their `place`: Qt would style anew what comes from elsewhere.
    """

    def __init__(self, dock: QWidget) -> None:
        super().__init__(dock)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.place = QWidget()
        self.setWidget(self.place)

    def stack(self, panels: Iterable[QWidget], stretching: QWidget) -> None:
        """Put panels one above the other; `stretching` takes what room is left."""
        layout = QVBoxLayout(self.place)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        for panel in panels:
            if layout.count():
                rule = QFrame(self.place)
                rule.setProperty("role", "rule")
                layout.addWidget(rule)
            layout.addWidget(panel, stretch=1 if panel is stretching else 0)

    def showEvent(self, event: QShowEvent) -> None:
        """Let nothing be painted that the panels hide."""
        super().showEvent(event)
        self.place.setAutoFillBackground(True)

    def minimumSizeHint(self) -> QSize:
        """Wide enough for the panels, so that only their height scrolls."""
        bar = self.verticalScrollBar().sizeHint().width()
        return QSize(self.place.minimumSizeHint().width() + bar, super().minimumSizeHint().height())


class Dock(QDockWidget):
    """Holds a panel, which is made when the dock is first seen and hidden while another tab is before it.

    Qt takes docks behind tabs for visible. Here `isVisible` of a panel says whether it can be seen, so that it may
    rest while it cannot.
    """

    def __init__(self, title: str, name: str, make: Callable[[], QWidget], parent: QWidget) -> None:
        super().__init__(title, parent)
        self.setObjectName(name)
        self.setTitleBarWidget(Grip(self))
        self._make = make
        self.visibilityChanged.connect(self._show_panel)

    def _show_panel(self, seen: bool) -> None:
        if seen and self.widget() is None:
            panel = self._make()
            policy = panel.sizePolicy()
            policy.setRetainSizeWhenHidden(True)  # or the docks would change their sizes with every tab
            panel.setSizePolicy(policy)
            self.setWidget(panel)
        if self.widget() is not None:
            self.widget().setVisible(seen)


def add_dock(
    window: QMainWindow, title: str, name: str, make: Callable[[], QWidget], area: Qt.DockWidgetArea
) -> QDockWidget:
    """Make a dock at an edge of the window for a panel, as a further tab if there is a dock already."""
    dock = Dock(title, name, make, window)
    others = [
        d for d in window.findChildren(QDockWidget) if d is not dock and window.dockWidgetArea(d) == area
    ]
    window.addDockWidget(area, dock)
    if others:
        window.tabifyDockWidget(others[-1], dock)
    return dock
