"""The colours that every view draws with, one set for light and one for dark.

A view asks `colours_for(self.palette())` when it paints: the palette is the only thing that says whether the
window is light or dark, so a change of theme reaches every view through Qt's own palette change.
"""

from __future__ import annotations

from typing import NamedTuple

from PySide6.QtGui import QPalette

from theditor.spline import Mode


class Colours(NamedTuple):
    """Colours as ``#rrggbb``, named by what they mean.

    Mode colours are for strokes and swatches (contrast at least 3 : 1), never for text.
    """

    window: str
    panel: str
    canvas: str
    border: str
    text: str
    secondary: str
    grid_minor: str
    grid_major: str
    accent: str
    selection: str
    accent_text: str
    trigonometric: str
    hyperbolic: str
    interpolating: str
    blend: str
    polygon: str
    hull: str
    comb: str
    comb_negative: str
    warning: str

    def of_mode(self, mode: Mode) -> str:
        """Colour of segments in `mode`."""
        return str(getattr(self, mode.value))


LIGHT = Colours(
    window="#F3F5F8",
    panel="#FAFBFC",
    canvas="#FFFFFF",
    border="#D8DEE6",
    text="#1B2430",
    secondary="#5B6573",
    grid_minor="#F0F3F6",
    grid_major="#E2E7ED",
    accent="#2F6BDE",
    selection="#E5EEFF",
    accent_text="#1F57C3",
    trigonometric="#0072B2",
    hyperbolic="#C8520A",
    interpolating="#008A63",
    blend="#6B7480",
    polygon="#A9B3C0",
    hull="#DDF3E4",
    comb="#7A5AC8",
    comb_negative="#B0437F",
    warning="#9A6700",
)

DARK = Colours(
    window="#1B1F25",
    panel="#20252C",
    canvas="#14171C",
    border="#333B46",
    text="#E7EBF1",
    secondary="#9BA6B5",
    grid_minor="#1B1F26",
    grid_major="#262C35",
    accent="#6EA0FF",
    selection="#263756",
    accent_text="#8FB5FF",
    trigonometric="#56B4E9",
    hyperbolic="#F0883E",
    interpolating="#2FC79A",
    blend="#A0AAB8",
    polygon="#566170",
    hull="#1E3A2C",
    comb="#A98BEB",
    comb_negative="#E38AB8",
    warning="#E3B341",
)


def colours_for(palette: QPalette) -> Colours:
    """Colours that suit a palette: `DARK` when its window is dark, else `LIGHT`."""
    return DARK if palette.window().color().lightness() < 128 else LIGHT
