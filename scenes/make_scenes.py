#!/usr/bin/env python3
"""Makes the sample scenes: python3 scenes/make_scenes.py [NAME.glb ...]. Needs nothing but Python.

Every scene is a function that returns a Scene; lengths in metres, y up, light in lux.
scenes/README.md has the exact numbers that tests and readers rely on.
"""
import math
import os
import sys

from making.cat import sitting_cat
from making.gltf_scene import FLOOR, Scene, diffuse, glass, metal, pane, png, srgb, textured
from making.real_glass import REAL_GLASS
from making.shapes import (box, equilateral_prism, flat_faces, holed_board, icosphere, lens, lens_along,
                           ring, room, sheet, square, surface_of, torus, upright)
from making.vectors import add, mul, rotation_to, sub, unit

HERE = os.path.dirname(os.path.abspath(__file__))


def sphere_scene(levels, exact, lamp=False):
    s = Scene()
    s.mesh('sphere', icosphere((0.0, 0.8, 0.0), 0.5, levels), glass('glass', 1.5))
    if exact:
        s.states('sphere')
    s.mesh('floor', square(8.0), FLOOR)
    if lamp:
        s.light((0.0, -1.0, 0.0), (0.0, 1.8, 0.0), name='lamp', type='point', intensity=3.0)
    else:
        s.sun((0.0, -1.0, 0.0), 1.0)
    s.camera('view', (1.55, 1.75, 2.35), (0.0, 0.42, 0.0), 38)
    s.camera_down('floor', (0.0, 0.2, 0.0), 1.0)
    return s


def glass_sphere():
    return sphere_scene(5, True)


def glass_sphere_coarse():
    return sphere_scene(3, False)


def glass_sphere_lamp():
    return sphere_scene(3, False, lamp=True)


def figure(cells, material):
    s = Scene()
    shape = surface_of(sitting_cat, (-0.62, -0.08, -0.44), (0.48, 1.10, 0.62), cells)
    lowest = min(p[1] for p in shape[0])
    shape = ([(x, y - lowest + 0.002, z) for x, y, z in shape[0]], shape[1], shape[2])
    s.mesh('cat', shape, material)
    s.mesh('floor', square(8.0), FLOOR)
    s.sun((-0.62, -0.70, 0.38), 10.0)
    s.camera('view', (0.75, 1.25, 2.35), (-0.26, 0.40, 0.08), 33)
    return s


def glass_figure():
    return figure(84, glass('amber glass', 1.5, ((0.98, 0.60, 0.16), 0.6)))


def flint_figure():
    return figure(64, glass('flint', 1.7283, dispersion=20 / 28.4))


WAVES = ((0.012, (5.1, 1.3), 0.4), (0.009, (-2.7, 6.2), 1.9), (0.007, (8.3, -4.1), 3.3),
         (0.004, (9.4, 9.9), 0.7))


def water_patch():
    def height(x, z): return 1.0 + sum(a * math.cos(k[0] * x + k[1] * z + p) for a, k, p in WAVES)

    def slope(x, z):
        return tuple(sum(-a * k[i] * math.sin(k[0] * x + k[1] * z + p) for a, k, p in WAVES) for i in (0, 1))

    s = Scene()
    s.mesh('water', sheet(1.0, height, slope, 128), glass('water', 1.33))
    # Cosines are sines a quarter turn ahead.
    s.states({'level': 1.0, 'waves': [{'amplitude': a, 'k': list(k), 'phase': p + math.pi / 2}
                                      for a, k, p in WAVES]})
    s.mesh('floor', square(8.0), FLOOR)
    s.sun((0.0, -1.0, 0.0), 1.0)
    s.camera('view', (1.6, 2.3, 2.9), (0.0, 0.35, 0.0), 40)
    s.camera_down('floor', (0.0, 0.5, 0.0), 1.0)
    return s


