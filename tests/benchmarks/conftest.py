"""Results are printed while the benchmarks run."""

import pytest


@pytest.fixture
def report(capsys):
    """Print a line past pytest's capture."""

    def tell(line):
        with capsys.disabled():
            print(f"\n{line}", end="")

    return tell
