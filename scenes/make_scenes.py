#!/usr/bin/env python3
"""Makes the sample scenes: python3 scenes/make_scenes.py [NAME.glb ...]. Needs nothing but Python.

Every scene is a function that returns a Scene; lengths in metres, y up, light in lux.
scenes/README.md has the exact numbers that tests and readers rely on.
"""
import json
import math
import os
import struct
import sys
import zlib

HERE = os.path.dirname(os.path.abspath(__file__))


# ---------------------------------------------------------------- vectors

def add(a, b): return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
def sub(a, b): return (a[0] - b[0], a[1] - b[1], a[2] - b[2])
def mul(a, s): return (a[0] * s, a[1] * s, a[2] * s)
def dot(a, b): return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
def unit(a): return mul(a, 1.0 / math.sqrt(dot(a, a)))


def rotation_to(forward, up=(0.0, 1.0, 0.0)):
    """Quaternion (x, y, z, w) of a node whose -z looks along `forward`."""
    z = mul(unit(forward), -1.0)
    hint = up if abs(dot(z, up)) < 0.999 else (0.0, 0.0, -1.0)
    x = unit(cross(hint, z))
    y = cross(z, x)
    m = ((x[0], y[0], z[0]), (x[1], y[1], z[1]), (x[2], y[2], z[2]))
    trace = m[0][0] + m[1][1] + m[2][2]
    if trace > 0:
        s = 2 * math.sqrt(trace + 1)
        q = ((m[2][1] - m[1][2]) / s, (m[0][2] - m[2][0]) / s, (m[1][0] - m[0][1]) / s, s / 4)
    else:
        i = max(range(3), key=lambda k: m[k][k])
        j, k = (i + 1) % 3, (i + 2) % 3
        s = 2 * math.sqrt(1 + m[i][i] - m[j][j] - m[k][k])
        v = [0.0] * 4
        v[i] = s / 4
        v[j] = (m[j][i] + m[i][j]) / s
        v[k] = (m[k][i] + m[i][k]) / s
        v[3] = (m[k][j] - m[j][k]) / s
        q = tuple(v)
    return [round(c, 9) for c in q]


# ---------------------------------------------------------------- shapes: (positions, normals, indices)

def square(half, y=0.0):
    p = [(-half, y, half), (half, y, half), (half, y, -half), (-half, y, -half)]
    return p, [(0.0, 1.0, 0.0)] * 4, [0, 1, 2, 0, 2, 3]


