#!/usr/bin/env python3
"""Draws faults: places by lines over all rooms, operators (operators.py) by chance, all from a seed.
  draw.py COUNT SEED [ROOM ...]   prints what it would draw
A fault that does not compile is on the list `refused` of the planted copy (plant.py), and another takes its
place."""
import functools
import random
import re
import sys

from faults import ROOT, Fault
from operators import all_places
from source_text import SourceText

# Rooms by the beginnings of their paths, the first that fits; `*.glsl` are shaders wherever they stand.
ROOMS = {
    'page': ('app/inspect/page/',),
    'app': ('app/',),
    'lab': ('lab/',),
    'scene': ('pipeline/scene/', 'pipeline/image_io/'),
    'plan': ('pipeline/plan/', 'pipeline/settings/', 'pipeline/views/', 'pipeline/gpu/'),
    'measure': ('pipeline/effects/', 'pipeline/measure/'),
    'renderer': ('pipeline/renderer/',),
    'passes': ('passes/',),
    'shaders': ('pipeline/shader/',),
    'raster': ('raster/', 'gl_backend/'),
}
# Declarations, among them shaders' constants that C++ has as enumerators; other lane widths than the planted
# build's, builds without a library, and texts that describe the machine or the options.
LEFT_OUT = re.compile(r'_test\.cpp$|_uniforms\.glsl$|without_|prelude|/lanes/sixteen|'
                      r'shader/constants\.glsl$|landing_status\.glsl$|'
                      r'passes/template/|'
                      r'app/completion/|app/doctor|std140|point_quads')
WIDEST = 400  # characters


class DrawnFault(Fault):
    """One that an operator made: its text may stand elsewhere, too, so that the place counts."""

    def __init__(self, room, kind, source, begin, end, fault):
        line = source.line_of(begin)
        column = begin - source.text.rfind('\n', 0, begin)
        text = ' '.join(source.text[begin:end].split())
        super().__init__(room, f'{source.path}:{line}:{column} {kind}', {
            'wrong': f'{kind}: `{text}` is `{" ".join(fault.split())}`', 'file': source.path,
            'text': source.text[begin:end], 'fault': fault})
        self.kind, self.begin, self.language = kind, begin, source.language

    def place(self, source):
        return self.begin

    def choice(self):
        # One line of text, so that a compiler's complaint about it is about no other.
        return ' '.join(super().choice().split())


def room_of(path):
    if path.endswith('.glsl'):
        return 'shaders'
    return next((room for room, begins in ROOMS.items() if path.startswith(begins)), None)


def files_by_room():
    rooms = {room: [] for room in ROOMS}
    for top in ('app', 'lab', 'pipeline', 'passes', 'raster', 'gl_backend'):
        for path in sorted((ROOT / top).rglob('*')):
            name = path.relative_to(ROOT).as_posix()
            wanted = path.suffix in ('.cpp', '.hpp', '.glsl') or name.startswith('app/inspect/page/')
            if wanted and path.suffix in ('.cpp', '.hpp', '.glsl', '.js') and not LEFT_OUT.search(name):
                rooms[room_of(name)].append(name)
    return rooms


@functools.lru_cache(maxsize=None)
def places_of(path):
    """The faults of each line that has any: {line: [(kind, begin, end, fault)]}."""
    source, lines = SourceText(path, (ROOT / path).read_text()), {}
    for place in all_places(source):
        if place[2] - place[1] <= WIDEST:
            lines.setdefault(source.line_of(place[1]), []).append(place)
    return source, lines


def shares(rooms, count):
    """How many of `count` each room gets, by its lines; the largest remainders round up."""
    lines = {room: sum((ROOT / path).read_text().count('\n') for path in paths)
             for room, paths in rooms.items()}
    exact = {room: count * n / sum(lines.values()) for room, n in lines.items()}
    whole = {room: int(share) for room, share in exact.items()}
    for room in sorted(exact, key=lambda r: whole[r] - exact[r])[:count - sum(whole.values())]:
        whole[room] += 1
    return whole


def drawn(count, seed, refused=(), taken=(), only=()):
    """`count` faults, of the rooms `only` where any are named; `taken` are those of the TOML lists, which no
    drawn one may overlap."""
    rooms, faults = files_by_room(), []
    if unknown := set(only) - set(rooms):
        sys.exit(f'draw.py: no room is named {", ".join(sorted(unknown))}')
    rooms = {room: rooms[room] for room in only or rooms}
    spans = {}
    for fault in taken:
        source = (ROOT / fault.file).read_text()
        begin = fault.place(source)
        spans.setdefault(fault.file, []).append((begin, begin + len(fault.text)))
    for room, share in shares(rooms, count).items():
        chance = random.Random(f'{seed} {room}')
        lines = [(path, line) for path in rooms[room] for line in sorted(places_of(path)[1])]
        chance.shuffle(lines)
        for path, line in lines:
            if share == 0:
                break
            source, of_line = places_of(path)
            places = of_line[line]
            kind = chance.choice(sorted({place[0] for place in places}))
            place = chance.choice([place for place in places if place[0] == kind])
            fault = DrawnFault(room, kind, source, *place[1:])
            # A line of its own each.
            first = source.text.rfind('\n', 0, place[1]) + 1
            last = source.text.find('\n', place[2])
            others = spans.setdefault(path, [])
            if fault.name in refused or any(b < last and first < e for b, e in others):
                continue
            others.append((first, last))
            faults.append(fault)
            share -= 1
    return faults


if __name__ == '__main__':
    for drawn_fault in drawn(int(sys.argv[1]), sys.argv[2], only=sys.argv[3:]):
        print(f'{drawn_fault.room:9} {drawn_fault.name}\n          {drawn_fault.wrong}')
