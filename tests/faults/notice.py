#!/usr/bin/env python3
"""Runs faults of a planted build, each with the tests that should notice it: those of the lists with the
tests that they name, drawn ones with all tests that reach their place, the cheapest first.
  notice.py BUILD [NAME ...]          the faults of the lists; NAME: a fault or a room, of both kinds
  notice.py BUILD --drawn [ROOM ...]  the drawn ones
    --sample COUNT SEED   so many of the lists, and with --drawn as many of the drawn ones as there are
    --quick               without the tests that compute long
    --promised SHARE      what share of the drawn ones is noticed: it fails with fewer than a sample of
                          so many has but once in a hundred times
    --patience SECONDS    a drawn fault that its tests have not noticed by then counts as unnoticed
    --jobs N, --json FILE
Exit 1 when a test fails without a fault, a fault of the lists goes unnoticed, or the drawn ones' score is too
low."""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import random
import sys
import tempfile
import time

from faults import ROOT, all_faults
from plant import drawn_in
from reach import LONGEST, SKIPPED, Runner, by_subject, escaped, known_or_found, run


class Tests:
    """The faults of the lists, by the tests that they name."""

    def __init__(self, build):
        self.build = build.resolve()

    def commands(self, fault):
        """Catch2's tests as one command, then each of the program's."""
        names = [name for name in fault.noticed_by if '_test.py' not in name]
        cases = ','.join(map(escaped, names))
        commands = [(str(self.build / 'caustics_tests'), '--abort', cases)] if names else []
        for name in fault.noticed_by:
            if name not in names:
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
        environment = {'CAUSTICS_FAULT': fault, 'CAUSTICS_PROGRAM': str(self.build / 'caustics')}
        with tempfile.TemporaryDirectory() as folder:
            status, output = run(command, environment, folder, LONGEST)
        passes = status in (0, SKIPPED) and 'No test' not in output
        return passes, 'does not end' if status is None else output

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


class DrawnTests:
    """The drawn faults, by the tests that reach their places: those of the same subject first."""

    def __init__(self, build, source, wanted, pool):
        self.runner, self.patience = Runner(build, source), wanted.patience
        self.tests = known_or_found(build, source, wanted.quick, pool)

    def judge(self, fault):
        begun = time.monotonic()
        place = fault.number() % (1 << 16)
        reaching = [test for test in self.tests if place in test.places]
        for group in by_subject(reaching, fault.file):
            if time.monotonic() - begun > self.patience:
                break
            by = self.runner.notices(group, fault.name)
            if by:
                return by, time.monotonic() - begun
        return (None if reaching else ''), time.monotonic() - begun


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('build', type=pathlib.Path)
    parser.add_argument('names', nargs='*')
    parser.add_argument('--drawn', action='store_true')
    parser.add_argument('--quick', action='store_true')
    parser.add_argument('--promised', type=float, default=0.0)
    parser.add_argument('--patience', type=float, default=math.inf)
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    parser.add_argument('--json', type=pathlib.Path)
    parser.add_argument('--sample', nargs=2, metavar=('COUNT', 'SEED'))
    return parser.parse_args()


def chosen(wanted, listed, drawn):
    """The faults of the lists and the drawn ones that are to be judged."""
    both = listed + drawn
    unknown = set(wanted.names) - {f.name for f in both} - {f.room for f in both}
    if unknown:
        sys.exit(f'notice.py: no fault or room is named {", ".join(sorted(unknown))}')
    if wanted.names:
        both = [f for f in both if f.name in wanted.names or f.room in wanted.names]
    listed = [f for f in listed if f in both and not f.unnoticed]
    if wanted.sample:
        listed = random.Random(wanted.sample[1]).sample(listed, min(int(wanted.sample[0]), len(listed)))
    elif wanted.drawn:
        listed = []
    by_name = set(wanted.names) & {f.name for f in drawn}
    return listed, [f for f in drawn if f in both] if wanted.drawn or by_name else []


def table(rows, kind):
    lines = [f'| room | {kind} | noticed | |', '|---|---|---|---|']
    rooms = sorted({row['room'] for row in rows})
    for room in [*rooms, 'all']:
        of_room = [row for row in rows if room in (row['room'], 'all')]
        noticed = sum(1 for row in of_room if row['noticed_by'])
        share = 100 * noticed / max(len(of_room), 1)
        lines.append(f'| {room} | {len(of_room)} | {noticed} | {share:.0f} % |')
    return '\n'.join(lines)


def fewest(count, share):
    """The largest number of which a sample of `count` has fewer with a chance of at most 1 %, where
    `share` is true of all."""
    below = 0.0
    for noticed in range(count + 1):
        below += math.comb(count, noticed) * share**noticed * (1 - share)**(count - noticed)
        if below > 0.01:
            return noticed
    return count


def judged(faults, judge, pool):
    rows, answers = [], {pool.submit(judge, fault): fault for fault in faults}
    for answer in concurrent.futures.as_completed(answers):
        fault, (by, seconds) = answers[answer], answer.result()
        verdict = 'noticed    ' if by else 'NOT REACHED' if by == '' else 'NOT NOTICED'
        print(f'{verdict} {seconds:6.1f} s  {fault.room}: {fault.name}: {fault.wrong}'
              + (f'\n                      by {by}' if by else ''), flush=True)
        rows.append({'room': fault.room, 'fault': fault.name, 'wrong': fault.wrong, 'noticed_by': by,
                     'seconds': round(seconds, 1)})
    return rows


def main():
    wanted = arguments()
    build = wanted.build.resolve()
    source = build.parent / 'source'
    tests = Tests(build)
    listed, drawn = chosen(wanted, all_faults(), drawn_in(source))
    if any(f.file.startswith('gl_backend/') for f in listed + drawn) and not tests.has_opengl():
        print('OpenGL does not work here: the faults of gl_backend are left out', flush=True)
        listed, drawn = ([f for f in faults if not f.file.startswith('gl_backend/')]
                         for faults in (listed, drawn))
    good, rows = True, []
    with concurrent.futures.ThreadPoolExecutor(wanted.jobs) as pool:
        if listed:
            broken = tests.broken(listed, pool)
            for command, said in broken:
                print(f'fails without a fault: {" ".join(command)[:500]}\n{said[-2000:]}', flush=True)
            if broken:
                return 1
            rows = judged(listed, tests.judge, pool)
            print(table(rows, 'of the lists'))
            good = all(row['noticed_by'] for row in rows)
        if drawn:
            of_drawn = judged(drawn, DrawnTests(build, source, wanted, pool).judge, pool)
            noticed = sum(1 for row in of_drawn if row['noticed_by'])
            bound = fewest(len(of_drawn), wanted.promised)
            print(table(of_drawn, 'drawn'))
            print(f'{noticed} of {len(of_drawn)} drawn faults are noticed; {bound} have to be')
            good = good and noticed >= bound
            rows += of_drawn
    if wanted.json:
        wanted.json.write_text(json.dumps(rows, indent=1) + '\n')
    return 0 if good else 1


if __name__ == '__main__':
    sys.exit(main())
