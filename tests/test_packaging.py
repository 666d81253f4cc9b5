"""What the README asks a bare machine to install agrees with what the program says is missing there."""

import re
from pathlib import Path

from theditor.cli.window import DEBIAN_PACKAGES

README = Path(__file__).parents[1] / "README.md"


def test_the_commands_install_the_system_libraries_that_the_program_names():
    window, tests = (
        set(names.split())
        for names in re.findall(r"--no-install-recommends (.*?) &&", README.read_text("utf-8"))
    )
    assert window == {"python3-venv", *DEBIAN_PACKAGES.split()}
    assert {"python3-venv", "libgl1", "libegl1"} < tests < window
