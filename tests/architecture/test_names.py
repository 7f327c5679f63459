#!/usr/bin/env python3
"""Every Catch2 test has a name of its own that CTest can pass on: a semicolon would split it, and the
halves would select no test and pass."""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROOMS = ('pipeline', 'passes', 'raster', 'gl_backend', 'lab', 'app', 'tests')


def main():
    names = collections.Counter()
    for room in ROOMS:
        for path in (ROOT / room).rglob('*_test.cpp'):
            names.update(re.findall(r'TEST_CASE\(\s*"((?:[^"\\]|\\.)*)"', path.read_text()))
    wrong = [f'semicolon in the test name: {n}' for n in names if ';' in n]
    wrong += [f'{count} tests have the name: {n}' for n, count in names.items() if count > 1]
    print('\n'.join(wrong) or f'{len(names)} tests have sound names of their own')
    return 1 if wrong or len(names) < 100 else 0


sys.exit(main())
