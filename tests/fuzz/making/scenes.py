"""Scenes that can be loaded and rendered, one for each feature of the loader."""
import base64
import struct

from making.gltf_file import BYTE, DOWN, HALF, SHORT, UBYTE, File, jpeg, png
from making.stage import GOLD, UVS, box, glass, octahedron, square, stage


def bare():
    file = File()
    file.node(mesh=file.mesh(octahedron(0.5, 0.0), file.material(**glass())))
    return file


def dispersing():
    material = glass(1.6, attenuationColor=[0.9, 0.5, 0.2], attenuationDistance=0.5)
    material['extensions']['KHR_materials_dispersion'] = {'dispersion': 0.8}
    return stage(material)


def pane():
    return stage({'pbrMetallicRoughness': {'baseColorFactor': [0.2, 0.6, 1, 1], 'metallicFactor': 0,
                                           'roughnessFactor': 0},
                  'doubleSided': True,
                  'extensions': {'KHR_materials_transmission': {'transmissionFactor': 0.9}}},
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
    file.node(mesh=file.mesh(square(0.3, 2.0), file.material(**lamp)), rotation=[1, 0, 0, 0],
              translation=[0, 4, 0])
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
    color, normal = file.texture(grid, 'image/png'), file.texture(bumps, 'image/png')
    grey = file.texture(jpeg(), 'image/jpeg')
    material = glass()
    material['pbrMetallicRoughness']['baseColorTexture'] = {**color, 'extensions': {'KHR_texture_transform': {
        'offset': [0.1, 0.2], 'rotation': 0.3, 'scale': [2, -1], 'texCoord': 0}}}
    material['pbrMetallicRoughness']['metallicRoughnessTexture'] = color
    material['normalTexture'] = {**normal, 'scale': 0.5}
    material['extensions']['KHR_materials_transmission']['transmissionTexture'] = grey
    material['emissiveTexture'], material['emissiveFactor'] = grey, [0.1, 0, 0]
    material['alphaMode'], material['alphaCutoff'] = 'MASK', 0.3
    file.document['samplers'] = [{'wrapS': 33071, 'wrapT': 33648}]
    file.document['textures'][0]['sampler'] = 0
    file.node(mesh=file.mesh(square(1.0, 0.5), file.material(**material), uvs=UVS,
                             tangents=[(1, 0, 0, 1)] * 4))
    file.light('directional', 10, {'rotation': DOWN}, color=[1, 0.9, 0.8])
    return file


def moving():
    file = stage()
    node = file.node(mesh=file.mesh(octahedron(0.3, 0.7), file.material(**glass())), name='lens',
                     translation=[0, 0, 0])
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
    mesh = file.mesh(octahedron(0.3, 0.7), file.material(**glass()),
                     targets=[{'POSITION': shift, 'NORMAL': turn}, {'POSITION': turn}])
    file.document['meshes'][mesh]['weights'] = [0.2, 0.0]
    node = file.node(mesh=mesh)
    file.document['animations'] = [{'samplers': [
        {'input': file.accessor([0.0, 1.0]),
         'output': file.accessor([0, 255, 255, 0], component=UBYTE, normalized=True)}],
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
    accessor = file.document['accessors'][
        file.document['meshes'][1]['primitives'][0]['attributes']['POSITION']]
    accessor['sparse'] = {'count': 2, 'indices': {'bufferView': file.view(struct.pack('<BB', 1, 3)),
                                                  'componentType': UBYTE},
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
    file.document['nodes'][0]['extras'] = {'exact_shape': {'level': 0,
                                                           'waves': [{'amplitude': 0.1, 'k': [3, 1],
                                                                      'phase': 1}]}}
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
    document['extensionsUsed'] = ['KHR_materials_variants', 'KHR_xmp_json_ld', 'KHR_materials_specular',
                                  'VENDOR_any']
    document['extensionsRequired'] = ['KHR_materials_clearcoat']
    document['scenes'].append({'name': 'second'})
    document['nodes'][1]['extensions'] = {'KHR_node_visibility': {'visible': False}}
    document['materials'][0]['extensions'] = {'KHR_materials_unlit': {}}
    document['materials'][0]['alphaMode'] = 'BLEND'
    file.node(children=[file.node(root=False, mesh=0, scale=[1e-3, 1, 1])], rotation=[0, 0, 0, 0])
    camera = file.list('cameras',
                       {'type': 'perspective', 'perspective': {'yfov': 0.8, 'znear': 0.1, 'aspectRatio': 2}})
    file.node(camera=camera, translation=[0, 1, 3], name='second')
    return file


SCENES = {function.__name__: function for function in (
    bare, dispersing, pane, sheet, water, point_inside, sized_lights, shining, hazy, hazy_beside, textured,
    moving, morphing, skinned, instances, quantized, sparse, sparse_alone, shapes, strips, joined, cube_light,
    extras_of_everything)}
