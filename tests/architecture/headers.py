#!/usr/bin/env python3
"""Every header compiles alone. Left out: those that a source of the build, or a header which compiles alone,
includes before anything else, which shows the same (tests do not count: they are compiled in batches); and
the bodies that pipeline/shader/stage.hpp and the tile kernels include inside a namespace of their lane width,
which have no guard on purpose. Of the rest the commit's hash draws a third (tests/support/drawn.py)."""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
from drawn import drawn  # noqa: E402: found by the line above

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROOMS = ('pipeline', 'passes', 'raster', 'gl_backend', 'lab', 'app', 'tests')
BODIES = {'pipeline/shader/vectors.hpp', 'pipeline/shader/scalar.hpp', 'pipeline/shader/wide.hpp',
          'pipeline/shader/stage.hpp', 'raster/lanes/tile_renderer.hpp'}


def complaint(header):
    code = f'#include "{header}"\n#include "{header}"\nint main() {{}}\n'
    result = subprocess.run([sys.argv[1], '-std=c++20', '-fsyntax-only', '-x', 'c++', '-I', str(ROOT), '-'],
                            input=code, text=True, capture_output=True)
    return f'{header}: {result.stderr.splitlines()[0]}' if result.returncode else None


def first_include(file):
    """The header of the project that a file includes before anything else, if it does."""
    found = re.search(r'^#include [<"].*', file.read_text(), re.MULTILINE) if file.exists() else None
    return found[0].split('"')[1] if found and '"' in found[0] else None


def included_first(files):
    """Headers that are the first include of one of these files, or of such a header, and so on."""
    first, files = set(), list(files)
    while files:
        header = first_include(files.pop())
        if header and header not in first:
            first.add(header)
            files.append(ROOT / header)
    return first


def has_epoxy():
    return complaint('epoxy/gl.h') is None


def main():
    compiled = included_first(s for room in ROOMS for s in (ROOT / room).rglob('*.cpp')
                              if not s.stem.endswith('_test'))
    headers = [str(h.relative_to(ROOT)) for room in ROOMS
               for h in sorted((ROOT / room).rglob('*.hpp'))]
    all_headers = len(headers)
    headers = [h for h in headers if h not in BODIES and h not in compiled]
    compiled = included_first(ROOT / h for h in headers)
    headers = [h for h in headers if h not in compiled]
    if not has_epoxy():  # the room is a stub then, with this one header
        headers = [h for h in headers if not h.startswith('gl_backend/') or h.endswith('/gl_device.hpp')]
    headers = drawn(headers, 3)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        wrong = [c for c in pool.map(complaint, headers) if c]
    print('\n'.join(wrong)
          or f'{len(headers)} of {all_headers} headers compile alone, sources begin with the others')
    return 1 if wrong or len(headers) < 3 or all_headers < 150 else 0


sys.exit(main())
