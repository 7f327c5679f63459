#!/usr/bin/env python3
"""Makes the fuzzers' corpus, one archive: tests/fuzz/corpus.zip. Needs nothing but Python; the same bytes
every time, wherefore nothing in it is compressed.

    make_corpus.py              makes the seeds anew; inputs that fuzzing found stay as they are
    make_corpus.py --add DIR    adds what fuzzing found: the files of DIR/load, DIR/image and DIR/render that
                                the archive lacks
    make_corpus.py --check      exit 1 when the archive is not what this script makes

Seeds are small files for every feature of the loader, files that it must refuse, and for whole frames the
same scenes followed by the bytes that choose settings (tests/fuzz/tiny_frame.cpp, choice_of). Names say what
a file is about. Inputs that fuzzing found stand beside them, without an ending: under the hash of their
content, or a name that a person gave. The build unpacks the archive.
"""
import io
import pathlib
import re
import sys
import zipfile

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
    ('extras_of_everything', 0, 0, 0, 0, 0, 0, 0), ('bare', 0, 0, 0, 0, 0, 0x80, 0),
    ('mirror', 0, 0, 0, 0, 0, 0x80, 0, 0x10), ('dispersing', 1, 0, 0, 0, 0, 0x80, 0, 0x2f),
    ('point_inside', 0, 4, 0, 0x3f, 0, 0x80, 0, 0x14), ('joined', 0, 0, 0, 0, 0, 0x80, 0, 0x0c)]


ARCHIVE = pathlib.Path(__file__).resolve().with_name('corpus.zip')
TARGETS = ('load', 'image', 'render')
FOUND = re.compile('[^./]+')


def seeds():
    """Content by name."""
    files = {f'load/{name}.glb': make().bytes() for name, make in SCENES.items()}
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
    return files


def found():
    """What fuzzing found before."""
    if not ARCHIVE.exists():
        return {}
    with zipfile.ZipFile(ARCHIVE) as archive:
        return {name: archive.read(name) for name in archive.namelist()
                if FOUND.fullmatch(name.partition('/')[2])}


def found_in(folder):
    return {f'{target}/{path.name}': path.read_bytes() for target in TARGETS
            for path in pathlib.Path(folder, target).glob('*') if FOUND.fullmatch(path.name)}


def packed(files):
    data = io.BytesIO()
    with zipfile.ZipFile(data, 'w', zipfile.ZIP_STORED) as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(name)  # of 1980, whenever it is made
            entry.create_system, entry.external_attr = 3, 0o644 << 16
            archive.writestr(entry, files[name])
    return data.getvalue()


def main(arguments):
    files = found()
    if arguments[:1] == ['--add'] and len(arguments) == 2:
        files |= found_in(arguments[1])
    elif arguments not in ([], ['--check']):
        sys.exit(__doc__)
    files |= seeds()
    data = packed(files)
    if arguments == ['--check']:
        if not ARCHIVE.exists() or ARCHIVE.read_bytes() != data:
            sys.exit('tests/fuzz/corpus.zip is not what tests/fuzz/make_corpus.py makes: run it')
    else:
        ARCHIVE.write_bytes(data)
    print(f'{len(files)} files, {sum(map(len, files.values()))} bytes')


main(sys.argv[1:])
