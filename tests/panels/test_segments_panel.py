import numpy as np
import pytest
from panel_hand import CTRL, LEFT, NONE, SHIFT, Hand, some_curve
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest

from theditor.drawing import Drawing, Item
from theditor.model import LIGHT, Document, Selection
from theditor.panels import SegmentPanel, SegmentsPanel, segment_model
from theditor.panels.segment_list import cell_rects
from theditor.spline import INTERPOLATING, Mode, known, negative_basis, recognise, recognise_segments

KEY = Qt.Key
T, H, STAR = Mode.TRIGONOMETRIC, Mode.HYPERBOLIC, Mode.INTERPOLATING


@pytest.fixture
def panel(document, selection, show):
    panel = SegmentsPanel(document, selection)
    panel.said = []
    panel.announce.connect(panel.said.append)
    return show(panel, 340, 400)


def click_mode(panel, row, mode):
    rect = panel.list.visualRect(panel.model.index(row))
    Hand(panel.list.viewport()).click_at(cell_rects(rect)[mode].center())


def click_row(panel, row, modifiers=NONE):
    rect = panel.list.visualRect(panel.model.index(row))
    QTest.mouseClick(panel.list.viewport(), LEFT, modifiers, QPoint(rect.left() + 80, rect.center().y()))


def texts(panel):
    return [panel.model.index(row).data() for row in range(panel.model.rowCount())]


def description(info):
    return info.text.text().split("\n")


def modes(document):
    return document.drawing[0].curve.modes


def test_rows_read_as_the_curves_segments(panel, document):
    names = [found and found.name for found in recognise_segments(document.drawing[0].curve)]
    assert names[:7] == [*["general trigonometric arc", None, None, None], *["general hyperbolic arc"] * 3]
    assert texts(panel) == [mode.value for mode in modes(document)]
    spoken = panel.model.index(4).data(Qt.ItemDataRole.AccessibleTextRole)
    assert spoken == "Segment 5, hyperbolic"


def test_known_curves_go_by_their_names_and_lose_them_with_their_shape(show):
    wheel = known.trochoid(arm=2.0, quarters=4)
    document = Document(Drawing([Item(wheel), Item(known.ellipse(quarters=3, degree=2))]))
    selection = Selection(document)
    panel = show(SegmentsPanel(document, selection), 340, 300)
    assert texts(panel) == ["trochoid, prolate"] * 4
    document.apply_curve("Move", 0, wheel.with_points(0, [[9, 9]]))
    assert texts(panel) == ["trigonometric", *["trochoid, prolate"] * 3]
    click_mode(panel, 2, H)
    assert texts(panel) == [
        "trigonometric",
        "blend · was trigonometric",
        "hyperbolic",
        "blend · was trigonometric",
    ]
    tip = panel.model.index(2).data(Qt.ItemDataRole.ToolTipRole)
    assert tip == "Segment 3: hyperbolic, shaped by λ₃ and λ₄"
    selection.select(curve=1)
    assert texts(panel) == ["ellipse arc"] * 3
    tip = panel.model.index(2).data(Qt.ItemDataRole.ToolTipRole)
    assert tip == "Segment 3: ellipse arc (trigonometric), shaped by λ₃ and λ₄"


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("degree", [2, 3])
def test_rows_with_a_negative_basis_function_are_marked_and_say_why(show, degree, closed):
    lambdas = np.zeros(200)
    lambdas[[0, 5, 64, 65, 130, 198]] = 5.0, 4.5, -17.5, 6.0, -20.0, 3.9
    curve = some_curve(lambdas, degree=degree, closed=closed)
    document = Document(Drawing([Item(curve)]))
    panel = show(SegmentsPanel(document, Selection(document)), 340, 300)
    guards = negative_basis(curve)
    reasons = [guards.reason(segment) for segment in range(curve.segment_count)]
    assert sum(map(bool, reasons)) >= 5
    for row, reason in enumerate(reasons):
        index = panel.model.index(row)
        assert index.data(panel.model.WarningRole).lower() == reason.lower()
        assert reason[1:] in index.data(Qt.ItemDataRole.ToolTipRole)
        assert reason[1:] in index.data(Qt.ItemDataRole.AccessibleTextRole)


def test_the_mark_is_painted(panel, document):
    row = panel.list.visualRect(panel.model.index(5))
    before = panel.list.viewport().grab(row).toImage()
    document.apply_curve("Change λ", 0, document.drawing[0].curve.with_lambdas(6, 5.0))
    marked = panel.list.viewport().grab(row).toImage()
    colour = QColor(LIGHT.warning)

    def count(image):
        return sum(
            image.pixelColor(x, y) == colour for x in range(image.width()) for y in range(image.height())
        )

    assert count(before) == 0
    assert count(marked) > 30


