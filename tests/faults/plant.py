#!/usr/bin/env python3
"""A copy of the sources that holds faults, to be chosen at run time by a name in the variable CAUSTICS_FAULT.
Files that are the same already are left alone: a build goes on from there.
  plant.py FOLDER [--draw COUNT SEED [ROOM ...]]
                                        every fault of the lists, and COUNT drawn ones (draw.py)
  plant.py FOLDER --mend BUILD.log      plants as before, but others for the drawn faults that the compiler
                                        refused; exit 1 when it refused none of them"""
import argparse
import json
import pathlib
import re
import shutil
import sys

from draw import drawn
from faults import ROOT, all_faults, complaints

PARTS = ('CMakeLists.txt', 'cmake', 'pipeline', 'passes', 'raster', 'gl_backend', 'lab', 'app', 'tests',
         'scenes', 'examples', 'docs', 'README.md', 'LICENSE', 'packages.txt')
HERE = pathlib.Path(__file__).resolve().parent
INCLUDE = '#include "pipeline/gpu/fault.hpp"\n'
# How a kernel and OpenGL's text come to know which fault was chosen.
WIRING = {
    'pipeline/shader/stage.hpp': ('#pragma once\n', '#pragma once\n' + INCLUDE),
    'gl_backend/gl_text.cpp': ('"#version 450 core\\n" + head',
                               '"#version 450 core\\n" + fault_text() + head'),
    # The page's script, as the program writes it and as the tests of the page do.
    'app/inspect/page.cpp': ('{"@SCRIPT@", kPageScript}', '{"@SCRIPT@", fault_script() + kPageScript}'),
    'tests/inspect/page_file.py': ("""'(() => {\\n"use strict";\\n' +""",
                                   """__import__("fault_script").text() + '(() => {\\n"use strict";\\n' +"""),
    # Where Catch2 shows all that a listener needs.
    'tests/support/catch_main.cpp': ('namespace {\nint skipped = 0;',
                                     '#include "tests/support/reach_listener.hpp"\n'
                                     'namespace {\nint skipped = 0;'),
    # A module, which the program's own names do not reach: it chooses for itself.
    'pipeline/image_io/room.cmake': ('MODULE ${module_sources})',
                                     'MODULE ${module_sources} '
                                     '${PROJECT_SOURCE_DIR}/pipeline/gpu/fault.cpp)'),
}
# Files of the copy alone.
ADDED = {'pipeline/gpu/fault.hpp': 'fault.hpp', 'pipeline/gpu/fault.cpp': 'fault.cpp',
         'tests/support/reach_listener.hpp': 'reach.cpp', 'tests/inspect/fault_script.py': 'fault_script.py',
         'tests/program/fault_script.py': 'fault_script.py'}


def with_include(path, text):
    if path.endswith('.hpp'):
        return text.replace('#pragma once\n', '#pragma once\n' + INCLUDE, 1)
    return INCLUDE + text if path.endswith('.cpp') else text


def planted(faults):
    """The changed files' texts, by path."""
    texts = {}
    for path in {fault.file for fault in faults}:
        source = (ROOT / path).read_text()
        places = [(fault.place(source), fault) for fault in faults if fault.file == path]
        text, done = '', 0
        for begin, fault in sorted(places, key=lambda place: place[0]):
            text += source[done:begin] + fault.choice()
            done = begin + len(fault.text)
        texts[path] = with_include(path, text + source[done:])
    for path, (before, after) in WIRING.items():
        text = texts.get(path) or (ROOT / path).read_text()
        if text.count(before) != 1:
            sys.exit(f'plant.py: {path} does not hold {before!r} once; mend WIRING')
        if path.endswith('.cpp') and not text.startswith(INCLUDE):
            text = with_include(path, text)
        texts[path] = text.replace(before, after)
    for path, name in ADDED.items():
        texts[path] = (HERE / name).read_text()
    return texts


