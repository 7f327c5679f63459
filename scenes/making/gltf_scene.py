"""Materials, images and scenes as binary glTF 2.0."""
import json
import math
import struct
import zlib

from making.vectors import rotation_to, sub


def diffuse(name, albedo):
    rgb = albedo if isinstance(albedo, tuple) else (albedo,) * 3
    return {'name': name, 'pbrMetallicRoughness': {'baseColorFactor': [*rgb, 1], 'metallicFactor': 0,
                                                   'roughnessFactor': 1}}


FLOOR = diffuse('floor', (0.80, 0.72, 0.62))


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


def srgb(c):
    return 12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055


def png(width, height, texel):
    """An image; texel(u, v) gives three numbers in 0..1, or four with opacity, at texel centres, v downwards.
    Stored uncompressed, so that the bytes do not depend on the version of zlib."""
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    rows = bytearray()
    for y in range(height):
        rows.append(0)
        for x in range(width):
            rows += bytes(min(255, max(0, round(255 * c)))
                          for c in texel((x + 0.5) / width, (y + 0.5) / height))
    kind = {3: 2, 4: 6}[len(texel(0.5, 0.5))]
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, kind, 0, 0, 0)) +
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
                'NORMAL': self.accessor(bufferView=normal, componentType=5126, count=len(normals),
                                        type='VEC3')},
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
        extensions = self.gltf.setdefault('extensions', {})
        lights = extensions.setdefault('KHR_lights_punctual', {'lights': []})['lights']
        lights.append(light)
        where = {'translation': list(place)} if place else {}
        self.node(name=light['name'], **where, rotation=rotation_to(travel, (0.0, 0.0, -1.0)),
                  extensions={'KHR_lights_punctual': {'light': len(lights) - 1}})

    def sun(self, travel, lux, **more):
        self.light(travel, name='sun', type='directional', intensity=lux, **more)

    def keyframes(self, node, path, times, values, interpolation='LINEAR'):
        """A channel of the scene's animation for the node of this name; of CUBICSPLINE three values a
        moment."""
        def stored(rows):
            while len(self.binary) % 4:
                self.binary.append(0)
            data = b''.join(struct.pack('<%df' % len(row), *row) for row in rows)
            self.gltf['bufferViews'].append({'buffer': 0, 'byteOffset': len(self.binary),
                                             'byteLength': len(data)})
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

    def write(self, path):
        while len(self.binary) % 4:
            self.binary.append(0)
        self.gltf['buffers'] = [{'byteLength': len(self.binary)}]
        self.gltf['extensionsUsed'] = sorted(self.extensions)
        text = json.dumps(self.gltf, separators=(',', ':')).encode()
        text += b' ' * (-len(text) % 4)
        with open(path, 'wb') as out:
            out.write(struct.pack('<4sII', b'glTF', 2, 12 + 8 + len(text) + 8 + len(self.binary)))
            out.write(struct.pack('<I4s', len(text), b'JSON') + text)
            out.write(struct.pack('<I4s', len(self.binary), b'BIN\0') + bytes(self.binary))
