#!/usr/bin/env python3
"""What accuracy costs in time, at one glance: the paper's own frame, the defaults, errors that were asked
for, a plain forward splat, traced light in the defaults' time, and POV-Ray, all against full light transport.

    lab/reference/povray/at_a_glance.py [--scene NAME ...] [-o DIR] [--check README.md [--drawn N SEED]]

Error: relative L1 of the caustic by means of 4 x 4 pixels, 256 x 256 pixels of floor. Time: wall milliseconds
of whole processes, the least of three. Writes DIR/at_a_glance.md and .svg, which README shows. With --check
each process runs once, and the errors are held against the page's, of N scenes drawn by chance: ends with 1
where they differ."""
import argparse
import math
import pathlib
import random
import re
import subprocess
import sys

sys.dont_write_bytecode = True
import bench as benches  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[3]
BOX, TARGETS = 4, ('5%', '2%', '1%')
PHOTONS = ((30000, 20, 100), (300000, 20, 100))
COLORS = ('#1b6ca8', '#c2571a', '#8a4f9e', '#4a8f3c')


def least_wall(run, repeat):
    return min(run()['wall'] for _ in range(repeat)) * 1000


def chosen_sizes(bench, target):
    """The options that `--target-error` chooses."""
    command = [bench.arguments.program, bench.file, '--camera', 'floor', '-r', '256x256', '--target-error',
               target, '-o', bench.path('chosen.exr'), '--aov', 'caustic']
    said = subprocess.run([str(word) for word in command], text=True, capture_output=True).stderr
    grid, map_ = re.search(r'chose --grid (\d+) --map (\d+)', said).groups()
    return ['--grid', grid, '--map', map_]


def frames(bench, repeat):
    """(name, milliseconds, error) of every way to the picture."""
    def error(picture):
        return bench.truth.errors(picture)['raw'][BOX]

    def rendered(name, *options):
        run = lambda: bench.caustics('render', 'frame', '--aov', 'caustic', *options)  # noqa: E731
        milliseconds = least_wall(run, repeat)
        return name, milliseconds, error(bench.read('frame', 'caustic'))

    yield rendered('`--preset paper`', '--preset', 'paper')
    defaults = rendered('defaults')
    yield defaults
    for target in TARGETS:
        yield rendered(f'`--target-error {target}`', *chosen_sizes(bench, target))
    yield rendered('forward splat, 2048 x 2048 rays', '--grid', '2048', '--map', '512', '--splat', 'point')
    # Traced light starts and stops by batches: as near to the defaults' time as its rays allow.
    rays, spent = 64, 0.0
    while rays < 4096 and spent < defaults[1]:
        rays *= 2
        spent = least_wall(lambda: bench.caustics('reference', 'equal', '--rays', rays, '--batches', '2',
                                                  '--aov', 'caustic'), 1)
    yield f'traced light, {rays} x {rays} rays', spent, error(bench.read('equal', 'caustic'))
    for photons in PHOTONS:
        setting = benches.Setting('POV-Ray', photons)
        yield (f'POV-Ray, {photons[0]} photons', least_wall(lambda s=setting: s.run(bench), repeat),
               error(bench.caustic(setting)))


def table(results):
    lines = ['| | ' + ' | '.join(f'`{name}`: error, ms' for name in results) + ' |',
             '|---|' + '---|' * len(results)]
    for row in zip(*results.values()):
        name = re.sub(r'(traced light), .*', r'\1, in about that time', row[0][0])
        lines.append(f'| {name} | ' + ' | '.join(f'{100 * e:.1f} %, {t:.0f}' for _, t, e in row) + ' |')
    return '\n'.join(lines) + '\n'


# How far errors may lie from the page's: a share of them. A target chooses by measured times, which every
# machine has for itself: where it is met, the page's figure may be another. It is met by the frame's own
# estimate, which was found a tenth too small. Equal times are nobody else's.
STEADY, CHOSEN, ESTIMATED = 0.03, 0.3, 1.15
LEAST = 0.0011  # the page has tenths of a percent


def departures(text, results):
    """A line for each error of the page's table that is not found again."""
    header = next(line for line in text.splitlines() if '`: error, ms' in line)
    scenes = re.findall(r'`(\w+)`: error, ms', header)
    lines, compared = [], 0
    for line in text.partition(header)[2].strip().splitlines():
        name, *cells = (cell.strip() for cell in line.strip('|').split('|'))
        for scene, cell in zip(scenes, cells):
            said = re.match(r'([\d.]+) %', cell)
            rows = [e for kind, _, e in results.get(scene, ()) if kind.split(',')[:1] == name.split(',')[:1]
                    and ('photons' not in name or kind == name)]
            if not said or not rows or name.startswith('traced'):
                continue
            compared += 1
            page, chosen = float(said[1]) / 100, name.startswith('`--target')
            asked = float(re.search(r'([\d.]+)%', name)[1]) / 100 if chosen else 0
            off = rows[0] - page if chosen else abs(rows[0] - page)
            if rows[0] > ESTIMATED * asked and off > max((CHOSEN if chosen else STEADY) * page, LEAST):
                lines.append(f'{scene}, {name}: the page says {said[1]} %, found {100 * rows[0]:.2f} %')
    return lines if compared else ['the page has no figure of these scenes']


