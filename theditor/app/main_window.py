"""The main window: the canvas, the panels around it, and the commands."""

from __future__ import annotations

import math
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import numpy as np
from PySide6.QtCore import QEvent, QPoint, QSettings, QSize, Qt, QTimer
from PySide6.QtGui import QCloseEvent, QKeySequence, QShowEvent
from PySide6.QtWidgets import (
    QApplication,
    QDockWidget,
    QLabel,
    QMainWindow,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from theditor.app.actions import commands
from theditor.app.clipboard import Clipboard
from theditor.app.context_menus import ContextMenus
from theditor.app.coordinates import Coordinates
from theditor.app.docks import Column, add_dock
from theditor.app.dropping import Dropping
from theditor.app.elided import Elided
from theditor.app.files import Files
from theditor.app.menus import build_menus, tint_icons
from theditor.app.outside import Outside
from theditor.app.problems import MessageBar
from theditor.app.toggles import keep_toggles, restore_toggles
from theditor.app.tour import GuideBar
from theditor.app.windows import open_windows, same_file
from theditor.app.work import Work
from theditor.app.work_card import WorkCard
from theditor.canvas import Canvas, Pointed
from theditor.drawing import Item
from theditor.model import Document, Selection
from theditor.model.naming import new_name
from theditor.model.recovery import Recovery
from theditor.panels.curve import CurvePanel
from theditor.panels.curves import CurvesPanel
from theditor.panels.lambda_strip import LambdaStrip
from theditor.panels.segment_info import SegmentPanel
from theditor.panels.segments import SegmentsPanel
from theditor.panels.shape import ShapePanel
from theditor.spline import MAX_COORDINATE, Curve, Mode

if TYPE_CHECKING:
    from theditor.panels.basis import BasisPanel
    from theditor.panels.continuity import ContinuityPanel
    from theditor.panels.curvature import CurvaturePanel
    from theditor.panels.history import HistoryPanel
    from theditor.panels.points import PointsPanel

Plot = TypeVar("Plot", "BasisPanel", "CurvaturePanel")

COLUMN_WIDTH = 400
LEAST_POSITION = 150
"""Room for usual coordinates in the status line, so that what is beside them stays where it is."""
MARGINS = 28
"""Beside the words of the status line, left and right together."""
STAYS, LEAST_READ = 8000, 2000
"""How long an announcement stays, and how long at least whatever the pointer finds, in milliseconds."""


class MainWindow(QMainWindow):
    """One drawing in a window. It starts empty; see `open_path`, `open_picture`."""

    def __init__(self) -> None:
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(1360, 860)
        self.document = Document(parent=self)
        self.selection = Selection(self.document, self)
        self.canvas = Canvas(self.document, self.selection)
        self.messages, self.guide = MessageBar(), GuideBar()
        self.recovery = Recovery(self.document, self)
        self.outside = Outside(self)
        self.files = Files(self)
        self.work = Work(self)
        WorkCard(self.work, self.canvas)
        self.clipboard = Clipboard(self)
        properties = self._build_docks()
        self.coordinates = Coordinates(self)
        self._build_panels(properties)
        self._tinted = (0, 0)
        self.commands = commands(self)
        self.actions_by_name = build_menus(self)
        self._tint_icons()
        if isinstance(app := QApplication.instance(), QApplication):
            app.screenAdded.connect(self._tint_icons)
        self.context_menus = ContextMenus(self)
        Dropping(self)
        self._build_status_line()
        self._follow()
        self._restore_layout()
        restore_toggles(self)
        self.canvas.setFocus()

    # Putting the window together

    def _build_docks(self) -> QDockWidget:
        """Put the canvas in the middle and docks around it; returns the one for the properties."""
        centre = QWidget()
        layout = QVBoxLayout(centre)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.messages)
        layout.addWidget(self.guide)
        layout.addWidget(self.canvas, stretch=1)
        self.setCentralWidget(centre)

        right, bottom = Qt.DockWidgetArea.RightDockWidgetArea, Qt.DockWidgetArea.BottomDockWidgetArea
        self.setCorner(Qt.Corner.BottomRightCorner, right)
        self.setTabPosition(bottom, QTabWidget.TabPosition.North)
        properties = add_dock(self, "Properties", "properties", lambda: self._column, right)
        tabs = [
            add_dock(self, title, name, partial(getattr, self, name), bottom)
            for title, name in (
                ("λ strip", "lambda_strip"),
                ("Points", "points"),
                ("Basis", "basis"),
                ("Curvature", "curvature"),
                ("Continuity", "continuity"),
                ("History", "history"),
            )
        ]
        tabs[0].raise_()
        self.resizeDocks([properties], [COLUMN_WIDTH], Qt.Orientation.Horizontal)
        self.resizeDocks(tabs[:1], [196], Qt.Orientation.Vertical)
        return properties

    def _build_panels(self, properties: QDockWidget) -> None:
        self._column = Column(properties)
        model, place = (self.document, self.selection), self._column.place
        self.curves, self.curve = CurvesPanel(*model, place), CurvePanel(*model, place)
        self.shape, self.segments = ShapePanel(*model, place), SegmentsPanel(*model, place)
        self.segment = SegmentPanel(*model, place)
        self._column.stack((self.curves, self.curve, self.shape, self.segments, self.segment), self.segments)
        self.lambda_strip = LambdaStrip(*model)
        self.curves.add_requested.connect(self.add_curve)
        self.curves.recolour_requested.connect(self.curve.choose_colour)

    def _build_status_line(self) -> None:
        bar = self.statusBar()
        bar.setSizeGripEnabled(False)
        self._position, self._over, self._zoom, self._hint = QLabel(), Elided(), QLabel(), Elided()
        self._found = ""  # under the pointer
        self._announced = QTimer(self, singleShot=True, interval=STAYS)
        self._announced.timeout.connect(self.end_announcement)
        self._position.setProperty("role", "strong")
        self._position.setMinimumWidth(LEAST_POSITION)
        bar.addWidget(self._position)
        bar.addWidget(self._over, 1)
        bar.addPermanentWidget(self._zoom)
        bar.addPermanentWidget(self._hint)
        self.canvas.pointed.connect(self._show_pointed)
        self.shape.hovered.connect(self.canvas.show_reach)
        self.lambda_strip.hovered.connect(self.canvas.show_reach)
        self.canvas.tool_changed.connect(lambda name: self.actions_by_name[f"tool_{name}"].setChecked(True))
        panels = (self.curves, self.curve, self.shape, self.segments, self.lambda_strip)
        for panel in (self.canvas, *panels):
            panel.announce.connect(self.announce)

    # Panels that are made when first seen

    @cached_property
    def points(self) -> PointsPanel:
        """The table of control points."""
        from theditor.panels.points import PointsPanel

        panel = PointsPanel(self.document, self.selection)
        panel.announce.connect(self.announce)
        return panel

    @cached_property
    def basis(self) -> BasisPanel:
        """The basis functions of a segment."""
        from theditor.panels.basis import BasisPanel

        return self._linked(BasisPanel(self.document, self.selection))

    @cached_property
    def curvature(self) -> CurvaturePanel:
        """The plot of curvature, and how its comb looks on the canvas."""
        from theditor.panels.curvature import CurvaturePanel

        panel = self._linked(CurvaturePanel(self.document, self.selection))
        panel.comb_changed.connect(self._show_comb)
        return panel

    @cached_property
    def continuity(self) -> ContinuityPanel:
        """The joints and how smooth they are."""
        from theditor.panels.continuity import ContinuityPanel

        panel = ContinuityPanel(self.document, self.selection)
        panel.hovered.connect(self.canvas.show_place)
        return panel

    @cached_property
    def history(self) -> HistoryPanel:
        """The steps of the document."""
        from theditor.panels.history import HistoryPanel

        return HistoryPanel(self.document)

    def _linked(self, panel: Plot) -> Plot:
        """Let a plot and the canvas show each other's place."""
        panel.hovered.connect(self.canvas.show_place)
        self.canvas.pointed.connect(lambda pointed: panel.show_place(pointed.u))
        return panel

    def _follow(self) -> None:
        document, stack = self.document, self.document.undo_stack
        document.started.connect(self.guide.hide)
        self.recovery.failed.connect(
            lambda problem: self.announce(f"Unsaved work cannot be kept for a crash: {problem}")
        )
        document.travelling.connect(self.end_announcement)
        document.renamed.connect(self._show_title)
        document.changed.connect(self._show_state)
        stack.cleanChanged.connect(self._show_state)
        stack.indexChanged.connect(self._show_state)
        self.selection.changed.connect(self._show_state)
        self._show_title()

    # Showing what is the case

    def _show_title(self) -> None:
        title = self.document.title.replace("[*]", "[*][*]")  # else Qt would put its mark there
        self.setWindowTitle(f"{title}[*] — theditor")
        self.setWindowFilePath(str(self.document.path or ""))
        self._show_state()

    def _show_state(self, *_: object) -> None:
        stack = self.document.undo_stack
        self.setWindowModified(not self.document.is_clean)
        for name, text in (("undo", stack.undoText()), ("redo", stack.redoText())):
            action = self.actions_by_name[name]
            verb = name.capitalize()
            action.setText(f"&{verb} {text}".rstrip())
            action.setIconText(verb)
            keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
            action.setToolTip(f"{verb} {text}".rstrip() + f" ({keys})")
        can = {enabled: enabled(self) for enabled in {command.enabled for command in self.commands}}
        for command in self.commands:
            self.actions_by_name[command.name].setEnabled(can[command.enabled])

    def announce(self, text: str) -> None:
        """Say something in the status line, until some seconds pass or the pointer finds something later on.

        Undo and redo end it: what it tells of may be undone.
        """
        self._announced.start()
        self._say(text)

    def end_announcement(self) -> None:
        """Show what the pointer finds in place of what was announced."""
        self._announced.stop()
        self._say(self._found)

    def _say(self, text: str) -> None:
        """Show words in the status line; an announcement also takes the room of what is to its right."""
        self._over.setText(text)
        self._over.setToolTip(text)
        beside = (self._zoom, self._hint)
        wide, room = self._over.sizeHint().width(), self.statusBar().width() - self._over.x()
        self._over.least = room - MARGINS
        fits = wide + sum(label.sizeHint().width() for label in beside) <= room
        for label in beside:
            label.setVisible(fits or not self._announced.isActive())

    @property
    def announced(self) -> str:
        """What the status line says beside the pointer's position."""
        return self._over.text()

    def _show_pointed(self, pointed: Pointed) -> None:
        position = pointed.position
        digits = max(3, math.ceil(math.log10(pointed.scale)) + 1)  # to a tenth of a pixel or finer
        words = "" if position is None else f"x {position[0]:z.{digits}f}   y {position[1]:z.{digits}f}"
        self._position.setText(words := words.replace("-", "−"))
        wide = self._position.fontMetrics().horizontalAdvance(words) + MARGINS
        self._position.setMinimumWidth(max(LEAST_POSITION, wide))
        unread = self._announced.remainingTime() > STAYS - LEAST_READ
        self._found = pointed.over
        if (pointed.over and not unread) or not self._announced.isActive():
            self.end_announcement()
        self._hint.setText(pointed.hint)
        self._zoom.setText(f"zoom {pointed.scale:.3g} px/unit")

    def _show_comb(self, length: float, density: int) -> None:
        """Show the curvature comb, with teeth of that length and number."""
        self.canvas.set_shown(comb_length=length, comb_density=density)
        self.actions_by_name["show_comb"].setChecked(True)

    # Files

    def open_path(self, path: Path) -> bool:
        """Open a file; if it cannot be read, say why and keep the drawing."""
        return self.files.open_path(path)

    def open_picture(self, name: str) -> None:
        """Open a copy of a gallery picture; saving it asks for a file."""
        self.files.open_picture(name)

    def may_discard(self) -> bool:
        """Whether the drawing may go: nothing is unsaved, or the user saved it or gave it up."""
        return self.files.may_discard()

    # Editing

    def set_mode(self, mode: Mode) -> None:
        """Give the λ that the λ panel acts on a mode or, on one curve, its segments if no point is selected."""
        selection = self.selection
        if selection.count or (len(selection.curves) > 1 and not selection.segments):
            self.shape.set_mode(mode)
        else:
            self.segments.set_mode(mode)

    def add_curve(self) -> None:
        """Add a clamped curve in the middle of the view, to be dragged into shape, and make it current."""
        from theditor.canvas.pen import preferred_degree  # loaded when it is first asked for

        plane, drawing = self.canvas.plane, self.document.drawing
        reach = 0.3 * min(plane.width, plane.height) / plane.scale
        shape = [(-1.2, -0.5), (-0.7, 0.6), (0.0, -0.3), (0.7, 0.6), (1.2, -0.5)]
        points = (np.array(shape) * reach + (plane.x, plane.y)).clip(-MAX_COORDINATE, MAX_COORDINATE)
        curve = Curve(points, degree=preferred_degree(), ends="clamped")
        item = Item(curve, name=new_name({item.name for item in drawing}))
        self.document.apply("Add curve", drawing.inserted(len(drawing), item))
        self.selection.select(curve=len(drawing))

    # The window itself

    def has_room_for(self, path: Path | None) -> bool:
        """Whether nothing was done here yet, and no other file than the one at `path` is open."""
        document = self.document
        unused = document.is_clean and document.undo_stack.count() == 0
        return unused and (document.path is None or same_file(document.path, path))

    def beside(self) -> MainWindow:
        """Open another, empty window beside this one."""
        window = MainWindow()
        window.move(self.pos() + QPoint(32, 32))
        window.show()
        return window

    def come_to_front(self) -> None:
        """Be the window the user is in."""
        self.raise_()
        self.activateWindow()

    def quit(self) -> None:
        """Close all windows, unless one of them stays."""
        QApplication.closeAllWindows()

    def changeEvent(self, event: QEvent) -> None:
        """Draw the icons in the colours of the theme."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "_tinted"):
            self._tint_icons()
        elif event.type() == QEvent.Type.ActivationChange and self.isActiveWindow():
            self.outside.check()

    def _tint_icons(self) -> None:
        look = QApplication.palette().cacheKey(), len(QApplication.screens())
        if look != self._tinted:  # Qt tells of the palette once more when the window is first shown
            self._tinted = look
            tint_icons(self)

    def showEvent(self, event: QShowEvent) -> None:
        """Count as open from now on."""
        super().showEvent(event)
        if self not in open_windows:
            open_windows.append(self)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Ask about unsaved changes, and keep the layout for the next time."""
        if not self.may_discard():
            event.ignore()
            return
        self.work.stop()
        self.files.leave()
        if self in open_windows:
            open_windows.remove(self)
        settings = QSettings()
        settings.setValue("geometry", self.saveGeometry())
        settings.setValue("layout", self.saveState())
        keep_toggles(self)
        event.accept()

    def _restore_layout(self) -> None:
        settings = QSettings()
        geometry, layout = settings.value("geometry"), settings.value("layout")
        if geometry is not None and layout is not None:
            self.restoreGeometry(geometry)
            self.restoreState(layout)

    def sizeHint(self) -> QSize:
        """A size at which nothing scrolls for Figure 10."""
        return QSize(1360, 860)
