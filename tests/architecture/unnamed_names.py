#!/usr/bin/env python3
"""Keeps the names in unnamed namespaces of one room apart. Sources are compiled in batches
(cmake/unity.cmake), of sizes that differ between builds and clang-tidy, and two of one batch share their
unnamed namespace: a name of two different things may compile today and fail when a file joins the room."""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROOMS = ('pipeline', 'passes', 'raster', 'gl_backend', 'lab', 'app')

TYPE = re.compile(r'(?:struct|class|enum class|enum|using) (\w+)')
FUNCTION = re.compile(
    r'[\w:<>,&*\[\] ]*[ &*>](\w+)\(([^;{]*)\)(?: const)?(?: noexcept)?(?: ->[^{;]*)? [{;]?', re.S)
# A line at the margin, with those that go on with it.
OUTERMOST = re.compile(r'^(?!namespace|using \w+::)(?=[A-Za-z])(?:template <[^\n]*>\n)?'
                       r'([^#\n][^\n]*(?:\n {4,}[^\n]*)*)', re.M)
NAMESPACE = re.compile(
    r'^namespace ([\w:]+) \{$|^namespace \{\n(.*?)^\}  // namespace$|^\}  // namespace [\w:]+$', re.M | re.S)
CONSTANT = re.compile(r'[\w:<>,&*() ]*[ &*>](\w+)(?:\[\w*\])* ?[={;]')


def parameter_types(parameters):
    """The parameters without their names and default values: two functions with the same are one."""
    types = []
    for parameter in re.split(r',(?![^<(]*[>)])', parameters):
        bare = re.sub(r'=.*', '', parameter, flags=re.S).strip()
        types.append(' '.join(re.sub(r'([ &*>])\w+$', r'\1', bare).split()))
    return ', '.join(types)


def unnamed_parts(text):
    """Every enclosing namespace's name with the text of its unnamed namespaces; a comment closes each."""
    enclosing = []
    for match in NAMESPACE.finditer(text):
        if match.group(1):
            enclosing.append(match.group(1))
        elif match.group(2) is None:
            enclosing.pop()
        else:
            yield '::'.join(enclosing), match.group(2)


def names_in(part):
    """The names that stand at the outermost level of a part: functions with their parameters' types."""
    part = re.sub(r'//[^\n]*', '', part)
    for match in OUTERMOST.finditer(part):
        head = match.group(1)
        kind = TYPE.match(head)
        function = FUNCTION.match(head)
        constant = CONSTANT.match(head)
        if kind:
            yield kind.group(1)
        elif function and (not constant or constant.end() > function.end(1)):
            yield f'{function.group(1)}({parameter_types(function.group(2))})'
        elif constant:
            yield constant.group(1)


def main():
    places = collections.defaultdict(set)
    for room in ROOMS:
        for file in sorted((ROOT / room).rglob('*.cpp')):
            if not file.name.endswith('_test.cpp'):
                for enclosing, part in unnamed_parts(file.read_text()):
                    for name in names_in(part):
                        places[room, enclosing, name].add(str(file.relative_to(ROOT)))
    for (_, enclosing, name), files in sorted(places.items()):
        if len(files) > 1:
            print(f'{enclosing}: {name} is in the unnamed namespace of {" and of ".join(sorted(files))}: '
                  'rename one of them')
    print(f'{len(places)} names in unnamed namespaces')
    if not places or any(len(files) > 1 for files in places.values()):
        sys.exit(1)


if __name__ == '__main__':
    main()
