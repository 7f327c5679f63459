#!/usr/bin/env python3
"""Puts a table that the tests print into its page.

    tests/support/update_table.py build/release/caustics_tests closed_forms

The program draws every row on both devices and prints the table; this file shortens it for a reader, and puts
it between the two marks in the page."""
import pathlib
import subprocess
import sys

DOCS = pathlib.Path(__file__).resolve().parents[2] / 'docs'


def cells_of(line):
    return [cell.strip() for cell in line.strip('|').split('|')]


def nearest_to_bounds(lines):
    """Of each closed form's figures of one kind, the one that comes nearest to its bound."""
    forms = {}
    for truth, figure, software, opengl, bound, _ in map(cells_of, lines[2:]):
        if opengl not in (software, 'no driver'):
            sys.exit(f'{truth}, {figure}: {software} on the software device, {opengl} on OpenGL')
        kind = figure.split(',')[0].split()[0]
        forms.setdefault(truth, {}).setdefault(kind, []).append((figure, software, bound))
    text = []
    for truth, kinds in forms.items():
        nearest = (max(each, key=lambda row: float(row[1]) / float(row[2])) for each in kinds.values())
        said = [f'{what}: {error} ({bound})' for what, error, bound in nearest]
        text.append(f'- **{truth}**: {"; ".join(said)}')
    return text


TABLES = {  # page, how the table is shortened, least number of lines
    'closed_forms': (DOCS / 'accuracy.md', nearest_to_bounds, 20),
}


def main():
    if len(sys.argv) != 3 or sys.argv[2] not in TABLES:
        sys.exit(__doc__)
    program, name = sys.argv[1:]
    page, shortened, least = TABLES[name]
    run = subprocess.run([program, f'[.{name}]'], capture_output=True, text=True)
    lines = [line for line in run.stdout.splitlines() if line.startswith('|')]
    if run.returncode != 0 or len(lines) < least:
        sys.exit(f'{program} did not print the table:\n{run.stdout}{run.stderr}')
    table = '\n'.join(shortened(lines)).rstrip('\n') + '\n'
    words = name.replace('_', ' ')
    begin, end = f'<!-- {words}: begin -->\n', f'<!-- {words}: end -->\n'
    text = page.read_text()
    if begin not in text or end not in text:
        sys.exit(f'{page} has no marks for the table: {begin.strip()}, {end.strip()}')
    before, rest = text.split(begin)
    page.write_text(before + begin + table + end + rest.split(end)[1])


if __name__ == '__main__':
    main()
