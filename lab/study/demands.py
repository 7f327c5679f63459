#!/usr/bin/env python3
"""Holds the sizes that --target-error and --time-budget choose against all sizes, tried by force, by a
256 x 256 floor view of each of eight scenes.

    lab/study/demands.py -o DIR [SCENE ...]        without scenes: all eight

Sizes of more than four times the vertices and texels of the best so far are not tried. Traced scenes are kept
in DIR. docs/accuracy.md has the outcome."""
import argparse
import json
import pathlib

from statement import ROOT, VIEW, judged, run, traced

SIDES = (64, 96, 128, 192, 256, 384, 512, 768, 1024, 1536)
# Percent, and milliseconds of all passes.
DEMANDS = {'glass_sphere': (6, 200), 'metal_ring': (3, 60), 'prism': (12, 200), 'slab_glass': (33, 100),
           'water_patch': (1, 60), 'two_lights': (6, 400), 'glass/glass_bowl': (20, 200),
           'glass/drinking_glass': (36, 150)}


class Bench:
    """One scene; sizes are tried once and remembered."""

    def __init__(self, program, scene, folder):
        self.program, self.scene, self.folder, self.tried = program, scene, folder, {}
        self.truth, self.noise = traced(program, scene, folder)

    def frame(self, grid, side):
        """True and stated error, and the fastest of three runs."""
        if (grid, side) not in self.tried:
            times = []
            for _ in range(3):
                true, stated = judged(self.program, self.scene, self.truth,
                                      ['--grid', str(grid), '--map', str(side), '--aov', 'beauty,caustic'],
                                      self.folder)
                times.append(json.loads((self.folder / 'frame.json').read_text())['milliseconds']['passes'])
            self.tried[grid, side] = true, stated, min(times)
        return self.tried[grid, side]

    def chosen(self, *demand):
        """What the program chooses, and its exit code: 6 where nothing does."""
        stats = self.folder / 'chosen.json'
        done = run(self.program, self.scene, *VIEW, *demand, '-o', self.folder / 'chosen.png', '--quiet',
                   '--stats', stats)
        settings = json.loads(stats.read_text())['settings']
        return (settings['grid'], settings['map']), done.returncode

    def by_force(self, meets, better):
        best = None
        for grid, side in sorted(((g, m) for g in SIDES for m in SIDES), key=lambda s: s[0]**2 + s[1]**2):
            far = best and grid**2 + side**2 > 4 * (best[0]**2 + best[1]**2)
            if far and (grid, side) not in self.tried:
                continue
            frame = self.frame(grid, side)
            if meets(frame) and (not best or better(frame, self.frame(*best))):
                best = grid, side
        return best


def told(name, demand, bench, chosen, code, best):
    def text(sides):
        if not sides:
            return 'none'
        true, stated, time = bench.frame(*sides)
        return f'{sides[0]} {sides[1]}, {100 * true:.1f} ({100 * stated:.1f}) %, {time:.0f} ms'
    missed = ', missed' if code else ''
    print(f'| {name} | {demand} | {text(chosen)}{missed} | {text(best)} |', flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('scenes', nargs='*', choices=[*DEMANDS, []], metavar='SCENE')
    parser.add_argument('-o', '--output', type=pathlib.Path, required=True)
    parser.add_argument('--program', default=str(ROOT / 'build/release/caustics'))
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    print('| scene | asked for | grid, map, true (stated) error, time | by force |\n|---|---|---|---|')
    for name in options.scenes or DEMANDS:
        bench = Bench(options.program, ROOT / 'scenes' / f'{name}.glb', options.output)
        error, budget = DEMANDS[name]
        chosen, code = bench.chosen('--target-error', f'{error}%')
        best = bench.by_force(lambda f: f[1] <= error / 100, lambda f, b: f[2] < b[2])
        told(name, f'{error} %', bench, chosen, code, best)
        chosen, code = bench.chosen('--time-budget', str(budget))
        best = bench.by_force(lambda f: f[2] <= budget, lambda f, b: f[1] < b[1])
        told(name, f'{budget} ms', bench, chosen, code, best)


if __name__ == '__main__':
    main()