def icosphere(centre, radius, levels):
    """20 * 4^levels triangles with the sphere's own normals."""
    g = (1 + math.sqrt(5)) / 2
    points = [unit(p) for p in ((-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
                                (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1))]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
             (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5),
             (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(levels):
        middles = {}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                points.append(unit(add(points[a], points[b])))
            return middles[key]

        finer = []
        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return ([add(centre, mul(p, radius)) for p in points], points, [i for f in faces for i in f])


def flat_faces(polygons):
    """A closed body of flat polygons, each counter-clockwise from outside."""
    positions, normals, indices = [], [], []
    for polygon in polygons:
        n = unit(cross(sub(polygon[1], polygon[0]), sub(polygon[2], polygon[0])))
        first = len(positions)
        positions += polygon
        normals += [n] * len(polygon)
        for i in range(2, len(polygon)):
            indices += [first, first + i - 1, first + i]
    return positions, normals, indices


def box(lower, upper):
    (a, b, c), (d, e, f) = lower, upper
    return flat_faces([[(a, e, f), (d, e, f), (d, e, c), (a, e, c)], [(a, b, c), (d, b, c), (d, b, f), (a, b, f)],
                       [(a, b, f), (d, b, f), (d, e, f), (a, e, f)], [(d, b, c), (a, b, c), (a, e, c), (d, e, c)],
                       [(d, b, f), (d, b, c), (d, e, c), (d, e, f)], [(a, b, c), (a, b, f), (a, e, f), (a, e, c)]])


def sheet(half, height, slope, cells):
    """An open surface y = height(x, z) with exact normals; slope(x, z) gives its two derivatives."""
    positions, normals, indices = [], [], []
    for j in range(cells + 1):
        for i in range(cells + 1):
            x, z = -half + 2 * half * i / cells, half - 2 * half * j / cells
            dx, dz = slope(x, z)
            positions.append((x, height(x, z), z))
            normals.append(unit((-dx, 1.0, -dz)))
    for j in range(cells):
        for i in range(cells):
            a = j * (cells + 1) + i
            b, c, d = a + 1, a + cells + 2, a + cells + 1
            indices += [a, b, c, a, c, d]
    return positions, normals, indices


def ring(inner, outer, height, cells):
    """A flat-topped ring around the y axis that stands on y = 0; its walls have the cylinders' normals."""
    positions, normals, indices = [], [], []

    def band(a, b):
        """A strip around the axis between two profiles (radius, y, radial normal, upward normal)."""
        first = len(positions)
        for i in range(cells + 1):
            t = 2 * math.pi * i / cells
            for radius, y, radial, up in (a, b):
                positions.append((radius * math.cos(t), y, radius * math.sin(t)))
                normals.append((radial * math.cos(t), up, radial * math.sin(t)))
        for i in range(cells):
            k = first + 2 * i
            indices.extend((k, k + 1, k + 3, k, k + 3, k + 2))

    band((outer, 0.0, 1.0, 0.0), (outer, height, 1.0, 0.0))
    band((outer, height, 0.0, 1.0), (inner, height, 0.0, 1.0))
    band((inner, height, -1.0, 0.0), (inner, 0.0, -1.0, 0.0))
    band((inner, 0.0, 0.0, -1.0), (outer, 0.0, 0.0, -1.0))
    return positions, normals, indices


def torus(centre, major, minor, axis, cells):
    """A torus around `axis` through `centre`, with its own normals."""
    z = unit(axis)
    x = unit(cross((0.0, 0.0, 1.0) if abs(z[2]) < 0.9 else (0.0, 1.0, 0.0), z))
    y = cross(z, x)
    around, across = 2 * cells, cells
    positions, normals, indices = [], [], []
    for i in range(around):
        a = 2 * math.pi * i / around
        out = add(mul(x, math.cos(a)), mul(y, math.sin(a)))
        for j in range(across):
            b = 2 * math.pi * j / across
            n = add(mul(out, math.cos(b)), mul(z, math.sin(b)))
            positions.append(add(centre, add(mul(out, major), mul(n, minor))))
            normals.append(n)
            p, q = i * across + j, i * across + (j + 1) % across
            r, s = (i + 1) % around * across + j, (i + 1) % around * across + (j + 1) % across
            indices.extend((p, r, s, p, s, q))
    return positions, normals, indices


def upright(x, half, low, high):
    """A rectangle across the x axis."""
    p = [(x, low, half), (x, low, -half), (x, high, -half), (x, high, half)]
    return p, [(1.0, 0.0, 0.0)] * 4, [0, 1, 2, 0, 2, 3]


def surface_of(field, lower, upper, cells):
    """The closed surface field = 0 (negative inside) by surface nets: one vertex a cell that the surface
    crosses, moved onto it; normals from the field's gradient."""
    size = [upper[k] - lower[k] for k in range(3)]
    step = max(size) / cells
    n = [int(math.ceil(size[k] / step)) + 1 for k in range(3)]

    def at(i, j, k): return (lower[0] + i * step, lower[1] + j * step, lower[2] + k * step)

    def gradient(p):
        h = 0.25 * step
        return unit(tuple((field(add(p, d)) - field(sub(p, d)))
                          for d in ((h, 0, 0), (0, h, 0), (0, 0, h))))

    values = [[[field(at(i, j, k)) for k in range(n[2])] for j in range(n[1])] for i in range(n[0])]
    positions, normals, indices, vertex = [], [], [], {}

    def vertex_of(i, j, k):
        if (i, j, k) in vertex:
            return vertex[(i, j, k)]
        crossings = []
        corners = [(a, b, c) for a in (0, 1) for b in (0, 1) for c in (0, 1)]
        for a in corners:
            for axis in range(3):
                if a[axis]:
                    continue
                b = tuple(a[m] + (m == axis) for m in range(3))
                fa = values[i + a[0]][j + a[1]][k + a[2]]
                fb = values[i + b[0]][j + b[1]][k + b[2]]
                if (fa < 0) != (fb < 0):
                    t = fa / (fa - fb)
                    crossings.append(tuple(a[m] + t * (b[m] - a[m]) for m in range(3)))
        p = at(*(x + sum(c[m] for c in crossings) / len(crossings)
                 for m, x in enumerate((i, j, k))))
        for _ in range(3):  # onto the surface
            g = gradient(p)
            p = sub(p, mul(g, field(p)))
        vertex[(i, j, k)] = len(positions)
        positions.append(p)
        normals.append(gradient(p))
        return vertex[(i, j, k)]

    for i in range(n[0] - 1):
        for j in range(n[1] - 1):
            for k in range(n[2] - 1):
                for axis in range(3):
                    here = (i, j, k)
                    there = tuple(here[m] + (m == axis) for m in range(3))
                    a, b = values[i][j][k], values[there[0]][there[1]][there[2]]
                    if (a < 0) == (b < 0):
                        continue
                    u, v = (axis + 1) % 3, (axis + 2) % 3
                    cells_around = []
                    for du, dv in ((0, 0), (-1, 0), (-1, -1), (0, -1)):
                        cell = list(here)
                        cell[u] += du
                        cell[v] += dv
                        cells_around.append(vertex_of(*cell))
                    if a >= 0:
                        cells_around.reverse()
                    q = cells_around
                    indices += [q[0], q[1], q[2], q[0], q[2], q[3]]
    edges = {}
    for t in range(0, len(indices), 3):
        for e in range(3):
            pair = (indices[t + e], indices[t + (e + 1) % 3])
            edges[pair] = edges.get(pair, 0) + 1
    assert all(edges.get((b, a)) == count == 1 for (a, b), count in edges.items()), 'not a closed manifold'
    return positions, normals, indices


# ---------------------------------------------------------------- glTF

def diffuse(name, albedo):
    rgb = albedo if isinstance(albedo, tuple) else (albedo,) * 3
    return {'name': name, 'pbrMetallicRoughness': {'baseColorFactor': [*rgb, 1], 'metallicFactor': 0,
                                                   'roughnessFactor': 1}}


def glass(name, ior, attenuation=None, dispersion=None):
    volume = {'thicknessFactor': 1}
    if attenuation:
        volume['attenuationColor'], volume['attenuationDistance'] = list(attenuation[0]), attenuation[1]
    extensions = {'KHR_materials_transmission': {'transmissionFactor': 1}, 'KHR_materials_ior': {'ior': ior},
                  'KHR_materials_volume': volume}
    if dispersion:
        extensions['KHR_materials_dispersion'] = {'dispersion': dispersion}
    return {'name': name, 'pbrMetallicRoughness': {'metallicFactor': 0, 'roughnessFactor': 0},
            'extensions': extensions}


def metal(name, rgb):
    return {'name': name, 'pbrMetallicRoughness': {'baseColorFactor': [*rgb, 1], 'metallicFactor': 1,
                                                   'roughnessFactor': 0.05}}


def pane(name, rgb):
    return {'name': name, 'doubleSided': True, 'pbrMetallicRoughness': {
        'baseColorFactor': [*rgb, 1], 'metallicFactor': 0, 'roughnessFactor': 0},
        'extensions': {'KHR_materials_transmission': {'transmissionFactor': 1}}}


def textured(material, base=None, normal=None, normal_scale=1.0):
    """The material with textures, given by their indices."""
    material = json.loads(json.dumps(material))
    if base is not None:
        material['pbrMetallicRoughness']['baseColorTexture'] = {'index': base}
    if normal is not None:
        material['normalTexture'] = {'index': normal, 'scale': normal_scale}
    return material


def png(width, height, texel):
    """An RGB image; texel(u, v) gives three numbers in 0..1 at texel centres, v downwards. Stored uncompressed, so
    that the bytes do not depend on the version of zlib."""
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    rows = bytearray()
    for y in range(height):
        rows.append(0)
        for x in range(width):
            rows += bytes(min(255, max(0, round(255 * c))) for c in texel((x + 0.5) / width, (y + 0.5) / height))
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0)) +
            chunk(b'IDAT', zlib.compress(bytes(rows), 0)) + chunk(b'IEND', b''))


