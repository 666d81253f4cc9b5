"""The main window: the canvas, the panels around it, and the commands."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PySide6.QtCore import QSettings, QSize, Qt
from PySide6.QtGui import QAction, QActionGroup, QCloseEvent
from PySide6.QtWidgets import (
    QApplication,
    QDockWidget,
    QFileDialog,
    QLabel,
    QMainWindow,
    QMenu,
    QMessageBox,
    QTabWidget,
    QToolBar,
    QVBoxLayout,
    QWidget,
)

from theditor.app.actions import commands, make_action
from theditor.app.docks import add_dock, scrolling_column
from theditor.app.gallery_dialog import GalleryDialog
from theditor.app.lambda_dialogs import LambdaDialog
from theditor.app.problems import MessageBar, log
from theditor.app.recent import recent_files, remember_file
from theditor.app.theme import Theme, choose_theme, chosen_theme
from theditor.canvas import Canvas, Pointed
from theditor.drawing import DrawingError, Item, load
from theditor.model import Document, Selection
from theditor.panels.basis import BasisPanel
from theditor.panels.continuity import ContinuityPanel
from theditor.panels.curvature import CurvaturePanel
from theditor.panels.curve import CurvePanel
from theditor.panels.curves import CurvesPanel
from theditor.panels.lambda_strip import LambdaStrip
from theditor.panels.segment_info import SegmentPanel
from theditor.panels.segments import SegmentsPanel
from theditor.panels.shape import ShapePanel
from theditor.resources import gallery, version
from theditor.spline import MAX_COORDINATE, Curve

FILE_FILTER = "theditor drawings (*.json);;All files (*)"
COLUMN_WIDTH = 400


class MainWindow(QMainWindow):
    """One drawing in a window. It starts empty; see `open_path`, `open_picture`, `new`."""

    def __init__(self) -> None:
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose, False)
        self.resize(1360, 860)
        self.setMinimumSize(720, 480)
        self.document = Document(parent=self)
        self.selection = Selection(self.document, self)
        self.canvas = Canvas(self.document, self.selection)
        self.messages = MessageBar()
        self._build_panels()
        self._build_commands()
        self._build_status_line()
        self._follow()
        self._restore_layout()
        self.canvas.setFocus()

    # Putting the window together

    def _build_panels(self) -> None:
        centre = QWidget()
        layout = QVBoxLayout(centre)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.messages)
        layout.addWidget(self.canvas, stretch=1)
        self.setCentralWidget(centre)

        model = self.document, self.selection
        self.curves, self.curve = CurvesPanel(*model), CurvePanel(*model)
        self.shape, self.segments, self.segment = (
            ShapePanel(*model),
            SegmentsPanel(*model),
            SegmentPanel(*model),
        )
        self.strip = LambdaStrip(*model)
        self.basis, self.curvature = BasisPanel(*model), CurvaturePanel(*model)
        self.continuity = ContinuityPanel(*model)
        self.curves.add_requested.connect(self.add_curve)
        column = (self.curves, self.curve, self.shape, self.segments, self.segment)

        right, bottom = Qt.DockWidgetArea.RightDockWidgetArea, Qt.DockWidgetArea.BottomDockWidgetArea
        self.setCorner(Qt.Corner.BottomRightCorner, right)
        self.setTabPosition(bottom, QTabWidget.TabPosition.North)
        properties = add_dock(
            self, "Properties", "properties", scrolling_column(column, self.segments), right
        )
        properties.setTitleBarWidget(QWidget())
        tabs = [
            add_dock(self, title, name, panel, bottom)
            for title, name, panel in (
                ("λ strip", "lambda_strip", self.strip),
                ("Basis", "basis", self.basis),
                ("Curvature", "curvature", self.curvature),
                ("Continuity", "continuity", self.continuity),
            )
        ]
        tabs[0].raise_()
        self.resizeDocks([properties], [COLUMN_WIDTH], Qt.Orientation.Horizontal)
        self.resizeDocks(tabs[:1], [196], Qt.Orientation.Vertical)

    def _build_commands(self) -> None:
        self.actions_by_name: dict[str, QAction] = {}
        toolbar = QToolBar("Toolbar")
        toolbar.setObjectName("toolbar")
        toolbar.setMovable(False)
        toolbar.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
        self.addToolBar(toolbar)
        menus: dict[str, QMenu] = {}
        group = ""
        for command in commands(self):
            menu = menus.get(command.menu) or self.menuBar().addMenu("&" + command.menu)
            menus[command.menu] = menu
            if command.gap:
                menu.addSeparator()
            action = make_action(self, command)
            self.actions_by_name[command.name] = action
            menu.addAction(action)
            if command.brief:
                part = command.name.split("_")[0]
                if group and part != group and not {part, group} <= {"undo", "redo"}:
                    toolbar.addSeparator()
                group = part
                toolbar.addAction(action)
        self._recent = QMenu("Open &recent", self)
        self._recent.aboutToShow.connect(self._list_recent)
        menus["File"].insertMenu(self.actions_by_name["gallery"], self._recent)
        self._build_view_menu(menus["View"])

    def _build_view_menu(self, menu: QMenu) -> None:
        menu.addSeparator()
        themes = menu.addMenu("&Theme")
        choice = QActionGroup(self)
        for theme, text in ((Theme.SYSTEM, "&System"), (Theme.LIGHT, "&Light"), (Theme.DARK, "&Dark")):
            action = themes.addAction(text)
            action.setObjectName(f"theme_{theme}")
            action.setCheckable(True)
            action.setChecked(theme is chosen_theme())
            action.triggered.connect(lambda _checked=False, theme=theme: choose_theme(theme))
            choice.addAction(action)
        panels = menu.addMenu("&Panels")
        for dock in self.findChildren(QDockWidget):
            panels.addAction(dock.toggleViewAction())

    def _build_status_line(self) -> None:
        bar = self.statusBar()
        bar.setSizeGripEnabled(False)
        self._position, self._over, self._zoom, self._hint = (QLabel() for _ in range(4))
        self._position.setProperty("role", "strong")
        self._position.setMinimumWidth(150)
        bar.addWidget(self._position)
        bar.addWidget(self._over, 1)
        bar.addPermanentWidget(self._zoom)
        bar.addPermanentWidget(self._hint)
        self.canvas.pointed.connect(self._show_pointed)
        self.shape.hovered.connect(self.canvas.show_reach)
        self.strip.hovered.connect(self.canvas.show_reach)
        for linked in (self.basis, self.curvature, self.continuity):
            linked.hovered.connect(self.canvas.show_place)
        self.curvature.comb_changed.connect(self._show_comb)
        for panel in (self.curves, self.curve, self.shape, self.segments, self.strip):
            panel.announce.connect(lambda text: bar.showMessage(text, 8000))

    def _follow(self) -> None:
        document, stack = self.document, self.document.undo_stack
        document.renamed.connect(self._show_title)
        document.changed.connect(self._show_state)
        stack.cleanChanged.connect(self._show_state)
        stack.indexChanged.connect(self._show_state)
        self.selection.changed.connect(self._show_state)
        self._show_title()

    # Showing what is the case

    def _show_title(self) -> None:
        self.setWindowTitle(f"{self.document.title}[*] — theditor")
        self.setWindowFilePath(str(self.document.path or ""))
        self._show_state()

    def _show_state(self, *_: object) -> None:
        stack, item = self.document.undo_stack, self.selection.item
        self.setWindowModified(not self.document.is_clean)
        for name, can, text in (
            ("undo", stack.canUndo(), stack.undoText()),
            ("redo", stack.canRedo(), stack.redoText()),
        ):
            action = self.actions_by_name[name]
            verb = name.capitalize()
            action.setEnabled(can or (name == "undo" and not self.document.is_clean))
            action.setText(f"&{verb} {text}".rstrip())
            action.setIconText(verb)
        editable = item is not None and not item.locked
        modes, many = ("trigonometric", "hyperbolic", "interpolating"), ("gradient", "smooth", "formula")
        for name in ("delete", "reverse", *modes, *many):
            self.actions_by_name[name].setEnabled(editable)
        for name in ("duplicate", "select_all"):
            self.actions_by_name[name].setEnabled(item is not None)

    def _show_pointed(self, pointed: Pointed) -> None:
        position = pointed.position
        digits = 3 if pointed.scale < 1e4 else 6
        words = "" if position is None else f"x {position[0]:.{digits}f}   y {position[1]:.{digits}f}"
        self._position.setText(words.replace("-", "−"))
        self._over.setText(pointed.over)
        self._hint.setText(pointed.hint)
        self._zoom.setText(f"zoom {pointed.scale:.3g} px/unit")
        self.basis.show_place(pointed.u)
        self.curvature.show_place(pointed.u)

    def _show_comb(self, length: float, density: int) -> None:
        """Show the curvature comb, with teeth of that length and number."""
        self.canvas.set_shown(comb_length=length, comb_density=density)
        self.actions_by_name["show_comb"].setChecked(True)

    # Files

    def new(self) -> None:
        """Start an empty drawing, once the old one may go."""
        if self.may_discard():
            self.document.start(type(self.document.drawing)())
            self.canvas.fit()

    def open(self) -> None:
        """Ask for a file and open it."""
        if self.may_discard():
            folder = str(self.document.path.parent) if self.document.path else ""
            name, _ = QFileDialog.getOpenFileName(self, "Open a drawing", folder, FILE_FILTER)
            if name:
                self.open_path(Path(name))

    def open_path(self, path: Path) -> bool:
        """Open a file; if it cannot be read, say why and keep the drawing."""
        try:
            self.document.open(path)
        except DrawingError as error:
            self._report(error)
            return False
        remember_file(path)
        self.messages.hide()
        self.canvas.fit()
        return True

    def open_gallery(self) -> None:
        """Let the user choose a picture from the gallery and open a copy of it."""
        if self.may_discard():
            dialog = GalleryDialog(self)
            if dialog.exec() and dialog.chosen is not None:
                self.open_picture(dialog.chosen.name)

    def open_picture(self, name: str) -> None:
        """Open a copy of a gallery picture; saving it asks for a file."""
        picture = next(picture for picture in gallery() if picture.name == name)
        self.document.start(load(picture.path), picture.title.split(" · ")[0])
        self.messages.hide()
        self.canvas.fit()

    def save(self) -> bool:
        """Save to the document's file, or ask for one."""
        if self.document.path is None:
            return self.save_as()
        return self._save_to(self.document.path)

    def save_as(self) -> bool:
        """Ask for a file and save to it."""
        self.document.settle()
        suggestion = self.document.path or Path(f"{self.document.title}.json")
        name, _ = QFileDialog.getSaveFileName(self, "Save the drawing", str(suggestion), FILE_FILTER)
        if not name:
            return False
        path = Path(name)
        return self._save_to(path if path.suffix else path.with_suffix(".json"))

    def _save_to(self, path: Path) -> bool:
        try:
            self.document.save(path)
        except DrawingError as error:
            self._report(error)
            return False
        remember_file(path)
        self.messages.hide()
        self.statusBar().showMessage(f"Saved {path}", 5000)
        return True

    def may_discard(self) -> bool:
        """Whether the drawing may go: nothing is unsaved, or the user saved it or gave it up."""
        self.document.settle()
        if self.document.is_clean:
            return True
        buttons = QMessageBox.StandardButton
        answer = QMessageBox.question(
            self,
            "Unsaved changes",
            f"“{self.document.title}” has changes that are not saved. Save them?",
            buttons.Save | buttons.Discard | buttons.Cancel,
            buttons.Save,
        )
        return answer == buttons.Discard or (answer == buttons.Save and self.save())

    def _list_recent(self) -> None:
        self._recent.clear()
        for path in recent_files():
            action = self._recent.addAction(str(path).replace("&", "&&"))
            action.triggered.connect(
                lambda _checked=False, path=path: self.may_discard() and self.open_path(path)
            )
        if self._recent.isEmpty():
            self._recent.addAction("No files yet").setEnabled(False)

    def _report(self, error: DrawingError) -> None:
        log.warning("%s", error)
        self.messages.tell(str(error))

    # Editing

    def select_all(self) -> None:
        """Select every control point of the current curve."""
        item = self.selection.item
        if item is not None:
            self.selection.select(points=range(len(item.curve.control_points)), segments=())

    def select_none(self) -> None:
        """Select no point and no segment."""
        self.selection.select(points=(), segments=())

    def add_curve(self) -> None:
        """Add a clamped cubic in the middle of the view, to be dragged into shape, and make it current."""
        plane, drawing = self.canvas.plane, self.document.drawing
        reach = 0.3 * min(plane.width, plane.height) / plane.scale
        shape = [(-1.2, -0.5), (-0.7, 0.6), (0.0, -0.3), (0.7, 0.6), (1.2, -0.5)]
        points = (np.array(shape) * reach + (plane.x, plane.y)).clip(-MAX_COORDINATE, MAX_COORDINATE)
        names = {item.name for item in drawing}
        number = next(n for n in range(1, len(drawing) + 2) if f"Curve {n}" not in names)
        item = Item(Curve(points, ends="clamped"), name=f"Curve {number}")
        self.document.apply("Add curve", drawing.inserted(len(drawing), item))
        self.selection.select(curve=len(drawing))

    def change_lambdas(self, dialog: LambdaDialog) -> None:
        """Ask how to change many λ at once, or say why none can be."""
        try:
            dialog(self.document, self.selection, self).open()
        except ValueError as error:
            self.statusBar().showMessage(str(error), 8000)

    def reverse(self) -> None:
        """Run through the current curve the other way; its shape stays."""
        item = self.selection.item
        if item is not None:
            self.document.apply_curve("Reverse direction", self.selection.curve, item.curve.reversed())

    # The window itself

    def about(self) -> None:
        """Say what this is."""
        QMessageBox.about(
            self,
            "About theditor",
            f"<b>theditor {version()}</b><p>An editor for TH-type uniform B-splines: quadratic and cubic curves "
            "whose segments are trigonometric, hyperbolic or interpolating, as their shape parameters λ say.</p>"
            "<p>After J. Xie, <i>A Geometric Modeling Method Based on TH-Type Uniform B-Splines</i>, "
            "Mathematical Problems in Engineering 2014, 242469.</p><p>MIT licence.</p>",
        )

    def quit(self) -> None:
        """Close all windows, unless one of them stays."""
        QApplication.closeAllWindows()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Ask about unsaved changes, and keep the layout for the next time."""
        if not self.may_discard():
            event.ignore()
            return
        settings = QSettings()
        settings.setValue("geometry", self.saveGeometry())
        settings.setValue("layout", self.saveState())
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
