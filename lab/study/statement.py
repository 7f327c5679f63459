#!/usr/bin/env python3
"""Holds the error that frames state of themselves against light itself: settings drawn at random, scene by
scene, each compared with `caustics reference` by the means of 4 x 4 pixels of a 256 x 256 floor view.

    lab/study/statement.py -o DIR [--settings 200] [--seed 1] [SCENE.glb ...]    without scenes: the samples'

Traced scenes are kept in DIR. Within a factor of two counts as right, and so do two errors below 1 % or three
standard errors of the truth. docs/accuracy.md has the outcome."""
import argparse
import json
import os
import pathlib
import random
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SAMPLES = ('glass_sphere', 'metal_ring', 'prism', 'slab_glass', 'water_sine', 'water_patch', 'two_lights')
VIEW = ['--camera', 'floor', '-r', '256x256']
KNOBS = {
    '--grid': ('64', '96', '128', '192', '256', '384', '512', '768'),
    '--map': ('64', '128', '256', '384', '512', '768', '1024'),
    '--splat': ('cell', 'cell', 'cell', 'gaussian', 'point'),
    '--estimator': ('secant', 'secant', 'secant', 'paper', 'newton', 'impostor'),
    '--iterations': ('1', '2', '3', '5', '5', '8'),
    '--interfaces': ('auto', 'auto', 'auto', '1', '2'),
    '-D': ('splits=0', 'splits=1', 'splits=2', 'splits=2', 'splits=3', 'splits=4'),
}


def run(program, *arguments):
    return subprocess.run([program, *arguments], text=True, capture_output=True)


def traced(program, scene, folder):
    """The truth's file, and the noise of its means of 4 x 4 pixels."""
    truth = folder / (scene.stem + '.truth.exr')
    stats = truth.with_suffix('.json')
    if not stats.exists():
        done = run(program, 'reference', scene, *VIEW, '-o', truth, '--stats', stats, '--error', '4%',
                   '--seconds', '180', '--quiet')
        if done.returncode not in (0, 6):
            sys.exit(f'{scene}: {done.stderr.strip()}')
    said = json.loads(stats.read_text())
    return truth, said['noise'] / 4 + said['given_up']


def judged(program, scene, truth, options, folder):
    """True and stated error of one frame."""
    picture, stats = folder / 'frame.exr', folder / 'frame.json'
    done = run(program, scene, *VIEW, '-o', picture, '--aov', 'caustic', '--stats', stats, '--quiet',
               *options)
    if done.returncode:
        sys.exit(f'{scene} {options}: {done.stderr.strip()}')
    lights = [light for light in json.loads(stats.read_text())['lights'] if light['estimated_error']]
    entered = [sum(light['flux']['entered']) * light['intensity'] for light in lights]
    stated = sum(e * light['estimated_error']['total'] for e, light in zip(entered, lights))
    compared = run(program, 'compare', picture, truth, '--layer', 'caustic', '--blocks', '4', '--json')
    layer = json.loads(compared.stdout)['layers'][0]
    return layer['metrics']['relative_l1'], stated / sum(entered) if sum(entered) else None


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('scenes', nargs='*', type=pathlib.Path)
    parser.add_argument('-o', '--output', type=pathlib.Path, required=True)
    parser.add_argument('--settings', type=int, default=200)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--program', default=str(ROOT / 'build/release/caustics'))
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    scenes = options.scenes or [ROOT / 'scenes' / f'{name}.glb' for name in SAMPLES] + sorted(
        (ROOT / 'scenes' / 'glass').glob('*.glb'))
    draw, right, rows = random.Random(options.seed), 0, []
    for k in range(options.settings):
        scene = scenes[k % len(scenes)]
        truth, noise = traced(options.program, scene, options.output)
        chosen = [word for knob, values in KNOBS.items() for word in (knob, draw.choice(values))]
        true, stated = judged(options.program, scene, truth, chosen, options.output)
        equal = max(0.01, 3 * noise)
        fits = stated is not None and (max(true, stated) <= equal or 0.5 <= stated / max(true, 1e-9) <= 2.0)
        right += fits
        rows.append([scene.stem, ' '.join(chosen[1::2]), f'{true:.4f}', f'{stated or 0:.4f}', str(int(fits))])
        print(f'{k + 1:4} {"  " if fits else "NO"} {scene.stem:24} true {true:7.4f} '
              f'stated {stated or 0:7.4f} noise {noise:.4f}  {" ".join(chosen[1::2])}', flush=True)
    (options.output / 'statement.csv').write_text(
        '\n'.join(['scene,settings,true,stated,fits'] + [','.join(row) for row in rows]) + os.linesep)
    print(f'{right} of {options.settings} within a factor of two: {100 * right / options.settings:.0f} %')


if __name__ == '__main__':
    main()
