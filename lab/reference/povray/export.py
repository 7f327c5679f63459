"""Writes a scene of glb.py as text for POV-Ray 3.7.

Units: POV-Ray has no 1/pi in its diffuse reflection. A white floor (`pigment { rgb 1 } finish { diffuse 1
}`) under a light of colour c shows c cos(theta), so that a directional light whose colour is its lux makes
every pixel of the floor its irradiance in lux. The receivers are therefore exported white, whatever their
albedo. compare.py checks this on floor that is not shadowed.

Coordinates stay as they are: the camera is written by its vectors, so that POV-Ray's left hand does not
matter."""
import math

# Of a point light: POV-Ray's 2 / (1 + (r / d)^2) is 2 d^2 / r^2 far from d.
FADE = 1e-3
WHITE = 'texture { pigment { color rgb 1 } finish { ambient 0 diffuse 1 } }'


def vector(v):
    return '<' + ','.join('%.9g' % c for c in v) + '>'


def is_glass(material):
    extensions = material.get('extensions', {})
    return (extensions.get('KHR_materials_transmission', {}).get('transmissionFactor', 0) >= 0.5 and
            extensions.get('KHR_materials_volume', {}).get('thicknessFactor', 0) > 0)


def is_mirror(material):
    surface = material.get('pbrMetallicRoughness', {})
    return (not is_glass(material) and surface.get('metallicFactor', 1) >= 0.5 and
            surface.get('roughnessFactor', 1) <= 0.2)


def is_caster(material):
    return is_glass(material) or is_mirror(material)


def absorption(material):
    """POV-Ray's exp(-(1 - fade_color) x / fade_distance) as c^(x / d)."""
    volume = material['extensions']['KHR_materials_volume']
    color, distance = volume.get('attenuationColor'), volume.get('attenuationDistance')
    if not color or not distance or min(color) >= 1:
        return ''
    logarithms = [math.log(max(c, 1e-6)) for c in color]
    length = distance / max(-x for x in logarithms)
    return (f' fade_power 1001 fade_distance {length:.9g}'
            f' fade_color rgb {vector([1 + x * length / distance for x in logarithms])}')


def base_color(material):
    return material.get('pbrMetallicRoughness', {}).get('baseColorFactor', (1, 1, 1, 1))[:3]


def caster_look(material, reflections):
    """The texture and interior of a caster, and what it does to photons. Without `reflections` glass still
    loses what Fresnel's equations say, but no photon goes where it is mirrored: light goes in and out once,
    as `render` has it."""
    if is_mirror(material):
        # Schlick's reflectance, as `render` computes it: F0 + (1 - F0) (1 - cos)^5.
        return (f'texture {{ pigment {{ color rgb 0 }} finish {{ ambient 0 diffuse 0 specular 0'
                f' reflection {{ rgb {vector(base_color(material))}, rgb 1 falloff 5 }} }} }}',
                'photons { target 1.0 reflection on refraction off collect off }')
    ior = material['extensions'].get('KHR_materials_ior', {}).get('ior', 1.5)
    return (f'texture {{ pigment {{ color rgbt 1 }} finish {{ ambient 0 diffuse 0 specular 0'
            f' reflection {{ 0, 1 fresnel on }} conserve_energy }} }}'
            f' interior {{ ior {ior:.9g}{absorption(material)} }}',
            f'photons {{ target 1.0 refraction on reflection {"on" if reflections else "off"} collect off }}')


def mesh2(mesh):
    return '\n'.join([
        'mesh2 {',
        f'vertex_vectors {{ {len(mesh.positions)}, {",".join(map(vector, mesh.positions))} }}',
        f'normal_vectors {{ {len(mesh.normals)}, {",".join(map(vector, mesh.normals))} }}',
        f'face_indices {{ {len(mesh.triangles)}, {",".join("<%d,%d,%d>" % t for t in mesh.triangles)} }}'])


def sphere(mesh):
    """The sphere in place of its mesh: the middle of the mesh's box, the farthest vertex, as `reference
    --exact`."""
    middle = [0.5 * (low + high) for low, high in mesh.box()]
    radius = max(math.dist(p, middle) for p in mesh.positions)
    return f'sphere {{ {vector(middle)}, {radius:.9g}'


def light_source(light):
    photons = 'photons { refraction on reflection on }'
    if light.kind == 'directional':
        # Parallel rays; from where does not matter as long as it is outside the scene.
        return (f'light_source {{ {vector([-20 * c for c in light.travel])} color rgb {vector(light.color)}'
                f' parallel point_at 0 {photons} }}')
    color = vector([c / (2 * FADE * FADE) for c in light.color])
    return (f'light_source {{ {vector(light.place)} color rgb {color}'
            f' fade_distance {FADE} fade_power 2 {photons} }}')


def camera(view):
    doubled = [[2 * c for c in v] for v in (view.right, view.up)]
    return (f'camera {{ orthographic location {vector(view.place)} direction {vector(view.forward)}'
            f' up {vector(doubled[1])} right {vector(doubled[0])} }}')


def scene_text(scene, view, photons, reflections=False, exact=None, levels=12):
    """`photons` is what stands in global_settings' block, such as 'count 10000 gather 20, 100'; None: no
    photons, and casters that are opaque and black, which is the direct light with its shadows alone.
    `exact`: a mesh's name."""
    parts = ['#version 3.7;', f'global_settings {{ assumed_gamma 1.0 max_trace_level {levels}']
    if photons:
        parts.append(f'photons {{ {photons} autostop 0 jitter 0.4 media 0 max_trace_level {levels} }}')
    parts += ['}', camera(view), *map(light_source, scene.lights)]
    for mesh in scene.meshes:
        parts.append(sphere(mesh) if mesh.name == exact else mesh2(mesh))
        if not is_caster(mesh.material):
            parts.append(f'{WHITE} photons {{ collect on }} }}')
        elif photons:
            parts += [*caster_look(mesh.material, reflections), '}']
        else:
            parts.append('texture { pigment { color rgb 0 } finish { ambient 0 diffuse 0 } } }')
    return '\n'.join(parts) + '\n'
