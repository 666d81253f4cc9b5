"""The selected curves in another degree or with other ends: one undo step, and one sentence on how well it went."""

from __future__ import annotations

from collections.abc import Callable

from theditor.model.document import Document
from theditor.model.long_edits import edit_curves, named
from theditor.model.selection import Selection
from theditor.model.words import shape_changed
from theditor.model.worker import Report, part_of
from theditor.spline import Curve, Ends, with_degree, with_ends
from theditor.spline.points import Edited

AT_ONCE = 4000
"""When curves have more control points than this together, refitting them is long work."""
FEW = 5
"""The same for more curves than this."""

Tell = Callable[[str], None]


def set_degree(document: Document, selection: Selection, degree: int, tell: Tell) -> None:
    """Make the selected curves quadratic or cubic, with all points refitted; tell how well it went."""
    kind = "quadratic" if degree == 2 else "cubic"
    words = f"Make {{}} {kind}", f"Making {{}} {kind}", f"Made {{}} {kind};"
    _reshape(document, selection, lambda curve, report: with_degree(curve, degree, report), words, tell)


def close(document: Document, selection: Selection, tell: Tell) -> None:
    """Close the selected curves; tell how well it went."""
    words = "Close {}", "Closing {}", "Closed {} by a new part from end to start; elsewhere"
    _reshape(document, selection, lambda curve, _: with_ends(curve, True), words, tell)


def set_ends(document: Document, selection: Selection, ends: Ends, tell: Tell) -> None:
    """Clamp or free the ends of the selected curves; closed ones are opened where they begin."""
    words = (
        ("Clamp {}", "Clamping {}", "Clamped {};")
        if ends == "clamped"
        else ("Free ends of {}", "Freeing the ends of {}", "Freed the ends of {};")
    )
    _reshape(document, selection, lambda curve, _: with_ends(curve, False, ends), words, tell)


def reverse(document: Document, selection: Selection) -> str:
    """Run through the selected curves the other way; what is selected on them stays selected."""
    document.settle()
    drawing, chosen = document.drawing, selection.chosen
    new = {i: drawing[i].curve.reversed() for i in chosen if not drawing[i].locked}
    if not new:
        return ""
    points = {i: len(drawing[i].curve.lambdas) - 1 - of if i in new else of for i, of in chosen.items()}
    segments = selection.segments
    if selection.curve in new:
        curve = drawing[selection.curve].curve
        last = curve.segment_count - 1 - (curve.closed and curve.degree == 3)
        segments = frozenset((last - segment) % curve.segment_count for segment in segments)
    document.apply(
        "Reverse direction" if len(new) == 1 else f"Reverse {len(new)} curves", drawing.with_curves(new)
    )
    selection.select_across(points, selection.curve, segments)
    named = f"“{drawing[min(new)].name}” runs" if len(new) == 1 else f"{len(new)} curves run"
    return f"{named} the other way now; the shape is the same"


def _reshape(
    document: Document,
    selection: Selection,
    edit: Callable[[Curve, Report], Edited],
    words: tuple[str, str, str],
    tell: Tell,
) -> None:
    """Edit the selected curves that are not locked.

    Segments and points selected on them go, as they are others. The words are those for the undo step, for what
    is going on, and for what was done; ``{}`` stands for the curves.
    """
    document.settle()
    drawing = document.drawing
    chosen = [i for i in selection.curves if not drawing[i].locked]
    if not chosen:
        return
    step, doing, done = words

    def edit_all(report: Report) -> dict[int, Edited]:
        edited = {}
        for number, i in enumerate(chosen):
            report(number / len(chosen))
            edited[i] = edit(drawing[i].curve, part_of(report, number, len(chosen)))
        return edited

    def finish(edited: dict[int, Edited]) -> str:
        new = {i: result.curve for i, result in edited.items()}
        of = "curve" if len(new) == 1 else f"{len(new)} curves"
        document.apply(step.format(of), document.drawing.with_curves(new))
        if not new.keys().isdisjoint(selection.curves):
            selection.select_across(dict.fromkeys(selection.curves, ()), segments=())
        deviation = max(result.deviation for result in edited.values())
        return f"{done.format(named(drawing, chosen))} {shape_changed(deviation, *new.values())}"

    long = len(chosen) > FEW or sum(len(drawing[i].curve.lambdas) for i in chosen) > AT_ONCE
    edit_curves(document, chosen, doing.format(named(drawing, chosen)), edit_all, finish, tell, long=long)
