"""glTF files, PNG and JPEG images, byte by byte."""
import base64
import copy
import json
import math
import struct
import zlib

FLOAT, UBYTE, USHORT, UINT, BYTE, SHORT = 5126, 5121, 5123, 5125, 5120, 5122
CODES = {FLOAT: 'f', UBYTE: 'B', USHORT: 'H', UINT: 'I', BYTE: 'b', SHORT: 'h'}
WIDTH = {'SCALAR': 1, 'VEC2': 2, 'VEC3': 3, 'VEC4': 4, 'MAT4': 16}
HALF = math.sqrt(0.5)
DOWN = [-HALF, 0.0, 0.0, HALF]  # a node whose -z looks down


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
    chunks = chunk(b'IHDR', header) + chunk(b'IDAT', zlib.compress(rows, 9)) + chunk(b'IEND', b'')
    return b'\x89PNG\r\n\x1a\n' + chunks


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
        self.document = {'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': []}], 'nodes': [],
                         'meshes': [],
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
        self.document['accessors'].append({'bufferView': self.view(data), 'componentType': component,
                                           'type': kind,
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
        extensions = self.document.setdefault('extensions', {})
        lights = extensions.setdefault('KHR_lights_punctual', {'lights': []})['lights']
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
