#!/usr/bin/env python3
"""Draws scenes in Blender's Cycles and in this program, as pairs: docs/images/cycles.jpg.

    docs/images/cycles.py PROGRAM ASSETS FOLDER

Blender builds each scene, exports it to FOLDER and path-traces it, unless FOLDER has that: one camera, a sun
of 5 degrees, even light from all around. Prints this program's flux over that of Cycles', of linear pictures,
whole and in regions. Needs Debian's blender (3.4) and openimageio-tools."""
import json
import math
import pathlib
import shutil
import subprocess
import sys

SIZE, SAMPLES, AMBIENT, SUN, DISK = (320, 180), 256, 0.3, 3.0, 5.0
# Asset or shape, whether to add a floor; where the camera stands, what it looks at, degrees across; the sun's
# azimuth and elevation, degrees; regions: x, y, width, height in pixels.
SCENES = {
    'ior': ('scenes/IORTestGrid.glb', 0, (0.3, -1.9, 0.25), (-0.01, 0, 0), 34, (35, 35),
            ('227,137,6,6', '158,56,72,120')),
    'mirror': ('models/teapot_mirror.glb', 0, (1.4, -1.9, 1.3), (0.25, 0.2, 0.1), 38, (245, 42),
               ('220,60,80,60', '60,105,80,60')),
    'dragon': ('scenes/DragonAttenuation.glb', 0, (2.4, -5.6, 3), (-0.1, -0.3, -0.2), 48, (80, 55),
               ('115,115,60,12', '170,20,40,40')),
    'rough': ('balls', 1, (1.6, -4, 2.8), (0.1, -0.1, 0.2), 46, (200, 50), ('72,88,78,52', '160,102,84,64')),
    'candle': ('scenes/GlassHurricaneCandleHolder.glb', 1, (0.32, -1, 0.58), (0, -0.07, 0.11), 34, (215, 45),
               ('150,140,70,38', '135,20,70,60')),
    'suzanne': ('monkey', 1, (1.3, -6, 4.4), (0.2, -0.3, 0.5), 42, (200, 55),
                ('80,95,148,80', '137,106,40,38')),
}


def paint(bpy, **inputs):
    made = bpy.data.materials.new('own')
    made.use_nodes = True
    for key, value in inputs.items():
        made.node_tree.nodes['Principled BSDF'].inputs[key.replace('_', ' ')].default_value = value
    bpy.context.object.data.materials.append(made)


def add_own(bpy, shape):
    balls = ((-0.6, 0, 0.1), (0.6, 0, 0.3), (0, 1.3, 0.6))
    for x, y, roughness in balls if shape == 'balls' else ((0, 0, 0),):
        if shape == 'balls':
            bpy.ops.mesh.primitive_uv_sphere_add(segments=96, ring_count=48, radius=0.5, location=(x, y, 0.6))
        else:
            bpy.ops.mesh.primitive_monkey_add(location=(0, 0, 1), rotation=(-0.6, 0, 0.3))
            bpy.context.object.modifiers.new('smooth', 'SUBSURF').levels = 2
        bpy.ops.object.shade_smooth()
        paint(bpy, Transmission=1, Roughness=roughness, IOR=1.5, Base_Color=(1, 1, 1, 1))


def make_glass_solid(bpy):
    """Gives it the thickness that the add-on of Blender 3.4 loses between import and export."""
    for each in bpy.data.node_groups:
        each.name = 'lost'
    group = bpy.data.node_groups.new('glTF Material Output', 'ShaderNodeTree')
    group.inputs.new('NodeSocketFloat', 'Thickness')
    group.nodes.new('NodeGroupInput')
    for nodes in [material.node_tree.nodes for material in bpy.data.materials if material.node_tree]:
        if nodes['Principled BSDF'].inputs['Transmission'].default_value > 0.5:
            node = nodes.new('ShaderNodeGroup')
            node.node_tree = group
            node.inputs['Thickness'].default_value = 1


