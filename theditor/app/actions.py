"""The table of commands: each declared once, with its words, its key and what it does.

Menus and toolbar are made of it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QKeySequence

from theditor.app.lambda_dialogs import LambdaDialog, formula_dialog, gradient_dialog, smooth_dialog
from theditor.spline import KNOWN, Known, Mode

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow

Keys = tuple[str | QKeySequence.StandardKey, ...]


@dataclass(frozen=True)
class Command:
    """Something the user can do.

    Attributes
    ----------
    menu
        Title of the menu it is in; ``"View/Show"`` is a submenu.
    text, tip
        A verb phrase for the menu, with its mnemonic, and a sentence for the status line and the tooltip.
    run
        What it does; a checkable command is also given its new state.
    keys
        Standard keys or key names; the first that exists on the platform is shown.
    on_canvas
        The key acts only while the canvas has the focus (single letters).
    checked
        Initial state of a checkable command, None for others.
    brief
        Text on the toolbar; empty for commands that are not there.
    gap
        Whether a separator goes before it.
    """

    name: str
    menu: str
    text: str
    tip: str
    run: Callable[..., object]
    keys: Keys = ()
    on_canvas: bool = False
    checked: bool | None = None
    brief: str = ""
    gap: bool = False


_Standard = QKeySequence.StandardKey


def commands(window: MainWindow) -> tuple[Command, ...]:
    """All commands of a window, in the order of its menus."""
    canvas, document = window.canvas, window.document

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
            gap=gap,
        )

    def mode(name: str, mode: Mode, text: str, key: str, *, gap: bool = False) -> Command:
        return Command(
            name,
            "Curve",
            text,
            f"Make the selected points or segments {mode.value}; all of them if none is selected",
            lambda: window.set_mode(mode),
            (key,),
            on_canvas=True,
            gap=gap,
        )

    def insert(known: Known, text: str) -> Command:
        name = known.name.lower()
        article = "an" if name[0] in "aeiou" else "a"
        return Command(
            f"insert_{name.replace(' ', '_')}",
            "Insert",
            f"{text}…",
            f"Insert {article} {name}, exact, by its parameters",
            lambda: window.insert(known),
        )

    def many(name: str, text: str, tip: str, dialog: LambdaDialog, *, gap: bool = False) -> Command:
        return Command(name, "Curve", text, tip, lambda: window.change_lambdas(dialog), gap=gap)

    return (
        Command("new", "File", "&New", "Start an empty drawing", window.files.new, (_Standard.New,)),
        Command("open", "File", "&Open…", "Open a drawing from a file", window.files.open, (_Standard.Open,)),
        Command(
            "gallery",
            "File",
            "Open &gallery…",
            "Choose one of the paper's figures or a known curve from pictures",
            window.files.open_gallery,
            ("Ctrl+G",),
        ),
        Command("save", "File", "&Save", "Save the drawing", window.files.save, (_Standard.Save,), gap=True),
        Command(
            "save_as",
            "File",
            "Save &as…",
            "Save the drawing to another file",
            window.files.save_as,
            (_Standard.SaveAs, "Ctrl+Shift+S"),
        ),
        Command(
            "quit", "File", "&Quit", "Close all windows", window.quit, (_Standard.Quit, "Ctrl+Q"), gap=True
        ),
        Command(
            "undo", "Edit", "&Undo", "Take the last step back", document.undo, (_Standard.Undo,), brief="Undo"
        ),
        Command(
            "redo",
            "Edit",
            "&Redo",
            "Do the step last taken back once more",
            document.redo,
            (_Standard.Redo, "Ctrl+Shift+Z", "Ctrl+Y"),
            brief="Redo",
        ),
        Command(
            "select_all",
            "Edit",
            "Select &all",
            "Select all control points of the current curve",
            window.select_all,
            (_Standard.SelectAll,),
            gap=True,
        ),
        Command(
            "select_none",
            "Edit",
            "Select &none",
            "Select no control point and no segment",
            window.select_none,
            ("Ctrl+Shift+A",),
        ),
        Command(
            "add",
            "Curve",
            "&Add curve",
            "Add a curve in the middle of the view",
            window.add_curve,
            ("Ctrl+Shift+N",),
        ),
        Command(
            "duplicate",
            "Curve",
            "&Duplicate curve",
            "Add a copy of the current curve",
            window.curves.duplicate,
            ("Ctrl+D",),
        ),
        Command("delete", "Curve", "De&lete curve", "Remove the current curve", window.curves.delete),
        mode("trigonometric", Mode.TRIGONOMETRIC, "Make segments &trigonometric", "T", gap=True),
        mode("hyperbolic", Mode.HYPERBOLIC, "Make segments &hyperbolic", "H"),
        mode("interpolating", Mode.INTERPOLATING, "Make segments &interpolating", "I"),
        many(
            "gradient",
            "λ &gradient…",
            "Let λ run evenly over the selected points, those of the selected segments, or the curve",
            gradient_dialog,
            gap=True,
        ),
        many("smooth", "&Smooth λ…", "Draw λ that jump up and down towards their neighbours", smooth_dialog),
        many("formula", "λ by &formula…", "Give each λ the value of a formula in i, n and λ", formula_dialog),
        Command(
            "keep_hull",
            "Curve",
            "&Keep the convex hull",
            "Let pulls and slides of the curve stay where the convex hull bounds it",
            canvas.keep_hull,
            checked=False,
            gap=True,
        ),
        Command(
            "reverse",
            "Curve",
            "&Reverse direction",
            "Run through the current curve the other way",
            window.reverse,
            gap=True,
        ),
        *map(insert, KNOWN, _with_mnemonics([known.name for known in KNOWN])),
        Command(
            "fit", "View", "&Fit", "Show the whole drawing", canvas.fit, ("F",), on_canvas=True, brief="Fit"
        ),
        Command(
            "zoom_in",
            "View",
            "Zoom &in",
            "Enlarge the picture",
            lambda: canvas.zoom(1.25),
            (_Standard.ZoomIn, "Ctrl+="),
        ),
        Command(
            "zoom_out",
            "View",
            "Zoom &out",
            "Shrink the picture",
            lambda: canvas.zoom(1 / 1.25),
            (_Standard.ZoomOut,),
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
        shown("ghost", "G&host", "Show the curve as it was while it is dragged", gap=True),
        shown("uniform", "Ordinary &B-spline", "Show the uniform B-spline of the same degree and polygon"),
        shown("legend", "L&egend", "Show which colour means which mode"),
        Command(
            "tour",
            "Help",
            "&Gallery…",
            "Choose one of the paper's figures or a known curve, with what to try on it",
            window.files.open_gallery,
        ),
        Command("about", "Help", "&About theditor", "Version, licence and the paper behind it", window.about),
    )


def _with_mnemonics(names: list[str]) -> list[str]:
    """Mark in each name the first letter that no earlier one has taken."""
    taken: set[str] = set()
    marked = []
    for name in names:
        place = next(i for i, letter in enumerate(name) if letter.lower() not in taken)
        taken.add(name[place].lower())
        marked.append(f"{name[:place]}&{name[place:]}")
    return marked


def make_action(window: MainWindow, command: Command) -> QAction:
    """The action of a command, with its keys in force."""
    action = QAction(command.text, window)
    action.setObjectName(command.name)
    sequences = [s for key in command.keys for s in _sequences(key)]
    action.setShortcuts(list(dict.fromkeys(sequences)))
    shortcut = f" ({sequences[0].toString(QKeySequence.SequenceFormat.NativeText)})" if sequences else ""
    action.setToolTip(command.tip + shortcut)
    action.setStatusTip(command.tip)
    if command.brief:
        action.setIconText(command.brief)
    if command.on_canvas:
        action.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
        window.canvas.addAction(action)
    if command.checked is None:
        action.triggered.connect(lambda _checked=False: command.run())
    else:
        action.setCheckable(True)
        action.setChecked(command.checked)
        action.toggled.connect(command.run)
    return action


def _sequences(key: str | QKeySequence.StandardKey) -> list[QKeySequence]:
    return [QKeySequence(key)] if isinstance(key, str) else QKeySequence.keyBindings(key)
