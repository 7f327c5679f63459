#!/usr/bin/env python3
"""Shader functions fit on a screen (40 lines, 5 parameters), and no condition asks an unnamed component of a texel or a
uniform: what a component means is said once, in a function is_..., has_... or fetch_..."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOST_LINES = 40
MOST_PARAMETERS = 5
HEAD = re.compile(r'^(?:\w+) (\w+)\(', re.M)
COMPARED = r'\s*(?:[<>]=?|[=!]=)\s*'
UNNAMED = re.compile(rf'\w\.w\b{COMPARED}|{COMPARED}[\w.]*\w\.w\b|\bu(?:\.\w+)*\.[xyz]\b{COMPARED}-?\d')


def matching(text, start, opening, closing):
    depth = 0
    for i in range(start, len(text)):
        depth += (text[i] == opening) - (text[i] == closing)
        if depth == 0:
            return i
    return len(text)


def parameters(text):
    depth, count = 0, 1 if text.strip() else 0
    for c in text:
        depth += (c == '(') - (c == ')')
        count += c == ',' and depth == 0
    return count


def functions(text):
    """Name, first line, lines, parameters and body of each function in a text."""
    for head in HEAD.finditer(text):
        close = matching(text, head.end() - 1, '(', ')')
        if not re.match(r'\s*\{', text[close + 1:]):
            continue
        end = matching(text, text.index('{', close), '{', '}')
        yield (head.group(1), text.count('\n', 0, head.start()) + 1, text.count('\n', head.start(), end) + 1,
               parameters(text[head.end():close]), text[head.start():end + 1])


def complaints(path):
    text = (ROOT / path).read_text()
    for name, line, lines, count, body in functions(text):
        where = f'{path}:{line}: {name}'
        if lines > MOST_LINES:
            yield f'{where} has {lines} lines, more than {MOST_LINES}: split it'
        if count > MOST_PARAMETERS:
            yield f'{where} has {count} parameters, more than {MOST_PARAMETERS}: make a struct of what belongs together'
        if not re.match('(is|has|fetch)_', name):
            for condition in UNNAMED.finditer(re.sub('//[^\n]*', '', body)):
                yield f'{where} asks an unnamed component ({condition.group(0).strip()}): give it a name'


def main():
    folders = [pathlib.Path(folder) for folder in sys.argv[1:]] or [ROOT / 'passes']
    texts = sorted(text for folder in folders for text in
                   (folder.resolve().rglob('*.glsl') if folder.is_dir() else [folder.resolve()]))
    wrong = [c for text in texts for c in complaints(text.relative_to(ROOT))]
    every = [(f[2], f[3], f[0]) for text in texts for f in functions(text.read_text())]
    print('\n'.join(wrong) or f'{len(every)} shader functions: at most {max(f[0] for f in every)} lines and '
                              f'{max(f[1] for f in every)} parameters')
    return 1 if wrong or not every else 0


sys.exit(main())
