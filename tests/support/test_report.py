#!/usr/bin/env python3
"""Counts what CTest ran, from its JUnit file: a line for each test that was skipped, with the cause, then
passed, failed and skipped as three numbers. A Python file that says how many of its methods passed counts as
those; everything else as one test. To standard error goes the end of what each failed test wrote.

    test_report.py REPORT.xml
"""
import re
import sys
import xml.etree.ElementTree as tree

METHODS = re.compile(r'^methods: (\d+) passed, (\d+) failed, (\d+) skipped$', re.MULTILINE)
FAILURE_LINES = 40
SKIPPED = re.compile(r'^skipped: (.*)$', re.MULTILINE)


def judged(case):
    """Passed, failed and skipped of one of CTest's tests, and its skipped ones as (name, cause)."""
    name, output = case.get('name'), case.findtext('system-out') or ''
    causes = SKIPPED.findall(output)
    if methods := METHODS.search(output):
        return [int(n) for n in methods.groups()], [(f'{name} {cause.partition(": ")[0]}',
                                                     cause.partition(': ')[2]) for cause in causes]
    if case.find('skipped') is not None or case.get('status') in ('disabled', 'notrun'):
        return [0, 0, 1], [(name, causes[0] if causes else 'CTest did not run it')]
    return ([1, 0, 0] if case.get('status') == 'run' else [0, 1, 0]), []


def say_failure(case):
    """Again at the end, where it is not lost among a thousand tests that passed."""
    lines = (case.findtext('system-out') or '').strip().splitlines()
    print(f'FAILED: {case.get("name")}', *lines[-FAILURE_LINES:], sep='\n    ', file=sys.stderr)


def main():
    counts, skipped = [0, 0, 0], []
    for case in tree.parse(sys.argv[1]).getroot().iter('testcase'):
        of_case, of_skipped = judged(case)
        counts = [a + b for a, b in zip(counts, of_case)]
        skipped += of_skipped
        if of_case[1]:
            say_failure(case)
    for name, cause in skipped:
        print(f'{name}: {cause}')
    print(*counts)


main()
