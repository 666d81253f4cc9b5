"""What the README shows works."""

import re
from pathlib import Path

import pytest

from theditor.drawing import load

README = Path(__file__).resolve().parent.parent / "README.md"


def block(language):
    return re.search(rf"```{language}\n(.*?)```", README.read_text("utf-8"), re.S)[1]


def test_the_file_it_shows_loads(tmp_path):
    (tmp_path / "shown.json").write_text(block("json"), "utf-8")
    drawing = load(tmp_path / "shown.json")
    assert drawing[0].name == "Figure 10"
    assert drawing[0].curve.segment_count == 1


def test_the_library_example_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    lines = block("python").splitlines()
    names = {}
    exec("\n".join(lines[:-1]), names)
    assert eval(lines[-1].split("#")[0], names) is True


@pytest.mark.parametrize("picture", re.findall(r"!\[.*?\]\((.*?)\)", README.read_text("utf-8")))
def test_its_pictures_exist(picture):
    assert (README.parent / picture).is_file()
