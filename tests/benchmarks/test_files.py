"""How fast files are read, written and checked, beside what Python does with the same.

    pytest tests/benchmarks/test_files.py -n 0

prints, for a file of 10⁵ points, the time to load it as a multiple of `json.loads` of the same bytes (the aim: at
most 2.5) and to save it as a multiple of `json.dumps` of the same data (at most 1.5); and for `theditor check` of
Figure 10, and of that file, the multiple of `python -c "import numpy"` (for Figure 10 at most 2).

Times on a busy machine mean little, so nothing here fails on them. Processor time is compared: how long the disk
takes is not ours.
"""

import json
import os
import resource
import subprocess
import sys
import time

import pytest
from large import spiral
from paired import fastest

from theditor.drawing import encode, load, save
from theditor.resources import resource as shipped


@pytest.fixture(scope="module")
def drawing():
    return spiral()


@pytest.fixture
def path(drawing, tmp_path):
    save(drawing, tmp_path / "spiral.json")
    return tmp_path / "spiral.json"


def test_loading(drawing, path, report):
    data = path.read_bytes()
    assert load(path) == drawing
    loads, ours = fastest(lambda: json.loads(data), lambda: load(path), clock=time.process_time)
    report(f"{len(data) / 1e6:.1f} MB, 10⁵ points: loading = {ours / loads:.2f} × json.loads")


def test_saving(drawing, path, report):
    plain = json.loads(encode(drawing))
    dumps, ours, checked = fastest(
        lambda: json.dumps(plain),
        lambda: save(drawing, path, overwrite=True),
        lambda: save(drawing, path),
        clock=time.process_time,
    )
    report(
        f"10⁵ points: saving = {ours / dumps:.2f} × json.dumps; "
        f"where it is first looked whether a drawing is replaced, {checked / dumps:.2f}"
    )


def test_checking(path, report):
    def run(*command):
        environment = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
        subprocess.run(
            [sys.executable, *map(str, command)], check=True, stdout=subprocess.DEVNULL, env=environment
        )

    def spent():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    numpy, figure, large = fastest(
        lambda: run("-c", "import numpy"),
        lambda: run("-m", "theditor", "check", shipped("gallery") / "figure-10.json"),
        lambda: run("-m", "theditor", "check", path),
        rounds=7,
        clock=spent,
    )
    report(
        f"theditor check = {figure / numpy:.2f} × import numpy for Figure 10, {large / numpy:.1f} × for 10⁵ points"
    )
