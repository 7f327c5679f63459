#!/usr/bin/env python3
"""The part of a long list of checks that a run takes: what the hash of the commit draws, so that a run can be
repeated and the next commit draws others. CAUSTICS_DRAWN=all takes everything.

    drawn.py OF < LIST     one line in OF of a list of lines
"""
import os
import pathlib
import random
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def seed():
    """The commit's hash; outside of a repository a word, so that always the same is drawn."""
    told = subprocess.run(['git', '-C', ROOT, 'rev-parse', 'HEAD'], capture_output=True, text=True)
    return told.stdout.strip() if told.returncode == 0 else 'no commit'


def drawn(things, of):
    """One in `of` of the things, at least one, in their order."""
    things = list(things)
    if os.environ.get('CAUSTICS_DRAWN') == 'all':
        return things
    chosen = random.Random(seed()).sample(range(len(things)), -(-len(things) // of))
    return [things[i] for i in sorted(chosen)]


if __name__ == '__main__':
    print('\n'.join(drawn(sys.stdin.read().splitlines(), int(sys.argv[1]))))
