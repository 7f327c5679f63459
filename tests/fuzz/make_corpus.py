#!/usr/bin/env python3
"""Makes the fuzzers' seeds: python3 tests/fuzz/make_corpus.py [FOLDER]. Needs nothing but Python; the same
bytes every time.

Small files for every feature of the loader, files that it must refuse, and for whole frames the same scenes
followed by the bytes that choose settings (tests/fuzz/tiny_frame.cpp, choice_of). Names say what a file is
about. Inputs that fuzzing found lie beside them under the hash of their content and are left alone.
"""
import pathlib
import sys

from making.gltf_file import glb
from making.images import images
from making.malformed import malformed, with_image
from making.scenes import SCENES, bare, neighbours
from making.stage import GOLD, stage


def mirror():
    return stage(GOLD)


# Names of scenes with eight bytes of settings each.
FRAMES = [
    ('bare', 0, 0, 0, 0, 0, 0, 0), ('mirror', 0, 0, 0, 0, 0, 0, 0), ('mirror', 0x41, 0, 0, 0, 0, 0x20, 0),
    ('dispersing', 0, 0, 0, 0, 0, 0, 0), ('dispersing', 2, 0x10, 8, 0, 0, 0, 0),
    ('dispersing', 0x20, 0, 12, 0, 0, 0, 0), ('pane', 0, 0, 0, 0, 0, 0, 0), ('pane', 0, 0x20, 0, 0, 0, 0, 0),
    ('sheet', 0, 0x10, 0, 0, 0, 0, 0), ('sheet', 0x80, 2, 0, 0, 0, 0, 0), ('water', 0, 0, 0, 0, 0, 0, 0),
    ('water', 1, 0x10, 0, 0, 0, 0, 128), ('point_inside', 0, 0, 0, 0, 0, 0, 0),
    ('point_inside', 0, 4, 0, 0x3f, 0, 0, 0), ('point_inside', 0, 8, 0, 0, 0, 0, 0),
    ('cube_light', 0, 4, 0, 0x3f, 0, 0, 0), ('cube_light', 8, 4, 0, 0, 0, 1, 0),
    ('sized_lights', 0, 0, 0, 0, 0, 0, 0), ('sized_lights', 4, 0, 0x80, 0x3f, 0, 2, 0),
    ('shining', 0, 0x40, 0, 0, 0, 0, 0), ('shining', 0, 0, 0, 0, 0, 4, 0), ('hazy', 0, 0, 0, 0, 0, 0, 0),
    ('hazy', 0, 0x10, 0, 0, 0x2c, 0, 0), ('hazy_beside', 0, 0, 0, 0, 0, 0, 0),
    ('textured', 0, 0, 0, 0, 0, 0, 0), ('textured', 1, 0, 0, 0x3f, 0, 0, 0),
    ('moving', 0, 0, 0, 0, 0, 0, 90), ('morphing', 0, 0, 0, 0, 0, 0, 255),
    ('skinned', 0, 0, 0, 0, 0, 0, 128), ('instances', 0, 0, 0, 0, 0, 0, 0),
    ('quantized', 0, 0, 0, 0, 0, 0, 0), ('joined', 0, 0, 0, 0, 0, 0, 0), ('joined', 3, 1, 0, 0, 0, 0, 0),
    ('joined', 3, 2, 2, 0, 0, 0, 0), ('shapes', 0, 0, 3, 0x0f, 0x40, 0, 0),
    ('strips', 0, 0, 0, 0, 0, 0x40, 0), ('bare', 3, 0, 0, 0, 0, 0, 0),
    ('bare', 0, 0, 0, 0x55, 0x55, 0x1c, 0), ('bare', 8, 0, 0, 0xaa, 0xaa, 0x0b, 0),
    ('extras_of_everything', 0, 0, 0, 0, 0, 0, 0)]


def main():
    here = pathlib.Path(__file__).resolve().parent
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here / 'corpus'
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
        files[f'render/{name}_{number:02}.glb'] = makers[name]().bytes() + bytes(choice + [0] *
                                                                                 (8 - len(choice)))
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    print(f'{len(files)} files, {sum(map(len, files.values()))} bytes')


main()