def test_toggling_a_segment_sets_both_its_parameters_and_tells_of_its_neighbours(panel, document, selection):
    click_mode(panel, 5, T)
    assert document.drawing[0].curve.lambdas[[6, 7]].tolist() == [0, 0]
    assert selection.segments == {5}
    assert document.undo_stack.undoText() == "Make segment 6 trigonometric"
    assert panel.said == ["Segment 6 is trigonometric; segments 5 and 7 became blends."]
    assert texts(panel)[4:7] == ["blend · was hyperbolic", "trigonometric", "blend · was hyperbolic"]
    document.apply_curve("Move", 0, document.drawing[0].curve.with_points(0, [[9, 9]]))
    assert texts(panel)[4:7] == ["blend", "trigonometric", "blend"]
    document.undo()
    document.undo()
    assert texts(panel)[4:7] == ["hyperbolic"] * 3


def test_a_button_in_a_selected_row_acts_on_all_selected_and_in_another_row_on_that_one(
    panel, document, selection
):
    click_row(panel, 1)
    click_row(panel, 3, CTRL)
    click_row(panel, 8, CTRL)
    assert selection.segments == {1, 3, 8}
    click_mode(panel, 3, H)
    assert [modes(document)[s] for s in (1, 3, 8)] == [H, H, H]
    assert document.undo_stack.undoText() == "Make 3 segments hyperbolic"
    assert selection.segments == {1, 3, 8}
    click_mode(panel, 5, STAR)
    assert selection.segments == {5}
    assert document.drawing[0].curve.lambdas[[6, 7]].tolist() == [INTERPOLATING[3]] * 2


def test_list_and_curve_share_one_selection(panel, selection):
    selection.select(points=[2], segments=[4, 5, 7])
    rows = {index.row() for index in panel.list.selectionModel().selectedIndexes()}
    assert rows == {4, 5, 7}
    click_row(panel, 2)
    assert (selection.segments, selection.points) == ({2}, set())
    click_row(panel, 6, SHIFT)
    assert selection.segments == {2, 3, 4, 5, 6}
    selection.select(segments=())
    assert not panel.list.selectionModel().hasSelection()
    selection.select(curve=1)
    assert panel.model.rowCount() == 13
    assert panel.model.index(0).data(panel.model.NumberRole) == 0
    selection.select(segments=[12])
    assert [index.row() for index in panel.list.selectionModel().selectedIndexes()] == [12]


@pytest.mark.parametrize(("key", "mode"), [(KEY.Key_T, T), (KEY.Key_H, H), (KEY.Key_I, STAR)])
def test_letters_set_the_selected_segments(panel, document, selection, qtbot, key, mode):
    selection.select(segments=[1, 8])
    panel.list.setFocus()
    qtbot.keyClick(panel.list, key)
    assert [modes(document)[s] for s in (1, 8)] == [mode, mode]
    assert selection.segments == {1, 8}


def test_without_a_selection_the_command_means_every_segment(panel, document):
    panel.set_mode(H)
    assert set(modes(document)) == {H}
    assert panel.said == ["10 segments are hyperbolic."]


def test_only_rows_whose_segment_changed_are_redrawn(panel, document):
    redrawn = []
    panel.model.dataChanged.connect(lambda a, b: redrawn.append((a.row(), b.row())))
    curve = document.drawing[0].curve
    document.apply_curve("Move", 0, curve.with_points(5, [[9, 9]]))
    document.apply_curve("Change λ", 0, document.drawing[0].curve.with_lambdas(9, 0.6))
    assert redrawn == [(2, 5), (7, 8)]


def test_only_visible_rows_of_a_long_curve_are_named(show, monkeypatch):
    asked = []

    def recognised(curve, segments):
        asked.extend(segments)
        return recognise_segments(curve, segments)

    counted = []

    row_count = segment_model.SegmentModel.rowCount

    def count_rows(model, parent=segment_model.NO_INDEX):
        counted.append(1)
        return row_count(model, parent)

    monkeypatch.setattr(segment_model.SegmentModel, "rowCount", count_rows)
    monkeypatch.setattr(segment_model, "recognise_segments", recognised)
    curve = some_curve([0.0] * 100_000)
    document = Document(Drawing([Item(curve)]))
    panel = show(SegmentsPanel(document, Selection(document)), 340, 400)
    panel.list.grab()
    assert 10 < len(asked) == len(set(asked)) < 50
    asked.clear()
    counted.clear()
    document.apply_curve("Move", 0, curve.with_points(4, [[9, 9]]))
    panel.list.grab()
    assert sorted(asked) == [1, 2, 3, 4]
    assert len(counted) < 200  # a list view that lays all its rows out anew asks once a row
    panel.list.scrollToBottom()
    panel.list.grab()
    assert max(asked) == curve.segment_count - 1
    assert len(asked) < 60


def test_a_clamped_end_follows_its_one_parameter(show):
    document = Document(Drawing([Item(some_curve([0, 0.5, 1, 1, 0.5, 0], ends="clamped"))]))
    panel = show(SegmentsPanel(document, Selection(document)), 340, 300)
    click_mode(panel, 0, H)
    assert document.drawing[0].curve.lambdas.tolist() == [0, 1, 1, 1, 0.5, 0]
    assert texts(panel)[:3] == ["hyperbolic"] * 3


