"""``theditor schema``: print the JSON Schema of the file format."""

from __future__ import annotations

import argparse
import json

from theditor.cli import streams
from theditor.drawing import json_schema


def declare(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments: none."""
    parser.description = "Print the JSON Schema (draft 2020-12) of the file format, as UTF-8."


def run(_options: argparse.Namespace) -> int:
    """Print the schema."""
    text = json.dumps(json_schema(), indent=2, ensure_ascii=False)
    streams.write(streams.STANDARD, f"{text}\n".encode())
    return 0
