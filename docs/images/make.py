#!/usr/bin/env python3
"""Makes every picture of the pages again with the built program.

    docs/images/make.py [PROGRAM] [NAME ...]     PROGRAM: build/release/caustics unless given

A picture is one frame of the software device, or several side by side, so its pixels are the same on every
machine: tests/program/docs_pictures_test.py renders a third of them and compares. Each pass has one of its
own, passes/PASS/PASS.png: its attachments in a row, as `render --dump --pictures` colours them."""
import functools
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

HERE = pathlib.Path(__file__).resolve().parent
SCENES = HERE.parents[1] / 'scenes'
sys.path.insert(0, str(HERE.parents[1] / 'tests/program'))
from pictures import Exr  # noqa: E402
GAP = 4  # white pixels between frames side by side
MOST_WIDTH = 800  # of a pass's picture


def floor_views(scene, *variants):
    return [(scene, f'-r 240x240 --camera floor {options}') for options in variants]


PICTURES = {  # name: (frames in a row, [(scene, options), ...])
    'overview': (2, [(scene, '-r 480x270')
                     for scene in ('glass_sphere', 'metal_ring', 'water_plops', 'stained_glass')]),
    'estimators': (4, floor_views('receivers', *(
        f'--preset paper --grid 512 --splat cell --weights physical --estimator {name}'
        for name in ('paper', 'newton', 'impostor')), '--iterations 3')),
    'grids': (4, floor_views('glass_sphere', *(f'--map 256 --splat {splat} --grid {grid}'
                                               for splat in ('point', 'cell') for grid in (64, 128)))),
    'spectrum': (2, [('spectrum', f'-r 400x225 --camera close --exposure 0.5 --grid 256 --wavelengths {n}')
                     for n in (3, 32)]),
    'lights': (2, [('two_lights', '-r 400x225'),
                   ('sun_disk', '-r 400x225 --grid 128 --map 256 -D shadow=512')]),
    'closed_room': (1, [('closed_room', '-r 480x270 --grid 1024 --map 1024')]),
    'materials': (2, [('water_normal_map', '-r 400x225'), ('glass_figure', '-r 400x225')]),
    'real_glass': (2, [(f'glass/{scene}', f'-r 400x225 -D further.share={share}')
                       for scene in ('drinking_glass', 'bottle_of_liquid') for share in (1, 0.05)]),
    'water_plops': (1, [('water_plops', '-r 480x270')]),
    'hazy_lens': (1, [('hazy_lens', '-r 480x270 --exposure 1')]),
}
# With traced light in the last column, which has other bits with another ray tracer: made where named.
TRACED = {
    'real_glass_traced': (3, [(scene, f'{camera} {options}')
                              for scene, camera in (('glass/drinking_glass', 'floor'),
                                                    ('glass/bottle_of_liquid', 'floor'),
                                                    ('glass_figure', 'view'))
                              for options in ('--interfaces 2', '', 'traced')]),
}
# By lab/study/growth.py, of what it measures.
MEASURED = {'growth'}
# By docs/images/inspect_pages.py, in a browser.
BROWSER = {'inspect', 'inspect_path'}

