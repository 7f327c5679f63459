#!/usr/bin/env python3
"""glslangValidator accepts every shader text as GLSL 4.50, both stages, behind the prelude."""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def expanded(path):
    return re.sub(r'#include "([^"]+)"', lambda m: expanded(m.group(1)), (ROOT / path).read_text())


def complaints(text_path, defines):
    body = ''.join(expanded(f'pipeline/shader/{name}.glsl') for name in ('constants', 'view', 'functions')) + expanded(text_path)
    prelude = expanded('pipeline/shader/prelude.glsl')
    if not (prelude + body).isascii():
        yield f'{text_path}: GLSL is ASCII, and a character here is not'
    for stage, macro in (('vert', 'VERTEX_STAGE'), ('frag', 'FRAGMENT_STAGE')):
        head = f'#version 450 core\n#define {macro} 1\n'
        head += ''.join(f'#define {d.replace("=", " ")}\n' for d in defines)
        with tempfile.NamedTemporaryFile('w', suffix='.' + stage) as file:
            file.write(head + prelude + body)
            file.flush()
            result = subprocess.run(['glslangValidator', file.name], text=True, capture_output=True)
        if result.returncode:
            yield f'{text_path} ({stage}): ' + ' | '.join(
                line for line in result.stdout.splitlines() if line.startswith('ERROR'))


def main():
    wrong, texts = [], 0
    for line in (ROOT / 'passes/room.cmake').read_text().splitlines():
        match = re.match(r'\s*caustics_add_shader\(\S+ \S+ TEXT (\S+?)(?: DEFINES (.*))?\)', line)
        if match:
            texts += 1
            wrong += complaints(match.group(1), (match.group(2) or '').split())
    print('\n'.join(wrong) or f'{texts} shader texts are GLSL 4.50')
    return 1 if wrong or texts < 10 else 0


sys.exit(main())
