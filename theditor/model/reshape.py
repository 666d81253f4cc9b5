"""The selected curves in another degree or with other ends: one undo step, and one sentence on how well it went."""

from __future__ import annotations

from collections.abc import Callable

from theditor.drawing import Drawing
from theditor.model.document import Document
from theditor.model.long_edits import edit_curves, named
from theditor.model.selection import Selection
from theditor.model.words import shape_changed
from theditor.model.worker import Report
from theditor.spline import Curve, Ends, with_degree, with_ends
from theditor.spline.points import Edited

AT_ONCE = 4000
"""When curves have more control points than this together, refitting them is long work."""


def set_degree(document: Document, selection: Selection, degree: int, tell: Callable[[str], None]) -> None:
    """Make the selected curves quadratic or cubic, with all points refitted; tell how well it went."""
    document.settle()
    kind = "quadratic" if degree == 2 else "cubic"
    drawing, chosen = document.drawing, _editable(document.drawing, selection)
    if not chosen:
        return

    def refit(report: Report) -> dict[int, Edited]:
        edited = {}
        for number, i in enumerate(chosen):
            report(number / len(chosen))
            edited[i] = with_degree(drawing[i].curve, degree)
        return edited

    def finish(edited: dict[int, Edited]) -> str:
        return _replace(document, selection, edited, f"Make {{}} {kind}", f"Made {{}} {kind}")

    long = sum(len(drawing[i].curve.lambdas) for i in chosen) > AT_ONCE
    edit_curves(document, chosen, f"Making {named(drawing, chosen)} {kind}", refit, finish, tell, long=long)


def close(document: Document, selection: Selection) -> str:
    """Close the selected curves."""
    return _reshape(document, selection, lambda curve: with_ends(curve, True), "Close {}", "Closed {}")


def set_ends(document: Document, selection: Selection, ends: Ends) -> str:
    """Clamp or free the ends of the selected curves; closed ones are opened where they begin."""
    text, told = (
        ("Clamp {}", "Clamped {}") if ends == "clamped" else ("Free ends of {}", "Freed the ends of {}")
    )
    return _reshape(document, selection, lambda curve: with_ends(curve, False, ends), text, told)


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
    document: Document, selection: Selection, edit: Callable[[Curve], Edited], text: str, told: str
) -> str:
    """Edit the selected curves that are not locked."""
    document.settle()
    drawing = document.drawing
    edited = {i: edit(drawing[i].curve) for i in _editable(drawing, selection)}
    return _replace(document, selection, edited, text, told) if edited else ""


def _replace(
    document: Document, selection: Selection, edited: dict[int, Edited], text: str, told: str
) -> str:
    """Put edited curves in their places; segments and points selected on them go, as they are others."""
    drawing = document.drawing
    new = {i: result.curve for i, result in edited.items()}
    document.apply(text.format("curve" if len(new) == 1 else f"{len(new)} curves"), drawing.with_curves(new))
    if not new.keys().isdisjoint(selection.curves):
        selection.select_across(dict.fromkeys(selection.curves, ()), segments=())
    deviation = max(result.deviation for result in edited.values())
    return f"{told.format(named(drawing, new))}; {shape_changed(deviation, *new.values())}"


def _editable(drawing: Drawing, selection: Selection) -> list[int]:
    return [i for i in selection.curves if not drawing[i].locked]