DUMPS = {  # name: (scene, options): small frames that together run every pass
    'sphere': ('glass_sphere', '-r 192x108 --grid 128 --map 128 -D further.share=1'),
    'step': ('receivers', '-r 192x108 --grid 128 --map 128 -D shadow=128 -D further.share=1'),
    'paper': ('receivers', '-r 192x108 --preset paper --estimator impostor --map 128 -D shadow=128'),
    'followed': ('receivers', '-r 192x108 --grid 128 --map 128 -D further.share=0 -D bounces=3 -D splits=0'),
    'tumbler': ('glass/drinking_glass', '-r 192x108 --grid 128 --map 128'),
    'lens': ('hazy_lens', '-r 192x108 --grid 128 --map 128 -D shafts=64 --exposure 1'),
    'panes': ('thin_panes', '-r 192x108 --grid 128 --map 128 -D shadow=128'),
    'pool': ('water_plops', '-r 96x54 --grid 64 --map 64'),
    'smooth': ('receivers', '-r 192x108 --grid 128 --map 128 -D shadow=128 -D samples=4'),
    'hazy_panes': ('thin_panes', '-r 192x108 --grid 128 --map 128 -D shadow=512'),
}
HAZE = {'hazy_panes': {'scattering': 0.25, 'anisotropy': 0.3}}  # added to that scene
PASSES = {  # pass: (dump, the instances shown)
    'ambient_occlusion': ('step', ['ambient_occlusion']),
    'ambient_rays': ('step', ['ambient_rays']),
    'average_samples': ('smooth', ['average_samples.sample 1', 'average_samples.sample 4']),
    'beams': ('lens', ['beams[sun]']),
    'stretches': ('lens', ['stretches[sun]']),
    'caster_exit_map': ('sphere', ['caster_exit_map[sun]']),
    'caster_flux': ('paper', ['caster_flux[sun]']),
    'caster_map': ('sphere', ['caster_map[sun]']),
    'caustic_cells': ('sphere', ['caustic_cells[sun]', 'caustic_cells[sun].cascade']),
    'caustic_footprints': ('tumbler', ['caustic_footprints[sun]']),
    'caustic_map': ('paper', ['caustic_map[sun]']),
    'cells': ('step', ['cells[sun]']),
    'compose': ('sphere', ['compose', 'compose.in_mirrors']),
    'first_hit': ('step', ['first_hit']),
    'haze': ('lens', ['haze']),
    'hidden_ends': ('sphere', ['hidden_ends.in_mirrors']),
    'hidden_landings': ('followed', ['hidden_landings[sun].far']),
    'impostor_map': ('paper', ['impostor_map']),
    'landing': ('step', ['landing[sun]']),
    'light_haze': ('hazy_panes', ['light_haze[sun]']),
    'light_shading': ('step', ['light_shading[sun]']),
    'light_shafts': ('lens', ['light_shafts[sun]']),
    'occluder_depth': ('lens', ['occluder_depth[sun]']),
    'pane_light': ('panes', ['pane_light[sun]']),
    'receiver_map': ('step', ['receiver_map[sun]', 'receiver_map[sun].far']),
    'shadow_bounds': ('hazy_panes', ['shadow_bounds[sun]']),
    'shadow_map': ('step', ['shadow_map[sun]']),
    'tone_map': ('step', ['tone_map']),
    'view_medium': ('lens', ['view_medium']),
    'view_range': ('lens', ['view_range']),
    'view_surfaces': ('step', ['view_surfaces']),
    'walk': ('tumbler', ['walk[sun]']),
    'glass': ('tumbler', ['glass']),
    'water_step': ('pool', ['water_step[water]']),
}


def read_png(data):
    """The rows, as bytes, of an 8-bit RGB file that is not interlaced."""
    width, height, *kind = struct.unpack('>IIBBBBB', data[16:29])
    if kind != [8, 2, 0, 0, 0]:
        raise ValueError(f'not a plain 8-bit RGB picture: {kind}')
    packed, at = b'', 8
    while at < len(data):
        size, name = struct.unpack('>I4s', data[at:at + 8])
        packed += data[at + 8:at + 8 + size] if name == b'IDAT' else b''
        at += size + 12
    raw, stride = zlib.decompress(packed), 3 * width
    rows, above = [], bytes(stride)
    for y in range(height):
        begin = y * (stride + 1)
        above = unfiltered(raw[begin], raw[begin + 1:begin + 1 + stride], above)
        rows.append(above)
    return rows


def predicted(kind, left, above, corner):
    """What a PNG filter expects of a byte, from its three neighbours."""
    if kind == 1:
        return left
    if kind == 2:
        return above
    if kind == 3:
        return (left + above) >> 1
    to_left, to_above = abs(above - corner), abs(left - corner)
    to_corner = abs(left + above - 2 * corner)
    if to_left <= to_above and to_left <= to_corner:
        return left
    return above if to_above <= to_corner else corner


def unfiltered(kind, row, above):
    if kind == 0:
        return bytes(row)
    if kind == 2:
        return bytes((value + up) & 255 for value, up in zip(row, above))
    out = bytearray(3) + row  # three zeros stand before the first pixel
    corners = bytes(3) + above
    for i, value in enumerate(row):
        out[i + 3] = (value + predicted(kind, out[i], above[i], corners[i])) & 255
    return bytes(out[3:])


def filtered(kind, row, above):
    lefts, corners = bytes(3) + row, bytes(3) + above
    return bytes([kind]) + bytes((value - predicted(kind, left, up, corner)) & 255
                                 for value, left, up, corner in zip(row, lefts, above, corners))


def write_png(rows):
    """The bytes of an 8-bit RGB file; each row has the filter that leaves the smallest differences."""
    def chunk(name, data):
        return struct.pack('>I', len(data)) + name + data + struct.pack('>I', zlib.crc32(name + data))

    packed, above = b'', bytes(len(rows[0]))
    for row in rows:
        choices = [b'\0' + row] + [filtered(kind, row, above) for kind in (1, 2, 4)]
        packed += min(choices, key=lambda choice: sum(min(value, 256 - value) for value in choice[1:]))
        above = row
    head = struct.pack('>IIBBBBB', len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) + chunk(b'IDAT', zlib.compress(packed, 9)) +
            chunk(b'IEND', b''))


