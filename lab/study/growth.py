#!/usr/bin/env python3
"""How processor time and peak memory of `caustics render` grow with each size that a frame has.

    lab/study/growth.py -o DIR [--only QUANTITY ...] [--most COUNT]

Writes growth.csv, passes.csv and growth.svg to DIR, and prints slopes of log cost over log size: 1 is linear.
Each figure is the least of three runs; runs of more than 20 s are made once. Scenes are kept in DIR."""
import argparse
import array
import csv
import json
import math
import multiprocessing
import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / 'scenes'))
from making import gltf_scene  # noqa: E402
from making.shapes import icosphere, square  # noqa: E402

SAMPLE = ROOT / 'scenes/glass_sphere.glb'
DOUBLED = (64, 128, 256, 512, 1024, 2048, 4096)
PICTURES = ('160x90', '320x180', '640x360', '1280x720', '1920x1080', '3840x2160', '7680x4320')
CENTRE, RADIUS = (0.0, 0.75, 0.0), 0.34
COSTS = {'processor_s': 'processor time, s', 'peak_mb': 'peak memory, MB'}
LONG_RUN = 20.0  # seconds


def fine_sphere(scene, triangles):
    """Rings of 2 n quads, made row by row: 10 million triangles as lists of tuples would take gigabytes."""
    n = max(2, round(math.sqrt(triangles / 4)))
    around = [(math.cos(math.pi * k / n), math.sin(math.pi * k / n)) for k in range(2 * n)]
    points = array.array('f', (0.0, 1.0, 0.0))
    for i in range(1, n):
        y, r = math.cos(math.pi * i / n), math.sin(math.pi * i / n)
        points.extend(v for c, s in around for v in (r * c, y, r * s))
    points.extend((0.0, -1.0, 0.0))
    last, m = len(points) // 3 - 1, 2 * n
    indices = array.array('I')
    for k in range(m):
        indices.extend((0, 1 + (k + 1) % m, 1 + k))
    quads = [v for k in range(m) for a, b in [(k, (k + 1) % m)] for v in (a, b, b + m, a, b + m, a + m)]
    for i in range(n - 2):
        indices.extend([v + 1 + i * m for v in quads])
    for k in range(m):
        indices.extend((last, last - m + k, last - m + (k + 1) % m))
    count = len(points) // 3

    def vectors(**bounds):
        return scene.accessor(bufferView=scene.view(points.tobytes(), 34962), componentType=5126, count=count,
                              type='VEC3', **bounds)
    position, normal = vectors(min=[-1.0] * 3, max=[1.0] * 3), vectors()
    corners = scene.accessor(bufferView=scene.view(indices.tobytes(), 34963), componentType=5125,
                             count=len(indices), type='SCALAR')
    scene.gltf['materials'].append(gltf_scene.glass('glass', 1.5))
    scene.extensions |= set(scene.gltf['materials'][-1]['extensions'])
    scene.gltf['meshes'].append({'name': 'sphere', 'primitives': [{
        'attributes': {'POSITION': position, 'NORMAL': normal}, 'indices': corners,
        'material': len(scene.gltf['materials']) - 1}]})
    scene.node(name='sphere', mesh=len(scene.gltf['meshes']) - 1, translation=list(CENTRE),
               scale=[RADIUS] * 3)


def staged(add_sphere, add_lights):
    """A sphere over a floor, seen as in scenes/glass_sphere.glb."""
    scene = gltf_scene.Scene()
    add_sphere(scene)
    scene.mesh('floor', square(8.0), gltf_scene.diffuse('floor', 0.8))
    add_lights(scene)
    scene.camera('view', (0.75, 1.35, 1.75), (0.3, 0.22, 0.0), 40)
    return scene


def with_triangles(count):
    return staged(lambda scene: fine_sphere(scene, count), lambda scene: scene.sun((0.5, -1.0, 0.12), 10.0))


def add_lights(scene, count):
    """Suns, spot and point lights by turns, all around above the sphere."""
    for k in range(count):
        turn, height = 2.399963 * k, 0.55 + 0.4 * (k + 0.5) / count  # the golden angle
        flat = math.sqrt(1.0 - height * height)
        away = (flat * math.cos(turn), height, flat * math.sin(turn))
        travel, place = tuple(-v for v in away), tuple(c + 2.0 * v for c, v in zip(CENTRE, away))
        if k % 3 == 0:
            scene.light(travel, name=f'sun {k}', type='directional', intensity=10.0 / count)
        elif k % 3 == 1:
            scene.light(travel, place, name=f'spot {k}', type='spot', intensity=40.0 / count,
                        spot={'innerConeAngle': 0.3, 'outerConeAngle': 0.5})
        else:
            scene.light(travel, place, name=f'point {k}', type='point', intensity=40.0 / count)