def water_sine():
    # Wave number k, amplitude a with a k = 0.3; depth 0.6 of the first focus n / ((n - 1) a k^2).
    k = 2 * math.pi / 0.5
    a = 0.3 / k
    depth = 0.6 * 1.33 / (0.33 * a * k * k)
    s = Scene()
    waves = sheet(1.0, lambda x, z: depth + a * math.cos(k * x),
                  lambda x, z: (-a * k * math.sin(k * x), 0.0), 128)
    s.mesh('water', waves, glass('water', 1.33))
    s.states({'level': depth, 'waves': [{'amplitude': a, 'k': [k, 0.0], 'phase': math.pi / 2}]})
    s.mesh('floor', square(2.5), FLOOR)
    s.sun((0.0, -1.0, 0.0), 1.0)
    s.camera_down('floor', (0.0, 0.5 * depth, 0.0), 0.5)
    return s


def slab(ior):
    s = Scene()
    s.mesh('slab', box((-0.5, 0.5, -0.5), (0.5, 0.8, 0.5)), glass('glass', ior))
    s.mesh('floor', square(4.0), FLOOR)
    s.sun((math.sin(math.radians(40)), -math.cos(math.radians(40)), 0.0), 1.0)
    s.camera('view', (0.7, 2.2, 3.0), (0.3, 0.25, 0.0), 38)
    s.camera_down('floor', (0.5, 0.4, 0.0), 1.0)
    return s


def prism():
    """An equilateral prism, edges of 0.3 m along z. Its left face leans so that the light meets it at 50
    degrees; the light is deviated by 38.65 degrees (n = 1.5168) and falls onto the floor."""
    s = Scene()
    travel = unit((math.cos(math.radians(20)), -math.sin(math.radians(20)), 0.0))
    s.mesh('prism', equilateral_prism(0.3, 0.8, 0.55, travel, 50),
           glass('BK7', 1.5168, dispersion=20 / 64.17))
    s.mesh('floor', square(8.0), FLOOR)
    s.sun(travel, 10.0)
    s.camera('view', (0.2, 1.6, 2.6), (0.35, 0.25, 0.0), 40)
    s.camera_down('floor', (0.5, 0.1, 0.0), 1.0)
    return s


def spectrum():
    """Newton's experiment: a slit of 8 mm, a prism of dense flint at least deviation (59.6 degrees), a
    spectrum on the floor."""
    s = Scene()
    lean = math.radians(25)
    travel = unit((math.cos(lean), -math.sin(lean), 0.0))
    s.mesh('prism', equilateral_prism(0.2, 0.3, 1.2, travel, 59.8),
           glass('SF10', 1.7283, dispersion=20 / 28.4))
    middle = 1.2 + 1.2 * math.tan(lean) + 0.01
    for name, low, high in (('upper board', middle + 0.0045, 2.6), ('lower board', 0.0, middle - 0.0045)):
        s.mesh(name, box((-1.202, low, -0.9), (-1.2, high, 0.9)), diffuse('board', 0.25))
    s.mesh('floor', square(6.0), diffuse('screen', 0.8))
    s.sun(travel, 60.0)
    s.camera('view', (1.9, 1.7, 1.6), (-0.2, 0.62, 0.0), 42)
    s.camera('close', (0.45, 0.5, 0.45), (0.0, 0.0, 0.0), 32)
    return s


def metal_ring():
    s = Scene()
    s.mesh('ring', ring(0.5, 0.54, 0.18, 256), metal('gold', (1.0, 0.78, 0.34)))
    s.states('cylinder')
    s.mesh('floor', square(8.0), FLOOR)
    s.sun((1.0, -0.8, 0.0), 10.0)
    s.camera('view', (-0.5, 1.3, 1.5), (0.05, 0.0, 0.0), 38)
    s.camera_down('floor', (0.0, 0.6, 0.0), 1.0)
    return s