def illuminance(program, scene, camera, options):
    """Of receivers: white is 1.6 times what the unshadowed light gives."""
    traced = options == ['traced']
    verb, effort = ('reference', ['--rays', '1024', '--batches', '24']) if traced else ('render', options)
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder) / 'light.exr'
        command = [program, verb, SCENES / f'{scene}.glb', '--camera', camera, '-r', '256x256',
                   '--aov', 'direct,caustic', '-o', output, '--quiet', *effort]
        subprocess.run(command, check=True)
        light = Exr(output.read_bytes()).values()
    white = 1.6 * max(light['direct.G'])
    shown = [min(1, (d + c) / white) ** (1 / 2.2) for d, c in zip(light['direct.G'], light['caustic.G'])]
    values = bytes(round(255 * value) for value in shown for _ in 'rgb')
    return [values[768 * row:768 * (row + 1)] for row in range(256)]


@functools.cache
def frame(program, scene, options):
    if not options.startswith('-'):
        return illuminance(program, scene, options.split()[0], options.split()[1:])
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder) / 'frame.png'
        command = [program, 'render', SCENES / f'{scene}.glb', *options.split(), '-o', output, '--quiet']
        subprocess.run(command, check=True)
        return read_png(output.read_bytes())


def with_medium(scene, medium):
    """The bytes of a .glb whose scene has this medium besides."""
    size = struct.unpack('<I', scene[12:16])[0]
    gltf = json.loads(scene[20:20 + size])
    gltf['scenes'][0]['extras'] = {'medium': medium}
    text = json.dumps(gltf).encode()
    text += b' ' * (-len(text) % 4)
    rest = scene[16:20] + text + scene[20 + size:]
    return scene[:8] + struct.pack('<II', 16 + len(rest), len(text)) + rest


@functools.cache
def dump(program, name):
    """[(label of a pass, rows of one of its pictures)], in order."""
    scene, options = DUMPS[name]
    with tempfile.TemporaryDirectory() as folder:
        path = SCENES / f'{scene}.glb'
        if name in HAZE:
            path = pathlib.Path(folder) / path.name
            path.write_bytes(with_medium((SCENES / path.name).read_bytes(), HAZE[name]))
        command = [program, 'render', path, *options.split(), '--quiet',
                   '--dump', folder, '--pictures', '-o', pathlib.Path(folder) / 'frame.png']
        subprocess.run(command, check=True)
        manifest = json.loads((pathlib.Path(folder) / 'manifest.json').read_text())
        shown = {label for each, labels in PASSES.values() if each == name for label in labels}
        return [(attachment['pass'], read_png((pathlib.Path(folder) / drawn['file']).read_bytes()))
                for attachment in manifest['attachments'] if attachment['pass'] in shown
                for drawn in attachment['pictures']]


def small(rows):
    """Of large pictures every n-th texel; tiny ones enlarged."""
    step, times = max(1, len(rows) // 128), max(1, 48 // len(rows))
    wide = [b''.join(row[i:i + 3] * times for i in range(0, len(row), 3 * step)) for row in rows[::step]]
    return [row for row in wide for _ in range(times)]


def in_rows(drawn, columns):
    """Pictures side by side, lower ones filled up below."""
    rows = []
    for first in range(0, len(drawn), columns):
        if first:
            rows += [b'\xff' * len(rows[0])] * GAP
        beside = drawn[first:first + columns]
        most = max(len(each) for each in beside)
        beside = [each + [b'\xff' * len(each[0])] * (most - len(each)) for each in beside]
        rows += [(b'\xff' * 3 * GAP).join(parts) for parts in zip(*beside)]
    widest = max(len(row) for row in rows)
    return [row + b'\xff' * (widest - len(row)) for row in rows]


def picture(program, name):
    """The rows of a picture as the program draws it now."""
    if name in PASSES:
        of, labels = PASSES[name]
        drawn = [small(rows) for label, rows in dump(program, of) if label in labels]
        fit = max(1, MOST_WIDTH // (len(drawn[0][0]) // 3 + GAP))
        rows = -(-len(drawn) // fit)
        return in_rows(drawn, -(-len(drawn) // rows))
    columns, frames = {**PICTURES, **TRACED}[name]
    return in_rows([frame(program, scene, options) for scene, options in frames], columns)


def path_of(name):
    return HERE.parents[1] / f'passes/{name}/{name}.png' if name in PASSES else HERE / f'{name}.png'


def main():
    names = [argument for argument in sys.argv[1:] if argument in {**PICTURES, **TRACED, **PASSES}]
    others = [argument for argument in sys.argv[1:] if argument not in names]
    program = others[0] if others else HERE.parents[1] / 'build/release/caustics'
    for name in names or [*PICTURES, *PASSES]:
        path, rows = path_of(name), picture(program, name)
        if not path.exists() or read_png(path.read_bytes()) != rows:
            path.write_bytes(write_png(rows))
            print(f'{path.name}: made anew, {path.stat().st_size} bytes')


if __name__ == '__main__':
    main()
