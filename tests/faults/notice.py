#!/usr/bin/env python3
"""Runs faults of a planted build, each with the tests that should notice it.
  notice.py BUILD [--jobs N] [--json FILE] [--sample COUNT SEED] [NAME ...]
NAME: a fault or a room; without any, all. Exit 1 when a test fails without a fault, or a fault goes
unnoticed."""
import argparse
import concurrent.futures
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

from faults import ROOT, all_faults

SKIPPED = 4  # tests/support/skip.hpp: what cannot run notices nothing
LONGEST = 900  # seconds; what takes longer hangs, which a test run notices, too


class Tests:
    def __init__(self, build):
        self.build = build.resolve()

    def commands(self, fault):
        """Catch2's tests as one command, then each of the program's."""
        patterns = [name for name in fault.noticed_by if '_test.py' not in name]
        commands = [(str(self.build / 'caustics_tests'), '--abort', ','.join(patterns))] if patterns else []
        for name in fault.noticed_by:
            if name not in patterns:
                file, *tests = name.split()
                commands.append((sys.executable, str(ROOT / 'tests/program' / file), '--failfast', *tests))
        return commands

    def broken(self, faults, pool):
        """What fails without a fault; Catch2's tests as one command, so that each runs once."""
        own = {command for fault in faults for command in self.commands(fault)}
        patterns = sorted({command[2] for command in own if command[1] == '--abort'})
        commands = [c for c in sorted(own) if c[1] != '--abort']
        if patterns:
            commands.append((str(self.build / 'caustics_tests'), ','.join(patterns)))
        answers = zip(commands, pool.map(self.run, commands))
        return [(command, said) for command, (passes, said) in answers if not passes]

    def run(self, command, fault=''):
        environment = dict(os.environ, CAUSTICS_FAULT=fault, CAUSTICS_PROGRAM=str(self.build / 'caustics'),
                           PYTHONDONTWRITEBYTECODE='1')
        with tempfile.TemporaryDirectory() as folder:
            try:
                result = subprocess.run(command, cwd=folder, env=environment, text=True, errors='replace',
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=LONGEST)
            except subprocess.TimeoutExpired:
                return False, 'does not end'
        passes = result.returncode in (0, SKIPPED) and 'No test' not in result.stdout
        return passes, result.stdout

    def has_opengl(self):
        scene = str(ROOT / 'scenes/slab.glb')
        return self.run((str(self.build / 'caustics'), 'digest', scene, '-r', '8x8', '--backend', 'gl'))[0]

    def judge(self, fault):
        """What notices the fault, or nothing; and the seconds that it took."""
        begun = time.monotonic()
        for command in self.commands(fault):
            if not self.run(command, fault.name)[0]:
                return ' '.join(command[1:]).replace(str(ROOT) + '/', ''), time.monotonic() - begun
        return None, time.monotonic() - begun


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('build', type=pathlib.Path)
    parser.add_argument('names', nargs='*')
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    parser.add_argument('--json', type=pathlib.Path)
    parser.add_argument('--sample', nargs=2, metavar=('COUNT', 'SEED'))
    return parser.parse_args()


def chosen(wanted):
    faults = all_faults()
    unknown = set(wanted.names) - {f.name for f in faults} - {f.room for f in faults}
    if unknown:
        sys.exit(f'notice.py: no fault or room is named {", ".join(sorted(unknown))}')
    if wanted.names:
        faults = [f for f in faults if f.name in wanted.names or f.room in wanted.names]
    faults = [f for f in faults if not f.unnoticed]
    if wanted.sample:
        faults = random.Random(wanted.sample[1]).sample(faults, min(int(wanted.sample[0]), len(faults)))
    return faults


def table(rows):
    lines = ['| room | planted | noticed |', '|---|---|---|']
    rooms = sorted({row['room'] for row in rows})
    for room in [*rooms, 'all']:
        of_room = [row for row in rows if room in (row['room'], 'all')]
        lines.append(f'| {room} | {len(of_room)} | {sum(1 for row in of_room if row["noticed_by"])} |')
    return '\n'.join(lines)


def main():
    wanted = arguments()
    tests, faults = Tests(wanted.build), chosen(wanted)
    if any(f.room == 'gl_backend' for f in faults) and not tests.has_opengl():
        print('OpenGL does not work here: the faults of gl_backend are left out', flush=True)
        faults = [f for f in faults if f.room != 'gl_backend']
    with concurrent.futures.ThreadPoolExecutor(wanted.jobs) as pool:
        broken = tests.broken(faults, pool)
        for command, said in broken:
            print(f'fails without a fault: {" ".join(command)[:500]}\n{said[-2000:]}', flush=True)
        if broken:
            return 1
        rows, answers = [], {pool.submit(tests.judge, fault): fault for fault in faults}
        for answer in concurrent.futures.as_completed(answers):
            fault, (by, seconds) = answers[answer], answer.result()
            print(f'{"noticed    " if by else "NOT NOTICED"} {seconds:6.1f} s  {fault.room}: {fault.name}: '
                  f'{fault.wrong}', flush=True)
            rows.append({'room': fault.room, 'fault': fault.name, 'noticed_by': by,
                         'seconds': round(seconds, 1)})
    print(table(rows))
    if wanted.json:
        wanted.json.write_text(json.dumps(rows, indent=1) + '\n')
    return 0 if all(row['noticed_by'] for row in rows) else 1


if __name__ == '__main__':
    sys.exit(main())
