#!/usr/bin/env python3
"""One registered pass is one folder, one shader text, one page, one test: passes/registry.cpp names no pass
without them, and passes/ has no folder without a pass."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PASSES = ROOT / 'passes'
NO_PASS = {'shared', 'template'}


def main():
    registry = (PASSES / 'registry.cpp').read_text()
    names = re.findall(r'^ +(\w+)_pass\(\),$', registry, re.M)
    wrong = [f'{name} is registered twice' for name in set(names) if names.count(name) > 1]
    for name in names:
        for ending in ('.cpp', '.hpp', '.glsl', '.md', '_test.cpp'):
            if not (PASSES / name / (name + ending)).is_file():
                wrong.append(f'passes/{name} has no {name}{ending}')
    folders = {path.name for path in PASSES.iterdir() if path.is_dir() and any(path.iterdir())} - NO_PASS
    wrong += [f'passes/{name} is no registered pass' for name in sorted(folders - set(names))]
    texts = set(re.findall(r'TEXT passes/(\w+)/(\w+)\.glsl', (PASSES / 'room.cmake').read_text()))
    wrong += [f'passes/{folder} has a text {text}.glsl; a pass has one, named like it'
              for folder, text in sorted(texts) if folder != text and folder not in NO_PASS]
    print('\n'.join(wrong) or f'{len(names)} passes, folders, shader texts, pages and tests')
    return 1 if wrong or len(names) < 20 else 0


sys.exit(main())