def test_a_locked_curve_stays_as_it_is_and_says_why(show, qtbot):
    document = Document(Drawing([Item(some_curve(), "Guarded", locked=True)]))
    selection = Selection(document)
    panel = show(SegmentsPanel(document, selection), 340, 400)
    click_mode(panel, 5, T)
    assert selection.segments == {5}
    with qtbot.waitSignal(panel.announce) as said:
        panel.set_mode(T)
    assert "“Guarded” is locked" in said.args[0]
    assert "“Guarded” is locked" in panel.model.index(5).data(Qt.ItemDataRole.ToolTipRole)
    assert document.undo_stack.count() == 0


def test_every_segment_of_a_long_curve_is_selected_and_set_at_once(show):
    document = Document(Drawing([Item(some_curve([0.0] * 50_000))]))
    selection = Selection(document)
    panel = show(SegmentsPanel(document, selection), 340, 400)
    panel.list.selectAll()
    assert len(selection.segments) == 49_997
    click_mode(panel, 3, H)
    assert (document.drawing[0].curve.mode_codes == 1).all()


@pytest.fixture
def info(document, selection, show):
    return show(SegmentPanel(document, selection))


def test_the_segment_panel_tells_what_a_segment_is(info, document, selection):
    assert info.text.text() == "Select a segment on the curve or in the list."
    selection.select(segments=[5])
    assert info.heading.text() == "Segment 6"
    what, equation, shaped, _ = description(info)
    assert what == "General hyperbolic arc."
    assert equation == recognise(document.drawing[0].curve, 5).equation
    assert shaped == "λ₆ = λ₇ = 1 · control points P₅, P₆, P₇ and P₈"
    selection.select(segments=[2])
    assert description(info)[0] == "Interpolating, meets P₃ and P₄ at its ends."
    assert description(info)[2].startswith("λ₃ = λ₄ = λ* = 8.91206 · ")
    selection.select(segments=[1])
    assert "λ₂ = 0, λ₃ = λ* = 8.91206" in info.text.text()
    document.apply_curve("Change λ", 0, document.drawing[0].curve.with_lambdas(3, 0.0))
    assert description(info)[0].startswith("General trigonometric arc")
    assert description(info)[2].startswith("λ₂ = λ₃ = 0 · ")


def test_the_segment_panel_measures(info, document, selection):
    document.apply_curve("Insert", 0, known.catenary(start=-1.0, units=2))
    selection.select(segments=[0])
    # A catenary's length is sinh τ, its curvature 1/cosh² τ: ∫κ² ds = ∫ cosh⁻³ τ dτ.
    tau = np.linspace(0, 1, 2001)
    bending = np.trapezoid(np.cosh(tau) ** -3, tau)
    assert description(info) == [
        "Catenary, parameter 1, vertex (0, 1), from τ = −1 to 0.",
        "(x, y) = (−1 + t, cosh(1 − t)), t ∈ [0, 1]",
        "λ₁ = λ₂ = 1 · control points P₀, P₁, P₂ and P₃",
        f"Length {np.sinh(1):.6g} · bending {bending:.6g} · joins end / C²",
    ]
    document.apply_curve("Insert", 0, known.cycloid())
    assert "bending ∞" in info.text.text()


def test_what_is_nearly_a_known_curve_is_completed_in_one_step(info, document, selection, qtbot):
    curve = known.hyperbola(units=4)
    document.apply_curve("Insert", 0, curve)
    selection.select(segments=[2])
    assert not info.complete.isVisible()
    document.apply_curve("Change λ", 0, curve.with_lambdas(4, 0.97))
    assert info.suggestion.text() == "λ₄ = 0.97: set to 1 to make it a hyperbola arc."
    document.apply("Lock", document.drawing.with_item(0, document.drawing[0].with_(locked=True)))
    assert not info.complete.isEnabled()
    document.undo()
    steps = document.undo_stack.count()
    qtbot.mouseClick(info.complete, LEFT)
    assert document.drawing[0].curve == curve
    assert description(info)[0].startswith("Hyperbola arc, centre (0, 0)")
    assert document.undo_stack.undoText() == "Make segment 3 a hyperbola arc"
    assert not info.complete.isVisible()
    document.undo()
    assert document.undo_stack.count() == steps
    assert info.complete.isVisible()


def test_the_segment_panel_sums_up_several(info, selection):
    selection.select(segments=[0, 4, 5, 8])
    assert info.heading.text() == "4 segments"
    assert info.text.text().startswith("1 trigonometric, 2 hyperbolic and 1 blend.")


def test_the_segment_panel_goes_round_a_closed_quadratic(info, selection):
    selection.select(curve=1, segments=[0])
    assert "control points P₁₂, P₀ and P₁" in info.text.text()


def test_a_straight_segment_has_no_parameter(show):
    document = Document(Drawing([Item(some_curve([0, 0], ends="clamped"))]))
    selection = Selection(document)
    info = show(SegmentPanel(document, selection))
    selection.select(segments=[0])
    assert description(info)[0] == "Line segment from (1, 0) to (0.283662, −0.544021)."
    assert description(info)[2] == "No λ shapes it · control points P₀ and P₁"