class Scene:
    def __init__(self):
        self.gltf = {'asset': {'version': '2.0', 'generator': 'scenes/make_scenes.py'}, 'scene': 0,
                     'scenes': [{'nodes': []}], 'nodes': [], 'meshes': [], 'materials': [], 'accessors': [],
                     'bufferViews': [], 'cameras': []}
        self.binary = bytearray()
        self.extensions = set()

    def node(self, **fields):
        self.gltf['scenes'][0]['nodes'].append(len(self.gltf['nodes']))
        self.gltf['nodes'].append(fields)

    def view(self, data, target):
        while len(self.binary) % 4:
            self.binary.append(0)
        self.gltf['bufferViews'].append({'buffer': 0, 'byteOffset': len(self.binary), 'byteLength': len(data),
                                         **({'target': target} if target else {})})
        self.binary += data
        return len(self.gltf['bufferViews']) - 1

    def accessor(self, **fields):
        self.gltf['accessors'].append(fields)
        return len(self.gltf['accessors']) - 1

    def texture(self, image):
        view = self.view(image, None)
        self.gltf.setdefault('images', []).append({'bufferView': view, 'mimeType': 'image/png'})
        self.gltf.setdefault('textures', []).append({'source': len(self.gltf['images']) - 1})
        return len(self.gltf['textures']) - 1

    def mesh(self, name, shape, material, uvs=None):
        positions, normals, indices = shape
        if material not in self.gltf['materials']:
            self.gltf['materials'].append(material)
            self.extensions |= set(material.get('extensions', {}))
        position = self.view(b''.join(struct.pack('<3f', *p) for p in positions), 34962)
        normal = self.view(b''.join(struct.pack('<3f', *n) for n in normals), 34962)
        small = len(positions) < 65535
        index = self.view(struct.pack('<%d%s' % (len(indices), 'H' if small else 'I'), *indices), 34963)
        stored = [struct.unpack('<3f', struct.pack('<3f', *p)) for p in positions]
        primitive = {
            'attributes': {
                'POSITION': self.accessor(bufferView=position, componentType=5126, count=len(positions),
                                          type='VEC3', min=[min(p[k] for p in stored) for k in range(3)],
                                          max=[max(p[k] for p in stored) for k in range(3)]),
                'NORMAL': self.accessor(bufferView=normal, componentType=5126, count=len(normals), type='VEC3')},
            'indices': self.accessor(bufferView=index, componentType=5123 if small else 5125,
                                     count=len(indices), type='SCALAR'),
            'material': self.gltf['materials'].index(material)}
        if uvs:
            placed = self.view(b''.join(struct.pack('<2f', *uv) for uv in uvs), 34962)
            primitive['attributes']['TEXCOORD_0'] = self.accessor(bufferView=placed, componentType=5126,
                                                                  count=len(uvs), type='VEC2')
        self.gltf['meshes'].append({'name': name, 'primitives': [primitive]})
        self.node(name=name, mesh=len(self.gltf['meshes']) - 1)

    def states(self, shape):
        """What the last mesh stands for exactly (docs/reference.md)."""
        self.gltf['nodes'][-1]['extras'] = {'exact_shape': shape}

    def light(self, travel, place=None, **light):
        self.extensions.add('KHR_lights_punctual')
        lights = self.gltf.setdefault('extensions', {}).setdefault('KHR_lights_punctual', {'lights': []})['lights']
        lights.append(light)
        where = {'translation': list(place)} if place else {}
        self.node(name=light['name'], **where, rotation=rotation_to(travel, (0.0, 0.0, -1.0)),
                  extensions={'KHR_lights_punctual': {'light': len(lights) - 1}})

    def sun(self, travel, lux, **more):
        self.light(travel, name='sun', type='directional', intensity=lux, **more)

    def keyframes(self, node, path, times, values, interpolation='LINEAR'):
        """A channel of the scene's animation for the node of this name; of CUBICSPLINE three values a moment."""
        def stored(rows):
            while len(self.binary) % 4:
                self.binary.append(0)
            data = b''.join(struct.pack('<%df' % len(row), *row) for row in rows)
            self.gltf['bufferViews'].append({'buffer': 0, 'byteOffset': len(self.binary), 'byteLength': len(data)})
            self.binary += data
            return len(self.gltf['bufferViews']) - 1

        animation = self.gltf.setdefault('animations', [{'name': 'moves', 'channels': [], 'samplers': []}])[0]
        moments = self.accessor(bufferView=stored([[t] for t in times]), componentType=5126, count=len(times),
                                type='SCALAR', min=[min(times)], max=[max(times)])
        output = self.accessor(bufferView=stored(values), componentType=5126, count=len(values),
                               type='VEC%d' % len(values[0]))
        animation['samplers'].append({'input': moments, 'output': output, 'interpolation': interpolation})
        number = next(i for i, n in enumerate(self.gltf['nodes']) if n.get('name') == node)
        animation['channels'].append({'sampler': len(animation['samplers']) - 1,
                                      'target': {'node': number, 'path': path}})

    def camera(self, name, eye, target, fov_degrees):
        self.gltf['cameras'].append({'name': name, 'type': 'perspective', 'perspective': {
            'yfov': math.radians(fov_degrees), 'znear': 0.01, 'aspectRatio': 16 / 9}})
        self.node(name=name, camera=len(self.gltf['cameras']) - 1, translation=list(eye),
                  rotation=rotation_to(sub(target, eye)))

    def camera_down(self, name, eye, half):
        self.gltf['cameras'].append({'name': name, 'type': 'orthographic', 'orthographic': {
            'xmag': half, 'ymag': half, 'znear': 0.001, 'zfar': 10}})
        self.node(name=name, camera=len(self.gltf['cameras']) - 1, translation=list(eye),
                  rotation=rotation_to((0.0, -1.0, 0.0), (0.0, 0.0, -1.0)))

    def write(self, file_name):
        while len(self.binary) % 4:
            self.binary.append(0)
        self.gltf['buffers'] = [{'byteLength': len(self.binary)}]
        self.gltf['extensionsUsed'] = sorted(self.extensions)
        text = json.dumps(self.gltf, separators=(',', ':')).encode()
        text += b' ' * (-len(text) % 4)
        with open(os.path.join(HERE, file_name), 'wb') as out:
            out.write(struct.pack('<4sII', b'glTF', 2, 12 + 8 + len(text) + 8 + len(self.binary)))
            out.write(struct.pack('<I4s', len(text), b'JSON') + text)
            out.write(struct.pack('<I4s', len(self.binary), b'BIN\0') + bytes(self.binary))