def mark(kind, x, y, color):
    """A sign for one way to the picture."""
    shapes = {'paper': 'M-5 -5H5V5H-5Z', 'defaults': 'M-6 0L0 -6L6 0L0 6Z', 'traced': 'M0 -6L6 5H-6Z',
              'target': 'M-4 0A4 4 0 1 1 4 0A4 4 0 1 1 -4 0',
              'splat': 'M0 6L6 -5H-6Z', 'POV-Ray': 'M-5 -5L5 5M5 -5L-5 5'}
    shape = next(shapes[word] for word in shapes if word in kind)
    return f'<path transform="translate({x:.1f} {y:.1f})" d="{shape}" fill="{color}" stroke="{color}"/>'


def plot(results):
    """Error over milliseconds, both logarithmic."""
    points = [(t, e) for rows in results.values() for _, t, e in rows]
    low, high = ([pick(p[k] for p in points) * by for k in (0, 1)]
                 for pick, by in ((min, 0.8), (max, 1.25)))
    width, height, edge = 760, 460, 60

    def place(t, e):
        along = [math.log(v / a) / math.log(b / a) for v, a, b in zip((t, e), low, high)]
        return edge + (width - 2 * edge) * along[0], height - edge - (height - 2 * edge) * along[1]

    text = ['<svg xmlns="http://www.w3.org/2000/svg" font-family="sans-serif" font-size="13" '
            f'viewBox="0 0 {width} {height}">', f'<rect width="{width}" height="{height}" fill="white"/>']
    steps = [digit * 10.0 ** power for power in range(-5, 6) for digit in (1, 2, 5)]
    for t in (t for t in steps if low[0] <= t <= high[0]):
        x = place(t, low[1])[0]
        text += [f'<path d="M{x:.1f} {edge}V{height - edge}" stroke="#ddd"/>',
                 f'<text x="{x:.1f}" y="{height - edge + 18}" text-anchor="middle">{t:g} ms</text>']
    for e in (e for e in steps if low[1] <= e <= high[1]):
        y = place(low[0], e)[1]
        text += [f'<path d="M{edge} {y:.1f}H{width - edge}" stroke="#ddd"/>',
                 f'<text x="{edge - 6}" y="{y + 4:.1f}" text-anchor="end">{100 * e:g} %</text>']
    for color, rows in zip(COLORS, results.values()):
        text += [mark(name, *place(t, e), color) for name, t, e in rows]
    for i, (color, scene) in enumerate(zip(COLORS, results)):
        text.append(f'<text x="{edge + 150 * i}" y="30" fill="{color}">{scene}</text>')
    for i, kind in enumerate(('--preset paper', 'defaults', '--target-error', 'forward splat', 'traced light',
                              'POV-Ray')):
        text += [mark(kind, edge + 115 * i, height - 18, '#444'),
                 f'<text x="{edge + 115 * i + 10}" y="{height - 14}">{kind}</text>']
    return '\n'.join(text + ['</svg>', ''])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('--scene', action='append')
    parser.add_argument('-o', '--output', type=pathlib.Path, default=pathlib.Path('at_a_glance'))
    parser.add_argument('--program', default=ROOT / 'build/release/caustics')
    parser.add_argument('--povray', default='povray')
    parser.add_argument('--check', type=pathlib.Path, metavar='README.md')
    parser.add_argument('--drawn', nargs=2, metavar=('N', 'SEED'))
    arguments = parser.parse_args()
    scenes = arguments.scene or ['glass_sphere', 'water_sine', 'metal_ring', 'glass/drinking_glass']
    if arguments.drawn:
        scenes = random.Random(arguments.drawn[1]).sample(scenes, int(arguments.drawn[0]))
    repeat = 1 if arguments.check else 3
    arguments.camera, arguments.exact, arguments.resolution, arguments.boxes = 'floor', None, 256, [BOX]
    arguments.physics, arguments.threads = 'full', 2
    arguments.truth_rays, arguments.truth_batches = 1024, 16
    results = {}
    for name in scenes:
        bench = benches.Bench(arguments, ROOT / 'scenes' / f'{name}.glb')
        bench.folder.mkdir(parents=True, exist_ok=True)
        results[bench.name] = list(frames(bench, repeat))
        print(f'{bench.name}: noise of the truth {bench.truth.noise[BOX]:.4f}', file=sys.stderr, flush=True)
    (arguments.output / 'at_a_glance.md').write_text(table(results))
    (arguments.output / 'at_a_glance.svg').write_text(plot(results))
    print(table(results), end='')
    wrong = departures(arguments.check.read_text(), results) if arguments.check else []
    print(''.join(line + '\n' for line in wrong), end='')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
