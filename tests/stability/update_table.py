#!/usr/bin/env python3
"""Puts the table of hard cases into docs/stability.md.

    tests/stability/update_table.py build/release/caustics_tests

The program draws every case on both backends and prints the table; this file only moves it between the two marks in the
page."""
import pathlib
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parents[2] / 'docs' / 'stability.md'
BEGIN, END = '<!-- hard cases: begin -->\n', '<!-- hard cases: end -->\n'


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    run = subprocess.run([sys.argv[1], '[.hard_cases]'], capture_output=True, text=True)
    lines = [line for line in run.stdout.splitlines() if line.startswith('|')]
    table = ''.join('\n' if line == '|' else line + '\n' for line in lines).rstrip('\n') + '\n'
    if run.returncode != 0 or table.count('\n') < 50:
        sys.exit(f'{sys.argv[1]} did not print the table:\n{run.stdout}{run.stderr}')
    text = PAGE.read_text()
    if BEGIN not in text or END not in text:
        sys.exit(f'{PAGE} has no marks for the table: {BEGIN.strip()}, {END.strip()}')
    before, rest = text.split(BEGIN)
    PAGE.write_text(before + BEGIN + table + END + rest.split(END)[1])


if __name__ == '__main__':
    main()