# ---------------------------------------------------------------- the scenes

FLOOR = diffuse('floor', (0.80, 0.72, 0.62))


def glass_sphere():
    s = Scene()
    s.mesh('sphere', icosphere((0.0, 0.8, 0.0), 0.5, 5), glass('glass', 1.5))
    s.states('sphere')
    s.mesh('floor', square(8.0), FLOOR)
    s.sun((0.0, -1.0, 0.0), 1.0)
    s.camera('view', (1.55, 1.75, 2.35), (0.0, 0.42, 0.0), 38)
    s.camera_down('floor', (0.0, 0.2, 0.0), 1.0)
    return s


def smooth_min(a, b, k):
    h = max(k - abs(a - b), 0.0) / k
    return min(a, b) - h * h * k / 4


def ellipsoid(p, centre, radii):
    q = sub(p, centre)
    a = math.sqrt(sum((q[k] / radii[k]) ** 2 for k in range(3)))
    b = math.sqrt(sum((q[k] / radii[k] ** 2) ** 2 for k in range(3)))
    return a * (a - 1) / b if b > 1e-9 else -min(radii)


def capsule(p, a, b, ra, rb):
    ab, ap = sub(b, a), sub(p, a)
    t = min(1.0, max(0.0, dot(ap, ab) / dot(ab, ab)))
    d = sub(ap, mul(ab, t))
    return math.sqrt(dot(d, d)) - (ra + (rb - ra) * t)