def thin_panes():
    s = Scene()
    for name, z, rgb in (('red', -0.5, (0.9, 0.15, 0.1)), ('yellow', 0.0, (0.95, 0.8, 0.2)),
                         ('blue', 0.5, (0.1, 0.3, 0.9))):
        positions, normals, indices = upright(0.0, 0.24, 0.05, 0.9)
        s.mesh(name, ([add(p, (0.0, 0.0, z)) for p in positions], normals, indices),
               pane(name + ' pane', rgb))
    s.mesh('sill', box((-0.05, 0.0, -0.8), (0.05, 0.05, 0.8)), diffuse('sill', 0.3))
    s.mesh('sphere', icosphere((-0.6, 0.3, 0.9), 0.2, 4), glass('glass', 1.5))
    s.mesh('floor', square(8.0), FLOOR)
    s.sun((1.0, -0.8, 0.1), 10.0)
    s.camera('view', (-1.6, 1.2, 1.9), (0.25, 0.25, 0.0), 42)
    return s


def two_lights():
    """A spot light and a sun through one glass ring: each throws its own caustic and shadow, in its
    colour."""
    s = Scene()
    s.mesh('ring', torus((0.0, 0.24, 0.0), 0.30, 0.11, (0.18, 1.0, 0.10), 48), glass('glass', 1.5))
    s.mesh('floor', square(8.0), diffuse('white floor', 0.8))
    s.light((0.75, -1.0, 0.10), name='sun', type='directional', intensity=4.0, color=[1.0, 0.60, 0.25])
    lamp = (1.15, 1.55, 0.55)
    s.light(sub((0.0, 0.25, 0.0), lamp), lamp, name='spot', type='spot', intensity=34.0,
            color=[0.22, 0.55, 1.0],
            spot={'innerConeAngle': 0.30, 'outerConeAngle': 0.42})
    s.camera('view', (0.35, 1.45, 2.05), (0.02, 0.08, 0.0), 32)
    s.camera_down('floor', (0.0, 0.1, 0.0), 1.0)
    return s


def receivers():
    """A caustic over receivers that are not plane: the edge of a step, a ball and a ramp."""
    s = Scene()
    s.mesh('sphere', icosphere((0.0, 0.75, 0.0), 0.34, 5), glass('glass', 1.5))
    s.mesh('step', box((0.22, 0.0, -0.75), (1.10, 0.20, 0.02)), diffuse('step', 0.7))
    s.mesh('ball', icosphere((0.40, 0.13, 0.24), 0.13, 4), diffuse('ball', 0.75))
    s.mesh('ramp',
           flat_faces([[(-0.5, 0.003, -0.6), (-0.5, 0.003, 0.6), (0.12, 0.16, 0.6), (0.12, 0.16, -0.6)]]),
           diffuse('ramp', 0.7))
    s.mesh('floor', square(8.0), FLOOR)
    s.sun((0.5, -1.0, 0.12), 10.0)
    s.camera('view', (0.75, 1.35, 1.75), (0.3, 0.22, 0.0), 40)
    s.camera_down('floor', (0.25, 0.38, 0.0), 0.75)
    return s


def sun_disk():
    """A sun of 5 degrees: the shadow of the post softens with the height of what throws it, and the caustic's
    edges are as soft as the way of its light is long."""
    s = Scene()
    s.mesh('sphere', icosphere((0.0, 0.45, 0.0), 0.28, 4), glass('glass', 1.5))
    s.mesh('post', box((-0.62, 0.0, -0.04), (-0.54, 0.9, 0.04)), diffuse('post', 0.5))
    s.mesh('floor', square(8.0), FLOOR)
    s.sun((0.7, -1.0, 0.25), 10.0, extras={'angular_diameter': 5.0})
    s.camera('view', (0.25, 1.5, 2.2), (0.1, 0.22, 0.05), 38)
    s.camera_down('floor', (0.0, 0.1, 0.0), 1.0)
    return s


# Slope amplitude, waves across the tile along x and z, phase.
RIPPLES = ((0.085, (2, 1), 0.4), (0.075, (-1, 2), 1.9), (0.070, (3, -2), 3.3), (0.050, (2, 4), 0.7),
           (0.045, (-5, 1), 5.1))


