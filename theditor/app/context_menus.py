"""Context menus of the canvas and of the lists, made from the table of commands."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QEvent, QObject, QPoint
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtWidgets import QMenu

from theditor.app.command import Place
from theditor.app.menus import draw_icons
from theditor.canvas.hit_test import JointHit, MiddleHit, PointHit, SegmentHit
from theditor.canvas.projection import projected

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow


class ContextMenus(QObject):
    """Pops up the menu of what the mouse, or the menu key, points at; it is selected first."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._places: dict[QObject, Place] = {
            window.curves.list: "curve",
            window.curves.list.viewport(): "curve",
            window.segments.list: "segment",
            window.segments.list.viewport(): "segment",
        }
        for watched in (window.canvas, window.canvas.viewport(), *self._places):
            watched.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Pop up the menu in place of what the widget would do."""
        if not isinstance(event, QContextMenuEvent):
            return False
        at = event.globalPos()
        if watched in self._places:
            self.menu(self._places[watched]).popup(at)
        elif event.reason() == QContextMenuEvent.Reason.Keyboard:
            self._popup_at_selection()
        else:
            self.menu(self._select(event.pos())).popup(at)
        return True

    def menu(self, place: Place) -> QMenu:
        """Return the commands that belong to a place, in the order of the table."""
        menu = QMenu(self._window)
        menu.aboutToHide.connect(menu.deleteLater)
        above = ""
        for command in self._window.commands:
            if place in command.places:
                if above and (command.gap or command.menu != above):
                    menu.addSeparator()
                above = command.menu
                menu.addAction(self._window.actions_by_name[command.name])
        draw_icons(self._window, menu.actions())
        return menu

    def _select(self, at: QPoint) -> Place:
        """Select what lies under a pixel of the canvas, unless it is already, and say what it is."""
        selection = self._window.selection
        match self._window.canvas.hit(np.array([at.x(), at.y()], dtype=float)):
            case PointHit(curve, point):
                if point not in selection.chosen[curve]:
                    selection.select(curve=curve, points={point}, segments=())
                return "point"
            case JointHit(point):
                if point not in selection.points:
                    selection.select(points={point}, segments=())
                return "point"
            case MiddleHit(segment):
                curve = selection.curve
            case SegmentHit(curve, segment, _):
                pass
            case _:
                return "ground"
        if len(selection.curves) > 1 and curve in selection.chosen:
            return "point" if selection.count else "segment"
        if curve != selection.curve or segment not in selection.segments:
            selection.select(curve=curve, points=(), segments={segment})
        return "segment"

    def _popup_at_selection(self) -> None:
        """Pop up the menu of what is selected, at its place on the canvas."""
        canvas, selection = self._window.canvas, self._window.selection
        at = canvas.rect().center()
        place: Place = "ground"
        if selection.item is not None and (selection.points or selection.segments):
            place = "point" if selection.points else "segment"
            curve = projected(selection.item.curve)
            where = (
                curve.control_points[min(selection.points)]
                if selection.points
                else curve(min(selection.segments) + 0.5)
            )
            x, y = canvas.plane.to_pixels(where).clip(0, [canvas.width(), canvas.height()]).tolist()
            at = QPoint(int(x), int(y))
        self.menu(place).popup(canvas.mapToGlobal(at))
