"""Reads a binary glTF file: meshes, lights and cameras, placed in the world. Metres, lux, candela.

Only what the sample scenes hold and POV-Ray can be told: float positions and normals, triangles, nodes with
translation, rotation and scale, directional and point lights, orthographic cameras. Everything else is
refused by name: a scene that is half exported would be compared with another scene."""
import json
import math
import struct
from dataclasses import dataclass

COMPONENTS = {5121: 'B', 5123: 'H', 5125: 'I', 5126: 'f'}
SIZES = {'SCALAR': 1, 'VEC2': 2, 'VEC3': 3, 'VEC4': 4}
KNOWN_MATERIAL = {'KHR_materials_transmission', 'KHR_materials_ior', 'KHR_materials_volume'}


class Unsupported(Exception):
    """The scene holds something that this exporter does not hand on."""


@dataclass
class Mesh:
    name: str
    positions: list
    normals: list
    triangles: list
    material: dict

    def box(self):
        return [(min(p[k] for p in self.positions), max(p[k] for p in self.positions)) for k in range(3)]


@dataclass
class Light:
    name: str
    kind: str        # directional or point
    color: tuple     # linear RGB times lux (directional) or candela (point)
    place: tuple
    travel: tuple    # unit vector along which the light goes


@dataclass
class Camera:
    """Orthographic: what it sees is right * [-1, 1] by up * [-1, 1] metres around the axis through
    `place`."""
    place: tuple
    right: tuple
    up: tuple
    forward: tuple


@dataclass
class Scene:
    meshes: list
    lights: list
    cameras: dict


def rotated(q, v):
    x, y, z, w = q
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return (v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
            v[2] + w * t[2] + x * t[1] - y * t[0])


def scaled(v, s):
    return tuple(s * c for c in v)


def unit(v):
    return scaled(v, 1 / math.sqrt(sum(c * c for c in v)))


class File:
    def __init__(self, path):
        data = path.read_bytes()
        if data[:4] != b'glTF' or len(data) < 28:
            raise Unsupported(f'{path}: is no binary glTF file')
        length = struct.unpack('<I', data[12:16])[0]
        self.gltf = json.loads(data[20:20 + length])
        self.binary = data[28 + length:]

    def accessor(self, number):
        """The rows of an accessor: tuples, or numbers of a scalar one."""
        a = self.gltf['accessors'][number]
        if 'sparse' in a or a['componentType'] not in COMPONENTS or a['type'] not in SIZES:
            raise Unsupported('sparse accessors and matrices are not exported')
        view, width = self.gltf['bufferViews'][a['bufferView']], SIZES[a['type']]
        layout = struct.Struct('<%d%s' % (width, COMPONENTS[a['componentType']]))
        start = view.get('byteOffset', 0) + a.get('byteOffset', 0)
        stride = view.get('byteStride', layout.size)
        rows = [layout.unpack_from(self.binary, start + i * stride) for i in range(a['count'])]
        return rows if width > 1 else [row[0] for row in rows]


def checked_material(material):
    unknown = set(material.get('extensions', {})) - KNOWN_MATERIAL
    keys = (*material, *material.get('pbrMetallicRoughness', {}))
    textures = [key for key in keys if key.endswith('Texture')]
    if unknown or textures or material.get('alphaMode', 'OPAQUE') != 'OPAQUE':
        what = ', '.join([*sorted(unknown), *textures]) or 'alpha'
        raise Unsupported(f"material '{material.get('name', '')}': {what} is not exported")
    return material


def mesh_of(file, node, place, turn, size):
    mesh = file.gltf['meshes'][node['mesh']]
    if len(mesh['primitives']) != 1:
        raise Unsupported(f"mesh '{mesh.get('name', '')}': of more than one primitive is not exported")
    primitive = mesh['primitives'][0]
    if primitive.get('mode', 4) != 4 or 'NORMAL' not in primitive['attributes'] or 'indices' not in primitive:
        raise Unsupported(f"mesh '{mesh.get('name', '')}': only indexed triangles with normals are exported")
    positions = [tuple(c + d for c, d in zip(rotated(turn, [s * x for s, x in zip(size, p)]), place))
                 for p in file.accessor(primitive['attributes']['POSITION'])]
    normals = [unit(rotated(turn, [x / s for s, x in zip(size, n)]))
               for n in file.accessor(primitive['attributes']['NORMAL'])]
    flat = file.accessor(primitive['indices'])
    material = checked_material(file.gltf['materials'][primitive['material']])
    return Mesh(node.get('name', mesh.get('name', '')), positions, normals,
                [tuple(flat[i:i + 3]) for i in range(0, len(flat), 3)], material)


def light_of(file, node, place, turn):
    number = node['extensions']['KHR_lights_punctual']['light']
    light = file.gltf['extensions']['KHR_lights_punctual']['lights'][number]
    if light['type'] not in ('directional', 'point') or 'range' in light or light.get('extras'):
        raise Unsupported(f"light '{light.get('name', '')}': only directional and point lights without a "
                          f"size are"
                          ' exported')
    color = scaled(light.get('color', (1, 1, 1)), light.get('intensity', 1))
    return Light(light.get('name', 'light'), light['type'], color, tuple(place), rotated(turn, (0, 0, -1)))


def read(path):
    """The scene in a file; Unsupported, with one line that names it, where that cannot be."""
    try:
        return scene_of(File(path), path)
    except (KeyError, IndexError, TypeError, ValueError, struct.error) as error:
        raise Unsupported(f'{path}: cannot be read: {type(error).__name__} {error}') from error


def scene_of(file, path):
    if 'animations' in file.gltf or 'skins' in file.gltf:
        raise Unsupported(f'{path}: moves, which is not exported')
    scene = Scene([], [], {})
    for number in file.gltf['scenes'][file.gltf.get('scene', 0)]['nodes']:
        node = file.gltf['nodes'][number]
        # The mesh is what both programs render, whatever exact shape it stands for.
        extras = set(node.get('extras', {})) - {'exact_shape'}
        if 'children' in node or 'matrix' in node or extras:
            raise Unsupported(
                f"node '{node.get('name', '')}': children, matrices and extras are not exported")
        place, turn = node.get('translation', (0, 0, 0)), node.get('rotation', (0, 0, 0, 1))
        if 'mesh' in node:
            scene.meshes.append(mesh_of(file, node, place, turn, node.get('scale', (1, 1, 1))))
        if 'KHR_lights_punctual' in node.get('extensions', {}):
            scene.lights.append(light_of(file, node, place, turn))
        if 'camera' in node and file.gltf['cameras'][node['camera']]['type'] == 'orthographic':
            lens = file.gltf['cameras'][node['camera']]['orthographic']
            scene.cameras[node.get('name', '')] = Camera(
                tuple(place), scaled(rotated(turn, (1, 0, 0)), lens['xmag']),
                scaled(rotated(turn, (0, 1, 0)), lens['ymag']), rotated(turn, (0, 0, -1)))
    return scene
