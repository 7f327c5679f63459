#!/usr/bin/env python3
"""Makes the fuzzers' seeds: python3 tests/fuzz/make_corpus.py [FOLDER]. Needs nothing but Python; the same bytes every time.

Small files for every feature of the loader, files that it must refuse, and for whole frames the same scenes followed by
the bytes that choose settings (tests/fuzz/tiny_frame.cpp, choice_of). Names say what a file is about. Inputs that fuzzing found
lie beside them under the hash of their content and are left alone.
"""
import base64
import copy
import json
import math
import pathlib
import struct
import sys
import zlib

# ---------------------------------------------------------------- files

FLOAT, UBYTE, USHORT, UINT, BYTE, SHORT = 5126, 5121, 5123, 5125, 5120, 5122
CODES = {FLOAT: 'f', UBYTE: 'B', USHORT: 'H', UINT: 'I', BYTE: 'b', SHORT: 'h'}
WIDTH = {'SCALAR': 1, 'VEC2': 2, 'VEC3': 3, 'VEC4': 4, 'MAT4': 16}


def glb(document, binary=b''):
    text = json.dumps(document, separators=(',', ':')).encode()
    text += b' ' * (-len(text) % 4)
    binary += b'\0' * (-len(binary) % 4)
    chunks = struct.pack('<I4s', len(text), b'JSON') + text
    if binary:
        chunks += struct.pack('<I4s', len(binary), b'BIN\0') + binary
    return b'glTF' + struct.pack('<II', 2, 12 + len(chunks)) + chunks


def png(width, height, texel, kind=2):
    """8-bit PNG; `texel(x, y)` gives the channels of colour type `kind`."""
    def chunk(name, data):
        return struct.pack('>I', len(data)) + name + data + struct.pack('>I', zlib.crc32(name + data))
    rows = b''.join(b'\0' + bytes(c for x in range(width) for c in texel(x, y)) for y in range(height))
    header = struct.pack('>IIBBBBB', width, height, 8, kind, 0, 0, 0)
    return b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', header) + chunk(b'IDAT', zlib.compress(rows, 9)) + chunk(b'IEND', b'')


def jpeg():
    """8 x 8 texels of one grey: baseline, one component, with Huffman tables of one code each."""
    def segment(marker, data):
        return bytes((0xFF, marker)) + struct.pack('>H', len(data) + 2) + data
    quantizer = segment(0xDB, b'\0' + bytes([16] * 64))
    frame = segment(0xC0, struct.pack('>BHHBBBB', 8, 8, 8, 1, 1, 0x11, 0))
    # DC: the code 0 is category 0; AC: the code 0 ends the block.
    dc = segment(0xC4, b'\x00' + bytes([1] + [0] * 15) + b'\x00')
    ac = segment(0xC4, b'\x10' + bytes([1] + [0] * 15) + b'\x00')
    scan = segment(0xDA, bytes((1, 1, 0x00, 0, 63, 0)))
    return b'\xff\xd8' + quantizer + frame + dc + ac + scan + b'\x3f' + b'\xff\xd9'


