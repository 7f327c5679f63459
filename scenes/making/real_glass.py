"""Real glass over a floor, for which two surfaces are not enough: the scenes of the folder glass."""
import json
import math

from making.glassware import bottle, bowl, tumbler, wine_glass
from making.gltf_scene import FLOOR, Scene, glass, metal, png, srgb, textured
from making.revolved import revolved, wound
from making.shapes import icosphere, ring, square
from making.vectors import mul, unit


def real_glass(*bodies, sun=(-1.0, -1.0, 0.0), view=1.0):
    """Glass over a floor, for which two surfaces are not enough: (name, shape, material) each, and texture
    coordinates where the material, made for the scene, has textures."""
    s = Scene()
    for name, shape, material, *uvs in bodies:
        s.mesh(name, shape, material(s) if callable(material) else material, *uvs)
    s.mesh('floor', square(8.0), FLOOR)
    s.sun(sun, 10.0)
    s.camera('view', (1.5, 1.45, 2.2), (-0.25, 0.28, 0.0), 38)
    s.camera_down('floor', (0.0, 0.01, 0.0), view)
    return s


GLASS = glass('glass', 1.5)


def steep(degrees):
    """Sunlight that far from the vertical."""
    return (-math.sin(math.radians(degrees)), -math.cos(math.radians(degrees)), 0.0)


def drinking_glass():
    return real_glass(('glass', revolved(tumbler(0.02), 96), GLASS), sun=steep(45))


def drinking_glass_high_sun():
    return real_glass(('glass', revolved(tumbler(0.02), 96), GLASS), sun=steep(20))


def glass_of_wine():
    return real_glass(('glass', revolved(wine_glass(0.02), 96), GLASS), sun=steep(45), view=1.4)


def bottle_of_liquid():
    glassy, liquid = bottle(0.02)
    return real_glass(('bottle', revolved(glassy, 96), glass('green glass', 1.52, ((0.45, 0.80, 0.50), 0.1))),
                      ('liquid', revolved(liquid, 96), glass('liquid', 1.33)), sun=steep(45), view=1.4)


def hollow_ball():
    shell = icosphere((0.0, 0.55, 0.0), 0.45, 4)
    p, n, i = icosphere((0.0, 0.55, 0.0), 0.38, 4)
    first = len(shell[0])
    inside = [first + i[k + o] for k in range(0, len(i), 3) for o in (0, 2, 1)]
    inward = [mul(v, -1.0) for v in n]
    return real_glass(('shell', (shell[0] + p, shell[1] + inward, shell[2] + inside), GLASS), sun=steep(20))


def bubbles():
    """Gas in glass: indices below 1 are relative to what is around."""
    return real_glass(('ball', icosphere((0.0, 0.55, 0.0), 0.45, 4), GLASS),
                      ('bubble', icosphere((0.12, 0.62, 0.05), 0.12, 4), glass('gas', 1.0 / 1.5)),
                      ('small bubble', icosphere((-0.15, 0.45, -0.08), 0.07, 4), glass('gas', 1.0 / 1.5)),
                      sun=steep(20))


def two_balls():
    return real_glass(('upper ball', icosphere((0.25, 0.95, 0.0), 0.28, 4), GLASS),
                      ('lower ball', icosphere((0.0, 0.35, 0.1), 0.30, 4), GLASS), sun=steep(20))


def glass_bowl():
    return real_glass(('bowl', revolved(bowl(0.02), 96), GLASS), sun=steep(30))


def moved(shape, x, z):
    p, n, i = shape
    return [(v[0] + x, v[1], v[2] + z) for v in p], n, i


def three_glasses():
    """The light of each goes through the others."""
    glasses = [moved(revolved(tumbler(0.02, radius=0.2, height=0.5), 96), x, z)
               for x, z in ((0.35, -0.1), (-0.15, 0.15), (-0.3, -0.45))]
    return real_glass(*((f'glass {k + 1}', glass, GLASS) for k, glass in enumerate(glasses)), sun=steep(50),
                      view=1.4)


def glass_on_floor():
    """Its foot and the floor are one plane."""
    return real_glass(('glass', revolved(tumbler(0.0), 96), GLASS), sun=steep(30))


def frosted_tumbler():
    frosted = json.loads(json.dumps(GLASS))
    frosted['name'] = 'frosted glass'
    frosted['pbrMetallicRoughness']['roughnessFactor'] = 0.3
    return real_glass(('glass', revolved(tumbler(0.02), 96), frosted), sun=steep(45))


def stained_tumbler():
    """Bands of colour, and waves that a normal texture puts on all surfaces."""
    bands = ((0.90, 0.25, 0.15), (0.95, 0.80, 0.30), (0.20, 0.45, 0.90))

    def color(u, v):
        return tuple(srgb(c) for c in bands[int(3 * v) % 3])

    def wavy(u, v):
        slope = [0.35 * math.sin(2 * math.pi * (12 * u)), 0.25 * math.sin(2 * math.pi * 6 * v)]
        return tuple(0.5 * c + 0.5 for c in unit((-slope[0], slope[1], 1.0)))

    def stained(s):
        return textured(glass('stained', 1.5), base=s.texture(png(32, 96, color)),
                        normal=s.texture(png(256, 128, wavy)), normal_scale=0.2)

    return real_glass(('glass', revolved(tumbler(0.02), 96), stained, wound(tumbler(0.02), 96, 0.77, 0.75)),
                      sun=steep(45))


def pierced_ball():
    """A shell of silver that an alpha mask has cut holes into: light enters and is mirrored inside."""
    ball = icosphere((0.0, 0.55, 0.0), 0.45, 4)

    def holes(u, v):
        open_here = abs((6 * u) % 1.0 - 0.5) < 0.3 and abs((4 * v) % 1.0 - 0.5) < 0.3
        return (1.0, 1.0, 1.0, 0.0 if open_here else 1.0)

    def silver(s):
        pierced = textured(metal('pierced silver', (0.97, 0.96, 0.91)), base=s.texture(png(192, 128, holes)))
        return {**pierced, 'alphaMode': 'MASK', 'doubleSided': True}

    uvs = [(0.5 + p[0] / 0.9, (p[1] - 0.1) / 0.9) for p in ball[0]]
    return real_glass(('ball', ball, silver, uvs), sun=steep(30))


def deep_ring():
    """A mirror that sees itself."""
    return real_glass(('ring', ring(0.4, 0.44, 0.7, 256), metal('silver', (0.97, 0.96, 0.91))), sun=steep(60))


REAL_GLASS = (drinking_glass, drinking_glass_high_sun, glass_of_wine, bottle_of_liquid, hollow_ball, bubbles,
              two_balls, glass_bowl, three_glasses, glass_on_floor, deep_ring, frosted_tumbler,
              stained_tumbler, pierced_ball)