def sitting_cat(p):
    """Signed distance (nearly) of a sitting cat, 1 m tall, facing +x and a little +z."""
    x, y, z = p
    m = (x, y, abs(z))  # two of each leg and ear
    d = ellipsoid(p, (-0.08, 0.30, 0.0), (0.27, 0.29, 0.24))                       # haunches
    d = smooth_min(d, capsule(p, (0.0, 0.40, 0.0), (0.10, 0.62, 0.0), 0.21, 0.145), 0.12)  # chest
    d = smooth_min(d, ellipsoid(p, (0.17, 0.80, 0.0), (0.165, 0.145, 0.16)), 0.07)  # head
    d = smooth_min(d, ellipsoid(p, (0.315, 0.765, 0.0), (0.06, 0.05, 0.07)), 0.05)  # muzzle
    d = smooth_min(d, capsule(m, (0.14, 0.87, 0.08), (0.13, 0.985, 0.115), 0.075, 0.022), 0.05)  # ears
    d = smooth_min(d, capsule(m, (0.14, 0.42, 0.09), (0.21, 0.06, 0.085), 0.075, 0.052), 0.06)  # forelegs
    d = smooth_min(d, ellipsoid(m, (0.25, 0.045, 0.085), (0.075, 0.045, 0.052)), 0.04)  # forepaws
    d = smooth_min(d, ellipsoid(m, (0.02, 0.16, 0.20), (0.19, 0.15, 0.10)), 0.07)   # thighs
    d = smooth_min(d, ellipsoid(m, (0.16, 0.045, 0.215), (0.10, 0.045, 0.055)), 0.05)  # hind paws
    if y > 0.3:
        return d  # far above the tail
    tail, previous = 1e9, None
    for i in range(13):  # an arc around the haunches, thinning towards its tip
        turn = math.radians(195 - 11 * i)
        point = (-0.08 + 0.40 * math.cos(turn), 0.075 - 0.02 * i / 12, 0.08 + 0.40 * math.sin(turn))
        if previous:
            tail = smooth_min(tail, capsule(p, previous, point, 0.07 - 0.0028 * (i - 1), 0.07 - 0.0028 * i), 0.02)
        previous = point
    d = smooth_min(d, tail, 0.06)
    return d


def glass_figure():
    s = Scene()
    shape = surface_of(sitting_cat, (-0.62, -0.08, -0.44), (0.48, 1.10, 0.62), 84)
    lowest = min(p[1] for p in shape[0])
    shape = ([(x, y - lowest + 0.002, z) for x, y, z in shape[0]], shape[1], shape[2])
    s.mesh('cat', shape, glass('amber glass', 1.5, ((0.98, 0.60, 0.16), 0.6)))
    s.mesh('floor', square(8.0), FLOOR)
    s.sun((-0.62, -0.70, 0.38), 10.0)
    s.camera('view', (0.75, 1.25, 2.35), (-0.26, 0.40, 0.08), 33)
    return s


WAVES = ((0.012, (5.1, 1.3), 0.4), (0.009, (-2.7, 6.2), 1.9), (0.007, (8.3, -4.1), 3.3), (0.004, (9.4, 9.9), 0.7))