def sources():
    for part in PARTS:
        path = ROOT / part
        yield from [path] if path.is_file() else (p for p in sorted(path.rglob('*')) if p.is_file())


def write(path, data):
    if path.is_file() and path.read_bytes() == data:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)


def refused_by_the_compiler(folder, faults, log):
    """The names of the drawn faults on whose lines of the copy the log has an error; where there is none, of
    all that stand in the files that it names: a member's default value shows where the member is used."""
    errors = {}
    place = rf'^{re.escape(str(folder))}/(\S+?):(\d+):(?:\d+:)? (?:fatal )?(?:error|note|.*required)'
    for path, line in re.findall(place, log, re.M):
        errors.setdefault(path, set()).add(int(line))
    names = []
    for path, lines in errors.items():
        texts = (folder / path).read_text().split('\n')
        for fault in faults:
            here = [i for i, text in enumerate(texts, 1) if f'FAULT({fault.number()})' in text]
            if fault.file == path and lines.intersection(here):
                names.append(fault.name)
    return names or [fault.name for fault in faults if fault.file in errors]


def draw_for(folder, wanted, taken):
    """The drawn faults; the folder remembers how they were drawn, and which were refused."""
    memory = folder / 'drawn.json'
    known = json.loads(memory.read_text()) if memory.is_file() else {}
    if wanted.draw:
        fresh = {'count': int(wanted.draw[0]), 'seed': wanted.draw[1], 'rooms': wanted.draw[2:]}
        fresh['refused'] = known.get('refused', []) if known.get('seed') == fresh['seed'] else []
        known = fresh
    if not known:
        return []
    if wanted.mend:
        before = drawn_as(known, taken)
        names = refused_by_the_compiler(folder, before, wanted.mend.read_text(errors='replace'))
        if not names:
            sys.exit('plant.py: no drawn fault stands where the build failed')
        print('refused by the compiler:', *names, sep='\n  ')
        known['refused'] += names
    memory.parent.mkdir(parents=True, exist_ok=True)
    memory.write_text(json.dumps(known))
    return drawn_as(known, taken)


class Wired:
    """A place that WIRING changes, which no drawn fault may alter."""

    def __init__(self, path, text):
        self.file, self.text = path, text

    def place(self, source):
        return source.index(self.text)


def drawn_as(known, taken):
    wired = [Wired(path, before) for path, (before, _) in WIRING.items()]
    return drawn(known['count'], known['seed'], set(known['refused']), taken + wired, known['rooms'])


def drawn_in(folder):
    """The drawn faults of a planted copy, for those who judge them."""
    memory = folder / 'drawn.json'
    if not memory.is_file():
        return []
    return drawn_as(json.loads(memory.read_text()), all_faults())


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('folder', type=pathlib.Path)
    parser.add_argument('--draw', nargs='+', metavar=('COUNT', 'SEED'))
    parser.add_argument('--mend', type=pathlib.Path, metavar='BUILD.log')
    return parser.parse_args()


def main():
    wanted = arguments()
    folder = wanted.folder.resolve()
    faults = all_faults()
    wrong = complaints(faults)
    if wrong:
        sys.exit('\n'.join(wrong))
    more = draw_for(folder, wanted, faults)
    texts = planted(faults + more)
    kept = {folder / path for path in texts} | {folder / 'drawn.json'}
    for path, text in texts.items():
        write(folder / path, text.encode())
    for source in sources():
        path = folder / source.relative_to(ROOT)
        if '__pycache__' in path.parts or path in kept:
            continue
        kept.add(path)
        write(path, source.read_bytes())
        shutil.copymode(source, path)
    for path in folder.rglob('*'):
        if path.is_file() and path not in kept and '__pycache__' not in path.parts:
            path.unlink()
    print(f'{len(faults)} faults and {len(more)} drawn ones planted in {folder}')


if __name__ == '__main__':
    main()
