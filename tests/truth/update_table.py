#!/usr/bin/env python3
"""Puts the table of closed forms into docs/measurements.md.

    tests/truth/update_table.py build/release/caustics_tests

The program renders every row on both devices at full size and prints the table; this file only moves it
between the two marks in the page."""
import pathlib
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parents[2] / 'docs' / 'measurements.md'
BEGIN, END = '<!-- closed forms: begin -->\n', '<!-- closed forms: end -->\n'


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    run = subprocess.run([sys.argv[1], '[.closed_forms]'], capture_output=True, text=True)
    table = ''.join(line + '\n' for line in run.stdout.splitlines() if line.startswith('|'))
    if run.returncode != 0 or table.count('\n') < 3:
        sys.exit(f'{sys.argv[1]} did not print the table:\n{run.stdout}{run.stderr}')
    text = PAGE.read_text()
    if BEGIN not in text or END not in text:
        sys.exit(f'{PAGE} has no marks for the table: {BEGIN.strip()}, {END.strip()}')
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    PAGE.write_text(before + BEGIN + table + END + after)


if __name__ == '__main__':
    main()
