"""Files that must be refused, or read with a note."""
import struct

from making.gltf_file import glb
from making.scenes import bare, hazy, moving, neighbours, skinned, water
from making.stage import GOLD, glass, stage


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


def with_image(data):
    file = stage(GOLD)
    texture = file.texture(data, 'image/png')
    file.document['materials'][0]['pbrMetallicRoughness']['baseColorTexture'] = texture
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
            'scale_huge': setter(*node, 'scale', [1e308, 1e308, 1e308]),
            'scale_zero': setter(*node, 'scale', [0, 1, 0]),
            'scale_tiny': setter(*node, 'scale', [1e-38, 1e-38, 1e-38]),
            'far': setter(*node, 'translation', [1e11, 0, 0]),
            'count_huge': setter(*accessor, 'count', 2 ** 53), 'count_zero': setter(*accessor, 'count', 0),
            'count_limit': setter(*accessor, 'count', 12000),
            'offset_huge': setter(*accessor, 'byteOffset', 2 ** 53 - 8),
            'offset_odd': setter(*accessor, 'byteOffset', 1),
            'type_unknown': setter(*accessor, 'type', 'VEC9'),
            'component_unknown': setter(*accessor, 'componentType', 5124),
            'normalized_float': setter(*accessor, 'normalized', True),
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
    for name, uri in {'up': '../../etc/hosts', 'up_encoded': '%2e%2e/%2e%2e/etc/hosts',
                      'absolute': '/dev/zero',
                      'scheme': 'file:///etc/hosts', 'nul': 'side%00.bin', 'folder': 'folder',
                      'long': 'x' * 5000,
                      'missing': 'nothing.bin', 'backslash': '..\\side.bin',
                      'base64_broken': 'data:;base64,@@@@',
                      'not_base64': 'data:text/plain,hello', 'itself': 'scene.gltf'}.items():
        document, binary = neighbours()
        document['buffers'][1]['uri'] = uri
        yield 'uri_' + name, glb(document, binary)
    for name, change in {
            'interval': setter('extras', 'water', 'plops', {'interval': 0}),
            'cells': setter('extras', 'water', 'cells', 1e9),
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
    file.document['accessors'][0]['bufferView'] = file.view(
        struct.pack('<18f', *[float('nan'), float('inf'), 1e30] * 6))
    yield 'positions_not_finite', file.bytes()
    file = stage(glass(), light=False)
    file.light('spot', -1, {'rotation': [0, 0, 0, 0], 'scale': [0, 0, 0]},
               spot={'innerConeAngle': 2, 'outerConeAngle': 1})
    yield 'light_without_direction', file.bytes()
