"""Mnemonics: the letter that is underlined in each entry of a menu, its own in every menu that the entry is in."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Mapping

_INITIAL = re.compile(r"(?<![A-Za-z])[A-Za-z]")
_LETTER = re.compile(r"[A-Za-z0-9]")


def lettered(
    entries: Iterable[tuple[str, frozenset[str]]], reserved: Mapping[str, str] | None = None
) -> list[str]:
    """Mark a letter in each text by ``&``.

    A letter that is marked already stays, unless an earlier entry of the same menu has it. Those without one
    get the first free initial, else the first free letter; where none is left the text stays bare.

    Parameters
    ----------
    entries
        Texts, with the menus that each of them is in.
    reserved
        Letters that are given away before, by menu.
    """
    taken: defaultdict[str, set[str]] = defaultdict(set)
    for menu, letters in (reserved or {}).items():
        taken[menu] |= set(letters.lower())
    texts, menus = zip(*entries, strict=True)
    result = [text.replace("&", "") for text in texts]

    def mark(i: int, places: Iterable[int]) -> bool:
        for place in places:
            letter = result[i][place].lower()
            if not any(letter in taken[menu] for menu in menus[i]):
                for menu in menus[i]:
                    taken[menu].add(letter)
                result[i] = f"{result[i][:place]}&{result[i][place:]}"
                return True
        return False

    bare = [i for i, text in enumerate(texts) if "&" not in text or not mark(i, [text.index("&")])]
    for i in bare:
        mark(i, (found.start() for kind in (_INITIAL, _LETTER) for found in kind.finditer(result[i])))
    return result
