"""Asks in which format to export, and how, and shows what it will look like."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from typing import Any, Final, NamedTuple

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QVBoxLayout,
    QWidget,
)

from theditor.app.export_preview import ExportPreview
from theditor.app.problem_line import ProblemLine
from theditor.drawing import Drawing
from theditor.exchange import FORMATS, PARTS, Options, writable
from theditor.exchange.options import PAGE, PIXELS
from theditor.exchange.scene import PRINTED, visible
from theditor.panels.live_inputs import LiveField
from theditor.panels.parts import GAP, MARGIN, ComboBox, Paragraph, describe, row

_FIELD: Final = 96
_COLUMN: Final = 300
_PICTURE: Final = frozenset({"show", "look", "size", "tolerance"})


class _Asked(NamedTuple):
    """What a format is, and which rows of the dialog concern it."""

    about: str
    rows: frozenset[str]
    unit: str = "mm"
    usual: str = ""
    """The size of its own choice."""
    size: float = PAGE


_ASKED: Final[dict[str, _Asked]] = {
    ".svg": _Asked(
        "Ellipse arcs exactly, other curves as cubic Béziers. The drawing rides along: it opens here again "
        "without loss.",
        _PICTURE,
        usual="1 mm for each unit",
    ),
    ".pdf": _Asked(
        "One page in cubic Béziers, for papers and printers.", _PICTURE, usual=f"{PAGE:g} mm long"
    ),
    ".png": _Asked(
        "Pixels, for slides and web pages.",
        _PICTURE | {"dpi", "ground"},
        unit="pixels",
        usual=f"{PIXELS:g} pixels long",
        size=PIXELS,
    ),
    ".dxf": _Asked(
        "For CAD programs: ellipse arcs exactly, hyperbola arcs of quadratics too, other curves as cubic splines, a "
        "layer for each.",
        frozenset({"tolerance"}),
    ),
    ".tex": _Asked(
        "A TikZ picture for papers, whose labels TeX sets in its own fonts.",
        _PICTURE,
        usual=f"{PAGE:g} mm long",
    ),
    ".csv": _Asked(
        "Points along each curve, a row each, for spreadsheets and programs.",
        frozenset({"sampling", "samples", "columns", "tolerance"}),
    ),
}
_SAMPLING: Final = {
    "parameter": "Equal steps of the parameter",
    "length": "Equal arc lengths",
    "tolerance": "As many as the tolerance needs",
}
_WORDS: Final = {"polygon": "&Polygon", "points": "P&oints", "labels": "&Labels", "comb": "&Comb"}


class ExportDialog(QDialog):
    """Fields for what concerns the chosen format, with a picture of the outcome beside them.

    Parameters
    ----------
    drawing
        What is to be exported.
    suffix
        The format to begin with.
    kept
        Returns the options to begin with in a format.
    selected
        What can be exported instead.
    """

    wanted = Signal()
    """The user asks for the file: `suffix` and `options` say how."""

    def __init__(
        self,
        drawing: Drawing,
        suffix: str,
        kept: Callable[[str], Options],
        parent: QWidget,
        *,
        selected: Drawing,
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle("Export")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._kept = kept
        self._chosen: dict[str, Options] = {}
        self._suffix = ""
        self._show: frozenset[str] = frozenset()  # what of the parts was ticked by hand
        self._drawing, self._selected = drawing, selected
        self._make_fields()
        self.preview = ExportPreview(drawing)
        self.sentence = ProblemLine(2)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.button = buttons.addButton("&Export…", QDialogButtonBox.ButtonRole.AcceptRole)
        self.button.setDefault(True)
        buttons.accepted.connect(self.wanted)
        buttons.rejected.connect(self.reject)
        left = QVBoxLayout()
        left.setSpacing(GAP)
        left.addLayout(self._form)
        left.addStretch(1)
        across = QHBoxLayout()
        across.setSpacing(MARGIN)
        across.addLayout(left)
        across.addWidget(self.preview, alignment=Qt.AlignmentFlag.AlignTop)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(MARGIN, MARGIN, MARGIN, MARGIN)
        layout.setSpacing(GAP)
        layout.addLayout(across)
        layout.addWidget(self.sentence)
        layout.addWidget(buttons)
        self.format.setCurrentIndex(max(self.format.findData(suffix), 0))
        self._choose_format()
        self.format.currentIndexChanged.connect(self._choose_format)

    @property
    def suffix(self) -> str:
        """The format that is chosen."""
        return str(self.format.currentData())

    @property
    def drawing(self) -> Drawing:
        """What is to be exported."""
        return self._selected if self.curves.currentData() else self._drawing

    def options(self) -> Options:
        """Return what the fields say; a `ValueError` says in a sentence why that cannot be."""
        size = self.measure.currentData()
        sides: dict[str, Any] = {size: self.side.number()} if size else {}
        return Options(
            tolerance=self.tolerance.number(),
            dpi=self.dpi.number(),
            transparent=self.transparent.isChecked(),
            show=self._show,
            print_style=self.print_style.isChecked(),
            sampling=self.sampling.currentData(),
            samples=_whole(self.samples.number()),
            tangent=self.tangent.isChecked(),
            curvature=self.curvature.isChecked(),
            **sides,
        )

    # Fields

    def _make_fields(self) -> None:
        self.format, self.measure, self.sampling = ComboBox(), ComboBox(), ComboBox()
        describe(self.format, "Format", "Format of the file")
        self.format.setMinimumWidth(_COLUMN)  # the same for all formats
        for suffix in writable():
            self.format.addItem(f"{FORMATS[suffix].name} ({suffix})", suffix)
        self.about = Paragraph()
        self.curves = ComboBox()
        describe(self.curves, "Curves", "Which curves are exported; hidden ones are left out")
        count = len(visible(self._selected))
        self.curves.addItem("All", False)
        self.curves.addItem(f"The {count} selected" if count > 1 else "The selected one", True)
        self.parts = {part: self._box(_WORDS[part], f"Show the {part}") for part in PARTS}
        self.print_style = self._box(
            "As in a pape&r: with polygon, points, labels",
            "Black, with polygon, points and labels; every mode of segments in its own dashes",
        )
        describe(self.measure, "Size", "How large the picture is")
        self.side = self._number("Size of the picture", "Longer side, or millimetres for each unit", 0, 1e18)
        self.dpi = self._number("Dots per inch", "Pixels per inch: lines and letters keep their size", 1, 1e4)
        self.transparent = self._box("&Transparent ground", "No white ground")
        describe(self.sampling, "Where points are taken", "Where the points of the table are taken")
        for way, text in _SAMPLING.items():
            self.sampling.addItem(text, way)
        self.samples = self._number("Steps", "Steps for each segment, or for each curve", 1, 100_000)
        self.tangent = self._box("Tan&gent", "Columns for the unit tangent")
        self.curvature = self._box("C&urvature", "A column for the curvature")
        self.tolerance = self._number(
            "Tolerance",
            "Largest deviation where it cannot be exact, as a share of the drawing's size",
            1e-12,
            0.1,
        )
        self._steps = QLabel("&Steps")
        self._steps.setBuddy(self.samples)
        self._form = QFormLayout()
        self._form.setHorizontalSpacing(MARGIN)
        self._form.setVerticalSpacing(GAP)
        self._form.setLabelAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        self._form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self._rows: dict[str, int] = {}
        self._row("format", "&Format", self.format)
        self._row("about", "", self.about)
        self._row("curves", "Cur&ves", self.curves)
        self._row("show", "Show", row(*self.parts.values()))
        self._row("look", "", self.print_style)
        self._row("size", "&Size", row(self.measure, self.side))
        self._row("dpi", "&Dots per inch", self.dpi)
        self._row("ground", "", self.transparent)
        self._row("sampling", "&Along", self.sampling)
        self._row("samples", self._steps, self.samples)
        self._row("columns", "Columns", row(self.tangent, self.curvature))
        self._row("tolerance", "Tolera&nce, share of size", self.tolerance)
        self.measure.currentIndexChanged.connect(self._choose_size)
        self.sampling.currentIndexChanged.connect(self._show_rows)
        self.curves.currentIndexChanged.connect(self._refresh)

    def _row(self, name: str, label: str | QLabel, field: Any) -> None:
        self._rows[name] = self._form.rowCount()
        self._form.addRow(label, field)
        if name == "size":
            self._form.labelForField(field).setBuddy(self.measure)  # type: ignore[attr-defined]

    def _box(self, text: str, tip: str) -> QCheckBox:
        box = QCheckBox(text)
        describe(box, text.replace("&", ""), tip)
        box.toggled.connect(self._refresh)
        return box

    def _number(self, name: str, tip: str, least: float, most: float) -> LiveField:
        field = LiveField(least, most)
        describe(field, name, tip)
        field.setFixedWidth(_FIELD)
        field.edited.connect(self._refresh)
        return field

    # What belongs to the format

    def _choose_format(self) -> None:
        """Show the rows of the format, with what was chosen for it before."""
        if self._suffix:
            with suppress(ValueError):
                self._chosen[self._suffix] = self.options()
        self._suffix = self.suffix
        asked = _ASKED[self._suffix]
        self.about.setText(asked.about)
        with QSignalBlocker(self.measure):
            self.measure.clear()
            if asked.usual:
                self.measure.addItem(asked.usual, "")
                self.measure.addItem(f"Longer side, {asked.unit}", "size")
                self.measure.addItem("Millimetres for each unit", "scale")
        self._show_options(self._chosen.get(self._suffix) or self._kept(self._suffix))
        self._show_rows()

    def _show_options(self, options: Options) -> None:
        """Put options into the fields."""
        way = "scale" if options.scale else "size" if options.size else ""
        with QSignalBlocker(self.measure):
            self.measure.setCurrentIndex(max(self.measure.findData(way), 0))
        self._choose_size()
        if way:
            self.side.show_value(options.scale or options.size)
        self._show = options.show
        self._show_parts()
        for box, on in (
            (self.print_style, options.print_style),
            (self.transparent, options.transparent),
            (self.tangent, options.tangent),
            (self.curvature, options.curvature),
        ):
            box.setChecked(on)
        self.sampling.setCurrentIndex(self.sampling.findData(options.sampling))
        self.dpi.show_value(options.dpi)
        self.samples.show_value(options.samples)
        self.tolerance.show_value(options.tolerance)

    def _choose_size(self) -> None:
        """Begin with the size that the format has by itself."""
        way = self.measure.currentData()
        self.side.setVisible(bool(way))
        self.side.show_value(1.0 if way == "scale" else _ASKED[self._suffix].size)
        self._refresh()

    def _show_rows(self) -> None:
        """Show only what concerns the format."""
        by = self.sampling.currentData()
        shown = {"format", "about", *_ASKED[self._suffix].rows}
        if 0 < len(visible(self._selected)) < len(visible(self._drawing)):
            shown.add("curves")
        if "sampling" in shown:
            shown.discard("samples" if by == "tolerance" else "tolerance")
        self._steps.setText("&Steps for each curve" if by == "length" else "&Steps for each segment")
        for name, line in self._rows.items():
            self._form.setRowVisible(line, name in shown)
        self.side.setVisible("size" in shown and bool(self.measure.currentData()))
        self._refresh()

    def _show_parts(self) -> None:
        """Tick what is shown: what was ticked by hand, and what print style shows by itself."""
        for part, box in self.parts.items():
            printed = part in PRINTED and self.print_style.isChecked()
            with QSignalBlocker(box):
                box.setEnabled(not printed)
                box.setChecked(printed or part in self._show)

    def _refresh(self) -> None:
        """Show what the fields ask for, or say why that cannot be."""
        self._show = frozenset(
            part
            for part, box in self.parts.items()
            if (box.isChecked() if box.isEnabledTo(self) else part in self._show)
        )
        self._show_parts()
        problem = ""
        try:
            self.preview.show_outcome(self.drawing, self._suffix, self.options())
        except ValueError as error:
            problem = str(error)
        self.sentence.show_problem(problem)
        self.button.setEnabled(not problem)


def _whole(number: float) -> int:
    if number != round(number):
        raise ValueError(f"The number of steps must be a whole one, not {number:g}")
    return round(number)
