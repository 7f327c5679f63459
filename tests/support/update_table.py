#!/usr/bin/env python3
"""Puts a table that the tests print into its page.

    tests/support/update_table.py build/release/caustics_tests hard_cases|closed_forms

The program draws every row on both devices and prints the table; this file only moves it between the two
marks in the page."""
import pathlib
import subprocess
import sys

DOCS = pathlib.Path(__file__).resolve().parents[2] / 'docs'
TABLES = {  # page, least number of lines
    'hard_cases': (DOCS / 'stability.md', 50),
    'closed_forms': (DOCS / 'measurements.md', 3),
}


def main():
    if len(sys.argv) != 3 or sys.argv[2] not in TABLES:
        sys.exit(__doc__)
    program, name = sys.argv[1:]
    page, least = TABLES[name]
    run = subprocess.run([program, f'[.{name}]'], capture_output=True, text=True)
    lines = [line for line in run.stdout.splitlines() if line.startswith('|')]
    table = ''.join('\n' if line == '|' else line + '\n' for line in lines).rstrip('\n') + '\n'
    if run.returncode != 0 or len(lines) < least:
        sys.exit(f'{program} did not print the table:\n{run.stdout}{run.stderr}')
    words = name.replace('_', ' ')
    begin, end = f'<!-- {words}: begin -->\n', f'<!-- {words}: end -->\n'
    text = page.read_text()
    if begin not in text or end not in text:
        sys.exit(f'{page} has no marks for the table: {begin.strip()}, {end.strip()}')
    before, rest = text.split(begin)
    page.write_text(before + begin + table + end + rest.split(end)[1])


if __name__ == '__main__':
    main()