def water_normal_map():
    """A flat sheet of water: its waves are a tile of normals of 1 m, so its caustics tile, too."""
    scale = 0.25  # the texture's slopes are four times the water's: finer steps of its 8 bits

    def normal(u, v):
        turns = [(a, k, math.hypot(*k), math.sin(2 * math.pi * (k[0] * u + k[1] * v) + p))
                 for a, k, p in RIPPLES]
        slope = [sum(-a * k[i] / length * s for a, k, length, s in turns) / scale for i in (0, 1)]
        n = unit((-slope[0], slope[1], 1.0))  # green leans up in the picture, against v
        return tuple(0.5 * c + 0.5 for c in n)

    s = Scene()
    water = textured(glass('water', 1.33), normal=s.texture(png(96, 96, normal)), normal_scale=scale)
    shape = square(1.0, 1.0)
    s.mesh('water', shape, water, [(p[0] + 1.0, p[2] + 1.0) for p in shape[0]])
    s.mesh('floor', square(8.0), FLOOR)
    s.sun((0.0, -1.0, 0.0), 1.0)
    s.camera('view', (1.6, 2.3, 2.9), (0.0, 0.35, 0.0), 40)
    s.camera_down('floor', (0.0, 0.5, 0.0), 1.0)
    return s


def stained_glass():
    """A window of thick glass, coloured by a texture, leaded and hammered; the sun draws it on the floor."""
    lead = (0.02, 0.02, 0.02)
    petals = ((0.85, 0.12, 0.10), (0.95, 0.62, 0.10), (0.12, 0.30, 0.85))
    outer = ((0.10, 0.55, 0.25), (0.55, 0.15, 0.60))

    def color(u, v):
        x, y = 2 * u - 1, 2 * v - 1
        r, turn = math.hypot(x, y), math.atan2(y, x) / (2 * math.pi) % 1.0
        if max(abs(x), abs(y)) > 0.94 or abs(r - 0.28) < 0.03 or abs(r - 0.86) < 0.03:
            return lead
        if r < 0.28:
            return (1.0, 0.95, 0.70)
        sector = turn * 12
        if abs(sector - round(sector)) * 2 * math.pi * r / 12 < 0.025:
            return lead
        return petals[int(sector) % 3] if r < 0.86 else outer[int(turn * 4) % 2]

    def encoded(u, v):
        return tuple(srgb(c) for c in color(u, v))

    def hammered(u, v):
        waves = ((3, 5), (-5, 2), (4, -4), (6, 1))
        slope = [sum(0.16 * k[i] / math.hypot(*k) * math.sin(2 * math.pi * (k[0] * u + k[1] * v) + sum(k))
                     for k in waves)
                 for i in (0, 1)]
        return tuple(0.5 * c + 0.5 for c in unit((-slope[0], slope[1], 1.0)))

    s = Scene()
    window = textured(glass('stained glass', 1.5), base=s.texture(png(128, 128, encoded)),
                      normal=s.texture(png(64, 64, hammered)), normal_scale=0.06)
    shape = box((-0.02, 0.06, -0.5), (0.02, 1.06, 0.5))
    # The broad faces show the whole picture; the narrow ones take its leaded rim.
    uvs = [(0.5 - p[2], 1.06 - p[1]) if abs(n[0]) > 0.5 else (0.01, 0.01) for p, n in zip(shape[0], shape[1])]
    s.mesh('window', shape, window, uvs)
    s.mesh('sill', box((-0.06, 0.0, -0.56), (0.06, 0.06, 0.56)), diffuse('sill', 0.3))
    s.mesh('floor', square(8.0), diffuse('floor', 0.8))
    s.sun((1.0, -0.85, 0.12), 10.0)
    s.camera('view', (-1.35, 1.35, 2.0), (0.42, 0.30, 0.0), 38)
    s.camera_down('floor', (0.75, 0.03, 0.0), 1.0)
    return s