def water_patch():
    def height(x, z): return 1.0 + sum(a * math.cos(k[0] * x + k[1] * z + p) for a, k, p in WAVES)

    def slope(x, z):
        return tuple(sum(-a * k[i] * math.sin(k[0] * x + k[1] * z + p) for a, k, p in WAVES) for i in (0, 1))

    s = Scene()
    s.mesh('water', sheet(1.0, height, slope, 128), glass('water', 1.33))
    # Cosines are sines a quarter turn ahead.
    s.states({'level': 1.0, 'waves': [{'amplitude': a, 'k': list(k), 'phase': p + math.pi / 2} for a, k, p in WAVES]})
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
    s.mesh('water', sheet(1.0, lambda x, z: depth + a * math.cos(k * x), lambda x, z: (-a * k * math.sin(k * x), 0.0),
                          128), glass('water', 1.33))
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


def equilateral_prism(edge, length, height, travel, incidence):
    """Faces of a prism along z whose left face leans so that light along `travel` meets it at `incidence` degrees."""
    h = edge * math.sqrt(3) / 2
    corners = [(-edge / 2, -h / 3), (edge / 2, -h / 3), (0.0, 2 * h / 3)]
    normal_angle = math.atan2(travel[1], travel[0]) + math.pi - math.radians(incidence)
    turn = normal_angle - math.radians(150)  # the left face's outward normal is at 150 degrees

    def placed(x, y, z):
        c, w = math.cos(turn), math.sin(turn)
        return (c * x - w * y, w * x + c * y + height, z)

    front = [placed(x, y, length / 2) for x, y in corners]
    back = [placed(x, y, -length / 2) for x, y in corners]
    faces = [front, [back[0], back[2], back[1]]]
    for i in range(3):
        j = (i + 1) % 3
        faces.append([front[i], back[i], back[j], front[j]])
    return flat_faces(faces)


def prism():
    """An equilateral prism, edges of 0.3 m along z. Its left face leans so that the light meets it at 50
    degrees; the light is deviated by 38.65 degrees (n = 1.5168) and falls onto the floor."""
    s = Scene()
    travel = unit((math.cos(math.radians(20)), -math.sin(math.radians(20)), 0.0))
    s.mesh('prism', equilateral_prism(0.3, 0.8, 0.55, travel, 50), glass('BK7', 1.5168, dispersion=20 / 64.17))
    s.mesh('floor', square(8.0), FLOOR)
    s.sun(travel, 10.0)
    s.camera('view', (0.2, 1.6, 2.6), (0.35, 0.25, 0.0), 40)
    s.camera_down('floor', (0.5, 0.1, 0.0), 1.0)
    return s


def spectrum():
    """Newton's experiment: a slit of 8 mm, a prism of dense flint at least deviation (59.6 degrees), a spectrum on the floor."""
    s = Scene()
    lean = math.radians(25)
    travel = unit((math.cos(lean), -math.sin(lean), 0.0))
    s.mesh('prism', equilateral_prism(0.2, 0.3, 1.2, travel, 59.8), glass('SF10', 1.7283, dispersion=20 / 28.4))
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
    for name, z, rgb in (('red', -0.5, (0.9, 0.15, 0.1)), ('yellow', 0.0, (0.95, 0.8, 0.2)), ('blue', 0.5, (0.1, 0.3, 0.9))):
        positions, normals, indices = upright(0.0, 0.24, 0.05, 0.9)
        s.mesh(name, ([add(p, (0.0, 0.0, z)) for p in positions], normals, indices), pane(name + ' pane', rgb))
    s.mesh('sill', box((-0.05, 0.0, -0.8), (0.05, 0.05, 0.8)), diffuse('sill', 0.3))
    s.mesh('sphere', icosphere((-0.6, 0.3, 0.9), 0.2, 4), glass('glass', 1.5))
    s.mesh('floor', square(8.0), FLOOR)
    s.sun((1.0, -0.8, 0.1), 10.0)
    s.camera('view', (-1.6, 1.2, 1.9), (0.25, 0.25, 0.0), 42)
    return s