class File:
    """A glTF document in the making: one buffer, a view for every accessor."""

    def __init__(self):
        self.binary = b''
        self.document = {'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': []}], 'nodes': [], 'meshes': [],
                         'materials': [], 'accessors': [], 'bufferViews': []}

    def view(self, data, **more):
        self.binary += b'\0' * (-len(self.binary) % 4)
        views = self.document['bufferViews']
        views.append({'buffer': 0, 'byteOffset': len(self.binary), 'byteLength': len(data), **more})
        self.binary += data
        return len(views) - 1

    def accessor(self, values, kind='SCALAR', component=FLOAT, **more):
        flat = [c for v in values for c in (v if isinstance(v, (tuple, list)) else (v,))]
        data = struct.pack(f'<{len(flat)}{CODES[component]}', *flat)
        self.document['accessors'].append({'bufferView': self.view(data), 'componentType': component, 'type': kind,
                                           'count': len(flat) // WIDTH[kind], **more})
        return len(self.document['accessors']) - 1

    def list(self, name, value):
        self.document.setdefault(name, []).append(value)
        return len(self.document[name]) - 1

    def material(self, **members):
        return self.list('materials', copy.deepcopy(members))

    def mesh(self, shape, material=None, uvs=None, tangents=None, targets=None, **more):
        positions, normals, indices = shape
        attributes = {'POSITION': self.accessor(positions, 'VEC3')}
        if normals:
            attributes['NORMAL'] = self.accessor(normals, 'VEC3')
        if uvs:
            attributes['TEXCOORD_0'] = self.accessor(uvs, 'VEC2')
        if tangents:
            attributes['TANGENT'] = self.accessor(tangents, 'VEC4')
        primitive = {'attributes': attributes, 'indices': self.accessor(indices, component=USHORT), **more}
        if material is not None:
            primitive['material'] = material
        if targets:
            primitive['targets'] = targets
        return self.list('meshes', {'primitives': [primitive]})

    def node(self, root=True, **members):
        index = self.list('nodes', members)
        if root:
            self.document['scenes'][0]['nodes'].append(index)
        return index

    def light(self, kind, intensity, node, extras=None, **members):
        lights = self.document.setdefault('extensions', {}).setdefault('KHR_lights_punctual', {'lights': []})['lights']
        lights.append({'type': kind, 'intensity': intensity, **members})
        self.node(extensions={'KHR_lights_punctual': {'light': len(lights) - 1}}, **node,
                  **({'extras': extras} if extras else {}))

    def camera(self, y=0.4, half=1.0):
        camera = self.list('cameras', {'type': 'orthographic', 'orthographic': {
            'xmag': half, 'ymag': half, 'znear': 0.01, 'zfar': 10}})
        self.node(camera=camera, translation=[0, y, 0], rotation=DOWN)

    def texture(self, data, mime):
        image = self.list('images', {'bufferView': self.view(data), 'mimeType': mime})
        return {'index': self.list('textures', {'source': image})}

    def bytes(self):
        document = {key: value for key, value in self.document.items() if value != []}
        if self.binary:
            document.setdefault('buffers', [{'byteLength': len(self.binary)}])
        return glb(document, self.binary)

    def text(self):
        document = {key: value for key, value in self.document.items() if value != []}
        uri = 'data:application/octet-stream;base64,' + base64.b64encode(self.binary).decode()
        document['buffers'] = [{'byteLength': len(self.binary), 'uri': uri}]
        return json.dumps(document).encode()


# ---------------------------------------------------------------- shapes: (positions, normals, indices)

HALF = math.sqrt(0.5)
DOWN = [-HALF, 0.0, 0.0, HALF]  # a node whose -z looks down


def square(half, y=0.0):
    return [(-half, y, half), (half, y, half), (half, y, -half), (-half, y, -half)], [(0, 1, 0)] * 4, [0, 1, 2, 0, 2, 3]


def octahedron(radius, y):
    tips = [(radius, y, 0), (-radius, y, 0), (0, y + radius, 0), (0, y - radius, 0), (0, y, radius), (0, y, -radius)]
    normals = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(2, 4, 0), (2, 0, 5), (2, 5, 1), (2, 1, 4), (3, 0, 4), (3, 5, 0), (3, 1, 5), (3, 4, 1)]
    return tips, normals, [i for face in faces for i in face]


def box(half, y):
    positions = [(half * x, y + half * h, half * z) for x in (-1, 1) for h in (-1, 1) for z in (-1, 1)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return positions, None, [i for a, b, c, d in faces for i in (a, b, c, a, c, d)]


UVS = [(0, 0), (1, 0), (1, 1), (0, 1)]
WHITE = {'pbrMetallicRoughness': {'baseColorFactor': [0.8, 0.8, 0.8, 1], 'metallicFactor': 0, 'roughnessFactor': 1}}


def glass(ior=1.5, **volume):
    return {'pbrMetallicRoughness': {'metallicFactor': 0, 'roughnessFactor': 0},
            'extensions': {'KHR_materials_transmission': {'transmissionFactor': 1}, 'KHR_materials_ior': {'ior': ior},
                           'KHR_materials_volume': {'thicknessFactor': 1, **volume}}}


GOLD = {'pbrMetallicRoughness': {'baseColorFactor': [1, 0.8, 0.3, 1], 'metallicFactor': 1, 'roughnessFactor': 0.05}}


def stage(caster=None, shape=None, light=True):
    """A floor, a caster above it, a light from above, a camera that looks down."""
    file = File()
    file.node(mesh=file.mesh(square(2.0), file.material(**WHITE)))
    if caster:
        file.node(mesh=file.mesh(shape or octahedron(0.4, 0.8), file.material(**caster)))
    if light:
        file.light('directional', 10, {'rotation': DOWN})
    file.camera()
    return file


# ---------------------------------------------------------------- scenes that can be rendered

def bare():
    file = File()
    file.node(mesh=file.mesh(octahedron(0.5, 0.0), file.material(**glass())))
    return file


def dispersing():
    material = glass(1.6, attenuationColor=[0.9, 0.5, 0.2], attenuationDistance=0.5)
    material['extensions']['KHR_materials_dispersion'] = {'dispersion': 0.8}
    return stage(material)


def pane():
    return stage({'pbrMetallicRoughness': {'baseColorFactor': [0.2, 0.6, 1, 1], 'metallicFactor': 0, 'roughnessFactor': 0},
                  'doubleSided': True, 'extensions': {'KHR_materials_transmission': {'transmissionFactor': 0.9}}},
                 square(0.5, 0.7))


def sheet():
    return stage(glass(1.33), square(1.0, 0.5))


def water():
    file = stage()
    mesh = file.mesh(square(1.0, 0.5), file.material(**glass(1.33)))
    file.node(name='pool', mesh=mesh, extras={'water': {
        'speed': 0.5, 'damping': 0.4, 'cells': 8, 'start': 1.0,
        'plops': {'interval': 0.4, 'radius': 0.8, 'height': 0.1, 'seed': 7}}})
    return file


def point_inside():
    file = stage(light=False)
    for x, z in ((-0.6, 0.0), (0.6, 0.0), (0.0, 0.6)):
        file.node(mesh=file.mesh(octahedron(0.25, 0.7), file.material(**glass())), translation=[x, 0, z])
    file.light('point', 20, {'translation': [0, 0.7, 0]}, range=10)
    return file


def sized_lights():
    file = stage(glass(), light=False)
    file.light('point', 50, {'translation': [0, 2, 0], 'rotation': DOWN}, extras={'rectangle': [0.3, 0.2]})
    file.light('spot', 50, {'translation': [1, 2, 0], 'rotation': DOWN}, extras={'radius': 0.1},
               spot={'innerConeAngle': 0.2, 'outerConeAngle': 0.6})
    file.light('directional', 5, {'rotation': DOWN}, extras={'angular_diameter': 0.5})
    return file


def shining():
    file = stage(glass(), light=False)
    lamp = {'emissiveFactor': [1, 0.8, 0.6], 'doubleSided': True,
            'extensions': {'KHR_materials_emissive_strength': {'emissiveStrength': 40}}}
    file.node(mesh=file.mesh(square(0.3, 2.0), file.material(**lamp)), rotation=[1, 0, 0, 0], translation=[0, 4, 0])
    return file


def hazy():
    file = stage(glass())
    file.document['scenes'][0]['extras'] = {'medium': {'scattering': [0.2, 0.3, 0.4], 'absorption': 0.05,
                                                       'anisotropy': 0.6}}
    return file


def hazy_beside():
    """Rays along an axis that pass by the haze, and a light with a position."""
    file = stage(glass(), light=False)
    file.light('point', 20, {'translation': [0.5, 2, 0.3]})
    file.document['scenes'][0]['extras'] = {'medium': {'scattering': 0.2}}
    file.document['cameras'][0]['orthographic'].update(xmag=5, ymag=5)
    return file


def textured():
    file = stage(light=False)
    grid = png(4, 4, lambda x, y: (60 * x, 60 * y, 128, 255 if (x + y) % 2 else 40), 6)
    bumps = png(2, 2, lambda x, y: (128 + 40 * x, 128 - 40 * y, 240))
    color, normal, grey = file.texture(grid, 'image/png'), file.texture(bumps, 'image/png'), file.texture(jpeg(), 'image/jpeg')
    material = glass()
    material['pbrMetallicRoughness']['baseColorTexture'] = {**color, 'extensions': {'KHR_texture_transform': {
        'offset': [0.1, 0.2], 'rotation': 0.3, 'scale': [2, -1], 'texCoord': 0}}}
    material['pbrMetallicRoughness']['metallicRoughnessTexture'] = color
    material['normalTexture'] = {**normal, 'scale': 0.5}
    material['extensions']['KHR_materials_transmission']['transmissionTexture'] = grey
    material['emissiveTexture'], material['emissiveFactor'] = grey, [0.1, 0, 0]
    material['alphaMode'], material['alphaCutoff'] = 'MASK', 0.3
    file.document['samplers'] = [{'wrapS': 33071, 'wrapT': 10497}]
    file.document['textures'][0]['sampler'] = 0
    file.node(mesh=file.mesh(square(1.0, 0.5), file.material(**material), uvs=UVS, tangents=[(1, 0, 0, 1)] * 4))
    file.light('directional', 10, {'rotation': DOWN}, color=[1, 0.9, 0.8])
    return file


def moving():
    file = stage()
    node = file.node(mesh=file.mesh(octahedron(0.3, 0.7), file.material(**glass())), name='lens', translation=[0, 0, 0])
    times = file.accessor([0.0, 0.5, 1.0], min=[0], max=[1])
    turn = file.accessor([(0, 0, 0, 1), (0, HALF, 0, HALF), (0, 1, 0, 0)], 'VEC4')
    place = file.accessor([(0, 0, 0), (0.4, 0, 0), (0, 0.2, 0)], 'VEC3')
    size = file.accessor([(0, 0, 0), (1, 1, 1), (0, 0, 0)] * 3, 'VEC3')
    file.document['animations'] = [{'name': 'a', 'samplers': [
        {'input': times, 'output': turn}, {'input': times, 'output': place, 'interpolation': 'STEP'},
        {'input': times, 'output': size, 'interpolation': 'CUBICSPLINE'}], 'channels': [
        {'sampler': 0, 'target': {'node': node, 'path': 'rotation'}},
        {'sampler': 1, 'target': {'node': node, 'path': 'translation'}},
        {'sampler': 2, 'target': {'node': node, 'path': 'scale'}}]}]
    return file


def morphing():
    file = stage()
    shift = file.accessor([(0, 0.1, 0)] * 6, 'VEC3')
    turn = file.accessor([(0, 0, 0.2)] * 6, 'VEC3')
    mesh = file.mesh(octahedron(0.3, 0.7), file.material(**glass()), targets=[{'POSITION': shift, 'NORMAL': turn}, {'POSITION': turn}])
    file.document['meshes'][mesh]['weights'] = [0.2, 0.0]
    node = file.node(mesh=mesh)
    file.document['animations'] = [{'samplers': [
        {'input': file.accessor([0.0, 1.0]), 'output': file.accessor([0, 255, 255, 0], component=UBYTE, normalized=True)}],
        'channels': [{'sampler': 0, 'target': {'node': node, 'path': 'weights'}}]}]
    return file


def skinned():
    file = stage()
    mesh = file.mesh(octahedron(0.3, 0.7), file.material(**glass()))
    attributes = file.document['meshes'][mesh]['primitives'][0]['attributes']
    attributes['JOINTS_0'] = file.accessor([(0, 1, 0, 0)] * 6, 'VEC4', UBYTE)
    attributes['WEIGHTS_0'] = file.accessor([(0.75, 0.25, 0, 0)] * 6, 'VEC4')
    tip = file.node(root=False, translation=[0, 0.2, 0])
    base = file.node(children=[tip])
    still = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    file.document['skins'] = [{'joints': [base, tip], 'skeleton': base,
                               'inverseBindMatrices': file.accessor([still, still], 'MAT4')}]
    file.node(mesh=mesh, skin=0)
    file.document['animations'] = [{'samplers': [{'input': file.accessor([0.0, 1.0]), 'output': file.accessor(
        [(0, 0, 0, 1), (0, 0, HALF, HALF)], 'VEC4')}],
        'channels': [{'sampler': 0, 'target': {'node': tip, 'path': 'rotation'}}]}]
    return file


def instances():
    file = stage()
    mesh = file.mesh(octahedron(0.2, 0.7), file.material(**glass()))
    file.node(mesh=mesh, extensions={'EXT_mesh_gpu_instancing': {'attributes': {
        'TRANSLATION': file.accessor([(0, 0, 0), (0.5, 0, 0)], 'VEC3'),
        'ROTATION': file.accessor([(0, 0, 0, 1), (0, 1, 0, 0)], 'VEC4'),
        'SCALE': file.accessor([(1, 1, 1), (-1, 2, 1)], 'VEC3')}}})
    return file


def quantized():
    file = stage()
    positions, normals, indices = octahedron(1, 0)
    mesh = file.mesh((positions, None, indices), file.material(**glass()))
    attributes = file.document['meshes'][mesh]['primitives'][0]['attributes']
    attributes['POSITION'] = file.accessor([tuple(100 * c for c in p) for p in positions], 'VEC3', SHORT)
    padded = b''.join(struct.pack('<bbbx', *(127 * c for c in n)) for n in normals)
    file.document['accessors'].append({'bufferView': file.view(padded, byteStride=4), 'componentType': BYTE,
                                       'normalized': True, 'type': 'VEC3', 'count': 6})
    attributes['NORMAL'] = len(file.document['accessors']) - 1
    file.node(mesh=mesh, matrix=[0.004, 0, 0, 0, 0, 0.004, 0, 0, 0, 0, 0.004, 0, 0, 0.8, 0, 1])
    file.document['extensionsUsed'] = file.document['extensionsRequired'] = ['KHR_mesh_quantization']
    return file


def sparse():
    file = stage(glass())
    accessor = file.document['accessors'][file.document['meshes'][1]['primitives'][0]['attributes']['POSITION']]
    accessor['sparse'] = {'count': 2, 'indices': {'bufferView': file.view(struct.pack('<BB', 1, 3)), 'componentType': UBYTE},
                          'values': {'bufferView': file.view(struct.pack('<6f', -0.5, 0.8, 0, 0, 0.3, 0))}}
    return file


def sparse_alone():
    file = sparse()
    for accessor in file.document['accessors']:
        if 'sparse' in accessor:
            del accessor['bufferView']
    return file


def shapes():
    file = stage(glass())
    file.document['nodes'][1]['extras'] = {'exact_shape': 'sphere'}
    file.document['nodes'][0]['extras'] = {'exact_shape': {'level': 0, 'waves': [{'amplitude': 0.1, 'k': [3, 1], 'phase': 1}]}}
    file.node(mesh=file.mesh(box(0.2, 0.3), 1), translation=[0.8, 0, 0], extras={'exact_shape': 'cylinder'})
    return file


def strips():
    file = stage()
    for mode in (5, 6, 1, 0):
        mesh = file.mesh(square(0.5, 0.5), file.material(**GOLD), mode=mode)
        file.node(mesh=mesh, scale=[1, 1, -1])
    return file


def joined():
    """A box from two primitives of one material, without normals; a second mesh inside it."""
    file = stage()
    positions, _, indices = box(0.4, 0.8)
    mesh = file.mesh((positions, None, indices[:18]), file.material(**glass()))
    other = file.mesh((positions, None, indices[18:]), 1)
    file.document['meshes'][mesh]['primitives'] += file.document['meshes'].pop(other)['primitives']
    file.node(mesh=mesh)
    file.node(mesh=file.mesh(octahedron(0.1, 0.8), file.material(**glass(1.0))))
    return file


def cube_light():
    file = point_inside()
    file.light('spot', 100, {'translation': [0, 3, 0], 'rotation': DOWN}, spot={'outerConeAngle': 1.5})
    return file


def neighbours():
    """A buffer and an image in files of their own."""
    file = stage(GOLD)
    document = file.document
    document['buffers'] = [{'byteLength': len(file.binary)}, {'byteLength': 64, 'uri': 'side.bin'},
                           {'byteLength': 32, 'uri': 'folder/side.bin'}]
    document['images'] = [{'uri': 'side.png'}, {'uri': 'data:image/png;base64,' + base64.b64encode(
        png(1, 1, lambda x, y: (200, 100, 50))).decode()}]
    document['textures'] = [{'source': 0}, {'source': 1}]
    document['materials'][0]['pbrMetallicRoughness']['baseColorTexture'] = {'index': 0}
    document['materials'][1]['pbrMetallicRoughness']['baseColorTexture'] = {'index': 1, 'texCoord': 0}
    return document, file.binary


def extras_of_everything():
    file = stage(GOLD)
    document = file.document
    document['asset'].update(generator='none', minVersion='2.0', extras=3)
    document['extensionsUsed'] = ['KHR_materials_variants', 'KHR_xmp_json_ld', 'KHR_materials_specular', 'VENDOR_any']
    document['extensionsRequired'] = ['KHR_materials_clearcoat']
    document['scenes'].append({'name': 'second'})
    document['nodes'][1]['extensions'] = {'KHR_node_visibility': {'visible': False}}
    document['materials'][0]['extensions'] = {'KHR_materials_unlit': {}}
    document['materials'][0]['alphaMode'] = 'BLEND'
    file.node(children=[file.node(root=False, mesh=0, scale=[1e-3, 1, 1])], rotation=[0, 0, 0, 0])
    camera = file.list('cameras', {'type': 'perspective', 'perspective': {'yfov': 0.8, 'znear': 0.1, 'aspectRatio': 2}})
    file.node(camera=camera, translation=[0, 1, 3], name='second')
    return file


SCENES = {function.__name__: function for function in (
    bare, dispersing, pane, sheet, water, point_inside, sized_lights, shining, hazy, hazy_beside, textured, moving, morphing, skinned,
    instances, quantized, sparse, sparse_alone, shapes, strips, joined, cube_light, extras_of_everything)}


def mirror():
    return stage(GOLD)


# Names of scenes with eight bytes of settings each.
FRAMES = [
    ('bare', 0, 0, 0, 0, 0, 0, 0), ('mirror', 0, 0, 0, 0, 0, 0, 0), ('mirror', 0x41, 0, 0, 0, 0, 0x20, 0),
    ('dispersing', 0, 0, 0, 0, 0, 0, 0), ('dispersing', 2, 0x10, 8, 0, 0, 0, 0), ('dispersing', 0x20, 0, 12, 0, 0, 0, 0),
    ('pane', 0, 0, 0, 0, 0, 0, 0), ('pane', 0, 0x20, 0, 0, 0, 0, 0), ('sheet', 0, 0x10, 0, 0, 0, 0, 0),
    ('sheet', 0x80, 2, 0, 0, 0, 0, 0), ('water', 0, 0, 0, 0, 0, 0, 0), ('water', 1, 0x10, 0, 0, 0, 0, 128),
    ('point_inside', 0, 0, 0, 0, 0, 0, 0), ('point_inside', 0, 4, 0, 0x3f, 0, 0, 0), ('point_inside', 0, 8, 0, 0, 0, 0, 0),
    ('cube_light', 0, 4, 0, 0x3f, 0, 0, 0), ('cube_light', 8, 4, 0, 0, 0, 1, 0), ('sized_lights', 0, 0, 0, 0, 0, 0, 0),
    ('sized_lights', 4, 0, 0x80, 0x3f, 0, 2, 0), ('shining', 0, 0x40, 0, 0, 0, 0, 0), ('shining', 0, 0, 0, 0, 0, 4, 0),
    ('hazy', 0, 0, 0, 0, 0, 0, 0), ('hazy', 0, 0x10, 0, 0, 0x2c, 0, 0), ('hazy_beside', 0, 0, 0, 0, 0, 0, 0), ('textured', 0, 0, 0, 0, 0, 0, 0),
    ('textured', 1, 0, 0, 0x3f, 0, 0, 0), ('moving', 0, 0, 0, 0, 0, 0, 90), ('morphing', 0, 0, 0, 0, 0, 0, 255),
    ('skinned', 0, 0, 0, 0, 0, 0, 128), ('instances', 0, 0, 0, 0, 0, 0, 0), ('quantized', 0, 0, 0, 0, 0, 0, 0),
    ('joined', 0, 0, 0, 0, 0, 0, 0), ('joined', 3, 1, 0, 0, 0, 0, 0), ('joined', 3, 2, 2, 0, 0, 0, 0),
    ('shapes', 0, 0, 3, 0x0f, 0x40, 0, 0), ('strips', 0, 0, 0, 0, 0, 0x40, 0), ('bare', 3, 0, 0, 0, 0, 0, 0),
    ('bare', 0, 0, 0, 0x55, 0x55, 0x1c, 0), ('bare', 8, 0, 0, 0xaa, 0xaa, 0x0b, 0), ('extras_of_everything', 0, 0, 0, 0, 0, 0, 0)]


# ---------------------------------------------------------------- files that must be refused, or read with a note

def changed(make, change):
    file = make()
    change(file.document)
    return file.bytes()


def setter(*path):
    """A change of the document: the last of `path` is put where the others lead."""
    def change(document):
        for key in path[:-2]:
            document = document[key]
        document[path[-2]] = path[-1]
    return change


def deep(levels):
    file = bare()
    mesh = file.document['nodes'][0]['mesh']
    file.document['nodes'] = [{'children': [i + 1]} for i in range(levels)] + [{'mesh': mesh}]
    return file.bytes()


def png_of(width, height):
    whole = png(1, 1, lambda x, y: (9, 9, 9))
    header = b'IHDR' + struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0)
    return whole[:12] + header + struct.pack('>I', zlib.crc32(header)) + whole[33:]


def with_image(data):
    file = stage(GOLD)
    file.document['materials'][0]['pbrMetallicRoughness']['baseColorTexture'] = file.texture(data, 'image/png')
    return file.bytes()


def malformed():
    whole = bare().bytes()
    size = struct.unpack('<I', whole[12:16])[0]
    accessor, view = ('accessors', 0), ('bufferViews', 0)
    node = ('nodes', 0)
    yield 'empty', b''
    yield 'no_json', b'glTF' + struct.pack('<III4s', 2, 20, 0, b'JSON')
    yield 'cut_short', whole[:len(whole) // 2]
    yield 'cut_header', whole[:11]
    yield 'length_lies', whole[:8] + struct.pack('<I', 0xFFFFFFFF) + whole[12:]
    yield 'chunk_length_lies', whole[:12] + struct.pack('<I', 0xFFFFFFFF) + whole[16:]
    yield 'second_json', whole[:20 + size + 4] + b'JSON' + whole[20 + size + 8:]
    yield 'version_1', whole[:4] + struct.pack('<I', 1) + whole[8:]
    yield 'bytes_behind', whole + b'and more'
    yield 'not_utf8', b'{"asset":{"version":"2.\xff"}}'
    yield 'marked', b'\xef\xbb\xbf' + b'{"asset":{"version":"2.0"}}'
    yield 'nested', b'{"a":' + b'[' * 300
    yield 'wide', b'{"asset":{"version":"2.0"},"extras":[' + b'0,' * 25000 + b'0]}'
    yield 'overflow', b'{"asset":{"version":"2.0"},"scene":1e999}'
    yield 'deep_nodes', deep(40)
    for name, change in {
            'cycle': setter(*node, 'children', [0]), 'twice': setter('scenes', 0, 'nodes', [0, 0]),
            'mesh_index': setter(*node, 'mesh', 2 ** 31), 'mesh_fraction': setter(*node, 'mesh', 0.5),
            'matrix_short': setter(*node, 'matrix', [1, 2]), 'matrix_zero': setter(*node, 'matrix', [0] * 16),
            'scale_huge': setter(*node, 'scale', [1e308, 1e308, 1e308]), 'scale_zero': setter(*node, 'scale', [0, 1, 0]),
            'scale_tiny': setter(*node, 'scale', [1e-38, 1e-38, 1e-38]), 'far': setter(*node, 'translation', [1e11, 0, 0]),
            'count_huge': setter(*accessor, 'count', 2 ** 53), 'count_zero': setter(*accessor, 'count', 0),
            'count_limit': setter(*accessor, 'count', 12000), 'offset_huge': setter(*accessor, 'byteOffset', 2 ** 53 - 8),
            'offset_odd': setter(*accessor, 'byteOffset', 1), 'type_unknown': setter(*accessor, 'type', 'VEC9'),
            'component_unknown': setter(*accessor, 'componentType', 5124), 'normalized_float': setter(*accessor, 'normalized', True),
            'view_huge': setter(*view, 'byteLength', 2 ** 53), 'stride_odd': setter(*view, 'byteStride', 5),
            'stride_small': setter(*view, 'byteStride', 4), 'view_buffer': setter(*view, 'buffer', 3),
            'buffer_remote': setter('buffers', [{'byteLength': 4, 'uri': 'http://example.org/x.bin'}]),
            'draco': setter('extensionsRequired', ['KHR_draco_mesh_compression']),
            'ior_negative': setter('materials', 0, 'extensions', 'KHR_materials_ior', 'ior', -1),
            'ior_text': setter('materials', 0, 'extensions', 'KHR_materials_ior', 'ior', 'glass'),
            'ior_zero': setter('materials', 0, 'extensions', 'KHR_materials_ior', 'ior', 0),
            'extension_list': setter('materials', 0, 'extensions', ['KHR_materials_ior']),
            'name_number': setter('meshes', 0, 'name', 3)}.items():
        yield name, changed(bare, change)
    for name, uri in {'up': '../../etc/hosts', 'up_encoded': '%2e%2e/%2e%2e/etc/hosts', 'absolute': '/dev/zero',
                      'scheme': 'file:///etc/hosts', 'nul': 'side%00.bin', 'folder': 'folder', 'long': 'x' * 5000,
                      'missing': 'nothing.bin', 'backslash': '..\\side.bin', 'base64_broken': 'data:;base64,@@@@',
                      'not_base64': 'data:text/plain,hello', 'itself': 'scene.gltf'}.items():
        document, binary = neighbours()
        document['buffers'][1]['uri'] = uri
        yield 'uri_' + name, glb(document, binary)
    for name, change in {
            'interval': setter('extras', 'water', 'plops', {'interval': 0}), 'cells': setter('extras', 'water', 'cells', 1e9),
            'steps': setter('extras', 'water', 'start', 3600), 'key': setter('extras', 'water', 'waves', 1),
            'speed': setter('extras', 'water', 'speed', 1e38)}.items():
        file = water()
        change(file.document['nodes'][-1])
        yield 'water_' + name, file.bytes()
    file = moving()
    file.document['animations'][0]['channels'].append(file.document['animations'][0]['channels'][0])
    yield 'channel_twice', file.bytes()
    file = moving()
    file.document['animations'][0]['samplers'][0]['input'] = 0
    yield 'times_are_positions', file.bytes()
    file = skinned()
    file.document['skins'][0]['joints'] = [0, 99]
    yield 'joint_missing', file.bytes()
    file = hazy()
    file.document['scenes'][0]['extras']['medium']['anisotropy'] = 1.0
    yield 'medium_forward', file.bytes()
    file = stage(light=False)
    for i in range(20):
        file.light('point', i, {'translation': [i, 1, 0]})
    yield 'lights_many', file.bytes()
    file = bare()
    file.document['accessors'][0]['bufferView'] = file.view(struct.pack('<18f', *[float('nan'), float('inf'), 1e30] * 6))
    yield 'positions_not_finite', file.bytes()
    file = stage(glass(), light=False)
    file.light('spot', -1, {'rotation': [0, 0, 0, 0], 'scale': [0, 0, 0]}, spot={'innerConeAngle': 2, 'outerConeAngle': 1})
    yield 'light_without_direction', file.bytes()


def images():
    grey = png(3, 2, lambda x, y: (80 * x,), 0)
    yield 'rgb.png', png(4, 4, lambda x, y: (60 * x, 60 * y, 128))
    yield 'rgba.png', png(2, 3, lambda x, y: (60 * x, 60 * y, 128, 90), 6)
    yield 'grey.png', grey
    yield 'grey_alpha.png', png(2, 2, lambda x, y: (60 * x, 99 * y), 4)
    yield 'cut.png', grey[:-20]
    yield 'wide.png', png_of(2 ** 31 - 1, 1)
    yield 'large.png', png_of(256, 256)
    yield 'none.png', png_of(0, 4)
    yield 'damaged.png', grey[:45] + b'\x55' + grey[46:]
    yield 'grey.jpg', jpeg()
    yield 'cut.jpg', jpeg()[:-6]
    yield 'scans.jpg', jpeg()[:-2] + b'\xff\xda' * 250 + b'\xff\xd9'
    yield 'large.jpg', jpeg().replace(struct.pack('>BHH', 8, 8, 8), struct.pack('>BHH', 8, 65535, 65535))
    yield 'other.gif', b'GIF89a\1\0\1\0\0\0\0;'
    yield 'other.webp', b'RIFF\x10\0\0\0WEBPVP8 '


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent / 'corpus'
    files = {}
    for name, make in SCENES.items():
        files[f'load/{name}.glb'] = make().bytes()
    files['load/embedded.gltf'] = bare().text()
    files['load/neighbours.glb'] = glb(*neighbours())
    for name, data in malformed():
        files[f'load/bad_{name}.glb'] = data
    for name, data in images():
        files[f'image/{name}'] = data
        if len(data) < 300:
            files[f'load/image_{name}.glb'] = with_image(data)
    makers = {**SCENES, 'mirror': mirror}
    for number, (name, *choice) in enumerate(FRAMES):
        files[f'render/{name}_{number:02}.glb'] = makers[name]().bytes() + bytes(choice + [0] * (8 - len(choice)))
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    print(f'{len(files)} files, {sum(map(len, files.values()))} bytes')


main()