def moving_lens():
    """A lens that circles once in 4 s above a floor and rocks, under a sun that swings: three ways of
    interpolation, and everything as at the start when they end."""
    s = Scene()
    s.mesh('lens', lens(0.28, 0.50, 64, 10), glass('glass', 1.5))
    s.mesh('floor', square(4.0), FLOOR)
    s.mesh('post', box((-0.03, 0.0, -0.03), (0.03, 0.35, 0.03)), diffuse('post', 0.5))
    s.sun((0.3, -1.0, 0.0), 10.0)
    s.camera('view', (0.35, 1.75, 2.15), (0.0, 0.15, 0.0), 38)
    s.camera_down('floor', (0.0, 0.1, 0.0), 1.0)
    times, circle = [0.0, 1.0, 2.0, 3.0, 4.0], []
    for t in times:  # a spline through four places of the circle, with the circle's own velocity
        c, w = math.cos(math.pi * t / 2), math.sin(math.pi * t / 2)
        velocity = (-0.45 * math.pi / 2 * w, 0.0, 0.45 * math.pi / 2 * c)
        circle += [velocity, (0.45 * c, 0.55, 0.45 * w), velocity]
    s.keyframes('lens', 'translation', times, circle, 'CUBICSPLINE')
    lean = [(0.0, 0.0, math.sin(math.radians(d) / 2), math.cos(math.radians(d) / 2)) for d in (20, -20, 20)]
    s.keyframes('lens', 'rotation', [0.0, 2.0, 4.0], lean)
    s.keyframes('sun', 'rotation', [0.0, 2.0, 4.0],
                [rotation_to(d, (0.0, 0.0, -1.0))
                 for d in ((0.3, -1.0, 0.0), (-0.3, -1.0, 0.0), (0.3, -1.0, 0.0))])
    s.keyframes('post', 'translation', [0.0, 2.0], [(0.0, 0.0, 0.0), (0.0, 0.0, -0.5)], 'STEP')
    return s


def water_plops():
    """A pool of 2 x 2 m, 0.4 m deep, whose water `extras` set in motion: plops at regular intervals."""
    s = Scene()
    s.mesh('water', square(1.0, 0.4), glass('water', 1.33))
    s.gltf['nodes'][-1]['extras'] = {'water': {
        'speed': 0.5, 'damping': 0.15, 'cells': 256, 'start': 5.0,
        'plops': {'interval': 0.2, 'radius': 0.14, 'height': 0.1, 'seed': 8}}}
    tiles = diffuse('tiles', (0.62, 0.80, 0.84))
    s.mesh('floor', square(1.0), tiles)
    for name, lower, upper in (('left', (-1.1, 0.0, -1.1), (-1.0, 0.5, 1.1)),
                               ('right', (1.0, 0.0, -1.1), (1.1, 0.5, 1.1)),
                               ('back', (-1.0, 0.0, -1.1), (1.0, 0.5, -1.0)),
                               ('front', (-1.0, 0.0, 1.0), (1.0, 0.5, 1.1))):
        s.mesh(name, box(lower, upper), tiles)
    s.sun((0.22, -1.0, -0.12), 10.0)
    s.camera('view', (0.40, 1.72, 1.08), (0.02, 0.10, -0.20), 41)
    s.camera_down('floor', (0.0, 0.2, 0.0), 1.0)
    return s