def trace(bpy, picture):
    # Blender lets exp(-density (1 - c) x) through, glTF c^(x / distance).
    for node in [n for m in bpy.data.materials for n in m.node_tree.nodes if n.type == 'VOLUME_ABSORPTION']:
        needed = [-math.log(max(c, 1e-6)) for c in node.inputs['Color'].default_value[:3]]
        most = max(*needed, 1e-9)
        node.inputs['Color'].default_value = (*[1 - value / most for value in needed], 1)
        node.inputs['Density'].default_value *= most
    scene = bpy.context.scene
    scene.render.engine = 'CYCLES'
    cycles, render = scene.cycles, scene.render
    cycles.samples, cycles.use_denoising, cycles.use_adaptive_sampling = SAMPLES, False, False
    cycles.blur_glossy = cycles.sample_clamp_indirect = 0
    cycles.pixel_filter_type = 'BOX'
    cycles.max_bounces = cycles.transmission_bounces = cycles.glossy_bounces = 24
    render.resolution_x, render.resolution_y, render.resolution_percentage = *SIZE, 100
    render.image_settings.file_format, render.image_settings.color_depth = 'OPEN_EXR', '32'
    scene.world, render.filepath = bpy.data.worlds.new('even'), picture
    scene.world.color = (AMBIENT, AMBIENT, AMBIENT)
    bpy.ops.render.render(write_still=True)


def in_blender(name, assets, folder):
    import bpy
    import numpy
    from mathutils import Vector
    numpy.bool = bool  # Debian 12's add-on is older than its numpy
    source, floor, eye, target, across, (azimuth, elevation), _ = SCENES[name]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_enable(module='io_scene_gltf2')
    if source.endswith('.glb'):
        bpy.ops.import_scene.gltf(filepath=f'{assets}/{source}')
    else:
        add_own(bpy, source)
    for thing in [o for o in bpy.data.objects if o.type in ('LIGHT', 'CAMERA')]:
        bpy.data.objects.remove(thing)
    make_glass_solid(bpy)
    if floor:
        bpy.ops.mesh.primitive_plane_add(size=30)
        paint(bpy, Base_Color=(.7, .7, .7, 1), Roughness=1, Specular=0)
    camera = bpy.data.objects.new('camera', bpy.data.cameras.new('camera'))
    light = bpy.data.objects.new('sun', bpy.data.lights.new('sun', 'SUN'))
    [bpy.context.collection.objects.link(thing) for thing in (camera, light)]
    camera.location, camera.data.angle, bpy.context.scene.camera = eye, math.radians(across), camera
    camera.rotation_euler = (Vector(target) - Vector(eye)).to_track_quat('-Z', 'Y').to_euler()
    light.rotation_euler = math.radians(90 - elevation), 0, math.radians(azimuth)
    light.data.energy, light.data.angle, light.data['angular_diameter'] = SUN, math.radians(DISK), DISK
    bpy.ops.export_scene.gltf(filepath=f'{folder}/{name}.glb', export_cameras=True, export_lights=True,
                              export_extras=True, export_apply=True, convert_lighting_mode='COMPAT')
    if not pathlib.Path(f'{folder}/{name}_cycles.exr').exists():
        trace(bpy, f'{folder}/{name}_cycles.exr')


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode > 1:  # 1: compare finds them different
        sys.exit(done.stderr)
    return done.stdout


def main(program, assets, folder):
    if not shutil.which('blender'):
        sys.exit('cycles.py: needs blender (apt-get install blender)')
    even, tiles = f'{folder}/even.exr', []
    run('oiiotool', '--pattern', f'constant:color={AMBIENT},{AMBIENT},{AMBIENT}', '64x32', 3, '-o', even)
    for name in SCENES:
        ours, cycles = f'{folder}/{name}_ours', f'{folder}/{name}_cycles'
        run('blender', '-b', '--factory-startup', '--python', __file__, '--', name, assets, folder)
        run(program, f'{folder}/{name}.glb', '--environment', even, '--ground', 'off', '-r', '%dx%d' % SIZE,
            '--grid', 256, '--map', 384, '-D', 'light.samples=32', '-D', 'samples=4', '-o', ours + '.exr')
        for picture in (cycles, ours):
            tiles.append(picture + '.png')
            run('oiiotool', picture + '.exr', '--ch', 'R,G,B', '-o', picture + '.rgb.exr', '--mulc', 0.7,
                '--powc', 0.4545, '--resize', '240x135', '-o', tiles[-1])
        for region in ('0,0,%d,%d' % SIZE, *SCENES[name][-1]):
            pair = ours + '.rgb.exr', cycles + '.rgb.exr'
            found = json.loads(run(program, 'compare', *pair, '--json', '--region', region))['channels']
            print(name, region, *['%.3f' % each['metrics']['flux_ratio'] for each in found], flush=True)
    run('oiiotool', *tiles, '--mosaic', f'4x{len(tiles) // 4}:pad=2', '--compression', 'jpeg:85', '-o',
        pathlib.Path(__file__).with_suffix('.jpg'))


if __name__ == '__main__':
    in_blender(*sys.argv[-3:]) if '--' in sys.argv else main(*sys.argv[1:])
