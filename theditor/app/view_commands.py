"""The commands that change what is shown of a drawing, and in which colours."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtGui import QKeySequence

from theditor.app.command import Command, has_curve
from theditor.app.theme import Theme, choose_theme, chosen_theme
from theditor.app.view import zoom_to_selection

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow

_Standard = QKeySequence.StandardKey


def view_commands(window: MainWindow) -> tuple[Command, ...]:
    """The commands of the menu View, in its order."""
    canvas = window.canvas

    def shown(name: str, text: str, tip: str, *, gap: bool = False, brief: str = "") -> Command:
        state = getattr(canvas.shown, name)
        return Command(
            f"show_{name}",
            "View",
            text,
            tip,
            lambda on: canvas.set_shown(**{name: on}),
            checked=state,
            brief=brief,
            icon=name if brief else "",
            gap=gap,
        )

    def theme(theme: Theme, text: str) -> Command:
        return Command(
            f"theme_{theme}",
            "View/Theme",
            text,
            f"Use the colours of the {theme} theme",
            lambda on: choose_theme(theme) if on else None,
            checked=theme is chosen_theme(),
            choice="theme",
        )

    return (
        Command(
            "fit",
            "View",
            "&Fit",
            "Show the whole drawing",
            canvas.fit,
            ("F",),
            on_canvas=True,
            brief="Fit",
            icon="fit",
            places=("ground",),
        ),
        Command(
            "zoom_selection",
            "View",
            "Zoom to &selection",
            "Show the selected points and segments as large as they go; the selected curves if there are none",
            lambda: zoom_to_selection(canvas, window.selection),
            ("3",),
            has_curve,
            on_canvas=True,
            places=("point", "segment", "curve"),
        ),
        Command(
            "zoom_in",
            "View",
            "Zoom &in",
            "Enlarge the picture",
            lambda: canvas.zoom(1.25),
            (_Standard.ZoomIn, "Ctrl+="),
            icon="zoom_in",
        ),
        Command(
            "zoom_out",
            "View",
            "Zoom &out",
            "Shrink the picture",
            lambda: canvas.zoom(1 / 1.25),
            (_Standard.ZoomOut,),
            icon="zoom_out",
        ),
        shown("polygon", "Control &polygon", "Show the control polygon", gap=True, brief="Polygon"),
        shown("labels", "&Labels", "Show the names of the control points", brief="Labels"),
        shown("joints", "&Joints", "Show where segments meet", brief="Joints"),
        shown(
            "modes", "&Mode colours", "Colour the current curve by the modes of its segments", brief="Modes"
        ),
        shown("grid", "&Grid", "Show the grid", brief="Grid"),
        shown(
            "comb", "Curvature &comb", "Show the curvature as teeth along the curve", gap=True, brief="Comb"
        ),
        shown("marks", "&Inflections and extremes", "Mark inflections and extremes of curvature"),
        shown("circle", "&Osculating circle", "Show the osculating circle at the pointer"),
        shown("hull", "Convex &hull", "Show the convex hull of the selected segments", brief="Hull"),
        shown("guards", "&Warnings", "Mark segments that the convex hull does not bound"),
        shown("ghost", "Ghost while dragging", "Show the curve as it was while it is dragged", gap=True),
        shown("uniform", "Ordinary &B-spline", "Show the uniform B-spline of the same degree and polygon"),
        Command(
            "show_coordinates",
            "View",
            "C&oordinates at the selection",
            "Show x and y of the selected points beside them, to be typed; Enter goes there",
            window.coordinates.set_on,
            checked=True,
        ),
        shown("legend", "L&egend", "Show which colour means which mode"),
        theme(Theme.SYSTEM, "&System"),
        theme(Theme.LIGHT, "&Light"),
        theme(Theme.DARK, "&Dark"),
    )