def hazy_lens():
    """A lens in the shutter of a dark, hazy room. Parallel light converges 1.096 m behind it
    (docs/medium.md)."""
    s = Scene()
    travel = unit((1.0, -0.12, 0.0))
    place = (-0.95, 0.68, 0.0)
    s.mesh('lens', lens_along(place, travel, 0.158, 1.137, 16), glass('glass', 1.5168))
    # The lens is wider than the hole before it, and the wall behind has a hole narrower than that and wider
    # than the converging light: neither map's texels see through between them, and no light ends on a rim.
    board = diffuse('black board', 0.10)
    s.mesh('shutter', holed_board(add(place, mul(travel, -0.013)), travel, 0.149, 2.4, 0.02, 64), board)
    s.mesh('wall', holed_board(add(place, mul(travel, 0.05)), travel, 0.146, 2.4, 0.02, 64), board)
    left, right, back, front, high = -1.4, 1.1, -0.8, 2.4, 2.2
    s.mesh('floor', ([(left, 0.0, front), (right, 0.0, front), (right, 0.0, back), (left, 0.0, back)],
                     [(0.0, 1.0, 0.0)] * 4, [0, 1, 2, 0, 2, 3]), diffuse('floor', (0.30, 0.27, 0.25)))
    s.mesh('back wall', ([(left, 0.0, back), (right, 0.0, back), (right, high, back), (left, high, back)],
                         [(0.0, 0.0, 1.0)] * 4, [0, 1, 2, 0, 2, 3]), diffuse('wall', (0.10, 0.11, 0.13)))
    s.mesh('screen', ([(right, 0.0, front), (right, high, front), (right, high, back), (right, 0.0, back)],
                      [(-1.0, 0.0, 0.0)] * 4, [0, 1, 2, 0, 2, 3]), diffuse('screen', 0.6))
    s.sun(travel, 10.0, color=[1.0, 0.86, 0.66])
    s.camera('view', (-0.35, 1.0, 2.05), (0.14, 0.50, 0.0), 42)
    s.gltf['scenes'][0]['extras'] = {'medium': {'scattering': 0.5, 'absorption': 0.02, 'anisotropy': 0.3}}
    return s


def closed_room():
    """A lamp in a closed room, glass and metal on all sides of it: caustics on floor, walls and ceiling."""
    s = Scene()
    for name, shape in room((-2.0, 0.0, -2.0), (2.0, 3.0, 2.0)):
        rgb = {'floor': (0.80, 0.72, 0.62), 'right wall': (0.62, 0.70, 0.80), 'left wall': (0.80, 0.66, 0.60)}
        s.mesh(name, shape, diffuse(name if name in rgb else 'wall', rgb.get(name, 0.75)))
    s.mesh('right sphere', icosphere((1.05, 1.35, 0.2), 0.28, 3), glass('glass', 1.5))
    s.mesh('upper sphere', icosphere((0.05, 2.4, 0.15), 0.22, 3), glass('glass', 1.5))
    s.mesh('left sphere', icosphere((-0.95, 1.55, 0.1), 0.24, 3),
           glass('amber', 1.5, ((0.98, 0.65, 0.20), 0.4)))
    s.mesh('ring', torus((0.0, 0.8, -0.1), 0.30, 0.11, (0.10, 1.0, 0.06), 28), glass('glass', 1.5))
    s.mesh('slab', box((-0.35, 1.15, -1.15), (0.30, 1.70, -1.0)), glass('glass', 1.5))
    s.mesh('ball', icosphere((0.15, 1.35, 1.0), 0.14, 2), metal('gold', (1.0, 0.78, 0.34)))
    s.light((0.0, -1.0, 0.0), (0.1, 1.45, -0.05), name='lamp', type='point', intensity=20.0)
    s.camera('view', (1.75, 2.35, 1.8), (-0.35, 1.05, -0.5), 64)
    s.camera('other', (-1.75, 0.6, -1.8), (0.35, 1.6, 0.5), 64)
    return s


def main():
    scenes = {'slab.glb': lambda: slab(1.0), 'slab_glass.glb': lambda: slab(1.5),
              **{make.__name__ + '.glb': make for make in (
                  glass_sphere, glass_sphere_coarse, glass_sphere_lamp, glass_figure, flint_figure,
                  water_patch, water_sine, prism, spectrum, metal_ring, thin_panes, two_lights, receivers,
                  sun_disk, water_normal_map, stained_glass, moving_lens, water_plops, hazy_lens,
                  closed_room)},
              **{'glass/' + make.__name__ + '.glb': make for make in REAL_GLASS}}
    for name, make in scenes.items():
        if len(sys.argv) > 1 and name not in sys.argv[1:]:
            continue
        scene = make()
        path = os.path.join(HERE, name)
        scene.write(path)
        triangles = sum(a['count'] // 3 for a in scene.gltf['accessors']
                        if a['type'] == 'SCALAR' and a['componentType'] != 5126)
        size = os.path.getsize(path) // 1024
        print(f'{name:34} {triangles:6} triangles {size:5} KB')


if __name__ == '__main__':
    main()