def with_lights(count):
    def add_sphere(scene):
        scene.mesh('sphere', icosphere(CENTRE, RADIUS, 5), gltf_scene.glass('glass', 1.5))
    return staged(add_sphere, lambda scene: add_lights(scene, count))


def pixels(size):
    width, height = map(int, size.split('x'))
    return width * height


class Quantity:
    """A size that is varied: what is given to the program, and how much of it there is."""

    def __init__(self, name, unit, sizes, count, options=None, scene=None):
        self.name, self.unit, self.sizes, self.count = name, unit, sizes, count
        self.options = options or (lambda size: [])
        self.scene = scene

    def scene_of(self, size, folder):
        if not self.scene:
            return SAMPLE
        file = folder / f'{self.name}_{size}.glb'
        if not file.exists():
            # By a process of its own: a program's peak counts what the process held that started it.
            maker = multiprocessing.get_context('fork').Process(target=lambda: self.scene(size).write(file))
            maker.start()
            maker.join()
        return file


QUANTITIES = [
    Quantity('grid', 'vertices of the grid', DOUBLED, lambda n: n * n, lambda n: ['--grid', n, '--map', 512]),
    Quantity('map', 'texels of the map', DOUBLED, lambda n: n * n, lambda n: ['--map', n, '--grid', 512]),
    Quantity('triangles', 'triangles', (1000, 10_000, 100_000, 1_000_000, 10_000_000), int,
             scene=with_triangles),
    Quantity('lights', 'lights', (1, 2, 4, 8, 16, 32, 64), int, scene=with_lights),
    Quantity('picture', 'pixels', PICTURES, pixels, lambda size: ['-r', size]),
    Quantity('threads', 'threads', (1, 2), int, lambda n: ['-t', n]),
]


class Bench:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def process(self, *arguments):
        """Processor seconds, wall seconds and peak bytes of one run."""
        start = time.monotonic()
        process = subprocess.Popen([self.program, *map(str, arguments)], stderr=subprocess.PIPE, text=True,
                                   stdout=subprocess.DEVNULL)
        said = process.stderr.read()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            sys.exit(f'{arguments}: {said.strip()}')
        return used.ru_utime + used.ru_stime, time.monotonic() - start, used.ru_maxrss * 1024

    def planned_bytes(self, scene, options):
        done = subprocess.run([self.program, 'plan', scene, '--json', *map(str, options)], check=True,
                              stdout=subprocess.PIPE)
        return json.loads(done.stdout)['memory_bytes']

    def measure(self, quantity, size):
        """A row of growth.csv, and the passes' milliseconds summed by name without light and branch."""
        scene, options = quantity.scene_of(size, self.folder), quantity.options(size)
        if quantity.name != 'threads':
            options = [*options, '-t', 2]
        render = ['render', scene, *options, '-o', self.folder / 'picture.png']
        runs = [self.process(*render)]
        while len(runs) < 3 and runs[0][1] < LONG_RUN:
            runs.append(self.process(*render))
        stats = self.folder / 'stats.json'
        self.process(*render, '--stats', stats)
        passes = {}
        for each in json.loads(stats.read_text())['passes']:
            name = each['pass'].split('[')[0]
            passes[name] = passes.get(name, 0.0) + each['processor_milliseconds']
        processor, wall, peak = (min(run[k] for run in runs) for k in range(3))
        row = {'quantity': quantity.name, 'size': size, 'count': quantity.count(size),
               'processor_s': round(processor, 3), 'wall_s': round(wall, 3),
               'passes_s': round(sum(passes.values()) / 1000, 3), 'peak_mb': round(peak / 1e6, 1),
               'planned_mb': round(self.planned_bytes(scene, options) / 1e6, 1)}
        return row, passes


def slope(first, last, cost):
    if not (first[cost] > 0 and last[cost] > 0):
        return 0.0
    return math.log(last[cost] / first[cost]) / math.log(last['count'] / first['count'])


def steepest(rows, cost):
    return max(slope(a, b, cost) for a, b in zip(rows, rows[1:]))


def told(quantity, rows):
    """A row of the table: both costs of a quantity."""
    if len(rows) < 2:
        return
    first, last = rows[0], rows[-1]
    off = max((abs(row['planned_mb'] / row['peak_mb'] - 1), row['size']) for row in rows)
    print(f'| {quantity.name} {first["size"]} to {last["size"]} | ' + ' | '.join(
        f'{first[cost]:.4g} to {last[cost]:.4g} | '
        f'{slope(rows[-2], last, cost):.2f}, {steepest(rows, cost):.2f}'
        for cost in COSTS) + f' | {100 * off[0]:.0f} % at {off[1]} |', flush=True)


