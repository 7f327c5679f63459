"""Shapes (positions, normals, indices), materials, and a floor with a caster on it."""
from making.gltf_file import DOWN, File


def square(half, y=0.0):
    corners = [(-half, y, half), (half, y, half), (half, y, -half), (-half, y, -half)]
    return corners, [(0, 1, 0)] * 4, [0, 1, 2, 0, 2, 3]


def octahedron(radius, y):
    tips = [(radius, y, 0), (-radius, y, 0), (0, y + radius, 0), (0, y - radius, 0), (0, y, radius),
            (0, y, -radius)]
    normals = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(2, 4, 0), (2, 0, 5), (2, 5, 1), (2, 1, 4), (3, 0, 4), (3, 5, 0), (3, 1, 5), (3, 4, 1)]
    return tips, normals, [i for face in faces for i in face]


def box(half, y):
    positions = [(half * x, y + half * h, half * z) for x in (-1, 1) for h in (-1, 1) for z in (-1, 1)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return positions, None, [i for a, b, c, d in faces for i in (a, b, c, a, c, d)]


UVS = [(0, 0), (1, 0), (1, 1), (0, 1)]
WHITE = {'pbrMetallicRoughness': {'baseColorFactor': [0.8, 0.8, 0.8, 1], 'metallicFactor': 0,
                                  'roughnessFactor': 1}}


def glass(ior=1.5, **volume):
    return {'pbrMetallicRoughness': {'metallicFactor': 0, 'roughnessFactor': 0},
            'extensions': {'KHR_materials_transmission': {'transmissionFactor': 1},
                           'KHR_materials_ior': {'ior': ior},
                           'KHR_materials_volume': {'thicknessFactor': 1, **volume}}}


GOLD = {'pbrMetallicRoughness': {'baseColorFactor': [1, 0.8, 0.3, 1], 'metallicFactor': 1,
                                 'roughnessFactor': 0.05}}


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
