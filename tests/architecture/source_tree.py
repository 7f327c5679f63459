"""The source tree as the architecture tests see it."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROOMS = ["pipeline", "passes", "raster", "gl_backend", "reference", "app"]
INCLUDE = re.compile(r'^\s*#\s*include\s+(["<])([^">]+)[">]', re.MULTILINE)


def files(*endings):
    """Files of the rooms with one of these endings, tests left out, sorted."""
    found = [path for room in ROOMS for path in (ROOT / room).rglob("*") if path.suffix in endings]
    return sorted(path for path in found if not path.stem.endswith("_test"))


def name(path):
    return path.relative_to(ROOT).as_posix()


def includes(path):
    """(quote, name) of every include in a file; the quote is '"' or '<'."""
    return INCLUDE.findall(path.read_text(encoding="utf-8"))
