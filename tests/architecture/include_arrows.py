#!/usr/bin/env python3
"""Keeps the arrows between the rooms: who may include whom (README, "Where things are")."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
MAY = {
    'pipeline/gpu': set(),
    'pipeline/shader': {'pipeline/gpu'},
    'pipeline/image_io': {'pipeline/gpu'},
    'pipeline/scene': {'pipeline/image_io', 'pipeline/shader', 'pipeline/gpu'},
    'pipeline/settings': {'pipeline/scene', 'pipeline/shader', 'pipeline/gpu'},
    'pipeline/effects': {'pipeline/settings', 'pipeline/scene', 'pipeline/gpu'},
    'pipeline/views': {'pipeline/effects', 'pipeline/settings', 'pipeline/scene', 'pipeline/gpu'},
    'pipeline/plan': {'pipeline/views', 'pipeline/effects', 'pipeline/settings', 'pipeline/scene',
                      'pipeline/gpu'},
    'pipeline/measure': {'pipeline/plan', 'pipeline/views', 'pipeline/effects', 'pipeline/settings',
                         'pipeline/scene', 'pipeline/shader', 'pipeline/gpu'},
    'pipeline/renderer': {'pipeline'},
    'passes': {'pipeline'},
    'raster': {'pipeline'},
    'gl_backend': {'pipeline'},
    'lab/reference': {'pipeline'},
    'lab/metrics': {'pipeline'},
    'lab/study': {'lab/metrics', 'pipeline'},
    'lab/paper': {'lab/reference', 'pipeline'},
    'app': {'passes', 'raster', 'gl_backend', 'lab', 'pipeline'},
    'tests/fuzz': {'passes', 'raster', 'pipeline', 'tests/support'},
    'tests/support': {'passes', 'raster', 'gl_backend', 'lab', 'pipeline', 'tests/raster'},
    'tests/raster': {'passes', 'raster', 'pipeline', 'tests/support'},
}

# Libraries that only some rooms may name: the others build and run without them.
OWNED = {
    'epoxy/': {'gl_backend'}, 'EGL/': {'gl_backend'}, 'GL/': {'gl_backend'},
    'tbb/': {'raster', 'pipeline/scene'}, 'oneapi/': {'raster', 'pipeline/scene'},
    'embree': {'lab/reference'}, 'CLI/': {'app'},
    'nlohmann/': {'pipeline/scene', 'lab/study', 'lab/paper', 'app'},
    'OpenImageIO/': {'pipeline/image_io'},
    'draco/': {'pipeline/scene'}, 'meshoptimizer': {'pipeline/scene'},
}


def room_of(path):
    return next((room for room in sorted(MAY, key=len, reverse=True) if path.startswith(room + '/')), None)


def main():
    wrong, seen = [], 0
    for room in MAY:
        for file in sorted((ROOT / room).rglob('*')):
            if file.suffix not in ('.hpp', '.cpp', '.glsl', '.in') or file.name.endswith('_test.cpp'):
                continue
            for number, line in enumerate(file.read_text().splitlines(), 1):
                library = re.match(r'\s*#include <([^>]+)>', line)
                for prefix, owners in OWNED.items():
                    if library and library.group(1).startswith(prefix) and room not in owners:
                        wrong.append(f'{file.relative_to(ROOT)}:{number}: {room} may not name {prefix}')
                match = re.match(r'\s*#include "([^"@]+)"', line)
                if not match:
                    continue
                seen += 1
                target = room_of(match.group(1))
                allowed = target and (target == room or target in MAY[room]
                                      or any(target.startswith(m + '/') for m in MAY[room]))
                if not allowed:
                    wrong.append(f'{file.relative_to(ROOT)}:{number}: {room} may not include '
                                 + match.group(1))
    print('\n'.join(wrong) or f'{seen} includes keep the arrows')
    return 1 if wrong or seen < 100 else 0


sys.exit(main())
