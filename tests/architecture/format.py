#!/usr/bin/env python3
"""The sources are as .clang-format has them, and no line of code is wider than 110 columns. Other versions
of clang-format than 14 lay code out differently: without that one the test is skipped (exit code 77), once
the widths are checked. `format.py --fix` formats the sources."""
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
WIDTH = 110
SOURCES = ('.cpp', '.hpp')
CODE = SOURCES + ('.py', '.glsl', '.cmake', '.sh', '.in', 'CMakeLists.txt')
LEFT_OUT = ('build', '.git')


def files(endings):
    """Those that git does not ignore; all where this is no checkout."""
    listed = subprocess.run(['git', '-C', ROOT, 'ls-files', '-co', '--exclude-standard'], text=True,
                            capture_output=True)
    names = listed.stdout.splitlines() if listed.returncode == 0 else [
        str(p.relative_to(ROOT)) for p in ROOT.rglob('*') if p.relative_to(ROOT).parts[0] not in LEFT_OUT]
    return sorted(n for n in names if n.endswith(endings) and (ROOT / n).is_file())


def too_wide():
    for name in files(CODE):
        for number, line in enumerate((ROOT / name).read_text().splitlines(), 1):
            if len(line) > WIDTH:
                yield f'{name}:{number}: {len(line)} columns, at most {WIDTH}'


def formatter():
    """clang-format 14, and why there is none."""
    found = 'no clang-format here'
    for name in ('clang-format-14', 'clang-format'):
        if program := shutil.which(name):
            version = subprocess.run([program, '--version'], text=True, capture_output=True)
            found = version.stdout.strip()
            if re.search(r'version 14\.', found):
                return program, ''
    return None, found


def unformatted(program):
    """Each source that the formatter would change, with the first place."""
    result = subprocess.run([program, '--dry-run', '-Werror', *files(SOURCES)], cwd=ROOT, text=True,
                            capture_output=True)
    places = {}
    for line in result.stderr.splitlines():
        if match := re.match(r'(.+?):(\d+):\d+: error: ', line):
            places.setdefault(match[1], match[2])
    if result.returncode and not places:
        return [f'clang-format failed: {result.stderr[:200]}']
    return [f'{name}:{number}: not as .clang-format has it' for name, number in places.items()]


def main():
    program, cause = formatter()
    if sys.argv[1:] == ['--fix']:
        if not program:
            sys.exit(f'needs clang-format 14; {cause}')
        return subprocess.run([program, '-i', *files(SOURCES)], cwd=ROOT).returncode
    wrong = list(too_wide()) + (unformatted(program) if program else [])
    if wrong:
        print('\n'.join(wrong) + '\nto format the sources: python3 tests/architecture/format.py --fix')
        return 1
    if not program:
        print(f'skipped: needs clang-format 14; {cause}')
        return 77
    count = len(files(SOURCES))
    print(f'{count} sources are formatted, no line of {len(files(CODE))} files is wider than {WIDTH}')
    return 1 if count < 100 else 0


if __name__ == '__main__':
    sys.exit(main())
