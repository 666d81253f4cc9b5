"""Damaged and hostile files: each is read as what it says or refused in one sentence, within bounds of work and memory.

THEDITOR_LONG_RUN=1 pytest tests/drawing/test_fuzz.py tries many more.
"""

import json
import os
import random
import sys
import tracemalloc
from pathlib import Path

import pytest

from theditor.drawing import Drawing, DrawingError, decode, encode
from theditor.resources import gallery

FILES = [p.path.read_bytes() for p in gallery()]
FILES.append((Path(__file__).parents[1] / "data" / "version-1.json").read_bytes())
ROUNDS = 50_000 if os.environ.get("THEDITOR_LONG_RUN") else 2000

# Values that are wrong nearly everywhere, among them what Python's own JSON would let pass.
ODD = [
    None,
    True,
    -1,
    0,
    4,
    1e13,
    10**30,
    1e-320,
    float("nan"),
    float("inf"),
    "",
    "1",
    "a\nb",
    "\ud800",
    "\x00",
]
ODD += [[], [[]], [[0, 0]], {}, {"points": []}, "free", "theditor", "#12345", "x" * 300]
TOKENS = [
    b"[",
    b"]",
    b"{",
    b"}",
    b",",
    b":",
    b'"',
    b"\\",
    b"\\ud83d",
    b"\n",
    b"1e400",
    b"-",
    b"0",
    b"NaN",
    b"null",
]
TOKENS += [b"\xef\xbb\xbf", b"\xff", b"\x00", b"\xc3", "λ".encode(), b'"points":', b'"version":', b" " * 50]


def damaged(rng, data):
    """Change a few bytes: put in, take out, repeat, cut off."""
    for _ in range(rng.randint(1, 3)):
        start = rng.randrange(len(data) + 1)
        stop = min(len(data), start + rng.choice([0, 0, 1, 2, 10, 100]))
        new = rng.choice([*TOKENS, bytes([rng.randrange(256)]), data[start:stop] * 2])
        data = data[:start] + new + (b"" if rng.random() < 0.05 else data[stop:])
    return data


def distorted(rng, data):
    """Change the structure: replace, remove, rename, repeat or nest a value somewhere."""
    root = json.loads(data)
    for _ in range(rng.randint(1, 3)):
        node, place = [root], 0
        while isinstance(node[place], dict | list) and node[place] and rng.random() < 0.8:
            node = node[place]
            place = rng.choice(list(node) if isinstance(node, dict) else range(len(node)))
        match rng.randrange(5):
            case 0:
                node[place] = rng.choice(ODD)
            case 1:
                node[place] = [node[place]]
            case 2 if isinstance(node, dict):
                node[rng.choice(["name", "ends", "colour", "", "Points"])] = node.pop(place)
            case 3 if isinstance(node, list):
                node.insert(place, rng.choice([node[place], rng.choice(ODD)]))
            case _ if node[place] is not root:
                del node[place]
    return json.dumps(root).encode()


def measured(data):
    """Decode under watch; return the sentence of the refusal, if any, and the numbers of calls and of bytes used."""
    calls = 0

    def count(*_):
        nonlocal calls
        calls += 1

    tracemalloc.start()
    sys.setprofile(count)
    try:
        outcome = decode(data)
    except DrawingError as error:
        outcome = str(error)
    finally:
        sys.setprofile(None)
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
    return outcome, calls, peak


def check(data):
    outcome, calls, used = measured(data)
    assert calls <= 10_000 + 4 * len(data)
    assert used <= 100_000 + 60 * len(data)
    if isinstance(outcome, Drawing):
        assert decode(encode(outcome)) == outcome
    else:
        assert outcome.isprintable()
        assert len(outcome) < 300
    return outcome


@pytest.mark.parametrize("mutate", [damaged, distorted])
def test_a_mutated_file_is_read_or_refused_in_one_sentence(mutate):
    rng = random.Random(0)
    outcomes = [check(mutate(rng, rng.choice(FILES))) for _ in range(ROUNDS)]
    accepted = sum(isinstance(each, Drawing) for each in outcomes)
    assert ROUNDS / 100 < accepted < ROUNDS * 0.9  # both ways are tried
    assert len({each.split("(")[0] for each in outcomes if isinstance(each, str)}) > 20


HOSTILE = {
    "nested lists": b"[" * 10**5,
    "nested objects": b'{"curves":' * 10**5,
    "nested where points belong": b'{"format":"theditor","version":1,"curves":[{"points":' + b"[" * 10**5,
    "one long text": b'"' + b"[" * 10**6 + b'"',
    "one long name": b'{"format":"theditor","version":1,"curves":[{"name":"' + b"[" * 10**6 + b'"}]}',
    "one long key": b'{"format":"theditor","version":1,"' + b"x" * 10**6 + b'":1}',
    "one long number": b'{"format":"theditor","version":' + b"9" * 10**6 + b"}",
    "many keys": b'{"format":"theditor","version":1,' + b'"":0,' * 10**5 + b'"curves":[]}',
    "many times the same key": b'{"format":"theditor",' + b'"version":1,' * 10**4 + b'"curves":[]}',
    "many faulty curves": b'{"format":"theditor","version":1,"curves":[' + b"{}," * 10**5 + b"{}]}",
    "blanks": b'{"format":"theditor","version":1,"curves":[' + b" \n" * 10**6 + b"]",
    "zeros": b"\x00" * 10**6,
    "half a letter": b"\xe2\x82" * 10**6,
    "a newer version": b'{"format":"theditor","version":999999999,"curves":' + b"[" * 900 + b"]" * 900 + b"}",
}


@pytest.mark.parametrize("data", HOSTILE.values(), ids=HOSTILE)
def test_a_hostile_file_costs_little(data):
    assert isinstance(check(data), str)
