#!/usr/bin/env python3
"""plant.py FOLDER: a copy of the sources that holds every fault, to be chosen at run time by its name in the
variable CAUSTICS_FAULT. Files that are the same already are left alone: a build goes on from there."""
import pathlib
import shutil
import sys

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
}


def with_include(path, text):
    if path.endswith('.hpp'):
        return text.replace('#pragma once\n', '#pragma once\n' + INCLUDE, 1)
    return INCLUDE + text if path.endswith('.cpp') else text


def planted(faults):
    """The changed files' texts, by path."""
    texts = {}
    for path in {fault.file for fault in faults}:
        source = (ROOT / path).read_text()
        places = [(source.index(fault.text), fault) for fault in faults if fault.file == path]
        text, done = '', 0
        for begin, fault in sorted(places, key=lambda place: place[0]):
            text += source[done:begin] + fault.choice()
            done = begin + len(fault.text)
        texts[path] = with_include(path, text + source[done:])
    for path, (before, after) in WIRING.items():
        text = texts.get(path) or (ROOT / path).read_text()
        if text.count(before) != 1:
            sys.exit(f'plant.py: {path} does not hold {before!r} once; mend WIRING')
        if path.endswith('.cpp') and INCLUDE not in text:
            text = with_include(path, text)
        texts[path] = text.replace(before, after)
    for name in ('fault.hpp', 'fault.cpp'):
        texts['pipeline/gpu/' + name] = (HERE / name).read_text()
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


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    faults = all_faults()
    wrong = complaints(faults)
    if wrong:
        sys.exit('\n'.join(wrong))
    texts = planted(faults)
    wanted = {folder / path for path in texts}
    for path, text in texts.items():
        write(folder / path, text.encode())
    for source in sources():
        path = folder / source.relative_to(ROOT)
        if '__pycache__' in path.parts or path in wanted:
            continue
        wanted.add(path)
        write(path, source.read_bytes())
        shutil.copymode(source, path)
    for path in folder.rglob('*'):
        if path.is_file() and path not in wanted and '__pycache__' not in path.parts:
            path.unlink()
    print(f'{len(faults)} faults planted in {folder}')


if __name__ == '__main__':
    main()
