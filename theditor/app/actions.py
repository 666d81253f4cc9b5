"""The table of commands: each declared once, with its words, its key, when it can be done and what it does.

Menus, toolbar, context menus, the command palette and the sheet of shortcuts are made of it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtGui import QKeySequence

from theditor.app import dialogs
from theditor.app.command import Command, can_edit_any, has_curve
from theditor.app.curve_commands import curve_commands
from theditor.app.point_commands import point_commands
from theditor.app.select_commands import select_commands
from theditor.app.view_commands import view_commands
from theditor.spline import KNOWN, Known

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow

_Standard = QKeySequence.StandardKey


def can_undo(window: MainWindow) -> bool:
    """Needs a step to take back; a hand on the drawing counts."""
    return window.document.undo_stack.canUndo() or window.document.before is not None


def can_redo(window: MainWindow) -> bool:
    """Needs a step that was taken back."""
    return window.document.undo_stack.canRedo()


def commands(window: MainWindow) -> tuple[Command, ...]:
    """All commands of a window, in the order of its menus."""
    canvas, document = window.canvas, window.document

    def insert(known: Known) -> Command:
        name = known.name.lower()
        article = "an" if name[0] in "aeiou" else "a"
        return Command(
            f"insert_{name.replace(' ', '_')}",
            "Insert",
            f"{known.name}…",
            f"Insert {article} {name}, exact, by its parameters",
            lambda: dialogs.insert_known(window, known),
        )

    def tool(name: str, text: str, tip: str, keys: tuple[str, ...], brief: str) -> Command:
        return Command(
            f"tool_{name}",
            "Tools",
            text,
            tip,
            lambda on: canvas.use(name) if on else None,
            keys,
            on_canvas=True,
            checked=name == "select",
            choice="tool",
            brief=brief,
            icon=name,
        )

    return (
        Command(
            "new", "File", "&New", "Start an empty drawing", window.files.new, (_Standard.New,), icon="new"
        ),
        Command(
            "open",
            "File",
            "&Open…",
            "Open a drawing from a file",
            window.files.open,
            (_Standard.Open,),
            icon="open",
        ),
        Command(
            "gallery",
            "File",
            "Open &gallery…",
            "Choose one of the paper's figures or a known curve from pictures",
            window.files.open_gallery,
            ("Ctrl+G",),
            icon="gallery",
        ),
        Command(
            "save",
            "File",
            "&Save",
            "Save the drawing",
            window.files.save,
            (_Standard.Save,),
            icon="save",
            gap=True,
        ),
        Command(
            "save_as",
            "File",
            "Save &as…",
            "Save the drawing to another file",
            window.files.save_as,
            (_Standard.SaveAs, "Ctrl+Shift+S"),
        ),
        Command(
            "import",
            "File",
            "&Import…",
            "Add curves from files of other programs, SVG pictures and tables of points, to the drawing",
            lambda: dialogs.import_files(window),
            ("Ctrl+I",),
            icon="import",
            gap=True,
        ),
        Command(
            "export",
            "File",
            "&Export…",
            "Write the drawing as a picture or a table for other programs: SVG, PDF, PNG, DXF, TikZ, CSV",
            lambda: dialogs.export(window),
            ("Ctrl+E", "Ctrl+Shift+E"),
            has_curve,
            icon="export",
        ),
        Command(
            "recover",
            "File",
            "Reco&ver…",
            "Bring back work that was not saved before the program ended, or that was discarded in the last days",
            lambda: dialogs.recover(window),
            gap=True,
        ),
        Command(
            "quit", "File", "&Quit", "Close all windows", window.quit, (_Standard.Quit, "Ctrl+Q"), gap=True
        ),
        Command(
            "undo",
            "Edit",
            "&Undo",
            "Take the last step back",
            document.undo,
            (_Standard.Undo,),
            can_undo,
            brief="Undo",
            icon="undo",
        ),
        Command(
            "redo",
            "Edit",
            "&Redo",
            "Do the step last taken back once more",
            document.redo,
            (_Standard.Redo, "Ctrl+Shift+Z", "Ctrl+Y"),
            can_redo,
            brief="Redo",
            icon="redo",
        ),
        Command(
            "cut",
            "Edit",
            "Cu&t",
            "Copy the selected curves, and delete them",
            window.clipboard.cut,
            ("Ctrl+X",),
            can_edit_any,
            places=("curve",),
            gap=True,
            icon="cut",
        ),
        Command(
            "copy",
            "Edit",
            "&Copy",
            "Copy the curves on which something is selected, whole: as curves, as text and as a picture",
            window.clipboard.copy,
            ("Ctrl+C",),
            has_curve,
            places=("point", "segment", "curve"),
            icon="copy",
        ),
        Command(
            "paste",
            "Edit",
            "&Paste",
            "Paste curves, an SVG picture, its path data or a table of numbers as curves, at the pointer",
            window.clipboard.paste,
            ("Ctrl+V",),
            places=("point", "segment", "ground"),
            icon="paste",
        ),
        Command(
            "paste_in_place",
            "Edit",
            "Paste in p&lace",
            "Paste curves, an SVG picture, its path data or a table of numbers as curves, at their own coordinates",
            window.clipboard.paste_in_place,
            ("Ctrl+Alt+V",),
            places=("ground",),
        ),
        *select_commands(window),
        Command(
            "preferences",
            "Edit",
            "&Preferences…",
            "Theme, nudge step and the degree of new curves",
            lambda: dialogs.show_preferences(window),
            (_Standard.Preferences, "Ctrl+,"),
            gap=True,
        ),
        *curve_commands(window),
        *map(insert, KNOWN),
        *point_commands(window),
        tool("select", "&Select and move", "Select, move and shape with the mouse", ("S", "N"), "Select"),
        tool("pen", "&Pen", "Draw a curve by its control points, one click each", ("B",), "Pen"),
        tool("freehand", "&Freehand", "Draw a stroke, which becomes a curve", ("P",), "Freehand"),
        Command(
            "snap",
            "Tools",
            "S&nap",
            "Draw points that are moved or placed to control points, joints, curves and the grid; Shift suspends it",
            canvas.set_snapping,
            ("%",),
            on_canvas=True,
            checked=False,
            brief="Snap",
            gap=True,
            icon="snap",
        ),
        *view_commands(window),
        Command(
            "palette",
            "Help",
            "&Find a command…",
            "Type a few letters of what you want to do",
            lambda: dialogs.find_command(window),
            ("Ctrl+Shift+P",),
            places=("ground",),
        ),
        Command(
            "shortcuts",
            "Help",
            "&Keys and mouse…",
            "Everything the keys and the mouse do",
            lambda: dialogs.show_shortcuts(window),
            ("?", "F1"),
        ),
        Command(
            "tour",
            "Help",
            "&Gallery…",
            "Choose one of the paper's figures or a known curve, with what to try on it",
            window.files.open_gallery,
            icon="gallery",
        ),
        Command(
            "about",
            "Help",
            "&About theditor",
            "Version, licence and the paper behind it",
            lambda: dialogs.show_about(window),
        ),
    )