def tell_steep_passes(quantity, passes):
    """Passes of more than 20 ms that grow faster than what they are given by a tenth, which no noise does."""
    for (size_a, a), (size_b, b) in zip(passes, passes[1:]):
        ratio = quantity.count(size_b) / quantity.count(size_a)
        for name in b:
            if ratio > 1 and a.get(name, 0.0) > 20 and b[name] > a[name] * ratio ** 1.1:
                print(f'{quantity.name} {size_a} to {size_b}: {name} {a[name]:.0f} to {b[name]:.0f} ms',
                      file=sys.stderr)


def panel(quantity, rows, left, top, width, height):
    """Both costs over one size, all logarithmic."""
    decades = [math.floor(math.log10(rows[0]['count'])), math.ceil(math.log10(rows[-1]['count'] * 1.01))]
    values = [row[cost] for row in rows for cost in COSTS]
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))

    def place(count, value):
        return (left + width * (math.log10(count) - decades[0]) / (decades[1] - decades[0]),
                top + height * (1 - (math.log10(value) - low) / (high - low)))

    text = [f'<text x="{left}" y="{top - 10}" font-weight="bold">{quantity.unit}</text>']
    for power in range(decades[0], decades[1] + 1):
        x = place(10.0 ** power, 10.0 ** low)[0]
        text += [f'<path d="M{x:.1f} {top}v{height}" stroke="#ddd"/>',
                 f'<text x="{x:.1f}" y="{top + height + 16}" text-anchor="middle">{10 ** power:g}</text>']
    for power in range(low, high + 1):
        y = place(10.0 ** decades[0], 10.0 ** power)[1]
        text += [f'<path d="M{left} {y:.1f}h{width}" stroke="#ddd"/>',
                 f'<text x="{left - 5}" y="{y + 4:.1f}" text-anchor="end">{10.0 ** power:g}</text>']
    for (cost, name), color in zip(COSTS.items(), ('#1f6fb4', '#c8501e')):
        points = [place(row['count'], row[cost]) for row in rows]
        text.append('<path d="M' + 'L'.join(f'{x:.1f} {y:.1f}' for x, y in points) +
                    f'" fill="none" stroke="{color}" stroke-width="2"/>')
        text += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{color}"/>' for x, y in points]
    return text


def plot(results):
    width, height = 300, 220
    columns = 3
    lines = (len(results) + columns - 1) // columns
    size = columns * (width + 70) + 20, lines * (height + 75) + 40
    text = ['<svg xmlns="http://www.w3.org/2000/svg" font-family="sans-serif" font-size="13" '
            f'viewBox="0 0 {size[0]} {size[1]}">',
            f'<rect width="{size[0]}" height="{size[1]}" fill="white"/>']
    for (name, color), x in zip(zip(COSTS.values(), ('#1f6fb4', '#c8501e')), (60, 240)):
        text.append(f'<text x="{x}" y="24" fill="{color}">{name}</text>')
    for i, (quantity, rows) in enumerate(results):
        text += panel(quantity, rows, 60 + i % columns * (width + 70), 70 + i // columns * (height + 75),
                      width, height)
    return '\n'.join(text + ['</svg>', ''])


def write_rows(file, rows):
    with open(file, 'w', newline='', encoding='utf-8') as out:
        writer = csv.DictWriter(out, rows[0].keys(), lineterminator='\n')
        writer.writeheader()
        writer.writerows(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('-o', '--output', type=pathlib.Path, required=True)
    parser.add_argument('--only', action='append', choices=[q.name for q in QUANTITIES])
    parser.add_argument('--most', type=float, default=math.inf, help='no size of a larger count')
    parser.add_argument('--program', default=str(ROOT / 'build/release/caustics'))
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    bench, results, all_rows, all_passes = Bench(options.program, options.output), [], [], []
    print('| | processor s | slope: last, steepest | peak MB | slope: last, steepest | '
          'plan off by at most |\n'
          '|---|---|---|---|---|---|')
    for quantity in QUANTITIES:
        if options.only and quantity.name not in options.only:
            continue
        rows, passes = [], []
        for size in quantity.sizes:
            if quantity.count(size) > options.most:
                continue
            row, times = bench.measure(quantity, size)
            rows.append(row)
            passes.append((size, times))
            print(row, file=sys.stderr, flush=True)
            all_passes += [{'quantity': quantity.name, 'size': size, 'pass': name,
                            'processor_ms': round(ms, 2)} for name, ms in times.items()]
        told(quantity, rows)
        tell_steep_passes(quantity, passes)
        all_rows += rows
        if len(rows) > 1 and quantity.name != 'threads':
            results.append((quantity, rows))
        write_rows(options.output / 'growth.csv', all_rows)
        write_rows(options.output / 'passes.csv', all_passes)
    (options.output / 'growth.svg').write_text(plot(results), encoding='utf-8')


if __name__ == '__main__':
    main()