def two_lights():
    """A spot light and a sun through one glass ring: each throws its own caustic and shadow, in its colour."""
    s = Scene()
    s.mesh('ring', torus((0.0, 0.24, 0.0), 0.30, 0.11, (0.18, 1.0, 0.10), 48), glass('glass', 1.5))
    s.mesh('floor', square(8.0), diffuse('white floor', 0.8))
    s.light((0.75, -1.0, 0.10), name='sun', type='directional', intensity=4.0, color=[1.0, 0.60, 0.25])
    lamp = (1.15, 1.55, 0.55)
    s.light(sub((0.0, 0.25, 0.0), lamp), lamp, name='spot', type='spot', intensity=34.0, color=[0.22, 0.55, 1.0],
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
    s.mesh('ramp', flat_faces([[(-0.5, 0.003, -0.6), (-0.5, 0.003, 0.6), (0.12, 0.16, 0.6), (0.12, 0.16, -0.6)]]),
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
RIPPLES = ((0.085, (2, 1), 0.4), (0.075, (-1, 2), 1.9), (0.070, (3, -2), 3.3), (0.050, (2, 4), 0.7), (0.045, (-5, 1), 5.1))


def water_normal_map():
    """A flat sheet of water: its waves are a tile of normals of 1 m, so its caustics tile, too."""
    scale = 0.25  # the texture's slopes are four times the water's: finer steps of its 8 bits

    def normal(u, v):
        turns = [(a, k, math.hypot(*k), math.sin(2 * math.pi * (k[0] * u + k[1] * v) + p)) for a, k, p in RIPPLES]
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
        def srgb(c): return 12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055
        return tuple(srgb(c) for c in color(u, v))

    def hammered(u, v):
        waves = ((3, 5), (-5, 2), (4, -4), (6, 1))
        slope = [sum(0.16 * k[i] / math.hypot(*k) * math.sin(2 * math.pi * (k[0] * u + k[1] * v) + sum(k)) for k in waves)
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


def lens(radius, sphere_radius, segments, rings):
    """A biconvex lens around the y axis and the origin: two caps of spheres, with the spheres' normals."""
    drop = math.sqrt(sphere_radius ** 2 - radius ** 2)
    half_angle = math.asin(radius / sphere_radius)
    positions, normals, indices = [], [], []
    for side in (1.0, -1.0):
        first = len(positions)
        for i in range(rings + 1):
            a = half_angle * i / rings
            for j in range(segments if i else 1):
                b = 2 * math.pi * j / segments
                n = (math.sin(a) * math.cos(b), side * math.cos(a), math.sin(a) * math.sin(b))
                positions.append((sphere_radius * n[0], sphere_radius * n[1] - side * drop, sphere_radius * n[2]))
                normals.append(n)
        for i in range(rings):
            for j in range(segments):
                k = (j + 1) % segments
                a, b = first + 1 + (i - 1) * segments, first + 1 + i * segments
                faces = [(first, b + k, b + j)] if i == 0 else [(a + j, a + k, b + k), (a + j, b + k, b + j)]
                for f in faces:
                    indices += f if side > 0 else f[::-1]
    return positions, normals, indices


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
                [rotation_to(d, (0.0, 0.0, -1.0)) for d in ((0.3, -1.0, 0.0), (-0.3, -1.0, 0.0), (0.3, -1.0, 0.0))])
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
    for name, lower, upper in (('left', (-1.1, 0.0, -1.1), (-1.0, 0.5, 1.1)), ('right', (1.0, 0.0, -1.1), (1.1, 0.5, 1.1)),
                               ('back', (-1.0, 0.0, -1.1), (1.0, 0.5, -1.0)), ('front', (-1.0, 0.0, 1.0), (1.0, 0.5, 1.1))):
        s.mesh(name, box(lower, upper), tiles)
    s.sun((0.22, -1.0, -0.12), 10.0)
    s.camera('view', (0.40, 1.72, 1.08), (0.02, 0.10, -0.20), 41)
    s.camera_down('floor', (0.0, 0.2, 0.0), 1.0)
    return s


def lens_along(centre, axis, radius, curvature, cells):
    """A biconvex lens with an edge that tapers to nothing: two caps of spheres, with the spheres' own normals."""
    z = unit(axis)
    x = unit(cross((0.0, 0.0, 1.0) if abs(z[2]) < 0.9 else (0.0, 1.0, 0.0), z))
    y = cross(z, x)
    depth = curvature - math.sqrt(curvature ** 2 - radius ** 2)  # of one cap
    positions, normals, indices = [], [], []
    for side in (1.0, -1.0):
        middle = add(centre, mul(z, side * (depth - curvature)))
        first = len(positions)
        rings, around = cells, 4 * cells
        for i in range(rings + 1):
            r = radius * i / rings
            for j in range(1 if i == 0 else around):
                turn = 2 * math.pi * j / around
                out = add(mul(x, r * math.cos(turn)), mul(y, r * math.sin(turn)))
                n = unit(add(out, mul(z, side * math.sqrt(curvature ** 2 - r * r))))
                positions.append(add(middle, mul(n, curvature)))
                normals.append(n)

        def at(i, j): return first if i == 0 else first + 1 + (i - 1) * around + j % around

        for i in range(rings):
            for j in range(around):
                a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
                faces = [(a, b, c)] + ([(a, c, d)] if i else [])
                for f in faces:
                    indices += f if side > 0 else (f[0], f[2], f[1])
    return positions, normals, indices


def holed_board(centre, axis, hole, half, thickness, cells):
    """A square board across `axis` with a round hole, its walls included."""
    z = unit(axis)
    x = unit(cross((0.0, 1.0, 0.0), z))
    y = cross(z, x)
    inner, outer = [], []
    for j in range(cells):
        c, w = math.cos(2 * math.pi * j / cells), math.sin(2 * math.pi * j / cells)
        reach = half / max(abs(c), abs(w))
        inner.append((hole * c, hole * w))
        outer.append((reach * c, reach * w))

    def placed(p, side):
        return add(add(centre, add(mul(x, p[0]), mul(y, p[1]))), mul(z, 0.5 * side * thickness))

    faces = []
    for j in range(cells):
        k = (j + 1) % cells
        for side in (1, -1):
            quad = [placed(inner[j], side), placed(outer[j], side), placed(outer[k], side), placed(inner[k], side)]
            faces.append(quad if side > 0 else quad[::-1])
        faces.append([placed(inner[j], 1), placed(inner[k], 1), placed(inner[k], -1), placed(inner[j], -1)])
        faces.append([placed(outer[j], -1), placed(outer[k], -1), placed(outer[k], 1), placed(outer[j], 1)])
    return flat_faces(faces)


def hazy_lens():
    """A lens in the shutter of a dark, hazy room. Parallel light converges 1.096 m behind it (docs/medium.md)."""
    s = Scene()
    travel = unit((1.0, -0.12, 0.0))
    place = (-0.95, 0.68, 0.0)
    s.mesh('lens', lens_along(place, travel, 0.158, 1.137, 16), glass('glass', 1.5168))
    # The lens is wider than the hole before it, and the wall behind has a hole narrower than that and wider than the
    # converging light: neither map's texels see through between them, and no light ends on a rim.
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


def room(lower, upper):
    """The six sides of a room, seen from inside: name and shape."""
    positions, _, _ = box(lower, upper)
    names = ('ceiling', 'floor', 'front wall', 'back wall', 'right wall', 'left wall')
    for i, name in enumerate(names):
        yield name, flat_faces([positions[4 * i:4 * i + 4][::-1]])


def closed_room():
    """A lamp in a closed room, glass and metal on all sides of it: caustics on floor, walls and ceiling."""
    s = Scene()
    for name, shape in room((-2.0, 0.0, -2.0), (2.0, 3.0, 2.0)):
        rgb = {'floor': (0.80, 0.72, 0.62), 'right wall': (0.62, 0.70, 0.80), 'left wall': (0.80, 0.66, 0.60)}
        s.mesh(name, shape, diffuse(name if name in rgb else 'wall', rgb.get(name, 0.75)))
    s.mesh('right sphere', icosphere((1.05, 1.35, 0.2), 0.28, 3), glass('glass', 1.5))
    s.mesh('upper sphere', icosphere((0.05, 2.4, 0.15), 0.22, 3), glass('glass', 1.5))
    s.mesh('left sphere', icosphere((-0.95, 1.55, 0.1), 0.24, 3), glass('amber', 1.5, ((0.98, 0.65, 0.20), 0.4)))
    s.mesh('ring', torus((0.0, 0.8, -0.1), 0.30, 0.11, (0.10, 1.0, 0.06), 28), glass('glass', 1.5))
    s.mesh('slab', box((-0.35, 1.15, -1.15), (0.30, 1.70, -1.0)), glass('glass', 1.5))
    s.mesh('ball', icosphere((0.15, 1.35, 1.0), 0.14, 2), metal('gold', (1.0, 0.78, 0.34)))
    s.light((0.0, -1.0, 0.0), (0.1, 1.45, -0.05), name='lamp', type='point', intensity=20.0)
    s.camera('view', (1.75, 2.35, 1.8), (-0.35, 1.05, -0.5), 64)
    s.camera('other', (-1.75, 0.6, -1.8), (0.35, 1.6, 0.5), 64)
    return s


def main():
    scenes = {'glass_sphere.glb': glass_sphere, 'glass_figure.glb': glass_figure, 'water_patch.glb': water_patch,
              'water_sine.glb': water_sine, 'slab.glb': lambda: slab(1.0), 'slab_glass.glb': lambda: slab(1.5),
              'prism.glb': prism, 'spectrum.glb': spectrum, 'metal_ring.glb': metal_ring,
              'thin_panes.glb': thin_panes, 'two_lights.glb': two_lights, 'receivers.glb': receivers, 'sun_disk.glb': sun_disk,
              'water_normal_map.glb': water_normal_map, 'stained_glass.glb': stained_glass,
              'moving_lens.glb': moving_lens,
              'water_plops.glb': water_plops,
              'hazy_lens.glb': hazy_lens,
              'closed_room.glb': closed_room}
    for name, make in scenes.items():
        if len(sys.argv) > 1 and name not in sys.argv[1:]:
            continue
        scene = make()
        scene.write(name)
        triangles = sum(a['count'] // 3 for a in scene.gltf['accessors']
                        if a['type'] == 'SCALAR' and a['componentType'] != 5126)
        size = os.path.getsize(os.path.join(HERE, name)) // 1024
        print(f'{name:20} {triangles:6} triangles {size:5} KB')


if __name__ == '__main__':
    main()
