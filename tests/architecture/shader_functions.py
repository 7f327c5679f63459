#!/usr/bin/env python3
"""A shader function has at most 40 lines and 5 parameters, and no condition asks an unnamed component.

The rule for conditions, in one sentence: a component of a uniform (`u.name.x`) is compared with nothing, and
a component of a vector parameter of a uniform type, of a fetched texel, or named `w` is compared with no
literal, except where the comparison gives it its name: as the whole of a function (`Bool is_covered(Vec4
texel) { return texel.w != 0.0f; }`) or of a struct's member (`material.solid = texel.w > 0.5f;`).
Coordinates that are computed (`t.z > 0.0f`) may be compared.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
ROOT = ROOT if len(sys.argv) > 1 else ROOT.parents[2]
MOST_LINES, MOST_PARAMETERS = 40, 5

COMPARED = r'(?:<=|>=|==|!=|<|>)'
LITERAL = r'(?<![\w.])(?:-?\d[\d.]*(?:e[-+]?\d+)?f?\b|(?:Float|float|Int)\(-?\d[^()]*\))'
FETCH = r'\w*fetch\w*\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)'
FUNCTION = re.compile(r'^(?:const )?\w+ (\w+)\(((?:[^()]|\([^()]*\))*)\)\s*\{', re.M)
NAMING = (re.compile(r'^\s*Bool \w+\((?:[^()]|\([^()]*\))*\) \{ return [^;&|]*; \}\s*$'),
          re.compile(r'^\s*\w+\.\w+ = [^;&|]*;\s*$'))


def without_comments(text):
    return re.sub(r'//[^\n]*', '', text)


def functions(text):
    """Name, parameters, lines and first line of each function in a text without comments."""
    for match in FUNCTION.finditer(text):
        depth, end = 1, match.end()
        while depth and end < len(text):
            depth += {'{': 1, '}': -1}.get(text[end], 0)
            end += 1
        parameters = re.sub(r'\([^()]*\)', '', match.group(2)).strip()
        count = parameters.count(',') + 1 if parameters and parameters != 'void' else 0
        yield (match.group(1), count, text.count('\n', match.start(), end) + 1,
               text.count('\n', 0, match.start()) + 1)


def unnamed_conditions(text):
    """Line and words of each comparison that the rule refuses, in a text without comments."""
    texels = re.findall(r'Vec[234] (\w+) = ' + FETCH + r';', text)
    uniforms = re.findall(r'\b(?:i?vec[234]|IN\(i?vec[234]\)) (\w+)(?=[,);])', text)
    names = '|'.join(sorted(set(texels + uniforms))) or r'\b\B'
    uniform = r'\bu\.\w+\.[xyzw]\b'
    component = rf'(?:\b(?:{names})\.[xyzw]\b|{FETCH}\.[xyzw]\b|\b\w+(?:\.\w+)*\.w\b)'
    refused = re.compile(rf'{uniform}\s*{COMPARED}|{COMPARED}\s*-?{uniform}|'
                         rf'{component}\s*{COMPARED}\s*{LITERAL}|{LITERAL}\s*{COMPARED}\s*{component}')
    for number, line in enumerate(text.splitlines(), 1):
        if any(naming.match(line) for naming in NAMING) and not re.search(uniform, line):
            continue
        for match in refused.finditer(line):
            yield number, ' '.join(match.group(0).split())


def main():
    wrong, seen, longest, conditions = [], 0, 0, 0
    texts = sorted(path for room in ('passes', 'pipeline/shader') for path in (ROOT / room).rglob('*.glsl'))
    for path in texts:
        name, text = path.relative_to(ROOT), without_comments(path.read_text())
        for function, parameters, lines, number in functions(text):
            seen, longest = seen + 1, max(longest, lines)
            if lines > MOST_LINES:
                wrong.append(f'{name}:{number}: {function} has {lines} lines, more than {MOST_LINES}: '
                             'split it')
            if parameters > MOST_PARAMETERS:
                wrong.append(f'{name}:{number}: {function} has {parameters} parameters, more than '
                             f'{MOST_PARAMETERS}: join those that belong together in a struct')
        for number, words in unnamed_conditions(text):
            conditions += 1
            wrong.append(f'{name}:{number}: `{words}` asks an unnamed component: give it a name')
    print('\n'.join(wrong))
    print(f'{len(texts)} texts, {seen} functions, the longest of {longest} lines; '
          f'conditions on unnamed components: {conditions}')
    return 1 if wrong or len(texts) < 50 or seen < 200 else 0


sys.exit(main())
