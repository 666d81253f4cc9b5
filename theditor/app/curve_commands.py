"""The commands that edit whole curves, and λ along them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from theditor.app import dialogs
from theditor.app.command import Command, can_edit, can_edit_any, has_curve
from theditor.model import reshape
from theditor.spline import Mode

if TYPE_CHECKING:
    from theditor.app.main_window import MainWindow


def curve_commands(window: MainWindow) -> tuple[Command, ...]:
    """The commands of the menu Curve, in its order, but for those that make pieces."""
    canvas, document = window.canvas, window.document

    def mode(name: str, mode: Mode, text: str, key: str, *, gap: bool = False) -> Command:
        return Command(
            name,
            "Curve",
            text,
            f"Make the selected points or segments {mode.value}; all of them if none is selected",
            lambda: window.set_mode(mode),
            (key,),
            can_edit,
            on_canvas=True,
            icon=name,
            places=("point", "segment"),
            gap=gap,
        )

    def many(
        name: Literal["gradient", "smooth", "formula"], text: str, tip: str, *, gap: bool = False
    ) -> Command:
        return Command(
            name,
            "Curve",
            text,
            tip,
            lambda: dialogs.change_lambdas(window, name),
            enabled=can_edit,
            places=("point", "segment"),
            gap=gap,
        )

    return (
        Command(
            "add",
            "Curve",
            "&Add curve",
            "Add a curve in the middle of the view",
            window.add_curve,
            ("Ctrl+Shift+N",),
            places=("ground",),
            icon="add",
        ),
        Command(
            "duplicate",
            "Curve",
            "&Duplicate curves",
            "Put a copy of each selected curve on top of it",
            window.curves.duplicate,
            ("Ctrl+D",),
            has_curve,
            places=("segment", "curve"),
            icon="duplicate",
        ),
        Command(
            "delete",
            "Curve",
            "De&lete curves",
            "Remove the selected curves",
            window.curves.delete,
            ("Delete",),
            can_edit_any,
            on_list=True,
            places=("segment", "curve"),
            icon="delete",
        ),
        Command(
            "rename",
            "Curve",
            "Re&name curve",
            "Give the current curve another name, in the list of curves",
            window.curves.rename,
            enabled=can_edit,
            places=("curve",),
            gap=True,
        ),
        Command(
            "recolour",
            "Curve",
            "Recol&our curves…",
            "Give the selected curves another colour",
            window.curve.choose_colour,
            enabled=can_edit_any,
            places=("curve",),
        ),
        Command(
            "hide",
            "Curve",
            "Hide or sho&w curves",
            "Hide the selected curves, or show them again",
            window.curves.toggle_visible,
            enabled=has_curve,
            places=("curve",),
        ),
        Command(
            "lock",
            "Curve",
            "Lo&ck or unlock curves",
            "Guard the selected curves against edits, or let them be edited again",
            window.curves.toggle_locked,
            enabled=has_curve,
            places=("curve",),
        ),
        Command(
            "move_up",
            "Curve",
            "Move &up in the list",
            "Move the current curve one place up in the list, which draws it further beneath",
            lambda: window.curves.reorder(-1),
            ("Ctrl+Up",),
            lambda window: window.selection.curve > 0,
            on_list=True,
            places=("curve",),
            gap=True,
        ),
        Command(
            "move_down",
            "Curve",
            "Mo&ve down in the list",
            "Move the current curve one place down in the list, which draws it further on top",
            lambda: window.curves.reorder(1),
            ("Ctrl+Down",),
            lambda window: 0 <= window.selection.curve < len(window.document.drawing) - 1,
            on_list=True,
            places=("curve",),
        ),
        mode("trigonometric", Mode.TRIGONOMETRIC, "Make segments &trigonometric", "T", gap=True),
        mode("hyperbolic", Mode.HYPERBOLIC, "Make segments &hyperbolic", "H"),
        mode("interpolating", Mode.INTERPOLATING, "Make segments &interpolating", "I"),
        many(
            "gradient",
            "λ &gradient…",
            "Let λ run evenly over the selected points, those of the selected segments, or the curve",
            gap=True,
        ),
        many("smooth", "&Smooth λ…", "Draw λ that jump up and down towards their neighbours"),
        many("formula", "λ by &formula…", "Give each λ the value of a formula in i, n and λ"),
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
            "Run through the selected curves the other way",
            lambda: window.announce(reshape.reverse(document, window.selection)),
            enabled=can_edit_any,
            places=("segment", "curve"),
            gap=True,
        ),
    )
