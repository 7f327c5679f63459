#!/usr/bin/env python3
"""Whether builds draw the same bits: SHA-256 of every attachment of every pass of the sample scenes, for each
program, each of its lane widths, and several numbers of threads, against the first program's first. Without
--all the sizes are small, and programs behind the first take the numbers of threads in turn, one for each
lane width.

    matrix.py build/release/caustics build/clang/caustics
    matrix.py build/release/caustics 'aarch64=qemu-aarch64-static build/determinism/aarch64/caustics_digest'

A program is `caustics` or `caustics_digest`; NAME=COMMAND says how to start one that needs help. Prints a
table and ends with 0 where all agree, 1 where something differs or a program fails, 2 for wrong usage."""
import argparse
import concurrent.futures
import os
import pathlib
import re
import shlex
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Small enough for a build without optimisation; --all takes the sizes of `caustics digest`.
QUICK = '-r 48x27 --grid 24 --map 24 -D shadow=48 -D light.samples=2'.split()
# Whatever the sizes, its waves are run for seconds: every other program draws it once only, on its widest
# lanes.
SLOW = 'water_plops.glb'


class Failure(Exception):
    pass


def digest(command, arguments, lanes=''):
    """The lines of a program's digest."""
    environment = {**os.environ, 'CAUSTICS_LANES': lanes}
    result = subprocess.run([*command, 'digest', *arguments], env=environment, text=True, capture_output=True,
                            stdin=subprocess.DEVNULL)
    if result.returncode != 0:
        raise Failure(f'exit code {result.returncode}: {result.stderr.strip()[-300:]}')
    return result.stdout.splitlines()


def lanes_of(command, scene):
    """The lane widths that this build has and this processor runs: what a wrong name is answered with."""
    try:
        digest(command, [*QUICK, str(scene)], 'none')
    except Failure as answer:
        found = re.search(r'processor have:([\w ]+)', str(answer))
        if found:
            return found.group(1).split()
        raise
    raise Failure('took a lane width that does not exist')


def program_of(text):
    name, equals, command = text.partition('=')
    if equals and '/' not in name:
        return name, shlex.split(command)
    path = pathlib.Path(text).resolve()
    if not os.access(path, os.X_OK) or path.is_dir():
        raise argparse.ArgumentTypeError(f'{text} is no program')
    return path.parent.name, [str(path)]


def numbers(text):
    values = [int(word) for word in text.split(',')]
    if min(values) < 1:
        raise argparse.ArgumentTypeError('threads are counted from 1')
    return values


def options():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('programs', metavar='PROGRAM', nargs='+', type=program_of,
                        help='a path, or NAME=COMMAND')
    parser.add_argument('--all', action='store_true',
                        help='the sizes of `caustics digest`, and everything with everything')
    parser.add_argument('--threads', type=numbers, default=[1, 2, 7],
                        help='numbers of threads (default 1,2,7)')
    parser.add_argument('--lanes',
                        help='only these lane widths, with commas between (default all that a build has)')
    parser.add_argument('--scenes', default='*.glb',
                        help='only files of this pattern in scenes/ (default *.glb)')
    parser.add_argument('--leave-out', default='', metavar='PATTERN', help='files in scenes/ to leave out')
    parser.add_argument('--jobs', type=int, default=os.cpu_count(),
                        help='programs at a time (default one a core)')
    return parser.parse_args()


def differences(lines, expected):
    """How many attachments differ, and the first that does: 'scene pass attachment'."""
    names, expected_names = ([line.rsplit(' ', 1)[0] for line in each] for each in (lines, expected))
    if names != expected_names:
        odd = next((a for a, b in zip(names, expected_names) if a != b), f'{len(names)} of them')
        return len(expected), 'other attachments: ' + odd
    wrong = [name for name, line, other in zip(names, lines, expected) if line != other]
    return len(wrong), wrong[0] if wrong else ''


def run(command, arguments, lanes):
    started = time.monotonic()
    try:
        lines = digest(command, arguments, lanes)
    except (Failure, OSError) as error:
        return [], str(error), time.monotonic() - started
    return lines, '' if lines else 'printed nothing', time.monotonic() - started


def configurations(wanted, scenes):
    """(name, command, lanes, threads, scenes) of everything to be run."""
    for name, command in wanted.programs:
        found = lanes_of(command, scenes[0])
        lanes = [width for width in found if not wanted.lanes or width in wanted.lanes.split(',')]
        for turn, width in enumerate(lanes):
            if wanted.all or (name, command) == wanted.programs[0]:
                yield from ((name, command, width, threads, scenes) for threads in wanted.threads)
                continue
            drawn = [scene for scene in scenes if scene.name != SLOW or width == lanes[-1]]
            yield name, command, width, wanted.threads[turn % len(wanted.threads)], drawn


def main():
    wanted = options()
    scenes = [scene for scene in sorted((ROOT / 'scenes').glob(wanted.scenes))
              if not scene.match(wanted.leave_out or '-')]
    if not scenes:
        sys.exit(f'no scene in {ROOT / "scenes"} matches {wanted.scenes}')
    sizes = [] if wanted.all else QUICK
    try:
        rows = list(configurations(wanted, scenes))
    except (Failure, OSError) as error:
        print(f'matrix.py: {error}', file=sys.stderr)
        return 1
    width = max(len(name) for name, *_ in rows)
    print(f'{"build":{width}}  lanes   threads  attachments  differing  seconds')
    reference, agree = None, 0
    with concurrent.futures.ThreadPoolExecutor(max(1, wanted.jobs)) as pool:
        runs = [pool.submit(run, command, [*sizes, '-t', str(threads), *map(str, drawn)], lanes)
                for _, command, lanes, threads, drawn in rows]
        for (name, _, lanes, threads, drawn), future in zip(rows, runs):
            lines, problem, seconds = future.result()
            reference = lines if reference is None else reference
            names = {scene.name for scene in drawn}
            expected = [line for line in reference if line.split()[0] in names]
            wrong, first = (len(expected), problem) if problem else differences(lines, expected)
            agree += wrong == 0 and not problem
            print(f'{name:{width}}  {lanes:6}  {threads:7}  {len(lines):11}  {wrong:9}  {seconds:7.1f}  '
                  f'{first}'.rstrip(),
                  flush=True)
    print(f'{agree} of {len(rows)} configurations agree on {len(reference)} attachments '
          f'of {len(scenes)} scenes')
    return 0 if agree == len(rows) and reference else 1


sys.exit(main())
