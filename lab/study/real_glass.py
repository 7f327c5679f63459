#!/usr/bin/env python3
"""How near the caustics of real glass come to full light transport, by how often light is split.

    lab/study/real_glass.py [SCENE ...] [-o DIR] [--check docs/materials.md] [--drawn N SEED]

Error: relative L1 of the layer caustic by means of 8 x 8 of 256 x 256 pixels of floor, through two surfaces
and with so many splits. Writes the table. With --check it ends with 1 where an error differs from the page's;
--drawn takes N of the scenes, by chance."""
import argparse
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
WAYS = {'two surfaces': ['-D', 'further.share=1'],
        **{f'splits {n}': ['-D', f'splits={n}'] for n in (0, 1, 2, 4)}}
# How far errors may lie from the page's: a share of them, and the noise of so short a trace, which the page's
# (64 batches) has half of.
NEAR, LEAST = 0.05, 0.006


def run(program, *words):
    done = subprocess.run([str(word) for word in (program, *words)], text=True, capture_output=True)
    if done.returncode not in (0, 1):
        sys.exit(f'real_glass.py: caustics {words[0]} ended with {done.returncode}: {done.stderr}')
    return done.stdout


def errors(program, scene, folder, batches):
    """{way: error}."""
    view = ['--camera', 'floor', '-r', '256x256', '--aov', 'caustic', '--quiet']
    truth, frame = (folder / f'{scene.stem}_{name}.exr' for name in ('truth', 'frame'))
    run(program, 'reference', scene, *view, '--physics', 'full', '--batches', batches, '-o', truth)
    found = {}
    for way, options in WAYS.items():
        run(program, 'render', scene, *view, *options, '-o', frame)
        compared = run(program, 'compare', frame, truth, '--layer', 'caustic', '--blocks', 8, '--json')
        found[way] = json.loads(compared)['layers'][0]['metrics']['relative_l1']
    return found


def departures(page, results):
    """A line for each error that the page has otherwise."""
    lines = []
    for name, found in results.items():
        row = re.search(rf'^ *\| `{name}` \|(.*)\|$', page, re.M)
        said = [float(cell.split(',')[0]) for cell in row[1].split('|')] if row else []
        if len(said) != len(found):
            lines.append(f'{name}: the page has no row of {len(found)} errors')
            continue
        lines += [f'{name}, {way}: the page says {old}, found {new:.4f}'
                  for old, (way, new) in zip(said, found.items()) if abs(new - old) > max(NEAR * old, LEAST)]
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('scenes', nargs='*', type=pathlib.Path)
    parser.add_argument('-o', '--output', type=pathlib.Path)
    parser.add_argument('--program', default=ROOT / 'build/release/caustics')
    parser.add_argument('--batches', type=int, default=16)
    parser.add_argument('--check', type=pathlib.Path)
    parser.add_argument('--drawn', nargs=2, metavar=('N', 'SEED'))
    arguments = parser.parse_args()
    scenes = arguments.scenes or sorted((ROOT / 'scenes/glass').glob('*.glb'))
    if arguments.drawn:
        scenes = random.Random(arguments.drawn[1]).sample(scenes, int(arguments.drawn[0]))
    results = {}
    with tempfile.TemporaryDirectory() as scratch:
        folder = arguments.output or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        print('| error | ' + ' | '.join(WAYS) + ' |\n|---|' + '---|' * len(WAYS))
        for scene in scenes:
            results[scene.stem] = errors(arguments.program, scene, folder, arguments.batches)
            cells = (f'{error:.3f}' for error in results[scene.stem].values())
            print(f'| `{scene.stem}` | ' + ' | '.join(cells) + ' |', flush=True)
    wrong = departures(arguments.check.read_text(), results) if arguments.check else []
    print(''.join(line + '\n' for line in wrong), end='')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
